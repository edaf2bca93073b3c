//! Batched orient3d against CGAL's EPICK in a loop over the same arrays.

use std::hint::black_box;
use std::time::Instant;

use homeo::predicate::batch::{Level, Points, orient3d_at, orient3d_indexed_at};
use homeo::predicate::{Sign, StageCounts};
use homeo::shell::decomposition::TETS;
use homeo::shell::{Shell, Slab};
use homeo_benches::generate::same;
use homeo_benches::random::Random;
use homeo_benches::ratio::{Side, take_turns};
use homeo_benches::subject::Subject;
use homeo_benches::table::median;
use serde_json::json;

use crate::error::{PeersError, Res};
use crate::orient::cgal_side;
use crate::plan::{NOT_BUILT, Plan};
use crate::report::{Asked, Report, Row};

/// Inputs that stay in the cache nearest to the processor but one.
const CACHED: usize = 4096;

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let count = plan.options.size(10_000_000, 200_000);
    streamed(plan, count, report)?;
    streamed(plan, CACHED, report)?;
    // 24 tets a prism, 8 f^2 prisms.
    indexed(plan, plan.options.size(229, 32), report)
}

fn name(level: Level) -> &'static str {
    match level {
        Level::Baseline => "SSE2",
        Level::Avx2 => "AVX2",
        Level::Avx512 => "AVX-512",
        _ => "another level",
    }
}

/// At least, for streams and for indexed inputs.
fn asked(level: Level) -> [f64; 2] {
    match level {
        Level::Baseline => [2.5, 2.5],
        Level::Avx2 => [3.0, 2.8],
        _ => [4.0, 3.5],
    }
}

/// What is to be asked of the programs: how the data are sent, and the signs that they must find.
struct Peers<'p> {
    plan: &'p Plan,
    send: &'p dyn Fn(&mut Subject) -> Res,
    count: usize,
    wanted: [u64; 2],
}

impl Peers<'_> {
    fn sides<'s>(&self) -> Res<Vec<(&'static str, Side<'s, PeersError>)>> {
        let mut out = Vec::new();
        let programs = [("CGAL EPICK", "orient_epick"), ("CGAL EPICK, -march=native", "orient_epick_native")];
        for (name, program) in programs {
            let Some(cgal) = &self.plan.cgal else { continue };
            let mut subject = Subject::start(&cgal.0, program, &[])?;
            (self.send)(&mut subject)?;
            subject.ready()?;
            out.push((name, cgal_side(subject, self.count, self.wanted)));
        }
        Ok(out)
    }
}

