//! What unit tests of several modules share.

mod data;
mod meshes;
mod random;

pub(crate) use data::{data, shell_directory};
pub(crate) use meshes::{joined, torus};
pub(crate) use random::Random;
