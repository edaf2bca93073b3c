// Powers of two are exact.
#![allow(clippy::float_cmp)]

use crate::fuzz::bits::{exponent, power, scaled};
use crate::fuzz::corpus::{self, CorpusError};
use crate::fuzz::generate::{Origin, Source};
use crate::fuzz::random::Random;
use crate::fuzz::symmetry::{self, Symmetry};
use crate::fuzz::{Class, Generator, Options, Pool, Predicate, hex, judge};

fn text(x: f64) -> String {
    let mut out = String::new();
    hex::write(&mut out, x);
    out
}

/// As the C library prints them.
#[test]
fn hexadecimal_doubles_as_c_prints_them() {
    let known = [
        (0.0, "0x0p+0"),
        (-0.0, "-0x0p+0"),
        (1.0, "0x1p+0"),
        (-10.5, "-0x1.5p+3"),
        (0.1, "0x1.999999999999ap-4"),
        (5e-324, "0x0.0000000000001p-1022"),
        (f64::MIN_POSITIVE, "0x1p-1022"),
        (f64::MIN_POSITIVE / 2.0, "0x0.8p-1022"),
        (f64::MAX, "0x1.fffffffffffffp+1023"),
    ];
    for (x, printed) in known {
        assert_eq!(text(x), printed);
        assert_eq!(hex::parse(printed).map(f64::to_bits), Some(x.to_bits()));
    }
    assert_eq!(hex::parse("0x10p-1"), Some(8.0));
    assert_eq!(hex::parse("0.25"), Some(0.25));
    for bad in [
        "",
        "-",
        "0x",
        "0x1",
        "0xp1",
        "0x1p",
        "0x1.g p3",
        "0x1p+1024",
        "0x1p-1075",
        "nan",
        "inf",
        "0x1p99999",
    ] {
        assert_eq!(hex::parse(bad), None, "{bad}");
    }
    // More bits than a double has.
    assert_eq!(hex::parse("0x1.00000000000001p+0"), None);
}

#[test]
fn every_double_comes_back() {
    let mut random = Random(1);
    for _ in 0..20_000 {
        let x = f64::from_bits(random.next());
        if x.is_finite() {
            assert_eq!(hex::parse(&text(x)).map(f64::to_bits), Some(x.to_bits()), "{}", text(x));
        }
    }
}

#[test]
fn powers_of_two() {
    for k in -1074..=1023 {
        assert_eq!(exponent(power(k)), Some(k));
        assert_eq!(scaled(1.0, k), power(k));
        assert_eq!(scaled(power(k), -k), 1.0, "{k}");
        assert_eq!(scaled(power(-1074), k + 1074), power(k));
    }
    assert_eq!((power(-1075), scaled(1.5, 1023), exponent(0.0)), (0.0, 1.5 * power(1023), None));
    assert_eq!((scaled(1.0, 3000), scaled(-4.0, -3000)), (f64::MAX, -0.0));
    // Rounded once: 2^-1073 + 2^-1074 is kept, what is below is rounded to even.
    assert_eq!(scaled(7.0, -1075), 4.0 * power(-1074));
}

#[test]
fn origins_and_orders_come_back() {
    let origin = Origin { generator: Generator::Sweep, base: Generator::Near };
    assert_eq!(origin.to_string().parse(), Ok(origin));
    assert!("sweep/never".parse::<Origin>().is_err());
    let mut random = Random(2);
    for predicate in Predicate::ALL {
        assert_eq!(predicate.name().parse(), Ok(predicate));
        for _ in 0..20 {
            let symmetry = symmetry::random(predicate, &mut random);
            assert_eq!(Symmetry::parse(&symmetry.to_string(), predicate), Some(symmetry));
        }
    }
    for bad in ["0 1", "0 0 1", "0 1 3", "x", "0 1 2 --"] {
        assert_eq!(Symmetry::parse(bad, Predicate::Orient2d), None, "{bad}");
    }
    assert!(Class::ALL.iter().all(|class| !class.name().contains([' ', ';'])));
}

#[test]
fn what_is_no_corpus_is_refused_with_its_line() {
    let good = "homeo-fuzz 1\n\n# words\norient2d 0x0p+0 0 1 0 0 1 ; class nan ; origin sweep/near ; order 1 0 2 -\n";
    let entries = corpus::read(good).unwrap();
    assert_eq!(entries.len(), 1);
    assert_eq!(entries[0].case, [0.0, 0.0, 1.0, 0.0, 0.0, 1.0]);
    assert!(entries[0].symmetry.as_ref().is_some_and(|s| s.negates && s.order == [1, 0, 2]));
    for (bad, line) in [
        ("", 1),
        ("homeo-fuzz 2\n", 1),
        ("homeo-fuzz 1\norient2d 0 0 1\n", 2),
        ("homeo-fuzz 1\n\norient4d 0\n", 3),
        ("homeo-fuzz 1\norient2d 0 0 1 0 0 nan\n", 2),
        ("homeo-fuzz 1\norient2d 0 0 1 0 0 1 ; colour red\n", 2),
        ("homeo-fuzz 1\norient2d 0 0 1 0 0 1 ; order 0 1\n", 2),
        ("homeo-fuzz 1\nray_triangle 0 0 0 0 0 0 0 0 0 1 0 0 0 1 0\n", 2),
    ] {
        assert!(matches!(corpus::read(bad), Err(CorpusError { line: at, .. }) if at == line), "{bad}");
    }
}

/// By the definition: an order is a symmetry exactly when the judge's answers to many cases and their images agree with it.
#[test]
fn symmetries_are_told_from_other_orders() {
    let mut random = Random(5);
    for predicate in Predicate::ALL {
        let pool = Pool::default();
        let options = Options::new(predicate);
        let cases = Source::new(predicate, &options.generators, 1, &pool).batch(400).coordinates;
        let agrees = |symmetry: &Symmetry| {
            cases.chunks_exact(predicate.arity()).all(|case| {
                let image = symmetry.image(case, predicate.dimension());
                match (judge(predicate, case), judge(predicate, &image)) {
                    (Some(one), Some(other)) => !symmetry.contradicts(&one.into(), &other.into()),
                    // The image is not even a case.
                    _ => false,
                }
            })
        };
        let mut counts = [0; 2];
        for round in 0..150 {
            let mut symmetry = symmetry::random(predicate, &mut random);
            for _ in 0..round % 3 {
                let (i, j) = (random.below(predicate.points()), random.below(predicate.points()));
                symmetry.order.swap(i, j);
            }
            symmetry.negates ^= round % 5 == 0;
            assert_eq!(symmetry.is_of(predicate), agrees(&symmetry), "{predicate}: {symmetry}");
            counts[usize::from(symmetry.is_of(predicate))] += 1;
        }
        assert!(counts[0] > 20 && counts[1] > 20, "{predicate}: {counts:?}");
    }
    let unequal = "homeo-fuzz 1\norient2d 0 0 1 0 0 1 ; order 1 0 2\n";
    let refused = corpus::read(unequal).unwrap_err().to_string();
    assert_eq!(refused, "line 2: `1 0 2` is no symmetry of orient2d");
}
