//! Rule R3: planes that separate two small point sets, found and applied with exact signs.

use std::fmt;

use rustc_hash::FxHashSet;
use smallvec::SmallVec;

use super::exact::{Vec3, dot, minus, sign};
use super::write::joined;
use crate::number::dyadic::scale_points;
use crate::predicate::{self, Axis, Sign, Stage, StageCounts};
use crate::shell::Name;

/// A named input point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointName {
    /// A mesh vertex.
    Mesh(u32),
    /// A point of the shell.
    Shell(Name),
}

impl fmt::Display for PointName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mesh(v) => write!(f, "g{v}"),
            Self::Shell(name) => write!(f, "{name}"),
        }
    }
}

/// A separating plane, by the points that define it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneName {
    /// Through three points.
    Through([PointName; 3]),
    /// Through two points, parallel to the normal of the (first) mesh triangle.
    Line([PointName; 2]),
    /// Through the first point, perpendicular to the line to the second.
    Normal([PointName; 2]),
}

impl PlaneName {
    /// The text in certificates, which name points in their own ways.
    pub(crate) fn text(&self, name: impl Fn(&PointName) -> String) -> String {
        let (kind, points): (char, &[PointName]) = match self {
            Self::Through(points) => ('p', points),
            Self::Line(points) => ('l', points),
            Self::Normal(points) => ('n', points),
        };
        format!("{kind}:{}", joined(points.iter().map(name), ","))
    }
}

impl fmt::Display for PlaneName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(ToString::to_string))
    }
}

/// A point with exact coordinates, whatever they are.
pub(crate) trait ExactPoint: Sync {
    /// As [`predicate::orient3d_staged`].
    fn orient3d_staged(a: &Self, b: &Self, c: &Self, d: &Self) -> (Sign, Stage);
    /// As [`predicate::orient2d_staged`].
    fn orient2d_staged(a: &Self, b: &Self, c: &Self, drop: Axis) -> (Sign, Stage);
    /// The points times one positive number that makes all coordinates integers.
    fn integers(points: &[&Self]) -> Vec<Vec3>;
    /// Equal coordinates?
    fn is_at(&self, other: &Self) -> bool;

    /// As [`predicate::orient3d`].
    fn orient3d(a: &Self, b: &Self, c: &Self, d: &Self) -> Sign {
        Self::orient3d_staged(a, b, c, d).0
    }

    /// As [`predicate::orient2d`].
    fn orient2d(a: &Self, b: &Self, c: &Self, drop: Axis) -> Sign {
        Self::orient2d_staged(a, b, c, drop).0
    }

    /// As [`predicate::projection_axis`].
    fn projection_axis(a: &Self, b: &Self, c: &Self) -> Option<Axis> {
        Axis::ALL.into_iter().find(|&axis| !Self::orient2d(a, b, c, axis).is_zero())
    }
}

impl ExactPoint for [f64; 3] {
    fn orient3d_staged(a: &Self, b: &Self, c: &Self, d: &Self) -> (Sign, Stage) {
        predicate::orient3d_staged(a, b, c, d)
    }

    fn orient2d_staged(a: &Self, b: &Self, c: &Self, drop: Axis) -> (Sign, Stage) {
        predicate::orient2d_staged(a, b, c, drop)
    }

    fn integers(points: &[&Self]) -> Vec<Vec3> {
        let points: Vec<Self> = points.iter().map(|p| **p).collect();
        scale_points(&points).0
    }

    fn is_at(&self, other: &Self) -> bool {
        predicate::same_point(self, other)
    }
}

/// A point of one of the two sets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Named<'a, P = [f64; 3]> {
    pub(crate) name: PointName,
    pub(crate) at: &'a P,
}

/// Two point sets and what they may share.
#[derive(Debug)]
pub(crate) struct Pair<'a, P = [f64; 3]> {
    /// All points: the first `split` are `A`, the others `B`. `A`'s first three are the mesh triangle.
    pub(crate) points: Few<Named<'a, P>>,
    pub(crate) split: usize,
    /// Per point: does it count as common?
    pub(crate) common: Few<bool>,
    /// Whether a remainder must be exactly the common part (C6 of one mesh) or all at one common place at most.
    pub(crate) exact_common: bool,
}

