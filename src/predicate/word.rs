//! The cheapest exact stage: coordinates that, axis by axis, are multiples of one power of two and fit a machine word.
//!
//! Scaling an axis by a positive number changes no sign of a determinant of differences. Points on a grid, points rounded to
//! `float`, and doubles of similar size all fit; what does not goes to [`Integers`](super::determinant::Integers).

use super::Sign;
use super::determinant::Rows;
use crate::number::fixed::{cross, dot};

/// Every integer here is below `2^BITS` in absolute value; their differences are below `2^(BITS + 1)`.
const BITS: u64 = 60;

/// `values` as integers after a common scaling by a power of two, each below `2^60`. `None` where they are not of that form,
/// and for values that are not finite.
///
/// Let `e` be the largest biased exponent, at least 59, so that all values are below `2^(e - 1022)`. The factor `2^(1082 - e)`
/// is a normal double, as `59 <= e <= 2047`, and brings them below `2^60`. The product is exact where it is not subnormal. A
/// value whose product is an integer other than zero is taken as it is; a product that underflowed is below one and is refused,
/// but for the value zero. An infinite or NaN product equals no integer.
#[inline(always)]
pub(super) fn words<const N: usize>(values: [f64; N]) -> Option<[i64; N]> {
    let mut largest = 0;
    for x in &values {
        largest = largest.max(x.to_bits() << 1 >> 53);
    }
    let factor = f64::from_bits((1023 + 1022 + BITS - largest.max(BITS - 1)) << 52);
    let mut out = [0; N];
    let mut is_exact = true;
    for (out, x) in out.iter_mut().zip(&values) {
        let product = x * factor;
        *out = product as i64;
        let differs = (*out as f64).partial_cmp(&product) != Some(std::cmp::Ordering::Equal);
        // Zero alone has neither exponent nor fraction.
        is_exact &= !differs & ((*out != 0) | (x.to_bits() << 1 == 0));
    }
    is_exact.then_some(out)
}

#[inline(always)]
fn axis<const N: usize, const A: usize>(points: [&[f64; A]; N], axis: usize) -> Option<[i64; N]> {
    let mut values = [0.0; N];
    for (value, point) in values.iter_mut().zip(points) {
        *value = point[axis];
    }
    words(values)
}

/// The sign of the determinant whose rows are differences of points, if their coordinates fit. Differences are below `2^61`.
#[inline(always)]
pub(super) fn sign3<const N: usize>(points: [&[f64; 3]; N], rows: Rows<3>) -> Option<Sign> {
    let axes = [axis(points, 0)?, axis(points, 1)?, axis(points, 2)?];
    let row =
        |(i, j): (usize, usize)| [axes[0][j] - axes[0][i], axes[1][j] - axes[1][i], axes[2][j] - axes[2][i]];
    let [p, q, r] = [row(rows[0]), row(rows[1]), row(rows[2])];
    Some(dot(&p, &cross(&q, &r)).sign())
}

/// [`sign3`] in the plane.
#[inline(always)]
pub(super) fn sign2(points: [&[f64; 2]; 3], rows: Rows<2>) -> Option<Sign> {
    let axes = [axis(points, 0)?, axis(points, 1)?];
    let row = |(i, j): (usize, usize)| [axes[0][j] - axes[0][i], axes[1][j] - axes[1][i]];
    let [p, q] = [row(rows[0]), row(rows[1])];
    let product = |i: usize, j: usize| i128::from(p[i]) * i128::from(q[j]);
    Some(product(0, 1).cmp(&product(1, 0)).into())
}
