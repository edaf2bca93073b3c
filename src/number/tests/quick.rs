//! The arithmetic by quickcheck, on every backend that is compiled in: the laws of a field; every result against a fraction
//! of `num-bigint` that is never reduced, and against the processor's own rounding; every backend against the default.

// quickcheck wants values.
#![allow(clippy::needless_pass_by_value)]

use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher};

use num_bigint::{BigInt, BigUint};
use quickcheck::{Arbitrary, Gen, QuickCheck, Testable};

use crate::number::Rational;
use crate::predicate::Sign;
use crate::predicate::tests::oracle::integer;

fn check(property: impl Testable) {
    let count = u64::from(super::cases(400));
    // Without `max_tests` quickcheck ends after 10000 cases, and says nothing.
    let mut runner = QuickCheck::new().rng(Gen::new(9)).tests(count).max_tests(count).min_tests_passed(count);
    runner.quickcheck(property);
}

/// A fraction as a text has it, not in lowest terms: decimal digits in groups of nine.
#[derive(Clone, Debug)]
struct Fraction {
    negative: bool,
    above: Vec<u32>,
    below: Vec<u32>,
}

const GROUP: u32 = 1_000_000_000;

fn groups(mut number: u128) -> Vec<u32> {
    let mut out = Vec::new();
    while number > 0 {
        out.push((number % u128::from(GROUP)) as u32);
        number /= u128::from(GROUP);
    }
    out.reverse();
    out
}

fn digits(groups: &[u32]) -> String {
    groups.iter().map(|group| format!("{group:09}")).collect()
}

impl Fraction {
    fn new(negative: bool, above: Vec<u32>, mut below: Vec<u32>) -> Self {
        if below.iter().all(|group| *group == 0) {
            below.push(1);
        }
        Self { negative, above, below }
    }

    fn signed(&self) -> String {
        format!("{}0{}", if self.negative { "-" } else { "" }, digits(&self.above))
    }

    fn of<R: Rational>(&self) -> R {
        R::parse(&format!("{}/{}", self.signed(), digits(&self.below))).expect("a rational")
    }

    fn pair(&self) -> Pair {
        Pair { above: number(&self.signed()), below: number(&digits(&self.below)) }
    }
}

/// A product of small primes: fractions of two of them have much in common, as have those of sums.
fn smooth(g: &mut Gen) -> u128 {
    (0..u8::arbitrary(g) % 48).fold(1_u128, |product, _| {
        let factor = g.choose(&[2, 2, 3, 5, 7, 11]).copied().unwrap_or(1);
        product.checked_mul(factor).unwrap_or(product)
    })
}

impl Arbitrary for Fraction {
    fn arbitrary(g: &mut Gen) -> Self {
        let small = |g: &mut Gen| groups(u128::from(u8::arbitrary(g) % 10));
        let dyadic = |g: &mut Gen| groups(u128::from(u64::arbitrary(g)) << (u8::arbitrary(g) % 64));
        let long = |g: &mut Gen| Vec::<u32>::arbitrary(g).into_iter().map(|x| x % GROUP).collect();
        let [above, below] = match u8::arbitrary(g) % 4 {
            0 => [small(g), small(g)],
            1 => [groups(smooth(g)), groups(smooth(g))],
            2 => [dyadic(g), groups(1 << (u8::arbitrary(g) % 127))],
            _ => [long(g), long(g)],
        };
        Self::new(bool::arbitrary(g), above, below)
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let parts = (self.negative, self.above.clone(), self.below.clone());
        let own = self.below.clone();
        let smaller = parts.shrink().map(|(negative, above, below)| Self::new(negative, above, below));
        // A denominator that came back as it was would be tried for ever.
        Box::new(smaller.filter(move |f| f.below.len() <= own.len()))
    }
}

/// A finite double.
#[derive(Clone, Copy, Debug)]
struct Finite(f64);

impl Arbitrary for Finite {
    fn arbitrary(g: &mut Gen) -> Self {
        const EXPONENT: u64 = 0x7ff << 52;
        loop {
            let bits = u64::arbitrary(g);
            let bits = match u8::arbitrary(g) % 4 {
                // Of sizes so near to each other that both matter in a sum.
                0 => bits & !EXPONENT | (991 + u64::arbitrary(g) % 64) << 52,
                // Subnormal, or nearly.
                1 => bits & !(0x7fc << 52),
                // Few bits.
                2 => bits & (u64::MAX << (u64::arbitrary(g) % 53)),
                _ => bits,
            };
            if f64::from_bits(bits).is_finite() {
                return Self(f64::from_bits(bits));
            }
        }
    }

