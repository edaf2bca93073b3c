use crate::certify::{Observer, Silent};
use crate::fuzz::bits::magnitude;
use crate::fuzz::{
    Answer, BuiltIn, Class, Flipped, Generator, Limit, Options, Predicate, Report, Subject, SubjectError,
    corpus, from_fn, judge, replay, run,
};
use crate::predicate::Sign;

fn options(predicate: Predicate, cases: u64) -> Options {
    Options { limit: Limit::Cases(cases), ..Options::new(predicate) }
}

fn right(predicate: Predicate, x: &[f64]) -> Answer {
    judge(predicate, x).map_or(Answer::Unsupported, Answer::Sign)
}

/// An onset is the exponent at which a planted bug begins, exactly.
#[test]
fn planted_onsets_are_found_exactly() {
    let mut subject = from_fn("planted", |predicate, x| match magnitude(x) {
        Some(e) if e < -500 => right(predicate, x).flipped(),
        Some(e) if e >= 333 => Answer::Nan,
        _ => right(predicate, x),
    });
    let report = run(&mut subject, &options(Predicate::Orient3d, 60_000), &Silent).unwrap();
    let begin = |class: Class| {
        let rows = report.onsets.iter().filter(|row| row.class == class && row.origin.starts_with("sweep/"));
        rows.map(|row| (row.below, row.above)).collect::<Vec<_>>()
    };
    assert_eq!(begin(Class::Nan), [(None, Some(333)); 3]);
    // Degenerate cases get a sign that can be wrong when they are rounded to subnormal numbers.
    assert_eq!(begin(Class::WrongSign), [(Some(-501), None); 3]);
    let classes: Vec<Class> = report.findings.iter().map(|f| f.class).collect();
    assert!(classes.iter().all(|c| matches!(c, Class::Nan | Class::WrongSign)));
    assert!(report.findings.iter().any(|f| f.minimal));
    assert_eq!(report.cases, 60_000);
    assert_eq!(report.cases, report.origins.iter().map(|o| o.cases).sum::<u64>());
    assert_eq!(report.mismatches, report.findings.iter().map(|f| f.count).sum::<u64>());
}

/// The faults that are known of two crates, with nobody saying where to look.
#[test]
fn known_faults_of_published_predicates_are_found() {
    for mut subject in [BuiltIn::GeometryPredicates, BuiltIn::Robust] {
        let report = run(&mut subject, &options(Predicate::Orient3d, 400_000), &Silent).unwrap();
        let row = |class, origin: &str| {
            report.onsets.iter().find(|row| row.class == class && row.origin == origin).unwrap()
        };
        // Exactly coplanar points below about 2^-310, nearly coplanar ones below about 2^-338, NaN above about 2^341.
        let coplanar = row(Class::FalseNonZero, "sweep/degenerate").below.unwrap();
        let near = row(Class::FalseZero, "sweep/near").below.unwrap();
        let large = row(Class::Nan, "sweep/uniform").above.unwrap();
        assert!((-320..=-305).contains(&coplanar), "{coplanar}");
        assert!((-345..=-335).contains(&near), "{near}");
        assert!((338..=343).contains(&large), "{large}");
        // Exponents mixed by 400 and less.
        let mixed = row(Class::FalseNonZero, "spread");
        assert!(mixed.spread.is_some_and(|spread| spread <= 850), "{mixed:?}");
        // Points of one size near one get right answers.
        assert!(
            report
                .origins
                .iter()
                .filter(|o| ["uniform", "grid", "degenerate"].contains(&&*o.origin))
                .all(|o| o.mismatches == 0)
        );
    }
}

#[test]
fn our_predicates_are_clean() {
    let mut cases = 0;
    for predicate in Predicate::ALL {
        let report = run(&mut BuiltIn::Fast, &options(predicate, 15_000), &Silent).unwrap();
        assert!(report.is_clean(), "{}", report.words());
        assert_eq!(report.unsupported, 0);
        cases += report.cases;
    }
    assert_eq!(cases, 11 * 15_000);
}

