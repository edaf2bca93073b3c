//! Tests of readers, writers, connectivity and validation.

mod cells;
mod facts;
mod hostile;
mod io;
mod roundtrip;
mod topology;

use super::*;
use crate::testing::data;

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
