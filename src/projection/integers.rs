//! The barycentric coordinates of a point in a tet as integers with one common factor: of fixed width where they fit.
//!
//! Coordinate `k` is a determinant of differences between the tet's vertices and the point; together they are the
//! tet's own determinant. Each axis has a unit of its own, a power of two: it is a factor of every determinant, and their
//! ratios do not change.

use dashu_int::{IBig, UBig};

use crate::number::dyadic::decompose;
use crate::number::fixed::{self, Fixed, Magnitude};

/// Numbers of one kind: the smallest that holds them all.
#[derive(Clone, Debug)]
pub(super) enum Integers<const N: usize> {
    /// Differences of at most 61 bits.
    Narrow([Fixed<3>; N]),
    /// Coordinates of at most 125 bits.
    Wide([Fixed<6>; N]),
    /// Any others.
    Big(Box<[IBig; N]>),
}

/// Rows: the tet's vertices minus the point.
type Rows<T> = [[T; 3]; 4];

/// The coordinates of a point in a positive tet, times one positive number. All must be finite.
///
/// Where none is negative their sum, and all sums of some of them with factors -1, 0, 1, are integers of the same
/// kind: in absolute value none is above the sum of the four.
pub(super) fn coordinates(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Integers<4> {
    let Some(rows) = differences(tet, p) else {
        return Integers::Big(Box::new(determinants(&big_differences(tet, p), cross_big, dot_big, |x| -x)));
    };
    // All bits that differ from the sign; below 2^61 in each for a difference of at most 2^61. Four dot products then stay
    // below 2^188.
    let bits = rows.as_flattened().iter().fold(0, |all, d| all | (d ^ (d >> 127)));
    if bits >> 61 == 0 {
        let rows = rows.map(|row| row.map(|d| d as i64));
        return Integers::Narrow(determinants(&rows, fixed::cross, fixed::dot, negated));
    }
    let rows = rows.map(|row| row.map(|d| Fixed::from(d).magnitude()));
    Integers::Wide(determinants(&rows, cross_wide, dot_wide, negated))
}

/// The four determinants from two cross products; swapping two rows changes the sign.
fn determinants<T, M, P>(
    [a, b, c, d]: &Rows<T>,
    cross: impl Fn(&[T; 3], &[T; 3]) -> [M; 3],
    dot: impl Fn(&[T; 3], &[M; 3]) -> P,
    negated: impl Fn(P) -> P,
) -> [P; 4] {
    let (cd, ab) = (cross(c, d), cross(a, b));
    [dot(b, &cd), negated(dot(a, &cd)), dot(d, &ab), negated(dot(c, &ab))]
}

/// The differences in units of the axes; `None` where a coordinate is not below `2^125` in these.
fn differences(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Option<Rows<i128>> {
    let mut rows = [[0; 3]; 4];
    for axis in 0..3 {
        let (parts, lowest) = parts(tet, p, axis);
        let mut values = [0; 5];
        for (value, (mantissa, exponent)) in values.iter_mut().zip(parts) {
            let shift = if mantissa == 0 { 0 } else { exponent.abs_diff(lowest) };
            // A mantissa has at most 53 bits.
            if shift > 125 - 53 {
                return None;
            }
            *value = i128::from(mantissa) << shift;
        }
        for (row, value) in rows.iter_mut().zip(values) {
            row[axis] = value - values[4];
        }
    }
    Some(rows)
}

/// Mantissas and exponents of one coordinate of the tet's vertices and the point, and the axis' unit.
fn parts(tet: [&[f64; 3]; 4], p: &[f64; 3], axis: usize) -> ([(i64, i32); 5], i32) {
    let [a, b, c, d] = tet;
    let parts = [a, b, c, d, p].map(|x| decompose(x[axis]));
    let lowest = parts.iter().fold(i32::MAX, |low, &(m, e)| if m == 0 { low } else { low.min(e) });
    (parts, lowest)
}

fn big_differences(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Rows<IBig> {
    let columns = [0, 1, 2].map(|axis| {
        let (parts, lowest) = parts(tet, p, axis);
        let [a, b, c, d, p] = parts.map(|(mantissa, exponent)| {
            IBig::from(mantissa) << if mantissa == 0 { 0 } else { exponent.abs_diff(lowest) as usize }
        });
        [a, b, c, d].map(|x| x - &p)
    });
    [0, 1, 2, 3].map(|k| columns.each_ref().map(|column| column[k].clone()))
}

/// Differences are below `2^126`, products `2^252`, their differences `2^253`.
fn cross_wide(q: &[Magnitude<2>; 3], r: &[Magnitude<2>; 3]) -> [Magnitude<4>; 3] {
    let minor = |i: usize, j: usize| q[i].times::<2, 4>(&r[j]).minus(q[j].times(&r[i])).magnitude();
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// Three products below `2^379`, and four of these sums below `2^383`.
fn dot_wide(p: &[Magnitude<2>; 3], minor: &[Magnitude<4>; 3]) -> Fixed<6> {
    let product = |i: usize| -> Fixed<6> { minor[i].times(&p[i]) };
    product(0).plus(product(1)).plus(product(2))
}

fn cross_big(q: &[IBig; 3], r: &[IBig; 3]) -> [IBig; 3] {
    [&q[1] * &r[2] - &q[2] * &r[1], &q[2] * &r[0] - &q[0] * &r[2], &q[0] * &r[1] - &q[1] * &r[0]]
}

fn dot_big(p: &[IBig; 3], minor: &[IBig; 3]) -> IBig {
    &p[0] * &minor[0] + &p[1] * &minor[1] + &p[2] * &minor[2]
}

fn negated<const P: usize>(x: Fixed<P>) -> Fixed<P> {
    Fixed::ZERO.minus(x)
}

impl<const N: usize> Integers<N> {
    /// Sums of the numbers with factors -1, 0, 1.
    pub(super) fn combined<const M: usize>(&self, factors: [[i8; N]; M]) -> Integers<M> {
        match self {
            Self::Narrow(x) => Integers::Narrow(factors.map(|row| sum(x, row))),
            Self::Wide(x) => Integers::Wide(factors.map(|row| sum(x, row))),
            Self::Big(x) => {
                let sum = |row: [i8; N]| x.iter().zip(row).map(|(x, factor)| x * IBig::from(factor)).sum();
                Integers::Big(Box::new(factors.map(sum)))
            }
        }
    }

    /// As big integers.
    pub(super) fn to_big(&self) -> [IBig; N] {
        match self {
            Self::Narrow(x) => x.map(big),
            Self::Wide(x) => x.map(big),
            Self::Big(x) => x.as_ref().clone(),
        }
    }
}

fn sum<const P: usize, const N: usize>(x: &[Fixed<P>; N], factors: [i8; N]) -> Fixed<P> {
    x.iter().zip(factors).fold(Fixed::ZERO, |sum, (x, factor)| match factor {
        0 => sum,
        1.. => sum.plus(*x),
        _ => sum.minus(*x),
    })
}

fn big<const P: usize>(x: Fixed<P>) -> IBig {
    let Magnitude { negative, limbs } = x.magnitude();
    let bytes = limbs.map(u64::to_le_bytes);
    let value = IBig::from(UBig::from_le_bytes(bytes.as_flattened()));
    if negative { -value } else { value }
}
