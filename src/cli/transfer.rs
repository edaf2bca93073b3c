//! `homeo transfer`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use serde::Serialize;
use serde_json::{Value, json};

use super::CliError;
use super::input::{self, Loaded, ThreeMeshes};
use super::output::{self, Json, one_line};
use super::section::{Proof, prove};
use crate::mesh::{self, TriMesh};
use crate::projection::{Projection, SectionError};
use crate::shell::{Shell, VertexOrder};
use crate::transfer::attribute::{self, Attribute, AttributeError, Domain, Sample, Samples, Weights};
use crate::transfer::{
    RoundTrip, Transfer, Worst, exact_round_trips, measured, random_points, round_trip, round_trip_phong,
};

/// Arguments of `homeo transfer`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Shell file (HDF5)
    shell: PathBuf,
    /// The mesh with the attributes, a section of the shell; `stored` is the mesh in the shell file, `middle` the
    /// middle surface
    a: PathBuf,
    /// The mesh that gets them, another section; `stored` and `middle` as for A
    b: PathBuf,
    /// Certificates of `bijection` for A and for B (give it twice); without them both are certified here
    #[arg(long, value_name = "CERT")]
    certificate: Vec<PathBuf>,
    /// Attributes of A: PLY (properties), OBJ (vt), CSV or JSON; may be repeated
    #[arg(long, value_name = "FILE")]
    attributes: Vec<PathBuf>,
    /// Where B's attributes go: .ply (B with properties), .csv, or .json (with the points of A)
    #[arg(short = 'o', long = "output", value_name = "OUT")]
    output: PathBuf,
    /// Exact weights, and interpolation that is rounded once
    #[arg(long)]
    exact: bool,
    /// Carry on without a proof that the map is a bijection
    #[arg(long)]
    unproved: bool,
    /// How many points of A are compared with the exact map (corners of triangles and points inside, by turns)
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(0..=10_000_000))]
    measure: u32,
    /// Round trips of those points by Phong projection, too
    #[arg(long)]
    compare_phong: bool,
    /// Vertex order: `id`, or a file of all vertex ids, smallest first
    #[arg(long, value_name = "id|FILE", default_value = "id")]
    order: String,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
}

#[derive(Serialize)]
struct Report {
    proved: bool,
    proofs: Vec<Value>,
    exact: bool,
    vertices: usize,
    faces: usize,
    attributes: Vec<Value>,
    seconds: f64,
    /// The largest proved bound of the weights that were used; 0 for exact ones.
    error_bound: f64,
    measured: Value,
    /// Points that came back exactly to where they started, of those measured.
    exact_round_trips: usize,
    round_trip: Value,
    #[serde(skip_serializing_if = "Option::is_none")]
    phong: Option<Value>,
    output: String,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let json = Json::of(args.json.clone());
    let format = Output::of(&args.output)?;
    if args.attributes.is_empty() && format != Output::Json {
        return Err(CliError::Usage(
            "no attributes: give --attributes FILE, or -o OUT.json for the points alone".to_owned(),
        ));
    }
    if !matches!(args.certificate.len(), 0 | 2) {
        return Err(CliError::Usage("--certificate: give one for A, then one for B, or none".to_owned()));
    }
    writable(args, &json)?;
    let loaded = Loaded::read(Some(&args.shell), &ThreeMeshes::default(), None)?;
    let meshes = [mesh_of(&args.a, &loaded)?, mesh_of(&args.b, &loaded)?];
    let attributes = read_attributes(args, &meshes[0])?;
    let order = input::order(&args.order, loaded.shell().vertex_count())?;
    let proofs = proofs(args, loaded.shell(), &meshes, &order)?;
    let fail = |reason: String| CliError::Read { file: loaded.shell_name(), reason };
    let projection = Projection::new(loaded.shell(), &order).map_err(|e| fail(e.to_string()))?;
    let [a, b] = &meshes;
    let start = Instant::now();
    let transfer = Transfer::new(&projection, a, b).map_err(|e| fail(e.to_string()))?;
    let samples = Samples::new(&transfer, b, args.exact)?;
    let carried =
        attributes.iter().map(|x| attribute::carry(x, a, &samples)).collect::<Result<Vec<_>, _>>()?;
    let seconds = start.elapsed().as_secs_f64();
    let measures = Measures::new(&transfer, args).map_err(|e| fail(e.to_string()))?;
    output::replace(&args.output, &encode(format, b, &carried, &samples, !proofs.is_empty())?)?;
    let report = Report {
        proved: !proofs.is_empty(),
        proofs: proofs.iter().map(Proof::json).collect(),
        exact: args.exact,
        vertices: b.vertices.len(),
        faces: b.faces.len(),
        attributes: carried.iter().map(summary).collect(),
        seconds,
        error_bound: samples.vertices.iter().chain(&samples.faces).map(|s| s.error).fold(0.0, f64::max),
        measured: measures.json(),
        exact_round_trips: measures.equal,
        round_trip: trip(&measures.ours),
        phong: measures.phong.as_ref().map(trip),
        output: args.output.display().to_string(),
    };
    json.emit(&report, &words(&report, &proofs, &measures))?;
    Ok(ExitCode::SUCCESS)
}

