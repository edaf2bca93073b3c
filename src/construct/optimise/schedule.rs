//! The order of operations (*Shell* section 3.4, "Scheduling and Termination"), as a machine that can be saved between
//! any two batches.

use std::collections::BinaryHeap;

use serde::{Deserialize, Serialize};

use super::batch::{BATCH, Entry, Work, rank};
use super::operation::{Key, Operation};
use super::repair;
use super::split;

/// How often coarsening and polishing are repeated at most.
pub(crate) const REPEATS: u32 = 4;

/// How often room is made for a partner that is still violated at the end.
const RELIEFS: u32 = 12;

/// So many edges are few in any shell.
const FEW: usize = 200;

/// How many operations were made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counts {
    /// Edge collapses.
    pub collapses: u64,
    /// Edge flips.
    pub flips: u64,
    /// Edge splits.
    pub splits: u64,
    /// Pans, zooms and rotations.
    pub moves: u64,
    /// Rounds of the outer loop.
    pub rounds: u64,
}

impl Counts {
    pub(crate) fn add(&mut self, operation: Operation, made: u64) {
        let count = match operation {
            Operation::Collapse | Operation::HardCollapse => &mut self.collapses,
            Operation::Flip => &mut self.flips,
            Operation::Split | Operation::Relief => &mut self.splits,
            Operation::Smooth | Operation::Repair => &mut self.moves,
        };
        *count = count.saturating_add(made);
    }
}

/// What the passes are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Phase {
    /// The outer loop: flips, smoothing, collapses, until a round leaves less than 0.01 % fewer prisms.
    Coarsen,
    /// Flips and smoothing; so many rounds are over.
    Polish(u32),
    /// Of joint shells: splits where the partner is still violated, then flips, repairs and smoothing.
    Relieve(u32),
    Done,
}

impl Phase {
    /// The end, or another round of making room for the partner.
    fn last(work: &Work<'_>, rounds: u32) -> Self {
        if rounds < RELIEFS && work.lacks_little_room() { Self::Relieve(rounds) } else { Self::Done }
    }

    /// In words, for a progress bar.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Coarsen => "coarsening",
            Self::Polish(_) => "polishing",
            Self::Relieve(_) => "making room",
            Self::Done => "optimised",
        }
    }
}

/// One kind of operation all over the shell, and what is left of it.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) enum Pass {
    /// At these keys, from one of them on.
    List { operation: Operation, keys: Vec<Key>, next: usize },
    /// Collapses, shortest edge first.
    Queue { operation: Operation, queue: BinaryHeap<Entry> },
}

impl Pass {
    fn operation(&self) -> Operation {
        match self {
            Self::List { operation, .. } | Self::Queue { operation, .. } => *operation,
        }
    }
}

/// Where the work is.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Position {
    /// Coarsening and polishing are repeated while polishing has made more coarsening possible.
    pub(crate) repeat: u32,
    pub(crate) phase: Phase,
    pub(crate) pass: Pass,
    /// The number of prisms when this repeat began, and this round of coarsening.
    pub(crate) before_repeat: usize,
    pub(crate) before_round: usize,
}

impl Position {
    /// The begin.
    pub(crate) fn new(work: &mut Work<'_>) -> Self {
        let live = work.state.live;
        Self {
            repeat: 0,
            phase: Phase::Coarsen,
            pass: work.pass(Operation::Flip),
            before_repeat: live,
            before_round: live,
        }
    }

    /// One batch further; is there more to do?
    pub(crate) fn advance(&mut self, work: &mut Work<'_>, polish: u32) -> bool {
        while self.phase != Phase::Done {
            match &mut self.pass {
                Pass::List { operation, keys, next } if *next < keys.len() => {
                    let end = next.saturating_add(BATCH).min(keys.len());
                    work.batch(*operation, &keys[*next..end]);
                    *next = end;
                    return true;
                }
                Pass::Queue { operation, queue } if !queue.is_empty() => {
                    work.collapses(*operation, queue);
                    return true;
                }
                _ => self.next_pass(work, polish),
            }
        }
        false
    }

