//! `rug`: GMP, the fastest, LGPL; needs m4 and a C toolchain to build.

use rug::{Integer, Rational as RugRational};

use crate::number::Rational;
use crate::predicate::Sign;

impl Rational for RugRational {
    const BACKEND: &'static str = "rug";

    fn from_scaled(mantissa: i64, exponent: i32) -> Self {
        Self::from(mantissa) << exponent
    }

    fn plus(&self, other: &Self) -> Self {
        Self::from(self + other)
    }

    fn minus(&self, other: &Self) -> Self {
        Self::from(self - other)
    }

    fn times(&self, other: &Self) -> Self {
        Self::from(self * other)
    }

    fn over(&self, other: &Self) -> Option<Self> {
        (!Rational::is_zero(other)).then(|| Self::from(self / other))
    }

    fn negated(&self) -> Self {
        Self::from(-self)
    }

    fn sign(&self) -> Sign {
        self.cmp0().into()
    }

    fn numerator(&self) -> String {
        self.numer().to_string()
    }

    fn denominator(&self) -> String {
        self.denom().to_string()
    }

    fn from_decimal(numerator: &str, denominator: &str) -> Option<Self> {
        let denominator: Integer = denominator.parse().ok().filter(|d: &Integer| d.is_positive())?;
        Some(Self::from((numerator.parse::<Integer>().ok()?, denominator)))
    }

    fn bit_lengths(&self) -> (u64, u64) {
        (self.numer().significant_bits().into(), self.denom().significant_bits().into())
    }

    fn quotient(&self, shift: i32) -> Option<(u64, bool)> {
        let by = shift.unsigned_abs();
        let (mut numerator, mut denominator) = (self.numer().clone().abs(), self.denom().clone());
        if shift < 0 {
            numerator <<= by;
        } else {
            denominator <<= by;
        }
        let (quotient, rest) = numerator.div_rem(denominator);
        Some((quotient.to_u64()?, !rest.is_zero()))
    }
}