/// As many as a triangle and a prism have, without a heap: most pairs of a large mesh need no more than a few signs.
pub(crate) type Few<T> = SmallVec<[T; 12]>;

/// Indices of points that all planes so far have gone through.
type Remainder = Few<usize>;

impl<P: ExactPoint> Pair<'_, P> {
    fn is_harmless(&self, remainder: &[usize]) -> bool {
        let harmless = |in_a: bool| {
            if self.exact_common {
                let mut all = if in_a { 0..self.split } else { self.split..self.points.len() };
                return all.all(|i| self.common[i] == remainder.contains(&i));
            }
            let mut left = remainder.iter().filter(|&&i| (i < self.split) == in_a);
            let at = |i: usize| self.points[i].at;
            left.next().is_none_or(|&i| self.common[i] && left.all(|&j| at(j).is_at(at(i))))
        };
        harmless(true) || harmless(false)
    }

    /// The points on the plane, when it separates what remains.
    fn pass(&self, remainder: &[usize], mut value: impl FnMut(usize) -> Sign) -> Option<Remainder> {
        let (mut a, mut b) = (Sign::Zero, Sign::Zero);
        let mut on = Few::new();
        for &i in remainder {
            let sign = value(i);
            let side = if i < self.split { &mut a } else { &mut b };
            match (sign, *side) {
                (Sign::Zero, _) => on.push(i),
                (s, Sign::Zero) => *side = s,
                (s, t) if s == t => {}
                _ => return None,
            }
        }
        (a == Sign::Zero || b == Sign::Zero || a != b).then_some(on)
    }

    fn through(
        &self,
        remainder: &[usize],
        [p, q, r]: [usize; 3],
        stages: &mut StageCounts,
    ) -> Option<Remainder> {
        let at = |i: usize| self.points[i].at;
        let spans = [p, q, r];
        self.pass(remainder, |i| {
            if spans.contains(&i) {
                Sign::Zero
            } else {
                stages.note(P::orient3d_staged(at(p), at(q), at(r), at(i)))
            }
        })
    }

    fn everything(&self) -> Remainder {
        (0..self.points.len()).collect()
    }

    /// Does the plane through three of the points separate alone?
    pub(crate) fn closed_by(&self, plane: [usize; 3]) -> bool {
        self.closed_by_staged(plane, &mut StageCounts::default())
    }

    /// [`closed_by`](Self::closed_by), and the signs of determinants that it took.
    pub(crate) fn closed_by_staged(&self, plane: [usize; 3], stages: &mut StageCounts) -> bool {
        self.through(&self.everything(), plane, stages).is_some_and(|left| self.is_harmless(&left))
    }

    /// Separating planes, or `None` when the convex hulls share more than they may.
    ///
    /// A plane through three of the points suffices where they span space: move any weakly separating plane until it
    /// rests on three; inside it, planes through two of its points and one off it cut the remaining sets apart. Where
    /// all points lie in the mesh triangle's plane, lines in that plane do the same one dimension down.
    pub(crate) fn separation(&self) -> Option<Vec<PlaneName>> {
        self.separation_staged(&mut StageCounts::default())
    }

    /// [`separation`](Self::separation), and the signs of determinants and dots that it took.
    pub(crate) fn separation_staged(&self, stages: &mut StageCounts) -> Option<Vec<PlaneName>> {
        self.search(&self.everything(), 3, &mut FxHashSet::default(), stages)
    }

    /// At most `depth` planes that separate the remainder. Many planes of points in degenerate position leave the same
    /// points: what has been searched in vain is not searched again.
    fn search(
        &self,
        remainder: &[usize],
        depth: usize,
        vain: &mut FxHashSet<(usize, Remainder)>,
        stages: &mut StageCounts,
    ) -> Option<Vec<PlaneName>> {
        if self.is_harmless(remainder) {
            return Some(Vec::new());
        }
        if depth == 0 {
            return None;
        }
        let mut open: Vec<(PlaneName, Remainder)> = Vec::new();
        // A plane that every remaining point lies on gains nothing; one that leaves a harmless rest ends the search.
        let mut look = |(plane, left): (PlaneName, Remainder)| {
            if self.is_harmless(&left) {
                return Some(vec![plane]);
            }
            if left.len() < remainder.len() {
                open.push((plane, left));
            }
            None
        };
        let mut found = None;
        if !self.is_flat(&self.everything(), stages) {
            found = self.planes_through(remainder, stages).find_map(&mut look);
        }
        if found.is_none() && self.is_flat(remainder, stages) {
            found = self.lines(remainder, stages).find_map(&mut look);
            if found.is_none() {
                found = self.normals(remainder, stages).find_map(&mut look);
            }
        }
        // The fewer points remain, the fewer planes must follow.
        open.sort_by_key(|(_, left)| left.len());
        found.or_else(|| {
            open.into_iter().find_map(|(plane, left)| {
                let key = (depth - 1, left);
                if vain.contains(&key) {
                    return None;
                }
                let Some(mut rest) = self.search(&key.1, depth - 1, vain, stages) else {
                    vain.insert(key);
                    return None;
                };
                rest.insert(0, plane);
                Some(rest)
            })
        })
    }

    fn planes_through<'s>(
        &'s self,
        remainder: &'s [usize],
        stages: &'s mut StageCounts,
    ) -> impl Iterator<Item = (PlaneName, Remainder)> + 's {
        let n = self.points.len();
        let triples =
            (0..n).flat_map(move |p| (p + 1..n).flat_map(move |q| (q + 1..n).map(move |r| [p, q, r])));
        triples.filter_map(move |t| {
            let left = self.through(remainder, t, stages)?;
            Some((PlaneName::Through(t.map(|i| self.points[i].name)), left))
        })
    }

    /// Do the points lie in the mesh triangle's plane?
    fn is_flat(&self, remainder: &[usize], stages: &mut StageCounts) -> bool {
        let at = |i: usize| self.points[i].at;
        remainder
            .iter()
            .all(|&i| i < 3 || stages.note(P::orient3d_staged(at(0), at(1), at(2), at(i))).is_zero())
    }

    /// Planes through two of the remaining points, all in the mesh triangle's plane, and perpendicular to it.
    fn lines<'s>(
        &'s self,
        remainder: &'s [usize],
        stages: &'s mut StageCounts,
    ) -> impl Iterator<Item = (PlaneName, Remainder)> + 's {
        let at = |i: usize| self.points[i].at;
        // Within the plane the value's sign is the orientation of the points dropped along an axis, up to one sign
        // that is the same for all of them and does not matter here.
        let proper = |axis: &Axis| !stages.note(P::orient2d_staged(at(0), at(1), at(2), *axis)).is_zero();
        let axis = Axis::ALL.into_iter().find(proper);
        let pairs = remainder
            .iter()
            .flat_map(move |&p| remainder.iter().map(move |&q| [p, q]))
            .filter(|[p, q]| p < q);
        pairs.filter_map(move |[p, q]| {
            let left = self.pass(remainder, |i| match axis {
                Some(axis) if i != p && i != q => stages.note(P::orient2d_staged(at(p), at(q), at(i), axis)),
                _ => Sign::Zero,
            })?;
            Some((PlaneName::Line([p, q].map(|i| self.points[i].name)), left))
        })
    }

    /// Planes through one of the remaining points, perpendicular to the line to another point.
    fn normals<'s>(
        &'s self,
        remainder: &'s [usize],
        stages: &'s mut StageCounts,
    ) -> impl Iterator<Item = (PlaneName, Remainder)> + 's {
        let x = P::integers(&self.points.iter().map(|p| p.at).collect::<Vec<_>>());
        let ends = remainder.iter().flat_map(move |&p| (0..self.points.len()).map(move |q| [p, q]));
        ends.filter(|[p, q]| p != q).filter_map(move |[p, q]| {
            let along = minus(&x[q], &x[p]);
            let value = |i: usize| (sign(&dot(&along, &minus(&x[i], &x[p]))), Stage::Big);
            let left = self.pass(remainder, |i| stages.note(value(i)))?;
            Some((PlaneName::Normal([p, q].map(|i| self.points[i].name)), left))
        })
    }
}
