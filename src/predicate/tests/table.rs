use super::oracle::P;
use crate::predicate::{
    Sign, Stage, det_sign, det_sign_exact, det_sign_staged, dot_sign, dot_sign_exact, orient3d,
    orient3d_exact, side_of_plane,
};

/// The table says what to expect; every predicate of that form must agree.
#[test]
fn signs_of_the_table() {
    let mut cases = 0;
    for line in include_str!("../testdata/signs.txt").lines().filter(|line| !line.starts_with('#')) {
        let fields: Vec<&str> = line.split(' ').collect();
        let [predicate, _, sign] = fields[..3] else { panic!("{line}") };
        let expected = Sign::from(sign.parse::<i8>().expect("a sign").cmp(&0));
        let numbers: Vec<f64> = fields[3..]
            .iter()
            .map(|bits| f64::from_bits(u64::from_str_radix(bits, 16).expect("hexadecimal")))
            .collect();
        let points: Vec<P> = numbers.chunks(3).map(|p| [p[0], p[1], p[2]]).collect();
        match (predicate, &points[..]) {
            ("orient3d", [a, b, c, d]) => {
                assert_eq!(orient3d(a, b, c, d), expected, "{line}");
                assert_eq!(side_of_plane(a, b, c, d), expected, "{line}");
                assert_eq!(orient3d_exact(a, b, c, d), expected, "{line}");
                assert_eq!(det_sign([a, b], [a, c], [a, d]), expected, "{line}");
                assert_eq!(dot_sign(a, b, c, a, d), expected, "{line}");
                assert_eq!(orient3d(b, a, c, d), -expected, "{line}");
            }
            ("dot_sign", [a, b, c, s, t]) => {
                assert_eq!(dot_sign(a, b, c, s, t), expected, "{line}");
                assert_eq!(dot_sign_exact(a, b, c, s, t), expected, "{line}");
                assert_eq!(det_sign([a, b], [a, c], [s, t]), expected, "{line}");
                assert_eq!(det_sign_exact([s, t], [a, b], [a, c]), expected, "{line}");
                assert_eq!(dot_sign(a, b, c, t, s), -expected, "{line}");
            }
            _ => panic!("{line}"),
        }
        cases += 1;
    }
    assert_eq!(cases, 116, "the table has been changed");
}

#[test]
fn stages_of_plain_cases() {
    let (o, x, y, z) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    assert_eq!(det_sign_staged([&o, &x], [&o, &y], [&o, &z]), (Sign::Positive, Stage::Filter));
    assert_eq!(det_sign_staged([&o, &x], [&o, &y], [&x, &y]), (Sign::Zero, Stage::Fixed));
    let far = [1e300, 1e-300, 0.0];
    assert_eq!(det_sign_staged([&o, &far], [&x, &far], [&o, &[0.0, 1.0, 1.0]]), (Sign::Positive, Stage::Big));
}

#[test]
fn signs_form_the_group_they_should() {
    let all = [Sign::Negative, Sign::Zero, Sign::Positive];
    for a in all {
        assert_eq!((-a).as_i8(), -a.as_i8());
        assert_eq!(
            [a.is_negative(), a.is_zero(), a.is_positive()].map(i8::from),
            [i8::from(a.as_i8() < 0), i8::from(a.as_i8() == 0), i8::from(a.as_i8() > 0)]
        );
        assert_eq!(Sign::from(std::cmp::Ordering::from(a)), a);
        for b in all {
            assert_eq!((a * b).as_i8(), a.as_i8() * b.as_i8());
            assert_eq!(a.is_opposite(b), a.as_i8() * b.as_i8() == -1);
        }
    }
    assert_eq!(Sign::of_difference(-0.0, 0.0), Sign::Zero);
    assert_eq!(Sign::of_difference(f64::MIN, f64::MAX), Sign::Negative);
}

#[test]
fn stage_counts_add_up() {
    use crate::predicate::StageCounts;
    let mut counts = StageCounts::default();
    assert_eq!(counts.note((7, Stage::Filter)), 7);
    counts.record(Stage::Big);
    counts.record(Stage::Big);
    let sum: StageCounts = [counts, counts].into_iter().sum();
    assert_eq!(sum, StageCounts { filter: 2, fixed: 0, big: 4 });
    assert_eq!(sum.total(), 6);
}
