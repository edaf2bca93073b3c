//! Time and memory of certify and check against the size of the input; every size in a process of its own.

use std::process::Command;

use homeo_benches::built::program;
use homeo_benches::cgal::Answer;
use homeo_benches::plot::{self, PowerLaw, Series};
use homeo_benches::table::{Table, median};
use serde::Serialize;
use serde_json::json;

use crate::error::{PeersError, Res};
use crate::plan::Plan;
use crate::report::{Asked, Report, Row};

/// Wanted numbers of triangles.
const SIZES: [u32; 8] = [10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000, 2_000_000];
/// Up to here a size is measured several times.
const SMALL: u32 = 100_000;

/// One size.
#[derive(Debug, Serialize)]
struct Run {
    triangles: u64,
    prisms: u64,
    certify_seconds: f64,
    check_seconds: f64,
    input_bytes: f64,
    certificate_bytes: f64,
    certify_peak_mib: Option<f64>,
    check_peak_mib: Option<f64>,
}

impl Run {
    /// The peak of certify as a multiple of what it reads and writes.
    fn memory(&self) -> Option<f64> {
        let bytes = self.input_bytes + self.certificate_bytes;
        self.certify_peak_mib.map(|mib| mib * 1024.0 * 1024.0 / bytes)
    }
}

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let limit = plan.options.max_triangles.unwrap_or(if plan.options.quick { 20_000 } else { u32::MAX });
    let sizes = SIZES.into_iter().filter(|size| *size <= limit);
    let mut runs = Vec::new();
    for size in sizes {
        let rounds = if size <= SMALL { plan.options.few_rounds() } else { 1 };
        match measure(size, rounds) {
            Ok(run) => runs.push(run),
            // Not enough memory, most likely: what fits is still told.
            Err(error @ PeersError::Program { .. }) => {
                eprintln!("FAILED: {error}");
                let what = format!("certify and check, {size} triangles");
                report.row(Row::absent(&what, "linear", Some(Asked::AtMost(1.05)), "FAILED"));
                break;
            }
            Err(error) => return Err(error),
        }
        eprintln!("  {:?}", runs.last());
    }
    if runs.is_empty() {
        return Ok(());
    }
    let points = |seconds: &dyn Fn(&Run) -> f64| -> Vec<[f64; 2]> {
        runs.iter().map(|r| [r.triangles as f64, seconds(r)]).collect()
    };
    let both = [("certify", points(&|r| r.certify_seconds)), ("check", points(&|r| r.check_seconds))];
    let span = format!("{} -> {} triangles", ends(&runs, 0), ends(&runs, usize::MAX));
    let asked = Some(Asked::AtMost(1.05));
    let mut series = Vec::new();
    for (name, points) in both {
        let fit = PowerLaw::fit(&points);
        let what = format!("growth of {name} time, {span}");
        report.row(match fit {
            Some(law) => Row::value(&what, "linear", asked, law.exponent, "fitted exponent"),
            None => Row::absent(&what, "linear", asked, "too few sizes"),
        });
        series.push(Series { name: name.to_owned(), points, fit });
    }
    memory(&runs, report);
    table(&runs, report);
    report.data("growth", json!(runs));
    let path = crate::output("peers.svg", &plan.options)?;
    plot::log_log(&path, "certify and check, one thread", ["triangles", "seconds"], &series)
        .map_err(|error| PeersError::Plot(error.to_string()))
}

/// The size of the first or last run, for a title.
fn ends(runs: &[Run], at: usize) -> u64 {
    runs.get(at).or(runs.last()).map_or(0, |r| r.triangles)
}

fn memory(runs: &[Run], report: &mut Report) {
    let (asked, against) = (Some(Asked::AtMost(12.0)), "input + certificate bytes");
    let Some(last) = runs.last() else { return };
    let what = format!("peak memory of certify, {} triangles", last.triangles);
    let meaning = "times the bytes of coordinates (8 each), indices (4 each) and certificate";
    report.row(match last.memory() {
        Some(factor) => Row::value(&what, against, asked, factor, meaning),
        None => Row::absent(&what, against, asked, "the system does not say"),
    });
}

fn table(runs: &[Run], report: &mut Report) {
    let columns = [
        "triangles",
        "prisms",
        "certify s",
        "check s",
        "input MB",
        "certificate MB",
        "certify peak MiB",
        "times input + certificate",
        "check peak MiB",
    ];
    let mut table = Table::new(&columns);
    let mib = |m: Option<f64>| m.map_or_else(|| "-".to_owned(), |m| format!("{m:.0}"));
    for run in runs {
        table.row(vec![
            run.triangles.to_string(),
            run.prisms.to_string(),
            format!("{:.2}", run.certify_seconds),
            format!("{:.2}", run.check_seconds),
            format!("{:.1}", run.input_bytes / 1e6),
            format!("{:.1}", run.certificate_bytes / 1e6),
            mib(run.certify_peak_mib),
            run.memory().map_or_else(|| "-".to_owned(), |x| format!("{x:.1}")),
            mib(run.check_peak_mib),
        ]);
    }
    let text = "![Time against size](peers.svg)\n\nGenerated shells before simplification (`initial`), each size in a process of \
                its own, one thread. The peak includes the input and what its generator left behind.";
    report.detail("Growth", text, &table);
}

/// Runs `homeo-profile` so often; medians of the times, largest memory.
fn measure(size: u32, rounds: usize) -> Res<Run> {
    let argument = format!("initial:{}", (size / 8).isqrt());
    let failed =
        |text: String| PeersError::Program { program: "homeo-profile", argument: argument.clone(), text };
    let io = |source| PeersError::Io { what: "homeo-profile".to_owned(), source };
    let mut answers = Vec::new();
    for _ in 0..rounds {
        let path = program("homeo-profile").map_err(io)?;
        let output = Command::new(path).args([&argument, "check"]).output().map_err(io)?;
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(failed(format!("{}: {}", output.status, said.trim())));
        }
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        if !text.contains("checker: valid") {
            return Err(failed("the checker does not accept".to_owned()));
        }
        answers.push(Answer::parse("homeo-profile", &text));
    }
    let all = |key: &str| answers.iter().map(|a| a.get::<f64>(key)).collect::<Result<Vec<f64>, _>>();
    let first = |key: &str| -> Res<f64> { Ok(all(key)?.first().copied().unwrap_or(f64::NAN)) };
    let whole = |key: &str| -> Res<u64> {
        let first = answers.first().ok_or_else(|| failed("it was not run".to_owned()))?;
        Ok(first.get(key)?)
    };
    let largest = |key: &str| all(key).ok().and_then(|all| all.into_iter().reduce(f64::max));
    Ok(Run {
        triangles: whole("mesh_triangles")?,
        prisms: whole("prisms")?,
        certify_seconds: median(&all("seconds")?),
        check_seconds: median(&all("check_seconds")?),
        input_bytes: first("input_bytes")?,
        certificate_bytes: first("certificate_bytes")?,
        certify_peak_mib: largest("peak_mib"),
        check_peak_mib: largest("check_peak_mib"),
    })
}
