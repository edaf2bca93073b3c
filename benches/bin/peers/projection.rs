//! The projection of a point: exact against CGAL's exact constructions, and in doubles against the exact one.

use std::collections::BTreeSet;
use std::hint::black_box;
use std::time::Instant;

use homeo::projection::{Projection, Rat, ShellPoint};
use homeo::shell::VertexOrder;
use homeo_benches::generate::{offset_shell, sphere};
use homeo_benches::prism;
use homeo_benches::random::Random;
use homeo_benches::ratio::{Side, take_turns};
use homeo_benches::run::on_one_thread;
use homeo_benches::subject::Subject;

use crate::error::{PeersError, Res};
use crate::plan::{NOT_BUILT, Plan};
use crate::report::{Asked, Report, Row};

/// A program of exact constructions: what it is, its options, and what is asked against it.
const CGAL: [(&str, &[&str], f64); 4] = [
    ("CGAL Gmpq, field followed", &["--gmpq"], 20.0),
    ("CGAL Gmpq, barycentric sums", &["--gmpq", "--sums"], 20.0),
    ("CGAL EPECK forced exact, field followed", &[], 10.0),
    ("CGAL EPECK forced exact, barycentric sums", &["--sums"], 10.0),
];

/// How often all points are projected in one measurement.
const PASSES: usize = 10;

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let shell = offset_shell(&sphere(plan.options.size(50, 12)), 0.3);
    let projection = Projection::new(&shell, &VertexOrder::Id)?;
    let cases = cases(&projection, plan.options.size(2_000, 200));
    exact(plan, &projection, &cases, report)?;
    float(&projection, &cases, report)?;
    batch(plan, &projection, &self::cases(&projection, plan.options.size(200_000, 2_000)), report)
}

/// A point, and a prism that holds it.
type Case = (u32, [f64; 3]);

/// Points anywhere in random tets.
fn cases(projection: &Projection<'_>, count: usize) -> Vec<Case> {
    let mut random = Random(4);
    let tets = projection.tets();
    let case = |_| {
        let tet = tets[random.below(tets.len())];
        let corners = tet.names.map(|name| *projection.shell().position(name));
        let parts = [0; 4].map(|_| random.unit());
        let sum: f64 = parts.iter().sum();
        let p = [0, 1, 2].map(|axis| (0..4).map(|k| parts[k] / sum * corners[k][axis]).sum::<f64>());
        (tet.prism, p)
    };
    // Rounding may move a point out of its tet, and even out of the shell.
    (0..count).map(case).filter(|(_, p)| projection.is_inside_f64(p)).collect()
}

/// The seconds of one point. Several passes over all points: one would be over in less than a millisecond.
fn ours<'a>(cases: &'a [Case], project: impl Fn(u32, &[f64; 3]) + 'a) -> Side<'a, PeersError> {
    Box::new(move || {
        let start = Instant::now();
        for _ in 0..PASSES {
            cases.iter().for_each(|(prism, p)| project(*prism, black_box(p)));
        }
        Ok(start.elapsed().as_secs_f64() / (PASSES * cases.len()) as f64)
    })
}

/// What is expected of the programs, and what they are sent.
fn questions(projection: &Projection<'_>, cases: &[Case]) -> Res<(Vec<BTreeSet<String>>, Vec<f64>)> {
    let shell = projection.shell();
    let ranks = VertexOrder::Id.ranks(shell.vertex_count());
    let (mut answers, mut numbers) = (Vec::new(), Vec::new());
    for (id, p) in cases {
        let corners = prism::corners(shell, &ranks, *id);
        let written = |image: &ShellPoint| prism::written(shell, image, corners);
        let [x, y, z] = p.map(|x| Rat::try_from(x).unwrap_or(Rat::ZERO));
        let images = projection.project_all(&[x, y, z]);
        let wanted: BTreeSet<String> = images.iter().filter_map(written).collect();
        let found = projection.images_in(*id, p);
        if found.iter().filter_map(|image| written(&image.to_point())).collect::<BTreeSet<_>>() != wanted {
            let what = format!("{p:?} in prism {id}: not {wanted:?}");
            return Err(PeersError::Disagrees { who: "images_in".to_owned(), what });
        }
        answers.push(wanted);
        numbers.extend(prism::numbers(shell, corners, p));
    }
    Ok((answers, numbers))
}

/// What is done here for a point, as a row says it. The first is what CGAL's programs do: they are told the prism, and find
/// all images in it.
const OURS: [&str; 4] = [
    "exact projection of a point",
    "the same in lowest terms",
    "the same, the prism to be found, too",
    "the same in lowest terms, the prism to be found, too",
];

