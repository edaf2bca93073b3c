use super::oracle::{self, P};
use crate::predicate::determinant::Integers;
use crate::predicate::{
    Axis, Plane, Sign, Stage, StageCounts, collinear, dot_sign_exact, dot_sign_staged, normal_signs,
    orient2d_exact, orient2d_staged, orient3d, orient3d_exact, orient3d_staged,
};
use crate::testing::Random;

/// Two to the power `e`, subnormals included.
fn power(e: i32) -> f64 {
    if e >= -1022 {
        f64::from_bits(u64::try_from(e + 1023).expect("range") << 52)
    } else {
        f64::from_bits(1 << (e + 1074))
    }
}

/// A pair of stage counts: 3D and 2D.
type Counts = [StageCounts; 2];

/// Compares every predicate on five points with the brute force; records the stages.
fn check(points: &[P; 5], counts: &mut Counts) {
    let [a, b, c, d, e] = points;
    let expected = oracle::orient3d(a, b, c, d);
    assert_eq!(counts[0].note(orient3d_staged(a, b, c, d)), expected, "orient3d {points:?}");
    assert_eq!(orient3d_exact(a, b, c, d), expected, "orient3d_exact {points:?}");
    let plane = Plane::of([a, b, c]);
    assert_eq!(plane.side([a, b, c], d), expected, "side of a plane {points:?}");
    let expected = oracle::dot_sign(a, b, c, d, e);
    assert_eq!(counts[0].note(dot_sign_staged(a, b, c, d, e)), expected, "dot_sign {points:?}");
    assert_eq!(dot_sign_exact(a, b, c, d, e), expected, "dot_sign_exact {points:?}");
    assert_eq!(plane.dot_sign([a, b, c], d, e), expected, "dot with a plane {points:?}");
    for (axis, k) in Axis::ALL.into_iter().zip(0..) {
        let expected = oracle::orient2d(a, b, c, k);
        assert_eq!(counts[1].note(orient2d_staged(a, b, c, axis)), expected, "orient2d {k} {points:?}");
        assert_eq!(orient2d_exact(a, b, c, axis), expected, "orient2d_exact {k} {points:?}");
    }
}

fn run(seed: u64, cases: usize, mut make: impl FnMut(&mut Random) -> [P; 5]) -> Counts {
    let mut random = Random(seed);
    let mut counts = Counts::default();
    for _ in 0..cases {
        check(&make(&mut random), &mut counts);
    }
    counts
}

fn five(random: &mut Random, mut coordinate: impl FnMut(&mut Random) -> f64) -> [P; 5] {
    [(); 5].map(|()| random.point(&mut coordinate))
}

#[test]
fn unit_simplex_is_positive() {
    let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    assert_eq!(orient3d_staged(&o, &x, &y, &z), (Sign::Positive, Stage::Filter));
    assert_eq!(orient3d(&o, &y, &x, &z), Sign::Negative);
    assert_eq!(normal_signs(&o, &x, &y), [Sign::Zero, Sign::Zero, Sign::Positive]);
    assert!(collinear(&o, &x, &[-3.0, 0.0, 0.0]) && !collinear(&o, &x, &y));
}

/// Known fault elsewhere: 0 for the unit simplex times 1e-108, NaN for it times 1e103.
#[test]
fn known_fault_scaled_unit_simplex() {
    let tiny = f64::from_bits(1);
    for s in [1e-108, 1e103, 1e-308, 1e308, f64::MAX, tiny, 1e-107, 1e102, 1e154, 1e-154] {
        let (o, x, y, z) = ([0.0; 3], [s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]);
        assert_eq!(orient3d(&o, &x, &y, &z), Sign::Positive, "{s:e}");
        assert_eq!(orient3d(&o, &x, &z, &y), Sign::Negative, "{s:e}");
        assert_eq!(orient3d(&o, &x, &y, &[s, s, 0.0]), Sign::Zero, "{s:e}");
        // Differences that overflow: the simplex between corners of the cube of edge 2s.
        let (a, b, c, d) = ([-s; 3], [s, -s, -s], [-s, s, -s], [-s, -s, s]);
        assert_eq!(orient3d(&a, &b, &c, &d), Sign::Positive, "{s:e}");
    }
}

