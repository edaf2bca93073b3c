//! One prism as nine points: what operations propose and the invariants judge.

use serde::{Deserialize, Serialize};

use super::limits::minus;
use crate::construct::direction::unit;
use crate::predicate::{orient3d, same_point};
use crate::shell::Slab;
use crate::shell::decomposition::TETS;

/// The three points of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Pillar {
    pub(crate) bottom: [f64; 3],
    pub(crate) middle: [f64; 3],
    pub(crate) top: [f64; 3],
}

impl Pillar {
    /// The ends of the half in a slab, lower one first.
    pub(crate) fn half(&self, slab: Slab) -> [&[f64; 3]; 2] {
        match slab {
            Slab::Bottom => [&self.bottom, &self.middle],
            Slab::Top => [&self.middle, &self.top],
        }
    }

    /// The pillar with both halves shortened to a share of their length.
    pub(crate) fn scaled(&self, share: f64) -> Self {
        let m = self.middle;
        let near = |end: [f64; 3]| std::array::from_fn(|i| m[i] + share * (end[i] - m[i]));
        Self { bottom: near(self.bottom), middle: m, top: near(self.top) }
    }

    /// One point only?
    pub(crate) fn is_pinched(&self) -> bool {
        same_point(&self.bottom, &self.middle) && same_point(&self.middle, &self.top)
    }

    /// Are all coordinates numbers?
    pub(crate) fn is_finite(&self) -> bool {
        [self.bottom, self.middle, self.top].iter().flatten().all(|x| x.is_finite())
    }
}

/// The direction of a pillar, a unit vector.
pub(crate) fn direction(pillar: &Pillar) -> [f64; 3] {
    unit(minus(&pillar.top, &pillar.bottom))
}

/// The straight pillar, up to rounding, at a middle with a direction and lengths.
pub(crate) fn with_lengths(m: &[f64; 3], d: &[f64; 3], down: f64, up: f64) -> Pillar {
    Pillar {
        bottom: std::array::from_fn(|i| m[i] - down * d[i]),
        middle: *m,
        top: std::array::from_fn(|i| m[i] + up * d[i]),
    }
}

/// A prism that may become part of the shell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Prism {
    pub(crate) pillars: [Pillar; 3],
    pub(crate) pinched: [bool; 3],
}

impl Prism {
    /// The point of a slab at a local vertex of the table of tets.
    pub(crate) fn point(&self, slab: Slab, (corner, is_hi): (u8, bool)) -> &[f64; 3] {
        let [lo, hi] = self.pillars[usize::from(corner)].half(slab);
        if is_hi { hi } else { lo }
    }

    /// The tets of a slab whose pillar is not pinched, with the corner of that pillar.
    pub(crate) fn tets(&self, slab: Slab) -> impl Iterator<Item = (usize, [&[f64; 3]; 4])> {
        TETS.iter()
            .filter(|t| !self.pinched[usize::from(t.pillar)])
            .map(move |t| (usize::from(t.pillar), t.vertices.map(|v| self.point(slab, v))))
    }

    /// C1: are all 24 tets positive (those on pinched pillars left out)?
    pub(crate) fn is_positive(&self) -> bool {
        Slab::BOTH
            .into_iter()
            .all(|slab| self.tets(slab).all(|(_, [a, b, c, d])| orient3d(a, b, c, d).is_positive()))
    }

    /// The bottom or top triangle.
    pub(crate) fn outside(&self, slab: Slab) -> [&[f64; 3]; 3] {
        [0, 1, 2].map(|k| match slab {
            Slab::Bottom => &self.pillars[k].bottom,
            Slab::Top => &self.pillars[k].top,
        })
    }

    /// The middle triangle.
    pub(crate) fn middle(&self) -> [&[f64; 3]; 3] {
        [0, 1, 2].map(|k| &self.pillars[k].middle)
    }

    /// All nine points.
    pub(crate) fn points(&self) -> [&[f64; 3]; 9] {
        let p = &self.pillars;
        [
            &p[0].bottom,
            &p[1].bottom,
            &p[2].bottom,
            &p[0].middle,
            &p[1].middle,
            &p[2].middle,
            &p[0].top,
            &p[1].top,
            &p[2].top,
        ]
    }
}
