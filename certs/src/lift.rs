//! `section` and `section-all-orders` refuted: the no-lift witness (FORMAT section 3.4).

use crate::Res;
use crate::boxes::{Aabb, Tree};
use crate::complex::Complex;
use crate::line::Names4;
use crate::number::sgn;
use crate::parse::{At, Branch, Leg, Root, TetFact, Witness};
use crate::separate::carrier;
use crate::tets::{Selected, Tet};
use crate::world::World;
use num_bigint::BigInt;
use num_integer::Integer;
use std::collections::{BTreeMap, BTreeSet};

pub(crate) struct Lift<'a> {
    world: &'a World,
    selected: &'a Selected<'a>,
    /// Of the prisms' boxes.
    tree: Tree<'a>,
}

/// A point of `T` in a tet, with its carrier there.
struct Station<'a> {
    at: &'a At,
    tet: Tet,
    carrier: Vec<usize>,
}

pub(crate) fn check(world: &World, selected: &Selected<'_>, witness: &Witness) -> Res {
    match witness {
        Witness::Topology(line, euler, stated) => {
            let value = |c: &Complex| if *euler { c.euler() } else { c.parts() as i128 };
            let found = [value(&world.mesh), value(&world.shell)];
            ensure!(found == *stated, "wrong-value", "line {line}: the values are {found:?}");
            ensure!(found[0] != found[1], "not-refuted", "line {line}: the values are equal");
            Ok(())
        }
        Witness::Tet(fact) => not_positive(world, fact, selected.of(fact.prism)),
        Witness::Roots(roots) => Lift::new(world, selected).roots(roots),
    }
}

/// A `tet` line about one of these tets of its prism.
pub(crate) fn not_positive(world: &World, fact: &TetFact, mut tets: impl Iterator<Item = Tet>) -> Res {
    let TetFact { line, tet, value, .. } = fact;
    let tet = tets.find(|t| t.names == *tet);
    let det = world.det(tet.ok_or_else(|| bad!("unknown-tet", "line {line}"))?.rows());
    ensure!(world.value(&det) == *value, "wrong-value", "line {line}");
    ensure!(sgn(&det) <= 0, "not-refuted", "line {line}");
    Ok(())
}

impl<'a> Lift<'a> {
    pub(crate) fn new(world: &'a World, selected: &'a Selected<'a>) -> Self {
        let bounds = |prism| Aabb::of(&world.keys, world.pillars(prism).as_flattened());
        Self { world, selected, tree: Tree::new(world.shell.len(), bounds) }
    }

    fn roots(&self, roots: &'a [Root]) -> Res {
        let (mut from, mut landed) = (BTreeSet::new(), BTreeSet::new());
        for root in roots {
            let found = self.carriers(&self.world.corners(root.at.triangle), &root.at.weights);
            let stated = root.branches.iter().map(|b| &b.names);
            ensure!(stated.eq(&found), "wrong-branches", "line {}: other carriers", root.at.line);
            for branch in &root.branches {
                let ends: Vec<_> =
                    branch.legs.iter().map(|l| self.walk(root, branch, l)).collect::<Res<_>>()?;
                let Branch { line, reason, .. } = branch;
                ensure!(self.refuted(reason, &ends), "not-refuted", "line {line}: no `{reason}`");
                let lands = ends.iter().filter(|_| *reason == "lands");
                landed.extend(lands.map(|end| self.world.shell.part(end.tet.prism)));
            }
            from.insert(self.world.mesh.part(root.at.triangle));
        }
        ensure!(from.len() == roots.len(), "wrong-branches", "two roots in one component");
        ensure!(landed.len() < roots.len(), "not-refuted", "the lifts may fill the shell");
        Ok(())
    }

    /// The carriers of a weighted point over all tets, ascending.
    pub(crate) fn carriers(&self, points: &[usize], weights: &[BigInt]) -> BTreeSet<Vec<usize>> {
        let near = Aabb::of(&self.world.keys, &carrier(points, weights));
        let tets = self.tree.meeting(&near).into_iter().flat_map(|prism| self.selected.of(prism));
        tets.filter_map(|tet| self.carrier(points, weights, &tet)).collect()
    }

    /// The carrier of a weighted point in a closed tet, if it lies in it.
    fn carrier(&self, points: &[usize], weights: &[BigInt], tet: &Tet) -> Option<Vec<usize>> {
        let coordinates = self.coordinates(points, weights, tet);
        let inside = tet.positive(self.world) && coordinates.iter().all(|x| sgn(x) >= 0);
        inside.then(|| carrier(&tet.names, &coordinates))
    }

    /// The barycentric coordinates of a weighted point in a tet that is not flat, times a positive number.
    fn coordinates(&self, points: &[usize], weights: &[BigInt], tet: &Tet) -> [BigInt; 4] {
        let sign = self.world.sign(self.world.replaced(tet.names, 0, tet.names[0]));
        let used = || points.iter().zip(weights).filter(|(_, w)| sgn(w) != 0);
        let part = |i: usize, (&x, w)| self.world.det(self.world.replaced(tet.names, i, x)) * w * sign;
        std::array::from_fn(|i| used().map(|point| part(i, point)).sum())
    }

