//! `num-rational` over `num-bigint`: slow, and written independently of the others.

use num_bigint::{BigInt, BigUint, Sign as BigSign};
use num_rational::Ratio;
use num_traits::Zero;

use crate::number::Rational;
use crate::predicate::Sign;

impl Rational for Ratio<BigInt> {
    const BACKEND: &'static str = "num-rational";

    fn from_scaled(mantissa: i64, exponent: i32) -> Self {
        let shift = exponent.unsigned_abs();
        let mantissa = BigInt::from(mantissa);
        if exponent < 0 {
            Self::new(mantissa, BigInt::from(1) << shift)
        } else {
            Self::from_integer(mantissa << shift)
        }
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
        (!Zero::is_zero(other)).then(|| self / other)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn sign(&self) -> Sign {
        match self.numer().sign() {
            BigSign::Minus => Sign::Negative,
            BigSign::NoSign => Sign::Zero,
            BigSign::Plus => Sign::Positive,
        }
    }

    fn numerator(&self) -> String {
        self.numer().to_string()
    }

    fn denominator(&self) -> String {
        self.denom().to_string()
    }

    fn from_decimal(numerator: &str, denominator: &str) -> Option<Self> {
        let denominator: BigUint = denominator.parse().ok().filter(|d| !Zero::is_zero(d))?;
        Some(Self::new(numerator.parse().ok()?, denominator.into()))
    }

    fn bit_lengths(&self) -> (u64, u64) {
        (self.numer().bits(), self.denom().bits())
    }

    fn quotient(&self, shift: i32) -> Option<(u64, bool)> {
        let by = shift.unsigned_abs();
        let (numerator, denominator) = (self.numer().magnitude(), self.denom().magnitude());
        let (numerator, denominator) = if shift < 0 {
            (numerator << by, denominator.clone())
        } else {
            (numerator.clone(), denominator << by)
        };
        let quotient = &numerator / &denominator;
        let inexact = &quotient * &denominator != numerator;
        Some((u64::try_from(quotient).ok()?, inexact))
    }
}
