//! Building shells. So far: samples with known properties, for the demo and for tests.

mod sample;

pub use sample::{Sample, dent, icosphere, sample};
