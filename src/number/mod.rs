//! Exact numbers: dyadic values of floats, fixed-width integers, rationals.

pub mod dyadic;
pub mod fixed;
