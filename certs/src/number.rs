//! Exact integers and vectors of them; a determinant's sign from leading bits where these decide it.

use ethnum::I256;
use num_bigint::BigInt;
use num_traits::Signed;
use std::ops::{Add, Mul, Neg, Sub};

/// A vector or a point.
pub(crate) type Vec3<T = BigInt> = [T; 3];

/// -1, 0 or 1.
pub(crate) fn sgn(x: &BigInt) -> i32 {
    i32::from(x.is_positive()) - i32::from(x.is_negative())
}

/// The finite double with this [`key`] as `mantissa * 2^exponent` with a mantissa of at most 53 bits.
fn split(key: i64) -> (i64, i64) {
    let (raw, fraction) = (key.abs() >> 52, key.abs() & ((1 << 52) - 1));
    let (mantissa, exponent) = if raw == 0 { (fraction, -1074) } else { (fraction | 1 << 52, raw - 1075) };
    (if key < 0 { -mantissa } else { mantissa }, exponent)
}

/// The same with an odd mantissa, or `(0, 0)`.
pub(crate) fn decode(key: i64) -> (i64, i64) {
    let (mantissa, exponent) = split(key);
    let zeros = mantissa.trailing_zeros();
    if mantissa == 0 { (0, 0) } else { (mantissa >> zeros, exponent + i64::from(zeros)) }
}

/// A double of less than `2^top` in absolute value, divided by `2^(top - bits)` and rounded down: at most `2^bits` in
/// absolute value, and exact if no bit is lost. There are at most 80 bits.
pub(crate) fn leading_bits(key: i64, top: i64, bits: i64) -> i128 {
    let (mantissa, exponent) = split(key);
    let shift = exponent - top + bits;
    if shift < 0 { i128::from(mantissa) >> (-shift).min(127) } else { i128::from(mantissa) << shift }
}

/// An integer that orders finite doubles as their values do, equal exactly for equal values (`-0` and `0` too).
pub(crate) fn key(bits: u64) -> i64 {
    let magnitude = (bits & (u64::MAX >> 1)).cast_signed();
    if bits >> 63 == 1 { -magnitude } else { magnitude }
}

/// Integers of 256 bits, where they suffice, or of as many as it takes.
pub(crate) trait Integer:
    Clone + From<i8> + PartialOrd + Neg<Output = Self> + Add<Output = Self> + Sub<Output = Self>
{
    fn big(&self) -> BigInt;

    /// The integers times a common power of two, rounded down: at most `2^80` in absolute value, and one of at least `2^79`.
    fn leading(numbers: &[Self]) -> impl Iterator<Item = i128>;
}

impl Integer for I256 {
    fn big(&self) -> BigInt {
        BigInt::from_signed_bytes_le(&self.to_le_bytes())
    }

    fn leading(numbers: &[Self]) -> impl Iterator<Item = i128> {
        let bits = numbers.iter().map(|x| 256 - x.abs().leading_zeros()).max().unwrap_or(0);
        numbers.iter().map(move |x| if bits > 80 { x >> (bits - 80) } else { x << (80 - bits) }.as_i128())
    }
}

impl Integer for BigInt {
    fn big(&self) -> BigInt {
        self.clone()
    }

    fn leading(numbers: &[Self]) -> impl Iterator<Item = i128> {
        let bits = numbers.iter().map(BigInt::bits).max().unwrap_or(0);
        let scaled = move |x: &BigInt| if bits > 80 { x >> (bits - 80) } else { x << (80 - bits) };
        numbers.iter().map(move |x| i128::try_from(scaled(x)).unwrap_or(i128::MAX))
    }
}

pub(crate) fn cross<T: Integer>(a: &Vec3<T>, b: &Vec3<T>) -> Vec3<T>
where
    for<'x> &'x T: Mul<&'x T, Output = T>,
{
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        &a[j] * &b[k] - &a[k] * &b[j]
    })
}

pub(crate) fn dot<T: Integer>(a: &Vec3<T>, b: &Vec3<T>) -> T
where
    for<'x> &'x T: Mul<&'x T, Output = T>,
{
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// The determinant of three rows.
pub(crate) fn det([a, b, c]: &[Vec3; 3]) -> BigInt {
    dot(&cross(a, b), c)
}

/// The sign of the determinant of three rows, each entry known as an integer of at most `2^41` in absolute value with an
/// error below 2; `None` if that does not decide it.
///
/// A product `x y z` with entries of at most `m` has an error below `(m+2)^3 - m^3 = 6m^2 + 12m + 8`, the six of the
/// determinant together one below `48 (m+1)^2`. The largest intermediate sums are at most `6 * 2^123 < 2^127`.
pub(crate) fn sign_short(rows: &[Vec3<i64>; 3]) -> Option<i32> {
    let det = determinant(rows.map(|row| row.map(i128::from)));
    let m = i128::from(rows.iter().flatten().map(Signed::abs).max().unwrap_or(0)) + 1;
    (det.abs() >= 48 * m * m).then(|| det.signum() as i32)
}

/// The same with entries of at most `2^81`, which may be known exactly. Their leading bits come first: those are at most
/// `2^41`, again with errors below 2. The largest intermediate sums are at most `6 * 2^243 < 2^255`.
pub(crate) fn sign_near(rows: &[Vec3<i128>; 3], exact: bool) -> Option<i32> {
    let long = || {
        let det = determinant(rows.map(|row| row.map(I256::from)));
        let m = I256::from(rows.iter().flatten().map(Signed::abs).max().unwrap_or(0) + 1);
        (exact || det.abs() >= m * m * 48).then(|| det.signum().as_i32())
    };
    sign_short(&rows.map(|row| row.map(|x| (x >> 40) as i64))).or_else(long)
}

fn determinant<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<Output = T>>([a, b, c]: [Vec3<T>; 3]) -> T {
    let minor = |j: usize, k: usize| a[j] * b[k] - a[k] * b[j];
    minor(1, 2) * c[0] + minor(2, 0) * c[1] + minor(0, 1) * c[2]
}

#[cfg(test)]
mod tests;