/// Conventions: every built-in subject agrees with the judge where nothing is difficult, on both sides.
#[test]
fn plain_cases_are_right_for_all() {
    let plain = |predicate| Options { generators: vec![Generator::Uniform], ..options(predicate, 3000) };
    for mut subject in BuiltIn::ALL {
        for predicate in Predicate::ALL {
            match run(&mut subject, &plain(predicate), &Silent) {
                Ok(report) => {
                    // Doubles err on a case in thousands, and the others never.
                    let allowed = if subject == BuiltIn::F64 { 3 } else { 0 };
                    assert!(report.mismatches <= allowed, "{}", report.words());
                }
                Err(SubjectError::Unsupported { .. }) => {
                    assert!(!matches!(subject, BuiltIn::F64 | BuiltIn::Fast), "{subject} {predicate}");
                    assert!(
                        !matches!(predicate, Predicate::Orient2d | Predicate::Orient3d),
                        "{subject} {predicate}"
                    );
                }
                Err(other) => panic!("{other}"),
            }
        }
    }
    let mut opposite = Flipped(from_fn("opposite", |p, x| right(p, x).flipped()));
    let report = run(&mut opposite, &options(Predicate::Insphere, 2000), &Silent).unwrap();
    assert!(report.is_clean() && report.subject == "opposite, flipped");
}

#[test]
fn one_seed_one_report() {
    let json = |seed| {
        let options = Options { seed, ..options(Predicate::Orient2d, 30_000) };
        serde_json::to_string(&run(&mut BuiltIn::F64, &options, &Silent).unwrap()).unwrap()
    };
    assert_eq!(json(7), json(7));
    assert_ne!(json(7), json(8));
}

/// Contradictions are found by the orders of the points: this judge-free finding names the order.
#[test]
fn an_answer_that_depends_on_the_order_is_inconsistent() {
    // Wrong whenever the last point has the least first coordinate.
    let mut subject = from_fn("order", |p, x| {
        let last = x[x.len() - 3];
        if x.iter().step_by(3).all(|first| *first >= last) {
            Answer::Sign(Sign::Positive)
        } else {
            right(p, x)
        }
    });
    let options = Options { generators: vec![Generator::Permutations], ..options(Predicate::Orient3d, 4000) };
    let report = run(&mut subject, &options, &Silent).unwrap();
    let found: Vec<_> = report.findings.iter().filter(|f| f.class == Class::Inconsistent).collect();
    assert!(!found.is_empty() && found.iter().all(|f| f.order.is_some()));
    let text = corpus::write(&report);
    let entries = corpus::read(&text).unwrap();
    let again = replay(&mut subject, Predicate::Orient3d, &entries).unwrap();
    assert!(again.findings.iter().any(|f| f.class == Class::Inconsistent && f.order.is_some()));
}

fn by_class(report: &Report) -> Vec<(Class, String, String)> {
    let mut out: Vec<_> =
        report.findings.iter().map(|f| (f.class, f.case.clone(), f.answer.clone())).collect();
    out.sort();
    out.dedup();
    out
}

#[test]
fn a_corpus_reproduces_its_findings() {
    let mut subject = BuiltIn::F64;
    let options = Options {
        generators: vec![Generator::Overflow, Generator::Near],
        ..options(Predicate::Orient3d, 20_000)
    };
    let report = run(&mut subject, &options, &Silent).unwrap();
    assert!(report.findings.len() > 3);
    let entries = corpus::read(&corpus::write(&report)).unwrap();
    assert_eq!(entries.len(), report.findings.len());
    let again = replay(&mut subject, Predicate::Orient3d, &entries).unwrap();
    assert_eq!(again.cases, entries.len() as u64);
    assert_eq!(by_class(&again), by_class(&report));
    // Another implementation has another verdict on the same cases.
    assert!(replay(&mut BuiltIn::Fast, Predicate::Orient3d, &entries).unwrap().is_clean());
    assert_eq!(replay(&mut subject, Predicate::Insphere, &entries).unwrap().cases, 0);
}

