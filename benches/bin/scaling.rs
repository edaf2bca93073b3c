//! Time and memory of `homeo build` against input size: noisy spheres of 1,000 to 200,000 triangles, and the real surfaces
//! of the last `homeo-dataset`.
//!
//!     homeo-scaling [TRIANGLES...]
//!
//! With sizes only these are built and nothing is kept.

use std::error::Error;
use std::process::ExitCode;
use std::time::Duration;

use homeo::mesh::{self, Format, TriMesh};
use homeo_benches::generate::{sphere, unit_hash};
use homeo_benches::plot::{self, PowerLaw, Series};
use homeo_benches::table::Table;
use homeo_benches::{built, results};
use serde::Serialize;
use serde_json::Value;

type Res<T = ()> = Result<T, Box<dyn Error>>;

/// Wanted numbers of triangles.
const SIZES: [u32; 8] = [1_000, 2_000, 5_000, 10_000, 20_000, 50_000, 100_000, 200_000];
const LIMIT: Duration = Duration::from_secs(3600);
/// The largest move of a vertex along its radius, as a share of an edge: enough that no triangle is where it was, and
/// without folds.
const NOISE: f64 = 0.2;

/// One build.
#[derive(Clone, Debug, Serialize)]
struct Run {
    input: String,
    /// `generated` or `real`.
    kind: &'static str,
    triangles: u64,
    prisms: u64,
    seconds: f64,
    certify_seconds: f64,
    peak_mib: Option<f64>,
}

const KEYS: [&str; 7] = ["input", "kind", "triangles", "prisms", "seconds", "certify_seconds", "peak_mib"];

fn main() -> Res<ExitCode> {
    let wanted = std::env::args().skip(1).map(|a| a.parse()).collect::<Result<Vec<u32>, _>>()?;
    let sizes = if wanted.is_empty() { &SIZES[..] } else { &wanted[..] };
    let mut runs = Vec::new();
    let mut failed = 0;
    for &size in sizes {
        match generated(size) {
            Ok(run) => {
                println!("{run:?}");
                runs.push(run);
            }
            Err(e) => {
                println!("FAILED {size}: {e}");
                failed += 1;
            }
        }
    }
    let law = law(&runs);
    let real = real()?;
    if real.is_empty() {
        println!("SKIPPED: no dataset.json, so no real surfaces in the plot; `just dataset` makes it");
    }
    runs.extend(real);
    let text = section(&runs, law);
    println!("{text}");
    if wanted.is_empty() {
        plot(&runs, law)?;
        let values = runs.iter().map(serde_json::to_value).collect::<Result<Vec<Value>, _>>()?;
        std::fs::write(results::file("scaling.csv"), results::csv(&KEYS, &values))?;
        results::put("scaling", &text)?;
    }
    Ok(ExitCode::from(u8::from(failed > 0)))
}

/// A noisy sphere of about so many triangles: `8 * frequency^2`.
fn noisy(triangles: u32) -> TriMesh {
    let frequency = (triangles / 8).isqrt().max(1);
    let mut mesh = sphere(frequency);
    // A quarter of the equator has `frequency` edges; the radius is about a half.
    let reach = NOISE * 0.5 * std::f64::consts::FRAC_PI_2 / f64::from(frequency);
    for (v, p) in mesh.vertices.iter_mut().enumerate() {
        let factor = 1.0 + 2.0 * reach * (2.0 * unit_hash(v as u64) - 1.0);
        *p = p.map(|x| 0.5 + (x - 0.5) * factor);
    }
    mesh
}

fn generated(size: u32) -> Res<Run> {
    let dir = tempfile::tempdir()?;
    let [file, shell] = ["noisy.off", "noisy.h5"].map(|name| dir.path().join(name));
    mesh::write(&file, &noisy(size), Format::Off)?;
    let report = built::build(&file, &shell, &[], LIMIT)??;
    let at = |path: &str| report.pointer(path).ok_or_else(|| format!("the report has no {path}"));
    let count = |path: &str| at(path).map(|v| v.as_u64().unwrap_or(0));
    let seconds = |path: &str| at(path).map(|v| v.as_f64().unwrap_or(f64::NAN));
    let triangles = count("/mesh/triangles")?;
    Ok(Run {
        input: format!("sphere-{triangles}"),
        kind: "generated",
        triangles,
        prisms: count("/prisms")?,
        seconds: seconds("/seconds")?,
        certify_seconds: seconds("/parts/certify")?,
        peak_mib: at("/peak_mib")?.as_f64(),
    })
}

/// The real surfaces that were built at default settings; none without the file.
fn real() -> Res<Vec<Run>> {
    let Ok(text) = std::fs::read_to_string(results::file("dataset.json")) else { return Ok(Vec::new()) };
    let data: Value = serde_json::from_str(&text)?;
    let run = |row: &Value| {
        let number = |key: &str| row.get(key).and_then(Value::as_f64);
        let whole = |key: &str| row.get(key).and_then(Value::as_u64);
        let is = |key: &str, word: &str| row.get(key).and_then(Value::as_str) == Some(word);
        (is("settings", "default") && is("outcome", "built")).then_some(())?;
        Some(Run {
            input: row.get("mesh")?.as_str()?.to_owned(),
            kind: "real",
            triangles: whole("triangles")?,
            prisms: whole("prisms")?,
            seconds: number("seconds")?,
            certify_seconds: number("certify_seconds")?,
            peak_mib: number("peak_mib"),
        })
    };
    let rows = data.get("rows").and_then(Value::as_array);
    let mut out: Vec<Run> = rows.into_iter().flatten().filter_map(run).collect();
    out.sort_by_key(|r| r.triangles);
    Ok(out)
}

/// The law through the runs.
fn law(runs: &[Run]) -> Option<PowerLaw> {
    PowerLaw::fit(&runs.iter().map(|r| [r.triangles as f64, r.seconds]).collect::<Vec<_>>())
}

fn section(runs: &[Run], law: Option<PowerLaw>) -> String {
    let mut table = Table::new(&["input", "triangles", "prisms", "build s", "certify s", "peak MiB"]);
    for run in runs {
        table.row(vec![
            run.input.clone(),
            run.triangles.to_string(),
            run.prisms.to_string(),
            format!("{:.2}", run.seconds),
            format!("{:.2}", run.certify_seconds),
            run.peak_mib.map_or_else(|| "-".to_owned(), |m| format!("{m:.0}")),
        ]);
    }
    let fit = law.map_or_else(String::new, |PowerLaw { exponent, .. }| {
        format!(
            "Over the generated spheres the time grows with the power {exponent:.2} of the number of triangles. "
        )
    });
    format!(
        "## Time against input size\n\nWritten by `just scaling` (also [CSV](scaling.csv)): `homeo build` at default settings. {fit}\
         Peak memory includes certifying and checking.\n\n![Time against input size](scaling.svg)\n\n{}\n{}.",
        table.render(),
        results::machine()
    )
}

/// Seconds over triangles, both axes logarithmic.
fn plot(runs: &[Run], law: Option<PowerLaw>) -> Res {
    let series = |kind: &str, name: &str, fit: Option<PowerLaw>| {
        let of = runs.iter().filter(|r| r.kind == kind).map(|r| [r.triangles as f64, r.seconds]);
        Series { name: name.to_owned(), points: of.collect(), fit }
    };
    let both = [series("generated", "noisy spheres", law), series("real", "real surfaces", None)];
    plot::log_log(&results::file("scaling.svg"), "homeo build", ["triangles", "seconds"], &both)
}
