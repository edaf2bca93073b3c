//! `homeo project`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use rayon::prelude::*;
use serde::Serialize;

use super::CliError;
use super::input::{self, Loaded, ThreeMeshes, read_regular};
use super::output::{self, Json};
use crate::projection::{Projection, ShellPoint};

/// Arguments of `homeo project`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Shell file (HDF5)
    shell: Option<PathBuf>,
    #[command(flatten)]
    three: ThreeMeshes,
    /// A point to project; may be repeated
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], allow_hyphen_values = true)]
    point: Vec<f64>,
    /// A file of points, one `x y z` a line; empty lines and lines that begin with `#` are skipped
    #[arg(long, value_name = "FILE")]
    points: Option<PathBuf>,
    /// Vertex order: `id`, or a file of all vertex ids, smallest first
    #[arg(long, value_name = "id|FILE", default_value = "id")]
    order: String,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
}

#[derive(Serialize)]
struct Report {
    points: Vec<Point>,
}

#[derive(Serialize)]
struct Point {
    point: [f64; 3],
    /// None outside of the shell; more than one where the shell overlaps itself.
    images: Vec<Image>,
}

/// A point of the abstract shell; rationals as `p/q`, and rounded.
#[derive(Serialize)]
struct Image {
    prism: u32,
    corners: [u32; 3],
    weights: [String; 3],
    height: String,
    approximate_weights: [f64; 3],
    approximate_height: f64,
}

/// Runs the command: 0 when all points are in the shell, 1 when one is not.
pub(super) fn run(mut args: Args) -> Result<ExitCode, CliError> {
    let json = match args.three.files() {
        Some(_) => Json::of(args.json.take()),
        None => Json::from_arguments(args.json.take(), &mut args.shell),
    };
    let points = points(&args)?;
    let loaded = Loaded::read(args.shell.as_deref(), &args.three, None)?;
    if let Some(file) = json.file() {
        let mut taken = loaded.inputs();
        taken.extend(args.points.as_deref());
        taken.push(Path::new(&args.order));
        output::may_write(file, &taken)?;
    }
    let order = input::order(&args.order, loaded.shell().vertex_count())?;
    let projection = Projection::new(loaded.shell(), &order)
        .map_err(|e| CliError::Read { file: loaded.shell_name(), reason: e.to_string() })?;
    let report = Report { points: points.into_par_iter().map(|p| project(&projection, p)).collect() };
    json.emit(&report, &words(&report))?;
    Ok(ExitCode::from(u8::from(report.points.iter().any(|p| p.images.is_empty()))))
}

fn project(projection: &Projection<'_>, point: [f64; 3]) -> Point {
    let image = |q: ShellPoint| Image {
        prism: q.prism,
        corners: projection.shell().faces.get(q.prism as usize).copied().unwrap_or_default(),
        weights: q.weights.each_ref().map(ToString::to_string),
        height: q.height.to_string(),
        approximate_weights: q.weights.each_ref().map(|w| w.to_f64().value()),
        approximate_height: q.height.to_f64().value(),
    };
    Point { point, images: projection.images(&point).iter().map(|q| image(q.to_point())).collect() }
}

fn points(args: &Args) -> Result<Vec<[f64; 3]>, CliError> {
    let mut out: Vec<[f64; 3]> = args.point.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    if out.iter().flatten().any(|x| !x.is_finite()) {
        return Err(CliError::Usage("--point: a coordinate is not finite".to_owned()));
    }
    if let Some(path) = &args.points {
        let bytes = read_regular(path)?;
        for (line, text) in (1_usize..).zip(bytes.split(|&b| b == b'\n')) {
            let text = text.trim_ascii();
            if !text.is_empty() && !text.starts_with(b"#") {
                out.push(point(text).ok_or_else(|| CliError::Read {
                    file: path.display().to_string(),
                    reason: format!("line {line}: not three finite numbers"),
                })?);
            }
        }
    }
    if out.is_empty() {
        return Err(CliError::Usage("no point: give --point X Y Z or --points FILE".to_owned()));
    }
    Ok(out)
}

fn point(text: &[u8]) -> Option<[f64; 3]> {
    let mut numbers = std::str::from_utf8(text).ok()?.split_ascii_whitespace();
    let mut next = || numbers.next()?.parse::<f64>().ok().filter(|x| x.is_finite());
    let point = [next()?, next()?, next()?];
    numbers.next().is_none().then_some(point)
}

fn words(report: &Report) -> String {
    let mut out = String::new();
    for p in &report.points {
        let [x, y, z] = p.point;
        let _ = writeln!(out, "point {x:?} {y:?} {z:?}");
        if p.images.is_empty() {
            let _ = writeln!(out, "    outside of the shell");
        }
        for image in &p.images {
            let [a, b, c] = image.corners;
            let _ = writeln!(out, "    prism {} (vertices {a} {b} {c})", image.prism);
            let [u, v, w] = image.approximate_weights;
            let height = image.approximate_height;
            let _ = writeln!(out, "        weights {u} {v} {w}, height {height} (rounded)");
            let _ = writeln!(out, "        exactly {}, height {}", image.weights.join(" "), image.height);
        }
    }
    out
}
