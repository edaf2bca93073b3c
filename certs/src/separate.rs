//! Planes that separate, and the claims `disjoint-*` and `i2` (FORMAT sections 3.5 and 3.6, rule R3 of THEORY).

use crate::boxes::{Aabb, Tree};
use crate::complex::distinct;
use crate::line::Plane;
use crate::number::{cross, dot, sgn};
use crate::parse::{Crossing, Separation};
use crate::world::World;
use crate::{Res, each, show};
use num_bigint::BigInt;

/// What the triangles of the mesh are compared with: each other, a layer of the shell, the tets of the prisms.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Other {
    Mesh,
    Layer(usize),
    Tets,
}

impl Other {
    /// The triangle `j` (none for `Tets`).
    fn triangle(self, world: &World, j: usize) -> Option<[usize; 3]> {
        match self {
            Self::Mesh => Some(world.corners(j)),
            Self::Layer(layer) => Some(world.shell.triangles[j].map(|v| 3 * v + layer)),
            Self::Tets => None,
        }
    }
}

/// Mesh triangle `i` with corners `a`, and a triangle or a tet `b`.
struct Pair<'a> {
    world: &'a World,
    a: [usize; 3],
    b: &'a [usize],
    other: Other,
}

impl Pair<'_> {
    /// The side of a plane on which a point lies.
    fn side(&self, plane: &Plane, x: usize) -> i32 {
        let (world, [p, q, r]) = (self.world, self.a);
        let normal = || cross(&world.offset([p, q]), &world.offset([p, r]));
        match *plane {
            Plane::Through(points) => world.side(points, x),
            Plane::Line(ends) if ends.contains(&x) => 0,
            Plane::Line(ends @ [a, _]) => {
                sgn(&dot(&cross(&world.offset(ends), &normal()), &world.offset([a, x])))
            }
            Plane::Normal(ends @ [a, _]) => sgn(&dot(&world.offset(ends), &world.offset([a, x]))),
        }
    }

    /// Whether what remains of one side after the last plane may be there.
    fn harmless(&self, rest: &[usize]) -> bool {
        let common = |x: &usize| self.a.contains(x) && self.b.contains(x);
        let World { keys, pinched, .. } = self.world;
        let at_pinch = |v: usize| pinched[v] && keys[rest[0]] == keys[3 * v + 1];
        if self.other == Other::Mesh {
            return rest.iter().all(common) && rest.len() == self.a.iter().filter(|x| common(x)).count();
        }
        rest.is_empty() || rest.len() == 1 && self.b.iter().any(|n| at_pinch(n / 3))
    }

    /// Whether each plane has what remains of `a` on one closed side and of `b` on the other, and the remainder is harmless.
    fn separate(&self, planes: &[Plane], a: &[usize], b: &[usize]) -> bool {
        // A loop, since a line may have any number of planes.
        let (mut a, mut b) = (a.to_vec(), b.to_vec());
        for plane in planes {
            // A triangle and a tet have at most four points; a missing one counts as one on the plane.
            let sides =
                |points: &[usize]| [0, 1, 2, 3].map(|i| points.get(i).map_or(0, |&x| self.side(plane, x)));
            let (of_a, of_b) = (sides(&a), sides(&b));
            let apart = |s: i32| !of_a.contains(&-s) && !of_b.contains(&s);
            if !apart(1) && !apart(-1) {
                return false;
            }
            for (points, sides) in [(&mut a, of_a), (&mut b, of_b)] {
                let mut sides = sides.into_iter();
                points.retain(|_| sides.next() == Some(0));
            }
        }
        self.harmless(&a) || self.harmless(&b)
    }

    /// Whether the plane of `i` or that of a face of `b` separates on its own.
    fn separate_alone(&self) -> bool {
        // Three points are left of a triangle when the missing fourth one is skipped.
        let face = |skip: usize| {
            let mut rest = self.b.iter().enumerate().filter(|x| x.0 != skip).map(|x| *x.1);
            Some([rest.next()?, rest.next()?, rest.next()?])
        };
        let mut planes = std::iter::once(self.a).chain((0..4).filter_map(face));
        planes.any(|points| self.separate(&[Plane::Through(points)], &self.a, self.b))
    }
}

