//! Certificates about meshes: every control of `corpus-meshes` is valid, and every mutant gets the answer that `table.tsv`
//! states by hand from `MESHES.md`; damage never makes the checker panic.

#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests may fail like tests

mod table;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use homeo_certs::{check, check_files};
use table::{Row, names_in};

/// Codes of `MESHES.md` section 4 without a mutant: `usage` is not about contents, `size` needs a file of 1 GiB.
const CODES: [&str; 25] = [
    "bytes",
    "truncated",
    "magic",
    "syntax",
    "digits",
    "range",
    "claims",
    "counts",
    "input",
    "hash",
    "cells",
    "mesh-conditions",
    "not-closed",
    "topology",
    "superfluous",
    "missing-separation",
    "not-separated",
    "ray-component",
    "ray",
    "winding",
    "sign",
    "crossing",
    "twice",
    "wrong-point",
    "not-refuted",
];

fn corpus() -> PathBuf {
    table::corpus("corpus-meshes")
}

fn rows() -> Vec<Row> {
    table::rows(&corpus().join("table.tsv"), &[])
}

fn paths(row: &Row) -> (PathBuf, Vec<PathBuf>) {
    let folder = corpus().join(&row.control);
    (folder.join(row.file()), row.inputs.iter().map(|name| folder.join(name)).collect())
}

#[test]
fn every_certificate_gets_the_answer_of_the_table() {
    let (mut wrong, mut valid, mut controls) = (Vec::new(), BTreeSet::new(), 0);
    for row in rows() {
        let (cert, inputs) = paths(&row);
        let outcome = check_files(&cert, &inputs);
        if let Some(difference) = row.difference(&outcome) {
            wrong.push(difference);
        } else if row.exit == 0 {
            let text = fs::read_to_string(cert).unwrap();
            let stated = text.lines().nth(1).unwrap().strip_prefix("claim ").unwrap().to_owned();
            let [(name, certified)] = &outcome.claims[..] else { panic!("claims of {}", row.place()) };
            assert_eq!(format!("{name} {}", if *certified { "certified" } else { "refuted" }), stated);
            valid.insert(stated);
        } else {
            assert!(outcome.claims.is_empty());
        }
        controls += usize::from(row.mutant == "control");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(controls >= 45, "{controls} controls");
    let claims = ["manifold", "embedded", "same-topology", "nested", "pl-homeomorphism"];
    let both = claims.iter().flat_map(|claim| ["certified", "refuted"].map(|v| format!("{claim} {v}")));
    assert_eq!(valid, both.chain(["nested-topology refuted".to_owned()]).collect());
}

#[test]
fn every_code_has_a_mutant() {
    let found: BTreeSet<String> = rows().into_iter().map(|row| row.code).filter(|code| code != "-").collect();
    assert_eq!(found, CODES.iter().map(|&code| code.to_owned()).collect());
}

#[test]
fn every_kind_of_witness_is_accepted_and_refused() {
    let mut answers: BTreeMap<String, BTreeSet<bool>> = BTreeMap::new();
    for row in rows() {
        let text = String::from_utf8_lossy(&fs::read(paths(&row).0).unwrap()).into_owned();
        let lines: Vec<&str> = text.split("begin witness\n").nth(1).unwrap_or("").lines().collect();
        if let [line, _, "end"] = lines[..] {
            let word = line.split(' ').next().unwrap().to_owned();
            answers.entry(word).or_default().insert(row.exit == 0);
        }
    }
    let words =
        ["cross", "direction", "edge", "facet", "flat", "link", "open", "repeated", "sign", "twice", "twin"];
    for word in words.iter().chain(&["vertex", "winding"]) {
        assert_eq!(answers[*word].len(), 2, "{word}");
    }
}

#[test]
fn every_file_is_in_the_table() {
    let mut listed: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for row in rows() {
        let (file, place) = (row.file(), row.place());
        let names = listed.entry(row.control).or_default();
        assert!(names.insert(file), "{place} stands twice");
        names.extend(row.inputs.into_iter().filter(|name| name != "c.off"));
    }
    for (control, names) in listed {
        assert_eq!(names_in(&corpus().join(&control)), names, "{control}");
    }
}

/// A small generator of numbers, the same in every run.
fn random(state: &mut u64) -> usize {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    usize::try_from(*state >> 33).unwrap()
}

#[test]
fn damage_never_panics() {
    let mut state = 1;
    for row in rows().iter().filter(|row| row.exit == 0) {
        let (cert, inputs) = paths(row);
        let cert = fs::read(cert).unwrap();
        let inputs: Vec<_> = inputs.iter().map(|path| fs::read(path).unwrap()).collect();
        for _ in 0..20 {
            let (mut cert, mut inputs) = (cert.clone(), inputs.clone());
            let many = inputs.len();
            let file =
                if random(&mut state) > 1 << 29 { &mut cert } else { &mut inputs[random(&mut state) % many] };
            for _ in 0..1 + random(&mut state) % 3 {
                let at = random(&mut state) % file.len();
                file[at] = b"0123456789 -/^*abspln:,\n"[random(&mut state) % 24];
            }
            let outcome = check(&cert, &inputs);
            assert!(outcome.exit <= 3 && (outcome.exit == 0) == outcome.code.is_empty());
        }
    }
}
