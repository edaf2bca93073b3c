//! The certificate text (`certs/MESHES.md` section 3).

use std::fmt::Write as _;

use sha2::{Digest as _, Sha256};

use super::super::claim::Verdict;
use super::super::separate::{PlaneName, PointName};
use super::super::write::{hex, joined};
use super::decide::Side;
use super::witness::Input;
use crate::mesh::Complex;

/// Most witness lines in a file.
pub(in crate::certify) const LINES: usize = 100;

/// One line about an input, with the hash of its complex file.
pub(in crate::certify) fn input(name: Input, complex: &Complex, text: &str) -> String {
    let hash = hex(&Sha256::digest(text.as_bytes()));
    format!(
        "input {name} {hash} {} {} {} {}\n",
        complex.space.dimension(),
        complex.cells.corners(),
        complex.positions.len(),
        complex.cells.len()
    )
}

pub(in crate::certify) fn plane(input: Input, plane: &PlaneName) -> String {
    plane.text(|point| match point {
        PointName::Mesh(v) => format!("{input}{v}"),
        PointName::Shell(name) => name.to_string(),
    })
}

/// The whole file.
pub(in crate::certify) fn certificate(
    claim: &str,
    verdict: Verdict,
    sides: &[(Input, &Complex, &Side)],
) -> String {
    let mut out = format!("homeo-meshes 1\nclaim {claim} {verdict}\n");
    for (name, complex, _) in sides {
        out += &input(*name, complex, &super::complex_file(complex));
    }
    let mut counts = Vec::new();
    if verdict == Verdict::Certified {
        for (name, _, side) in sides {
            let _ = writeln!(out, "begin {name}");
            for (i, j, planes) in &side.separations {
                let _ = writeln!(out, "sep {i} {j} {}", joined(planes.iter().map(|p| plane(*name, p)), " "));
            }
            counts.push(side.separations.len());
        }
    } else {
        out += "begin witness\n";
        let lines = sides.iter().flat_map(|(name, _, side)| side.witnesses.iter().map(|w| w.line(*name)));
        let lines: Vec<String> = lines.take(LINES).collect();
        counts.push(lines.len());
        lines.iter().for_each(|line| out += &format!("{line}\n"));
    }
    let _ = write!(out, "counts {}\nend\n", joined(counts, " "));
    out
}
