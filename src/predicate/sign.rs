//! The three-valued answer of every predicate.

use std::cmp::Ordering;
use std::ops::{Mul, Neg};

/// The sign of an exact quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(i8)]
pub enum Sign {
    /// Less than zero.
    Negative = -1,
    /// Exactly zero.
    Zero = 0,
    /// Greater than zero.
    Positive = 1,
}

impl Sign {
    /// `-1`, `0` or `1`.
    #[inline]
    pub const fn as_i8(self) -> i8 {
        self as i8
    }

    /// Greater than zero?
    #[inline]
    pub const fn is_positive(self) -> bool {
        matches!(self, Self::Positive)
    }

    /// Less than zero?
    #[inline]
    pub const fn is_negative(self) -> bool {
        matches!(self, Self::Negative)
    }

    /// Exactly zero?
    #[inline]
    pub const fn is_zero(self) -> bool {
        matches!(self, Self::Zero)
    }

    /// Are the two signs strictly opposite (one positive, one negative)?
    #[inline]
    pub const fn is_opposite(self, other: Self) -> bool {
        self.as_i8() * other.as_i8() < 0
    }

    /// The sign of `left - right`; an unordered pair (a NaN) counts as equal.
    #[inline]
    pub fn of_difference(left: f64, right: f64) -> Self {
        left.partial_cmp(&right).unwrap_or(Ordering::Equal).into()
    }
}

impl Neg for Sign {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Zero => Self::Zero,
            Self::Positive => Self::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        match other {
            Self::Negative => -self,
            Self::Zero => Self::Zero,
            Self::Positive => self,
        }
    }
}

impl From<Ordering> for Sign {
    #[inline]
    fn from(ordering: Ordering) -> Self {
        match ordering {
            Ordering::Less => Self::Negative,
            Ordering::Equal => Self::Zero,
            Ordering::Greater => Self::Positive,
        }
    }
}

impl From<Sign> for Ordering {
    #[inline]
    fn from(sign: Sign) -> Self {
        match sign {
            Sign::Negative => Self::Less,
            Sign::Zero => Self::Equal,
            Sign::Positive => Self::Greater,
        }
    }
}
