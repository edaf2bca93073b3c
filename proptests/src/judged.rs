//! Inputs of the checkers: a case as four OFF files.

use std::fmt::Write;

use crate::recipe::Case;

fn off(vertices: &[[f64; 3]], faces: &[[u32; 3]]) -> Vec<u8> {
    let mut out = format!("OFF\n{} {} 0\n", vertices.len(), faces.len());
    for [x, y, z] in vertices {
        writeln!(out, "{x} {y} {z}").unwrap();
    }
    for [a, b, c] in faces {
        writeln!(out, "3 {a} {b} {c}").unwrap();
    }
    out.into_bytes()
}

/// Bottom, middle, top, mesh. Rust prints doubles so that they are read back exactly.
#[must_use]
pub fn inputs(case: &Case) -> Vec<Vec<u8>> {
    let shell = &case.shell;
    let mut out: Vec<Vec<u8>> =
        [&shell.bottom, &shell.middle, &shell.top].into_iter().map(|p| off(p, &shell.faces)).collect();
    out.push(off(&case.mesh.vertices, &case.mesh.faces));
    out
}
