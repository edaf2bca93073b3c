//! A second mesh that is to become a section of the same shell (a *joint shell*).
//!
//! The shell is valid around its own mesh at every moment. How far it is from holding the partner, too, is measured by
//! a *violation*, which no operation increases and repairs (`repair.rs`) lower. Floats steer here: that a shell with
//! violation zero holds the partner is for the certifier to say.

use std::borrow::Cow;

use super::cast;
use super::invariants::{Judge, View, at_pinch};
use super::prism::{Pillar, Prism};
use super::tree::Box3;
use crate::construct::direction::float_dot;
use crate::mesh::TriMesh;
use crate::predicate::{Meeting, triangle_tet, triangle_triangle};
use crate::shell::Slab;

/// What a contact in the wrong direction counts at least; its sine of inclination is added.
const FOLD: f64 = 0.1;

/// The partner mesh.
#[derive(Debug)]
pub(crate) struct Partner<'a>(Judge<'a>);

impl Partner<'_> {
    /// O(n log n).
    pub(crate) fn new(mesh: TriMesh) -> Self {
        Self(Judge::new(Cow::Owned(mesh), 0.0))
    }

    /// Is the partner violated no more after a change than before?
    pub(crate) fn prefers(&self, after: &[Prism], before: impl FnOnce() -> Vec<Prism>) -> bool {
        let now = self.violation(after);
        now <= 0.0 || now <= self.violation(&before())
    }

    /// How far some prisms are from holding the partner: the pillars that do not cross it just once, its triangles that
    /// meet bottom or top, and its triangles that touch tets in the wrong direction.
    pub(crate) fn violation(&self, prisms: &[Prism]) -> f64 {
        let mut pillars: Vec<(&Pillar, [u64; 3])> = prisms
            .iter()
            .flat_map(|p| (0..3).filter(|&k| !p.pinched[k]).map(|k| &p.pillars[k]))
            .map(|pillar| (pillar, pillar.middle.map(f64::to_bits)))
            .collect();
        pillars.sort_by_key(|(_, key)| *key);
        pillars.dedup_by_key(|(_, key)| *key);
        let crossings =
            |(p, _): &(&Pillar, _)| f64::from(cast::crossings(&self.0, &p.bottom, &p.top).abs_diff(1));
        pillars.iter().map(crossings).sum::<f64>() + prisms.iter().map(|p| self.of(p)).sum::<f64>()
    }

    /// The part of a prism's own triangles and tets.
    fn of(&self, prism: &Prism) -> f64 {
        let view = View::new(prism);
        let mut sum = 0.0;
        self.0.tree.all(&Box3::of(prism.points()), |f| {
            sum += self.of_pair(&view, f);
            true
        });
        sum
    }

    fn of_pair(&self, view: &View<'_>, f: u32) -> f64 {
        let triangle = self.0.corners(f);
        let bounds = Box3::of(triangle);
        let counts = |met: Meeting| met.meets() && !(met == Meeting::Point && at_pinch(view.prism, triangle));
        let mut sum = 0.0;
        for (s, slab) in Slab::BOTH.into_iter().enumerate() {
            let facing = self.0.facing(view, slab, f, triangle);
            for (corner, tet) in view.prism.tets(slab) {
                if facing[corner] == f64::NEG_INFINITY
                    && bounds.meets(&Box3::of(tet))
                    && counts(triangle_tet(triangle, tet))
                {
                    let cosine = float_dot(&self.0.normals[f as usize], &view.halves[s][corner]);
                    sum += FOLD + (-cosine).max(0.0);
                }
            }
            let meets = bounds.meets(&view.outside[s])
                && counts(triangle_triangle(triangle, view.prism.outside(slab)));
            sum += f64::from(u8::from(meets));
        }
        sum
    }

    /// The unit normals of the partner's triangles in some prisms.
    pub(crate) fn normals_in(&self, prisms: &[Prism]) -> Vec<[f64; 3]> {
        self.0.normals_in(prisms)
    }
}
