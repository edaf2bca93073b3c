//! Claim C1 against CGAL's EPICK in a loop over the same file.

use homeo::shell::{Shell, hdf5};
use homeo_benches::cgal::{Cgal, Files};
use homeo_benches::generate::same;
use homeo_benches::ratio::{Side, take_turns};
use homeo_benches::real;
use homeo_benches::run::{on_one_thread, positivity, signs_alone};
use homeo_benches::subject::Subject;
use homeo_benches::table::{Table, median};

use crate::error::{PeersError, Res};
use crate::plan::{NOT_BUILT, Plan};
use crate::report::{Asked, Report, Row};

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let mut table = Table::new(&[
        "shell",
        "prisms",
        "tets",
        "homeo M tets/s",
        "signs one by one",
        "EPICK",
        "EPICK native",
    ]);
    // 8 f^2 prisms: 1,002,528.
    let shell = same(plan.options.size(354, 40)).shell;
    let asked = Some(Asked::AtLeast(4.0));
    one(plan, &format!("C1, generated, {} prisms", shell.faces.len()), &shell, asked, &mut table, report)?;
    let shells: Vec<_> =
        real::shells().into_iter().filter(|p| p.to_string_lossy().ends_with(".init")).collect();
    if shells.is_empty() {
        eprintln!("SKIPPED: C1 on real shells, none in {}", real::data().display());
    }
    for path in shells {
        let shell = hdf5::read(&path)?.shell;
        if shell.faces.len() >= 10_000 {
            one(plan, &format!("C1, {}", real::name(&path)), &shell, None, &mut table, report)?;
        }
    }
    let text = "Millions of tets a second, medians. *Signs one by one* is the same without blocks, certificate and witnesses.";
    report.detail("Claim `positivity` alone", text, &table);
    Ok(())
}

const PROGRAMS: [(&str, &str); 2] =
    [("CGAL EPICK loop", "c1"), ("CGAL EPICK loop, -march=native", "c1_native")];

fn one(
    plan: &Plan,
    what: &str,
    shell: &Shell,
    asked: Option<Asked>,
    table: &mut Table,
    report: &mut Report,
) -> Res {
    let tets = on_one_thread(|| positivity(shell))??.0;
    let ours: Side<'_, PeersError> = Box::new(|| Ok(on_one_thread(|| positivity(shell))??.1));
    let alone: Side<'_, PeersError> = Box::new(|| {
        let (bad, seconds) = signs_alone(shell);
        let what = || format!("{bad} tets are not positive");
        if bad == 0 {
            Ok(seconds)
        } else {
            Err(PeersError::Disagrees { who: "signs alone".to_owned(), what: what() })
        }
    });
    let mut sides = vec![ours, alone];
    let files = plan.cgal.as_ref().map(|_| Files::new(shell, None)).transpose()?;
    if let (Some(cgal), Some(files)) = (&plan.cgal, &files) {
        for (_, program) in PROGRAMS {
            sides.push(cgal_side(cgal, program, files, tets)?);
        }
    }
    let times = take_turns(plan.options.rounds, true, &mut sides)?;
    let cells = times.iter().map(|t| format!("{:.1}", tets as f64 / median(t) / 1e6));
    let name = what.trim_start_matches("C1, ").to_owned();
    table.row([name, shell.faces.len().to_string(), tets.to_string()].into_iter().chain(cells).collect());
    for (k, (name, _)) in PROGRAMS.into_iter().enumerate() {
        report.row(match times.get(k + 2) {
            Some(theirs) => Row::ratio(what, name, asked, theirs, &times[0]),
            None => Row::absent(what, name, asked, NOT_BUILT),
        });
    }
    Ok(())
}

/// CGAL's loop, which must find as many tets, all positive.
fn cgal_side<'a>(cgal: &Cgal, program: &str, files: &Files, tets: u64) -> Res<Side<'a, PeersError>> {
    let paths: Vec<_> = files.paths.iter().map(|p| p.to_string_lossy()).collect();
    let arguments: Vec<&str> = std::iter::once("--serve").chain(paths.iter().map(AsRef::as_ref)).collect();
    let mut subject = Subject::start(&cgal.0, program, &arguments)?;
    subject.ready()?;
    Ok(Box::new(move || {
        let answer = subject.turn()?;
        let found = [answer.get::<u64>("tets")?, answer.get::<u64>("not_positive")?];
        if found == [tets, 0] {
            return Ok(answer.get("seconds")?);
        }
        let what = format!("{found:?} tets and tets that are not positive, not {tets} and 0");
        Err(PeersError::Disagrees { who: subject.name().to_owned(), what })
    }))
}
