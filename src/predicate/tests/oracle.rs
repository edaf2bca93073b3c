//! Brute force that shares no code with the predicates: `num-bigint` and a float decoder of its own.

use num_bigint::BigInt;

use crate::predicate::Sign;
use crate::testing::Random;

pub(crate) type P = [f64; 3];

/// `x * 2^1074`, an integer for every finite float.
pub(crate) fn integer(x: f64) -> BigInt {
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

pub(crate) fn vector(to: &P, from: &P) -> [BigInt; 3] {
    [0, 1, 2].map(|k| integer(to[k]) - integer(from[k]))
}

pub(crate) fn det(u: &[BigInt; 3], v: &[BigInt; 3], w: &[BigInt; 3]) -> BigInt {
    &u[0] * &v[1] * &w[2] + &u[1] * &v[2] * &w[0] + &u[2] * &v[0] * &w[1]
        - &u[2] * &v[1] * &w[0]
        - &u[1] * &v[0] * &w[2]
        - &u[0] * &v[2] * &w[1]
}

pub(crate) fn sign(x: &BigInt) -> Sign {
    x.cmp(&BigInt::ZERO).into()
}

pub(crate) fn orient3d(a: &P, b: &P, c: &P, d: &P) -> Sign {
    sign(&det(&vector(b, a), &vector(c, a), &vector(d, a)))
}

pub(crate) fn dot_sign(a: &P, b: &P, c: &P, s: &P, t: &P) -> Sign {
    sign(&det(&vector(b, a), &vector(c, a), &vector(t, s)))
}

/// The determinant with the given rows, by expansion along the first one.
pub(crate) fn det_of(rows: &[Vec<BigInt>]) -> BigInt {
    let Some((first, rest)) = rows.split_first() else { return BigInt::from(1) };
    let mut sum = BigInt::ZERO;
    for (k, x) in first.iter().enumerate() {
        let minor: Vec<Vec<BigInt>> = rest.iter().map(|row| [&row[..k], &row[k + 1..]].concat()).collect();
        let term = x * det_of(&minor);
        sum += if k % 2 == 0 { term } else { -term };
    }
    sum
}

/// The determinant with the rows `(1, p, |p|^2)`, times `(-1)^dimension`: the same as with differences to the last point.
pub(crate) fn lifted<const D: usize>(points: &[[f64; D]]) -> Sign {
    let row = |p: &[f64; D]| {
        let p = p.map(integer);
        // Homogeneous: 1 stands for the unit of the integers.
        let unit = integer(1.0);
        let square: BigInt = p.iter().map(|x| x * x).sum();
        let mut row: Vec<BigInt> = p.into_iter().map(|x| x * &unit).collect();
        row.push(square);
        row.push(&unit * &unit);
        row
    };
    sign(&det_of(&points.iter().map(row).collect::<Vec<_>>()))
}

pub(crate) fn orient2d(a: &P, b: &P, c: &P, drop: usize) -> Sign {
    let (u, v) = (vector(b, a), vector(c, a));
    let (i, j) = ((drop + 1) % 3, (drop + 2) % 3);
    sign(&(&u[i] * &v[j] - &u[j] * &v[i]))
}

impl Random {
    pub(crate) fn point(&mut self, mut coordinate: impl FnMut(&mut Self) -> f64) -> P {
        [coordinate(self), coordinate(self), coordinate(self)]
    }

    /// Any finite bit pattern.
    pub(crate) fn any_finite(&mut self) -> f64 {
        loop {
            let x = f64::from_bits(self.next());
            if x.is_finite() {
                return x;
            }
        }
    }
}
