//! The integer filter against exact determinants; doubles against their bits.

use super::{Integer, Vec3, cross, decode, det, dot, key, leading_bits, sgn, sign_near};
use ethnum::I256;
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
        let near: Vec<i128> = Integer::leading(rows.as_flattened()).collect();
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

/// Numbers of changing size, of either sign.
fn random() -> impl FnMut(u32) -> i128 {
    let mut state = 5u64;
    let mut word = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        i128::from(state >> 32)
    };
    move |bits| {
        let x = (word() << 64 | word() << 32 | word()) & ((1 << bits) - 1);
        if word() % 2 == 0 { x } else { -x }
    }
}

/// Rows of which the third is a combination of the others up to a disturbance of so many bits.
fn nearly_dependent(next: &mut impl FnMut(u32) -> i128, bits: u32, disturbance: u32) -> [Vec3<i128>; 3] {
    let mut row = || [0; 3].map(|_| next(bits));
    let (a, b) = (row(), row());
    let (p, q) = (next(6), next(6));
    [a, b, std::array::from_fn(|i| (a[i] * p + b[i] * q) / 128 + next(disturbance))]
}

fn big(rows: &[Vec3<i128>; 3]) -> [Vec3; 3] {
    rows.map(|row| row.map(BigInt::from))
}

/// The signs of the cofactors: how each entry moves the determinant.
fn cofactors(rows: &[Vec3<i128>; 3]) -> [Vec3<i32>; 3] {
    let [a, b, c] = &big(rows);
    [cross(b, c), cross(c, a), cross(a, b)].map(|row| row.map(|x| sgn(&x)))
}

#[test]
fn the_filter_withstands_the_worst_errors() {
    let mut next = random();
    let (mut decided, mut left, mut turned) = (0, 0, 0);
    for round in 0..60000 {
        let bits = 2 + round % 80;
        let rows = match round % 3 {
            0 => [[0; 3]; 3].map(|row| row.map(|_| next(bits))),
            _ => nearly_dependent(&mut next, bits, 1 + round / 3 % 8),
        };
        // Entries off by almost 2, all to the side that makes the determinant smaller.
        let (sign, effect) = (sgn(&det(&big(&rows))), cofactors(&rows));
        let error = (1i128 << 21) - 1;
        let exact = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                (BigInt::from(rows[i][j]) << 20) - BigInt::from(error) * (sign * effect[i][j])
            })
        });
        let truth = sgn(&det(&exact));
        turned += usize::from(truth != sign);
        match sign_near(&rows, false) {
            Some(found) => {
                assert_eq!(found, truth, "{rows:?}");
                decided += 1;
            }
            None => left += 1,
        }
    }
    assert!(decided > 5000 && left > 5000 && turned > 5000, "{decided} {left} {turned}");
}

#[test]
fn the_short_filter_withstands_the_worst_roundings() {
    let mut next = random();
    let (mut found, mut turned) = ([0; 3], 0);
    for round in 0..60000 {
        let bits = 2 + round % 40;
        let short = match round % 3 {
            0 => [[0; 3]; 3].map(|row| row.map(|_| next(bits))),
            _ => nearly_dependent(&mut next, bits, 1 + round / 3 % 8),
        };
        // Rounding down takes almost one from the entries that make the determinant smaller.
        let (sign, effect) = (sgn(&det(&big(&short))), cofactors(&short));
        let rows = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                (short[i][j] << 40) + if sign * effect[i][j] < 0 { (1i128 << 40) - 1 } else { 0 }
            })
        });
        let truth = sgn(&det(&big(&rows)));
        turned += usize::from(truth != sign);
        assert!(sign_near(&rows, false).is_none_or(|found| found == truth), "{rows:?}");
        assert_eq!(sign_near(&rows, true), Some(truth), "{rows:?}");
        found[usize::try_from(truth + 1).expect("a sign")] += 1;
    }
    assert!(turned > 2000 && found[0] > 5000 && found[2] > 5000, "{turned} {found:?}");
}

