//! Exponents and neighbours of doubles.

use crate::number::dyadic::decompose;

/// `2^k`; the nearest of 0 and infinity where that is no double.
pub(super) fn power(k: i32) -> f64 {
    match k {
        ..-1074 => 0.0,
        -1074..=-1023 => f64::from_bits(1 << (k + 1074).unsigned_abs()),
        -1022..=1023 => f64::from_bits(u64::from((k + 1023).unsigned_abs()) << 52),
        _ => f64::INFINITY,
    }
}

/// `x * 2^k`, rounded where it is subnormal, at most the largest double.
pub(super) fn scaled(x: f64, k: i32) -> f64 {
    let mut x = x;
    let mut k = k;
    // At most four steps: exponents range over less than 2,200. Only the last one rounds.
    while k > 1000 {
        x *= power(1000);
        k -= 1000;
    }
    while k < -1000 {
        // The last factor takes what would be subnormal: an earlier one must not round.
        let part = (k + 1000).max(-1000);
        if exponent(x).is_none_or(|e| e + part <= -1022) {
            break;
        }
        x *= power(part);
        k -= part;
    }
    if k < -1000 {
        x *= power(k.max(-1074));
    } else {
        x *= power(k);
    }
    x.clamp(f64::MIN, f64::MAX)
}

/// `floor(log2(|x|))`; `None` for zero.
pub(super) fn exponent(x: f64) -> Option<i32> {
    let (mantissa, exponent) = decompose(x);
    let bits = 64 - mantissa.unsigned_abs().leading_zeros();
    (mantissa != 0).then(|| exponent + bits.cast_signed() - 1)
}

/// The largest exponent among the values; `None` if all are zero.
pub(super) fn magnitude(case: &[f64]) -> Option<i32> {
    case.iter().filter_map(|x| exponent(*x)).max()
}

/// The difference of the largest and the least exponent among the values that are not zero.
pub(super) fn spread(case: &[f64]) -> i32 {
    let least = case.iter().filter_map(|x| exponent(*x)).min();
    magnitude(case).zip(least).map_or(0, |(greatest, least)| greatest - least)
}

/// The double `steps` further up, at most the largest one.
pub(super) fn neighbour(x: f64, steps: i32) -> f64 {
    let mut x = x;
    for _ in 0..steps.unsigned_abs() {
        x = if steps > 0 { x.next_up() } else { x.next_down() };
    }
    x.clamp(f64::MIN, f64::MAX)
}
