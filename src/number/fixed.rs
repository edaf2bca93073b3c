//! Integers of `N` 64-bit limbs on the stack, least significant limb first.
//!
//! Signed values are two's complement. Nothing here checks for overflow: the caller proves that
//! its values fit (see `predicate::determinant`). All loops have constant bounds and no data
//! dependent branches, so that random signs cost no mispredicted jumps.

use crate::predicate::Sign;

/// A signed integer in two's complement, `-2^(64N-1) <= x < 2^(64N-1)`, `N >= 1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fixed<const N: usize>(pub [u64; N]);

/// A sign bit and a magnitude, the form in which products are formed.
#[derive(Clone, Copy, Debug)]
pub struct Magnitude<const N: usize> {
    /// Is the value less than zero?
    pub negative: bool,
    /// The absolute value.
    pub limbs: [u64; N],
}

impl<const N: usize> Fixed<N> {
    /// Zero.
    pub const ZERO: Self = Self([0; N]);

    /// `mantissa * 2^shift`, provided that it fits; bits beyond the top limb are lost.
    #[inline]
    pub fn shifted(mantissa: i64, shift: u32) -> Self {
        // Known at compile time; native shifts are much faster.
        if N == 1 {
            return Self([(mantissa << (shift % 64)).cast_unsigned(); N]);
        }
        if N == 2 {
            let wide = (i128::from(mantissa) << (shift % 128)).cast_unsigned();
            let mut limbs = [wide as u64; N];
            if let Some(high) = limbs.get_mut(1) {
                *high = (wide >> 64) as u64;
            }
            return Self(limbs);
        }
        let wide = u128::from(mantissa.unsigned_abs()) << (shift % 64);
        let (low, high) = (wide as u64, (wide >> 64) as u64);
        let first = (shift / 64) as usize;
        let mut limbs = [0; N];
        for (i, limb) in limbs.iter_mut().enumerate() {
            *limb = if i == first {
                low
            } else if i == first + 1 {
                high
            } else {
                0
            };
        }
        Self(negate_if(limbs, mantissa < 0))
    }

    /// `self - other` modulo `2^(64N)`.
    #[inline]
    #[must_use]
    pub fn minus(self, other: Self) -> Self {
        let mut out = [0; N];
        let mut borrow = false;
        for ((out, x), y) in out.iter_mut().zip(self.0).zip(other.0) {
            let (difference, b1) = x.overflowing_sub(y);
            let (difference, b2) = difference.overflowing_sub(u64::from(borrow));
            *out = difference;
            borrow = b1 | b2;
        }
        Self(out)
    }

    /// `self + other` modulo `2^(64N)`.
    #[inline]
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let mut out = [0; N];
        let mut carry = false;
        for ((out, x), y) in out.iter_mut().zip(self.0).zip(other.0) {
            let (sum, c1) = x.overflowing_add(y);
            let (sum, c2) = sum.overflowing_add(u64::from(carry));
            *out = sum;
            carry = c1 | c2;
        }
        Self(out)
    }

    /// Sign bit and absolute value.
    #[inline]
    pub fn magnitude(self) -> Magnitude<N> {
        let negative = self.is_negative();
        Magnitude { negative, limbs: negate_if(self.0, negative) }
    }

    #[inline]
    fn is_negative(self) -> bool {
        self.0.last().is_some_and(|top| top >> 63 == 1)
    }

    /// The sign.
    #[inline]
    pub fn sign(self) -> Sign {
        if self.is_negative() {
            Sign::Negative
        } else if self.0.iter().fold(0, |any, limb| any | limb) == 0 {
            Sign::Zero
        } else {
            Sign::Positive
        }
    }
}

impl<const N: usize> Magnitude<N> {
    /// The product, provided that it is below `2^(64P-1)` in absolute value; `P >= N + M` always
    /// suffices for operands below `2^(64N-1)` and `2^(64M)`.
    #[inline]
    pub fn times<const M: usize, const P: usize>(&self, other: &Magnitude<M>) -> Fixed<P> {
        let mut out = [0_u64; P];
        for (i, &x) in self.limbs.iter().enumerate() {
            let mut carry = 0_u128;
            for (j, &y) in other.limbs.iter().enumerate() {
                if let Some(limb) = out.get_mut(i + j) {
                    // (2^64-1)^2 + 2 (2^64-1) = 2^128 - 1: no overflow.
                    let sum = u128::from(x) * u128::from(y) + u128::from(*limb) + carry;
                    *limb = sum as u64;
                    carry = sum >> 64;
                }
            }
            // Row i has touched limbs i .. i+M only, so limb i+M is still zero.
            if let Some(limb) = out.get_mut(i + M) {
                *limb = carry as u64;
            }
        }
        Fixed(negate_if(out, self.negative ^ other.negative))
    }
}

/// The cross product of vectors of machine words, for entries of at most `2^61` in absolute value: products are at most `2^122`,
/// their differences `2^123`.
#[inline(always)]
pub fn cross(q: &[i64; 3], r: &[i64; 3]) -> [i128; 3] {
    let product = |i: usize, j: usize| i128::from(q[i]) * i128::from(r[j]);
    [product(1, 2) - product(2, 1), product(2, 0) - product(0, 2), product(0, 1) - product(1, 0)]
}

/// The dot product of machine words with a [`cross`] product, all words at most `2^61` in absolute value.
///
/// With an entry `2^64 h + l`, `0 <= l < 2^64`, `|h| <= 2^59`: three products with `l` are below `2^127` together, three with `h`
/// at most `2^122`, and the whole at most `3 * 2^184`.
#[inline(always)]
pub fn dot(p: &[i64; 3], minors: &[i128; 3]) -> Fixed<3> {
    let (mut low, mut high) = (0_i128, 0_i128);
    for (x, m) in p.iter().zip(minors) {
        let x = i128::from(*x);
        low += x * i128::from(m.cast_unsigned() as u64);
        high += x * (m >> 64);
    }
    let Fixed([second, third]) = (high + (low >> 64)).into();
    Fixed([low.cast_unsigned() as u64, second, third])
}

impl From<i128> for Fixed<2> {
    #[inline]
    fn from(x: i128) -> Self {
        let x = x.cast_unsigned();
        Self([x as u64, (x >> 64) as u64])
    }
}

/// `-limbs` modulo `2^(64N)` if `negate`, else `limbs`.
#[inline]
fn negate_if<const N: usize>(limbs: [u64; N], negate: bool) -> [u64; N] {
    let mask = u64::from(negate).wrapping_neg();
    let mut carry = negate;
    let mut out = limbs;
    for limb in &mut out {
        let (sum, overflow) = (*limb ^ mask).overflowing_add(u64::from(carry));
        *limb = sum;
        carry = overflow;
    }
    out
}
