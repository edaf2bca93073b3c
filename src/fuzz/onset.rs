//! At which magnitudes failures begin.

use std::collections::BTreeMap;

use serde::Serialize;

use super::bits::{magnitude, scaled, spread};
use super::finding::Failure;
use super::generate::{Generator, Origin};
use super::{Class, Predicate, Subject, SubjectError, shrink};

/// Failing cases next to the onset that are kept for [`Onsets::refine`].
const KEPT: usize = 8;
/// How far, in powers of two, they are moved towards size one.
const REACH: i32 = 48;

/// Failures of one class among the cases of one origin.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Onset {
    /// The class.
    pub class: Class,
    /// The generator; `sweep/base` for the cases of each generator that the sweep scales.
    pub origin: String,
    /// How many.
    pub failures: u64,
    /// For `sweep`: the largest exponent `e <= 0` with failures. They begin below: coordinates in `[2^e, 2^(e+1))`.
    pub below: Option<i32>,
    /// For `sweep`: the least exponent `e > 0` with failures.
    pub above: Option<i32>,
    /// For other generators: the least difference of the largest and the least exponent of a failing case.
    pub spread: Option<i32>,
    /// For other generators: the range of the largest exponents of failing cases.
    pub exponents: Option<[i32; 2]>,
}

/// The failing cases next to an onset, the nearest first.
#[derive(Debug, Default)]
struct Edge(Vec<(i32, Failure)>);

impl Edge {
    /// `distance` is that from size one.
    fn note(&mut self, distance: i32, failure: &Failure) {
        let full = self.0.len() >= KEPT;
        if full && self.0.last().is_some_and(|(last, _)| *last <= distance) {
            return;
        }
        let place = self.0.partition_point(|(known, _)| *known <= distance);
        self.0.insert(place, (distance, failure.clone()));
        self.0.truncate(KEPT);
    }
}

#[derive(Debug, Default)]
struct Row {
    failures: u64,
    below: Edge,
    above: Edge,
    spread: Option<i32>,
    exponents: Option<[i32; 2]>,
}

/// Failures by class and origin.
#[derive(Debug, Default)]
pub(super) struct Onsets(BTreeMap<(Class, Origin), Row>);

impl Onsets {
    pub(super) fn note(&mut self, failure: &Failure) {
        let row = self.0.entry((failure.class, failure.origin.row())).or_default();
        row.failures += 1;
        let Some(e) = magnitude(&failure.case) else { return };
        if failure.origin.generator == Generator::Sweep {
            let edge = if e <= 0 { &mut row.below } else { &mut row.above };
            edge.note(e.abs(), failure);
        } else {
            let s = spread(&failure.case);
            row.spread = Some(row.spread.map_or(s, |known| known.min(s)));
            row.exponents = Some(row.exponents.map_or([e, e], |[low, high]| [low.min(e), high.max(e)]));
        }
    }

    /// Moves the cases next to each onset further towards size one for as long as they fail.
    pub(super) fn refine(
        &mut self,
        subject: &mut dyn Subject,
        predicate: Predicate,
        stop: &dyn Fn() -> bool,
    ) -> Result<(), SubjectError> {
        for ((class, _), row) in &mut self.0 {
            // Each of these costs a start of the program.
            if matches!(class, Class::Hang | Class::Crash) {
                continue;
            }
            for (edge, direction) in [(&mut row.below, 1), (&mut row.above, -1)] {
                while !stop() && nearer(edge, direction, subject, predicate, stop)? {}
            }
        }
        Ok(())
    }

    /// As a table.
    pub(super) fn rows(&self) -> Vec<Onset> {
        let row = |((class, origin), row): (&(Class, Origin), &Row)| Onset {
            class: *class,
            origin: origin.to_string(),
            failures: row.failures,
            below: row.below.0.first().map(|(distance, _)| -distance),
            above: row.above.0.first().map(|(distance, _)| *distance),
            spread: row.spread,
            exponents: row.exponents,
        };
        self.0.iter().map(row).collect()
    }
}

/// Finds multiples of the kept cases that fail nearer to size one; were there any?
fn nearer(
    edge: &mut Edge,
    direction: i32,
    subject: &mut dyn Subject,
    predicate: Predicate,
    stop: &dyn Fn() -> bool,
) -> Result<bool, SubjectError> {
    let nearest = edge.0.first().map_or(0, |(distance, _)| *distance);
    let mut better = Vec::new();
    for (distance, failure) in &edge.0 {
        // Only distances that beat the best one, and not beyond size one.
        let steps = (distance - nearest + 1)..=(distance - nearest + REACH).min(*distance);
        let cases: Vec<(i32, Vec<f64>)> = steps
            .map(|k| (distance - k, failure.case.iter().map(|x| scaled(*x, direction * k)).collect()))
            .filter(|(_, case): &(i32, Vec<f64>)| predicate.accepts(case))
            .collect();
        for some in cases.chunks(shrink::AT_ONCE) {
            if stop() {
                break;
            }
            let asked: Vec<&[f64]> = some.iter().map(|(_, case)| case.as_slice()).collect();
            let failing = shrink::fails(subject, predicate, failure, &asked)?;
            for ((distance, case), _) in some.iter().zip(failing).filter(|(_, fails)| *fails) {
                better.push((*distance, Failure { case: case.clone(), ..failure.clone() }));
            }
        }
    }
    for (distance, failure) in &better {
        edge.note(*distance, failure);
    }
    Ok(!better.is_empty())
}
