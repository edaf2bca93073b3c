//! `malachite`: pure Rust, LGPL.

use malachite::Natural;
use malachite::base::num::arithmetic::traits::{DivRem, Sign as MalachiteSign};
use malachite::base::num::basic::traits::Zero;
use malachite::base::num::logic::traits::SignificantBits;
use malachite::rational::Rational as MalachiteRational;

use crate::number::Rational;
use crate::predicate::Sign;

impl Rational for MalachiteRational {
    const BACKEND: &'static str = "malachite";

    fn from_scaled(mantissa: i64, exponent: i32) -> Self {
        Self::from(mantissa) << exponent
    }

    fn plus(&self, other: &Self) -> Self {
        self + other
    }

    fn minus(&self, other: &Self) -> Self {
        self - other
    }

    fn times(&self, other: &Self) -> Self {
        self * other
    }

    fn over(&self, other: &Self) -> Option<Self> {
        (!other.is_zero()).then(|| self / other)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn sign(&self) -> Sign {
        MalachiteSign::sign(self).into()
    }

    fn numerator(&self) -> String {
        let sign = if Rational::sign(self).is_negative() { "-" } else { "" };
        format!("{sign}{}", self.numerator_ref())
    }

    fn denominator(&self) -> String {
        self.denominator_ref().to_string()
    }

    fn from_decimal(numerator: &str, denominator: &str) -> Option<Self> {
        let magnitude = numerator.strip_prefix('-').unwrap_or(numerator);
        let positive = magnitude.len() == numerator.len();
        let denominator: Natural = denominator.parse().ok().filter(|d| *d != Natural::ZERO)?;
        Some(Self::from_sign_and_naturals(positive, magnitude.parse().ok()?, denominator))
    }

    fn bit_lengths(&self) -> (u64, u64) {
        (self.numerator_ref().significant_bits(), self.denominator_ref().significant_bits())
    }

    fn quotient(&self, shift: i32) -> Option<(u64, bool)> {
        let by = shift.unsigned_abs();
        let (numerator, denominator) = self.to_numerator_and_denominator();
        let (quotient, rest) = if shift < 0 {
            (numerator << by).div_rem(denominator)
        } else {
            numerator.div_rem(denominator << by)
        };
        Some((u64::try_from(&quotient).ok()?, rest != Natural::ZERO))
    }
}
