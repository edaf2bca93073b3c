//! The loop: make cases, ask, judge, keep what is wrong; then shrink.

use std::cell::Cell;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use rayon::prelude::*;

use super::finding::{Failure, Finding, Key};
use super::generate::{Batch, Generator, Origin, Pool, Source};
use super::onset::Onsets;
use super::report::{OriginCount, Report};
use super::subject::wire_line;
use super::{Answer, Class, Predicate, Subject, SubjectError, corpus, judge, shrink};
use crate::certify::Observer;
use crate::predicate::Sign;

/// When to end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// After so many cases: two runs with one seed give one report, unless answers depend on time.
    Cases(u64),
    /// After this time, a fifth of which is for shrinking and for the search for the onset of failures.
    Time(Duration),
}

/// What to ask.
#[derive(Clone, Debug)]
pub struct Options {
    /// The predicate.
    pub predicate: Predicate,
    /// Generators, mixed evenly.
    pub generators: Vec<Generator>,
    /// Seed of all that is random.
    pub seed: u64,
    /// When to end.
    pub limit: Limit,
    /// Meshes for [`Generator::Real`].
    pub meshes: Pool,
}

impl Options {
    /// 100,000 cases of all generators that need no mesh, with seed 0.
    #[must_use]
    pub fn new(predicate: Predicate) -> Self {
        let generators = Generator::ALL.into_iter().filter(|g| *g != Generator::Real).collect();
        Self { predicate, generators, seed: 0, limit: Limit::Cases(100_000), meshes: Pool::default() }
    }
}

/// Findings of one run that are shrunk.
const SHRUNK: usize = 64;

/// Asks the subject about many cases and judges its answers. Ends early, with what has been found so far, when the
/// observer wants so.
///
/// # Errors
/// [`SubjectError`] if the subject cannot be asked. Mismatches are no errors.
pub fn run(
    subject: &mut dyn Subject,
    options: &Options,
    observer: &dyn Observer,
) -> Result<Report, SubjectError> {
    let start = Instant::now();
    let mut tally = Tally::new(options.predicate);
    let mut source = Source::new(options.predicate, &options.generators, options.seed, &options.meshes);
    let total = match options.limit {
        Limit::Cases(count) => Some(count),
        Limit::Time(_) => None,
    };
    let mut size = BatchSize(total.is_none().then_some(1));
    observer.stage("cases", total);
    while !observer.cancelled() {
        let left = match options.limit {
            Limit::Cases(count) => count.saturating_sub(tally.cases),
            Limit::Time(time) if start.elapsed() >= time.mul_f64(0.8) => 0,
            Limit::Time(_) => u64::MAX,
        };
        if left == 0 {
            break;
        }
        let pace = size.of(subject.pace().batch);
        let batch = source.batch(usize::try_from(left).map_or(pace, |left| left.min(pace)));
        let asked = Instant::now();
        if !tally.ask(&batch, subject)? {
            break;
        }
        size.note(asked.elapsed());
        observer.advance(batch.origins.len() as u64);
        tally.is_supported(subject)?;
    }
    subject.end()?;
    observer.stage("shrinking", None);
    let late = || match options.limit {
        Limit::Cases(_) => false,
        Limit::Time(time) => start.elapsed() >= time,
    };
    tally.finish(subject, options.seed, &|| late() || observer.cancelled())
}

/// Asks about the cases of a corpus again; nothing is shrunk.
///
/// # Errors
/// [`SubjectError`] if the subject cannot be asked.
pub fn replay(
    subject: &mut dyn Subject,
    predicate: Predicate,
    entries: &[corpus::Entry],
) -> Result<Report, SubjectError> {
    let mut tally = Tally::new(predicate);
    for entry in entries.iter().filter(|entry| entry.predicate == predicate) {
        let mut batch =
            Batch { coordinates: entry.case.clone(), origins: vec![entry.origin], images: Vec::new() };
        if let Some(symmetry) = &entry.symmetry {
            batch.coordinates.extend(symmetry.image(&entry.case, predicate.dimension()));
            batch.origins.push(entry.origin);
            batch.images.push((1, 0, symmetry.clone()));
        }
        if !tally.ask(&batch, subject)? {
            break;
        }
    }
    subject.end()?;
    tally.is_supported(subject)?;
    tally.finish(subject, 0, &|| true)
}

