//! Phong projection, for comparison (Kobbelt et al. 1998; Panozzo et al. 2013): the point of a mesh whose
//! interpolated normal passes through a given point.
//!
//! Floating point and Newton's method; neither injective nor onto in general, and no bound for its error.

use glam::{DMat3, DVec3};
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{PointDistance, RTree};

use crate::mesh::TriMesh;

/// A mesh with unit normals at its vertices and a box tree.
#[derive(Debug)]
pub struct Phong<'a> {
    mesh: &'a TriMesh,
    normals: Vec<DVec3>,
    tree: RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>,
}

/// Triangles are tried from the nearest box on, at most so many.
const MOST: usize = 400;
/// Newton steps.
const STEPS: usize = 30;
/// How far a weight may be below zero: both triangles at an edge may miss a point on it.
const OUTSIDE: f64 = -1e-9;

/// A point of the mesh, and its distance along the normal.
type Found = (u32, [f64; 3], f64);

impl<'a> Phong<'a> {
    /// Normals are area-weighted means over the triangles around a vertex. `O(n log n)`. The mesh's corners
    /// must be in range; coordinates that are not finite give no answers.
    #[must_use]
    pub fn new(mesh: &'a TriMesh) -> Self {
        let mut normals = vec![DVec3::ZERO; mesh.vertices.len()];
        let mut boxes = Vec::with_capacity(mesh.faces.len());
        for (id, face) in (0_u32..).zip(&mesh.faces) {
            let [a, b, c] = face.map(|v| DVec3::from_array(mesh.vertices[v as usize]));
            let normal = (b - a).cross(c - a);
            for &v in face {
                normals[v as usize] += normal;
            }
            if a.is_finite() && b.is_finite() && c.is_finite() {
                let corners = Rectangle::from_corners(a.min(b).min(c).to_array(), a.max(b).max(c).to_array());
                boxes.push(GeomWithData::new(corners, id));
            }
        }
        let normals = normals.into_iter().map(DVec3::normalize_or_zero).collect();
        Self { mesh, normals, tree: RTree::bulk_load(boxes) }
    }

    fn corners(&self, face: u32) -> [DVec3; 3] {
        self.mesh.faces[face as usize].map(|v| DVec3::from_array(self.mesh.vertices[v as usize]))
    }

    fn corner_normals(&self, face: u32) -> [DVec3; 3] {
        self.mesh.faces[face as usize].map(|v| self.normals[v as usize])
    }

    /// The interpolated normal, not of unit length; zero where there is no such triangle.
    #[must_use]
    pub fn normal(&self, face: u32, weights: [f64; 3]) -> [f64; 3] {
        if face as usize >= self.mesh.faces.len() {
            return [0.0; 3];
        }
        mix(self.corner_normals(face), weights).to_array()
    }

    /// The point of the mesh nearest to `p` along its own interpolated normal.
    #[must_use]
    pub fn project(&self, p: [f64; 3]) -> Option<(u32, [f64; 3])> {
        let p = DVec3::from_array(p);
        self.nearest(p, |face| self.newton(face, p))
    }

    /// The point of the mesh where the line through `p` along `direction` meets it, the nearest to `p`.
    #[must_use]
    pub fn cast(&self, p: [f64; 3], direction: [f64; 3]) -> Option<(u32, [f64; 3])> {
        let (p, n) = (DVec3::from_array(p), DVec3::from_array(direction).normalize_or_zero());
        self.nearest(p, |face| {
            let [a, b, c] = self.corners(face);
            let s = solve(DMat3::from_cols(b - a, c - a, -n), p - a)?;
            let weights = [1.0 - s.x - s.y, s.x, s.y];
            weights.iter().all(|&w| w >= OUTSIDE).then_some((face, weights, s.z.abs()))
        })
    }

    /// The best answer of all triangles that can have a better one than those tried.
    fn nearest(&self, p: DVec3, mut one: impl FnMut(u32) -> Option<Found>) -> Option<(u32, [f64; 3])> {
        if !p.is_finite() {
            return None;
        }
        let mut best: Option<Found> = None;
        let at = p.to_array();
        for near in self.tree.nearest_neighbor_iter(&at).take(MOST) {
            // Interpolated normals are no longer than 1, so no answer is nearer than its box.
            if best.is_some_and(|b| near.distance_2(&at) > b.2 * b.2) {
                break;
            }
            if let Some(found) = one(near.data)
                && best.is_none_or(|b| found.2 < b.2)
            {
                best = Some(found);
            }
        }
        best.map(|(face, weights, _)| (face, weights.map(|w| w.max(0.0))))
    }

    /// Solves `x(u, v) + t n(u, v) = p` on one triangle.
    fn newton(&self, face: u32, p: DVec3) -> Option<Found> {
        let ([a, b, c], [k, l, m]) = (self.corners(face), self.corner_normals(face));
        let (mut u, mut v) = (1.0 / 3.0, 1.0 / 3.0);
        let mut t = (p - mix([a, b, c], [u, u, v])).dot(mix([k, l, m], [u, u, v]));
        for _ in 0..STEPS {
            let w = [1.0 - u - v, u, v];
            let n = mix([k, l, m], w);
            let residual = mix([a, b, c], w) + t * n - p;
            let step = solve(DMat3::from_cols(b - a + t * (l - k), c - a + t * (m - k), n), residual)?;
            (u, v, t) = (u - step.x, v - step.y, t - step.z);
            if !(u.abs() < 10.0 && v.abs() < 10.0) {
                return None;
            }
            if step.x.abs() + step.y.abs() < 1e-14 {
                let weights = [1.0 - u - v, u, v];
                return weights.iter().all(|&w| w >= OUTSIDE).then_some((face, weights, t.abs()));
            }
        }
        None
    }
}

fn mix([a, b, c]: [DVec3; 3], [u, v, w]: [f64; 3]) -> DVec3 {
    a * u + b * v + c * w
}

fn solve(matrix: DMat3, right: DVec3) -> Option<DVec3> {
    let x = matrix.inverse() * right;
    x.is_finite().then_some(x)
}
