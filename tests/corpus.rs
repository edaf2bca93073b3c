//! `certs/corpus` holds the certificates of the small shells as golden files: the certifier must write them again, byte
//! for byte, with any number of threads. `HOMEO_BLESS=1 cargo test --test corpus` rewrites them.
// Helpers of tests may panic; clippy knows that only inside `#[test]` functions.
#![allow(clippy::expect_used)]

mod common;

use std::fs;
use std::path::{Path, PathBuf};

use homeo::certify::{Silent, certify};
use homeo::mesh::{Format, TriMesh, encode};
use homeo::shell::three;

fn corpus() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("certs/corpus")
}

/// The files of a case: its inputs and its certificate.
fn files(case: &common::Case) -> Vec<(String, Vec<u8>)> {
    let [bottom, middle, top] = three::to_meshes(&case.shell);
    let off = |m: &TriMesh| encode(m, Format::Off, "corpus").expect("OFF holds every mesh");
    let outcome = certify(&case.shell, Some(&case.mesh), &case.options, &Silent).expect("a verdict");
    vec![
        ("bottom.off".into(), off(&bottom)),
        ("middle.off".into(), off(&middle)),
        ("top.off".into(), off(&top)),
        ("mesh.off".into(), off(&case.mesh)),
        ("control.cert".into(), outcome.certificate.into_bytes()),
    ]
}

#[test]
fn golden_certificates_are_written_again() {
    let bless = std::env::var_os("HOMEO_BLESS").is_some();
    let mut wrong = Vec::new();
    for case in common::cases() {
        let dir = corpus().join(case.name);
        if bless {
            fs::create_dir_all(&dir).unwrap();
        }
        for (name, bytes) in files(&case) {
            let path = dir.join(&name);
            if bless {
                fs::write(&path, &bytes).unwrap();
            } else if fs::read(&path).ok().as_deref() != Some(&bytes[..]) {
                wrong.push(format!("{}/{name} differs from the golden file", case.name));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_number_of_threads_changes_nothing() {
    for case in common::cases() {
        let write = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| files(&case).pop())
        };
        assert_eq!(write(1), write(3), "{}", case.name);
    }
}