/// How many cases are asked at once: in a timed run so many that a batch takes a moment, for nothing stops it on the way.
struct BatchSize(Option<usize>);

impl BatchSize {
    fn of(&self, best: usize) -> usize {
        self.0.map_or(best, |size| size.min(best))
    }

    fn note(&mut self, took: Duration) {
        if let Some(size) = &mut self.0 {
            match took.as_millis() {
                ..100 => *size = size.saturating_mul(2),
                500.. => *size = (*size / 2).max(1),
                _ => {}
            }
        }
    }
}

/// `None` where the subject has been given up: what has been found before still counts.
fn unless_given_up<T>(result: Result<T, SubjectError>) -> Result<Option<T>, SubjectError> {
    match result {
        Err(SubjectError::GaveUp { .. }) => Ok(None),
        other => other.map(Some),
    }
}

/// What has been found so far.
struct Tally {
    predicate: Predicate,
    cases: u64,
    unsupported: u64,
    gave_up: bool,
    mismatches: u64,
    origins: BTreeMap<Origin, [u64; 2]>,
    groups: BTreeMap<Key, (u64, Failure)>,
    onsets: Onsets,
}

impl Tally {
    fn new(predicate: Predicate) -> Self {
        Self {
            predicate,
            cases: 0,
            unsupported: 0,
            gave_up: false,
            mismatches: 0,
            origins: BTreeMap::new(),
            groups: BTreeMap::new(),
            onsets: Onsets::default(),
        }
    }

    /// An error for a subject that has answered nothing, which is no clean run.
    fn is_supported(&self, subject: &dyn Subject) -> Result<(), SubjectError> {
        if self.cases > 0 && self.unsupported == self.cases {
            return Err(SubjectError::Unsupported { subject: subject.name(), predicate: self.predicate });
        }
        Ok(())
    }

    /// Asks about a batch and judges the answers. Was it answered? A subject may be given up once it has been found wrong;
    /// before that there would be nothing to say.
    fn ask(&mut self, batch: &Batch, subject: &mut dyn Subject) -> Result<bool, SubjectError> {
        match subject.answer(self.predicate, &batch.coordinates) {
            Err(SubjectError::GaveUp { .. }) if self.mismatches > 0 => {
                self.gave_up = true;
                Ok(false)
            }
            answers => self.take(batch, answers?, subject).map(|()| true),
        }
    }

    /// Judges a batch. A case without an answer, or without a right one, would count as answered rightly: both are errors.
    fn take(
        &mut self,
        batch: &Batch,
        answers: Vec<Answer>,
        subject: &dyn Subject,
    ) -> Result<(), SubjectError> {
        let arity = self.predicate.arity();
        let judged = |case: &[f64]| {
            let none = || SubjectError::NoCase { case: wire_line(self.predicate, case) };
            judge(self.predicate, case).ok_or_else(none)
        };
        let right: Vec<Sign> =
            batch.coordinates.par_chunks_exact(arity).map(judged).collect::<Result<_, _>>()?;
        if answers.len() != right.len() {
            let (found, wanted) = (answers.len(), right.len());
            return Err(SubjectError::Count { subject: subject.name(), found, wanted });
        }
        let case = |i: usize| batch.coordinates.get(i * arity..(i + 1) * arity).unwrap_or_default().to_vec();
        for (second, first, symmetry) in &batch.images {
            let (Some(one), Some(other)) = (answers.get(*first), answers.get(*second)) else { continue };
            if symmetry.contradicts(one, other) {
                self.add(Failure {
                    class: Class::Inconsistent,
                    origin: batch.origins[*first],
                    case: case(*first),
                    answer: one.clone(),
                    expected: right[*first],
                    symmetry: Some(symmetry.clone()),
                });
            }
        }
        for (i, ((answer, expected), origin)) in
            answers.into_iter().zip(right).zip(&batch.origins).enumerate()
        {
            self.cases += 1;
            let counts = self.origins.entry(*origin).or_default();
            counts[0] += 1;
            self.unsupported += u64::from(answer == Answer::Unsupported);
            if let Some(class) = Class::of(&answer, expected) {
                counts[1] += 1;
                self.mismatches += 1;
                self.add(Failure { class, origin: *origin, case: case(i), answer, expected, symmetry: None });
            }
        }
        Ok(())
    }

