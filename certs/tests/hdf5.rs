//! Real shell files: all are read, and damage of their structure never panics.
#![allow(clippy::expect_used)]
mod common;
use common::{one_prism, sha};
use homeo_certs::check;
use std::path::PathBuf;

fn shells() -> Vec<(PathBuf, Vec<u8>)> {
    let root = std::env::var_os("HOMEO_DATA")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/data"), PathBuf::from);
    let Ok(folder) = std::fs::read_dir(root.join("thirdparty/shells")) else {
        eprintln!("SKIPPED: no shell files under {}", root.display());
        return Vec::new();
    };
    let paths = folder.map(|entry| entry.expect("an entry").path());
    let shell = |path: &PathBuf| path.extension().is_some_and(|e| e == "h5" || e == "init");
    paths.filter(shell).map(|path| (path.clone(), std::fs::read(&path).expect("a file"))).collect()
}

/// A certificate whose shell hash is that of no file.
fn unbound() -> String {
    let case = one_prism();
    case.text()
        .replace(&sha(&[&case.layers[0], &case.layers[1], &case.layers[2]], &case.prisms), &"0".repeat(64))
}

#[test]
fn all_are_read() {
    for (path, bytes) in shells() {
        let got = check(unbound().as_bytes(), &[bytes]);
        assert_eq!(got.code, "hash", "{}: {}", path.display(), got.message);
    }
}

#[test]
fn damage_never_panics() {
    let Some((_, bytes)) = shells().into_iter().min_by_key(|s| s.1.len()) else { return };
    let text = unbound();
    let mut refused = 0;
    for i in 0..bytes.len().min(6000) {
        for byte in [0, 1, 0x10, 0x7f, 0xff] {
            let mut other = bytes.clone();
            other[i] = byte;
            let code = check(text.as_bytes(), &[other]).code;
            assert!(code == "hash" || code == "input", "byte {i}");
            refused += usize::from(code == "input");
        }
    }
    assert!(refused > 100);
    for cut in 0..200 {
        let got = check(text.as_bytes(), &[bytes[..bytes.len() * cut / 200].to_vec()]);
        // What nobody reads may be at the end.
        assert!(got.code == "input" || (got.code == "hash" && cut > 100), "cut at {cut} of 200");
    }
}
