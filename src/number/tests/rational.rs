//! One suite, run on every backend that is compiled in.

use std::cmp::Ordering;

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use crate::number::{ParseRationalError, Rational};
use crate::predicate::Sign;

fn rational<R: Rational>(text: &str) -> R {
    R::parse(text).expect("a rational")
}

fn float<R: Rational>(x: f64) -> R {
    R::from_f64(x).expect("finite")
}

fn runner(cases: u32) -> TestRunner {
    TestRunner::new_with_rng(
        Config { cases: super::cases(cases), failure_persistence: None, ..Config::default() },
        proptest::test_runner::TestRng::deterministic_rng(proptest::test_runner::RngAlgorithm::ChaCha),
    )
}

fn finite() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite())
}

/// Values with small and with large terms, zeros among them.
fn fractions() -> impl Strategy<Value = String> {
    let small = (-9_i64..=9, 1_u64..=9).prop_map(|(n, d)| format!("{n}/{d}"));
    let large = ("-?[0-9]{1,90}", "[1-9][0-9]{0,90}").prop_map(|(n, d)| format!("{n}/{d}"));
    prop_oneof![small, large]
}

fn known_values<R: Rational>() {
    assert_eq!(R::zero().to_text(), "0");
    assert_eq!(R::one().to_text(), "1");
    assert_eq!(rational::<R>("-6/4").to_text(), "-3/2");
    assert_eq!(rational::<R>("-6/4").numerator(), "-3");
    assert_eq!(rational::<R>("-6/4").denominator(), "2");
    assert_eq!(rational::<R>("-0/7"), R::zero());
    assert_eq!(rational::<R>("0/7").denominator(), "1");
    assert_eq!(rational::<R>("007/0014").to_text(), "1/2");
    assert_eq!(float::<R>(-0.75).to_text(), "-3/4");
    assert_eq!(float::<R>(0.1).to_text(), "3602879701896397/36028797018963968");
    assert_eq!(float::<R>(1e22).to_text(), "10000000000000000000000");
    assert_eq!(float::<R>(-0.0), R::zero());
    assert_eq!(R::from_i64(i64::MIN).to_text(), "-9223372036854775808");
    assert_eq!(R::from_scaled(12, -3).to_text(), "3/2");
    assert_eq!(R::from_scaled(-3, 70).to_text(), "-3541774862152233910272");
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(R::from_f64(x), None);
    }
    assert_eq!(R::one().over(&R::zero()), None);
    assert_eq!(rational::<R>("1/3").plus(&rational("1/6")).to_text(), "1/2");
    assert_eq!(rational::<R>("1/3").minus(&rational("5/6")).to_text(), "-1/2");
    assert_eq!(rational::<R>("-2/3").times(&rational("9/4")).to_text(), "-3/2");
    assert_eq!(rational::<R>("-2/3").over(&rational("-4/9")).map(|q| q.to_text()), Some("3/2".into()));
    assert_eq!(rational::<R>("-2/3").absolute().to_text(), "2/3");
    assert_eq!(rational::<R>("1/3").cmp(&rational("333333333/1000000000")), Ordering::Greater);
    assert_eq!([-5, 0, 7].map(|n| R::from_i64(n).sign()), [Sign::Negative, Sign::Zero, Sign::Positive]);
    assert_eq!(rational::<R>("-1/3").to_f64().to_bits(), (-1.0_f64 / 3.0).to_bits());
}

fn refused_texts<R: Rational>() {
    for (text, position) in [
        ("", 0),
        ("-", 1),
        ("+1", 0),
        ("1_0", 1),
        (" 1", 0),
        ("1 ", 1),
        ("1/", 2),
        ("/2", 0),
        ("1/-2", 2),
        ("1/2/3", 3),
        ("1.5", 1),
        ("1e5", 1),
        ("0x10", 1),
        ("--1", 1),
        ("1/+2", 2),
        ("\u{661}", 0),
        ("12\u{661}", 2),
        ("inf", 0),
    ] {
        assert_eq!(R::parse(text), Err(ParseRationalError::Syntax { position }), "{text:?}");
    }
    for text in ["1/0", "0/0", "-5/000"] {
        assert_eq!(R::parse(text), Err(ParseRationalError::ZeroDenominator), "{text:?}");
    }
}