    fn shrink(&self) -> Box<dyn Iterator<Item = Self>> {
        let bits = self.0.to_bits();
        let fewer = bits & bits.wrapping_sub(1);
        let smaller = [0.0, self.0.trunc(), f64::from_bits(fewer)];
        Box::new(smaller.into_iter().filter(move |x| x.to_bits() < bits).map(Self))
    }
}

/// The oracle: numerator and positive denominator, whatever they have in common.
struct Pair {
    above: BigInt,
    below: BigInt,
}

fn number(text: &str) -> BigInt {
    text.parse().expect("an integer")
}

impl Pair {
    fn zero_when(&self) -> bool {
        self.above == BigInt::ZERO
    }

    fn then(&self, operation: u8, other: &Self) -> Self {
        let (a, b, c, d) = (&self.above, &self.below, &other.above, &other.below);
        let [above, below] = match operation % 4 {
            0 => [a * d + c * b, b * d],
            1 => [a * d - c * b, b * d],
            2 => [a * c, b * d],
            _ if other.zero_when() => [a.clone(), b.clone()],
            _ => [a * d, b * c],
        };
        if below < BigInt::ZERO { Self { above: -above, below: -below } } else { Self { above, below } }
    }
}

/// The same on a backend; a division by zero leaves the number as it is.
fn then<R: Rational>(value: &R, operation: u8, other: &R) -> R {
    match operation % 4 {
        0 => value.plus(other),
        1 => value.minus(other),
        2 => value.times(other),
        _ => value.over(other).unwrap_or_else(|| value.clone()),
    }
}

fn greatest_common(a: &BigInt, b: &BigInt) -> BigInt {
    let (mut a, mut b) = (a.clone(), b.clone());
    while b != BigInt::ZERO {
        (a, b) = (b.clone(), a % b);
    }
    a
}

/// Everything that a backend says about a number is true of this fraction.
fn is<R: Rational>(value: &R, pair: &Pair, shift: i16) {
    let (above, below) = (number(&value.numerator()), number(&value.denominator()));
    assert!(below > BigInt::ZERO);
    assert_eq!(&above * &pair.below, &pair.above * &below);
    let common = greatest_common(&above, &below);
    assert_eq!(common.magnitude(), &BigUint::from(1_u8), "not in lowest terms");
    assert_eq!(value.bit_lengths(), (above.bits(), below.bits()));
    assert_eq!(value.sign(), Sign::from(above.cmp(&BigInt::ZERO)));
    assert_eq!(value.is_zero(), pair.zero_when());
    let (left, right) =
        (usize::from((-shift).max(0).unsigned_abs()), usize::from(shift.max(0).unsigned_abs()));
    let (whole, part) = (above.magnitude() << left, below.magnitude() << right);
    let expected =
        u64::try_from(&whole / &part).ok().map(|quotient| (quotient, whole % part != BigUint::ZERO));
    assert_eq!(value.quotient(i32::from(shift)), expected);
}

type Program = Vec<(u8, Fraction)>;

fn follows_unreduced_fractions<R: Rational>(program: Program, shift: i16) {
    let start = (R::one(), Pair { above: BigInt::from(1), below: BigInt::from(1) });
    let (value, pair) = program.iter().fold(start, |(value, pair), (operation, operand)| {
        (then(&value, *operation, &operand.of()), pair.then(*operation, &operand.pair()))
    });
    is(&value, &pair, shift % 400);
    is(&value.negated(), &Pair { above: -pair.above, below: pair.below }, 0);
}

fn orders_as_cross_products<R: Rational>(x: Fraction, y: Fraction) {
    let (a, b) = (x.pair(), y.pair());
    let order = (&a.above * &b.below).cmp(&(&b.above * &a.below));
    let (x, y) = (x.of::<R>(), y.of::<R>());
    assert_eq!(x.cmp(&y), order);
    assert_eq!(y.cmp(&x), order.reverse());
    assert_eq!(x == y, order.is_eq());
    assert_eq!(x.absolute() > x, x < R::zero());
}