/// Our levels, then CGAL; `work` answers at a level.
fn compare(
    peers: &Peers<'_>,
    what: &str,
    ask: Option<usize>,
    work: &dyn Fn(Level) -> Res<StageCounts>,
    report: &mut Report,
) -> Res {
    let levels = Level::ALL.into_iter().filter(|level| level.is_available());
    let mut sides: Vec<(&str, Side<'_, PeersError>)> = Vec::new();
    for level in levels.clone() {
        let run = move || -> Res<f64> {
            let start = Instant::now();
            black_box(work(level)?);
            Ok(start.elapsed().as_secs_f64() / peers.count as f64)
        };
        sides.push((name(level), Box::new(run)));
    }
    let ours = sides.len();
    sides.extend(peers.sides()?);
    let (names, mut sides): (Vec<&str>, Vec<_>) = sides.into_iter().unzip();
    let rounds =
        if peers.count <= CACHED { 20 * peers.plan.options.rounds } else { peers.plan.options.rounds };
    let times = take_turns(rounds, true, &mut sides)?;
    for (k, level) in Level::ALL.into_iter().enumerate() {
        let what = format!("{what}, {}", name(level));
        let asked = ask.map(|kind| Asked::AtLeast(asked(level)[kind]));
        if k >= ours {
            report.row(Row::absent(&what, "CGAL EPICK", asked, "not on this processor"));
        } else if peers.plan.cgal.is_none() {
            report.row(Row::absent(&what, "CGAL EPICK", asked, NOT_BUILT));
        } else {
            for (name, theirs) in names.iter().zip(&times).skip(ours) {
                report.row(Row::ratio(&what, name, asked, theirs, &times[k]));
            }
        }
    }
    Ok(())
}

/// How the inputs are decided: what a batch costs depends on it.
fn stages(name: &str, found: StageCounts, report: &mut Report) {
    let value = json!({ "filter": found.filter, "fixed_width": found.fixed, "big_integers": found.big });
    report.data(&format!("orient3d, batched, {name}, decided by"), value);
}

fn same_at_all_levels(signs: &[Sign], answer: impl Fn(Level, &mut [Sign]) -> Res<StageCounts>) -> Res {
    for level in Level::ALL.into_iter().filter(|level| level.is_available()) {
        let mut again = vec![Sign::Zero; signs.len()];
        answer(level, &mut again)?;
        if again != signs {
            let what = "another sign than with the instructions of every processor".to_owned();
            return Err(PeersError::Disagrees { who: name(level).to_owned(), what });
        }
    }
    Ok(())
}

fn counts(signs: &[Sign]) -> [u64; 2] {
    [Sign::Positive, Sign::Zero].map(|sign| signs.iter().filter(|s| **s == sign).count() as u64)
}

/// Random points of the unit cube, one array an axis of each of the four points.
fn streamed(plan: &Plan, count: usize, report: &mut Report) -> Res {
    let mut random = Random(6);
    let data: Vec<f64> = (0..12 * count).map(|_| random.unit()).collect();
    let arrays: Vec<&[f64]> = data.chunks_exact(count).collect();
    let point = |k: usize| Points([0, 1, 2].map(|axis| arrays[3 * k + axis]));
    let points = [0, 1, 2, 3].map(point);
    let mut signs = vec![Sign::Zero; count];
    stages(&format!("{count} streamed"), orient3d_at(Level::Baseline, points, &mut signs)?, report);
    let wanted = counts(&signs);
    same_at_all_levels(&signs, |level, again| Ok(orient3d_at(level, points, again)?))?;
    let signs = std::cell::RefCell::new(signs);
    let send = |subject: &mut Subject| {
        subject.send_line(&format!("streams {count}"))?;
        Ok(subject.send_numbers(&data)?)
    };
    let cached = count == CACHED;
    let what = if cached {
        format!("orient3d, batched, {count} streamed again and again (in cache)")
    } else {
        format!("orient3d, batched, {count} streamed")
    };
    let peers = Peers { plan, send: &send, count, wanted };
    let work = |level: Level| Ok(orient3d_at(level, points, &mut signs.borrow_mut())?);
    compare(&peers, &what, (!cached).then_some(0), &work, report)?;
    if !cached {
        memory(plan, &data, count, report);
    }
    Ok(())
}

/// The same bytes read and no more: what no batch can be faster than.
fn memory(plan: &Plan, data: &[f64], count: usize, report: &mut Report) {
    let read = || {
        let start = Instant::now();
        let sums = data.chunks_exact(32).fold([0.0; 32], |mut sums, part| {
            sums.iter_mut().zip(part).for_each(|(sum, x)| *sum += x);
            sums
        });
        black_box(sums);
        start.elapsed().as_secs_f64()
    };
    let seconds: Vec<f64> = (0..plan.options.rounds.max(3)).map(|_| read()).collect();
    let seconds = median(&seconds);
    let rate = (size_of_val(data) as f64) / seconds / 1e9;
    let meaning = format!("ns an input to read its 96 bytes, {rate:.1} GB/s");
    let value = seconds / count as f64 * 1e9;
    report.row(Row::value("the streams read and added up alone", "memory", None, value, &meaning));
    report.data("stream_read", json!({ "seconds": seconds, "bytes": size_of_val(data) }));
}

/// The tets of a generated shell: every vertex serves a few inputs that follow each other.
fn indexed(plan: &Plan, frequency: u32, report: &mut Report) -> Res {
    let shell = same(frequency).shell;
    let vertices = [shell.bottom.as_slice(), &shell.middle, &shell.top].concat();
    let quads = tets(&shell);
    let mut signs = vec![Sign::Zero; quads.len()];
    let found = orient3d_indexed_at(Level::Baseline, &vertices, &quads, &mut signs)?;
    stages(&format!("{} indexed", quads.len()), found, report);
    let (count, wanted) = (quads.len(), counts(&signs));
    same_at_all_levels(&signs, |level, again| Ok(orient3d_indexed_at(level, &vertices, &quads, again)?))?;
    let signs = std::cell::RefCell::new(signs);
    let send = |subject: &mut Subject| {
        subject.send_line(&format!("indexed {} {count}", vertices.len()))?;
        subject.send_numbers(vertices.as_flattened())?;
        Ok(subject.send_indices(quads.as_flattened())?)
    };
    let peers = Peers { plan, send: &send, count, wanted };
    let work = |level: Level| Ok(orient3d_indexed_at(level, &vertices, &quads, &mut signs.borrow_mut())?);
    compare(&peers, &format!("orient3d, batched, {count} indexed"), Some(1), &work, report)
}

/// All tets of all prisms, as indices into bottom, middle and top one after another.
fn tets(shell: &Shell) -> Vec<[u32; 4]> {
    let n = u32::try_from(shell.vertex_count()).unwrap_or(u32::MAX);
    let mut out = Vec::with_capacity(24 * shell.faces.len());
    for face in &shell.faces {
        for (k, _) in (0..).zip(Slab::BOTH) {
            let vertex = |(corner, hi): (u8, bool)| face[usize::from(corner)] + n * (k + u32::from(hi));
            out.extend(TETS.iter().map(|tet| tet.vertices.map(vertex)));
        }
    }
    out
}
