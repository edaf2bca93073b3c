//! What the checkers read, a case as four OFF files, and what they say, verdicts.

use std::collections::BTreeMap;
use std::fmt::Write;

use homeo::certify::{Claim, Outcome, Verdict};

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

/// Verdicts by the names of certificate lines; the parts of C6 are claims of their own there.
#[must_use]
pub fn verdicts(outcome: &Outcome) -> BTreeMap<String, bool> {
    let mut out = BTreeMap::new();
    for c in &outcome.claims {
        if c.claim == Claim::Disjoint {
            let parts =
                c.parts.iter().map(|p| (format!("disjoint-{}", p.about), p.verdict == Verdict::Certified));
            out.extend(parts);
        } else {
            out.insert(c.claim.name().to_owned(), c.verdict == Verdict::Certified);
        }
    }
    out
}
