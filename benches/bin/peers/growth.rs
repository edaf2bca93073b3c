//! Time and memory of certify and check against the size of the input; every run in a process of its own, every size several
//! times: one slow run moves the median of its size little, and with it the fitted exponent.

use std::process::Command;
use std::time::Instant;

use homeo_benches::built::program;
use homeo_benches::cgal::Answer;
use homeo_benches::plot::{self, PowerLaw, Series};
use homeo_benches::table::{Table, median};
use serde::Serialize;
use serde_json::json;

use crate::error::{PeersError, Res};
use crate::plan::{Options, Plan};
use crate::report::{Asked, Report, Row};

/// Wanted numbers of triangles.
const SIZES: [u32; 8] = [10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000, 2_000_000];
/// Up to here a size is run at least three times, from here on twice.
const SMALL: u32 = 200_000;
/// A size is run until so many seconds are spent on it...
const SECONDS: f64 = 15.0;
/// ...but no more often than this.
const MOST: usize = 15;

/// One size: medians of the times, largest memory.
#[derive(Debug, Serialize)]
struct Run {
    triangles: u64,
    prisms: u64,
    runs: usize,
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
    let sizes = SIZES.into_iter().filter(|size| *size <= limit).map(Size::new).collect();
    let runs = measure(sizes, &plan.options, report)?;
    if runs.is_empty() {
        return Ok(());
    }
    let points = |seconds: &dyn Fn(&Run) -> f64| -> Vec<[f64; 2]> {
        runs.iter().map(|r| [r.triangles as f64, seconds(r)]).collect()
    };
    let both = [("certify", points(&|r| r.certify_seconds)), ("check", points(&|r| r.check_seconds))];
    let span = format!("{} -> {} triangles", ends(&runs, 0), ends(&runs, usize::MAX));
    let asked = Some(Asked::AtMost(1.05));
    let times = runs.iter().map(|r| r.runs);
    let (least, most) = (times.clone().min().unwrap_or(0), times.max().unwrap_or(0));
    let fitted = format!("fitted exponent, over medians of {least} to {most} runs a size");
    let mut series = Vec::new();
    for (name, points) in both {
        let fit = PowerLaw::fit(&points);
        let what = format!("growth of {name} time, {span}");
        report.row(match fit {
            Some(law) => Row::value(&what, "linear", asked, law.exponent, &fitted),
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
        "runs",
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
            run.runs.to_string(),
            format!("{:.2}", run.certify_seconds),
            format!("{:.2}", run.check_seconds),
            format!("{:.1}", run.input_bytes / 1e6),
            format!("{:.1}", run.certificate_bytes / 1e6),
            mib(run.certify_peak_mib),
            run.memory().map_or_else(|| "-".to_owned(), |x| format!("{x:.1}")),
            mib(run.check_peak_mib),
        ]);
    }
    let text = "![Time against size](peers.svg)\n\nGenerated shells before simplification (`initial`), each run in a process of \
                its own, one thread; medians over the runs of a size, which take turns with those of other sizes. The peak includes the input and what its generator left behind.";
    report.detail("Growth", text, &table);
}

/// A size that is measured.
struct Size {
    triangles: u32,
    answers: Vec<Answer>,
    spent: f64,
}

impl Size {
    const fn new(triangles: u32) -> Self {
        Self { triangles, answers: Vec::new(), spent: 0.0 }
    }

    fn wants_another(&self, options: &Options) -> bool {
        let done = self.answers.len();
        let few = options.few_rounds();
        if options.quick {
            return done < few;
        }
        let least = if self.triangles <= SMALL { few.max(3) } else { 2 };
        done < least || (done < MOST && self.spent < SECONDS)
    }

    /// What was asked of the program.
    fn argument(&self) -> String {
        format!("initial:{}", (self.triangles / 8).isqrt())
    }

    /// Runs `homeo-profile` once.
    fn run(&mut self) -> Res {
        let argument = self.argument();
        let failed =
            |text: String| PeersError::Program { program: "homeo-profile", argument: argument.clone(), text };
        let io = |source| PeersError::Io { what: "homeo-profile".to_owned(), source };
        let path = program("homeo-profile").map_err(io)?;
        let start = Instant::now();
        let output = Command::new(path).args([&argument, "check"]).output().map_err(io)?;
        self.spent += start.elapsed().as_secs_f64();
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr);
            return Err(failed(format!("{}: {}", output.status, said.trim())));
        }
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        if !text.contains("checker: valid") {
            return Err(failed("the checker does not accept".to_owned()));
        }
        self.answers.push(Answer::parse("homeo-profile", &text));
        Ok(())
    }

    fn result(&self) -> Res<Run> {
        let all = |key: &str| self.answers.iter().map(|a| a.get::<f64>(key)).collect::<Result<Vec<f64>, _>>();
        let first = |key: &str| -> Res<f64> { Ok(all(key)?.first().copied().unwrap_or(f64::NAN)) };
        let whole = |key: &str| -> Res<u64> {
            let first = self.answers.first().ok_or_else(|| PeersError::Program {
                program: "homeo-profile",
                argument: self.argument(),
                text: "it was not run".to_owned(),
            })?;
            Ok(first.get(key)?)
        };
        let largest = |key: &str| all(key).ok().and_then(|all| all.into_iter().reduce(f64::max));
        Ok(Run {
            triangles: whole("mesh_triangles")?,
            prisms: whole("prisms")?,
            runs: self.answers.len(),
            certify_seconds: median(&all("seconds")?),
            check_seconds: median(&all("check_seconds")?),
            input_bytes: first("input_bytes")?,
            certificate_bytes: first("certificate_bytes")?,
            certify_peak_mib: largest("peak_mib"),
            check_peak_mib: largest("check_peak_mib"),
        })
    }
}

/// Runs all sizes, ascending, turn by turn: a time at which the machine is slow falls on several of them. A size that fails ends
/// with all larger ones.
fn measure(mut sizes: Vec<Size>, options: &Options, report: &mut Report) -> Res<Vec<Run>> {
    while sizes.iter().any(|size| size.wants_another(options)) {
        for k in 0..sizes.len() {
            let Some(size) = sizes.get_mut(k).filter(|size| size.wants_another(options)) else { continue };
            match size.run() {
                Ok(()) => eprintln!("  {}, run {}", size.argument(), size.answers.len()),
                // Not enough memory, most likely: what fits is still told.
                Err(error @ PeersError::Program { .. }) => {
                    eprintln!("FAILED: {error}");
                    let what = format!("certify and check, {} triangles", size.triangles);
                    report.row(Row::absent(&what, "linear", Some(Asked::AtMost(1.05)), "FAILED"));
                    sizes.truncate(k);
                    break;
                }
                Err(error) => return Err(error),
            }
        }
    }
    sizes.iter().map(Size::result).collect()
}
