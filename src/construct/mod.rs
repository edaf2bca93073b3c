//! Shells around meshes (*Shell* sections 3.3 to 3.6).
//!
//! [`initial`] makes the initial shell: its middle surface is the mesh, refined where beveling needs it.
//! [`optimise()`] coarsens and thickens it. [`measure`] says how thick, well shaped and near to the mesh a shell is. [`sample`] makes shells with known properties, for the demo and for tests.

mod bevel;
mod boundary;
pub mod direction;
mod draft;
mod fixed;
mod gate;
mod initial;
pub mod measure;
pub mod optimise;
mod overlap;
mod sample;
mod scale;
mod thickness;

pub use gate::BuildError;
pub use initial::{Initial, InitialOptions, Thickness, initial};
pub use optimise::{OptimiseOptions, Optimised, optimise, optimise_joint, optimise_locally};
pub use sample::{Sample, dent, icosphere, sample};
