//! The implementations of [`Rational`](super::Rational).

mod dashu;
#[cfg(feature = "malachite")]
mod malachite;
#[cfg(feature = "num-rational")]
mod num_rational;
#[cfg(feature = "rug")]
mod rug;
