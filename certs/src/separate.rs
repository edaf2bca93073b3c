//! Planes that separate, and the claims `disjoint-*` and `i2` (FORMAT sections 3.5 and 3.6, rule R3 of THEORY).

use crate::boxes::{Aabb, Tree};
use crate::complex::{classes, distinct};
use crate::lift::Lift;
use crate::line::Plane;
use crate::number::{cross, dot, sgn};
use crate::pages::Separations;
use crate::parse::{Crossing, Overlap, Separation};
use crate::tets::{self, Selected};
use crate::world::World;
use crate::{Res, each, part, show};
use num_bigint::BigInt;

/// What is compared: the triangles of the mesh with themselves, with those of a layer, or with prisms, all nine points
/// of which stand for their tets; the skin with itself.
pub(crate) enum Sets<'a> {
    Mesh,
    Layer(usize),
    Prisms,
    Skin(&'a [[usize; 3]]),
}

impl Sets<'_> {
    /// Whether both lists are one: each two of its triangles are a pair.
    fn itself(&self) -> bool {
        matches!(self, Self::Mesh | Self::Skin(_))
    }

    /// How many are compared with how many.
    fn len(&self, world: &World) -> [usize; 2] {
        match self {
            Self::Mesh => [world.mesh.len(); 2],
            Self::Skin(skin) => [skin.len(); 2],
            _ => [world.mesh.len(), world.shell.len()],
        }
    }

    fn first(&self, world: &World, i: usize) -> [usize; 3] {
        if let Self::Skin(skin) = self { skin[i] } else { world.corners(i) }
    }

    fn bounds(&self, world: &World, j: usize) -> Aabb {
        match self {
            Self::Layer(layer) => Aabb::of(&world.keys, &world.shell.of(j).map(|v| world.name(v, *layer))),
            Self::Prisms => Aabb::of(&world.keys, world.pillars(j).as_flattened()),
            _ => Aabb::of(&world.keys, &self.first(world, j)),
        }
    }

    fn second(&self, world: &World, j: usize) -> Points {
        let three = |[a, b, c]: [usize; 3]| ([a, b, c, 0, 0, 0, 0, 0, 0], 3);
        match self {
            Self::Layer(layer) => three(world.shell.of(j).map(|v| world.name(v, *layer))),
            Self::Prisms => (std::array::from_fn(|i| world.pillars(j)[i / 3][i % 3]), 9),
            _ => three(self.first(world, j)),
        }
    }
}

/// Points, as many as the number says.
type Points = ([usize; 9], usize);

/// A triangle `a`, and a triangle or a tet `b`.
struct Pair<'a> {
    world: &'a World,
    a: [usize; 3],
    b: &'a [usize],
    itself: bool,
}

