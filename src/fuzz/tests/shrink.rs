use crate::fuzz::finding::Failure;
use crate::fuzz::generate::Origin;
use crate::fuzz::shrink::{cost, shrink};
use crate::fuzz::{Answer, Class, Generator, Predicate, Symmetry, from_fn, judge};
use crate::predicate::Sign;

fn failure(class: Class, case: Vec<f64>, symmetry: Option<Symmetry>) -> Failure {
    Failure {
        class,
        origin: Origin { generator: Generator::Uniform, base: Generator::Uniform },
        case,
        answer: Answer::Crash,
        expected: Sign::Zero,
        symmetry,
    }
}

/// A bug with one simplest case: the first coordinate at least 3, the fifth negative.
#[test]
fn a_planted_bug_shrinks_to_its_simplest_case() {
    let bug = |x: &[f64]| x[0] >= 3.0 && x[4] < 0.0;
    let mut subject = from_fn("planted", |_, x| if bug(x) { Answer::Crash } else { Answer::Unsupported });
    let case = vec![57.322, -0.1, 1e-3, 2.0_f64.powi(-20), -71.034, 19.0];
    let failure = failure(Class::Crash, case, None);
    let shrunk = shrink(&mut subject, Predicate::Orient2d, &failure, 10_000, &|| false).unwrap();
    assert!(shrunk.minimal);
    assert_eq!(shrunk.case, [4.0, 0.0, 0.0, 0.0, -1.0, 0.0]);
    // No case of single bits and few exponents is simpler.
    let simple: Vec<f64> =
        (-3..=6).flat_map(|e| [2.0_f64.powi(e), -(2.0_f64.powi(e)), 3.0 * 2.0_f64.powi(e)]).collect();
    for x in &simple {
        for y in &simple {
            let other = [*x, 0.0, 0.0, 0.0, *y, 0.0];
            assert!(!bug(&other) || cost(&other) >= cost(&shrunk.case), "{other:?}");
        }
    }
    // With no tries left the case stays, and is not called minimal.
    let stopped = shrink(&mut subject, Predicate::Orient2d, &failure, 10_000, &|| true).unwrap();
    assert!(!stopped.minimal && stopped.case == failure.case);
}

/// What is shrunk still fails in the same class: here near-coplanar points that doubles call coplanar.
#[test]
fn the_class_is_kept() {
    let orient = |x: &[f64]| {
        let v = |i: usize, k: usize| x[3 * i + k] - x[k];
        v(1, 0) * (v(2, 1) * v(3, 2) - v(2, 2) * v(3, 1))
            + v(1, 1) * (v(2, 2) * v(3, 0) - v(2, 0) * v(3, 2))
            + v(1, 2) * (v(2, 0) * v(3, 1) - v(2, 1) * v(3, 0))
    };
    let mut subject = from_fn("doubles", |_, x| Answer::of_value(orient(x)));
    let tiny = 1.7 * 2.0_f64.powi(-400);
    let case: Vec<f64> =
        [0.3, 0.2, 0.1, 1.3, 0.7, 0.2, 0.4, 1.1, 0.6, 0.9, 0.8, 1.7].map(|x| x * tiny).to_vec();
    assert_eq!(
        Class::of(&Answer::of_value(orient(&case)), judge(Predicate::Orient3d, &case).unwrap()),
        Some(Class::FalseZero)
    );
    let failure = failure(Class::FalseZero, case.clone(), None);
    let shrunk = shrink(&mut subject, Predicate::Orient3d, &failure, 20_000, &|| false).unwrap();
    let answer = Answer::of_value(orient(&shrunk.case));
    assert_eq!(Class::of(&answer, judge(Predicate::Orient3d, &shrunk.case).unwrap()), Some(Class::FalseZero));
    // Nothing is left but what spans a tet: three coordinates of one bit each.
    assert_eq!(shrunk.case.iter().filter(|x| **x != 0.0).count(), 3, "{:?}", shrunk.case);
    assert!(shrunk.minimal && cost(&shrunk.case) < cost(&case));
}

/// A subject that says 1 for every order of the points contradicts itself; the truth is not asked for.
#[test]
fn contradictions_shrink_as_pairs() {
    let mut subject = from_fn("one", |_, _| Answer::Sign(Sign::Positive));
    let order = Symmetry { order: vec![1, 0, 2], negates: true };
    let failure = failure(Class::Inconsistent, vec![0.3, 0.7, -0.2, 0.9, 0.5, 1.1], Some(order));
    let shrunk = shrink(&mut subject, Predicate::Orient2d, &failure, 10_000, &|| false).unwrap();
    // The largest exponent stays in its band, so one coordinate of one bit is left.
    assert_eq!(shrunk.case.iter().filter(|x| **x != 0.0).count(), 1, "{:?}", shrunk.case);
}