fn exact(plan: &Plan, projection: &Projection<'_>, cases: &[Case], report: &mut Report) -> Res {
    let (answers, numbers) = questions(projection, cases)?;
    let (answers, numbers) = (&answers, &numbers);
    let mut sides = vec![
        ours(cases, |prism, p| drop(black_box(projection.images_in(prism, p)))),
        ours(cases, |prism, p| {
            projection.images_in(prism, p).iter().for_each(|image| drop(black_box(image.to_point())));
        }),
        ours(cases, |_, p| drop(black_box(projection.image(p)))),
        ours(cases, |_, p| drop(black_box(projection.project_exactly(p)))),
    ];
    if let Some(cgal) = &plan.cgal {
        for (_, options, _) in CGAL {
            let mut subject = Subject::start(&cgal.0, "projection", options)?;
            sides.push(Box::new(move || {
                subject.send("timed", answers.len(), numbers)?;
                let first = subject.line()?;
                let seconds: Option<f64> = first.strip_prefix("seconds=").and_then(|s| s.parse().ok());
                for (i, wanted) in answers.iter().enumerate() {
                    let line = subject.line()?;
                    if prism::parse(&line).map(|(_, images)| images).as_ref() != Some(wanted) {
                        let what = format!("point {i}: {line}, not {wanted:?}");
                        return Err(PeersError::Disagrees { who: subject.name().to_owned(), what });
                    }
                }
                let text = format!("no time in `{first}`");
                let none = PeersError::Program { program: "projection", argument: options.join(" "), text };
                Ok(seconds.ok_or(none)? / answers.len() as f64)
            }));
        }
    }
    let times = take_turns(plan.options.rounds, true, &mut sides)?;
    for (k, (name, _, factor)) in CGAL.into_iter().enumerate() {
        for (i, what) in OURS.into_iter().enumerate() {
            let asked = (i == 0).then_some(Asked::AtLeast(factor));
            report.row(match times.get(k + OURS.len()) {
                Some(theirs) => Row::ratio(what, name, asked, theirs, &times[i]),
                None => Row::absent(what, name, asked, NOT_BUILT),
            });
        }
    }
    Ok(())
}

/// Ways to project in doubles; to be compared with the exact one.
fn float(projection: &Projection<'_>, cases: &[Case], report: &mut Report) -> Res {
    let mut worst = [0.0, 0.0];
    for (_, p) in cases {
        for (w, x) in worst.iter_mut().zip(error(projection, p)?) {
            *w = f64::max(*w, x);
        }
    }
    let meaning =
        format!("largest error / its stated bound; {} points, largest error {:.1e}", cases.len(), worst[1]);
    report.row(Row::value(
        "f64 projection: error",
        "own exact path",
        Some(Asked::AtMost(1.0)),
        worst[0],
        &meaning,
    ));
    Ok(())
}

/// Many points at once: neighbours in space follow upon each other by chance alone.
fn batch(plan: &Plan, projection: &Projection<'_>, cases: &[Case], report: &mut Report) -> Res {
    let points: Vec<[f64; 3]> = cases.iter().map(|(_, p)| *p).collect();
    let single = |p: &[f64; 3]| projection.project_f64(p);
    if !on_one_thread(|| projection.project_batch_f64(&points))?.into_iter().eq(points.iter().map(single)) {
        let what = "a batch is not its single calls".to_owned();
        return Err(PeersError::Disagrees { who: "f64 projection".to_owned(), what });
    }
    let each = |project: &dyn Fn(&[f64; 3])| {
        let start = Instant::now();
        points.iter().for_each(|p| project(black_box(p)));
        Ok(start.elapsed().as_secs_f64() / points.len() as f64)
    };
    let together = || {
        let start = Instant::now();
        drop(black_box(projection.project_batch_f64(black_box(&points))));
        start.elapsed().as_secs_f64() / points.len() as f64
    };
    let mut sides: Vec<Side<'_, PeersError>> = vec![
        Box::new(|| Ok(on_one_thread(together)?)),
        Box::new(|| Ok(together())),
        Box::new(|| {
            each(&|p| {
                black_box(projection.project_f64(p));
            })
        }),
        Box::new(|| each(&|p| drop(black_box(projection.image(p))))),
        Box::new(|| each(&|p| drop(black_box(projection.project_exactly(p))))),
    ];
    let times = take_turns(plan.options.rounds, true, &mut sides)?;
    let exactly = ["own exact path", "own exact path, lowest terms"];
    let threads = rayon::current_num_threads();
    for (what, ours) in [
        ("f64 projection, one point".to_owned(), 2),
        (format!("f64 projection, batched, {} points", points.len()), 0),
        (format!("f64 projection, batched, {} points, {threads} threads", points.len()), 1),
    ] {
        for (own, theirs) in exactly.into_iter().zip(3..) {
            report.row(Row::ratio(&what, own, None, &times[theirs], &times[ours]));
        }
        if ours < 2 {
            report.row(Row::ratio(&what, "single calls", None, &times[2], &times[ours]));
        }
    }
    Ok(())
}

/// The largest error of the four numbers, as a share of the stated bound, and itself. Both are computed exactly and then
/// rounded to doubles.
fn error(projection: &Projection<'_>, p: &[f64; 3]) -> Res<[f64; 2]> {
    let wrong = |what: &str| PeersError::Disagrees {
        who: "f64 projection".to_owned(),
        what: format!("{p:?}: {what}"),
    };
    let (Some(exact), Some(float)) = (projection.project_exactly(p), projection.project_f64(p)) else {
        return Err(wrong("no image"));
    };
    if exact.prism != float.prism {
        return Err(wrong("another prism"));
    }
    let pairs = exact.weights.iter().zip(float.weights).chain([(&exact.height, float.height)]);
    let mut largest = Rat::ZERO;
    for (exact, float) in pairs {
        let difference = Rat::try_from(float).map_err(|_| wrong("not finite"))? - exact;
        largest = largest.max(if difference < Rat::ZERO { -difference } else { difference });
    }
    let bound = Rat::try_from(float.error).map_err(|_| wrong("a bound that is not finite"))?;
    if largest > bound {
        return Err(wrong("an error above its bound"));
    }
    Ok([(&largest / bound).to_f64().value(), largest.to_f64().value()])
}
