use super::oracle;
use crate::predicate::{Sign, incircle, incircle_exact, insphere, insphere_exact};
use crate::testing::Random;

const TURNS: usize = 4000;

/// Coordinates of one of several kinds, the same kind for a whole case.
fn coordinate(kind: usize, random: &mut Random) -> f64 {
    match kind {
        0 => f64::from(random.integer(-3, 3)),
        1 => random.real(),
        2 => random.any_finite(),
        3 => f64::from_bits(random.next() & 0xfff),
        4 => f64::from(random.integer(-3, 3)) * 2.0_f64.powi(1020),
        // At the ends of the range in which the filter works.
        5 => f64::from(random.integer(-3, 3)) * 2.0_f64.powi(if random.below(2) == 0 { -100 } else { 100 }),
        // Nearly on a circle: rounded multiples of a few points of one.
        _ => [0.6, -0.6, 0.8, -0.8, 1.0, 0.0][random.below(6)] + f64::from(random.integer(-1, 1)) * 1e-16,
    }
}

#[test]
fn circles_agree_with_the_determinant() {
    let mut random = Random(1);
    let mut seen = std::collections::BTreeMap::new();
    for turn in 0..TURNS {
        let kind = turn % 7;
        let p = [(); 4].map(|()| [(); 2].map(|()| coordinate(kind, &mut random)));
        let expected = oracle::lifted(&p);
        let [a, b, c, d] = &p;
        assert_eq!(incircle(a, b, c, d), expected, "{p:?}");
        assert_eq!(incircle_exact(a, b, c, d), expected, "{p:?}");
        *seen.entry((kind, expected)).or_insert(0) += 1;
    }
    assert!(
        seen[&(0, Sign::Zero)] > 20 && seen[&(6, Sign::Negative)] > 20 && seen[&(6, Sign::Positive)] > 20
    );
}

#[test]
fn spheres_agree_with_the_determinant() {
    let mut random = Random(2);
    let mut zeros = 0;
    for turn in 0..TURNS {
        let p = [(); 5].map(|()| [(); 3].map(|()| coordinate(turn % 7, &mut random)));
        let expected = -oracle::lifted(&p);
        let [a, b, c, d, e] = &p;
        assert_eq!(insphere(a, b, c, d, e), expected, "{p:?}");
        assert_eq!(insphere_exact(a, b, c, d, e), expected, "{p:?}");
        zeros += usize::from(expected.is_zero());
    }
    assert!(zeros > 30, "{zeros}");
}

#[test]
fn inside_and_outside_of_the_unit_simplices() {
    let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    assert_eq!(insphere(&o, &x, &y, &z, &[0.25; 3]), Sign::Positive);
    assert_eq!(insphere(&x, &o, &y, &z, &[0.25; 3]), Sign::Negative);
    assert_eq!(insphere(&o, &x, &y, &z, &[1.0; 3]), Sign::Zero);
    assert_eq!(insphere(&o, &x, &y, &z, &[1.0, 1.0, 1.0_f64.next_up()]), Sign::Negative);
    assert_eq!(incircle(&[0.0; 2], &[1.0, 0.0], &[0.0, 1.0], &[0.25; 2]), Sign::Positive);
    assert_eq!(incircle(&[1.0, 0.0], &[0.0; 2], &[0.0, 1.0], &[0.25; 2]), Sign::Negative);
    assert_eq!(incircle(&[0.0; 2], &[1.0, 0.0], &[0.0, 1.0], &[1.0; 2]), Sign::Zero);
    // No panic, whatever comes.
    let _ = insphere(&[f64::NAN; 3], &x, &y, &z, &[f64::INFINITY; 3]);
    let _ = incircle(&[f64::NAN; 2], &[f64::INFINITY; 2], &[f64::NEG_INFINITY; 2], &[0.0; 2]);
}