/// One proof a mesh; none where none was asked for.
fn proofs(
    args: &Args,
    shell: &Shell,
    meshes: &[TriMesh; 2],
    order: &VertexOrder,
) -> Result<Vec<Proof>, CliError> {
    if args.unproved {
        return Ok(Vec::new());
    }
    let one = |k: usize, path: &Path| {
        let certificate = args.certificate.get(k).map(PathBuf::as_path);
        prove(shell, &meshes[k], &one_line(&path.display().to_string()), order, certificate)
    };
    Ok(vec![one(0, &args.a)?, one(1, &args.b)?])
}

/// Errors on points of A.
struct Measures {
    worst: Worst,
    /// Exact round trips that are equalities.
    equal: usize,
    ours: RoundTrip,
    phong: Option<RoundTrip>,
}

impl Measures {
    fn new(transfer: &Transfer<'_>, args: &Args) -> Result<Self, SectionError> {
        let points = random_points(transfer.source(), args.measure as usize);
        let phong = || round_trip_phong(transfer.source(), transfer.target(), &points);
        Ok(Self {
            worst: measured(transfer, &points)?,
            equal: exact_round_trips(transfer, &points)?,
            ours: round_trip(transfer, &points),
            phong: args.compare_phong.then(phong),
        })
    }

    fn json(&self) -> Value {
        let Worst { points, measured, bound } = self.worst;
        json!({"points": points, "largest": measured, "bound": bound})
    }
}

fn writable(args: &Args, json: &Json) -> Result<(), CliError> {
    let mut taken: Vec<&Path> = vec![&args.shell, &args.a, &args.b, Path::new(&args.order)];
    taken.extend(args.attributes.iter().chain(&args.certificate).map(PathBuf::as_path));
    output::may_write(&args.output, &taken)?;
    taken.push(&args.output);
    json.file().map_or(Ok(()), |path| output::may_write(path, &taken))
}

fn mesh_of(path: &Path, loaded: &Loaded) -> Result<TriMesh, CliError> {
    let Shell { middle, faces, .. } = loaded.shell();
    match path.to_str() {
        Some("middle") => Ok(TriMesh { vertices: middle.clone(), faces: faces.clone() }),
        Some("stored") => loaded.mesh().cloned().ok_or_else(|| CliError::Read {
            file: loaded.shell_name(),
            reason: "it holds no mesh".to_owned(),
        }),
        _ => Ok(mesh::read(path)?.mesh),
    }
}

