//! A mesh triangle in the coordinates of a tet, in integers.
//!
//! The tet's map to the reference prism is affine, so on a triangle the projection is a matrix. Its
//! inverse is wanted up to a factor only: points are homogeneous and nothing is divided.

use dashu_base::{BitTest, Sign as BigSign};
use dashu_int::IBig;

use crate::number::Rat;
use crate::number::dyadic::{decompose, scale_points};
use crate::predicate::Sign;

pub(super) type Big3 = [IBig; 3];

/// A triangle in a positive tet, up to one positive factor each.
#[derive(Debug)]
pub(super) struct Matrices {
    /// Row `k`, column `i`: the coordinate on tet vertex `k` of triangle corner `i`.
    pub(super) lambda: [Big3; 4],
    /// The tet's determinant: every column of `lambda` adds up to it.
    pub(super) volume: IBig,
    /// Row `i`, column `j`: the weight on triangle corner `i` that prism corner `j` has under the
    /// inverse of the projection. Its columns have one sum, [`Self::area`].
    pub(super) inverse: [Big3; 3],
    /// Zero where the triangle is parallel to the field of the tet, else positive.
    pub(super) area: IBig,
}

impl Matrices {
    /// `on[k]` is the prism corner on whose pillar tet vertex `k` lies.
    pub(super) fn new(tet: [&[f64; 3]; 4], triangle: [&[f64; 3]; 3], on: [usize; 4]) -> Self {
        let [o, e1, e2, e3, a, b, c] =
            [tet[0], tet[1], tet[2], tet[3], triangle[0], triangle[1], triangle[2]];
        let (edges, crosses) =
            narrow([o, e1, e2, e3, a, b, c]).unwrap_or_else(|| wide([o, e1, e2, e3, a, b, c]));
        let [first, _, _, a, b, c] = &edges;
        let volume = dot(first, &crosses[0]);
        let [one, two, three] = [0, 1, 2].map(|k| [a, b, c].map(|q| dot(q, &crosses[k])));
        let zero = [0, 1, 2].map(|i| &volume - &one[i] - &two[i] - &three[i]);
        let lambda = [zero, one, two, three];
        let to_middle = sums(&lambda, on);
        let mut inverse = adjugate(&to_middle);
        let mut area = &inverse[0][0] + &inverse[1][0] + &inverse[2][0];
        if sign(&area).is_negative() {
            inverse = inverse.map(|row| row.map(|x| -x));
            area = -area;
        }
        Self { lambda, volume, inverse, area }
    }

    /// The tet coordinates of the point of the triangle with these weights.
    pub(super) fn in_tet(&self, weights: &Big3) -> [IBig; 4] {
        self.lambda.each_ref().map(|row| dot(row, weights))
    }

    /// The weights in the triangle of the point over a middle point.
    pub(super) fn on_triangle(&self, middle: &Big3) -> Big3 {
        self.inverse.each_ref().map(|row| dot(row, middle))
    }
}

/// Tet coordinates, or rows of them, added up by prism corner.
fn sums(lambda: &[Big3; 4], on: [usize; 4]) -> [Big3; 3] {
    [0, 1, 2].map(|j| [0, 1, 2].map(|i| (0..4).filter(|&k| on[k] == j).map(|k| &lambda[k][i]).sum::<IBig>()))
}

/// The weights of a middle point from the coordinates in the tet.
pub(super) fn middle_of(coordinates: &[IBig; 4], on: [usize; 4]) -> Big3 {
    [0, 1, 2].map(|j| (0..4).filter(|&k| on[k] == j).map(|k| &coordinates[k]).sum::<IBig>())
}

type Vectors = ([Big3; 6], [Big3; 3]);

