//! Whole certificates: against a CGAL program of the same checks, by two threads against one, and the checker.

use std::time::Instant;

use homeo::certify::{Claim, Options, Outcome, Silent, Verdict, certify};
use homeo_benches::cgal::{Answer, Cgal, Files};
use homeo_benches::generate::{Generated, initial, simplified};
use homeo_benches::run::{checker_inputs, on_threads, whole};
use homeo_benches::subject::Subject;
use serde_json::json;

use crate::error::{PeersError, Res};
use crate::plan::{NOT_BUILT, Plan};
use crate::report::{Asked, Report, Row};

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    // 8 f^2 triangles in about as many prisms, and 16 * 8 f^2 in 8 f^2.
    let inputs = [
        ("before simplification", initial(plan.options.size(158, 20))),
        ("after simplification", simplified(plan.options.size(40, 6), 2)),
    ];
    for (name, input) in inputs {
        let times = measure(plan, &input)?;
        let name =
            format!("{} triangles, {} prisms, {name}", input.mesh.faces.len(), input.shell.faces.len());
        rows(&name, &times, report);
        report.data(&format!("seconds of the CGAL program, {name}"), json!(times.parts));
    }
    pieces(plan, report)
}

/// Seconds by round.
#[derive(Default)]
struct Times {
    /// All claims, by one thread and two.
    certify: [Vec<f64>; 2],
    /// C1 to C4, by one thread.
    c1_to_c4: Vec<f64>,
    check: [Vec<f64>; 2],
    /// By the programs of CGAL: C1 to C4, all.
    cgal: [[Vec<f64>; 2]; 2],
    /// What CGAL spent on its parts, from the last round.
    parts: Vec<(String, f64)>,
}

/// The parts of CGAL's program; the last is not in C1 to C4.
const PARTS: [&str; 6] =
    ["c1_seconds", "contact_seconds", "layer_seconds", "fibre_seconds", "piece_seconds", "self_seconds"];
const PROGRAMS: [(&str, &str); 2] = [
    ("CGAL program, verdicts alone", "certify"),
    ("CGAL program, verdicts alone, -march=native", "certify_native"),
];

fn measure(plan: &Plan, input: &Generated) -> Res<Times> {
    let documents = checker_inputs(input)?;
    let files = plan.cgal.as_ref().map(|_| Files::new(&input.shell, Some(&input.mesh))).transpose()?;
    let mut programs = Vec::new();
    if let (Some(cgal), Some(files)) = (&plan.cgal, &files) {
        for (_, program) in PROGRAMS {
            programs.push(start(cgal, program, &[], files)?);
        }
    }
    let mut times = Times::default();
    for round in 0..plan.options.few_rounds() {
        eprintln!("  round {}", round + 1);
        let (outcome, seconds) = on_threads(1, || whole(input))??;
        times.certify[0].push(seconds);
        let (again, seconds) = on_threads(2, || whole(input))??;
        times.certify[1].push(seconds);
        if again.certificate != outcome.certificate {
            return Err(PeersError::Disagrees {
                who: "two threads".to_owned(),
                what: "another certificate".to_owned(),
            });
        }
        times.c1_to_c4.push(c1_to_c4(input)?);
        for (k, check) in times.check.iter_mut().enumerate() {
            check.push(checked(k + 1, &outcome, &documents)?);
        }
        for (program, cgal) in programs.iter_mut().zip(&mut times.cgal) {
            let answer = program.turn()?;
            agree(program.name(), &answer, &outcome)?;
            let parts = PARTS.iter().map(|part| answer.get::<f64>(part)).collect::<Result<Vec<f64>, _>>()?;
            let all: f64 = parts.iter().sum();
            cgal[0].push(all - parts[PARTS.len() - 1]);
            cgal[1].push(all);
            times.parts = PARTS.iter().map(ToString::to_string).zip(parts).collect();
        }
    }
    Ok(times)
}

/// The seconds of C1 to C4 with their certificate, by one thread.
fn c1_to_c4(input: &Generated) -> Res<f64> {
    let options = Options { claims: vec![Claim::SectionAllOrders], ..Options::default() };
    let start = Instant::now();
    on_threads(1, || certify(&input.shell, Some(&input.mesh), &options, &Silent))??;
    Ok(start.elapsed().as_secs_f64())
}

