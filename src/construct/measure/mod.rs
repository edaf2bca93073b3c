//! What a shell is like: thickness, shape, and the distance of its middle surface from the mesh.
//!
//! Thickness and shape are floats, for people: they prove nothing. The distance is an enclosure that is proved.

mod bound;
mod distance;
mod game;
mod nearest;
#[cfg(test)]
mod tests;

use serde::Serialize;

pub use distance::{Distance, Witness, distance};

use super::initial::longest_box_edge as longest;
use super::optimise::{length, mips};
use crate::mesh::TriMesh;
use crate::shell::{Layer, Shell, Slab};

/// How numbers are spread. Floats.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Distribution {
    /// How many numbers there are.
    pub count: usize,
    /// The smallest.
    pub min: f64,
    /// The mean.
    pub mean: f64,
    /// The largest.
    pub max: f64,
    /// The least numbers that at least 10, 20, ..., 90 percent of all are not greater than.
    pub deciles: [f64; 9],
}

impl Distribution {
    /// Of numbers in any order; `None` of none.
    #[must_use]
    pub fn of(mut values: Vec<f64>) -> Option<Self> {
        values.sort_by(f64::total_cmp);
        let (&min, &max) = (values.first()?, values.last()?);
        let n = values.len();
        let at =
            |tenth: usize| values.get((tenth * n).div_ceil(10).saturating_sub(1)).copied().unwrap_or(max);
        let deciles = [1, 2, 3, 4, 5, 6, 7, 8, 9].map(at);
        // Shares before the sum, which might overflow.
        let mean = values.iter().map(|x| x / n as f64).sum();
        Some(Self { count: n, min, mean, max, deciles })
    }

    /// In another unit: `by` is linear and increasing.
    #[must_use]
    pub fn map(&self, by: impl Fn(f64) -> f64) -> Self {
        let (min, mean, max) = (by(self.min), by(self.mean), by(self.max));
        Self { count: self.count, min, mean, max, deciles: self.deciles.map(by) }
    }
}

/// Lengths of the pillar halves in a slab, in the mesh's units, pinched vertices (which have none) left out.
#[must_use]
pub fn thickness(shell: &Shell, slab: Slab) -> Option<Distribution> {
    let [lo, hi] = [slab.lo(), slab.hi()].map(|layer| shell.layer(layer));
    let ids = (0u32..).zip(lo.iter().zip(hi));
    Distribution::of(ids.filter(|(v, _)| !shell.is_pinched(*v)).map(|(_, (p, q))| length(p, q)).collect())
}

/// MIPS energies of the middle triangles; 2 is an equilateral one.
#[must_use]
pub fn energy(shell: &Shell) -> Option<Distribution> {
    let middle = shell.layer(Layer::Middle);
    let corners = |f: &[u32; 3]| f.map(|v| middle.get(v as usize));
    let known = shell.faces.iter().filter_map(|f| match corners(f) {
        [Some(a), Some(b), Some(c)] => Some(mips([a, b, c])),
        _ => None,
    });
    Distribution::of(known.collect())
}

/// The longest edge of a mesh's bounding box: the unit of shares. 0 for a mesh without vertices.
#[must_use]
pub fn longest_box_edge(mesh: &TriMesh) -> f64 {
    longest(mesh).max(0.0)
}
