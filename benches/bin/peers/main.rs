//! homeo beside its peers, in one run: predicates, C1, projections, whole certificates; growth, memory and stages.
//!
//! Whatever a row compares took turns with it, round by round. Answers are compared, too: a peer that is exact and says
//! something else ends the run.

mod batch;
mod error;
mod growth;
mod long;
mod orient;
mod plan;
mod positivity;
mod projection;
mod rationals;
mod real;
mod report;
mod stages;
mod whole;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use homeo::predicate::batch::Level;
use homeo_benches::cgal::Cgal;
use homeo_benches::results;
use serde_json::json;

use error::{PeersError, Res};
use plan::{Options, Part, Plan};
use report::Report;

fn main() -> ExitCode {
    let options = Options::parse();
    eprintln!("peers: building the CGAL programs");
    let cgal = Cgal::build(&["peers"]);
    if cgal.is_none() {
        eprintln!("SKIPPED: every row about CGAL");
    }
    match run(&Plan { options, cgal }) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

type Work = fn(&Plan, &mut Report) -> Res;

const PARTS: [(Part, &str, Work); 9] = [
    (Part::Orient3d, "orient3d", orient::run),
    (Part::Batch, "orient3d, batched", batch::run),
    (Part::Positivity, "claim positivity", positivity::run),
    (Part::Projection, "projection", projection::run),
    (Part::Whole, "all claims", whole::run),
    (Part::Real, "real shells", real::run),
    (Part::Growth, "growth", growth::run),
    (Part::Long, "a long certificate", long::run),
    (Part::Stages, "stages", stages::run),
];

fn run(plan: &Plan) -> Res {
    let start = Instant::now();
    let load =
        || std::fs::read_to_string("/proc/loadavg").unwrap_or_default().chars().take(14).collect::<String>();
    let before = load();
    let mut report = Report::default();
    for (_, name, work) in PARTS.iter().filter(|(part, ..)| plan.options.wants(*part)) {
        eprintln!("peers: {name} ({:.0} s so far)", start.elapsed().as_secs_f64());
        work(plan, &mut report)?;
    }
    let (seconds, after) = (start.elapsed().as_secs_f64(), load());
    let rounds = plan.options.rounds;
    let few = plan.options.few_rounds();
    let head = "## Side by side\n\nWritten by `just peers`, never by hand (also [JSON](peers.json)). One thread unless said. Whatever \
                a row compares ran turn by turn in one run. *Measured* is the median over the rounds of the time of the other \
                divided by homeo's within a round, unless said: above 1, homeo is faster. Answers were compared as well. Absolute \
                times hold for one machine and its load.";
    let foot = format!(
        "{rounds} rounds ({few} for whole runs); {seconds:.0} s in all. {}; vector instructions up to {:?}. Load average {} at the \
         start, {} at the end.",
        results::machine(),
        Level::widest(),
        before.trim(),
        after.trim()
    );
    let text = report.markdown(head, &foot);
    println!("{text}");
    let about = json!({
        "rounds": rounds,
        "rounds_of_whole_runs": few,
        "quick": plan.options.quick,
        "machine": results::machine(),
        "level": format!("{:?}", Level::widest()),
        "load_at_start": before.trim(),
        "load_at_end": after.trim(),
        "seconds": seconds,
    });
    let path = output("peers.json", &plan.options)?;
    let json = serde_json::to_string_pretty(&report.json(&about))? + "\n";
    std::fs::write(&path, json)
        .map_err(|source| PeersError::Io { what: path.display().to_string(), source })?;
    if plan.options.whole() {
        let put = results::put("peers", &text);
        put.map_err(|source| PeersError::Io { what: "RESULTS.md".to_owned(), source })?;
    }
    eprintln!("peers: {} of the figures asked for not reached; {}", report.missed(), path.display());
    Ok(())
}

/// Where a result goes: beside `RESULTS.md` for the whole comparison, else where nothing is kept.
fn output(name: &str, options: &Options) -> Res<PathBuf> {
    if options.whole() {
        return Ok(results::file(name));
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/peers");
    std::fs::create_dir_all(&folder)
        .map_err(|source| PeersError::Io { what: folder.display().to_string(), source })?;
    Ok(folder.join(name))
}
