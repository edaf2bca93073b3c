//! A scripted program as subject, in both modes.

use std::time::Duration;

use crate::certify::Silent;
use crate::fuzz::{
    Answer, Class, Generator, Limit, Mode, Options, Predicate, Process, ProcessOptions, Report, Subject,
    SubjectError, run,
};

fn has_python() -> bool {
    let done =
        std::process::Command::new("python3").arg("--version").output().is_ok_and(|o| o.status.success());
    if !done {
        eprintln!("SKIPPED: python3 is not there, so no program was judged");
    }
    done
}

fn subject(mode: Mode, fault: &str) -> Process {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/src/fuzz/tests/subject.py");
    let word = if mode == Mode::Text { "text" } else { "binary" };
    let options = ProcessOptions { mode, timeout: Duration::from_millis(400), ..ProcessOptions::default() };
    Process::new(&format!("python3 '{script}' {word} {fault}"), options).unwrap()
}

fn uniform(cases: u64) -> Options {
    Options {
        generators: vec![Generator::Uniform],
        limit: Limit::Cases(cases),
        ..Options::new(Predicate::Orient2d)
    }
}

fn judged(mode: Mode, fault: &str, cases: u64) -> Report {
    run(&mut subject(mode, fault), &uniform(cases), &Silent).unwrap()
}

#[test]
fn right_programs_are_clean_in_both_modes() {
    if !has_python() {
        return;
    }
    for mode in [Mode::Text, Mode::Binary] {
        let options = Options { limit: Limit::Cases(3000), ..Options::new(Predicate::Orient2d) };
        let report = run(&mut subject(mode, "none"), &options, &Silent).unwrap();
        assert!(report.is_clean() && report.unsupported == 0, "{}", report.words());
        let partly = judged(mode, "partly", 400);
        assert!(partly.is_clean() && partly.unsupported > 100 && partly.unsupported < 300);
    }
}

#[test]
fn each_fault_has_its_class() {
    if !has_python() {
        return;
    }
    for mode in [Mode::Text, Mode::Binary] {
        for (fault, class) in [("bad", Class::BadAnswer), ("nan", Class::Nan), ("wrong", Class::WrongSign)] {
            let report = judged(mode, fault, 600);
            assert!(report.findings.iter().all(|f| f.class == class), "{}", report.words());
            // Shrunk: the first coordinate is 1 and nothing needless is left. A wrong sign needs a triangle.
            let first = &report.findings[0];
            assert!(first.minimal, "{}", report.words());
            assert!(first.case.starts_with("orient2d 0x1p+0 "), "{}", first.case);
            let zeros = first.case.matches(" 0x0p+0").count();
            assert!(zeros >= if fault == "wrong" { 3 } else { 5 }, "{}", first.case);
        }
    }
}

#[test]
fn crashes_are_found_down_to_the_case() {
    if !has_python() {
        return;
    }
    for mode in [Mode::Text, Mode::Binary] {
        let report = judged(mode, "crash", 60);
        let faulty = uniform(60);
        // The stream of cases is that of the seed: the count of crashes is known.
        let pool = crate::fuzz::Pool::default();
        let cases =
            crate::fuzz::generate::Source::new(Predicate::Orient2d, &faulty.generators, 0, &pool).batch(60);
        let expected = cases.coordinates.iter().step_by(6).filter(|x| **x > 0.75).count() as u64;
        assert!(expected > 2);
        assert_eq!((report.mismatches, report.cases), (expected, 60), "{}", report.words());
        assert!(report.findings.iter().all(|f| f.class == Class::Crash && f.answer == "crash"));
        assert_eq!(report.findings[0].case, "orient2d 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0");
    }
}

#[test]
fn hangs_are_found_down_to_the_case() {
    if !has_python() {
        return;
    }
    for mode in [Mode::Text, Mode::Binary] {
        let arity = Predicate::Orient2d.arity();
        let mut cases = [0.5, 0.0, 1.0, 0.0, 0.0, 1.0].repeat(7);
        cases[4 * arity] = 0.9;
        let answers = subject(mode, "hang").answer(Predicate::Orient2d, &cases).unwrap();
        let classes: Vec<String> = answers.iter().map(ToString::to_string).collect();
        assert_eq!(classes, ["1", "1", "1", "1", "hang", "1", "1"], "{mode:?}");
    }
}

