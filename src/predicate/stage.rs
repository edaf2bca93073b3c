//! Which stage of a predicate decided, and counters for it.

use std::ops::{Add, AddAssign};

/// The stage that decided a predicate, cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Floating point with a proved error bound.
    Filter,
    /// Integers of fixed width on the stack.
    Fixed,
    /// Big integers on the heap.
    Big,
}

/// How many predicate calls each stage decided.
///
/// A plain value: every thread owns one, and the sums are added at the end.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StageCounts {
    /// Calls decided by [`Stage::Filter`].
    pub filter: u64,
    /// Calls decided by [`Stage::Fixed`].
    pub fixed: u64,
    /// Calls decided by [`Stage::Big`].
    pub big: u64,
}

impl StageCounts {
    /// Counts one call.
    #[inline]
    pub fn record(&mut self, stage: Stage) {
        let counter = match stage {
            Stage::Filter => &mut self.filter,
            Stage::Fixed => &mut self.fixed,
            Stage::Big => &mut self.big,
        };
        *counter = counter.saturating_add(1);
    }

    /// Counts the stage of a staged answer and hands on its value:
    /// `let sign = counts.note(orient3d_staged(a, b, c, d));`
    #[inline]
    pub fn note<T>(&mut self, (value, stage): (T, Stage)) -> T {
        self.record(stage);
        value
    }

    /// All calls.
    pub fn total(&self) -> u64 {
        self.filter.saturating_add(self.fixed).saturating_add(self.big)
    }
}

impl Add for StageCounts {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            filter: self.filter.saturating_add(other.filter),
            fixed: self.fixed.saturating_add(other.fixed),
            big: self.big.saturating_add(other.big),
        }
    }
}

impl AddAssign for StageCounts {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl std::iter::Sum for StageCounts {
    fn sum<I: Iterator<Item = Self>>(counts: I) -> Self {
        counts.fold(Self::default(), Add::add)
    }
}