/// Known fault elsewhere: + for points near 2^-310 that are exactly coplanar.
#[test]
fn known_fault_coplanar_near_2_to_minus_310() {
    let counts = run(310, 2000, |random| {
        let s = power(-310);
        let mut p = five(random, |r| f64::from(r.integer(-(1 << 20), 1 << 20)) * s);
        // d = a + 2(b-a) - 3(c-a), exactly.
        p[3] = [0, 1, 2].map(|k| 2.0 * p[1][k] - 3.0 * p[2][k] + 2.0 * p[0][k]);
        assert_eq!(orient3d(&p[0], &p[1], &p[2], &p[3]), Sign::Zero);
        p
    });
    assert_eq!(counts[0].big, 0);
}

/// Known fault elsewhere: + for points near 2^-343 that are nearly coplanar.
#[test]
fn known_fault_near_coplanar_near_2_to_minus_343() {
    run(343, 4000, |random| {
        let s = power(-343);
        let mut p = five(random, |r| r.real() * s);
        let (x, y) = (random.real(), random.real());
        p[3] = [0, 1, 2].map(|k| p[0][k] + x * (p[1][k] - p[0][k]) + y * (p[2][k] - p[0][k]));
        p
    });
}

/// Known fault elsewhere: 73 of 2,000 wrong for exponents within +-400, 532 of 2,000 within +-500.
#[test]
fn known_fault_mixed_exponents() {
    for (seed, limit) in [(1, 400), (2, 500), (3, 1020), (4, 100), (5, 30)] {
        let counts = run(seed, 8000, |random| five(random, |r| r.real() * power(r.integer(-limit, limit))));
        // Spans beyond about 317 bits are for the big integers.
        let beyond_filter = if limit <= 100 { counts[0].fixed } else { counts[0].big };
        assert!(counts[0].filter > 0 && beyond_filter > 0, "{counts:?}");
    }
}

/// The constant underflow term is unsound: huge first row, products of tiny ones lost.
#[test]
fn known_fault_lost_products_of_tiny_differences() {
    run(6, 20_000, |random| {
        let (up, down) = (random.integer(300, 1000), random.integer(-560, -500));
        let mut p = [[0.0; 3]; 5];
        for (row, scale) in [(1, up), (2, down), (3, down)] {
            p[row] = random.point(|r| r.real() * power(scale));
        }
        // Nearly parallel tiny rows make the lost products matter.
        if random.below(2) == 0 {
            p[3] = p[2].map(|x| x * 1.5);
            let k = random.below(3);
            p[3][k] = p[3][k].next_up();
        }
        let turn = random.below(3);
        p[1..4].rotate_right(turn);
        p[4] = p[3];
        p[3] = [0.0; 3];
        let tail = p[4];
        p.swap(3, 4);
        p[4] = if random.below(2) == 0 { tail.map(|x| x * 3.0) } else { random.point(Random::any_finite) };
        p
    });
}

#[test]
fn uniform() {
    let counts = run(7, 20_000, |random| five(random, Random::real));
    assert!(counts[0].filter * 100 > counts[0].total() * 95, "{counts:?}");
}

#[test]
fn small_grid_and_exact_zeros() {
    let counts = run(8, 40_000, |random| {
        let (width, s) = (random.integer(1, 4), power(random.integer(-1074, 1000)));
        five(random, |r| f64::from(r.integer(-width, width)) * s)
    });
    assert_eq!(counts[0].big, 0, "one exponent: fixed width must be enough, {counts:?}");
    assert!(counts[0].fixed > 1000);
}

#[test]
fn near_degenerate() {
    run(9, 40_000, |random| {
        let mut p = five(random, Random::real);
        let (x, y) = (random.real(), random.real());
        p[3] = [0, 1, 2].map(|k| p[0][k] + x * (p[1][k] - p[0][k]) + y * (p[2][k] - p[0][k]));
        if random.below(2) == 0 {
            p[2] = [0, 1, 2].map(|k| p[0][k] + x * (p[1][k] - p[0][k]));
        }
        p[4] = p[3];
        let k = random.below(3);
        p[4][k] = if random.below(2) == 0 { p[4][k].next_up() } else { p[4][k].next_down() };
        p
    });
}

#[test]
fn coplanar_by_construction() {
    run(10, 30_000, |random| {
        let scale = power(random.integer(-900, 900));
        let mut p = five(random, |r| f64::from(r.integer(-(1 << 24), 1 << 24)) * scale);
        let (x, y) = (f64::from(random.integer(-9, 9)), f64::from(random.integer(-9, 9)));
        p[3] = [0, 1, 2].map(|k| (1.0 - x - y) * p[0][k] + x * p[1][k] + y * p[2][k]);
        assert_eq!(orient3d(&p[0], &p[1], &p[2], &p[3]), Sign::Zero);
        p[4] = [0, 1, 2].map(|k| p[3][k] + p[1][k] - p[0][k]);
        p
    });
}