#[test]
fn panics_are_crashes_and_infinities_have_a_sign() {
    let mut subject = from_fn("panics", |p, x| {
        assert!(x[0] < 0.9, "planted");
        right(p, x)
    });
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(|_| {}));
    let options = Options { generators: vec![Generator::Uniform], ..options(Predicate::Orient2d, 500) };
    let report = run(&mut subject, &options, &Silent).unwrap();
    std::panic::set_hook(hook);
    assert!(report.findings.iter().all(|f| f.class == Class::Crash));
    // The least double that will do has one bit: 1.
    assert_eq!(report.findings[0].case, "orient2d 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
    assert_eq!(Answer::of_value(f64::NEG_INFINITY), Answer::Sign(Sign::Negative));
    assert_eq!(Answer::of_value(f64::NAN), Answer::Nan);
}

#[test]
fn a_subject_that_judges_nothing_is_an_error() {
    let mut subject = from_fn("mute", |_, _| Answer::Unsupported);
    let done = run(&mut subject, &options(Predicate::Orient2d, 100), &Silent);
    assert!(matches!(done, Err(SubjectError::Unsupported { predicate: Predicate::Orient2d, .. })));
    let other = BuiltIn::Robust.answer(Predicate::RayTriangle, &Predicate::RayTriangle.example()).unwrap();
    assert_eq!(other, [Answer::Unsupported]);
}

#[test]
fn an_interruption_keeps_the_findings() {
    struct After(std::sync::atomic::AtomicU64);
    impl Observer for After {
        fn advance(&self, units: u64) {
            self.0.fetch_add(units, std::sync::atomic::Ordering::Relaxed);
        }
        fn cancelled(&self) -> bool {
            self.0.load(std::sync::atomic::Ordering::Relaxed) > 10_000
        }
    }
    let endless = options(Predicate::Orient3d, u64::MAX);
    let report = run(&mut BuiltIn::F64, &endless, &After(0.into())).unwrap();
    assert!(report.cases > 10_000 && report.cases < 30_000 && !report.is_clean());
    assert!(report.findings.iter().all(|f| !f.minimal));
}

/// A subject that drops its last answer.
struct Short;

impl Subject for Short {
    fn name(&self) -> String {
        "short".to_owned()
    }

    fn answer(&mut self, predicate: Predicate, cases: &[f64]) -> Result<Vec<Answer>, SubjectError> {
        let mut answers = BuiltIn::Fast.answer(predicate, cases)?;
        answers.pop();
        Ok(answers)
    }
}

#[test]
fn what_is_not_answered_or_has_no_answer_is_not_clean() {
    let short = run(&mut Short, &options(Predicate::Orient3d, 100), &Silent).unwrap_err();
    assert_eq!(short.to_string(), "short gives 99 answers to 100 cases");
    let origin =
        corpus::read("homeo-fuzz 1\norient2d 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0\n").unwrap()[0].origin;
    // A ray without a direction: a file with it is refused, but entries can be made by hand.
    let entry =
        corpus::Entry { predicate: Predicate::RayTriangle, case: vec![0.0; 15], origin, symmetry: None };
    let none = replay(&mut BuiltIn::Fast, Predicate::RayTriangle, std::slice::from_ref(&entry)).unwrap_err();
    assert!(none.to_string().starts_with("no answer is right for `ray_triangle 0x0p+0 "), "{none}");
    let mut mute = from_fn("mute", |_, _| Answer::Unsupported);
    let plain =
        corpus::Entry { predicate: Predicate::Orient2d, case: vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0], ..entry };
    let unsupported = replay(&mut mute, Predicate::Orient2d, &[plain]).unwrap_err();
    assert_eq!(unsupported.to_string(), "mute does not support orient2d");
}
