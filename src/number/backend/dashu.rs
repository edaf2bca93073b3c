//! `dashu`: pure Rust, within about 10 % of GMP at the sizes met here. `RBig` keeps lowest terms; the
//! crate's `Relaxed` type does not, and grows without bound on chains of operations.

use dashu_base::{BitTest, DivRem, Sign as DashuSign};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;

use crate::number::Rational;
use crate::predicate::Sign;

impl Rational for RBig {
    const BACKEND: &'static str = "dashu";

    fn from_scaled(mantissa: i64, exponent: i32) -> Self {
        let shift = exponent.unsigned_abs() as usize;
        let mantissa = IBig::from(mantissa);
        if exponent < 0 {
            Self::from_parts(mantissa, UBig::ONE << shift)
        } else {
            Self::from_parts(mantissa << shift, UBig::ONE)
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
        (!other.is_zero()).then(|| self / other)
    }

    fn negated(&self) -> Self {
        -self.clone()
    }

    fn sign(&self) -> Sign {
        match self.numerator().sign() {
            _ if self.numerator().is_zero() => Sign::Zero,
            DashuSign::Positive => Sign::Positive,
            DashuSign::Negative => Sign::Negative,
        }
    }

    fn numerator(&self) -> String {
        self.numerator().to_string()
    }

    fn denominator(&self) -> String {
        self.denominator().to_string()
    }

    fn from_decimal(numerator: &str, denominator: &str) -> Option<Self> {
        let denominator = UBig::from_str_radix(denominator, 10).ok().filter(|d| !d.is_zero())?;
        Some(Self::from_parts(IBig::from_str_radix(numerator, 10).ok()?, denominator))
    }

    fn bit_lengths(&self) -> (u64, u64) {
        (self.numerator().bit_len() as u64, self.denominator().bit_len() as u64)
    }

    fn quotient(&self, shift: i32) -> Option<(u64, bool)> {
        let by = shift.unsigned_abs() as usize;
        let (_, numerator) = self.numerator().clone().into_parts();
        let (quotient, rest) = if shift < 0 {
            (numerator << by).div_rem(self.denominator())
        } else {
            numerator.div_rem(self.denominator() << by)
        };
        Some((u64::try_from(quotient).ok()?, !rest.is_zero()))
    }
}
