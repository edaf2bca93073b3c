//! Boundary edges (*Shell* section 3.6): they are never split, so the prism on one has the pillars of both ends and
//! touches all triangles at both. Directions are turned until both ends suit both stars; where that fails one end is
//! pinched, never both.

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
        for edge in edges {
            if self.suits(edge) {
                continue;
            }
            // Of the two ends the one whose further edge does not suit either; then one pinch serves two edges.
            let misfits = |v: u32| self.along(v).iter().filter(|&&u| !self.suits([v, u])).count();
            let free = |v: &u32| self.along(*v).iter().all(|&u| !self.pinched[u as usize]);
            let best = edge.into_iter().filter(free).max_by_key(|&v| misfits(v));
            if let Some(v) = best {
                self.pinched[v as usize] = true;
            }
        }
    }
}
