//! The integer filter against exact determinants; doubles against their bits.

use super::{Vec3, decode, det, key, leading, sgn, sign_near};
use num_bigint::BigInt;

#[test]
fn the_filter_agrees_with_exact_signs() {
    let mut state = 7u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        BigInt::from(state.cast_signed() >> (state >> 3 & 31))
    };
    let (mut decided, mut left) = (0, 0);
    for round in 0..20000 {
        let mut rows: [Vec3; 3] = std::array::from_fn(|_| std::array::from_fn(|_| next()));
        if round % 3 == 0 {
            // Nearly dependent rows, with a disturbance of changing size.
            let small = BigInt::from(round % 7) << (round % 50);
            rows[2] = std::array::from_fn(|i| &rows[0][i] - &rows[1][i] + &small * i);
        }
        let near: Vec<i128> = leading(rows.iter().flatten()).collect();
        match sign_near(&std::array::from_fn(|i| std::array::from_fn(|j| near[3 * i + j])), false) {
            Some(sign) => {
                assert_eq!(sign, sgn(&det(&rows)), "{rows:?}");
                decided += 1;
            }
            None => left += 1,
        }
    }
    assert!(decided > 5000 && left > 1000, "{decided} {left}");
}

#[test]
fn known_exactly_zero_is_decided() {
    let at = |rows: [[i128; 3]; 3], exact| sign_near(&rows, exact);
    let flat = [[1, 2, 3], [4, 5, 6], [5, 7, 9]];
    assert_eq!((at(flat, true), at(flat, false)), (Some(0), None));
    // Too small for a filter; the next one needs more than the leading bits.
    assert_eq!((at([[1, 0, 0], [0, 1, 0], [0, 0, -1]], true)), Some(-1));
    let b = 1 << 80;
    let thin = [[b, b, 0], [b, b + (1 << 20), 0], [0, 0, b]];
    assert_eq!((at(thin, true), at(thin, false)), (Some(1), Some(1)));
    let thinner = [[b, b, 0], [b, b + 1, 0], [0, 0, b]];
    assert_eq!((at(thinner, true), at(thinner, false)), (Some(1), None));
    let largest = 1 << 81;
    assert_eq!(at([[largest, 0, -largest], [-largest, largest, 0], [largest; 3]], false), Some(1));
    assert_eq!(
        at([[-largest; 3], [-largest, largest, -largest], [-largest, -largest, largest]], false),
        Some(-1)
    );
}

#[test]
fn doubles() {
    let values = [0.0, 1.0, 1.5, 0.1, 1e308, 1e-308, f64::from_bits(1), f64::MAX, f64::MIN_POSITIVE];
    let all: Vec<f64> = values.iter().flat_map(|x| [*x, -x]).collect();
    for &x in &all {
        let (mantissa, exponent) = decode(key(x.to_bits()));
        assert!(mantissa == 0 || mantissa % 2 != 0);
        // The integer value times 2^1074.
        let scaled = BigInt::from(mantissa) << (if mantissa == 0 { 0 } else { exponent + 1074 });
        for &y in &all {
            let (n, e) = decode(key(y.to_bits()));
            let other = BigInt::from(n) << (if n == 0 { 0 } else { e + 1074 });
            assert_eq!(key(x.to_bits()).cmp(&key(y.to_bits())), scaled.cmp(&other), "{x} {y}");
            assert_eq!(scaled.cmp(&other), x.partial_cmp(&y).expect("finite"));
        }
    }
    assert_eq!((decode(key(0.375f64.to_bits())), decode(key((-4.0f64).to_bits()))), ((3, -3), (-1, 2)));
}
