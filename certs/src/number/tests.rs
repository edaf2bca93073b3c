//! Fixed width against `BigInt`; doubles against their bits.

use super::{Fixed, Num, decode, key};
use num_bigint::BigInt;

#[test]
fn fixed_width_is_big() {
    let mantissas = [0, 1, -1, 3, -7, (1 << 53) - 1, -((1 << 53) - 1)];
    let shifts = [0, 1, 63, 64, 65, 100, 127];
    let all: Vec<(i64, usize)> = mantissas.iter().flat_map(|m| shifts.map(|s| (*m, s))).collect();
    for &(m, s) in &all {
        for &(n, t) in &all {
            let (a, b) = (Fixed::<8>::scaled(m, s), Fixed::<8>::scaled(n, t));
            let (x, y) = (BigInt::scaled(m, s), BigInt::scaled(n, t));
            for (fixed, big) in [
                (a.plus(&b), x.plus(&y)),
                (a.minus(&b), x.minus(&y)),
                (a.times(&b), x.times(&y)),
                (a.times(&b).minus(&a), x.times(&y).minus(&x)),
            ] {
                assert_eq!((fixed.big(), fixed.sgn()), (big.clone(), big.sgn()));
            }
        }
    }
}

#[test]
fn doubles() {
    let values = [0.0, 1.0, 1.5, 0.1, 1e308, 1e-308, f64::from_bits(1), f64::MAX, f64::MIN_POSITIVE];
    let all: Vec<f64> = values.iter().flat_map(|x| [*x, -x]).collect();
    for &x in &all {
        let (mantissa, exponent) = decode(x.to_bits());
        assert!(mantissa == 0 || mantissa % 2 != 0);
        // The integer value times 2^1074.
        let scaled = BigInt::scaled(mantissa, usize::try_from(exponent + 1074).expect("not negative"));
        for &y in &all {
            let (n, e) = decode(y.to_bits());
            let other = BigInt::scaled(n, usize::try_from(e + 1074).expect("not negative"));
            assert_eq!(key(x.to_bits()).cmp(&key(y.to_bits())), scaled.cmp(&other), "{x} {y}");
            assert_eq!(scaled.cmp(&other), x.partial_cmp(&y).expect("finite"));
        }
    }
    assert_eq!((decode(0.375f64.to_bits()), decode((-4.0f64).to_bits())), ((3, -3), (-1, 2)));
}