/// Against a CGAL program that also has what a proof of C2 needs: every triangle cut by the tets, exactly. It is so slow that
/// one round on a small input must do.
fn pieces(plan: &Plan, report: &mut Report) -> Res {
    let peer = "CGAL program, with the section's exact pieces";
    for (name, input) in [("before", initial(12)), ("after", simplified(4, 2))] {
        let what = format!("C1-C4 whole, {} triangles, {name} simplification", input.mesh.faces.len());
        let Some(cgal) = &plan.cgal else {
            report.row(Row::absent(&what, peer, None, NOT_BUILT));
            continue;
        };
        let files = Files::new(&input.shell, Some(&input.mesh))?;
        let mut program = start(cgal, "certify", &["--pieces"], &files)?;
        let ours = c1_to_c4(&input)?;
        let answer = program.turn()?;
        let (outcome, _) = on_threads(1, || whole(&input))??;
        agree(program.name(), &answer, &outcome)?;
        let parts = PARTS[..5].iter().map(|part| answer.get::<f64>(part)).collect::<Result<Vec<f64>, _>>()?;
        report.row(Row::ratio(&what, peer, None, &[parts.iter().sum()], &[ours]));
    }
    Ok(())
}

fn start(cgal: &Cgal, program: &str, options: &[&str], files: &Files) -> Res<Subject> {
    let paths: Vec<_> = files.paths.iter().map(|p| p.to_string_lossy()).collect();
    let paths = paths.iter().map(AsRef::as_ref);
    let arguments: Vec<&str> = options.iter().copied().chain(["--serve"]).chain(paths).collect();
    let mut subject = Subject::start(&cgal.0, program, &arguments)?;
    subject.ready()?;
    Ok(subject)
}

/// The seconds of the checker, which must accept.
pub(crate) fn checked(threads: usize, outcome: &Outcome, documents: &[Vec<u8>]) -> Res<f64> {
    let start = Instant::now();
    let answer = on_threads(threads, || homeo_certs::check(outcome.certificate.as_ref(), documents))?;
    let seconds = start.elapsed().as_secs_f64();
    if answer.status == "valid" {
        return Ok(seconds);
    }
    let what = format!("{} {} {}", answer.status, answer.code, answer.message);
    Err(PeersError::Disagrees { who: "the checker".to_owned(), what })
}

/// CGAL's verdicts are ours: what it shows is certified, and it shows all of that.
fn agree(who: &str, answer: &Answer, outcome: &Outcome) -> Res {
    for claim in &outcome.claims {
        let key = match claim.claim {
            Claim::Positivity => "positivity",
            Claim::Section | Claim::Bijection | Claim::SectionAllOrders => "section",
            Claim::Disjoint => "disjoint",
            Claim::I2 => "i2",
            Claim::DisjointPrisms => continue,
        };
        if (answer.get::<u8>(key)? == 1) != (claim.verdict == Verdict::Certified) {
            let what = format!("{} is {} here", claim.claim, claim.verdict);
            return Err(PeersError::Disagrees { who: who.to_owned(), what });
        }
    }
    Ok(())
}

fn rows(name: &str, times: &Times, report: &mut Report) {
    let asked = Some(Asked::AtLeast(5.0));
    for ((peer, _), cgal) in PROGRAMS.iter().zip(&times.cgal) {
        let kinds = [("C1-C4 whole", &times.c1_to_c4, asked), ("all claims whole", &times.certify[0], None)];
        for ((what, ours, asked), theirs) in kinds.into_iter().zip(cgal) {
            let what = format!("{what}, {name}");
            report.row(if theirs.is_empty() {
                Row::absent(&what, peer, asked, NOT_BUILT)
            } else {
                Row::ratio(&what, peer, asked, theirs, ours)
            });
        }
    }
    let [one, two] = &times.certify;
    report.row(Row::ratio(
        &format!("certify, two threads, {name}"),
        "one thread",
        Some(Asked::AtLeast(1.8)),
        one,
        two,
    ));
    let words = ["one thread", "two threads"];
    for ((word, certify), check) in words.iter().zip(&times.certify).zip(&times.check) {
        let what = format!("check, {word}, {name}");
        report.row(Row::ratio(&what, "certify", Some(Asked::AtLeast(1.0)), certify, check));
    }
}