fn field_axioms<R: Rational>() {
    let three = (fractions(), fractions(), fractions());
    let result = runner(400).run(&three, |(x, y, z)| {
        let [x, y, z]: [R; 3] = [&x, &y, &z].map(|text| rational(text));
        let (zero, one) = (R::zero(), R::one());
        prop_assert_eq!(x.plus(&y), y.plus(&x));
        prop_assert_eq!(x.times(&y), y.times(&x));
        prop_assert_eq!(x.plus(&y).plus(&z), x.plus(&y.plus(&z)));
        prop_assert_eq!(x.times(&y).times(&z), x.times(&y.times(&z)));
        prop_assert_eq!(x.times(&y.plus(&z)), x.times(&y).plus(&x.times(&z)));
        prop_assert_eq!(x.plus(&zero), x.clone());
        prop_assert_eq!(x.times(&one), x.clone());
        prop_assert_eq!(x.plus(&x.negated()), zero.clone());
        prop_assert_eq!(x.minus(&y), x.plus(&y.negated()));
        prop_assert_eq!(x.minus(&y).sign(), Sign::from(x.cmp(&y)));
        prop_assert_eq!(x.times(&y).sign(), x.sign() * y.sign());
        match x.over(&y) {
            Some(quotient) => prop_assert_eq!(quotient.times(&y), x.clone()),
            None => prop_assert!(y.is_zero()),
        }
        prop_assert_eq!(&rational::<R>(&x.to_text()), &x);
        if x < y {
            prop_assert!(x.plus(&z) < y.plus(&z));
        }
        Ok(())
    });
    result.expect("field axioms");
}

/// Every finite float comes back, bit for bit but for the sign of zero; decomposition agrees with float
/// arithmetic where that is exact.
fn float_round_trip<R: Rational>() {
    let check = |x: f64| {
        let exact = float::<R>(x);
        let back = exact.to_f64();
        prop_assert!(back.to_bits() == x.to_bits() || (back.to_bits() == 0 && x.to_bits() << 1 == 0));
        prop_assert_eq!(exact.sign(), Sign::of_difference(x, 0.0));
        let half = x / 2.0;
        if half.is_normal() {
            prop_assert_eq!(float::<R>(half).plus(&float(half)), exact);
        }
        Ok(())
    };
    runner(3000).run(&finite(), check).expect("round trip");
    let tiny = f64::from_bits(1);
    let edge = [0.0, -0.0, tiny, f64::MIN_POSITIVE, f64::MIN_POSITIVE - tiny, f64::MAX, f64::MIN, 1.0, -tiny];
    for x in edge {
        check(x).expect("round trip");
    }
    let order = (finite(), finite());
    let result = runner(1000).run(&order, |(x, y)| {
        prop_assert_eq!(Some(float::<R>(x).cmp(&float(y))), x.partial_cmp(&y));
        Ok(())
    });
    result.expect("order");
}

/// Rounding straight from the definition: no neighbour is nearer, and a tie goes to the even one.
fn rounds_to_nearest<R: Rational>(x: &R) {
    let result = x.to_f64();
    let limit = float::<R>(f64::MAX).plus(&R::from_scaled(1, 970));
    if x.absolute() >= limit {
        assert!(result.is_infinite() && (result > 0.0) == x.sign().is_positive());
        return;
    }
    assert!(result.is_finite(), "{}", x.to_text());
    let distance = |y: &R| x.minus(y).absolute();
    let near = distance(&float(result));
    for neighbour in [result.next_up(), result.next_down()] {
        // Beyond the largest float the grid goes on for the purpose of rounding.
        let other = R::from_f64(neighbour)
            .unwrap_or_else(|| R::from_scaled(if neighbour > 0.0 { 1 } else { -1 }, 1024));
        match near.cmp(&distance(&other)) {
            Ordering::Less => {}
            Ordering::Equal => assert_eq!(result.to_bits() & 1, 0, "tie {}", x.to_text()),
            Ordering::Greater => panic!("{} is nearer than {result:?} to {}", other.to_text(), x.to_text()),
        }
    }
}

