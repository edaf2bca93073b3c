//! Shells around meshes (*Shell* sections 3.3 to 3.6).
//!
//! [`initial`] makes the initial shell: its middle surface is the mesh, refined where beveling needs it.
//! [`optimise()`] coarsens and thickens it.

mod bevel;
pub mod direction;
mod draft;
mod gate;
mod initial;
pub mod optimise;
mod thickness;

pub use gate::BuildError;
pub use initial::{Initial, InitialOptions, initial};
pub use optimise::{OptimiseOptions, Optimised, optimise};
