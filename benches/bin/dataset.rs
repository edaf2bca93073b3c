//! Builds a shell around every surface of the test data, has it certified and checked, and writes one table.
//!
//!     homeo-dataset [MESH...]
//!
//! With names of meshes only these are built and nothing is kept. Exit code 1 if a mesh failed.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Duration;

use homeo::construct::measure::longest_box_edge;
use homeo::report::ThicknessReport;
use homeo::shell::hdf5;
use homeo_benches::built::{self, verdict};
use homeo_benches::table::Table;
use homeo_benches::{real, results};
use serde::Serialize;
use serde_json::Value;

type Res<T = ()> = Result<T, Box<dyn Error>>;

/// No mesh and no checker may take longer than this.
const LIMIT: Duration = Duration::from_secs(3600);

/// Meshes that no shell can be built around, and what the refusal says.
const BAD: [(&str, &str); 4] = [
    ("blobby-shuffled.off", "oriented against each other"),
    ("camel.off", "intersects itself"),
    ("capsule.obj", "area is exactly zero"),
    ("cow.obj", "link has"),
];

/// The reference implementation's prisms and seconds (same kind of machine, two shared cores), and its shell file.
const REFERENCE: [(&str, u64, f64, Option<&str>); 9] = [
    ("cube.obj", 66, 0.4, Some("cube.obj.h5")),
    ("sphere.obj", 760, 3.2, Some("sphere.obj.h5")),
    ("bumpy.off", 162, 17.8, Some("bumpy.off.h5")),
    ("spot.obj", 238, 15.4, Some("c_spot.obj.h5")),
    ("bunny.off", 254, 47.7, Some("bunny.off.h5")),
    ("decimated-knight.off", 620, 19.1, Some("decimated-knight.off.h5")),
    ("fertility.off", 468, 56.0, None),
    ("fandisk.off", 146, 87.8, Some("fandisk.off.h5")),
    ("tennis.off", 104, 1.3, Some("tennis.off.h5")),
];

/// The reference's settings: thickness, and acos(1e-3) in degrees.
const SETTINGS: [&str; 4] = ["--thickness", "0.05", "--angle", "89.94270424"];

/// The columns of the CSV: members of [`Row`].
const KEYS: [&str; 19] = [
    "mesh",
    "settings",
    "triangles",
    "singular",
    "prisms",
    "reference_prisms",
    "seconds",
    "reference_seconds",
    "certify_seconds",
    "peak_mib",
    "thickness_min",
    "thickness_mean",
    "reference_thickness_min",
    "reference_thickness_mean",
    "homeo_check",
    "check_py",
    "check_py_seconds",
    "outcome",
    "reason",
];

/// One build.
#[derive(Clone, Debug, Default, Serialize)]
struct Row {
    mesh: String,
    /// `default`, or `reference` for the reference implementation's.
    settings: &'static str,
    triangles: Option<u64>,
    singular: Option<u64>,
    prisms: Option<u64>,
    reference_prisms: Option<u64>,
    seconds: Option<f64>,
    reference_seconds: Option<f64>,
    certify_seconds: Option<f64>,
    peak_mib: Option<f64>,
    /// Shares of the longest box edge.
    thickness_min: Option<f64>,
    thickness_mean: Option<f64>,
    reference_thickness_min: Option<f64>,
    reference_thickness_mean: Option<f64>,
    homeo_check: String,
    check_py: String,
    check_py_seconds: Option<f64>,
    /// `built`, `refused` as it must be, or `FAILED`.
    outcome: &'static str,
    /// Why there is no shell.
    reason: String,
}

fn main() -> Res<ExitCode> {
    let wanted: Vec<String> = std::env::args().skip(1).collect();
    let meshes = surfaces(&wanted)?;
    if meshes.is_empty() {
        println!(
            "SKIPPED: no such surfaces in {} (no shell was built)",
            real::data().join("surface").display()
        );
        return Ok(ExitCode::SUCCESS);
    }
    let mut rows = Vec::new();
    for mesh in &meshes {
        let name = real::name(mesh);
        let known = REFERENCE.iter().any(|r| r.0 == name);
        for settings in [Some("default"), known.then_some("reference")].into_iter().flatten() {
            // A failure is a row, and the others follow.
            let row = one(mesh, settings).unwrap_or_else(|e| Row {
                mesh: name.clone(),
                settings,
                outcome: "FAILED",
                reason: e.to_string(),
                ..Row::default()
            });
            print!("{}", line(&row, rows.is_empty()));
            rows.push(row);
        }
    }
    let failed = rows.iter().filter(|r| r.outcome == "FAILED").count();
    println!("{failed} failed");
    let text = section(&rows);
    if wanted.is_empty() {
        keep(&rows, &text)?;
    } else {
        println!("{text}");
    }
    Ok(ExitCode::from(u8::from(failed > 0)))
}

