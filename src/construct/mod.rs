//! Shells around meshes (*Shell* sections 3.3 to 3.6).
//!
//! [`initial`] makes the initial shell: its middle surface is the mesh, refined where beveling needs it.
//! [`optimise()`] coarsens and thickens it. [`sample`] makes shells with known properties, for the demo and for tests.

mod bevel;
mod boundary;
pub mod direction;
mod draft;
mod gate;
mod initial;
pub mod optimise;
mod sample;
mod thickness;

pub use gate::BuildError;
pub use initial::{Initial, InitialOptions, initial};
pub use optimise::{OptimiseOptions, Optimised, optimise, optimise_joint};
pub use sample::{Sample, dent, icosphere, sample};
