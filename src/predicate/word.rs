//! The cheapest exact stage: coordinates that, axis by axis, are multiples of one power of two and fit a machine word.
//!
//! Scaling an axis by a positive number changes no sign of a determinant of differences. Points on a grid, points rounded to
//! `float`, and doubles of similar size all fit; what does not goes to [`Integers`](super::determinant::Integers).

use super::Sign;
use super::determinant::Rows;

/// Every integer here is below `2^BITS` in absolute value; their differences are below `2^(BITS + 1)`.
const BITS: u64 = 60;

/// The lower half of 128 bits.
const LOW: i128 = u64::MAX as i128;

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

/// `a * d - b * c`, below `2^123`.
#[inline(always)]
fn minor(a: i64, b: i64, c: i64, d: i64) -> i128 {
    i128::from(a) * i128::from(d) - i128::from(b) * i128::from(c)
}

/// The sign of the determinant whose rows are differences of points, if their coordinates fit.
///
/// Differences are below `2^61`, minors `m` below `2^123`. With `m = 2^64 h + l`, `0 <= l < 2^64`: the three products `h * p` are
/// below `2^120`, the three `l * p` below `2^125`, so both sums fit 128 bits.
#[inline(always)]
pub(super) fn sign3<const N: usize>(points: [&[f64; 3]; N], rows: Rows<3>) -> Option<Sign> {
    let axes = [axis(points, 0)?, axis(points, 1)?, axis(points, 2)?];
    let row =
        |(i, j): (usize, usize)| [axes[0][j] - axes[0][i], axes[1][j] - axes[1][i], axes[2][j] - axes[2][i]];
    let [p, q, r] = [row(rows[0]), row(rows[1]), row(rows[2])];
    let minors =
        [minor(q[1], q[2], r[1], r[2]), minor(q[2], q[0], r[2], r[0]), minor(q[0], q[1], r[0], r[1])];
    let (mut high, mut low) = (0i128, 0i128);
    for (m, p) in minors.iter().zip(p) {
        high += (m >> 64) * i128::from(p);
        low += (m & LOW) * i128::from(p);
    }
    // 2^64 high + low = 2^64 (high + carry) + rest, with 0 <= rest < 2^64.
    Some((high + (low >> 64)).cmp(&0).then((low & LOW).cmp(&0)).into())
}

/// [`sign3`] in the plane.
#[inline(always)]
pub(super) fn sign2(points: [&[f64; 2]; 3], rows: Rows<2>) -> Option<Sign> {
    let axes = [axis(points, 0)?, axis(points, 1)?];
    let row = |(i, j): (usize, usize)| [axes[0][j] - axes[0][i], axes[1][j] - axes[1][i]];
    let [p, q] = [row(rows[0]), row(rows[1])];
    Some(minor(p[0], p[1], q[0], q[1]).cmp(&0).into())
}