/// The differences to the first point, and the cross products of the tet's edges (2x3, 3x1, 1x2),
/// where all integers fit into 62 bits. Each axis has a unit of its own: ratios of determinants do
/// not change.
///
/// Integers below `2^61`: differences below `2^62`, products below `2^124`, and the difference of two
/// of them below `2^125`.
fn narrow(points: [&[f64; 3]; 7]) -> Option<Vectors> {
    let mut out = [[0_i64; 3]; 7];
    for axis in 0..3 {
        let parts = points.map(|p| decompose(p[axis]));
        let lowest = parts.iter().filter(|(m, _)| *m != 0).map(|(_, e)| *e).min().unwrap_or(0);
        for (row, (mantissa, exponent)) in out.iter_mut().zip(parts) {
            if mantissa == 0 {
                continue;
            }
            let shift = exponent.abs_diff(lowest);
            if shift + 64 - mantissa.unsigned_abs().leading_zeros() > 61 {
                return None;
            }
            row[axis] = mantissa << shift;
        }
    }
    let [o, rest @ ..] = out;
    let edges = rest.map(|p| [p[0] - o[0], p[1] - o[1], p[2] - o[2]]);
    let cross = |u: [i64; 3], v: [i64; 3]| {
        let [u, v] = [u, v].map(|x| x.map(i128::from));
        [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]].map(IBig::from)
    };
    let [x, y, z, ..] = edges;
    Some((edges.map(|e| e.map(IBig::from)), [cross(y, z), cross(z, x), cross(x, y)]))
}

/// The same without a bound on the integers.
fn wide(points: [&[f64; 3]; 7]) -> Vectors {
    let (points, _) = scale_points(&points.map(|p| *p));
    let edge = |k: usize| [0, 1, 2].map(|i| &points[k + 1][i] - &points[0][i]);
    let edges = [0, 1, 2, 3, 4, 5].map(edge);
    let cross = |u: &Big3, v: &Big3| {
        [&u[1] * &v[2] - &u[2] * &v[1], &u[2] * &v[0] - &u[0] * &v[2], &u[0] * &v[1] - &u[1] * &v[0]]
    };
    let crosses = [cross(&edges[1], &edges[2]), cross(&edges[2], &edges[0]), cross(&edges[0], &edges[1])];
    (edges, crosses)
}

/// `a . b`.
pub(super) fn dot(a: &Big3, b: &Big3) -> IBig {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The transposed matrix of cofactors.
fn adjugate(n: &[Big3; 3]) -> [Big3; 3] {
    let minor = |r: usize, c: usize| {
        let ([r1, r2], [c1, c2]) = ([(r + 1) % 3, (r + 2) % 3], [(c + 1) % 3, (c + 2) % 3]);
        &n[r1][c1] * &n[r2][c2] - &n[r1][c2] * &n[r2][c1]
    };
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(j, i)))
}

pub(super) fn sign(x: &IBig) -> Sign {
    if *x == IBig::ZERO {
        Sign::Zero
    } else if x.sign() == BigSign::Negative {
        Sign::Negative
    } else {
        Sign::Positive
    }
}

/// `n / d` for `d > 0`: off by at most `4 u |n / d|`, or by `2^-1022`; zero exactly where `n` is.
///
/// Below `2^1000` both conversions and the division are rounded once each, and nothing leaves the range of
/// normal numbers. An overflow gives an infinity, which decides nothing.
pub(super) fn quotient(n: &IBig, d: &IBig) -> f64 {
    if *n == IBig::ZERO {
        return 0.0;
    }
    if n.bit_len() <= 1000 && d.bit_len() <= 1000 {
        return n.to_f64().value() / d.to_f64().value();
    }
    let (_, denominator) = d.clone().into_parts();
    let value = Rat::from_parts(n.clone(), denominator).to_f64().value();
    let least = if sign(n).is_negative() { -f64::MIN_POSITIVE } else { f64::MIN_POSITIVE };
    if value.abs() < f64::MIN_POSITIVE { least } else { value }
}

/// Integers in the ratio of three doubles, which must be finite.
pub(super) fn in_ratio(x: [f64; 3]) -> Big3 {
    crate::number::dyadic::common_scale(x).0
}
