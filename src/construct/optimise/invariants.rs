//! The invariants of every accepted operation (*Shell* Theorem 3.7), exact.
//!
//! For the new prisms: all tets positive; no mesh triangle meets their bottom or top triangles; every mesh triangle that
//! touches a tet has a positive dot with the pillar half that the tet carries (I2 to the letter; the paper's hull
//! condition is stricter). Contacts at a pinched vertex alone are excepted. With the manifold conditions that the
//! operations check, the mesh stays a section in all vertex orders.

use std::borrow::Cow;
use std::cell::Cell;

use super::partner::Partner;
use super::prism::{Pillar, Prism};
use super::state::{Change, State};
use super::tree::{Box3, Tree};
use crate::construct::direction::{float_dot, float_normal, unit};
use crate::mesh::TriMesh;
use crate::predicate::{
    Meeting, Plane, Sign, point_in_triangle, triangle_tet, triangle_touches_tet, triangle_triangle,
};
use crate::shell::Slab;

/// Judges prisms against a mesh.
#[derive(Debug)]
pub(crate) struct Judge<'a> {
    pub(crate) mesh: Cow<'a, TriMesh>,
    pub(crate) tree: Tree,
    pub(crate) normals: Vec<[f64; 3]>,
    planes: Vec<Plane>,
    /// The distortion bound: least cosine between a triangle's normal and the pillars of the tets that it touches.
    least_cosine: f64,
    /// Of a joint shell: the other mesh.
    pub(crate) partner: Option<Box<Partner<'a>>>,
}

/// The mesh triangle that was found in the way last. It is asked first, as it is often in the way of the next proposal for the same
/// place, too. It changes no answer: whatever is in the way of a proposal is reason enough against it.
#[derive(Debug, Default)]
pub(crate) struct Suspect(Cell<Option<u32>>);

/// The mesh triangles that prisms are judged against.
#[derive(Clone, Copy)]
pub(crate) struct Near<'n> {
    /// Ascending; all, where none are tracked.
    pub(crate) tracked: Option<&'n [u32]>,
    /// Which to ask first.
    pub(crate) suspect: &'n Suspect,
}

impl Near<'_> {
    /// The suspect, if it is one of the triangles.
    fn suspect(&self) -> Option<u32> {
        self.suspect.0.get().filter(|f| self.tracked.is_none_or(|list| list.binary_search(f).is_ok()))
    }
}

/// What a prism is compared by.
pub(crate) struct View<'p> {
    pub(crate) prism: &'p Prism,
    pub(crate) outside: [Box3; 2],
    slabs: [Box3; 2],
    /// Unit vectors of the six halves, by slab and corner, for the distortion bound.
    pub(crate) halves: [[[f64; 3]; 3]; 2],
    /// The planes of the bottom, middle and top triangle.
    planes: [Plane; 3],
}

impl<'p> View<'p> {
    pub(crate) fn new(prism: &'p Prism) -> Self {
        let half = |slab: Slab| {
            [0, 1, 2].map(|k| {
                let [lo, hi] = prism.pillars[k].half(slab);
                unit([hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]])
            })
        };
        Self {
            prism,
            outside: Slab::BOTH.map(|slab| Box3::of(prism.outside(slab))),
            slabs: Slab::BOTH.map(|slab| Box3::of(prism.outside(slab).into_iter().chain(prism.middle()))),
            halves: Slab::BOTH.map(half),
            planes: [prism.outside(Slab::Bottom), prism.middle(), prism.outside(Slab::Top)].map(Plane::of),
        }
    }

    /// Is the triangle strictly beyond one of the two triangles that the slab lies between? A positive prism has all its points in
    /// the slab between them or on them: the corners of the upper one are above the lower one, and conversely.
    fn is_beyond(&self, slab: Slab, triangle: [&[f64; 3]; 3]) -> bool {
        let [bottom, middle, top] = &self.planes;
        let (middle, outside) = ((middle, self.prism.middle()), self.prism.outside(slab));
        let (lo, hi) = match slab {
            Slab::Bottom => ((bottom, outside), middle),
            Slab::Top => (middle, (top, outside)),
        };
        let all = |(plane, corners): (&Plane, _), side| {
            triangle.into_iter().all(|x| plane.side(corners, x) == side)
        };
        all(lo, Sign::Negative) || all(hi, Sign::Positive)
    }

    /// Is the triangle strictly on one side of the slab's outside triangle?
    fn is_off(&self, slab: Slab, triangle: [&[f64; 3]; 3]) -> bool {
        let plane = &self.planes[if slab == Slab::Bottom { 0 } else { 2 }];
        let [x, y, z] = triangle.map(|x| plane.side(self.prism.outside(slab), x));
        !x.is_zero() && x == y && x == z
    }
}

