//! `homeo mesh-info` for tet meshes.

use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;

use serde::Serialize;

use super::CliError;
use super::output::{Json, one_line};
use crate::certify::Silent;
use crate::certify::pl::{self, Facts, Input, Least};
use crate::mesh::{ComplexFile, Format};

#[derive(Serialize)]
struct Report {
    file: String,
    format: Format,
    /// Sound, of one sign, and with an embedded boundary that is covered once.
    valid: bool,
    tets: TetInfo,
    /// The first reasons against it, as lines of `certs/MESHES.md`.
    defects: Vec<String>,
    notes: Vec<String>,
}

#[derive(Serialize)]
struct TetInfo {
    vertices: usize,
    tets: usize,
    boundary_euler_characteristic: i64,
    #[serde(flatten)]
    facts: Facts,
    least_determinant: Option<Least>,
    /// Names of exact positions in the file.
    exact_positions: Vec<String>,
}

/// Defects shown.
const LISTED: usize = 16;

/// Reports: 0 for an embedded mesh, 1 for one that is not.
pub(super) fn run(path: &Path, file: ComplexFile, json: &Json) -> Result<ExitCode, CliError> {
    let named = |source| CliError::Map { files: path.display().to_string(), source };
    let side = pl::side_facts(&file.complex, &Silent).map_err(named)?;
    let report = Report {
        file: path.display().to_string(),
        format: file.format,
        valid: side.witnesses.is_empty(),
        tets: TetInfo {
            vertices: file.complex.positions.len(),
            tets: file.complex.cells.len(),
            boundary_euler_characteristic: pl::boundary_euler(&file.complex).map_err(named)?,
            facts: side.facts,
            least_determinant: pl::least_determinant(&file.complex),
            exact_positions: file.exact.into_iter().map(|(name, _)| name).collect(),
        },
        defects: side.witnesses.iter().take(LISTED).map(|w| w.line(Input::A)).collect(),
        notes: file.notes,
    };
    let reasons: Vec<String> = side.witnesses.iter().take(LISTED).map(pl::Witness::sentence).collect();
    json.emit(&report, &words(&report, &reasons))?;
    Ok(ExitCode::from(u8::from(!report.valid)))
}

fn words(report: &Report, reasons: &[String]) -> String {
    let (info, facts) = (&report.tets, &report.tets.facts);
    let mut out = format!("{}\n", one_line(&report.file));
    let mut row = |what: &str, value: String| {
        let _ = writeln!(out, "  {what:22} {value}");
    };
    row("format", report.format.to_string());
    row("vertices", info.vertices.to_string());
    row("tets", info.tets.to_string());
    row("components", facts.components.to_string());
    if let Some(s) = &facts.signs {
        row("determinants", format!("{} positive, {} zero, {} negative", s.positive, s.zero, s.negative));
    }
    if let Some(least) = &info.least_determinant {
        row("least determinant", format!("{} (tet {}, exactly {})", least.near, least.cell, least.exact));
    }
    row("boundary triangles", facts.boundary_facets.to_string());
    row("boundary components", facts.boundary_components.to_string());
    row("boundary Euler char.", info.boundary_euler_characteristic.to_string());
    let looked = facts.pairs.map_or_else(
        || "not looked at, as the tets are faulty".to_owned(),
        |pairs| format!("{} (of {pairs} pairs)", facts.crossings),
    );
    row("boundary crossings", looked);
    for name in &info.exact_positions {
        row("exact positions", one_line(name));
    }
    for note in &report.notes {
        row("note", one_line(note));
    }
    for reason in reasons {
        let _ = writeln!(out, "      {reason}");
    }
    let _ = writeln!(out, "  {}", if report.valid { "embedded" } else { "NOT embedded" });
    out
}
