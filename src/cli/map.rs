//! `homeo map`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use serde::Serialize;

use super::CliError;
use super::map_input::{self, Pair};
use super::output::{self, Json, one_line};
use super::progress::Progress;
use crate::certify::pl::{self, Facts, Input, Mapped, PlError, PlOutcome};
use crate::certify::{CertifyError, Verdict};
use crate::mesh;

/// Arguments of `homeo map`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A B: two files with the same cells; B may be a text file of rational positions for A's vertices. Or one file: an
    /// OBJ file with texture coordinates, or an OpenVolumeMesh file with exact positions
    #[arg(required = true, num_args = 1..=2, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Positions of A by name: `vertices`, or a string property of an OpenVolumeMesh file
    #[arg(long, value_name = "NAME")]
    a_positions: Option<String>,
    /// Positions of B by name
    #[arg(long, value_name = "NAME")]
    b_positions: Option<String>,
    /// With an OBJ file: cut the surface open where texture coordinates differ at a vertex. In space the cut surface
    /// touches itself along the seams, which refutes the claim; what is found in the plane is reported beside it
    #[arg(long)]
    cut: bool,
    /// For every vertex of surface B a line `TRIANGLE W0 W1 W2`: its place in a triangle of surface A. Decides whether
    /// the map B -> A that is affine on B's triangles is a homeomorphism; there is no certificate for this yet
    #[arg(long, value_name = "FILE", conflicts_with_all = ["output", "write_inputs", "cut", "a_positions", "b_positions"])]
    correspondence: Option<PathBuf>,
    /// Decide C6 for one surface instead: its triangles share only what their common vertices force
    #[arg(long, conflicts_with_all = ["cut", "a_positions", "b_positions", "correspondence"])]
    embedded: bool,
    /// Where the certificate (or the refutation) goes; an existing file is replaced, but only when there is a verdict
    #[arg(short = 'o', long = "output", value_name = "OUT.cert")]
    output: Option<PathBuf>,
    /// Write both inputs as complex files into this directory, a.complex and b.complex, for the checkers
    #[arg(long, value_name = "DIR")]
    write_inputs: Option<PathBuf>,
    /// JSON to a file; `-` for standard output, in place of the words
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// No progress on standard error
    #[arg(short, long)]
    quiet: bool,
}

/// One input in the report.
#[derive(Serialize)]
struct SideReport {
    file: String,
    positions: String,
    vertices: usize,
    cells: usize,
    corners: usize,
    dimension: usize,
    facts: Facts,
    embedded: bool,
    reasons: Vec<Reason>,
}

#[derive(Serialize)]
struct Reason {
    kind: &'static str,
    text: String,
    line: String,
}

#[derive(Serialize)]
struct Report {
    claim: &'static str,
    verdict: &'static str,
    inputs: Vec<SideReport>,
    certificate: Option<String>,
    notes: Vec<String>,
}

/// Reasons listed for an input.
const LISTED: usize = 16;

/// Runs the command: 0 certified, 1 refuted.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let json = Json::of(args.json.clone());
    if let Some(file) = &args.correspondence {
        return by_correspondence(args, file, &json);
    }
    let names_of = [args.a_positions.as_deref(), args.b_positions.as_deref()];
    let pair = if args.embedded {
        map_input::surface(&args.files)?
    } else {
        map_input::read(&args.files, names_of, args.cut)?
    };
    let written = targets(args, &json)?;
    let progress = Progress::new(args.quiet);
    let decided = match pair.complexes.as_slice() {
        [a, b] => pl::pl_homeomorphism(a, b, &progress),
        [a] => pl::embedded(a, &progress),
        _ => Err(PlError::NoCells),
    };
    let outcome = decided.map_err(|e| match e {
        PlError::Certify(CertifyError::Cancelled) => CliError::Interrupted,
        source => CliError::Map { files: names(&args.files), source },
    })?;
    if progress.interrupted() {
        return Err(CliError::Interrupted);
    }
    let files: Vec<Vec<u8>> =
        pair.complexes.iter().map(|complex| pl::complex_file(complex).into_bytes()).collect();
    super::check::accepted(&outcome.certificate, &files)?;
    drop(progress);
    for (path, file) in written.iter().zip(&files) {
        output::replace(path, file)?;
    }
    if let Some(path) = &args.output {
        output::replace(path, outcome.certificate.as_bytes())?;
    }
    let report = report(&outcome, &pair, args);
    json.emit(&report, &words(&report, &written, args))?;
    Ok(ExitCode::from(u8::from(outcome.verdict != Verdict::Certified)))
}

fn names(files: &[PathBuf]) -> String {
    files.iter().map(|f| f.display().to_string()).collect::<Vec<_>>().join(", ")
}

/// The complex files to write; checks all outputs.
fn targets(args: &Args, json: &Json) -> Result<Vec<PathBuf>, CliError> {
    let directory = args.write_inputs.as_deref();
    let inputs: &[&str] = if args.embedded { &["a.complex"] } else { &["a.complex", "b.complex"] };
    let written: Vec<PathBuf> =
        directory.iter().flat_map(|dir| inputs.iter().map(|name| dir.join(name))).collect();
    let mut taken: Vec<&Path> = args.files.iter().map(PathBuf::as_path).collect();
    let outputs = written.iter().map(PathBuf::as_path).chain(args.output.as_deref()).chain(json.file());
    for path in outputs {
        output::may_write(path, &taken)?;
        taken.push(path);
    }
    Ok(written)
}

