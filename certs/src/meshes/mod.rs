//! Certificates about meshes without a shell: the format, the rules and the error codes are in `MESHES.md`.
//!
//! Their *trusted core* is `points`, `cells`, `pairs`, `rays`, `claims` and `witness`, with what they use of the other
//! one: `number`, `boxes`, and small parts of `complex`. `parse` and `read` are the readers.

mod cells;
mod claims;
mod pairs;
mod parse;
mod points;
mod rays;
mod read;
mod witness;

use crate::Res;
use crate::input::Files;
use claims::Input;
use points::Points;

/// The first line of a certificate that is judged here.
pub(crate) const MAGIC: &[u8] = b"homeo-meshes 1\n";

/// Checks a certificate; the claim and whether it is certified.
pub(crate) fn run(bytes: &[u8], files: &Files<'_>) -> Res<Vec<(&'static str, bool)>> {
    let cert = parse::parse(bytes)?;
    let read = read::read(files, cert.inputs.len())?;
    for (name, (stated, found)) in ["a", "b"].iter().zip(cert.inputs.iter().zip(&read)) {
        let numbers = (found.space, found.cells.k, found.cells.vertices, found.cells.len());
        let same =
            numbers == (stated.space, stated.k, stated.vertices, stated.cells) && found.sha == stated.sha;
        ensure!(same, "hash", "of {name}");
    }
    if let ("pl-homeomorphism", [a, b]) = (cert.claim, &read[..]) {
        ensure!(a.cells.corners == b.cells.corners, "cells", "of a and b differ");
    }
    let (mut inputs, mut groups) = (Vec::new(), Vec::new());
    let mut base = 0;
    for complex in read {
        let full = complex.cells.k == complex.space + 1;
        inputs.push(Input { base, full, cells: complex.cells });
        base += complex.points.len();
        groups.push(complex.points);
    }
    if cert.claim == "nested" {
        groups = vec![groups.concat()]; // which are compared with each other
    }
    claims::check(&cert, &inputs, &Points::new(groups))?;
    Ok(vec![(cert.claim, cert.certified)])
}
