use super::oracle::{self, P};
use crate::predicate::word::{sign2, sign3, words};
use crate::testing::Random;

const TINY: f64 = f64::from_bits(1);

#[test]
fn values_that_fit_a_word() {
    let two = |e: i32| 2f64.powi(e);
    // 2^59 is the largest power that stays below 2^60.
    assert_eq!(words([1.0, -3.0, two(59)]), Some([1, -3, 1 << 59]));
    assert_eq!(words([0.0, -0.0, 0.0]), Some([0; 3]));
    // The smallest scale is that of the largest power of two.
    assert_eq!(words([two(-1000), -3.0 * two(-1000)]), Some([1 << 23, -3 << 23]));
    assert_eq!(words([TINY, 0.0]), None);
    assert_eq!(words([f64::MAX, -f64::MAX]), Some([((1 << 53) - 1) << 7, -((1 << 53) - 1) << 7]));
    // One more bit does not fit.
    assert_eq!(words([1.0, two(60)]), None);
    assert_eq!(
        words([f64::from_bits(two(59).to_bits() + 1), two(59)]).map(|w| w[0]),
        Some((1 << 59) + (1 << 7))
    );
    assert_eq!(words([two(59), 0.5]), None);
    // A value that the scaling takes to zero, or to a subnormal number.
    assert_eq!(words([f64::MAX, TINY]), None);
    assert_eq!(words([two(1000), two(-20), 0.0]), None);
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        assert_eq!(words([1.0, bad]), None);
        assert_eq!(words([bad, 0.0]), None);
    }
}

/// Points with coordinates up to 60 bits, nearly or exactly in a plane, at any scale.
#[test]
fn signs_in_one_word_are_exact() {
    let mut random = Random(77);
    let mut seen = [0; 3];
    for round in 0..60_000u32 {
        let bits = 1 + round % 60;
        let scale = 2f64.powi([0, -60, 400, -1000][random.below(4)]);
        // A double has 53 bits: wide values have zeros below.
        let number = |random: &mut Random| {
            let value = (random.next() >> (64 - bits)).cast_signed();
            let value = if random.below(2) == 0 { value } else { -value };
            value as f64 * scale
        };
        let mut p: [P; 4] = [(); 4].map(|()| random.point(number));
        if round % 3 > 0 {
            // d = b + c - a where that is exact, or one step beside it.
            p[3] = [0, 1, 2].map(|k| p[1][k] + (p[2][k] - p[0][k]));
            if round % 3 == 2 {
                p[3][random.below(3)] += scale;
            }
        }
        if let Some(sign) = sign3([&p[0], &p[1], &p[2], &p[3]], [(0, 1), (0, 2), (0, 3)]) {
            assert_eq!(sign, oracle::orient3d(&p[0], &p[1], &p[2], &p[3]), "{p:?}");
            seen[usize::from((sign.as_i8() + 1).unsigned_abs())] += 1;
        }
        let plane = [0, 1, 3].map(|i: usize| [p[i][0], p[i][1]]);
        if let Some(sign) = sign2(plane.each_ref(), [(0, 1), (0, 2)]) {
            assert_eq!(sign, oracle::orient2d(&p[0], &p[1], &p[3], 2), "{p:?}");
        }
    }
    assert!(seen.iter().all(|&n| n > 5_000), "{seen:?}");
}

/// `2^e`, subnormal numbers included.
fn power(e: i32) -> f64 {
    if e < -1022 {
        f64::from_bits(1 << (e + 1074))
    } else {
        f64::from_bits(u64::from((e + 1023).unsigned_abs()) << 52)
    }
}

/// Each axis at a scale of its own, from the smallest numbers to the largest; all that rows are made of; both zeros.
#[test]
fn signs_in_one_word_are_exact_at_any_scale_of_an_axis() {
    let mut random = Random(78);
    let (mut fitted, mut zeros) = (0, 0);
    for round in 0..40_000 {
        let bits = random.integer(1, 62);
        let mut p = [[0.0; 3]; 6];
        for axis in 0..3 {
            let lowest = [-1074, 1023 - bits, random.integer(-1074, 1023 - bits)][random.below(3)];
            let whole = |random: &mut Random| {
                let value = (random.next() >> (64 - bits)) as f64;
                if random.below(2) == 0 { value } else { -value }
            };
            // Small combinations of two vectors: often one plane, or one unit beside it.
            let (u, v) = (whole(&mut random), whole(&mut random));
            for q in &mut p {
                let (i, j) = (f64::from(random.integer(-1, 1)), f64::from(random.integer(-1, 1)));
                let value = if round % 2 == 0 { whole(&mut random) } else { i * u + j * v };
                q[axis] = value * power(lowest);
            }
        }
        if !p.iter().flatten().all(|x| x.is_finite()) {
            continue;
        }
        let difference = |i: usize, j: usize| oracle::vector(&p[j], &p[i]);
        let [a, b, c, d, e, f] = p.each_ref();
        let tet = [(0, 1), (0, 2), (0, 3)];
        let dot = [(0, 1), (0, 2), (3, 4)];
        let vectors = [(0, 1), (2, 3), (4, 5)];
        for (rows, found) in [
            (tet, sign3([a, b, c, d], tet)),
            (dot, sign3([a, b, c, d, e], dot)),
            (vectors, sign3([a, b, c, d, e, f], vectors)),
        ] {
            let [x, y, z] = rows.map(|(i, j)| difference(i, j));
            let exact = oracle::sign(&oracle::det(&x, &y, &z));
            assert!(found.is_none_or(|sign| sign == exact), "{found:?} {exact:?} {rows:?} {p:?}");
            fitted += usize::from(found.is_some());
            zeros += usize::from(found.is_some() && exact.is_zero());
        }
    }
    assert!(fitted > 30_000 && zeros > 500, "{fitted} {zeros}");
}

/// Any bit patterns: no answer is wrong, and what is no number has none.
#[test]
fn any_bits_have_the_right_sign_or_none() {
    let mut random = Random(79);
    let mut fitted = 0;
    for round in 0..200_000 {
        let near = random.next();
        let number = |random: &mut Random| match random.below(8) {
            0 => [0.0, -0.0, f64::MAX, f64::MIN, TINY, -TINY, f64::MIN_POSITIVE, 1.0][random.below(8)],
            1 if round % 16 == 0 => f64::from_bits(random.next()),
            // The exponent of one number, and few bits: mostly these fit.
            _ => f64::from_bits(
                (near & 0xfff0_0000_0000_0000) | (random.next() << 44 >> 12) | random.next() << 63,
            ),
        };
        let p: [P; 4] = [(); 4].map(|()| [(); 3].map(|()| number(&mut random)));
        let found = sign3(p.each_ref(), [(0, 1), (0, 2), (0, 3)]);
        if p.iter().flatten().all(|x| x.is_finite()) {
            let exact = oracle::orient3d(&p[0], &p[1], &p[2], &p[3]);
            assert!(found.is_none_or(|sign| sign == exact), "{p:?}");
            fitted += usize::from(found.is_some());
        } else {
            assert_eq!(found, None, "{p:?}");
        }
    }
    assert!(fitted > 20_000, "{fitted}");
}
