//! The projection once more, by its definition: the field is followed to the middle surface.
//!
//! This is the test oracle for [`Projection::project`]. It uses planes, intersections and areas in
//! space, no barycentric sums and no reference prism; it is as exact, and several times slower. Use it to
//! check, not to compute.

use super::exact::{along, cross, dot, rational_point, sub, triangle_weights};
use super::{Projection, Rat, ShellPoint};
use crate::shell::{Layer, Slab, Tet};

impl Projection<'_> {
    /// Where the field `V` through the point meets the middle surface, in canonical form (height 0),
    /// when it starts in the closed tet `tet` (an index into [`tets`](Self::tets)).
    ///
    /// `V` is constant in a tet, from the lower to the upper end of its pillar half. From the top
    /// slab it is followed against its direction, from the bottom slab along it, tet by tet. All
    /// walls of a prism are parallel to the field, so the tets passed are the next ones of the
    /// prism's decomposition. `None` where the point is not in the tet, or there is no such tet.
    #[must_use]
    pub fn trace(&self, p: &[Rat; 3], tet: u32) -> Option<ShellPoint> {
        let start = *self.tets().get(tet as usize)?;
        if !self.in_tet(&start, p) {
            return None;
        }
        let slab: Vec<Tet> =
            self.tets_of(start.prism).iter().copied().filter(|t| t.slab == start.slab).collect();
        let at = slab.iter().position(|t| t.local == start.local)?;
        let passed: Vec<Tet> = match start.slab {
            Slab::Top => slab[..=at].iter().rev().copied().collect(),
            Slab::Bottom => slab[at..].to_vec(),
        };
        let mut position = p.clone();
        for tet in &passed {
            if !self.in_tet(tet, &position) {
                return None;
            }
            position = self.exit(tet, &position)?;
        }
        self.on_middle(start.prism, &position)
    }

    /// The middle points of all fields through the point, one for each way to start, without
    /// repetition, in ascending order of prisms.
    #[must_use]
    pub fn trace_all(&self, p: &[Rat; 3]) -> Vec<ShellPoint> {
        let mut ends: Vec<ShellPoint> = Vec::new();
        for end in self.locate(p).into_iter().filter_map(|l| self.trace(p, l.tet)) {
            if !ends.contains(&end) {
                ends.push(end);
            }
        }
        ends.sort_by_key(|end| end.prism);
        ends
    }

    fn corners(&self, tet: &Tet) -> [[Rat; 3]; 4] {
        self.points(tet).map(rational_point)
    }

    /// On the inner side of all four planes?
    fn in_tet(&self, tet: &Tet, p: &[Rat; 3]) -> bool {
        let x = self.corners(tet);
        (0..4).all(|k| {
            let [a, b, c] = [1, 2, 3].map(|i| &x[(k + i) % 4]);
            let normal = cross(&sub(b, a), &sub(c, a));
            let (inner, side) = (dot(&normal, &sub(&x[k], a)), dot(&normal, &sub(p, a)));
            inner * side >= Rat::ZERO
        })
    }

    /// Where the field leaves the tet towards the middle surface: through the face opposite the
    /// pillar's outer end.
    fn exit(&self, tet: &Tet, p: &[Rat; 3]) -> Option<[Rat; 3]> {
        let [lo, hi] = tet.field();
        let outer = match tet.slab {
            Slab::Bottom => lo,
            Slab::Top => hi,
        };
        let face: Vec<[Rat; 3]> = tet
            .names
            .iter()
            .filter(|&&n| n != outer)
            .map(|&n| rational_point(self.shell.position(n)))
            .collect();
        let [a, b, c] = face.as_slice() else { return None };
        let field = sub(&rational_point(self.shell.position(hi)), &rational_point(self.shell.position(lo)));
        let normal = cross(&sub(b, a), &sub(c, a));
        let speed = dot(&normal, &field);
        if speed == Rat::ZERO {
            return None;
        }
        let time = dot(&normal, &sub(a, p)) / speed;
        Some(along(p, &time, &field))
    }

    fn on_middle(&self, prism: u32, p: &[Rat; 3]) -> Option<ShellPoint> {
        let corners = *self.shell.faces.get(prism as usize)?;
        let x = corners.map(|v| rational_point(self.shell.position(self.shell.name(v, Layer::Middle))));
        let weights = triangle_weights(p, &x)?;
        Some(self.canonical_of(&ShellPoint { prism, weights, height: Rat::ZERO }))
    }
}
