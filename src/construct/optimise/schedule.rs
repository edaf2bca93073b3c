//! The order of operations (*Shell* section 3.4, "Scheduling and Termination"), and when to stop.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::time::{Duration, Instant};

use rustc_hash::FxHashMap;

use super::collapse::{Effort, collapse};
use super::flip::flip;
use super::invariants::Judge;
use super::limits::{Limits, distance};
use super::smooth::{pan, rotate, zoom};
use super::repair::repair;
use super::state::State;
use crate::certify::Observer;

/// How often coarsening and polishing are repeated at most.
const REPEATS: usize = 4;

/// Asks now and then whether to go on.
pub(crate) struct Stop<'a> {
    observer: &'a dyn Observer,
    until: Option<Instant>,
    calls: u64,
    stopped: bool,
}

impl<'a> Stop<'a> {
    pub(crate) fn new(observer: &'a dyn Observer, limit: Option<Duration>) -> Self {
        let until = limit.and_then(|l| Instant::now().checked_add(l));
        Self { observer, until, calls: 0, stopped: false }
    }

    /// Stop before the next operation?
    fn now(&mut self) -> bool {
        if self.calls.is_multiple_of(16) && !self.stopped {
            self.stopped = self.observer.cancelled() || self.until.is_some_and(|t| Instant::now() >= t);
            self.observer.advance(16);
        }
        self.calls += 1;
        self.stopped
    }

    pub(crate) fn stopped(&self) -> bool {
        self.stopped
    }
}

/// How many operations were made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Edge collapses.
    pub collapses: u64,
    /// Edge flips.
    pub flips: u64,
    /// Pans, zooms and rotations.
    pub moves: u64,
    /// Rounds of the outer loop.
    pub rounds: u64,
}

/// Everything that the schedule works with.
pub(crate) struct Work<'a> {
    pub(crate) state: State,
    pub(crate) judge: Judge<'a>,
    pub(crate) limits: Limits,
    pub(crate) counts: Counts,
    pub(crate) tried: Tried,
}

/// Up to which change an operation was tried in vain, or led to later changes: operations depend on their neighbourhood
/// alone, so that there is no use in trying again before it changes.
#[derive(Debug, Default)]
pub(crate) struct Tried {
    smooth: FxHashMap<u32, u64>,
    flip: FxHashMap<[u32; 2], u64>,
    /// Plain and hard.
    collapse: [FxHashMap<[u32; 2], u64>; 2],
}

/// Is it a waste to try again? If not, this counts as a try.
fn in_vain<const N: usize, K: std::hash::Hash + Eq>(
    state: &State,
    tried: &mut FxHashMap<K, u64>,
    key: K,
    vertices: [u32; N],
) -> bool {
    let last = tried.insert(key, state.clock);
    last.is_some_and(|last| vertices.into_iter().all(|v| state.is_settled(v, last)))
}

impl Work<'_> {
    /// Coarsening and polishing, again while polishing has made more coarsening possible.
    pub(crate) fn run(&mut self, polish: usize, stop: &mut Stop<'_>) {
        for repeat in 0..REPEATS {
            let effort = if repeat == 0 { Effort::PLAIN } else { Effort::HARD };
            let before = self.state.live;
            self.coarsen(effort, stop);
            if stop.stopped() || self.state.live == before {
                break;
            }
            self.polish(polish, stop);
        }
    }

    /// The outer loop: until a round leaves less than 0.01 % fewer prisms.
    fn coarsen(&mut self, effort: Effort, stop: &mut Stop<'_>) {
        stop.observer.stage("coarsening", None);
        self.report();
        loop {
            let before = self.state.live;
            self.flips(stop);
            self.repairs(stop);
            self.smooth(stop);
            self.collapses(effort, stop);
            self.report();
            self.counts.rounds += 1;
            if stop.stopped() || (before - self.state.live) * 10_000 < before {
                return;
            }
        }
    }

    fn polish(&mut self, rounds: usize, stop: &mut Stop<'_>) {
        stop.observer.stage("polishing", None);
        for _ in 0..rounds {
            if stop.stopped() {
                return;
            }
            self.flips(stop);
            self.repairs(stop);
            self.smooth(stop);
        }
        self.report();
    }

    fn report(&self) {
        let Some(partner) = self.judge.partner.as_deref() else { return };
        let faces = self.state.faces.iter().filter(|f| **f != super::state::GONE);
        let all: Vec<f64> = faces.map(|f| partner.violation_of(&self.state.prism(*f, None))).collect();
        eprintln!(
            "prisms {} violation {} in {}",
            self.state.live,
            all.iter().sum::<f64>(),
            all.iter().filter(|v| **v > 0.0).count()
        );
    }

    fn repairs(&mut self, stop: &mut Stop<'_>) {
        if self.judge.partner.is_none() {
            return;
        }
        for v in 0..u32::try_from(self.state.pillars.len()).unwrap_or(u32::MAX) {
            if self.state.star[v as usize].is_empty() || self.state.is_frozen(v) {
                continue;
            }
            if stop.now() {
                return;
            }
            self.counts.moves += u64::from(repair(&mut self.state, &self.judge, &self.limits, v));
        }
    }

    fn flips(&mut self, stop: &mut Stop<'_>) {
        for edge in self.state.edges() {
            if stop.now() {
                return;
            }
            if in_vain(&self.state, &mut self.tried.flip, edge, edge) {
                continue;
            }
            self.counts.flips += u64::from(flip(&mut self.state, &self.judge, edge));
        }
    }

    fn smooth(&mut self, stop: &mut Stop<'_>) {
        for v in 0..u32::try_from(self.state.pillars.len()).unwrap_or(u32::MAX) {
            if self.state.star[v as usize].is_empty() || self.state.is_frozen(v) {
                continue;
            }
            if stop.now() {
                return;
            }
            if in_vain(&self.state, &mut self.tried.smooth, v, [v]) {
                continue;
            }
            let moves = [
                pan(&mut self.state, &self.judge, v),
                zoom(&mut self.state, &self.judge, &self.limits, v),
                rotate(&mut self.state, &self.judge, v),
            ];
            self.counts.moves += moves.iter().filter(|m| **m).count() as u64;
        }
    }

    /// Shortest edges first; edges around a new vertex join the queue.
    fn collapses(&mut self, effort: Effort, stop: &mut Stop<'_>) {
        let mut queue: BinaryHeap<Reverse<(u64, [u32; 2])>> =
            self.state.edges().into_iter().map(|e| Reverse((self.length(e), e))).collect();
        while let Some(Reverse((length, edge))) = queue.pop() {
            if stop.now() {
                return;
            }
            if self.state.edge(edge[0], edge[1]).is_empty() || self.length(edge) != length {
                continue;
            }
            if in_vain(&self.state, &mut self.tried.collapse[usize::from(effort.is_hard())], edge, edge) {
                continue;
            }
            if let Some(stays) = collapse(&mut self.state, &self.judge, &self.limits, effort, edge) {
                self.counts.collapses += 1;
                for w in self.state.neighbours(stays) {
                    let edge = [stays.min(w), stays.max(w)];
                    queue.push(Reverse((self.length(edge), edge)));
                }
            }
        }
    }

    /// The edge's length as a number that sorts like it.
    fn length(&self, edge: [u32; 2]) -> u64 {
        let [p, q] = edge.map(|v| self.state.pillars[v as usize].middle);
        // The bits of numbers that are not negative ascend with them.
        distance(&p, &q).abs().to_bits()
    }
}
