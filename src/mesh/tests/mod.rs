//! Tests of readers, writers, connectivity and validation.

mod cells;
mod facts;
mod hostile;
mod io;
mod roundtrip;
mod topology;

use super::*;
use std::path::{Path, PathBuf};

/// The directory of test data, if it is there.
fn data() -> Option<PathBuf> {
    let path = std::env::var_os("HOMEO_DATA")
        .map_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data"), PathBuf::from);
    if path.is_dir() {
        return Some(path);
    }
    eprintln!("SKIPPED: no test data at {}", path.display());
    None
}

/// Reads text that must be a mesh.
fn parsed(text: &str, format: Format) -> MeshFile {
    parse(text.as_bytes(), format, "test").expect("must parse")
}

/// The error message of bytes that must not be a mesh; it must be one line.
fn refused(bytes: &[u8], format: Format) -> String {
    let message = parse(bytes, format, "test").expect_err("must be refused").to_string();
    assert!(!message.contains('\n') && message.len() < 300, "{message}");
    message
}

/// Coordinates by bits: `==` would take -0 for +0.
fn bits(mesh: &TriMesh) -> Vec<u64> {
    mesh.vertices.as_flattened().iter().map(|x| x.to_bits()).collect()
}