fn read_attributes(args: &Args, mesh: &TriMesh) -> Result<Vec<Attribute>, CliError> {
    let mut out = Vec::new();
    for path in &args.attributes {
        let found = attribute::read(path, mesh)?;
        if found.is_empty() {
            let reason = "it holds no attributes".to_owned();
            return Err(AttributeError::File { file: path.display().to_string(), reason }.into());
        }
        out.extend(found);
    }
    Ok(out)
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Output {
    Ply,
    Csv,
    Json,
}

impl Output {
    fn of(path: &Path) -> Result<Self, CliError> {
        let extension = path.extension().and_then(|e| e.to_str()).unwrap_or_default().to_ascii_lowercase();
        match extension.as_str() {
            "ply" => Ok(Self::Ply),
            "csv" => Ok(Self::Csv),
            "json" => Ok(Self::Json),
            _ => Err(CliError::Usage("-o: the name must end in .ply, .csv or .json".to_owned())),
        }
    }
}

fn encode(
    format: Output,
    target: &TriMesh,
    attributes: &[Attribute],
    samples: &Samples,
    proved: bool,
) -> Result<Vec<u8>, CliError> {
    match format {
        Output::Ply => {
            let comment = if proved { "" } else { "unproved: nothing shows that the map is a bijection" };
            Ok(attribute::to_ply(target, attributes, comment))
        }
        Output::Csv => Ok(attribute::to_csv(attributes)?),
        Output::Json => {
            let points = |list: &[Sample]| -> Value { list.iter().map(point).collect() };
            let value = json!({
                "proved": proved,
                "attributes": attribute::to_json(attributes),
                "points": {"vertices": points(&samples.vertices), "faces": points(&samples.faces)},
            });
            Ok(output::json(&value)?.into_bytes())
        }
    }
}

/// Rationals as texts `n/d`, or doubles.
fn point(sample: &Sample) -> Value {
    match &sample.weights {
        Weights::Exact(w) => json!({"face": sample.face, "weights": w.each_ref().map(ToString::to_string)}),
        Weights::Float(w) => json!({"face": sample.face, "weights": w}),
    }
}

fn summary(attribute: &Attribute) -> Value {
    let domain = match attribute.domain {
        Domain::Vertex => "vertex",
        Domain::Face => "face",
        Domain::Corner => "corner",
    };
    json!({"name": attribute.name, "domain": domain, "values": attribute.values.len()})
}

fn trip(t: &RoundTrip) -> Value {
    json!({"points": t.points, "lost": t.lost, "astray": t.astray, "largest": t.largest, "mean": t.mean})
}

fn words(report: &Report, proofs: &[Proof], measures: &Measures) -> String {
    let Measures { worst, equal, ours, phong } = measures;
    let mut out = String::new();
    for proof in proofs {
        let _ = writeln!(out, "{proof}");
    }
    if proofs.is_empty() {
        let _ = writeln!(out, "UNPROVED   nothing shows that this map is a bijection");
    }
    let how = if report.exact {
        "exact".to_owned()
    } else {
        format!("f64, proved bound {:.1e}", report.error_bound)
    };
    let _ = writeln!(
        out,
        "{} attributes to {} vertices and {} triangles in {:.2} s ({how})",
        report.attributes.len(),
        report.vertices,
        report.faces,
        report.seconds
    );
    let _ = writeln!(
        out,
        "weights in f64 against the exact ones, {} points: largest error {:.1e}, largest bound {:.1e}",
        worst.points, worst.measured, worst.bound
    );
    let _ = writeln!(out, "\nround trip A to B to A        points      lost    astray   largest      mean");
    let _ = writeln!(
        out,
        "  {:<26}{:>8}   ({} of them equal to the start as rationals)",
        "homeo, exact", worst.points, equal
    );
    let mut row = |name: &str, t: &RoundTrip| {
        let _ = writeln!(
            out,
            "  {name:<26}{:>8}{:>10}{:>10}{:>10.1e}{:>10.1e}",
            t.points, t.lost, t.astray, t.largest, t.mean
        );
    };
    row("homeo, f64", ours);
    if let Some(phong) = phong {
        row("Phong projection", phong);
    }
    let _ = writeln!(out, "\nwrote {}", one_line(&report.output));
    out
}
