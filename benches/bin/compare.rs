//! One run that measures homeo beside its peers, turn by turn, and writes the ratios to `benches/RESULTS.md`.
//!
//!     homeo-compare [ROUNDS]

use std::error::Error;
use std::fmt::Write;
use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use homeo::certify::Claim;
use homeo::shell::{Shell, hdf5};
use homeo_benches::cgal::{Cgal, Files};
use homeo_benches::generate::{Generated, initial, same, simplified};
use homeo_benches::quads::{IMPLEMENTATIONS, Kind, quads};
use homeo_benches::real;
use homeo_benches::results;
use homeo_benches::run::{checker_inputs, on_one_thread, positivity, signs_alone, whole};
use homeo_benches::table::{Table, median, smallest};

type Res<T = ()> = Result<T, Box<dyn Error>>;

fn main() -> Res {
    let rounds: usize = std::env::args().nth(1).map_or(Ok(7), |a| a.parse())?;
    let load =
        || std::fs::read_to_string("/proc/loadavg").unwrap_or_default().chars().take(14).collect::<String>();
    let before = load();
    let cgal = Cgal::build();
    let mut report = String::from(
        "## Side by side\n\nWritten by `benches/compare.sh`, never by hand. One thread. Within a row everything ran turn by turn in one \
         run; ratios are medians over the rounds of the ratio within a round, so that other load falls on both sides. \
         Absolute times hold for one machine and its load.\n",
    );
    predicates(rounds, &mut report)?;
    c1(rounds, cgal.as_ref(), &mut report)?;
    claims_and_checker(rounds.div_ceil(2), &mut report)?;
    let cores = std::thread::available_parallelism()?;
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let cpu = cpu.lines().find_map(|l| l.strip_prefix("model name")).unwrap_or(": unknown");
    writeln!(
        report,
        "\n{rounds} rounds (half as many for whole runs). Processor{cpu}, {cores} cores; load average {} at the start, {} at the end.",
        before.trim(),
        load().trim()
    )?;
    print!("{report}");
    results::put("compare", &report)?;
    Ok(())
}

fn predicates(rounds: usize, report: &mut String) -> Res {
    let mut table = Table::new(&[
        "orient3d",
        "homeo ns",
        "geometry-predicates ns (ratio)",
        "robust ns (ratio)",
        "signs differ",
    ]);
    for kind in Kind::ALL {
        let inputs = quads(kind, 100_000);
        let mut times = vec![Vec::new(); IMPLEMENTATIONS.len()];
        for _ in 0..rounds {
            for ((_, implementation), times) in IMPLEMENTATIONS.iter().zip(&mut times) {
                let start = Instant::now();
                black_box(inputs.iter().map(|q| i64::from(implementation(black_box(q)))).sum::<i64>());
                times.push(start.elapsed().as_nanos() as f64 / inputs.len() as f64);
            }
        }
        let differ = |q: &&_| IMPLEMENTATIONS.iter().any(|(_, f)| f(q) != IMPLEMENTATIONS[0].1(q));
        let against = |k: usize| format!("{:.1} ({:.2})", median(&times[k]), ratio(&times[k], &times[0]));
        let cells = [kind.name().to_owned(), format!("{:.1}", median(&times[0])), against(1), against(2)];
        let differing = inputs.iter().filter(differ).count();
        table.row(cells.into_iter().chain([format!("{differing} of {}", inputs.len())]).collect());
    }
    write!(
        report,
        "\n## Orientation of four points\n\nA ratio above 1: homeo is faster.\n\n{}",
        table.render()
    )?;
    Ok(())
}

/// The median over the rounds of `other / ours`.
fn ratio(other: &[f64], ours: &[f64]) -> f64 {
    median(&other.iter().zip(ours).map(|(a, b)| a / b).collect::<Vec<_>>())
}