impl<'a> Judge<'a> {
    /// O(n log n) for n mesh triangles.
    pub(crate) fn new(mesh: Cow<'a, TriMesh>, least_cosine: f64) -> Self {
        let corners = |f: &[u32; 3]| f.map(|v| &mesh.vertices[v as usize]);
        let normals = mesh.faces.iter().map(|f| float_normal(corners(f))).collect();
        let planes = mesh.faces.iter().map(|f| Plane::of(corners(f))).collect();
        Self { tree: Tree::new(&mesh), mesh, normals, planes, least_cosine, partner: None }
    }

    /// The corners of a mesh triangle.
    pub(crate) fn corners(&self, f: u32) -> [&[f64; 3]; 3] {
        self.mesh.faces[f as usize].map(|v| &self.mesh.vertices[v as usize])
    }

    /// Do all invariants hold after the change, and the distortion bound, or is the distortion at least no worse than
    /// before? Where the state has a skin, does that stay free of self-intersection?
    pub(crate) fn admits(&self, state: &State, change: &Change) -> bool {
        self.admits_one_of_many(state, change, &Suspect::default())
    }

    /// As [`Self::admits`], one proposal after another for the same place.
    pub(crate) fn admits_one_of_many(&self, state: &State, change: &Change, suspect: &Suspect) -> bool {
        let tracked = state.candidates(change);
        let near = Near { tracked: tracked.as_deref(), suspect };
        self.prefers(&state.prisms(change), near, || state.prisms_before(change))
            && state.skin.as_ref().is_none_or(|skin| skin.admits(state, change))
    }

    /// Do all invariants hold of the prisms `after`, and the distortion bound, or is it at least no worse than in
    /// those before? Nor may a partner be violated more.
    pub(crate) fn prefers(&self, after: &[Prism], near: Near<'_>, before: impl Fn() -> Vec<Prism>) -> bool {
        self.keeps_prisms(after, near, &before)
            && self.partner.as_ref().is_none_or(|p| p.prefers(after, before))
    }

    /// As [`Self::admits`], whatever the partner.
    pub(crate) fn keeps(&self, state: &State, change: &Change) -> bool {
        let tracked = state.candidates(change);
        let near = Near { tracked: tracked.as_deref(), suspect: &Suspect::default() };
        self.keeps_prisms(&state.prisms(change), near, || state.prisms_before(change))
            && state.skin.as_ref().is_none_or(|skin| skin.admits(state, change))
    }

    fn keeps_prisms(&self, after: &[Prism], near: Near<'_>, before: impl FnOnce() -> Vec<Prism>) -> bool {
        after.iter().all(Prism::is_positive)
            && self.worst_cosine(after, near).is_some_and(|cosine| {
                cosine >= self.least_cosine
                    || self.worst_cosine(&before(), near).is_some_and(|before| cosine >= before)
            })
    }

    /// Do the invariants hold of a prism?
    pub(crate) fn holds(&self, prism: &Prism) -> bool {
        let near = Near { tracked: None, suspect: &Suspect::default() };
        prism.is_positive() && self.worst_cosine(std::slice::from_ref(prism), near).is_some()
    }

    /// Of positive prisms: the smallest cosine that the distortion bound is about, or the bound where all are larger;
    /// `None` where an invariant about the mesh is broken.
    fn worst_cosine(&self, prisms: &[Prism], near: Near<'_>) -> Option<f64> {
        let is_in_the_way = |f| prisms.iter().any(|prism| self.pair(&View::new(prism), f).is_none());
        if near.suspect().is_some_and(is_in_the_way) {
            return None;
        }
        let mut worst = self.least_cosine;
        let fits = prisms.iter().all(|prism| {
            let view = View::new(prism);
            let bounds = Box3::of(prism.points());
            let mut fits = |f: u32| {
                let found = self.pair(&view, f);
                worst = worst.min(found.unwrap_or(worst));
                if found.is_none() {
                    near.suspect.0.set(Some(f));
                }
                found.is_some()
            };
            match near.tracked {
                None => self.tree.all(&bounds, fits),
                Some(list) => {
                    let near = |f: &u32| bounds.meets(&Box3::of(self.corners(*f)));
                    list.iter().copied().filter(near).all(&mut fits)
                }
            }
        });
        fits.then_some(worst)
    }

