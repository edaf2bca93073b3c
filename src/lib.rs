//! `homeo` proves, in exact arithmetic, that maps between triangle meshes are bijections.
//!
//! Floats propose, integers decide: every verdict is a statement about the input's `f64`
//! coordinates taken as exact rationals, and comes with a certificate or a witness.

pub mod certify;
pub mod cli;
pub mod construct;
pub mod mesh;
pub mod number;
pub mod predicate;
pub mod projection;
pub mod report;
pub mod shell;
