//! Exact geometric predicates on finite `f64` input.
//!
//! Every answer is a statement about the coordinates taken as exact rationals, for all finite values,
//! subnormals and the largest ones included. Speed comes from stages (see [`Stage`]): a float filter with
//! a proved bound, integers of fixed width, big integers.

mod determinant;
mod orient;
mod sign;
mod stage;
#[cfg(test)]
mod tests;

pub use orient::{
    Axis, collinear, dot_sign, dot_sign_exact, dot_sign_staged, normal_signs, orient2d, orient2d_exact,
    orient2d_staged, orient3d, orient3d_exact, orient3d_staged, projection_axis, side_of_plane, zero_area,
};
pub use sign::Sign;
pub use stage::{Stage, StageCounts};