impl Pair<'_> {
    /// The side of a plane on which a point lies.
    fn side(&self, plane: &Plane, x: usize) -> i32 {
        let (world, [p, q, r]) = (self.world, self.a);
        let normal = || cross(&world.offset([p, q]), &world.offset([p, r]));
        let from = |a: usize| world.offset([a, x]);
        match *plane {
            Plane::Through(points) => world.side(points, x),
            Plane::Line(ends @ [a, _]) => sgn(&dot(&cross(&world.offset(ends), &normal()), &from(a))),
            Plane::Normal(ends @ [a, _]) => sgn(&dot(&world.offset(ends), &from(a))),
        }
    }

    /// Whether what remains of one side after the last plane may be there.
    fn harmless(&self, rest: &[usize]) -> bool {
        let common = |x: &usize| self.a.contains(x) && self.b.contains(x);
        let World { keys, pinched, .. } = self.world;
        let at_pinch = |v: usize| pinched[v] && rest.iter().all(|&x| keys[x] == keys[3 * v + 1]);
        if self.itself {
            return rest.iter().all(common) && rest.len() == self.a.iter().filter(|x| common(x)).count();
        }
        rest.is_empty() || self.b.iter().any(|n| at_pinch(n / 3))
    }

    /// Whether each plane has what remains of `a` on one closed side and of `b` on the other, and the remainder is harmless.
    fn separate(&self, planes: &[Plane], a: &[usize], b: &[usize]) -> bool {
        // A loop, since a line may have any number of planes.
        let (mut a, mut b) = (a.to_vec(), b.to_vec());
        for plane in planes {
            // A triangle and a tet have at most four points; a missing one counts as one on the plane.
            let sides = |p: &[usize]| [0, 1, 2, 3].map(|i| p.get(i).map_or(0, |&x| self.side(plane, x)));
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
pub(crate) fn disjoint(world: &World, sets: &Sets<'_>, lines: &Separations<'_>) -> Res {
    let [many, others] = sets.len(world);
    let tree = Tree::new(others, |j| sets.bounds(world, j));
    each(many.div_ceil(SHARD), |shard| {
        let mut at = part(many, SHARD, shard);
        let lines = lines.of(at.clone())?;
        at.try_for_each(|i| {
            let mut partners = tree.meeting(&Aabb::of(&world.keys, &sets.first(world, i)));
            partners.retain(|&j| !sets.itself() || i < j);
            let [from, to] = [i, i + 1].map(|i| lines.partition_point(|line| line.pair.0 < i));
            one(world, sets, i, partners, &lines[from..to])
        })
    })
}

/// First triangles whose lines are read together.
const SHARD: usize = if cfg!(test) { 2 } else { 64 };

/// The pairs of one first triangle: those whose boxes meet, and those that have lines.
fn one(world: &World, sets: &Sets<'_>, i: usize, partners: Vec<usize>, lines: &[Separation]) -> Res {
    let (a, itself) = (sets.first(world, i), sets.itself());
    let bounds = Aabb::of(&world.keys, &a);
    for j in distinct(partners.into_iter().chain(lines.iter().map(|line| line.pair.1))) {
        let (second, n) = sets.second(world, j);
        let second = &second[..n];
        let tets = if n > 3 { tets::steep(world, i, j) } else { Vec::new() };
        let mut open: Vec<&[usize]> = tets.iter().map(|tet| &tet.names[..]).collect();
        if n == 3 {
            open.push(second);
        }
        let pair = |b| Pair { world, a, b, itself };
        open.retain(|b| Aabb::of(&world.keys, b).meets(&bounds) && !pair(b).separate_alone());
        // In the order of names; a pair of triangles has at most one line.
        let start = lines.partition_point(|line| line.pair.1 < j);
        for line in lines[start..].iter().take_while(|line| line.pair.1 == j) {
            let names = line.tet.as_ref().map_or(second, |tet| tet);
            let at = || format!("line {}: triangle {i} and {j}", line.line);
            let missed = open.first().is_some_and(|b| *b < names);
            ensure!(!missed, "missing-separation", "before {}: {}", at(), show(open[0]));
            ensure!(open.first() == Some(&names), "superfluous", "{}", at());
            let exist = line.planes.iter().all(|plane| plane.points().iter().all(|&x| world.exists(x)));
            ensure!(exist && pair(names).separate(&line.planes, &a, names), "not-separated", "{}", at());
            open.remove(0);
        }
        ensure!(open.is_empty(), "missing-separation", "triangle {i} and {j}: {}", show(open[0]));
    }
    Ok(())
}

/// `disjoint-mesh`, `-bottom`, `-top` or `i2` refuted: a point that both have.
pub(crate) fn crossing(world: &World, sets: &Sets<'_>, facts: &[Crossing]) -> Res {
    for Crossing { line, pair: (i, j), first, second, contact } in facts {
        let (a, (points, n)) = (sets.first(world, *i), sets.second(world, *j));
        let b = contact.as_ref().map_or(&points[..n], |(tet, _)| tet);
        let tet = contact.as_ref().and_then(|_| tets::all(world, *j).into_iter().find(|t| t.names == b));
        ensure!(contact.is_none() || tet.is_some(), "unknown-tet", "line {line}");
        let ((x, xw), (y, yw)) = (world.mean(&a, first), world.mean(b, second));
        ensure!(x.iter().zip(&y).all(|(x, y)| x * &yw == y * &xw), "wrong-point", "line {line}");
        if let (Some(tet), Some((_, value))) = (tet, contact) {
            let dot = world.det(world.dot(*i, tet.pillar));
            ensure!(world.value(&dot) == *value, "wrong-value", "line {line}");
            ensure!(sgn(&dot) <= 0, "not-refuted", "line {line}");
        }
        let (left, right) = (carrier(&a, first), carrier(b, second));
        let is_pinch = |&&p: &&usize| world.pinched.get(p / 3) == Some(&true);
        let pinch = b.iter().filter(is_pinch).any(|&p| (0..3).all(|i| world.integer(p, i) * &xw == x[i]));
        // Equal only for triangles of the mesh, whose points have other numbers than the shell's.
        ensure!(left != right && !pinch, "not-refuted", "line {line}");
    }
    Ok(())
}

/// The ids with a weight, ascending.
pub(crate) fn carrier(ids: &[usize], weights: &[BigInt]) -> Vec<usize> {
    distinct(ids.iter().zip(weights).filter(|(_, w)| sgn(w) != 0).map(|(&id, _)| id))
}

/// `disjoint-prisms` certified (rule R4): the skin does not meet itself, and a triangle of each connected part of it has
/// its middle in no other tet.
pub(crate) fn injective(world: &World, selected: &Selected<'_>, lines: &Separations<'_>) -> Res {
    ensure!(selected.positive(), "not-positive", "a tet of the order");
    let skin = selected.skin();
    ensure!(lines.greatest.is_none_or(|j| j < skin.len()), "superfluous", "the skin has {}", skin.len());
    disjoint(world, &Sets::Skin(&skin), lines)?;
    // Connected across the sides that just two triangles have.
    let sides = |(i, &[a, b, c]): (usize, &[usize; 3])| [([a, b], i), ([a, c], i), ([b, c], i)];
    let mut sides: Vec<_> = skin.iter().enumerate().flat_map(sides).collect();
    sides.sort_unstable();
    let shared = sides.chunk_by(|x, y| x.0 == y.0).filter(|chunk| chunk.len() == 2);
    let lift = Lift::new(world, selected);
    let parts = classes(skin.len(), shared.map(|chunk| (chunk[0].1, chunk[1].1)));
    for i in distinct(parts.into_iter().map(|i| i as usize)) {
        let carriers = lift.carriers(&skin[i], &[1, 1, 1].map(BigInt::from));
        ensure!(carriers.len() == 1, "overlap", "the middle of {} is in another tet", show(&skin[i]));
    }
    Ok(())
}

/// `disjoint-prisms` refuted: a point of two tets with different carriers.
pub(crate) fn overlap(world: &World, selected: &Selected<'_>, facts: &[Overlap]) -> Res {
    for Overlap { line, tets: [a, b], weights: [u, v] } in facts {
        let known = |tet: &[usize]| selected.holding(tet).next().is_some();
        ensure!(known(a) && known(b), "unknown-tet", "line {line}");
        let ((x, xw), (y, yw)) = (world.mean(a, u), world.mean(b, v));
        ensure!(x.iter().zip(&y).all(|(x, y)| x * &yw == y * &xw), "wrong-point", "line {line}");
        ensure!(carrier(a, u) != carrier(b, v), "not-refuted", "line {line}");
    }
    Ok(())
}
