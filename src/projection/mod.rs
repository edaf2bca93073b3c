//! The projection `P` of a shell, its inverse, and the maps that they give between meshes.

mod boxes;
mod error;
mod exact;
mod float;
mod inverse;
mod locate;
mod point;
mod section;
#[cfg(test)]
mod tests;
mod trace;

pub use error::{PointError, ProjectionError, SectionError};
pub use exact::Rat;
pub use float::{FloatPoint, MAX_ERROR};
pub use inverse::FibrePiece;
pub use locate::{Location, Projection};
pub use point::ShellPoint;
pub use section::{MeshPoint, SectionMap};
