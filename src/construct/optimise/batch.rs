//! Batches of operations: proposals in parallel, changes in order.
//!
//! A batch has a fixed size and ends in the state that its operations lead to one after the other, whatever the
//! number of threads: proposals are made against the state at its begin, and where a change before its turn has
//! touched the neighbourhood that a proposal was made from, it is made again.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use rayon::prelude::*;

use super::limits::distance;
use super::operation::{Key, Operation, Proposal, Rules, Tried, are_settled};
use super::schedule::Counts;
use super::state::State;

/// The number of operations between two moments at which the work can be stopped and saved.
pub(crate) const BATCH: usize = 64;

/// An edge in the queue: its length as a number that sorts like it, its rank among equals, its ends.
pub(crate) type Entry = Reverse<(u64, u64, Key)>;

/// The work: a state, what operations it is open to, what was done.
#[derive(Debug)]
pub(crate) struct Work<'a> {
    pub(crate) state: State,
    pub(crate) rules: Rules<'a>,
    pub(crate) counts: Counts,
    pub(crate) tried: Tried,
    pub(crate) seed: u64,
}

/// What was found about a key at the begin of a batch.
enum Found {
    /// Not looked at.
    Nothing,
    /// In vain.
    Vain,
    Made(Option<Proposal>),
}

impl Work<'_> {
    /// Proposals for some keys against the state as it is. With one thread they are made when their turn comes, except
    /// where a skin is kept: it is read far from the key, so that a proposal depends on when it was made.
    fn foresee(&self, operation: Operation, keys: &[Key]) -> Vec<Found> {
        if rayon::current_num_threads() < 2 && self.state.skin.is_none() {
            return keys.iter().map(|_| Found::Nothing).collect();
        }
        let one = |key: &Key| {
            if self.tried.in_vain(&self.state, operation, *key) {
                return Found::Vain;
            }
            Found::Made(operation.propose(&self.state, &self.rules, *key))
        };
        keys.par_iter().map(one).collect()
    }

    /// Does the skin, if one is kept, still admit what was proposed before other changes of the batch?
    fn fits_skin(&self, found: &Found) -> bool {
        match (&self.state.skin, found) {
            (Some(skin), Found::Made(Some((change, _)))) => skin.admits(&self.state, change),
            _ => true,
        }
    }

    /// One operation, with what was found before change number `since`; was the shell changed?
    fn operate(&mut self, operation: Operation, key: Key, found: Found, since: u64) -> bool {
        let holds = are_settled(&self.state, key, since) && self.fits_skin(&found);
        let found = if holds { found } else { Found::Nothing };
        let proposal = match found {
            Found::Vain => return false,
            Found::Nothing if self.tried.in_vain(&self.state, operation, key) => return false,
            Found::Nothing => operation.propose(&self.state, &self.rules, key),
            Found::Made(proposal) => proposal,
        };
        self.tried.note(&self.state, operation, key);
        let Some((change, made)) = proposal else { return false };
        if change.add.len() > change.remove.len() && !self.state.has_room() {
            return false;
        }
        self.state.apply(&change);
        self.counts.add(operation, made);
        true
    }

    /// The operations at some keys, in their order.
    pub(crate) fn batch(&mut self, operation: Operation, keys: &[Key]) {
        let since = self.state.clock;
        for (&key, found) in keys.iter().zip(self.foresee(operation, keys)) {
            self.operate(operation, key, found, since);
        }
    }

    /// Collapses from a queue, shortest edge first; edges around a new vertex join it. As many as the queue began with,
    /// at most [`BATCH`], and those shorter ones that join meanwhile.
    pub(crate) fn collapses(&mut self, operation: Operation, queue: &mut BinaryHeap<Entry>) {
        let mut first: Vec<Entry> = Vec::with_capacity(BATCH);
        while first.len() < BATCH
            && let Some(entry) = queue.pop()
        {
            if self.is_current(&entry) {
                first.push(entry);
            }
        }
        let keys: Vec<Key> = first.iter().map(|entry| entry.0.2).collect();
        let since = self.state.clock;
        for (entry, found) in first.into_iter().zip(self.foresee(operation, &keys)) {
            // The queue's greatest is its shortest: entries are reversed.
            while queue.peek().is_some_and(|next| *next > entry)
                && let Some(next) = queue.pop()
            {
                self.collapse(operation, next, Found::Nothing, since, queue);
            }
            self.collapse(operation, entry, found, since, queue);
        }
    }

    fn collapse(
        &mut self,
        operation: Operation,
        entry: Entry,
        found: Found,
        since: u64,
        queue: &mut BinaryHeap<Entry>,
    ) {
        let [u, w] = entry.0.2;
        if self.is_current(&entry) && self.operate(operation, [u, w], found, since) {
            let stays = if self.state.star[u as usize].is_empty() { w } else { u };
            for v in self.state.neighbours(stays) {
                queue.push(self.entry([stays.min(v), stays.max(v)]));
            }
        }
    }

    /// Is the edge still there and as long as it was? If it comes back, it joins the queue anew.
    fn is_current(&self, entry: &Entry) -> bool {
        let (length, _, [u, w]) = entry.0;
        !self.state.edge(u, w).is_empty() && self.length([u, w]) == length
    }

    pub(crate) fn entry(&self, edge: Key) -> Entry {
        Reverse((self.length(edge), rank(self.seed, edge), edge))
    }

    /// The edge's length as a number that sorts like it.
    fn length(&self, edge: Key) -> u64 {
        let [p, q] = edge.map(|v| self.state.pillars[v as usize].middle);
        // The bits of numbers that are not negative ascend with them.
        distance(&p, &q).abs().to_bits()
    }
}

/// A key's place among its equals: none with seed 0, else scrambled by the seed.
pub(crate) fn rank(seed: u64, [u, w]: Key) -> u64 {
    if seed == 0 { 0 } else { mixed(seed ^ mixed(u64::from(u) << 32 | u64::from(w))) }
}

/// The output function of splitmix64, a bijection.
fn mixed(x: u64) -> u64 {
    let z = x.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
