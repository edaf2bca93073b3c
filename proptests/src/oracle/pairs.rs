//! C6 and the contacts of C3+: every pair of triangles, every pair of triangle and tet.

use std::collections::BTreeSet;

use dashu_int::IBig;

use super::World;
use super::exact::{Point, Weights, clip, cross, dot, minus, positive, simplex};

/// The part of the (possibly flat) triangle `b` in the closed triangle `a`, which has area, as weights on `b`.
fn meet(a: [&Point; 3], b: [&Point; 3]) -> Vec<Weights> {
    let normal = cross(&minus(a[1], a[0]), &minus(a[2], a[0]));
    let form = |direction: &Point, origin: &Point| b.map(|p| dot(direction, &minus(p, origin))).to_vec();
    let plane = form(&normal, a[0]);
    let below: Weights = plane.iter().map(|x| -x).collect();
    let mut out = clip(&clip(&simplex(3), &plane), &below);
    for i in 0..3 {
        let inward = cross(&normal, &minus(a[(i + 1) % 3], a[i]));
        out = clip(&out, &form(&inward, a[i]));
    }
    out
}

/// The weighted point, times the sum of the weights; and that sum.
fn place(points: [&Point; 3], weights: &Weights) -> (Point, IBig) {
    let coordinate = |k: usize| points.iter().zip(weights).map(|(p, w)| &p[k] * w).sum::<IBig>();
    ([coordinate(0), coordinate(1), coordinate(2)], weights.iter().sum())
}

fn is_at((scaled, scale): &(Point, IBig), p: &Point) -> bool {
    (0..3).all(|k| scaled[k] == scale * &p[k])
}

impl World<'_> {
    /// C6 of the mesh: triangles meet in what their common vertices span.
    #[must_use]
    pub fn mesh_embedded(&self) -> bool {
        let n = self.mesh.faces.len();
        (0..n).all(|i| (0..i).all(|j| self.pair_embedded(i, j)))
    }

    fn pair_embedded(&self, i: usize, j: usize) -> bool {
        let common: BTreeSet<u32> =
            self.mesh.faces[i].into_iter().filter(|v| self.mesh.faces[j].contains(v)).collect();
        let shared =
            |w: &Weights| (0..3).all(|k| !positive(&w[k]) || common.contains(&self.mesh.faces[j][k]));
        meet(self.triangle(i), self.triangle(j)).iter().all(shared)
    }

    /// C6 of the mesh against bottom (0) or top (2): no common point, pinched vertices excepted.
    #[must_use]
    pub fn cap_disjoint(&self, layer: u32) -> bool {
        let prisms = &self.shell.faces;
        (0..self.mesh.faces.len())
            .all(|f| prisms.iter().all(|corners| self.pair_disjoint(f, *corners, layer)))
    }

    fn pair_disjoint(&self, f: usize, corners: [u32; 3], layer: u32) -> bool {
        let cap = corners.map(|v| self.at(3 * v + layer));
        let mut pinches =
            corners.into_iter().filter(|&v| self.pinched[v as usize]).map(|v| self.at(3 * v + 1));
        let common: Vec<(Point, IBig)> = meet(self.triangle(f), cap).iter().map(|w| place(cap, w)).collect();
        common.is_empty() || pinches.any(|p| common.iter().all(|x| is_at(x, p)))
    }

    /// The contacts of C3+: every triangle faces up in every tet that it touches, contacts at a pinched vertex
    /// excepted. All tets must be positive.
    #[must_use]
    pub fn contacts_face_up(&self) -> bool {
        let tets = self.tets.all.len();
        (0..self.mesh.faces.len()).all(|f| (0..tets).all(|t| positive(&self.slope(f, t)) || self.apart(f, t)))
    }

    fn apart(&self, f: usize, t: usize) -> bool {
        let mut pinches =
            self.tets.all[t].names.into_iter().filter(|c| self.pinched[(c / 3) as usize]).map(|c| self.at(c));
        let common: Vec<(Point, IBig)> =
            self.meet(f, t).iter().map(|(w, _)| place(self.triangle(f), w)).collect();
        common.is_empty() || pinches.any(|p| common.iter().all(|x| is_at(x, p)))
    }
}
