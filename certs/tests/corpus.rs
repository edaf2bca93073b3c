//! Every control of `certs/corpus` is valid with the claims that it states, and every mutant gets the answer that
//! `mutants.tsv` states by hand from `FORMAT.md`.

#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests may fail like tests

mod table;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use homeo_certs::{Outcome, check, check_files};
use table::{Row, names_in};

const INPUTS: [&str; 4] = ["bottom.off", "middle.off", "top.off", "mesh.off"];

/// Codes without a mutant: `usage` is not about a file's contents (tested below), `size` needs a file of 1 GiB.
const NOT_IN_CORPUS: [&str; 2] = ["usage", "size"];

/// All codes of `FORMAT.md` section 3.
const CODES: [&str; 44] = [
    "usage",
    "size",
    "bytes",
    "truncated",
    "magic",
    "syntax",
    "digits",
    "range",
    "duplicate",
    "claims",
    "counts",
    "input",
    "hash",
    "shell-conditions",
    "mesh-conditions",
    "pinched",
    "not-positive",
    "unknown-tet",
    "wrong-value",
    "not-refuted",
    "mesh-carrier",
    "shell-carrier",
    "cap",
    "no-point",
    "outside-carrier",
    "cell-mesh",
    "cell-shell",
    "area-mesh",
    "area-middle",
    "edge-twice",
    "boundary",
    "isolated",
    "degree-component",
    "degree",
    "all-orders-boundary",
    "all-orders",
    "wrong-branches",
    "wrong-step",
    "superfluous",
    "missing-separation",
    "not-separated",
    "wrong-point",
    "overlap",
    "-",
];

fn corpus() -> PathBuf {
    table::corpus("corpus")
}

fn rows() -> Vec<Row> {
    table::rows(&corpus().join("mutants.tsv"), &INPUTS)
}

fn answer(control: &str, cert: &str, inputs: &[String]) -> (Vec<u8>, Outcome) {
    let read = |name: &str| {
        fs::read(corpus().join(control).join(name)).unwrap_or_else(|e| panic!("{control}/{name}: {e}"))
    };
    let cert = read(cert);
    let inputs: Vec<_> = inputs.iter().map(|name| read(name)).collect();
    let outcome = check(&cert, &inputs);
    (cert, outcome)
}

/// The claim lines of a certificate, read here without the checker.
fn stated(cert: &[u8]) -> Vec<(String, bool)> {
    let text = String::from_utf8_lossy(cert);
    let claims = text.lines().filter_map(|line| line.strip_prefix("claim "));
    claims.map(|c| c.split_once(' ').unwrap()).map(|(name, v)| (name.to_owned(), v == "certified")).collect()
}

fn directories() -> BTreeSet<String> {
    let entries = fs::read_dir(corpus()).unwrap().map(|e| e.unwrap());
    let names =
        entries.filter(|e| e.file_type().unwrap().is_dir()).map(|e| e.file_name().into_string().unwrap());
    names.filter(|name| name != "__pycache__").collect()
}

#[test]
fn controls_are_valid_with_their_claims() {
    let names = directories();
    assert!(names.len() >= 26, "{} controls", names.len());
    for control in names {
        let (cert, outcome) = answer(&control, "control.cert", &INPUTS.map(str::to_owned));
        assert_eq!(
            (outcome.exit, outcome.status, outcome.code),
            (0, "valid", ""),
            "{control}: {}",
            outcome.message
        );
        assert_eq!(outcome.claims, stated(&cert), "{control}");
        assert!(!outcome.claims.is_empty(), "{control}");
    }
}

#[test]
fn mutants_get_the_answer_of_the_table() {
    let mut wrong = Vec::new();
    let mut corrupted = 0;
    for row in rows() {
        let (cert, outcome) = answer(&row.control, &row.file(), &row.inputs);
        if let Some(difference) = row.difference(&outcome) {
            wrong.push(difference);
        } else if row.exit == 0 {
            assert_eq!(outcome.claims, stated(&cert), "{}", row.place());
        } else {
            assert!(outcome.claims.is_empty());
            corrupted += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(corrupted >= 60, "{corrupted} mutants");
}

#[test]
fn every_code_has_a_mutant() {
    let found: BTreeSet<String> = rows().into_iter().map(|row| row.code).collect();
    let all: BTreeSet<String> = CODES.iter().map(|&code| code.to_owned()).collect();
    let missing: Vec<_> = all.iter().filter(|code| !found.contains(*code)).map(String::as_str).collect();
    assert_eq!(missing.into_iter().collect::<BTreeSet<_>>(), NOT_IN_CORPUS.into_iter().collect());
    assert!(found.is_subset(&all), "{found:?}");
}

#[test]
fn every_file_is_in_the_table() {
    let mut listed: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for control in directories() {
        let own = INPUTS.iter().chain(&["control.cert"]).map(|&name| name.to_owned());
        listed.insert(control, own.collect());
    }
    for row in rows() {
        let names =
            listed.get_mut(&row.control).unwrap_or_else(|| panic!("{}: no such control", row.control));
        assert!(names.insert(row.file()), "{} stands twice", row.place());
        names.extend(row.inputs);
    }
    for (control, names) in listed {
        assert_eq!(names_in(&corpus().join(&control)), names, "{control}");
    }
}

#[test]
fn usage_is_for_certificates_that_cannot_be_read() {
    let inputs = INPUTS.map(|name| corpus().join("inside").join(name));
    for cert in [corpus().join("inside/no-such.cert"), corpus().join("inside")] {
        let outcome = check_files(&cert, &inputs);
        assert_eq!((outcome.exit, outcome.code), (2, "usage"), "{}", cert.display());
    }
    let cert = corpus().join("inside/control.cert");
    let outcome = check_files(&cert, &[corpus().join("inside")]);
    assert_eq!((outcome.exit, outcome.code), (2, "input"));
    assert_eq!(check_files(&cert, &inputs).exit, 0);
}
