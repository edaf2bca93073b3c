//! Planes that separate triangles (MESHES section 4.4, rule R3 of THEORY), and edges in the plane.

use super::cells::{Facet, NONE};
use super::parse::Sep;
use super::points::{Points, Row};
use crate::boxes::{Aabb, Tree};
use crate::complex::distinct;
use crate::line::Plane;
use crate::number::{cross, dot, sgn};
use crate::{Res, each};

/// Triangles or edges with their numbers, ascending.
pub(super) struct Faces {
    pub(super) ids: Vec<usize>,
    pub(super) corners: Vec<Facet>,
}

impl Faces {
    fn find(&self, id: usize) -> Option<usize> {
        self.ids.binary_search(&id).ok()
    }

    pub(super) fn bounds(&self, points: &Points, at: usize) -> Aabb {
        Aabb::of(&points.keys, real(&self.corners[at]))
    }

    pub(super) fn tree<'a>(&'a self, points: &'a Points) -> Tree<'a> {
        Tree::new(self.ids.len(), move |at| self.bounds(points, at))
    }
}

/// The corners without a filling.
fn real(facet: &Facet) -> &[usize] {
    &facet[..if facet[2] == NONE { 2 } else { 3 }]
}

struct Pair<'a> {
    points: &'a Points,
    a: Facet,
    b: Facet,
}

impl Pair<'_> {
    /// The side of a plane on which a point lies.
    fn side(&self, plane: &Plane, x: usize) -> i32 {
        let offset = |from: usize, to: usize| self.points.exact(Row::Offset(from, to));
        if plane.points().contains(&x) && !matches!(plane, Plane::Normal(_)) {
            return 0;
        }
        match *plane {
            Plane::Through([a, b, c]) => self.points.orient(&[a, b, c, x]),
            Plane::Line([a, b]) => {
                sgn(&dot(&cross(&offset(a, b), &self.points.normal(self.a)), &offset(a, x)))
            }
            Plane::Normal([a, b]) => sgn(&dot(&offset(a, b), &offset(a, x))),
        }
    }

    /// Whether each plane has what remains of `a` on one closed side and of `b` on the other one, and then just the common
    /// vertices remain of one of them. (Different inputs have none in common.)
    fn separate(&self, planes: &[Plane]) -> bool {
        let (mut a, mut b) = (self.a.to_vec(), self.b.to_vec());
        for plane in planes {
            let sides = |ids: &[usize]| ids.iter().map(|&x| self.side(plane, x)).collect::<Vec<_>>();
            let (of_a, of_b) = (sides(&a), sides(&b));
            let apart = |s: i32| !of_a.contains(&-s) && !of_b.contains(&s);
            if !apart(1) && !apart(-1) {
                return false;
            }
            for (ids, sides) in [(&mut a, of_a), (&mut b, of_b)] {
                let mut sides = sides.into_iter();
                ids.retain(|_| sides.next() == Some(0));
            }
        }
        let common = |x: &usize| self.a.contains(x) && self.b.contains(x);
        let many = self.a.iter().filter(|x| common(x)).count();
        [a, b].iter().any(|rest| rest.iter().all(common) && rest.len() == many)
    }
}

/// The lines are about just the pairs of faces that need planes, and their planes separate. Without `right` the pairs
/// are those of `left`.
pub(super) fn separated(points: &Points, left: &Faces, right: Option<&Faces>, lines: &[Sep]) -> Res {
    let other = right.unwrap_or(left);
    let tree = other.tree(points);
    let first = distinct(left.ids.iter().copied().chain(lines.iter().map(|line| line.pair.0)));
    each(first.len(), |at| {
        let i = first[at];
        let [from, to] = [i, i + 1].map(|i| lines.partition_point(|line| line.pair.0 < i));
        let lines = &lines[from..to];
        let mut partners = match left.find(i) {
            Some(at) => tree.meeting(&left.bounds(points, at)),
            None => Vec::new(),
        };
        partners.iter_mut().for_each(|at| *at = other.ids[*at]);
        partners.retain(|&j| right.is_some() || i < j);
        partners.sort_unstable();
        for j in distinct(partners.iter().copied().chain(lines.iter().map(|line| line.pair.1))) {
            let line = lines.binary_search_by_key(&j, |line| line.pair.1).ok().map(|at| &lines[at]);
            let near = partners.binary_search(&j).is_ok();
            ensure!(near, "superfluous", "{i} and {j}: the boxes do not meet");
            let (Some(a), Some(b)) = (left.find(i), other.find(j)) else { continue };
            let pair = Pair { points, a: left.corners[a], b: other.corners[b] };
            if [pair.a, pair.b].iter().any(|&face| pair.separate(&[Plane::Through(face)])) {
                ensure!(line.is_none(), "superfluous", "{i} and {j}: the plane of a triangle separates");
                continue;
            }
            let Some(line) = line else { return Err(bad!("missing-separation", "{i} and {j}")) };
            ensure!(pair.separate(&line.planes), "not-separated", "line {}: {i} and {j}", line.line);
        }
        Ok(())
    })
}

/// No two edges in the plane have a point in common but a vertex.
pub(super) fn no_crossing(points: &Points, edges: &Faces) -> Res {
    let tree = edges.tree(points);
    each(edges.ids.len(), |i| {
        for j in tree.meeting(&edges.bounds(points, i)) {
            let ([a, b, _], [c, d, _]) = (edges.corners[i], edges.corners[j]);
            let meet = i < j && edges_meet(points, [a, b], [c, d]);
            ensure!(!meet, "crossing", "facets {} and {}", edges.ids[i], edges.ids[j]);
        }
        Ok(())
    })
}

/// Whether two edges whose boxes meet have a point in common besides common ends. They are no edge and its reverse.
fn edges_meet(points: &Points, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> bool {
    let turn = |p, q, r| points.orient(&[p, q, r]);
    // From a common end, they meet when they go the same way.
    for (end, p, q) in [(a == c, b, d), (a == d, b, c), (b == c, a, d), (b == d, a, c)] {
        if end {
            let from = if p == b { a } else { b };
            return turn(from, p, q) == 0 && points.along([from, p], [from, q]) > 0;
        }
    }
    // On one line they meet, as their boxes do.
    turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0
}
