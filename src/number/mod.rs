//! Exact numbers: dyadic values of floats, fixed-width integers, and rationals behind one trait.
//!
//! [`Rational`] has four backends: `dashu` (always there, [`Rat`]), and `rug`, `malachite` and
//! `num-rational` behind the features of these names. They check each other: one test suite runs on all.

mod backend;
pub mod dyadic;
pub mod fixed;
mod rational;
mod rounding;
#[cfg(test)]
mod tests;

pub use dyadic::Dyadic;
pub use rational::{ParseRationalError, Rational};

/// The default rational: always in lowest terms, with a positive denominator.
pub type Rat = dashu_ratio::RBig;
