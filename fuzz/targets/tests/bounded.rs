//! Regressions, and a bounded number of random mutations of seeds, on a stable toolchain.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::Path;

use homeo_fuzz_targets::{Random, seeds};

/// One to four random edits: a bit flip, a byte, a removal, a copied run, a cut.
fn mutated(seed: &[u8], random: &mut Random) -> Vec<u8> {
    let mut out = seed.to_vec();
    for _ in 0..=random.next(4) {
        let at = random.next(out.len());
        match random.next(5) {
            _ if out.is_empty() => out.push(0),
            0 => out[at] ^= 1 << random.next(8),
            1 => out[at] = u8::try_from(random.next(256)).unwrap_or(0),
            2 => drop(out.drain(at..(at + 1 + random.next(16)).min(out.len()))),
            3 => {
                let run: Vec<u8> = out[at..(at + 1 + random.next(32)).min(out.len())].to_vec();
                let to = random.next(out.len());
                out.splice(to..to, run);
            }
            _ => out.truncate(at),
        }
    }
    out
}

fn run(name: &str, rounds: usize) {
    let (_, target) = homeo_fuzz_targets::TARGETS.into_iter().find(|(n, _)| *n == name).unwrap();
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../regressions").join(name);
    for entry in fs::read_dir(dir).into_iter().flatten().flatten() {
        target(&fs::read(entry.path()).unwrap());
    }
    let seeds = seeds(name);
    seeds.iter().for_each(|seed| target(seed));
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for round in 0..rounds {
        target(&mutated(&seeds[round % seeds.len()], &mut random));
    }
}

#[test]
fn mesh() {
    run("mesh", 20_000);
}

#[test]
fn complex() {
    run("complex", 20_000);
}

#[test]
fn shell() {
    run("shell", 20_000);
}

#[test]
fn certificate() {
    run("certificate", 5_000);
}

#[test]
fn document() {
    run("document", 5_000);
}

#[test]
fn checkers() {
    run("checkers", 400);
}

#[test]
fn signs() {
    run("signs", 100_000);
}

#[test]
fn verdict() {
    run("verdict", 400);
}

#[test]
fn projection() {
    run("projection", 2_000);
}

/// A seed that is refused at once would test nothing.
#[test]
fn seeds_are_what_the_targets_take() {
    let formats = homeo::mesh::Format::READ_ONLY;
    let is_read =
        |seed: &Vec<u8>| formats.iter().any(|f| homeo::mesh::parse_complex(seed, *f, "seed").is_ok());
    let unread: Vec<usize> =
        seeds("complex").iter().enumerate().filter(|(_, s)| !is_read(s)).map(|(i, _)| i).collect();
    assert!(unread.is_empty(), "{unread:?}");
    assert_eq!(seeds("complex").len(), formats.len());
    let controls = [seeds("certificate").len(), seeds("document").len(), seeds("checkers").len()];
    assert!(
        controls[0] >= 30 && controls[1] >= 45 && controls[2] == controls[0] + controls[1],
        "{controls:?}"
    );
}

#[test]
fn every_target_has_an_entry() {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("../fuzz_targets");
    let mut names: Vec<String> = fs::read_dir(dir)
        .unwrap()
        .map(|e| e.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned())
        .collect();
    names.sort();
    let mut targets = homeo_fuzz_targets::TARGETS.map(|(name, _)| name.to_owned());
    targets.sort();
    assert_eq!(names, targets);
}