/// `disjoint-*` or `i2` certified: the lines are about just the pairs that need planes, and their planes separate.
pub(crate) fn disjoint(world: &World, other: Other, lines: &[Separation]) -> Res {
    let many = if other == Other::Mesh { world.mesh.triangles.len() } else { world.shell.triangles.len() };
    let triangles: Vec<[usize; 3]> = (0..many).filter_map(|j| other.triangle(world, j)).collect();
    let nine = |j: usize| world.shell.triangles[j].map(|v| [3 * v, 3 * v + 1, 3 * v + 2]).concat();
    let points = |j: usize| triangles.get(j).map_or_else(|| nine(j), Vec::from);
    let tree = Tree::new((0..many).map(|j| Aabb::of(&world.keys, &points(j))));
    each(world.mesh.triangles.len(), |i| {
        let a = world.corners(i);
        let bounds = Aabb::of(&world.keys, &a);
        let [from, to] = [i, i + 1].map(|i| lines.partition_point(|line| line.pair.0 < i));
        let mut partners = tree.meeting(&bounds);
        partners.retain(|&j| other != Other::Mesh || i < j);
        for j in distinct(partners.into_iter().chain(lines[from..to].iter().map(|line| line.pair.1))) {
            let listed = lines[from..to].iter().filter(|line| line.pair.1 == j);
            let about = |line: &Separation| line.tet.map_or_else(|| Vec::from(triangles[j]), Vec::from);
            let listed: Vec<_> = listed.map(|line| (line, about(line))).collect();
            let mut open: Vec<&[usize]> = triangles.get(j).into_iter().map(|t| &t[..]).collect();
            if other == Other::Tets && !world.rises(i, j) {
                let steep = world.tets[j].iter().filter(|t| world.sign(world.dot(i, t.pillar)) <= 0);
                open = steep.map(|tet| &tet.names[..]).collect();
            }
            let pair = |b| Pair { world, a, b, other };
            open.retain(|b| Aabb::of(&world.keys, b).meets(&bounds) && !pair(b).separate_alone());
            // In the order of names; a pair of triangles has at most one line.
            for (line, names) in &listed {
                let at = || format!("line {}: triangle {i} and {j}", line.line);
                let missed = open.first().is_some_and(|b| **b < names[..]);
                ensure!(!missed, "missing-separation", "before {}: {}", at(), show(open[0]));
                ensure!(open.first() == Some(&&names[..]), "superfluous", "{}", at());
                let exist = line.planes.iter().all(|plane| plane.points().iter().all(|&x| world.exists(x)));
                ensure!(exist && pair(names).separate(&line.planes, &a, names), "not-separated", "{}", at());
                open.remove(0);
            }
            ensure!(open.is_empty(), "missing-separation", "triangle {i} and {j}: {}", show(open[0]));
        }
        Ok(())
    })
}

/// `disjoint-*` or `i2` refuted: a point that both have.
pub(crate) fn crossing(world: &World, other: Other, facts: &[Crossing]) -> Res {
    for Crossing { line, pair: (i, j), first, second, contact } in facts {
        let a = world.corners(*i);
        let b =
            other.triangle(world, *j).map_or_else(|| contact.iter().flat_map(|c| c.0).collect(), Vec::from);
        let tet = world.tets.get(*j).and_then(|tets| tets.iter().find(|t| t.names == *b));
        ensure!(other != Other::Tets || tet.is_some(), "unknown-tet", "line {line}");
        let ((x, xw), (y, yw)) = (world.mean(&a, first), world.mean(&b, second));
        ensure!(x.iter().zip(&y).all(|(x, y)| x * &yw == y * &xw), "wrong-point", "line {line}");
        if let (Some(tet), Some((_, value))) = (tet, contact) {
            let dot = world.det(world.dot(*i, tet.pillar));
            ensure!(world.value(&dot) == *value, "wrong-value", "line {line}");
            ensure!(sgn(&dot) <= 0, "not-refuted", "line {line}");
        }
        let (left, right) = (carrier(&a, first), carrier(&b, second));
        let pinch = || right.len() == 1 && world.pinched[right[0] / 3];
        let forced = if other == Other::Mesh { left == right } else { pinch() };
        ensure!(!forced, "not-refuted", "line {line}");
    }
    Ok(())
}

/// The ids with a weight, ascending.
pub(crate) fn carrier(ids: &[usize], weights: &[BigInt]) -> Vec<usize> {
    distinct(ids.iter().zip(weights).filter(|(_, w)| sgn(w) != 0).map(|(&id, _)| id))
}