    fn tet(&self, names: &Names4, line: usize) -> Res<Tet> {
        self.selected.holding(names).next().ok_or_else(|| bad!("unknown-tet", "line {line}"))
    }

    /// Follows a leg to its last station.
    fn walk(&self, root: &'a Root, branch: &Branch, leg: &'a Leg) -> Res<Station<'a>> {
        let tet = self.tet(&leg.start, leg.line)?;
        let holds = branch.names.iter().all(|n| leg.start.contains(n));
        ensure!(tet.positive(self.world) && holds, "wrong-step", "line {}", leg.line);
        let mut here = Station { at: &root.at, tet, carrier: branch.names.clone() };
        for (at, names) in &leg.steps {
            let tet = self.tet(names, at.line)?;
            let corners = self.world.corners(here.at.triangle);
            let may = self.passable(&here.carrier) && self.vertices(at).iter().all(|v| corners.contains(v));
            let within = |tet: &Tet| self.carrier(&self.world.corners(at.triangle), &at.weights, tet);
            let next = within(&tet).filter(|c| may && within(&here.tet).as_ref() == Some(c));
            here = Station { at, tet, carrier: next.ok_or_else(|| bad!("wrong-step", "line {}", at.line))? };
        }
        Ok(here)
    }

    /// The point numbers of the mesh vertices with positive weight, ascending.
    fn vertices(&self, at: &At) -> Vec<usize> {
        carrier(&self.world.corners(at.triangle), &at.weights)
    }

    /// Whether a path through a point with this carrier continues in one way only: around an edge, the open wedges of
    /// the tets must be disjoint.
    fn passable(&self, carrier: &[usize]) -> bool {
        let &[a, b] = carrier else { return carrier.len() > 2 };
        let tets: Vec<Tet> = self.selected.holding(&[a, b]).collect();
        let turn = |x: usize, y: usize| self.world.sign([[a, b], [a, x], [a, y]]);
        let wedge = |tet: &Tet| -> Option<(usize, usize)> {
            let mut others = tet.names.into_iter().filter(|&n| n != a && n != b);
            let (c, d) = (others.next()?, others.next()?);
            Some(if turn(c, d) > 0 { (c, d) } else { (d, c) })
        };
        let wedges: Vec<_> = tets.iter().filter_map(wedge).collect();
        // Angles are below pi, so `x` is in the half-open wedge from `c` to `d` exactly when it turns so; two open wedges
        // overlap exactly when the start of one is in the other half-open one.
        let starts_in = |x: usize, (c, d): (usize, usize)| turn(c, x) >= 0 && turn(x, d) > 0;
        let disjoint = |i: usize, j: usize| i == j || !starts_in(wedges[i].0, wedges[j]);
        let n = wedges.len();
        tets.iter().all(|t| t.positive(self.world)) && (0..n).all(|i| (0..n).all(|j| disjoint(i, j)))
    }

    /// Whether the reason holds at the last stations of the legs.
    fn refuted(&self, reason: &str, ends: &[Station<'_>]) -> bool {
        let (world, Some(end)) = (self.world, ends.first()) else { return false };
        let on_mesh = self.vertices(end.at);
        let rim = world.mesh.on_boundary(on_mesh.iter().map(|x| x - world.base));
        let wall = world.shell.on_boundary(end.carrier.iter().map(|n| n / 3));
        let steep = || world.sign(world.dot(end.at.triangle, end.tet.pillar)) <= 0;
        let plane = world.corners(end.at.triangle);
        let flat = || end.carrier.len() == 3 && end.carrier.iter().all(|&n| world.side(plane, n) == 0);
        let point = |at: &At| primitive(world.corners(at.triangle), &at.weights);
        let at_one_point = || ends.iter().all(|other| point(other.at) == point(end.at));
        match (reason, ends) {
            ("cap", _) => world.in_cap(&[&end.carrier]),
            ("wall", _) => wall && !rim,
            ("boundary", _) => rim && !wall,
            ("fold", _) => on_mesh.len() == 3 && steep() && (end.carrier.len() == 4 || flat()),
            ("lands", _) => true,
            ("twice", [one, two]) => !at_one_point() && self.projected(one) == self.projected(two),
            ("monodromy", [one, two]) => at_one_point() && one.carrier != two.carrier,
            _ => false,
        }
    }

    fn projected(&self, station: &Station<'_>) -> BTreeMap<usize, BigInt> {
        let Station { at, tet, .. } = station;
        let coordinates = self.coordinates(&self.world.corners(at.triangle), &at.weights, tet);
        primitive(tet.names.map(|n| n / 3), &coordinates)
    }
}

/// Weights summed by id, without zeros, divided by their greatest common divisor: equal for equal points.
fn primitive<const N: usize>(ids: [usize; N], weights: &[BigInt]) -> BTreeMap<usize, BigInt> {
    let mut map = BTreeMap::new();
    for (id, weight) in ids.into_iter().zip(weights).filter(|x| sgn(x.1) != 0) {
        *map.entry(id).or_insert(BigInt::ZERO) += weight;
    }
    let divisor = map.values().fold(BigInt::ZERO, |divisor, weight| divisor.gcd(weight));
    map.values_mut().for_each(|weight| *weight /= &divisor);
    map
}
