//! Strategies and properties: random shells and meshes in degenerate position, and an oracle that decides the claims
//! of THEORY section 2 from their definitions, slowly and without any code of `homeo::certify`.
//!
//! This is test code: it may panic, and a panic is a failed test.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

pub mod campaign;
pub mod graphs;
pub mod judged;
pub mod lies;
pub mod meshes;
pub mod oracle;
pub mod recipe;
pub mod shapes;
pub mod sheets;

pub use meshes::{MeshRecipe, mesh_recipes};
pub use recipe::{Case, Recipe, recipes};