/// The meshes, small files first.
fn surfaces(wanted: &[String]) -> Res<Vec<PathBuf>> {
    let mut out: Vec<(u64, PathBuf)> = Vec::new();
    for entry in std::fs::read_dir(real::data().join("surface")).into_iter().flatten() {
        let entry = entry?;
        let name = real::name(&entry.path());
        let is_mesh = [".off", ".obj", ".ply", ".stl"].iter().any(|end| name.ends_with(end));
        if is_mesh && (wanted.is_empty() || wanted.contains(&name)) {
            out.push((entry.metadata()?.len(), entry.path()));
        }
    }
    out.sort();
    Ok(out.into_iter().map(|(_, path)| path).collect())
}

fn one(mesh: &Path, settings: &'static str) -> Res<Row> {
    let name = real::name(mesh);
    let mut row = Row { mesh: name.clone(), settings, outcome: "FAILED", ..Row::default() };
    let dir = tempfile::tempdir()?;
    let shell = dir.path().join("shell.h5");
    let more = if settings == "reference" { &SETTINGS[..] } else { &[] };
    let bad = BAD.iter().find(|b| b.0 == name);
    match built::build(mesh, &shell, more, LIMIT)? {
        Err(reason) => {
            let right = bad.is_some_and(|b| reason.contains(b.1));
            // The message begins with the file, whose place is nobody's business.
            row.reason = reason.split_once(&format!("{name}: ")).map_or(reason.clone(), |r| r.1.to_owned());
            row.outcome = if right { "refused" } else { "FAILED" };
        }
        Ok(report) => {
            measured(&report, &mut row);
            checked(&shell, &mut row)?;
            let valid = row.homeo_check == "valid" && row.check_py == "valid";
            row.outcome = if bad.is_none() && valid { "built" } else { "FAILED" };
            if bad.is_some() {
                "this mesh must be refused".clone_into(&mut row.reason);
            }
        }
    }
    if settings == "reference" {
        reference(&name, &mut row)?;
    }
    Ok(row)
}

fn measured(report: &Value, row: &mut Row) {
    let at = |path: &str| report.pointer(path);
    row.triangles = at("/mesh/triangles").and_then(Value::as_u64);
    row.singular = at("/singular/count").and_then(Value::as_u64);
    row.prisms = at("/prisms").and_then(Value::as_u64);
    row.seconds = at("/seconds").and_then(Value::as_f64);
    row.certify_seconds = at("/parts/certify").and_then(Value::as_f64);
    row.peak_mib = at("/peak_mib").and_then(Value::as_f64);
    let of = |side: &str, what: &str| at(&format!("/thickness/{side}_share/{what}")).and_then(Value::as_f64);
    let both = |what: &str| of("bottom", what).zip(of("top", what));
    row.thickness_min = both("min").map(|(b, t)| b.min(t));
    // Both halves are counted at the same vertices.
    row.thickness_mean = both("mean").map(|(b, t)| (b + t) / 2.0);
}

fn checked(shell: &Path, row: &mut Row) -> Res {
    (row.homeo_check, _) = verdict(&mut Command::new(built::program("homeo-check")?), shell, LIMIT)?;
    let script = results::file("../reference/check.py");
    match verdict(Command::new("python3").arg("-B").arg(script), shell, LIMIT) {
        Ok((word, seconds)) => (row.check_py, row.check_py_seconds) = (word, Some(seconds)),
        Err(e) => row.check_py = format!("not run: {e}"),
    }
    Ok(())
}

fn reference(name: &str, row: &mut Row) -> Res {
    let Some((_, prisms, seconds, file)) = REFERENCE.iter().find(|r| r.0 == name) else { return Ok(()) };
    (row.reference_prisms, row.reference_seconds) = (Some(*prisms), Some(*seconds));
    let Some(path) = file.map(|f| real::data().join("thirdparty/shells").join(f)).filter(|p| p.exists())
    else {
        return Ok(());
    };
    let file = hdf5::read(&path)?;
    let unit = file.mesh.as_ref().map_or(1.0, longest_box_edge);
    let thick = ThicknessReport::new(&file.shell, unit).least_and_mean_share();
    (row.reference_thickness_min, row.reference_thickness_mean) = (thick.map(|t| t[0]), thick.map(|t| t[1]));
    Ok(())
}

