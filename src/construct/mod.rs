//! Shells around meshes (*Shell* sections 3.3 to 3.6).
//!
//! [`initial`] makes the initial shell: its middle surface is the mesh, refined where beveling needs it.

mod bevel;
mod boundary;
pub mod direction;
mod draft;
mod gate;
mod initial;
mod thickness;

pub use gate::BuildError;
pub use initial::{Initial, InitialOptions, initial};
