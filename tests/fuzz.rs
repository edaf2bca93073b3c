//! `homeo fuzz` as a user runs it, with the example subjects of `reference/subjects`.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers outside of #[test] functions

mod command;

use std::process::Command;

use command::{code, homeo, path, schema, stderr, stdout, validate};
use serde_json::Value;

fn subjects(name: &str) -> String {
    format!("{}/reference/subjects/{name}", env!("CARGO_MANIFEST_DIR"))
}

/// Does the program answer? Says so loudly if not.
fn have(program: &str, arguments: &[&str]) -> bool {
    let done = Command::new(program).args(arguments).output().is_ok_and(|o| o.status.success());
    if !done {
        eprintln!("SKIPPED: {program} {} does not run here", arguments.join(" "));
    }
    done
}

#[test]
fn known_faults_are_told_with_a_corpus_that_replays() {
    let t = tempfile::tempdir().unwrap();
    let out = path(t.path(), "findings");
    // Options before the predicate, too.
    let done =
        homeo(&["fuzz", "--subject", "geometry-predicates", "orient3d", "--cases", "60000", "-o", &out]);
    let text = stdout(&done);
    assert_eq!(code(&done), 1, "{}", stderr(&done));
    assert!(text.contains("nan             uniform") && text.contains("2^34"), "{text}");
    assert_eq!(std::fs::read_to_string(path(t.path(), "findings/table.txt")).unwrap(), text);
    let report: Value =
        serde_json::from_slice(&std::fs::read(path(t.path(), "findings/report.json")).unwrap()).unwrap();
    validate(&report, &schema("fuzz"), "fuzz").unwrap();

    let corpus = path(t.path(), "findings/corpus.txt");
    let replayed =
        homeo(&["fuzz", "orient3d", "--subject", "geometry-predicates", "--replay", &corpus, "--json"]);
    let again: Value = serde_json::from_slice(&replayed.stdout).unwrap();
    validate(&again, &schema("fuzz"), "fuzz").unwrap();
    assert_eq!((code(&replayed), &again["cases"]), (1, &again["cases"]));
    assert!(again["cases"].as_u64() >= Some(report["findings"].as_array().unwrap().len() as u64));
    let ours = homeo(&["fuzz", "orient3d", "--subject", "fast", "--replay", &corpus]);
    assert_eq!(code(&ours), 0, "{}", stdout(&ours));
    let other = homeo(&["fuzz", "insphere", "--subject", "fast", "--replay", &corpus]);
    assert_eq!((code(&other), stderr(&other).lines().count()), (2, 1));
}

#[test]
fn a_seed_gives_one_report_byte_for_byte() {
    let run = |seed: &str| {
        let done =
            homeo(&["fuzz", "incircle", "--subject", "f64", "--cases", "5000", "--seed", seed, "--json"]);
        assert_eq!(code(&done), 1);
        done.stdout
    };
    assert_eq!(run("3"), run("3"));
    assert_ne!(run("3"), run("4"));
}

#[test]
fn wrong_usage_is_one_line_and_code_2() {
    for arguments in [
        &["fuzz", "orient3d", "--subject", "no-such-subject-here"][..],
        &["fuzz", "orient3d", "--subject", "fast", "--binary"],
        &["fuzz", "orient3d", "--subject", "fast", "--generators", "real"],
        &["fuzz", "orient3d", "--subject", "fast", "--seconds=-1"],
        &["fuzz", "orient3d", "--subject", "fast", "--cases", "0", "--quiet"],
        &["fuzz", "ray_triangle", "--subject", "robust", "--cases", "10"],
        &["fuzz", "orient3d", "--subject", "fast", "--replay", "/there/is/no/file"],
        &["fuzz", "orient3d", "--subject", "fast", "--mesh", "/there/is/no/file"],
    ] {
        let done = homeo(arguments);
        assert_eq!((code(&done), stderr(&done).lines().count()), (2, 1), "{arguments:?}: {}", stderr(&done));
    }
    assert_eq!(code(&homeo(&["fuzz", "orient4d", "--subject", "fast"])), 2);
    let misspelt = homeo(&["fuzz", "orient3d", "--subject", "robst"]);
    assert!(stderr(&misspelt).contains("geometry-predicates"), "{}", stderr(&misspelt));
}

/// The commands of README's section "Test your own predicates".
#[test]
fn the_adapter_in_c_is_judged() {
    if !have("cc", &["--version"]) {
        return;
    }
    let t = tempfile::tempdir().unwrap();
    let program = path(t.path(), "plain");
    let built = Command::new("cc").args(["-O2", "-o", &program, &subjects("plain.c")]).status().unwrap();
    assert!(built.success());
    let done = homeo(&["fuzz", "orient3d", "--subject", &program, "--cases", "20000"]);
    assert_eq!(code(&done), 1, "{}", stderr(&done));
    assert!(stdout(&done).contains("of any size"), "{}", stdout(&done));
    let near = homeo(&[
        "fuzz",
        "orient3d",
        "--subject",
        &program,
        "--cases",
        "2000",
        "--generators",
        "uniform,grid",
    ]);
    assert_eq!(code(&near), 0, "{}", stdout(&near));
    // The other convention is wrong wherever there is a sign.
    let flipped = homeo(&[
        "fuzz",
        "orient3d",
        "--subject",
        &program,
        "--flip",
        "--cases",
        "500",
        "--generators",
        "uniform",
    ]);
    assert!(stdout(&flipped).contains("500 wrong answers"), "{}", stdout(&flipped));
    let other = homeo(&["fuzz", "orient2d", "--subject", &program, "--cases", "10"]);
    assert_eq!(code(&other), 2);
}

#[test]
fn fractions_agree_with_the_judge() {
    if !have("python3", &["--version"]) {
        return;
    }
    for predicate in
        ["orient2d", "orient3d", "incircle", "insphere", "dot_sign", "prism_positivity", "section_dot"]
    {
        for binary in [false, true] {
            let mut subject = format!("python3 -B '{}'", subjects("exact.py"));
            let mut arguments = vec!["fuzz", predicate, "--cases", "500", "--subject"];
            if binary {
                subject += " --binary";
                arguments.insert(2, "--binary");
            }
            arguments.push(&subject);
            let done = homeo(&arguments);
            assert_eq!(code(&done), 0, "{predicate}: {}{}", stdout(&done), stderr(&done));
        }
    }
}

#[test]
fn numpy_is_judged_where_it_is() {
    if !have("python3", &["-c", "import numpy"]) {
        return;
    }
    let subject = format!("python3 -B '{}' --binary", subjects("numpy_det.py"));
    let done = homeo(&["fuzz", "orient3d", "--binary", "--cases", "10000", "--subject", &subject]);
    assert_eq!(code(&done), 1, "{}", stderr(&done));
}