    fn next_pass(&mut self, work: &mut Work<'_>, polish: u32) {
        let next = match (self.pass.operation(), self.phase) {
            (Operation::Flip, _) if work.rules.judge.partner.is_some() => Operation::Repair,
            (Operation::Flip | Operation::Repair, _) => Operation::Smooth,
            (Operation::Relief, _) => Operation::Flip,
            (Operation::Smooth, Phase::Coarsen) if self.repeat == 0 => Operation::Collapse,
            (Operation::Smooth, Phase::Coarsen) => Operation::HardCollapse,
            (Operation::Split, _) => Operation::Flip,
            _ => {
                self.next_round(work, polish);
                // Once, so that splits and collapses do not undo each other for ever; later coarsening takes away
                // what has not helped.
                let first = self.repeat == 0 && self.phase == Phase::Polish(0);
                match self.phase {
                    Phase::Relieve(_) => Operation::Relief,
                    _ if first => Operation::Split,
                    _ => Operation::Flip,
                }
            }
        };
        if self.phase != Phase::Done {
            self.pass = work.pass(next);
        }
    }

    fn next_round(&mut self, work: &mut Work<'_>, polish: u32) {
        // A joint shell is wanted for the two meshes that it holds, not for being coarse.
        if work.rules.judge.partner.is_some() && !work.violates_partner() {
            self.phase = Phase::Done;
            return;
        }
        let live = work.state.live;
        let rounds = match self.phase {
            Phase::Polish(rounds) => rounds.saturating_add(1),
            Phase::Coarsen => {
                work.counts.rounds = work.counts.rounds.saturating_add(1);
                let fewer = self.before_round.saturating_sub(live);
                if fewer.saturating_mul(10_000) >= self.before_round {
                    self.before_round = live;
                    return;
                }
                if self.repeat > 0 && live >= self.before_repeat {
                    self.phase = Phase::last(work, 0);
                    return;
                }
                0
            }
            Phase::Relieve(rounds) => {
                self.phase = Phase::last(work, rounds.saturating_add(1));
                return;
            }
            Phase::Done => return,
        };
        self.phase = if rounds < polish { Phase::Polish(rounds) } else { self.next_repeat(work, live) };
    }

    fn next_repeat(&mut self, work: &Work<'_>, live: usize) -> Phase {
        self.repeat += 1;
        (self.before_repeat, self.before_round) = (live, live);
        if self.repeat < REPEATS { Phase::Coarsen } else { Phase::last(work, 0) }
    }
}

impl Work<'_> {
    /// A new pass of an operation over the shell as it is.
    fn pass(&mut self, operation: Operation) -> Pass {
        self.tried.forget(&self.state, operation);
        let keys: Vec<Key> = match operation {
            Operation::Smooth | Operation::Repair => self.free_vertices(),
            Operation::Relief => self.narrow_edges(),
            Operation::Flip => self.state.edges(),
            Operation::Split => {
                let mut edges = self.state.edges();
                edges.retain(|&e| split::is_wanted(&self.state, &self.rules.limits, e));
                edges
            }
            Operation::Collapse | Operation::HardCollapse => {
                let queue = self.state.edges().into_iter().map(|e| self.entry(e)).collect();
                return Pass::Queue { operation, queue };
            }
        };
        let mut keys = keys;
        // Stable: with seed 0 all ranks are equal.
        keys.sort_by_key(|&key| rank(self.seed, key));
        Pass::List { operation, keys, next: 0 }
    }

    /// The edges of prisms that violate the partner, ascending.
    fn narrow_edges(&self) -> Vec<Key> {
        let Some(partner) = &self.rules.judge.partner else { return Vec::new() };
        let mut edges = self.state.edges();
        edges.retain(|&edge| repair::is_wanted(&self.state, partner, edge));
        edges
    }

    /// Is the partner violated, but in few places? Where it is everywhere, splits would only multiply prisms.
    fn lacks_little_room(&self) -> bool {
        let narrow = self.narrow_edges().len();
        narrow > 0 && narrow <= FEW.max(self.state.live / 10)
    }

    fn violates_partner(&self) -> bool {
        !self.narrow_edges().is_empty()
    }

    /// The vertices that may move, ascending.
    fn free_vertices(&self) -> Vec<Key> {
        (0u32..)
            .zip(&self.state.star)
            .filter(|(v, star)| !star.is_empty() && !self.state.is_frozen(*v))
            .map(|(v, _)| [v, v])
            .collect()
    }
}