    fn add(&mut self, failure: Failure) {
        self.onsets.note(&failure);
        let simpler = |known: &Failure| shrink::cost(&failure.case) < shrink::cost(&known.case);
        match self.groups.get_mut(&failure.key()) {
            Some((count, known)) => {
                *count += 1;
                if simpler(known) {
                    *known = failure;
                }
            }
            None => {
                self.groups.insert(failure.key(), (1, failure));
            }
        }
    }

    /// Shrinks and refines until `stop`, and sums up.
    fn finish(
        mut self,
        subject: &mut dyn Subject,
        seed: u64,
        stop: &dyn Fn() -> bool,
    ) -> Result<Report, SubjectError> {
        let gave_up = Cell::new(self.gave_up);
        let stop = || gave_up.get() || stop();
        let refined = self.onsets.refine(subject, self.predicate, &stop);
        gave_up.set(unless_given_up(refined)?.is_none() || gave_up.get());
        let mut findings: BTreeMap<Key, Finding> = BTreeMap::new();
        for (turn, key) in self.order().into_iter().enumerate() {
            let Some((count, failure)) = self.groups.get(&key) else { continue };
            let mut finding = None;
            if turn < SHRUNK && !stop() {
                finding = unless_given_up(self.smaller(subject, failure, &stop))?;
                gave_up.set(finding.is_none());
            }
            let (failure, minimal) = finding.unwrap_or_else(|| (failure.clone(), false));
            findings.insert(key, Finding::new(self.predicate, &failure, *count, minimal));
        }
        let origins = self.origins.iter().map(|(origin, [cases, mismatches])| OriginCount {
            origin: origin.to_string(),
            cases: *cases,
            mismatches: *mismatches,
        });
        Ok(Report {
            predicate: self.predicate,
            subject: subject.name(),
            seed,
            cases: self.cases,
            unsupported: self.unsupported,
            gave_up: gave_up.get(),
            mismatches: self.mismatches,
            origins: origins.collect(),
            onsets: self.onsets.rows(),
            findings: findings.into_values().collect(),
        })
    }

    /// The failure with a smaller case and its own answers, and whether it is minimal. A smaller case that does not fail a
    /// second time is not taken.
    fn smaller(
        &self,
        subject: &mut dyn Subject,
        failure: &Failure,
        stop: &dyn Fn() -> bool,
    ) -> Result<(Failure, bool), SubjectError> {
        let tries = match failure.class {
            Class::Hang | Class::Crash => subject.pace().crashes,
            _ => subject.pace().tries,
        };
        let shrunk = shrink::shrink(subject, self.predicate, failure, tries, stop)?;
        if shrunk.case == failure.case {
            return Ok((failure.clone(), shrunk.minimal));
        }
        let answer = subject.answer(self.predicate, &shrunk.case)?.into_iter().next();
        let expected = judge(self.predicate, &shrunk.case);
        let (Some(answer), Some(expected)) = (answer, expected) else { return Ok((failure.clone(), false)) };
        if failure.symmetry.is_none() && Class::of(&answer, expected) != Some(failure.class) {
            return Ok((failure.clone(), false));
        }
        Ok((Failure { case: shrunk.case, answer, expected, ..failure.clone() }, shrunk.minimal))
    }

    /// The keys, so that each class and origin comes to its turn before a second band of any.
    fn order(&self) -> Vec<Key> {
        let mut seen: BTreeMap<(Class, Origin), usize> = BTreeMap::new();
        let mut keys: Vec<(usize, Key)> = Vec::new();
        for key in self.groups.keys() {
            let turn = seen.entry((key.class, key.origin)).or_default();
            keys.push((*turn, *key));
            *turn += 1;
        }
        keys.sort();
        keys.into_iter().map(|(_, key)| key).collect()
    }
}