fn correct_rounding<R: Rational>() {
    let result = runner(2000).run(&(fractions(), -1200_i32..1200), |(x, e)| {
        rounds_to_nearest(&rational::<R>(&x).times(&R::from_scaled(1, e)));
        Ok(())
    });
    result.expect("rounding");
    let result = runner(1500).run(&finite(), |x| {
        let Some(next) = R::from_f64(x.next_up()) else { return Ok(()) };
        let middle = float::<R>(x).plus(&next).times(&R::from_scaled(1, -1));
        rounds_to_nearest(&middle);
        let nudge = R::from_scaled(1, -3000);
        prop_assert_eq!(float::<R>(middle.plus(&nudge).to_f64()), next);
        prop_assert_eq!(float::<R>(middle.minus(&nudge).to_f64()), float::<R>(x));
        Ok(())
    });
    result.expect("ties");
    for place in
        [-1076, -1075, -1074, -1073, -1023, -1022, -1021, 969, 970, 971, 1022, 1023, 1024, 1030, 5000]
    {
        for factor in 1..=9 {
            for extra in [-1_i64, 0, 1] {
                let x = R::from_scaled(factor, place).plus(&R::from_scaled(extra, place - 80));
                rounds_to_nearest(&x);
                rounds_to_nearest(&x.negated());
                rounds_to_nearest(&float::<R>(f64::MAX).plus(&x));
                rounds_to_nearest(&float::<R>(f64::MIN_POSITIVE).minus(&x));
            }
        }
    }
    assert_eq!(R::from_scaled(-1, -1075).to_f64().to_bits(), (-0.0_f64).to_bits());
    assert_eq!(R::from_scaled(-1, -9000).to_f64().to_bits(), (-0.0_f64).to_bits());
}

macro_rules! suite {
    ($name:ident, $backend:ty) => {
        mod $name {
            use super::super::super::Rational;

            type R = $backend;

            #[test]
            fn known_values() {
                assert_eq!(R::BACKEND.replace('-', "_"), stringify!($name));
                super::known_values::<R>();
            }

            #[test]
            fn refused_texts() {
                super::refused_texts::<R>();
            }

            #[test]
            fn field_axioms() {
                super::field_axioms::<R>();
            }

            #[test]
            fn float_round_trip() {
                super::float_round_trip::<R>();
            }

            #[test]
            fn correct_rounding() {
                super::correct_rounding::<R>();
            }

            #[test]
            fn agrees_with_the_default() {
                super::agree::<R, crate::number::Rat>();
            }
        }
    };
}

/// A chain of operations gives the same texts and floats on two backends.
fn agree<A: Rational, B: Rational>() {
    fn chain<R: Rational>(texts: &[String]) -> (String, u64) {
        let mut value = R::one();
        for (k, text) in texts.iter().enumerate() {
            let x = rational::<R>(text);
            value = match k % 4 {
                0 => value.plus(&x),
                1 => value.times(&x),
                2 => value.over(&x).unwrap_or_else(R::one),
                _ => value.minus(&x),
            };
        }
        (value.to_text(), value.to_f64().to_bits())
    }
    let result = runner(300).run(&prop::collection::vec(fractions(), 1..12), |texts| {
        prop_assert_eq!(chain::<A>(&texts), chain::<B>(&texts));
        Ok(())
    });
    result.expect("agreement");
}

super::backends!(suite);
