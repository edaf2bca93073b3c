//! Topological beveling (*Shell* section 3.3, Figure 9, and the singular-vertex pattern of section 3.5): refines the mesh
//! without moving it, so that no prism has pillars of the wrong direction for a triangle that it touches.
//!
//! A beveled triangle gets two points on each edge and one inside near each corner (two near a pinched corner), each
//! with the pillar of the corner that it is near. Near a pinched corner, which has no pillar, the points on an edge get
//! the mean normal of the edge's two triangles and so do the inner points beside them. Other triangles that share a
//! beveled edge are cut up without new inner points. Boundary edges are never split: a rounded point would not lie on
//! the edge, and the mesh would leave the shell through the wall.

use rustc_hash::FxHashMap;

use super::direction::{direction_for, float_normal, is_proved, unit};
use super::draft::Draft;
use crate::mesh::connectivity::Side;
use crate::mesh::{Connectivity, TriMesh};
use crate::predicate::dot_sign;

/// What the stages before know.
pub(crate) struct Input<'a> {
    pub(crate) mesh: &'a TriMesh,
    pub(crate) connectivity: &'a Connectivity,
    /// Unit directions; of pinched vertices unused.
    pub(crate) direction: &'a [[f64; 3]],
    pub(crate) pinched: &'a [bool],
}

impl Input<'_> {
    fn corners(&self, f: u32) -> [&[f64; 3]; 3] {
        self.mesh.faces[f as usize].map(|v| &self.mesh.vertices[v as usize])
    }

    /// Triangles that share a vertex with `f`, itself included; with repetitions.
    fn around(&self, f: u32) -> impl Iterator<Item = u32> + '_ {
        self.mesh.faces[f as usize].into_iter().flat_map(|v| self.connectivity.star(v)).map(|c| c.face())
    }

    /// Is the prism over `f` as it stands a bad one: a triangle at one of its corners has a dot that is not positive
    /// with a pillar, or a corner is pinched?
    fn needs_bevel(&self, f: u32) -> bool {
        let face = self.mesh.faces[f as usize];
        if face.iter().any(|&v| self.pinched[v as usize]) {
            return true;
        }
        let origin = [0.0; 3];
        self.around(f).any(|g| {
            let [a, b, c] = self.corners(g);
            face.iter().any(|&v| !dot_sign(a, b, c, &origin, &self.direction[v as usize]).is_positive())
        })
    }

    /// The triangles to bevel.
    pub(crate) fn to_bevel(&self) -> Vec<bool> {
        use rayon::prelude::*;
        (0..self.mesh.faces.len() as u32).into_par_iter().map(|f| self.needs_bevel(f)).collect()
    }
}

/// How far from a corner the new points are, as a share of the edge.
const SHARE: f64 = 0.2;

fn blend(points: &[(&[f64; 3], f64)]) -> [f64; 3] {
    std::array::from_fn(|i| points.iter().map(|(p, w)| p[i] * w).sum())
}

struct Beveler<'a> {
    input: &'a Input<'a>,
    bevel: &'a [bool],
    draft: Draft,
    /// The two new vertices on an edge `[u, w]`, `u < w`: near `u`, near `w`.
    on_edge: FxHashMap<[u32; 2], [u32; 2]>,
}

/// The refined mesh as a draft without thickness.
pub(crate) fn bevel(input: &Input<'_>, bevel: &[bool]) -> Draft {
    let mut work = Beveler { input, bevel, draft: Draft::default(), on_edge: FxHashMap::default() };
    for (v, at) in input.mesh.vertices.iter().enumerate() {
        work.draft.push(*at, input.direction[v], input.pinched[v], v as u32);
    }
    for f in 0..input.mesh.faces.len() as u32 {
        if bevel[f as usize] { work.beveled(f) } else { work.conforming(f) }
    }
    work.draft
}

