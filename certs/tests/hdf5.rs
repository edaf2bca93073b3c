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

/// A file whose root group has these names, each from a place of the heap on, and no objects.
fn with_names(places: &[u64], heap: &[u8]) -> Vec<u8> {
    let mut file = vec![0; 512];
    let mut put = |at: usize, bytes: &[u8]| file[at..at + bytes.len()].copy_from_slice(bytes);
    let (header, tree, local_heap, symbols, names) = (96u64, 136u64, 184u64, 216u64, 480u64);
    put(0, b"\x89HDF\r\n\x1a\n");
    put(13, &[8, 8]);
    put(64, &header.to_le_bytes());
    put(96, &[1, 0, 1, 0, 1, 0, 0, 0, 24]);
    put(112, &[0x11, 0, 16]);
    put(120, &tree.to_le_bytes());
    put(128, &local_heap.to_le_bytes());
    put(136, b"TREE\0\0\x01");
    put(168, &symbols.to_le_bytes());
    put(184, b"HEAP");
    put(192, &(heap.len() as u64).to_le_bytes());
    put(208, &names.to_le_bytes());
    put(216, b"SNOD\x01\0");
    put(222, &[places.len() as u8]);
    for (i, place) in places.iter().enumerate() {
        put(224 + 40 * i, &place.to_le_bytes());
    }
    put(480, heap);
    file
}

#[test]
fn names_do_not_overlap() {
    let text = unbound();
    let says = |places: &[u64], heap: &[u8], what: &str| {
        let got = check(text.as_bytes(), &[with_names(places, heap)]);
        assert!(got.code == "input" && got.message.contains(what), "{places:?}: {}", got.message);
    };
    says(&[0], b"abcd\0", "dataset mbase: missing");
    says(&[0, 3], b"ab\0cd\0", "dataset mbase: missing");
    says(&[0, 1], b"ab\0cd\0", "dataset mbase: missing"); // no longer than the heap
    says(&[0, 1, 2], b"abcd\0", "no end of its own");
    says(&[0, 1], b"abcd\0", "no end of its own");
    says(&[0, 0], b"ab\0cd\0", "a name is used twice");
    says(&[3], b"ab\0cd", "no end of its own");
    says(&[9], b"ab\0cd", "outside the heap");
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
