//! Brute force that shares no code with the predicates: `num-bigint` and a float decoder of its own.

use num_bigint::BigInt;

use crate::predicate::Sign;
use crate::testing::Random;

pub(super) type P = [f64; 3];

/// `x * 2^1074`, an integer for every finite float.
pub(super) fn integer(x: f64) -> BigInt {
    assert!(x.is_finite());
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52) & 2047, bits & 0x000f_ffff_ffff_ffff);
    let magnitude = if exponent == 0 {
        BigInt::from(fraction)
    } else {
        BigInt::from(fraction + 0x0010_0000_0000_0000) << (exponent - 1)
    };
    if bits >> 63 == 1 { -magnitude } else { magnitude }
}

pub(super) fn vector(to: &P, from: &P) -> [BigInt; 3] {
    [0, 1, 2].map(|k| integer(to[k]) - integer(from[k]))
}

pub(super) fn det(u: &[BigInt; 3], v: &[BigInt; 3], w: &[BigInt; 3]) -> BigInt {
    &u[0] * &v[1] * &w[2] + &u[1] * &v[2] * &w[0] + &u[2] * &v[0] * &w[1]
        - &u[2] * &v[1] * &w[0]
        - &u[1] * &v[0] * &w[2]
        - &u[0] * &v[2] * &w[1]
}

pub(super) fn sign(x: &BigInt) -> Sign {
    x.cmp(&BigInt::ZERO).into()
}

pub(super) fn orient3d(a: &P, b: &P, c: &P, d: &P) -> Sign {
    sign(&det(&vector(b, a), &vector(c, a), &vector(d, a)))
}

pub(super) fn dot_sign(a: &P, b: &P, c: &P, s: &P, t: &P) -> Sign {
    sign(&det(&vector(b, a), &vector(c, a), &vector(t, s)))
}

pub(super) fn orient2d(a: &P, b: &P, c: &P, drop: usize) -> Sign {
    let (u, v) = (vector(b, a), vector(c, a));
    let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
    sign(&(&u[i] * &v[j] - &u[j] * &v[i]))
}

impl Random {
    /// Uniform integer in `low..=high`.
    pub(super) fn integer(&mut self, low: i32, high: i32) -> i32 {
        low + i32::try_from(self.below(high.abs_diff(low) as usize + 1)).expect("small")
    }

    pub(super) fn point(&mut self, mut coordinate: impl FnMut(&mut Self) -> f64) -> P {
        [coordinate(self), coordinate(self), coordinate(self)]
    }

    /// Any finite bit pattern.
    pub(super) fn any_finite(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.next());
            if x.is_finite() {
                return x;
            }
        }
    }
}
