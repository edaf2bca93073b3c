//! Every finite `f64` is `mantissa * 2^exponent`: decomposition, common scaling, printing.

use std::fmt;

use dashu_base::PowerOfTwo;
use dashu_int::IBig;

use super::Rat;

/// `(mantissa, exponent)` with `x = mantissa * 2^exponent`, the mantissa odd, or `(0, 0)` for zero.
///
/// `|mantissa| < 2^53` and `-1074 <= exponent <= 1023`. NaN and infinities have no value: the
/// answer is some pair within the same ranges, so that callers cannot be made to panic.
#[inline]
pub fn decompose(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let biased = ((bits >> 52) & 0x7ff).min(0x7fe) as i32;
    let fraction = bits & ((1 << 52) - 1);
    let (magnitude, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
    if magnitude == 0 {
        return (0, 0);
    }
    let zeros = magnitude.trailing_zeros();
    let magnitude = (magnitude >> zeros).cast_signed();
    let mantissa = if x.is_sign_negative() { -magnitude } else { magnitude };
    (mantissa, exponent + zeros.cast_signed())
}

/// The integers `x_i / 2^e` and the common exponent `e`, the largest one for which all are
/// integers (`0` if every value is zero). Requires finite values.
pub fn common_scale<const N: usize>(values: [f64; N]) -> ([IBig; N], i32) {
    let parts = values.map(decompose);
    let scale = parts.iter().filter(|(m, _)| *m != 0).map(|(_, e)| *e).min().unwrap_or(0);
    (parts.map(|part| scaled(part, scale)), scale)
}

/// The points' integer coordinates `p / 2^e` and the common exponent `e` of all coordinates of all
/// points (`0` if every coordinate is zero). Requires finite coordinates; linear in the number of
/// points, with integers of up to 2,098 bits.
pub fn scale_points(points: &[[f64; 3]]) -> (Vec<[IBig; 3]>, i32) {
    let parts = || points.iter().flatten().map(|&x| decompose(x));
    let scale = parts().filter(|(m, _)| *m != 0).map(|(_, e)| e).min().unwrap_or(0);
    (points.iter().map(|p| p.map(|x| scaled(decompose(x), scale))).collect(), scale)
}

/// `mantissa * 2^(exponent - scale)`, for `exponent >= scale` or a zero mantissa.
fn scaled((mantissa, exponent): (i64, i32), scale: i32) -> IBig {
    let shift = if mantissa == 0 { 0 } else { exponent.abs_diff(scale) };
    IBig::from(mantissa) << shift as usize
}

/// An exact dyadic number: `mantissa * 2^exponent` with an odd mantissa, or `0 * 2^0`.
///
/// Printed as `-13*2^-150`, always with its exponent, and zero as `0`: every value has one text.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Dyadic {
    mantissa: IBig,
    exponent: i64,
}

impl Dyadic {
    /// `mantissa * 2^exponent`, brought to the normal form. The exponent saturates (it would take a
    /// mantissa of `2^63` zero bits or an exponent near `i64::MAX`).
    pub fn new(mantissa: IBig, exponent: i64) -> Self {
        match mantissa.trailing_zeros() {
            None => Self { mantissa, exponent: 0 },
            Some(zeros) => Self {
                mantissa: mantissa >> zeros,
                exponent: exponent.saturating_add(i64::try_from(zeros).unwrap_or(i64::MAX)),
            },
        }
    }

    /// The exact value of a float; `None` for NaN and infinities.
    pub fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let (mantissa, exponent) = decompose(value);
        Some(Self { mantissa: mantissa.into(), exponent: exponent.into() })
    }

    /// The same value, if the denominator is a power of two.
    pub fn from_rational(value: &Rat) -> Option<Self> {
        let denominator = value.denominator();
        let exponent = denominator.trailing_zeros()?;
        if !denominator.is_power_of_two() {
            return None;
        }
        Some(Self::new(value.numerator().clone(), -i64::try_from(exponent).ok()?))
    }

    /// The odd mantissa, or zero.
    pub fn mantissa(&self) -> &IBig {
        &self.mantissa
    }

    /// The exponent; 0 for zero.
    pub fn exponent(&self) -> i64 {
        self.exponent
    }
}

impl fmt::Display for Dyadic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.mantissa == IBig::ZERO {
            return f.write_str("0");
        }
        write!(f, "{}*2^{}", self.mantissa, self.exponent)
    }
}