#[test]
fn what_is_known_exactly_is_decided() {
    let mut next = random();
    let mut found = [0; 3];
    for round in 0..20000 {
        let rows = nearly_dependent(&mut next, 2 + round % 80, round / 80 % 4);
        let truth = sgn(&det(&big(&rows)));
        assert_eq!(sign_near(&rows, true), Some(truth), "{rows:?}");
        found[usize::try_from(truth + 1).expect("a sign")] += 1;
    }
    assert!(found.iter().all(|&n| n > 50), "{found:?}");
}

fn short(x: &BigInt) -> I256 {
    x.to_string().parse().expect("256 bits")
}

#[test]
fn short_vectors_are_multiplied_as_long_ones() {
    let mut next = random();
    for _ in 0..2000 {
        // Differences of numbers below 2^80, and products of them.
        let [a, b, c]: [Vec3<I256>; 3] =
            std::array::from_fn(|_| std::array::from_fn(|_| I256::from(next(80)) + I256::from(next(80))));
        let big = |v: &Vec3<I256>| v.each_ref().map(Integer::big);
        assert_eq!(big(&cross(&a, &b)), cross(&big(&a), &big(&b)));
        assert_eq!(dot(&cross(&a, &b), &c).big(), det(&[big(&a), big(&b), big(&c)]));
    }
}

#[test]
fn the_leading_bits_of_doubles() {
    let values =
        [1.0, 1.5, 0.1, 1e308, 1e-308, f64::from_bits(1), f64::MAX, f64::MIN_POSITIVE, 5e-324 * 77.0];
    let all: Vec<f64> = values.iter().flat_map(|x| [*x, -x]).chain([0.0]).collect();
    for (&x, &greater) in all.iter().flat_map(|x| all.iter().map(move |y| (x, y))) {
        let (mantissa, e) = decode(key(greater.to_bits()));
        let top = e + 64 - i64::from(mantissa.unsigned_abs().leading_zeros());
        if x.abs() > greater.abs() {
            continue;
        }
        for bits in [40, 80] {
            let near = BigInt::from(leading_bits(key(x.to_bits()), top, bits));
            // The value in units of 2^-1100, and those of the leading bits.
            let (mantissa, e) = decode(key(x.to_bits()));
            let value = if mantissa == 0 { BigInt::ZERO } else { BigInt::from(mantissa) << (e + 1200) };
            let unit = BigInt::from(1) << (top - bits + 1200);
            assert!(&near * &unit <= value && value < (&near + 1) * &unit, "{x:e} {greater:e} {bits}");
            assert!(near.magnitude() <= BigInt::from(1u128 << bits).magnitude(), "{x:e} {greater:e}");
        }
    }
}

#[test]
fn leading_bits_are_rounded_down() {
    let mut next = random();
    for round in 0..5000u64 {
        let numbers: [BigInt; 4] = std::array::from_fn(|i| {
            let bits = u32::try_from(round % 90).expect("small") + 1;
            let x = BigInt::from(next(bits)) << (round * (7 + i as u64) % 61);
            // A power of two among the negative ones, which rounding may not take below -2^80.
            if round % 5 == 0 && i == 0 {
                -(BigInt::from(1) << (round % 200)) - BigInt::from(round % 2)
            } else {
                x
            }
        });
        let near: Vec<i128> = Integer::leading(&numbers[..]).collect();
        if numbers.iter().all(|x| x.bits() < 255) {
            let short: Vec<I256> = numbers.iter().map(short).collect();
            assert_eq!(I256::leading(&short).collect::<Vec<_>>(), near, "{numbers:?}");
            assert!(short.iter().map(Integer::big).eq(numbers.iter().cloned()));
        }
        let most = numbers.iter().map(BigInt::bits).max().unwrap_or(0);
        for (x, near) in numbers.iter().zip(&near) {
            // Both times 2^80 and the common power of two.
            let (low, x) = (BigInt::from(*near) << most, x << 80u32);
            let one = BigInt::from(1) << most;
            assert!(low <= x && x < low + one, "{numbers:?}");
            assert!(near.abs() <= 1 << 80);
        }
        assert!(most == 0 || near.iter().any(|x| x.abs() >= 1 << 79), "{numbers:?}");
    }
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