fn shown<T>(value: Option<T>, show: impl Fn(T) -> String) -> String {
    value.map_or_else(|| "-".to_owned(), show)
}

/// The columns of the table, with their values in a row.
fn columns(row: &Row) -> [(&'static str, String); 13] {
    let count = |n: Option<u64>| shown(n, |n| n.to_string());
    let seconds = |s: Option<f64>| shown(s, |s| format!("{s:.1}"));
    let thick = |least: Option<f64>, mean: Option<f64>| {
        shown(least.zip(mean), |(least, mean)| format!("{least:.1e} / {mean:.4}"))
    };
    let word = |text: &str| if text.is_empty() { "-".to_owned() } else { text.to_owned() };
    [
        ("mesh", row.mesh.clone()),
        ("settings", row.settings.to_owned()),
        ("triangles", count(row.triangles)),
        ("singular", count(row.singular)),
        ("prisms", count(row.prisms)),
        ("its prisms", count(row.reference_prisms)),
        ("build s", seconds(row.seconds)),
        ("its s", seconds(row.reference_seconds)),
        ("certify s", seconds(row.certify_seconds)),
        ("peak MiB", shown(row.peak_mib, |m| format!("{m:.0}"))),
        ("thickness least / mean", thick(row.thickness_min, row.thickness_mean)),
        ("its thickness", thick(row.reference_thickness_min, row.reference_thickness_mean)),
        ("homeo-check, check.py", format!("{}, {}", word(&row.homeo_check), word(&row.check_py))),
    ]
}

/// A row on the terminal, after the header if it is the first.
fn line(row: &Row, first: bool) -> String {
    let widths = [22, 9, 9, 8, 7, 10, 8, 7, 9, 8, 22, 19, 21];
    let pad = |cells: Vec<String>| -> String {
        let cells = cells.iter().zip(widths).map(|(c, w)| format!("{c:w$} "));
        cells.collect::<String>()
    };
    let head = pad(columns(row).iter().map(|c| c.0.to_owned()).collect());
    let body = pad(columns(row).into_iter().map(|c| c.1).collect());
    let head = if first { format!("{head} outcome\n") } else { String::new() };
    format!("{head}{body} {} {}\n", row.outcome, row.reason)
}

/// The section of `RESULTS.md`.
fn section(rows: &[Row]) -> String {
    let mut header: Vec<&str> = columns(&Row::default()).iter().map(|c| c.0).collect();
    header.push("outcome");
    let mut table = Table::new(&header);
    let mut refused = Table::new(&["mesh", "outcome", "reason"]);
    for row in rows {
        if row.prisms.is_some() {
            let mut cells: Vec<String> = columns(row).into_iter().map(|c| c.1).collect();
            cells.push(row.outcome.to_owned());
            table.row(cells);
        } else {
            refused.row(vec![row.mesh.clone(), row.outcome.to_owned(), row.reason.replace('|', "/")]);
        }
    }
    let mut outcomes: BTreeMap<&str, usize> = BTreeMap::new();
    rows.iter().for_each(|r| *outcomes.entry(r.outcome).or_default() += 1);
    let outcomes: Vec<String> = outcomes.iter().map(|(o, n)| format!("{n} {o}")).collect();
    format!(
        "## Shells around real surfaces\n\nWritten by `just dataset` (also [CSV](dataset.csv) and [JSON](dataset.json)). Every shell \
         was certified for all claims; both checkers read the files. \"Its\" figures are the reference implementation's, at its \
         settings (thickness 0.05, cosine at least 1e-3), and of another run on two shared cores. Thickness is that of the halves at \
         vertices that are not pinched, as a share of the longest box edge. Peak memory includes certifying and checking.\n\n{}\n\
         No shell:\n\n{}\n{}. {}.",
        table.render(),
        refused.render(),
        outcomes.join(", "),
        results::machine()
    )
}

fn keep(rows: &[Row], text: &str) -> Res {
    let values = rows.iter().map(serde_json::to_value).collect::<Result<Vec<Value>, _>>()?;
    let json = serde_json::json!({ "machine": results::machine(), "rows": values });
    std::fs::write(results::file("dataset.json"), serde_json::to_string_pretty(&json)? + "\n")?;
    std::fs::write(results::file("dataset.csv"), results::csv(&KEYS, &values))?;
    results::put("dataset", text)?;
    Ok(())
}