#[test]
fn any_finite_bits() {
    run(11, 20_000, |random| five(random, Random::any_finite));
}

#[test]
fn extreme_values() {
    let pool = [
        0.0,
        -0.0,
        f64::MAX,
        f64::MAX.next_down(),
        f64::MIN,
        f64::from_bits(1),
        -f64::from_bits(1),
        f64::from_bits(3),
        f64::MIN_POSITIVE,
        f64::MIN_POSITIVE.next_down(),
        1e308,
        -1e308,
        1e-308,
        1.0,
        1.0_f64.next_up(),
        -1.0,
        1e154,
        1e-154,
        1e-162,
        1e-200,
        1e200,
    ];
    let counts = run(12, 40_000, |random| five(random, |r| pool[r.below(pool.len())]));
    assert!(counts[0].filter > 100 && counts[1].fixed > 100 && counts[0].big > 100, "{counts:?}");
}

#[test]
fn permutations_change_the_sign_by_parity() {
    let mut random = Random(13);
    for round in 0..2000 {
        let mut p = five(&mut random, |r| match round % 3 {
            0 => r.real(),
            1 => f64::from(r.integer(-2, 2)),
            _ => r.any_finite(),
        });
        let sign = orient3d(&p[0], &p[1], &p[2], &p[3]);
        let mut parity = Sign::Positive;
        for _ in 0..12 {
            let (i, j) = (random.below(4), random.below(4));
            if i != j {
                parity = -parity;
                p.swap(i, j);
            }
            assert_eq!(orient3d(&p[0], &p[1], &p[2], &p[3]), sign * parity);
        }
    }
}

/// Whatever the bits, there is an answer.
#[test]
fn not_finite_does_not_panic() {
    let pool = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, 1.0, f64::MAX];
    let mut random = Random(14);
    for _ in 0..2000 {
        let [a, b, c, d, e] = five(&mut random, |r| pool[r.below(pool.len())]);
        orient3d_exact(&a, &b, &c, &d);
        dot_sign_staged(&a, &b, &c, &d, &e);
        normal_signs(&a, &b, &c);
    }
}

/// Integers of exactly the widths at which the stages change over, with the largest differences.
#[test]
fn widths_at_the_limits_of_the_stages() {
    for (bits, stage) in [
        (60, Stage::Fixed),
        (61, Stage::Fixed),
        (62, Stage::Fixed),
        (63, Stage::Fixed),
        (64, Stage::Fixed),
        (124, Stage::Fixed),
        (125, Stage::Fixed),
        (126, Stage::Fixed),
        (127, Stage::Fixed),
        (128, Stage::Fixed),
        (316, Stage::Fixed),
        (317, Stage::Fixed),
        (318, Stage::Big),
        (319, Stage::Big),
    ] {
        let large = 9_007_199_254_740_991.0 * power(bits - 53);
        let mut undecided = StageCounts::default();
        let counts = run(900 + u64::from(bits.unsigned_abs()), 3000, |random| {
            let pool = [large, -large, large, -large, large.next_down(), -large.next_down(), 1.0, -1.0];
            let mut p = five(random, |r| pool[r.below(8)]);
            // The least place of every axis is 1 and the largest value is there.
            p[0] = [1.0, -1.0, 1.0];
            p[1] = [large, -large, large];
            let [a, b, c, d, _] = &p;
            undecided.note(orient3d_staged(a, b, c, d));
            p
        });
        assert!(undecided.filter < undecided.total(), "{bits}");
        let (wide, narrow) = (counts[0].big, counts[0].fixed);
        // Zero rows and columns are fixed whatever the width.
        assert!(if stage == Stage::Big { wide > 0 } else { wide == 0 && narrow > 0 }, "{bits} {counts:?}");
        // The determinants themselves, however the filter decides.
        let mut random = Random(u64::from(bits.unsigned_abs()));
        for _ in 0..3000 {
            let pool = [large, -large, 1.0, -1.0];
            let p = five(&mut random, |r| pool[r.below(4)]);
            assert_eq!(unfiltered(&p), oracle::orient3d(&p[0], &p[1], &p[2], &p[3]), "{bits} {p:?}");
        }
    }
}

/// [`orient3d`] without its filter.
fn unfiltered(p: &[P; 5]) -> Sign {
    let axis = |k: usize| [p[0][k], p[1][k], p[2][k], p[3][k]];
    Integers::new([0, 1, 2].map(axis)).sign([(0, 1), (0, 2), (0, 3)]).0
}
