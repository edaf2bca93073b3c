//! The promise that the trusted core stays small enough to be read.
#![allow(clippy::panic)]

use std::path::Path;

/// The files that `lib.rs` calls the trusted core.
const CORE: [&str; 10] =
    ["number", "complex", "world", "tets", "boxes", "shard", "overlay", "orders", "lift", "separate"];

/// Lines that are neither blank, a comment, nor the inclusion of unit tests.
fn code_lines(file: &Path) -> usize {
    let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let code = |line: &&str| !line.is_empty() && !line.starts_with("//");
    let tests = |line: &&str| ["#[cfg(test)]", "mod tests;"].contains(line);
    text.lines().map(str::trim).filter(|line| code(line) && !tests(line)).count()
}

#[test]
fn the_trusted_core_is_small() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let lines = CORE.map(|name| (name, code_lines(&source.join(format!("{name}.rs")))));
    let total: usize = lines.iter().map(|l| l.1).sum();
    assert!(total < 1350, "{total} lines: {lines:?}");
}

/// The core of the certificates about meshes, as `meshes/mod.rs` says.
const MESHES_CORE: [&str; 6] = ["points", "cells", "pairs", "rays", "claims", "witness"];

#[test]
fn the_core_about_meshes_is_small() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/meshes");
    let lines = MESHES_CORE.map(|name| (name, code_lines(&source.join(format!("{name}.rs")))));
    let total: usize = lines.iter().map(|l| l.1).sum();
    assert!(total < 800, "{total} lines: {lines:?}");
    let entries = std::fs::read_dir(&source).unwrap_or_else(|error| panic!("{}: {error}", source.display()));
    for path in entries.filter_map(Result::ok).map(|entry| entry.path()).filter(|path| path.is_file()) {
        let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let other = ["mod", "parse", "read"].contains(&stem.as_str());
        assert!(other || MESHES_CORE.contains(&stem.as_str()), "{} is in no list", path.display());
    }
}

#[test]
fn every_file_is_counted_or_named_as_not_core() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let entries = std::fs::read_dir(&source).unwrap_or_else(|error| panic!("{}: {error}", source.display()));
    for path in entries.filter_map(Result::ok).map(|entry| entry.path()) {
        if path.is_dir() {
            continue; // unit tests
        }
        let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let other = ["lib", "main", "parse", "line", "pages", "input", "hdf5", "compose", "tests"]
            .contains(&stem.as_str());
        assert!(other || CORE.contains(&stem.as_str()), "{} is in no list", path.display());
    }
}