impl Beveler<'_> {
    fn triangle(&mut self, face: [u32; 3], origin: u32) {
        self.draft.faces.push(face);
        self.draft.origin.push(origin);
    }

    /// The new vertices on side `i` of `f` in the direction of the triangle, if the edge is split.
    fn side(&mut self, f: u32, i: u32) -> Option<[u32; 2]> {
        let side = Side::new(f, i);
        let mate = self.input.connectivity.mate(side)?;
        if !self.bevel[f as usize] && !self.bevel[mate.face() as usize] {
            return None;
        }
        let [u, w] = self.input.connectivity.ends(side);
        let key = [u.min(w), u.max(w)];
        let pair = match self.on_edge.get(&key) {
            Some(pair) => *pair,
            None => {
                let pair = [self.near(key, [f, mate.face()]), self.near([key[1], key[0]], [f, mate.face()])];
                self.on_edge.insert(key, pair);
                pair
            }
        };
        Some(if u == key[0] { pair } else { [pair[1], pair[0]] })
    }

    /// The new vertex on the edge from `v` to `w` near `v`.
    fn near(&mut self, [v, w]: [u32; 2], faces: [u32; 2]) -> u32 {
        let (p, q) = (&self.input.mesh.vertices[v as usize], &self.input.mesh.vertices[w as usize]);
        let at = blend(&[(p, 1.0 - SHARE), (q, SHARE)]);
        let direction = self.pillar(v, faces);
        self.draft.push(at, direction, false, v)
    }

    /// The pillar of `v`, or, where it has none, of the edge between two triangles.
    fn pillar(&self, v: u32, faces: [u32; 2]) -> [f64; 3] {
        if !self.input.pinched[v as usize] {
            return self.input.direction[v as usize];
        }
        let [a, b] = faces.map(|f| float_normal(self.input.corners(f)));
        let mean = unit(std::array::from_fn(|i| a[i] + b[i]));
        if is_proved(self.input.mesh, &faces, &mean) {
            return mean;
        }
        direction_for(self.input.mesh, &faces).unwrap_or(a)
    }

    /// Cuts up a triangle that is not beveled: a fan over its corners and the points on its sides.
    fn conforming(&mut self, f: u32) {
        let face = self.input.mesh.faces[f as usize];
        // Each ring vertex with the sides that it lies on: side i runs from corner i to the next one.
        let mut ring: Vec<(u32, u8)> = Vec::with_capacity(9);
        for (i, &corner) in face.iter().enumerate() {
            ring.push((corner, 1 << i | 1 << ((i + 2) % 3)));
            // Seen from the opposite corner it is side i + 2.
            let points = self.side(f, ((i + 2) % 3) as u32);
            ring.extend(points.into_iter().flatten().map(|v| (v, 1 << i)));
        }
        self.fan(ring, f);
    }

    /// Triangulates a ring of points on a triangle's sides without flat triangles: corners between two split sides are
    /// cut off, then a fan from a point that allows one.
    fn fan(&mut self, mut ring: Vec<(u32, u8)>, f: u32) {
        for corner in self.input.mesh.faces[f as usize] {
            let n = ring.len();
            let Some(k) = ring.iter().position(|(v, _)| *v == corner) else { continue };
            let (before, after) = (ring[(k + n - 1) % n], ring[(k + 1) % n]);
            if before.1.count_ones() == 1 && after.1.count_ones() == 1 {
                self.triangle([before.0, corner, after.0], f);
                ring.remove(k);
            }
        }
        let n = ring.len();
        let flat = |from: usize| {
            (1..n - 1).any(|i| ring[from].1 & ring[(from + i) % n].1 & ring[(from + i + 1) % n].1 != 0)
        };
        let from = (0..n).find(|&k| !flat(k)).unwrap_or(0);
        for i in 1..n - 1 {
            self.triangle([ring[from].0, ring[(from + i) % n].0, ring[(from + i + 1) % n].0], f);
        }
    }

    /// Pattern (a).
    fn beveled(&mut self, f: u32) {
        let face = self.input.mesh.faces[f as usize];
        let split = [0, 1, 2].map(|i| self.side(f, i));
        // At corner i: the point on the side that leaves it, and on the side that arrives.
        let leaving = |i: usize| split[(i + 2) % 3].map(|pair| pair[0]);
        let arriving = |i: usize| split[(i + 1) % 3].map(|pair| pair[1]);
        // Inner points near each corner: beside the leaving and beside the arriving side; the same unless pinched.
        let inner = [0, 1, 2].map(|i| self.inner(f, i, leaving(i), arriving(i)));
        for i in 0..3usize {
            let (a, [first, last]) = (face[i], inner[i]);
            // Without a point on it the side is whole, and its strip below holds the corner itself.
            if let Some(p) = leaving(i) {
                self.triangle([a, p, first], f);
            }
            if first != last {
                self.triangle([a, first, last], f);
            }
            if let Some(q) = arriving(i) {
                self.triangle([a, last, q], f);
            }
            // The strip along the side that leaves corner i.
            let j = (i + 1) % 3;
            let (from, to) = (leaving(i).unwrap_or(a), arriving(j).unwrap_or(face[j]));
            let (far, near) = (inner[j][1], first);
            self.triangle([from, to, far], f);
            self.triangle([from, far, near], f);
        }
        let mut ring: Vec<u32> = Vec::with_capacity(6);
        for [first, last] in inner {
            // Around the middle, counter-clockwise: the point beside the arriving side comes first.
            ring.push(last);
            if first != last {
                ring.push(first);
            }
        }
        for i in 1..ring.len() - 1 {
            self.triangle([ring[0], ring[i], ring[i + 1]], f);
        }
    }

    /// The inner points near corner `i`: `[beside the leaving side, beside the arriving side]`.
    fn inner(&mut self, f: u32, i: usize, leaving: Option<u32>, arriving: Option<u32>) -> [u32; 2] {
        let face = self.input.mesh.faces[f as usize];
        let [a, b, c] = [0, 1, 2].map(|k| face[(i + k) % 3]);
        let at = |v: u32| &self.input.mesh.vertices[v as usize];
        let place = |x: f64, y: f64| blend(&[(at(a), 1.0 - x - y), (at(b), x), (at(c), y)]);
        if !self.input.pinched[a as usize] {
            let at = place(SHARE, SHARE);
            let id = self.draft.push(at, self.input.direction[a as usize], false, a);
            return [id, id];
        }
        let normal = float_normal(self.input.corners(f));
        let copied = |draft: &Draft, v: Option<u32>| v.map_or(normal, |v| draft.direction[v as usize]);
        let (beside_leaving, beside_arriving) =
            (place(1.5 * SHARE, 0.75 * SHARE), place(0.75 * SHARE, 1.5 * SHARE));
        let (d, e) = (copied(&self.draft, leaving), copied(&self.draft, arriving));
        [self.draft.push(beside_leaving, d, false, a), self.draft.push(beside_arriving, e, false, a)]
    }
}
