//! Exact geometric predicates on finite `f64` input.
//!
//! Every answer is a statement about the coordinates taken as exact rationals, for all finite values,
//! subnormals and the largest ones included. Speed comes from stages (see [`Stage`]): a float filter with
//! a proved bound, integers of fixed width, big integers.

pub mod batch;
mod determinant;
mod meeting;
mod orient;
mod position;
mod ray;
mod sign;
mod sphere;
mod stage;
#[cfg(test)]
pub(crate) mod tests;
mod word;

pub(crate) use determinant::Minors;
pub(crate) use meeting::triangle_touches_tet;
pub use meeting::{Meeting, segment_segment, segment_triangle, triangle_tet, triangle_triangle};
pub(crate) use orient::Plane;
pub use orient::{
    Axis, collinear, det_sign, det_sign_exact, det_sign_staged, dot_sign, dot_sign_exact, dot_sign_staged,
    normal_signs, orient2d, orient2d_exact, orient2d_staged, orient3d, orient3d_exact, orient3d_staged,
    projection_axis, side_of_plane, zero_area,
};
pub use position::{ZeroMask, point_in_tet, point_in_triangle, point_on_segment, same_point};
pub use ray::ray_triangle;
pub use sign::Sign;
pub use sphere::{incircle, incircle_exact, insphere, insphere_exact};
pub use stage::{Stage, StageCounts};