fn c1(rounds: usize, cgal: Option<&Cgal>, report: &mut String) -> Res {
    let mut inputs: Vec<(String, Shell)> = vec![("generated, same:160".to_owned(), same(160).shell)];
    for path in real::shells().iter().filter(|p| p.to_string_lossy().ends_with(".init")) {
        let shell = hdf5::read(path)?.shell;
        if shell.faces.len() >= 10_000 {
            inputs.push((real::name(path), shell));
        }
    }
    let columns = [
        "shell",
        "prisms",
        "tets",
        "homeo M tets/s (best)",
        "homeo, signs alone",
        "CGAL EPICK M tets/s (best)",
        "CGAL s / homeo s",
        "CGAL s / signs alone s",
    ];
    let mut table = Table::new(&columns);
    for (name, shell) in inputs {
        let files = cgal.map(|_| Files::new(&shell, None)).transpose()?;
        let (mut ours, mut signs, mut theirs, mut tets) = (Vec::new(), Vec::new(), Vec::new(), 0);
        for _ in 0..rounds {
            let (count, seconds) = on_one_thread(|| positivity(&shell))??;
            tets = count;
            ours.push(seconds);
            let (bad, seconds) = signs_alone(&shell);
            signs.push(seconds);
            if bad != 0 {
                return Err(format!("{name}: {bad} tets are not positive").into());
            }
            if let (Some(cgal), Some(files)) = (cgal, &files) {
                let answer = cgal.run("c1", &[], &files.paths)?;
                if answer.get::<u64>("tets")? != tets {
                    return Err(format!("{name}: CGAL counts other tets than homeo").into());
                }
                theirs.push(answer.get("min_seconds")?);
            }
        }
        let rate = |times: &[f64]| {
            format!("{:.1} ({:.1})", tets as f64 / median(times) / 1e6, tets as f64 / smallest(times) / 1e6)
        };
        let peer = if theirs.is_empty() {
            ["not built".to_owned(), String::new(), String::new()]
        } else {
            [rate(&theirs), format!("{:.2}", ratio(&theirs, &ours)), format!("{:.2}", ratio(&theirs, &signs))]
        };
        let cells = [name, shell.faces.len().to_string(), tets.to_string(), rate(&ours), rate(&signs)];
        table.row(cells.into_iter().chain(peer).collect());
    }
    write!(
        report,
        "\n## Claim `positivity` alone\n\nAsked for: 1.5 M tets/s. Both on the same coordinates, signs only.\n\n{}",
        table.render()
    )?;
    Ok(())
}

/// Real files to certify and check: before simplification, and after it.
const REAL: [&str; 4] = ["bunny.off.h5.init", "c_homer.obj.h5.init", "bunny.off.h5", "fandisk.off.h5"];

fn claims_and_checker(rounds: usize, report: &mut String) -> Res {
    let columns = [
        "input",
        "mesh triangles",
        "prisms",
        "certify s",
        "check s",
        "check / certify",
        "peak MiB of certify",
        "certificate MB",
    ];
    let mut table = Table::new(&columns);
    let mut parts = Table::new(&["input", "claim", "verdict", "s"]);
    let mut inputs = vec![
        ("initial:50".to_owned(), initial(50)),
        ("same:30".to_owned(), same(30)),
        ("simplified:16".to_owned(), simplified(16, 2)),
    ];
    for path in real::shells() {
        if REAL.contains(&real::name(&path).as_str()) {
            let file = hdf5::read(&path)?;
            let mesh = file.mesh.ok_or("a shell file without a mesh")?;
            inputs.push((path.to_string_lossy().into_owned(), Generated { shell: file.shell, mesh }));
        }
    }
    for (argument, input) in &inputs {
        let name = real::name(Path::new(argument));
        let files = checker_inputs(input)?;
        let (mut certify, mut check, mut outcome) = (Vec::new(), Vec::new(), None);
        for _ in 0..rounds {
            let (result, seconds) = on_one_thread(|| whole(input))??;
            certify.push(seconds);
            let start = Instant::now();
            let answer = homeo_certs::check(result.certificate.as_ref(), &files);
            check.push(start.elapsed().as_secs_f64());
            if answer.status != "valid" {
                return Err(format!(
                    "{name}: the checker says {} {} {}",
                    answer.status, answer.code, answer.message
                )
                .into());
            }
            outcome = Some(result);
        }
        let outcome = outcome.ok_or("no round")?;
        for claim in outcome.claims.iter().filter(|c| c.claim != Claim::Bijection) {
            let cells = [&name, claim.claim.name(), claim.verdict.word()].map(str::to_owned);
            parts.row(cells.into_iter().chain([format!("{:.3}", claim.seconds)]).collect());
        }
        table.row(row(argument, input, &certify, &check, outcome.certificate.len())?);
    }
    write!(
        report,
        "\n## All claims, and the checker\n\nAsked for: initial:50 under 10 s and 1 GiB, and a ratio below 1.\n\n{}\n{}",
        table.render(),
        parts.render()
    )?;
    Ok(())
}

fn row(argument: &str, input: &Generated, certify: &[f64], check: &[f64], bytes: usize) -> Res<Vec<String>> {
    // A process of its own, so that only the certifier's memory counts.
    let output =
        Command::new(std::env::current_exe()?.with_file_name("homeo-profile")).arg(argument).output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let peak = text.lines().find_map(|l| l.strip_prefix("peak_mib=")).unwrap_or("unknown");
    Ok(vec![
        real::name(Path::new(argument)),
        input.mesh.faces.len().to_string(),
        input.shell.faces.len().to_string(),
        format!("{:.2}", median(certify)),
        format!("{:.2}", median(check)),
        format!("{:.2}", ratio(check, certify)),
        peak.to_owned(),
        format!("{:.1}", bytes as f64 / 1e6),
    ])
}
