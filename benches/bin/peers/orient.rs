//! Single calls of orient3d against CGAL, three crates, plain doubles, and rational numbers.

use std::hint::black_box;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use homeo_benches::quads::{IMPLEMENTATIONS, Implementation, Kind, Quad, ours, quads};
use homeo_benches::ratio::{Side, take_turns};
use homeo_benches::subject::Subject;

use crate::error::{PeersError, Res};
use crate::plan::{NOT_BUILT, Plan};
use crate::rationals;
use crate::report::{Asked, Report, Row};

/// What is asked of one kind of input against EPICK.
fn asked(kind: Kind) -> Asked {
    Asked::AtLeast(if kind == Kind::Random { 1.5 } else { 8.0 })
}

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    for kind in Kind::ALL {
        let inputs = quads(kind, plan.options.size(100_000, 5_000));
        fast(plan, kind, &inputs, report)?;
        slow(plan, kind, &inputs[..plan.options.size(2_000, 100)], report)?;
    }
    Ok(())
}

/// The sum of all signs, and the seconds a call. Every input is hidden from the optimiser: calls stay single.
fn timed(implementation: Implementation, inputs: &[Quad]) -> (i64, f64) {
    let start = Instant::now();
    let sum = inputs.iter().map(|q| i64::from(implementation(black_box(q)))).sum();
    (sum, start.elapsed().as_secs_f64() / inputs.len() as f64)
}

fn side<'a>(implementation: Implementation, inputs: &'a [Quad]) -> Side<'a, PeersError> {
    Box::new(move || {
        let (sum, seconds) = timed(implementation, inputs);
        black_box(sum);
        Ok(seconds)
    })
}

/// A CGAL program that has the inputs and says the same signs.
pub(crate) fn cgal_side<'a>(mut program: Subject, count: usize, wanted: [u64; 2]) -> Side<'a, PeersError> {
    Box::new(move || {
        let answer = program.turn()?;
        let found = [answer.get::<u64>("positive")?, answer.get::<u64>("zero")?];
        if found != wanted {
            let what = format!("{found:?} of {count} signs positive and zero, not {wanted:?}");
            return Err(PeersError::Disagrees { who: program.name().to_owned(), what });
        }
        Ok(answer.get::<f64>("seconds")? / count as f64)
    })
}

const CGAL: [(&str, &str); 3] = [
    ("CGAL EPICK", "orient_epick"),
    ("CGAL EPICK, -march=native", "orient_epick_native"),
    ("CGAL EPECK", "orient_epeck"),
];

fn fast(plan: &Plan, kind: Kind, inputs: &[Quad], report: &mut Report) -> Res {
    let what = format!("orient3d, {}, one call", kind.name());
    let signs: Vec<i8> = inputs.iter().map(ours).collect();
    let count = |sign: i8| signs.iter().filter(|&&s| s == sign).count() as u64;
    let mut names = vec!["homeo".to_owned()];
    let mut sides = vec![side(ours, inputs)];
    for (name, program) in CGAL {
        let asked = (name != "CGAL EPECK").then(|| asked(kind));
        let Some(cgal) = &plan.cgal else {
            report.row(Row::absent(&what, name, asked, NOT_BUILT));
            continue;
        };
        let mut program = Subject::start(&cgal.0, program, &[])?;
        program.send_line(&format!("quads {}", inputs.len()))?;
        program.send_numbers(inputs.as_flattened().as_flattened())?;
        program.ready()?;
        names.push(name.to_owned());
        sides.push(cgal_side(program, inputs.len(), [count(1), count(0)]));
    }
    for (name, implementation) in IMPLEMENTATIONS.into_iter().skip(1) {
        let wrong = inputs.iter().zip(&signs).filter(|(q, s)| implementation(q) != **s).count();
        names.push(if wrong == 0 {
            name.to_owned()
        } else {
            format!("{name} ({wrong} of {} signs wrong)", inputs.len())
        });
        sides.push(side(implementation, inputs));
    }
    let times = take_turns(plan.options.rounds, true, &mut sides)?;
    for (name, theirs) in names.iter().zip(&times).skip(1) {
        let asked = name.starts_with("CGAL EPICK").then(|| asked(kind));
        report.row(Row::ratio(&what, name, asked, theirs, &times[0]));
    }
    Ok(())
}

/// Against numbers that need microseconds; on fewer inputs.
fn slow(plan: &Plan, kind: Kind, inputs: &[Quad], report: &mut Report) -> Res {
    let what = format!("orient3d, {}, one call", kind.name());
    let mut names = vec!["homeo".to_owned()];
    let mut sides = vec![side(ours, inputs)];
    for (name, implementation) in rationals::all() {
        let against = format!("rationals, {name}");
        let Some(implementation) = implementation else {
            report.row(Row::absent(&what, &against, None, NOT_BUILT));
            continue;
        };
        if let Some(q) = inputs.iter().find(|q| implementation(q) != ours(q)) {
            return Err(PeersError::Disagrees { who: name.to_owned(), what: format!("{q:?}") });
        }
        names.push(against);
        sides.push(side(implementation, inputs));
    }
    match python(&inputs[..inputs.len() / 4]) {
        Ok(side) => {
            names.push("rationals, Python fractions".to_owned());
            sides.push(side);
        }
        Err(error) => {
            eprintln!("SKIPPED: Python fractions: {error}");
            report.row(Row::absent(&what, "rationals, Python fractions", None, "no python3"));
        }
    }
    let times = take_turns(plan.options.few_rounds(), true, &mut sides)?;
    for (name, theirs) in names.iter().zip(&times).skip(1) {
        report.row(Row::ratio(&what, name, None, theirs, &times[0]));
    }
    Ok(())
}

/// `reference/subjects/exact.py`: the pipe counts, but is short beside the work.
fn python(inputs: &[Quad]) -> Res<Side<'_, PeersError>> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reference/subjects/exact.py");
    let mut command = Command::new("python3");
    let mut program =
        Subject::spawn("exact.py".to_owned(), command.args(["-B"]).arg(script).arg("--binary"))?;
    let numbers = inputs.as_flattened().as_flattened();
    let mut ask = move || -> Res<f64> {
        let start = Instant::now();
        program.send("orient3d", inputs.len(), numbers)?;
        let signs = program.signs(inputs.len())?;
        let seconds = start.elapsed().as_secs_f64() / inputs.len() as f64;
        match inputs.iter().zip(signs).find(|(q, s)| ours(q) != *s) {
            Some((q, _)) => Err(PeersError::Disagrees { who: "exact.py".to_owned(), what: format!("{q:?}") }),
            None => Ok(seconds),
        }
    };
    // Is it there, and right?
    ask()?;
    Ok(Box::new(ask))
}
