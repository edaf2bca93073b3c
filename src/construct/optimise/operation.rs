//! The operations by name: what each proposes at a key, and where that was tried in vain.

use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};

use super::collapse::{self, Effort};
use super::invariants::Judge;
use super::limits::Limits;
use super::state::{Change, State};
use super::{flip, repair, smooth, split};

/// The ends of an edge, the smaller id first, or a vertex twice.
pub(crate) type Key = [u32; 2];

/// A kind of operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Operation {
    Flip,
    Smooth,
    Collapse,
    /// The collapse with more effort.
    HardCollapse,
    Split,
    /// Of joint shells: a pillar that suits the partner better.
    Repair,
    /// Of joint shells: a split that makes room for repairs.
    Relief,
}

/// A change that all rules allow, and how many operations it is.
pub(crate) type Proposal = (Change, u64);

/// What proposals are made from, besides the state.
#[derive(Debug)]
pub(crate) struct Rules<'a> {
    pub(crate) judge: Judge<'a>,
    pub(crate) limits: Limits,
}

impl Operation {
    pub(crate) const COUNT: usize = 7;

    /// What the operation would do. Reads nothing of the state but what [`State::is_settled`] at both ends covers.
    pub(crate) fn propose(self, state: &State, rules: &Rules<'_>, key: Key) -> Option<Proposal> {
        let Rules { judge, limits } = rules;
        let one = |change| (change, 1);
        match self {
            Self::Flip => flip::propose(state, judge, key).map(one),
            Self::Smooth => smooth::propose(state, judge, limits, key[0]),
            Self::Collapse => collapse::propose(state, judge, limits, Effort::PLAIN, key).map(one),
            Self::HardCollapse => collapse::propose(state, judge, limits, Effort::HARD, key).map(one),
            Self::Split => split::propose(state, judge, limits, key).map(one),
            Self::Repair => repair::propose(state, rules, key[0]).map(one),
            Self::Relief => repair::split(state, rules, key).map(one),
        }
    }
}

/// Per operation and key the change up to which it was tried: it failed, or led to later changes. Operations depend on
/// their neighbourhood alone, so that there is no use in trying again before it changes.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Tried([FxHashMap<Key, u64>; Operation::COUNT]);

impl Tried {
    /// Is it a waste to try now?
    pub(crate) fn in_vain(&self, state: &State, operation: Operation, key: Key) -> bool {
        self.0[operation as usize].get(&key).is_some_and(|&last| are_settled(state, key, last))
    }

    /// Notes a try now.
    pub(crate) fn note(&mut self, state: &State, operation: Operation, key: Key) {
        self.0[operation as usize].insert(key, state.clock);
    }

    /// Forgets edges that are no more: if one comes back, its ends have changed.
    pub(crate) fn forget(&mut self, state: &State, operation: Operation) {
        self.0[operation as usize].retain(|&[u, w], _| u == w || !state.edge(u, w).is_empty());
    }

    /// All entries, ascending.
    pub(crate) fn entries(&self) -> Vec<Vec<(Key, u64)>> {
        let sorted = |map: &FxHashMap<Key, u64>| {
            let mut all: Vec<(Key, u64)> = map.iter().map(|(k, c)| (*k, *c)).collect();
            all.sort_unstable();
            all
        };
        self.0.iter().map(sorted).collect()
    }

    /// From entries, as far as there are that many operations.
    pub(crate) fn of(entries: Vec<Vec<(Key, u64)>>) -> Self {
        let mut out = Self::default();
        for (map, entries) in out.0.iter_mut().zip(entries) {
            map.extend(entries);
        }
        out
    }
}

/// Is whatever an operation at the key reads as it was after change number `clock`?
pub(crate) fn are_settled(state: &State, key: Key, clock: u64) -> bool {
    key.into_iter().all(|v| state.is_settled(v, clock))
}
