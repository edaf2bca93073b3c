use dashu_int::IBig;
use proptest::prelude::*;

use crate::number::dyadic::{Dyadic, common_scale, decompose, scale_points};
use crate::number::{Rat, Rational};

#[test]
fn texts() {
    let text = |x: f64| Dyadic::from_f64(x).expect("finite").to_string();
    assert_eq!(text(0.0), "0");
    assert_eq!(text(-0.0), "0");
    assert_eq!(text(1.0), "1*2^0");
    assert_eq!(text(-0.75), "-3*2^-2");
    assert_eq!(text(f64::from_bits(1)), "1*2^-1074");
    assert_eq!(text(f64::MAX), "9007199254740991*2^971");
    assert_eq!(Dyadic::new(IBig::from(-52), -152).to_string(), "-13*2^-150");
    assert_eq!(Dyadic::new(IBig::ZERO, 99), Dyadic::new(IBig::ZERO, 0));
    assert_eq!(Dyadic::from_f64(f64::NAN), None);
    assert_eq!(Dyadic::from_f64(f64::NEG_INFINITY), None);
    let rational = |text| Rat::parse(text).expect("a rational");
    assert_eq!(Dyadic::from_rational(&rational("-13/64")).map(|d| d.to_string()), Some("-13*2^-6".into()));
    assert_eq!(Dyadic::from_rational(&rational("40")).map(|d| d.to_string()), Some("5*2^3".into()));
    assert_eq!(Dyadic::from_rational(&rational("0")).map(|d| d.to_string()), Some("0".into()));
    assert_eq!(Dyadic::from_rational(&rational("1/3")), None);
    assert_eq!(Dyadic::from_rational(&rational("1/6")), None);
}

#[test]
fn decompose_stays_in_range_for_all_bits() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -f64::NAN] {
        let (mantissa, exponent) = decompose(x);
        assert!(mantissa.unsigned_abs() < 1 << 53 && (-1074..=1023).contains(&exponent));
    }
}

proptest! {
    #[test]
    fn decompose_is_exact(bits in any::<u64>()) {
        let x = f64::from_bits(bits);
        prop_assume!(x.is_finite());
        let (mantissa, exponent) = decompose(x);
        prop_assert!(mantissa % 2 != 0 || (mantissa, exponent) == (0, 0));
        prop_assert!(mantissa.unsigned_abs() < 1 << 53 && (-1074..=1023).contains(&exponent));
        // Two exact float products: a mantissa times two powers of two, each in range.
        let half = exponent / 2;
        let rebuilt = mantissa as f64 * 2.0_f64.powi(half) * 2.0_f64.powi(exponent - half);
        prop_assert!(rebuilt.to_bits() == x.to_bits() || (x.to_bits() << 1 == 0 && rebuilt.to_bits() == 0));
    }

    #[test]
    fn scaling_is_exact(bits in prop::array::uniform6(any::<u64>())) {
        let values = bits.map(f64::from_bits);
        prop_assume!(values.iter().all(|x| x.is_finite()));
        let points = [[values[0], values[1], values[2]], [values[3], values[4], values[5]]];
        let (scaled, exponent) = scale_points(&points);
        let (flat, same) = common_scale(values);
        prop_assert_eq!(exponent, same);
        prop_assert_eq!(scaled.as_flattened(), &flat[..]);
        let unit = Rat::from_scaled(1, exponent);
        for (integer, x) in flat.iter().zip(values) {
            prop_assert_eq!(Rat::from(integer.clone()).times(&unit), Rat::from_f64(x).expect("finite"));
        }
        // The largest such exponent: some integer is odd (or all are zero).
        prop_assert!(flat.iter().any(|i| i.trailing_zeros() == Some(0)) || flat.iter().all(|i| *i == IBig::ZERO));
    }
}

#[test]
fn scaling_of_nothing_and_of_zeros() {
    assert_eq!(scale_points(&[]), (vec![], 0));
    assert_eq!(scale_points(&[[0.0, -0.0, 0.0]]), (vec![[IBig::ZERO, IBig::ZERO, IBig::ZERO]], 0));
}
