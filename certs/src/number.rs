//! Exact integers and vectors of them; a determinant's sign from leading bits where these decide it.

use num_bigint::BigInt;
use num_traits::Signed;

/// A vector or a point.
pub(crate) type Vec3<T = BigInt> = [T; 3];

/// -1, 0 or 1.
pub(crate) fn sgn(x: &BigInt) -> i32 {
    i32::from(x.is_positive()) - i32::from(x.is_negative())
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

pub(crate) fn cross(a: &Vec3, b: &Vec3) -> Vec3 {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

pub(crate) fn dot(a: &Vec3, b: &Vec3) -> BigInt {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The determinant of three rows.
pub(crate) fn det([a, b, c]: &[Vec3; 3]) -> BigInt {
    dot(&cross(a, b), c)
}

/// The integers divided by a common power of two and rounded down; all results are below `2^40` in absolute value.
pub(crate) fn leading<'a>(numbers: impl Iterator<Item = &'a BigInt> + Clone) -> impl Iterator<Item = i64> {
    let shift = numbers.clone().map(BigInt::bits).max().unwrap_or(0).saturating_sub(40);
    // Rounding down may give -2^40, which fits too.
    numbers.map(move |x| i64::try_from(x >> shift).unwrap_or(i64::MAX))
}

/// The sign of the determinant of three rows, each entry known as an integer of at most `2^41` in absolute value with an
/// error below 2; `None` if that does not decide it.
///
/// A product `x y z` with entries of at most `m` has an error below `(m+2)^3 - m^3 = 6m^2 + 12m + 8`, the six of the
/// determinant together one below `48 (m+1)^2`. The largest intermediate sum is at most `6 * 2^123 < 2^127`.
pub(crate) fn sign_near(rows: &[Vec3<i64>; 3]) -> Option<i32> {
    let [a, b, c] = rows.map(|row| row.map(i128::from));
    let largest = rows.iter().flatten().map(|x| i128::from(x.unsigned_abs())).max().unwrap_or(0);
    let minor = |j: usize, k: usize| a[j] * b[k] - a[k] * b[j];
    let value = minor(1, 2) * c[0] + minor(2, 0) * c[1] + minor(0, 1) * c[2];
    let decided = value.abs() >= 48 * (largest + 1) * (largest + 1);
    decided.then_some(if value < 0 { -1 } else { 1 })
}

#[cfg(test)]
mod tests;
