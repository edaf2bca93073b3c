//! Correct rounding of rationals to `f64`, the same for all backends.

use super::Rational;

/// The nearest float, ties to even.
pub(super) fn nearest_even<R: Rational>(value: &R) -> f64 {
    let magnitude = magnitude(value);
    if value.sign().is_negative() { -magnitude } else { magnitude }
}

fn magnitude<R: Rational>(value: &R) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    // 2^(e-1) < |value| < 2^(e+1).
    let (numerator, denominator) = value.bit_lengths();
    let e = (i128::from(numerator) - i128::from(denominator)).clamp(-2000, 2000) as i32;
    if e > 1026 {
        return f64::INFINITY;
    }
    if e < -1080 {
        return 0.0;
    }
    // Either the quotient has 62 or 63 bits, or its last bit is worth 2^-1076, a quarter of the least
    // subnormal: at least two bits more than the result keeps, so that one sticky bit decides ties. It has
    // at most 63 bits in both cases.
    let shift = (e - 62).max(-1076);
    match value.quotient(shift) {
        Some((quotient, inexact)) => round(quotient, shift, inexact),
        None => f64::NAN,
    }
}

/// Rounds `(quotient + r) * 2^shift`, where `0 < r < 1` if `inexact` and else `r = 0`.
///
/// Requires `shift >= -1076`, and `shift = -1076` unless the quotient has at least 55 bits.
fn round(quotient: u64, shift: i32, inexact: bool) -> f64 {
    let bits = 64 - quotient.leading_zeros();
    // The exponent of the result's last place.
    let place = (shift + bits.cast_signed() - 53).max(-1074);
    let dropped = place.abs_diff(shift).clamp(1, 63);
    let (kept, rest, half) = (quotient >> dropped, quotient & ((1 << dropped) - 1), 1 << (dropped - 1));
    let up = rest > half || (rest == half && (inexact || kept & 1 == 1));
    let kept = kept + u64::from(up);
    if kept < 1 << 52 {
        // Only at the least place, 2^-1074: a subnormal or zero.
        return f64::from_bits(kept);
    }
    match u64::try_from(place + 1075) {
        // A carry to 2^53 moves into the exponent field by itself, also from subnormal to normal and from
        // the largest float to infinity.
        Ok(biased) if biased < 2047 => f64::from_bits((biased << 52) + (kept - (1 << 52))),
        _ => f64::INFINITY,
    }
}
