//! `homeo mesh-info`.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use serde::Serialize;

use super::CliError;
use super::inspect::box_words;
use super::output::{self, Json, one_line};
use super::tet_info;
use crate::mesh::{self, Cells, Defect, Format, MeshInfo, Positions, TriMesh};

/// Arguments of `homeo mesh-info`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The mesh (OBJ, OFF, PLY, STL, VTK, MEDIT, Gmsh, GIFTI, OpenVolumeMesh); tet meshes, too
    mesh: Option<PathBuf>,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
}

#[derive(Serialize)]
struct Report {
    file: String,
    format: Format,
    valid: bool,
    info: MeshInfo,
    /// The first few defects of each kind.
    defects: Vec<Defect>,
    notes: Vec<String>,
}

/// Runs the command: 0 for a valid mesh, 1 for one with defects that are not allowed.
pub(super) fn run(mut args: Args) -> Result<ExitCode, CliError> {
    let json = Json::from_arguments(args.json.take(), &mut args.mesh);
    let path = args.mesh.ok_or_else(|| CliError::Usage("no mesh: give a mesh file".to_owned()))?;
    if let Some(file) = json.file() {
        output::may_write(file, &[&path])?;
    }
    let read = mesh::read_complex(&path)?;
    let mesh = match (read.complex.cells, read.complex.positions) {
        (Cells::Triangles(faces), Positions::Float(vertices)) => TriMesh { vertices, faces },
        (cells, positions) => {
            let complex = mesh::Complex { cells, positions, ..read.complex };
            return tet_info::run(&path, mesh::ComplexFile { complex, ..read }, &json);
        }
    };
    let found = mesh::validate(&mesh)?;
    let report = Report {
        file: path.display().to_string(),
        format: read.format,
        valid: found.is_valid(),
        info: found.info,
        defects: found.listed,
        notes: read.notes,
    };
    json.emit(&report, &words(&report))?;
    Ok(ExitCode::from(u8::from(!report.valid)))
}

fn words(report: &Report) -> String {
    let info = &report.info;
    let mut out = format!("{}\n", one_line(&report.file));
    let mut row = |what: &str, value: String| {
        let _ = writeln!(out, "  {what:22} {value}");
    };
    row("format", report.format.to_string());
    row("vertices", info.vertices.to_string());
    row("triangles", info.faces.to_string());
    row("edges", info.edges.to_string());
    row("components", info.components.to_string());
    row("boundary loops", info.boundary_loops.to_string());
    row("Euler characteristic", info.euler_characteristic.to_string());
    row("genus", info.genus.map_or_else(|| "undefined".to_owned(), |g| g.to_string()));
    row("bounding box", box_words(info.bounding_box));
    for note in &report.notes {
        row("note", one_line(note));
    }
    for (kind, count) in &info.defects {
        let allowed = if kind.is_allowed() { " (allowed)" } else { "" };
        let _ = writeln!(out, "  {count} {}{allowed}", kind.name());
        for defect in report.defects.iter().filter(|d| d.kind() == *kind).take(5) {
            let _ = writeln!(out, "      {defect}");
        }
    }
    let _ = writeln!(out, "  {}", if report.valid { "valid input" } else { "NOT a valid input" });
    out
}