#[test]
fn programs_that_do_not_speak_the_protocol_are_errors() {
    let start = |command: &str| {
        let mut subject = Process::new(command, ProcessOptions::default()).unwrap();
        run(&mut subject, &uniform(10), &Silent)
    };
    assert!(matches!(start("/there/is/no/such-program"), Err(SubjectError::Start { .. })));
    assert!(matches!(Process::new("", ProcessOptions::default()), Err(SubjectError::Command { .. })));
    assert!(matches!(Process::new("a 'b", ProcessOptions::default()), Err(SubjectError::Command { .. })));
    if !has_python() {
        return;
    }
    let mute = run(&mut subject(Mode::Text, "mute"), &uniform(10), &Silent);
    assert!(mute.as_ref().is_err_and(|e| e.to_string().contains("no words")), "{mute:?}");
    let chatty = run(&mut subject(Mode::Text, "chatty"), &uniform(10), &Silent);
    assert!(matches!(chatty, Err(SubjectError::TooMuch { .. })), "{chatty:?}");
    let other = Options { limit: Limit::Cases(10), ..Options::new(Predicate::Insphere) };
    let unsupported = run(&mut subject(Mode::Text, "none"), &other, &Silent);
    assert!(matches!(unsupported, Err(SubjectError::Unsupported { .. })), "{unsupported:?}");
    // A subject that crashes without end is given up.
    let mut weak = ProcessOptions { restarts: 3, ..ProcessOptions::default() };
    weak.timeout = Duration::from_millis(400);
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/src/fuzz/tests/subject.py");
    let mut weak = Process::new(&format!("python3 '{script}' text crash"), weak).unwrap();
    let gave_up = run(&mut weak, &uniform(500), &Silent);
    assert!(matches!(gave_up, Err(SubjectError::GaveUp { times: 4, .. })), "{gave_up:?}");
}

/// No single case breaks it: asked again, each is answered.
#[test]
fn a_program_that_fails_now_and_then_is_not_clean() {
    if !has_python() {
        return;
    }
    for mode in [Mode::Text, Mode::Binary] {
        let report = judged(mode, "tired", 40);
        assert_eq!(report.cases, 40);
        assert!(report.mismatches > 0 && report.mismatches < 20, "{}", report.words());
        let crashes = report.findings.iter().all(|f| f.class == Class::Crash && f.answer == "crash");
        assert!(crashes && report.findings.iter().all(|f| !f.minimal), "{}", report.words());
    }
}

#[test]
fn answers_after_the_last_case_are_noticed() {
    if !has_python() {
        return;
    }
    for mode in [Mode::Text, Mode::Binary] {
        let late = run(&mut subject(mode, "afterthought"), &uniform(10), &Silent);
        assert!(matches!(late, Err(SubjectError::TooMuch { .. })), "{late:?}");
    }
}

/// A line has to arrive whole in time, not a byte.
#[test]
fn a_line_that_drips_is_a_hang() {
    if !has_python() {
        return;
    }
    let case = [0.9, 0.0, 1.0, 0.0, 0.0, 1.0];
    let answers = subject(Mode::Text, "drip").answer(Predicate::Orient2d, &case).unwrap();
    assert_eq!(answers, [Answer::Hang]);
}

/// A fifth of all cases crash: the run ends when the program is given up, and keeps what it has found.
#[test]
fn what_was_found_before_giving_up_is_told() {
    if !has_python() {
        return;
    }
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/src/fuzz/tests/subject.py");
    let options = ProcessOptions { restarts: 60, ..ProcessOptions::default() };
    let mut weak = Process::new(&format!("python3 '{script}' text crash"), options).unwrap();
    let timed = Options { limit: Limit::Time(Duration::from_secs(600)), ..uniform(0) };
    let report = run(&mut weak, &timed, &Silent).unwrap();
    assert!(report.gave_up && report.cases > 60 && report.cases < 2000, "{}", report.words());
    assert!(report.findings.iter().all(|f| f.class == Class::Crash), "{}", report.words());
    assert!(report.words().contains(", given up after too many crashes\n"));
}
