//! Exact integers: fixed-width ones on the stack and `BigInt`, behind one trait, and vectors of them.

use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// What the geometric code needs of an integer.
pub(crate) trait Num: Clone {
    /// `mantissa * 2^shift`.
    fn scaled(mantissa: i64, shift: usize) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    /// -1, 0 or 1.
    fn sgn(&self) -> i32;
    fn big(&self) -> BigInt;
}

impl Num for BigInt {
    fn scaled(mantissa: i64, shift: usize) -> Self {
        Self::from(mantissa) << shift
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
    fn sgn(&self) -> i32 {
        if self.is_zero() { 0 } else { i32::from(self.is_positive()) * 2 - 1 }
    }
    fn big(&self) -> BigInt {
        self.clone()
    }
}

/// A two's complement integer of `64 N` bits, least limb first. Arithmetic wraps, so a caller must know a bound;
/// with coordinates `|x| < 2^L` every value that this crate computes in `Num` is below `2^(4L+8)`:
/// a difference `d` is below `2^(L+1)`; a component of `d x d` has 2 products, below `2^(2L+3)`; a component of
/// `d x (d x d)` is below `2^(3L+5)`; its dot with a `d` has 3 products, below `2^(4L+8)`. A determinant of three `d`
/// is below `2^(3L+6)`, a sum of four of them below `2^(3L+8)`. Hence [`fits`].
#[derive(Clone, Copy)]
pub(crate) struct Fixed<const N: usize>([u64; N]);

/// Whether `Fixed<N>` is wide enough for coordinates below `2^bits`.
pub(crate) fn fits<const N: usize>(bits: usize) -> bool {
    bits.saturating_mul(4).saturating_add(8) < 64 * N
}

impl<const N: usize> Fixed<N> {
    fn negated(&self) -> Self {
        Self([0; N]).minus(self)
    }
}

impl<const N: usize> Num for Fixed<N> {
    fn scaled(mantissa: i64, shift: usize) -> Self {
        let wide = u128::from(mantissa.unsigned_abs()) << (shift % 64);
        let mut limbs = [0; N];
        for (limb, part) in limbs.iter_mut().skip(shift / 64).zip([wide as u64, (wide >> 64) as u64]) {
            *limb = part;
        }
        if mantissa < 0 { Self(limbs).negated() } else { Self(limbs) }
    }
    fn plus(&self, other: &Self) -> Self {
        let (mut out, mut carry) = ([0; N], 0);
        for ((o, a), b) in out.iter_mut().zip(self.0).zip(other.0) {
            let sum = u128::from(a) + u128::from(b) + carry;
            (*o, carry) = (sum as u64, sum >> 64);
        }
        Self(out)
    }
    fn minus(&self, other: &Self) -> Self {
        let (mut out, mut borrow) = ([0; N], false);
        for ((o, a), b) in out.iter_mut().zip(self.0).zip(other.0) {
            let (first, under) = a.overflowing_sub(b);
            let (second, again) = first.overflowing_sub(u64::from(borrow));
            (*o, borrow) = (second, under || again);
        }
        Self(out)
    }
    fn times(&self, other: &Self) -> Self {
        let mut out = [0u64; N];
        for (i, a) in self.0.iter().enumerate() {
            let mut carry = 0;
            for (o, b) in out[i..].iter_mut().zip(other.0) {
                let sum = u128::from(*a) * u128::from(b) + u128::from(*o) + carry;
                (*o, carry) = (sum as u64, sum >> 64);
            }
        }
        Self(out)
    }
    fn sgn(&self) -> i32 {
        match self.0.last() {
            Some(top) if top >> 63 == 1 => -1,
            _ => i32::from(self.0.iter().any(|&limb| limb != 0)),
        }
    }
    fn big(&self) -> BigInt {
        BigInt::from_signed_bytes_le(&self.0.iter().flat_map(|limb| limb.to_le_bytes()).collect::<Vec<u8>>())
    }
}

/// A finite double as `mantissa * 2^exponent` with an odd mantissa, or `(0, 0)`.
pub(crate) fn decode(bits: u64) -> (i64, i64) {
    let (raw, fraction) = ((bits >> 52 & 0x7ff).cast_signed(), (bits & ((1 << 52) - 1)).cast_signed());
    let (mantissa, exponent) = if raw == 0 { (fraction, -1074) } else { (fraction | 1 << 52, raw - 1075) };
    if mantissa == 0 {
        return (0, 0);
    }
    let zeros = mantissa.trailing_zeros();
    let odd = mantissa >> zeros;
    (if bits >> 63 == 1 { -odd } else { odd }, exponent + i64::from(zeros))
}

/// An integer that orders finite doubles as their values do, equal exactly for equal values (`-0` and `0` too).
pub(crate) fn key(bits: u64) -> i64 {
    let magnitude = (bits & (u64::MAX >> 1)).cast_signed();
    if bits >> 63 == 1 { -magnitude } else { magnitude }
}

/// A vector or a point.
pub(crate) type Vec3<N> = [N; 3];

pub(crate) fn sub<N: Num>(a: &Vec3<N>, b: &Vec3<N>) -> Vec3<N> {
    std::array::from_fn(|i| a[i].minus(&b[i]))
}

pub(crate) fn cross<N: Num>(a: &Vec3<N>, b: &Vec3<N>) -> Vec3<N> {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j].times(&b[k]).minus(&a[k].times(&b[j]))
    })
}

pub(crate) fn dot<N: Num>(a: &Vec3<N>, b: &Vec3<N>) -> N {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

/// The determinant of three rows.
pub(crate) fn det<N: Num>(a: &Vec3<N>, b: &Vec3<N>, c: &Vec3<N>) -> N {
    dot(&cross(a, b), c)
}

#[cfg(test)]
mod tests;