    /// For a mesh triangle where it may be, the smallest cosine or the bound; else `None`.
    fn pair(&self, view: &View<'_>, f: u32) -> Option<f64> {
        let triangle = self.corners(f);
        let bounds = Box3::of(triangle);
        let mut worst = self.least_cosine;
        for (s, slab) in Slab::BOTH.into_iter().enumerate() {
            if !bounds.meets(&view.slabs[s]) {
                continue;
            }
            let facing = self.facing(view, slab, f, triangle);
            if facing.iter().all(|cosine| *cosine >= self.least_cosine) {
                continue;
            }
            if view.is_beyond(slab, triangle) || self.has_on_one_side(f, view.prism, slab) {
                continue;
            }
            for (corner, tet) in view.prism.tets(slab) {
                let cosine = facing[corner];
                if cosine < worst
                    && bounds.meets(&Box3::of(tet))
                    && triangle_touches_tet(triangle, tet)
                    && !only_at_pinch(view.prism, triangle, tet)
                {
                    if cosine == f64::NEG_INFINITY {
                        return None;
                    }
                    worst = cosine;
                }
            }
        }
        let apart = Slab::BOTH.into_iter().enumerate().all(|(s, slab)| {
            if !bounds.meets(&view.outside[s]) || view.is_off(slab, triangle) {
                return true;
            }
            // The plane of the larger one first: it has most triangles on one side.
            let met = triangle_triangle(view.prism.outside(slab), triangle);
            !met.meets() || (met == Meeting::Point && at_pinch(view.prism, triangle))
        });
        apart.then_some(worst)
    }

    /// Does the mesh triangle's plane have all points of the slab strictly on one side?
    fn has_on_one_side(&self, f: u32, prism: &Prism, slab: Slab) -> bool {
        let (triangle, plane) = (self.corners(f), &self.planes[f as usize]);
        let first = plane.side(triangle, prism.pillars[0].half(slab)[0]);
        let same = |pillar: &Pillar| pillar.half(slab).into_iter().all(|p| plane.side(triangle, p) == first);
        !first.is_zero() && prism.pillars.iter().all(same)
    }

    /// The unit normals of the mesh triangles in some prisms.
    pub(crate) fn normals_in(&self, prisms: &[Prism]) -> Vec<[f64; 3]> {
        let mut found: Vec<u32> = Vec::new();
        for prism in prisms {
            self.tree.all(&Box3::of(prism.points()), |f| {
                let triangle = self.corners(f);
                let bounds = Box3::of(triangle);
                let touches = |slab| {
                    prism
                        .tets(slab)
                        .any(|(_, tet)| bounds.meets(&Box3::of(tet)) && triangle_tet(triangle, tet).meets())
                };
                if Slab::BOTH.into_iter().any(touches) {
                    found.push(f);
                }
                true
            });
        }
        found.sort_unstable();
        found.dedup();
        found.into_iter().map(|f| self.normals[f as usize]).collect()
    }

    /// The cosines between the triangle's normal and the pillar halves of a slab, in floats; minus infinity where the
    /// exact dot product is not positive, and plus infinity at a pinched corner.
    pub(crate) fn facing(&self, view: &View<'_>, slab: Slab, f: u32, triangle: [&[f64; 3]; 3]) -> [f64; 3] {
        let s = usize::from(slab == Slab::Top);
        [0, 1, 2].map(|k| {
            let [lo, hi] = view.prism.pillars[k].half(slab);
            if view.prism.pinched[k] {
                f64::INFINITY
            } else if self.planes[f as usize].dot_sign(triangle, lo, hi).is_positive() {
                // Where the float is not positive, although the exact value is, it says "nearly none".
                float_dot(&self.normals[f as usize], &view.halves[s][k]).max(0.0)
            } else {
                f64::NEG_INFINITY
            }
        })
    }
}

/// Given that a triangle meets a tet of the prism: in a pinched corner alone?
fn only_at_pinch(prism: &Prism, triangle: [&[f64; 3]; 3], tet: [&[f64; 3]; 4]) -> bool {
    prism.pinched.contains(&true)
        && triangle_tet(triangle, tet) == Meeting::Point
        && at_pinch(prism, triangle)
}

/// Given that a triangle meets a part of the prism that has all its pinched corners in one point: is it that corner?
pub(crate) fn at_pinch(prism: &Prism, triangle: [&[f64; 3]; 3]) -> bool {
    (0..3).any(|k| prism.pinched[k] && point_in_triangle(&prism.pillars[k].middle, triangle).is_some())
}
