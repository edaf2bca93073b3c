//! The invariants of every accepted operation (*Shell* Theorem 3.7), exact.
//!
//! For the new prisms: all tets positive; no mesh triangle meets their bottom or top triangles; every mesh triangle that
//! touches a tet has a positive dot with the pillar half that the tet carries (I2 to the letter; the paper's hull
//! condition is stricter). Contacts at a pinched vertex alone are excepted. With the manifold conditions that the
//! operations check, the mesh stays a section in all vertex orders.

use super::prism::Prism;
use super::tree::{Box3, Tree};
use crate::construct::direction::{float_dot, float_normal, unit};
use crate::mesh::TriMesh;
use crate::predicate::{Meeting, dot_sign, point_in_triangle, triangle_tet, triangle_triangle};
use crate::shell::Slab;

/// Judges prisms against a mesh.
#[derive(Debug)]
pub(crate) struct Judge<'a> {
    pub(crate) mesh: &'a TriMesh,
    pub(crate) tree: Tree,
    normals: Vec<[f64; 3]>,
    /// The distortion bound: least cosine between a triangle's normal and the pillars of the tets that it touches.
    least_cosine: f64,
}

/// What a prism is compared by.
struct View<'p> {
    prism: &'p Prism,
    outside: [Box3; 2],
    /// Unit vectors of the six halves, by slab and corner, for the distortion bound.
    halves: [[[f64; 3]; 3]; 2],
}

impl<'p> View<'p> {
    fn new(prism: &'p Prism) -> Self {
        let half = |slab: Slab| {
            [0, 1, 2].map(|k| {
                let [lo, hi] = prism.pillars[k].half(slab);
                unit([hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]])
            })
        };
        Self {
            prism,
            outside: Slab::BOTH.map(|slab| Box3::of(prism.outside(slab))),
            halves: Slab::BOTH.map(half),
        }
    }
}

impl<'a> Judge<'a> {
    /// O(n log n) for n mesh triangles.
    pub(crate) fn new(mesh: &'a TriMesh, least_cosine: f64) -> Self {
        let normals = mesh
            .faces
            .iter()
            .map(|f| float_normal(f.map(|v| &mesh.vertices[v as usize])))
            .collect();
        Self { mesh, tree: Tree::new(mesh), normals, least_cosine }
    }

    /// The corners of a mesh triangle.
    pub(crate) fn corners(&self, f: u32) -> [&'a [f64; 3]; 3] {
        self.mesh.faces[f as usize].map(|v| &self.mesh.vertices[v as usize])
    }

    /// Do all invariants hold for these prisms?
    pub(crate) fn admits(&self, prisms: &[Prism]) -> bool {
        prisms.iter().all(Prism::is_positive) && self.fits(prisms)
    }

    /// Do all invariants about the mesh hold for these prisms?
    pub(crate) fn fits(&self, prisms: &[Prism]) -> bool {
        prisms.iter().all(|p| self.fits_one(p))
    }

    fn fits_one(&self, prism: &Prism) -> bool {
        let view = View::new(prism);
        self.tree.all(&Box3::of(prism.points()), |f| self.pair(&view, f))
    }

    /// Is the mesh triangle where it may be?
    fn pair(&self, view: &View<'_>, f: u32) -> bool {
        let triangle = self.corners(f);
        let bounds = Box3::of(triangle);
        let wrong = Slab::BOTH.map(|slab| self.wrong(view, slab, f, triangle));
        for (s, slab) in Slab::BOTH.into_iter().enumerate() {
            if wrong[s] == [false; 3] {
                continue;
            }
            for (corner, tet) in view.prism.tets(slab) {
                if wrong[s][corner] && bounds.meets(&Box3::of(tet)) {
                    let met = triangle_tet(triangle, tet);
                    if met.meets() && !(met == Meeting::Point && at_pinch(view.prism, triangle)) {
                        return false;
                    }
                }
            }
        }
        Slab::BOTH.into_iter().enumerate().all(|(s, slab)| {
            if !bounds.meets(&view.outside[s]) {
                return true;
            }
            let met = triangle_triangle(triangle, view.prism.outside(slab));
            !met.meets() || (met == Meeting::Point && at_pinch(view.prism, triangle))
        })
    }

    /// Which pillar halves of a slab must not carry a tet that the triangle touches?
    fn wrong(&self, view: &View<'_>, slab: Slab, f: u32, [a, b, c]: [&[f64; 3]; 3]) -> [bool; 3] {
        let s = usize::from(slab == Slab::Top);
        [0, 1, 2].map(|k| {
            let [lo, hi] = view.prism.pillars[k].half(slab);
            !view.prism.pinched[k]
                && (!dot_sign(a, b, c, lo, hi).is_positive()
                    || float_dot(&self.normals[f as usize], &view.halves[s][k]) < self.least_cosine)
        })
    }
}

/// Given that a triangle meets a part of the prism that has all its pinched corners in one point: is it that corner?
fn at_pinch(prism: &Prism, triangle: [&[f64; 3]; 3]) -> bool {
    (0..3).any(|k| prism.pinched[k] && point_in_triangle(&prism.pillars[k].middle, triangle).is_some())
}