fn is_a_field<R: Rational>(x: Fraction, y: Fraction, z: Fraction) {
    let [x, y, z]: [R; 3] = [&x, &y, &z].map(Fraction::of);
    let (zero, one) = (R::zero(), R::one());
    let hash = |x: &R| BuildHasherDefault::<DefaultHasher>::default().hash_one(x);
    for (left, right) in [
        (x.plus(&y), y.plus(&x)),
        (x.times(&y), y.times(&x)),
        (x.plus(&y).plus(&z), x.plus(&y.plus(&z))),
        (x.times(&y).times(&z), x.times(&y.times(&z))),
        (x.plus(&y).times(&z), x.times(&z).plus(&y.times(&z))),
        (x.plus(&zero), x.clone()),
        (x.times(&one), x.clone()),
        (x.times(&zero), zero.clone()),
        (x.minus(&x), zero.clone()),
        (x.plus(&y).minus(&y), x.clone()),
        (x.negated().times(&y), x.times(&y).negated()),
        (x.negated().negated(), x.clone()),
    ] {
        assert_eq!(left, right);
        assert_eq!(hash(&left), hash(&right), "equal numbers, different hashes");
    }
    let Some(inverse) = one.over(&y) else { return assert!(y.is_zero()) };
    assert_eq!(inverse.times(&y), one);
    assert_eq!(one.over(&inverse), Some(y.clone()));
    assert_eq!(x.over(&y), Some(x.times(&inverse)));
    assert_eq!(x.times(&y).over(&y), Some(x));
}

fn returns_floats<R: Rational>(x: Finite, mantissa: i64, exponent: i16) {
    let exact = R::from_f64(x.0).expect("finite");
    let unit = BigInt::from(1) << 1074;
    is(&exact, &Pair { above: integer(x.0), below: unit }, 0);
    let back = exact.to_f64();
    assert!(back.to_bits() == x.0.to_bits() || exact.is_zero() && back.to_bits() == 0);
    assert_eq!(R::parse(&exact.to_text()), Ok(exact));
    let exponent = exponent % 2500;
    let power = BigInt::from(1) << exponent.unsigned_abs();
    let scaled = R::from_scaled(mantissa, i32::from(exponent));
    let mantissa = BigInt::from(mantissa);
    let pair = if exponent < 0 {
        Pair { above: mantissa, below: power }
    } else {
        Pair { above: mantissa * power, below: BigInt::from(1) }
    };
    is(&scaled, &pair, 0);
}

/// IEEE 754: the processor's sum, difference, product and quotient are the exact ones, rounded.
fn rounds_as_the_processor<R: Rational>(x: Finite, y: Finite) {
    let [a, b] = [x, y].map(|x| R::from_f64(x.0).expect("finite"));
    let same = |exact: &R, float: f64| {
        // An exact zero has no sign.
        let zero = exact.is_zero() && float.to_bits() << 1 == 0;
        assert!(zero || exact.to_f64().to_bits() == float.to_bits(), "{} is not {float:e}", exact.to_text());
    };
    same(&a.plus(&b), x.0 + y.0);
    same(&a.minus(&b), x.0 - y.0);
    same(&a.times(&b), x.0 * y.0);
    if let Some(quotient) = a.over(&b) {
        same(&quotient, x.0 / y.0);
    }
}

macro_rules! suite {
    ($name:ident, $backend:ty) => {
        mod $name {
            use super::*;

            type R = $backend;

            #[test]
            fn follows_unreduced_fractions() {
                check(super::follows_unreduced_fractions::<R> as fn(_, _));
            }

            #[test]
            fn orders_as_cross_products() {
                check(super::orders_as_cross_products::<R> as fn(_, _));
            }

            #[test]
            fn is_a_field() {
                check(super::is_a_field::<R> as fn(_, _, _));
            }

            #[test]
            fn returns_floats() {
                check(super::returns_floats::<R> as fn(_, _, _));
            }

            #[test]
            fn rounds_as_the_processor() {
                check(super::rounds_as_the_processor::<R> as fn(_, _));
            }
        }
    };
}

super::backends!(suite);

/// A backend and the default give the same results, to the last character and bit.
#[cfg(any(feature = "rug", feature = "malachite", feature = "num-rational"))]
mod equal {
    use std::cmp::Ordering;

    use super::*;
    use crate::number::Rat;

    /// All that can be told after each step.
    type Facts = (Ordering, String, u64, (u64, u64), Option<(u64, bool)>);

    fn steps<R: Rational>(program: &Program, shift: i16) -> Vec<Facts> {
        let mut value = R::one();
        let step = |(operation, operand): &(u8, Fraction)| {
            let operand = operand.of();
            let order = value.cmp(&operand);
            value = then(&value, *operation, &operand);
            let float = value.to_f64().to_bits();
            (order, value.to_text(), float, value.bit_lengths(), value.quotient(i32::from(shift % 400)))
        };
        program.iter().map(step).collect()
    }

    fn to_the_default<R: Rational>(program: Program, shift: i16) {
        assert_eq!(steps::<R>(&program, shift), steps::<Rat>(&program, shift));
    }

    macro_rules! equal {
        ($name:ident, $backend:ty) => {
            #[test]
            fn $name() {
                check(to_the_default::<$backend> as fn(_, _));
            }
        };
    }

    super::super::other_backends!(equal);
}
