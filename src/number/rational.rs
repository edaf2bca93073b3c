//! The trait that every rational backend implements.

use std::fmt::Debug;
use std::hash::Hash;

use super::{dyadic, rounding};
use crate::predicate::Sign;

/// Why a text is not a rational number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ParseRationalError {
    /// The text is not of the form `-?[0-9]+(/[0-9]+)?`.
    #[error("expected a rational number such as -3/4, found something else at byte {position}")]
    Syntax {
        /// Byte offset of the first byte that does not fit.
        position: usize,
    },
    /// The denominator is zero.
    #[error("the denominator is zero")]
    ZeroDenominator,
}

/// A rational number in lowest terms with a positive denominator; `Ord` and `Eq` compare values.
pub trait Rational: Clone + Debug + Eq + Ord + Hash + Send + Sync + 'static {
    /// The backend's name, as in the feature list.
    const BACKEND: &'static str;

    /// `mantissa * 2^exponent`, exactly. Takes memory proportional to `|exponent|`.
    fn from_scaled(mantissa: i64, exponent: i32) -> Self;

    /// The sum.
    #[must_use]
    fn plus(&self, other: &Self) -> Self;

    /// The difference.
    #[must_use]
    fn minus(&self, other: &Self) -> Self;

    /// The product.
    #[must_use]
    fn times(&self, other: &Self) -> Self;

    /// The quotient; `None` if `other` is zero.
    #[must_use]
    fn over(&self, other: &Self) -> Option<Self>;

    /// `-self`.
    #[must_use]
    fn negated(&self) -> Self;

    /// The sign.
    fn sign(&self) -> Sign;

    /// The numerator in decimal, with `-` if negative.
    fn numerator(&self) -> String;

    /// The positive denominator in decimal.
    fn denominator(&self) -> String;

    /// From a decimal numerator of the form `-?[0-9]+` and a decimal denominator of the form `[0-9]+`, not
    /// necessarily in lowest terms; `None` if the denominator is zero. What other forms give depends on the
    /// backend (a value or `None`, never a panic): [`Rational::parse`] is the checked way in.
    fn from_decimal(numerator: &str, denominator: &str) -> Option<Self>;

    /// The bit lengths of `|numerator|` and denominator.
    fn bit_lengths(&self) -> (u64, u64);

    /// `floor(|self| / 2^shift)`, and whether the division left a remainder; `None` if the quotient does
    /// not fit 64 bits.
    fn quotient(&self, shift: i32) -> Option<(u64, bool)>;

    /// Zero.
    fn zero() -> Self {
        Self::from_i64(0)
    }

    /// One.
    fn one() -> Self {
        Self::from_i64(1)
    }

    /// An integer.
    fn from_i64(value: i64) -> Self {
        Self::from_scaled(value, 0)
    }

    /// The exact value of a float; `None` for NaN and infinities.
    fn from_f64(value: f64) -> Option<Self> {
        if !value.is_finite() {
            return None;
        }
        let (mantissa, exponent) = dyadic::decompose(value);
        Some(Self::from_scaled(mantissa, exponent))
    }

    /// The nearest float, ties to even, as IEEE 754 rounds: subnormals included, infinite from
    /// `2^1024 - 2^970` on, `-0.0` for tiny negative values.
    fn to_f64(&self) -> f64 {
        rounding::nearest_even(self)
    }

    /// Is it zero?
    fn is_zero(&self) -> bool {
        self.sign().is_zero()
    }

    /// The absolute value.
    #[must_use]
    fn absolute(&self) -> Self {
        if self.sign().is_negative() { self.negated() } else { self.clone() }
    }

    /// `numerator/denominator` in decimal, without the denominator if it is 1.
    fn to_text(&self) -> String {
        match (self.numerator(), self.denominator()) {
            (numerator, denominator) if denominator == "1" => numerator,
            (numerator, denominator) => format!("{numerator}/{denominator}"),
        }
    }

    /// Reads `-?[0-9]+(/[0-9]+)?` (ASCII digits, no spaces, not necessarily in lowest terms).
    ///
    /// # Errors
    ///
    /// [`ParseRationalError`] if the text has another form or a zero denominator.
    fn parse(text: &str) -> Result<Self, ParseRationalError> {
        let (numerator, denominator) = split(text)?;
        // The form is right, so a zero denominator is all that can be wrong.
        Self::from_decimal(numerator, denominator).ok_or(ParseRationalError::ZeroDenominator)
    }
}

/// Numerator and denominator (`1` if there is none) of a text of the right form.
fn split(text: &str) -> Result<(&str, &str), ParseRationalError> {
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let (digits, rest) = unsigned.split_at(leading_digits(unsigned));
    let syntax = |position| Err(ParseRationalError::Syntax { position });
    let end = text.len() - rest.len();
    if digits.is_empty() {
        return syntax(end);
    }
    let numerator = text.get(..end).unwrap_or(text);
    if rest.is_empty() {
        return Ok((numerator, "1"));
    }
    let Some(denominator) = rest.strip_prefix('/') else { return syntax(end) };
    let valid = leading_digits(denominator);
    if valid == 0 || valid < denominator.len() {
        return syntax(end + 1 + valid);
    }
    Ok((numerator, denominator))
}

fn leading_digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}
