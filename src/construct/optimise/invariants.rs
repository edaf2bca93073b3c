//! The invariants of every accepted operation (*Shell* Theorem 3.7), exact.
//!
//! For the new prisms: all tets positive; no mesh triangle meets their bottom or top triangles; every mesh triangle that
//! touches a tet has a positive dot with the pillar half that the tet carries (I2 to the letter; the paper's hull
//! condition is stricter). Contacts at a pinched vertex alone are excepted. With the manifold conditions that the
//! operations check, the mesh stays a section in all vertex orders.

use super::prism::Prism;
use super::state::{Change, State};
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
    /// Another mesh that is to become a section, too.
    pub(crate) partner: Option<Box<Judge<'a>>>,
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
        let normals =
            mesh.faces.iter().map(|f| float_normal(f.map(|v| &mesh.vertices[v as usize]))).collect();
        Self { mesh, tree: Tree::new(mesh), normals, least_cosine, partner: None }
    }

    /// The corners of a mesh triangle.
    pub(crate) fn corners(&self, f: u32) -> [&'a [f64; 3]; 3] {
        self.mesh.faces[f as usize].map(|v| &self.mesh.vertices[v as usize])
    }

    /// Do all invariants hold after the change, and the distortion bound, or is the distortion at least no worse than
    /// before?
    pub(crate) fn admits(&self, state: &State, change: &Change) -> bool {
        let after = state.prisms(change);
        self.joint(state, change, &after)
            && after.iter().all(Prism::is_positive)
            && self.worst_cosine(&after).is_some_and(|cosine| {
                cosine >= self.least_cosine
                    || self.worst_cosine(&state.prisms_before(change)).is_some_and(|before| cosine >= before)
            })
    }

    fn joint(&self, state: &State, change: &Change, after: &[Prism]) -> bool {
        let Some(partner) = &self.partner else { return true };
        let now = partner.violation(after);
        now <= 0.0 || now <= partner.violation(&state.prisms_before(change))
    }

    /// How far the prisms are from holding this mesh as a section.
    pub(crate) fn violation(&self, prisms: &[Prism]) -> f64 {
        prisms.iter().map(|p| self.violation_of(p)).sum()
    }

    pub(crate) fn violation_of(&self, prism: &Prism) -> f64 {
        let view = View::new(prism);
        let mut sum = 0.0;
        for pillar in prism.pillars {
            let n = super::cast::count(self, &pillar.bottom, &pillar.top);
            sum += f64::from((n - 1).abs());
        }
        self.tree.all(&Box3::of(prism.points()), |f| {
            let triangle = self.corners(f);
            let bounds = Box3::of(triangle);
            for (s, slab) in Slab::BOTH.into_iter().enumerate() {
                let facing = self.facing(&view, slab, f, triangle);
                if facing.iter().any(|c| *c == f64::NEG_INFINITY) {
                    for (corner, tet) in view.prism.tets(slab) {
                        if facing[corner] == f64::NEG_INFINITY && bounds.meets(&Box3::of(tet)) {
                            let met = triangle_tet(triangle, tet);
                            if met.meets() && !(met == Meeting::Point && at_pinch(view.prism, triangle)) {
                                let cos = float_dot(&self.normals[f as usize], &view.halves[s][corner]);
                                sum += 0.1 + (-cos).max(0.0);
                            }
                        }
                    }
                }
                if bounds.meets(&view.outside[s]) {
                    let met = triangle_triangle(triangle, view.prism.outside(slab));
                    if met.meets() && !(met == Meeting::Point && at_pinch(view.prism, triangle)) {
                        sum += 1.0;
                    }
                }
            }
            true
        });
        sum
    }

    /// Normals of triangles near the prisms.
    pub(crate) fn normals_near(&self, prisms: &[Prism]) -> Vec<[f64; 3]> {
        let mut out: Vec<u32> = Vec::new();
        for p in prisms {
            self.tree.all(&Box3::of(p.points()), |f| {
                let t = self.corners(f);
                if [Slab::Bottom, Slab::Top].into_iter().any(|s| p.tets(s).any(|(_, tet)| Box3::of(t).meets(&Box3::of(tet)) && triangle_tet(t, tet).meets())) {
                    out.push(f);
                }
                true
            });
        }
        out.sort_unstable();
        out.dedup();
        out.into_iter().map(|f| self.normals[f as usize]).collect()
    }

    /// The smallest cosine that the distortion bound is about, or the bound where all are larger; `None` where an
    /// invariant about the mesh is broken.
    fn worst_cosine(&self, prisms: &[Prism]) -> Option<f64> {
        let mut worst = self.least_cosine;
        let fits = prisms.iter().all(|prism| {
            let view = View::new(prism);
            self.tree.all(&Box3::of(prism.points()), |f| {
                let found = self.pair(&view, f);
                worst = worst.min(found.unwrap_or(worst));
                found.is_some()
            })
        });
        fits.then_some(worst)
    }

    /// For a mesh triangle where it may be, the smallest cosine or the bound; else `None`.
    fn pair(&self, view: &View<'_>, f: u32) -> Option<f64> {
        let triangle = self.corners(f);
        let bounds = Box3::of(triangle);
        let mut worst = self.least_cosine;
        for slab in Slab::BOTH {
            let facing = self.facing(view, slab, f, triangle);
            if facing.iter().all(|cosine| *cosine >= self.least_cosine) {
                continue;
            }
            for (corner, tet) in view.prism.tets(slab) {
                let cosine = facing[corner];
                if cosine < worst && bounds.meets(&Box3::of(tet)) {
                    let met = triangle_tet(triangle, tet);
                    if met.meets() && !(met == Meeting::Point && at_pinch(view.prism, triangle)) {
                        if cosine == f64::NEG_INFINITY {
                            return None;
                        }
                        worst = cosine;
                    }
                }
            }
        }
        let apart = Slab::BOTH.into_iter().enumerate().all(|(s, slab)| {
            if !bounds.meets(&view.outside[s]) {
                return true;
            }
            let met = triangle_triangle(triangle, view.prism.outside(slab));
            !met.meets() || (met == Meeting::Point && at_pinch(view.prism, triangle))
        });
        apart.then_some(worst)
    }

    /// The cosines between the triangle's normal and the pillar halves of a slab, in floats; minus infinity where the
    /// exact dot product is not positive, and plus infinity at a pinched corner.
    fn facing(&self, view: &View<'_>, slab: Slab, f: u32, [a, b, c]: [&[f64; 3]; 3]) -> [f64; 3] {
        let s = usize::from(slab == Slab::Top);
        [0, 1, 2].map(|k| {
            let [lo, hi] = view.prism.pillars[k].half(slab);
            if view.prism.pinched[k] {
                f64::INFINITY
            } else if dot_sign(a, b, c, lo, hi).is_positive() {
                // Where the float is not positive, although the exact value is, it says "nearly none".
                float_dot(&self.normals[f as usize], &view.halves[s][k]).max(0.0)
            } else {
                f64::NEG_INFINITY
            }
        })
    }
}

/// Given that a triangle meets a part of the prism that has all its pinched corners in one point: is it that corner?
fn at_pinch(prism: &Prism, triangle: [&[f64; 3]; 3]) -> bool {
    (0..3).any(|k| prism.pinched[k] && point_in_triangle(&prism.pillars[k].middle, triangle).is_some())
}
