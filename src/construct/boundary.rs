//! Boundary edges (*Shell* section 3.6): they are never split, so the prism on one has the pillars of both ends and
//! touches all triangles at both. Directions are turned until both ends suit both stars; where that fails one end is
//! pinched, never both.

use rustc_hash::{FxHashMap, FxHashSet};

use super::direction::{direction_for, is_proved};
use crate::mesh::{Connectivity, TriMesh};

/// The state of directions and pinching that boundary edges change.
pub(crate) struct Pillars<'a> {
    pub(crate) mesh: &'a TriMesh,
    pub(crate) connectivity: &'a Connectivity,
    pub(crate) direction: &'a mut [[f64; 3]],
    pub(crate) pinched: &'a mut [bool],
}

impl Pillars<'_> {
    fn star(&self, v: u32) -> Vec<u32> {
        self.connectivity.star(v).iter().map(|c| c.face()).collect()
    }

    /// Is a pillar at each end, where there is one, positive for all triangles at the other end?
    fn suits(&self, [u, w]: [u32; 2]) -> bool {
        let one = |a: u32, b: u32| {
            let pinched = self.pinched[a as usize] || self.pinched[b as usize];
            pinched || is_proved(self.mesh, &self.star(b), &self.direction[a as usize])
        };
        one(u, w) && one(w, u)
    }

    /// The ends of boundary edges at `v`, other than `v`.
    fn along(&self, v: u32) -> Vec<u32> {
        let star = self.connectivity.star(v).iter();
        let sides =
            star.flat_map(|c| [c.next(), c.previous()]).filter(|s| self.connectivity.mate(*s).is_none());
        sides.flat_map(|s| self.connectivity.ends(s)).filter(|u| *u != v).collect()
    }

    /// Makes every boundary edge suit, by turning directions, then by pinching. Edges that still do not suit are left;
    /// building will fail on them and say where.
    pub(crate) fn settle(&mut self) {
        let edges: Vec<[u32; 2]> = self.connectivity.boundary().map(|s| self.connectivity.ends(s)).collect();
        for v in edges.iter().flatten().copied() {
            if self.pinched[v as usize] || self.along(v).iter().all(|&u| self.suits([v, u])) {
                continue;
            }
            let mut faces = self.star(v);
            self.along(v).iter().for_each(|&u| faces.extend(self.star(u)));
            faces.sort_unstable();
            faces.dedup();
            if let Some(d) = direction_for(self.mesh, &faces) {
                self.direction[v as usize] = d;
            }
        }
        for chain in self.chains() {
            self.pinch_along(&chain);
        }
    }

    /// The boundary loops as edges head to tail, each from an edge that suits, if there is one.
    fn chains(&self) -> Vec<Vec<[u32; 2]>> {
        let next: FxHashMap<u32, u32> =
            self.connectivity.boundary().map(|s| self.connectivity.ends(s)).map(|[u, w]| (u, w)).collect();
        let mut starts: Vec<u32> = next.keys().copied().collect();
        starts.sort_unstable();
        let mut seen = FxHashSet::default();
        let mut out = Vec::new();
        for start in starts {
            let mut chain = Vec::new();
            let mut at = start;
            while seen.insert(at) {
                let Some(&to) = next.get(&at) else { break };
                chain.push([at, to]);
                at = to;
            }
            let first = chain.iter().position(|e| self.suits(*e)).unwrap_or(0);
            chain.rotate_left(first);
            out.push(chain);
        }
        out
    }

    /// Pinches the far end of every edge that does not suit, so that one pinch serves two edges; where the end after it
    /// is pinched already, the near end.
    fn pinch_along(&mut self, chain: &[[u32; 2]]) {
        for &[u, w] in chain {
            if self.suits([u, w]) {
                continue;
            }
            let free = |v: u32| self.along(v).iter().all(|&u| !self.pinched[u as usize]);
            if let Some(v) = [w, u].into_iter().find(|v| free(*v)) {
                self.pinched[v as usize] = true;
            }
        }
    }
}
