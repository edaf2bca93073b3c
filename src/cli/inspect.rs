//! `homeo inspect`.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::ExitCode;

use serde::Serialize;

use super::CliError;
use super::input::{Loaded, ThreeMeshes};
use super::output::{self, Json, one_line};
use crate::mesh::{self, MeshInfo};
use crate::shell::{ShellFacts, validate};

/// Arguments of `homeo inspect`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Shell file (HDF5)
    shell: Option<PathBuf>,
    #[command(flatten)]
    three: ThreeMeshes,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
}

#[derive(Serialize)]
struct Report {
    files: Vec<String>,
    valid: bool,
    /// The first input condition that does not hold.
    defect: Option<String>,
    boundary_sides: Option<usize>,
    unreferenced_vertices: Option<usize>,
    shell: ShellFacts,
    mesh: Option<MeshInfo>,
    notes: Vec<String>,
}

/// Runs the command: 0 for a valid input, 1 for a shell that breaks an input condition.
pub(super) fn run(mut args: Args) -> Result<ExitCode, CliError> {
    let json = match args.three.files() {
        Some(_) => Json::of(args.json.take()),
        None => Json::from_arguments(args.json.take(), &mut args.shell),
    };
    let loaded = Loaded::read(args.shell.as_deref(), &args.three, None)?;
    if let Some(file) = json.file() {
        output::may_write(file, &loaded.inputs())?;
    }
    let condition = validate::validate(loaded.shell());
    let report = Report {
        files: loaded.shell_files.iter().map(|f| f.display().to_string()).collect(),
        valid: condition.is_ok(),
        defect: condition.as_ref().err().map(ToString::to_string),
        boundary_sides: condition.as_ref().ok().map(|r| r.boundary_sides),
        unreferenced_vertices: condition.as_ref().ok().map(|r| r.unreferenced.len()),
        shell: ShellFacts::new(loaded.shell())?,
        mesh: loaded.mesh().map(mesh::mesh_info).transpose()?,
        notes: loaded.file.notes.clone(),
    };
    json.emit(&report, &words(&report, &loaded.shell_name()))?;
    Ok(ExitCode::from(u8::from(!report.valid)))
}

/// The first ids of a list.
fn some_of(ids: &[u32]) -> String {
    let shown: Vec<String> = ids.iter().take(10).map(ToString::to_string).collect();
    let more = if ids.len() > shown.len() { " ..." } else { "" };
    if shown.is_empty() { String::new() } else { format!(" (vertices {}{more})", shown.join(" ")) }
}

pub(super) fn box_words(bounds: Option<[[f64; 3]; 2]>) -> String {
    bounds.map_or_else(|| "none".to_owned(), |[low, high]| format!("{low:?} to {high:?}"))
}

fn range_words(range: Option<[f64; 2]>) -> String {
    range.map_or_else(|| "none".to_owned(), |[least, greatest]| format!("{least:.6e} to {greatest:.6e}"))
}

fn words(report: &Report, name: &str) -> String {
    let s = &report.shell;
    let mut out = format!("{name}\n");
    let mut row = |what: &str, value: String| {
        let _ = writeln!(out, "  {what:22} {value}");
    };
    row("prisms", s.prisms.to_string());
    row("vertices", s.vertices.to_string());
    row("tets in all orders", s.tets.to_string());
    let pillars = s.pillars;
    let kinds = format!("{} straight, {} bent, {} pinched", pillars.straight, pillars.bent, pillars.pinched);
    row("pillars", kinds + &some_of(&s.pinched_vertices));
    if let Some(sides) = report.boundary_sides {
        row("boundary", format!("{sides} sides in {} loops", s.boundary_loops));
    }
    row("components", s.components.to_string());
    row("Euler characteristic", s.euler_characteristic.to_string());
    row("genus", s.genus.map_or_else(|| "undefined".to_owned(), |g| g.to_string()));
    row("bounding box", box_words(s.bounding_box));
    row("bottom thickness", format!("{} (approximate)", range_words(s.approximate_bottom_thickness)));
    row("top thickness", format!("{} (approximate)", range_words(s.approximate_top_thickness)));
    match &report.mesh {
        Some(mesh) => row("stored mesh", format!("{} triangles, {} vertices", mesh.faces, mesh.vertices)),
        None => row("stored mesh", "none".to_owned()),
    }
    match &report.defect {
        None => row("input conditions", "hold".to_owned()),
        Some(defect) => row("input conditions", format!("BROKEN: {defect}")),
    }
    for note in &report.notes {
        row("note", one_line(note));
    }
    out
}
