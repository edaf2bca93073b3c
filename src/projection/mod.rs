//! The projection `P` of a shell, its inverse, and the maps that they give between meshes.

mod boxes;
mod error;
mod exact;
mod inverse;
mod locate;
mod point;
#[cfg(test)]
mod tests;
mod trace;

pub use error::{PointError, ProjectionError, SectionError};
pub use exact::Rat;
pub use inverse::FibrePiece;
pub use locate::{Location, Projection};
pub use point::ShellPoint;