fn report(outcome: &PlOutcome, pair: &Pair, args: &Args) -> Report {
    let sides = outcome.sides.iter().zip(&pair.complexes).zip([Input::A, Input::B]).enumerate();
    let inputs = sides.map(|(i, ((side, complex), input))| SideReport {
        file: pair.files[i].display().to_string(),
        positions: pair.positions[i].clone(),
        vertices: complex.positions.len(),
        cells: complex.cells.len(),
        corners: complex.cells.corners(),
        dimension: complex.space.dimension(),
        facts: side.facts.clone(),
        embedded: outcome.sound && side.witnesses.is_empty(),
        reasons: side
            .witnesses
            .iter()
            .take(LISTED)
            .map(|w| Reason { kind: w.kind(), text: w.sentence(), line: w.line(input) })
            .collect(),
    });
    Report {
        claim: if args.embedded { "embedded" } else { "pl-homeomorphism" },
        verdict: outcome.verdict.word(),
        inputs: inputs.collect(),
        certificate: args.output.as_ref().map(|p| p.display().to_string()),
        notes: pair.notes.clone(),
    }
}

fn words(report: &Report, written: &[PathBuf], args: &Args) -> String {
    let mut out: String = report.notes.iter().map(|n| format!("note: {}\n", one_line(n))).collect();
    let _ = writeln!(out, "{}: {}", report.claim, report.verdict.to_uppercase());
    for (side, name) in report.inputs.iter().zip(["a", "b"]) {
        let kind = match (side.corners, side.dimension) {
            (4, _) => "tets",
            (_, 2) => "triangles in the plane",
            _ => "triangles in space",
        };
        let _ = writeln!(
            out,
            "  {name}: {} ({}): {} vertices, {} {kind}",
            one_line(&side.file),
            one_line(&side.positions),
            side.vertices,
            side.cells
        );
        if let Some(s) = &side.facts.signs {
            let _ = writeln!(out, "     {} positive, {} zero, {} negative", s.positive, s.zero, s.negative);
        }
        if side.embedded {
            let _ = writeln!(out, "     the positions embed the complex");
        }
        for reason in &side.reasons {
            let _ = writeln!(out, "     NOT: {}", reason.text);
        }
    }
    if report.verdict == Verdict::Certified.word() && report.inputs.len() == 2 {
        out += "  The map from a to b that is affine on every cell is a homeomorphism.\n";
    }
    match (&args.output, written) {
        (None, _) => out += "No certificate was kept; -o OUT.cert keeps it.\n",
        (Some(path), []) => {
            let _ = writeln!(out, "Certificate: {}", one_line(&path.display().to_string()));
            out += "             (--write-inputs DIR writes the complex files that the checkers read)\n";
        }
        (Some(path), files) => {
            let shown = |p: &Path| one_line(&p.display().to_string());
            let inputs: Vec<String> = files.iter().map(|p| shown(p)).collect();
            let _ = writeln!(out, "Certificate: {}", shown(path));
            let _ = writeln!(out, "Check it:    homeo-check {} {}", shown(path), inputs.join(" "));
        }
    }
    out
}

#[derive(Serialize)]
struct Corresponding {
    claim: &'static str,
    verdict: &'static str,
    reason: Option<String>,
}

/// 0 for a homeomorphism, 1 for a map that is none, 2 where the file gives no map.
fn by_correspondence(args: &Args, file: &Path, json: &Json) -> Result<ExitCode, CliError> {
    let [a_file, b_file] = args.files.as_slice() else {
        return Err(CliError::Usage("--correspondence goes with A and B".to_owned()));
    };
    let (a, b) = (mesh::read(a_file)?, mesh::read(b_file)?);
    let places = mesh::read_correspondence(file, a.mesh.faces.len())?;
    if let Some(path) = json.file() {
        output::may_write(path, &[a_file, b_file, file])?;
    }
    let found = pl::map_by_correspondence(&a.mesh, &b.mesh, &places)
        .map_err(|e| CliError::Read { file: file.display().to_string(), reason: e.to_string() })?;
    let reason = match &found {
        Mapped::Homeomorphism => None,
        Mapped::NotAMap(faces) => {
            return Err(CliError::NotAMap {
                file: file.display().to_string(),
                count: faces.len(),
                first: faces.first().copied().unwrap_or_default(),
            });
        }
        Mapped::Flat(f) => Some(format!("the image of B's triangle {f} has no area")),
        Mapped::Fold([f, g]) => {
            Some(format!("the images of B's triangles {f} and {g} are turned against each other"))
        }
        Mapped::Boundary(f) => {
            Some(format!("a boundary edge of B's triangle {f} is not mapped into A's boundary"))
        }
        Mapped::Missed(t) => Some(format!("nothing is mapped into the component of A's triangle {t}")),
        Mapped::Twice([f, g]) => {
            Some(format!("the centre of the image of B's triangle {f} is in the image of triangle {g}, too"))
        }
    };
    // Not "certified" and "refuted": these words are kept for what a checker can be asked about.
    let holds = reason.is_none();
    let verdict = if holds { "homeomorphism" } else { "no homeomorphism" };
    let report = Corresponding { claim: "map-by-correspondence", verdict, reason };
    let mut words = format!("map by correspondence: {verdict}\n");
    words += &match &report.reason {
        None => "  The map from B to A that is affine on B's triangles is a homeomorphism of the surfaces.\n"
            .to_owned(),
        Some(reason) => format!("  NOT: {reason}\n"),
    };
    words += "Decided exactly, but there is no certificate for this yet, so it is not called certified.\n";
    json.emit(&report, &words)?;
    Ok(ExitCode::from(u8::from(!holds)))
}
