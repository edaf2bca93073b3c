//! `section` and `section-all-orders` refuted: the no-lift witness (FORMAT section 3.4).

use crate::boxes::Aabb;
use crate::line::Tet as Names;
use crate::number::Num;
use crate::parse::{At, Branch, Leg, Root, TetFact, Witness};
use crate::separate::carrier;
use crate::tets::Selected;
use crate::world::World;
use crate::{Res, ensure, invalid};
use num_bigint::BigInt;
use num_traits::{Signed, Zero};
use std::collections::{BTreeMap, BTreeSet, HashMap};

struct Lift<'a, N> {
    world: &'a World<N>,
    selected: &'a Selected,
    /// Whether an edge has an injective star.
    stars: HashMap<[usize; 2], bool>,
}

/// A point of `T` in a tet, with its carrier there.
struct Station<'a> {
    at: &'a At,
    tet: usize,
    carrier: Vec<usize>,
}

pub(crate) fn check<N: Num>(world: &World<N>, selected: &Selected, witness: &Witness) -> Res {
    match witness {
        Witness::Topology(line, euler, stated) => {
            let of = |c: &crate::complex::Complex, n| if *euler { c.euler(n) } else { c.parts as i128 };
            let found = [of(&world.mesh, world.points_in_mesh()), of(&world.shell, world.pinched.len())];
            ensure(found == *stated, "wrong-value", || format!("line {line}: the values are {found:?}"))?;
            ensure(found[0] != found[1], "not-refuted", || format!("line {line}: the values are equal"))
        }
        Witness::Tet(fact) => {
            let tet = selected.find(&fact.tet).filter(|&t| selected.tets[t].1 == fact.prism);
            negative(world, fact, tet.map(|t| selected.tets[t].0))
        }
        Witness::Roots(roots) => Lift { world, selected, stars: HashMap::new() }.roots(roots),
    }
}

/// A `tet` line about a tet, if it is one that the line may be about.
pub(crate) fn negative<N: Num>(world: &World<N>, fact: &TetFact, tet: Option<crate::tets::Tet>) -> Res {
    let at = || format!("line {}", fact.line);
    let Some(tet) = tet else { return invalid("unknown-tet", at()) };
    let det = tet.det(world);
    ensure(world.value(&det) == fact.value, "wrong-value", at)?;
    ensure(det.sgn() <= 0, "not-refuted", at)
}

impl<N: Num> Lift<'_, N> {
    fn roots(&mut self, roots: &[Root]) -> Res {
        let (mut from, mut landed) = (BTreeSet::new(), BTreeSet::new());
        for root in roots {
            let found = self.carriers(&root.at);
            let stated = root.branches.iter().map(|b| &b.names);
            ensure(stated.eq(&found), "wrong-branches", || {
                format!("line {}: the root lies in {} carriers, or in others", root.at.line, found.len())
            })?;
            for branch in &root.branches {
                let ends =
                    branch.legs.iter().map(|leg| self.walk(root, branch, leg)).collect::<Res<Vec<_>>>()?;
                let why = || format!("line {}: the reason `{}` does not hold", branch.line, branch.reason);
                ensure(self.refuted(branch.reason, &ends), "not-refuted", why)?;
                if branch.reason == "lands" {
                    landed.extend(ends.iter().map(|e| self.world.shell.part[self.selected.tets[e.tet].1]));
                }
            }
            from.insert(self.world.mesh.part[root.at.triangle]);
        }
        let line = roots.first().map_or(0, |r| r.at.line);
        ensure(from.len() == roots.len(), "wrong-branches", || {
            format!("line {line}: two roots in one component")
        })?;
        ensure(landed.len() < roots.len(), "not-refuted", || {
            format!("line {line}: the lifts may fill the shell")
        })
    }

    /// The carriers of a point over all tets, ascending.
    fn carriers(&self, at: &At) -> BTreeSet<Vec<usize>> {
        let keys = &self.world.keys;
        let near = Aabb::of(keys, &carrier(&self.world.corners(at.triangle), &at.weights));
        let tets = self.selected.tets.iter().enumerate();
        tets.filter(|(_, t)| Aabb::of(keys, &t.0.names).meets(&near))
            .filter_map(|(i, _)| self.carrier(at, i))
            .collect()
    }

    /// The carrier of a point in a closed tet, if it lies in it.
    fn carrier(&self, at: &At, tet: usize) -> Option<Vec<usize>> {
        let coordinates = self.coordinates(at, tet)?;
        let inside = !coordinates.iter().any(Signed::is_negative);
        inside.then(|| carrier(&self.selected.tets[tet].0.names, &coordinates))
    }

    /// The barycentric coordinates, times a positive number, in a positive tet.
    fn coordinates(&self, at: &At, tet: usize) -> Option<[BigInt; 4]> {
        let (tet, _, positive) = &self.selected.tets[tet];
        let [a, b, c, d] = tet.names;
        let sign = self.world.orient(a, b, c, d).sgn();
        let mut sum: [BigInt; 4] = std::array::from_fn(|_| BigInt::zero());
        for (x, weight) in
            self.world.corners(at.triangle).into_iter().zip(&at.weights).filter(|w| !w.1.is_zero())
        {
            for (sum, value) in sum.iter_mut().zip(self.world.coordinates(tet.names, x)) {
                *sum += value.big() * weight * sign;
            }
        }
        positive.then_some(sum)
    }

    fn tet(&self, names: &Names, line: usize) -> Res<usize> {
        self.selected.find(names).map_or_else(|| invalid("unknown-tet", format!("line {line}")), Ok)
    }

    /// Follows a leg to its last station.
    fn walk<'b>(&mut self, root: &'b Root, branch: &Branch, leg: &'b Leg) -> Res<Station<'b>> {
        let tet = self.tet(&leg.start, leg.line)?;
        let holds = branch.names.iter().all(|n| leg.start.contains(n));
        ensure(self.selected.tets[tet].2 && holds, "wrong-step", || format!("line {}", leg.line))?;
        let mut here = Station { at: &root.at, tet, carrier: branch.names.clone() };
        for (at, names) in &leg.steps {
            let tet = self.tet(names, at.line)?;
            let next = self.carrier(at, tet).filter(|c| self.carrier(at, here.tet).as_ref() == Some(c));
            let corners = self.world.corners(here.at.triangle);
            let beside = self.vertices(at).iter().all(|v| corners.contains(v));
            match next {
                Some(carrier) if beside && self.passable(&here.carrier) && self.passable(&carrier) => {
                    here = Station { at, tet, carrier };
                }
                _ => return invalid("wrong-step", format!("line {}", at.line)),
            }
        }
        Ok(here)
    }

    /// The point numbers of the mesh vertices with positive weight, ascending.
    fn vertices(&self, at: &At) -> Vec<usize> {
        carrier(&self.world.corners(at.triangle), &at.weights)
    }

    /// Whether a path through a point with this carrier continues in one way only.
    fn passable(&mut self, carrier: &[usize]) -> bool {
        match *carrier {
            [] | [_] => false,
            [a, b] => match self.stars.get(&[a, b]) {
                Some(&known) => known,
                None => {
                    let injective = self.injective(a, b);
                    self.stars.insert([a, b], injective);
                    injective
                }
            },
            _ => true,
        }
    }

    /// Whether the open wedges of the tets around an edge are disjoint.
    fn injective(&self, a: usize, b: usize) -> bool {
        let tets: Vec<_> = self.selected.holding(&[a, b]).map(|t| &self.selected.tets[t]).collect();
        let turn = |x: usize, y: usize| self.world.orient(a, b, x, y).sgn();
        let wedge = |names: &Names| -> Option<(usize, usize)> {
            let others: Vec<usize> = names.iter().copied().filter(|&n| n != a && n != b).collect();
            let &[c, d] = others.as_slice() else { return None };
            Some(if turn(c, d) > 0 { (c, d) } else { (d, c) })
        };
        let wedges: Vec<_> = tets.iter().filter_map(|t| wedge(&t.0.names)).collect();
        // Angles are below pi, so `x` is in the half-open wedge from `c` to `d` exactly when it turns so; two open wedges
        // overlap exactly when the start of one is in the other half-open one.
        let starts_in = |x: usize, (c, d): (usize, usize)| turn(c, x) >= 0 && turn(x, d) > 0;
        let overlap =
            |i: usize, j: usize| starts_in(wedges[i].0, wedges[j]) || starts_in(wedges[j].0, wedges[i]);
        tets.iter().all(|t| t.2) && !(0..wedges.len()).any(|j| (0..j).any(|i| overlap(i, j)))
    }

    fn refuted(&self, reason: &str, ends: &[Station<'_>]) -> bool {
        let Some(end) = ends.first() else { return false };
        let world = self.world;
        let on_mesh: Vec<usize> = self.vertices(end.at).iter().map(|x| x - world.base).collect();
        let pillars: Vec<usize> = end.carrier.iter().map(|n| n / 3).collect();
        let (rim, wall) = (world.mesh.on_boundary(&on_mesh), world.shell.on_boundary(&pillars));
        match (reason, ends) {
            ("cap", _) => world.in_cap(&end.carrier),
            ("wall", _) => wall && !rim,
            ("boundary", _) => rim && !wall,
            ("fold", _) => {
                let [a, b, c] = world.corners(end.at.triangle);
                let flat = || {
                    end.carrier.len() == 3 && end.carrier.iter().all(|&n| world.orient(a, b, c, n).sgn() == 0)
                };
                let dot = world.dot(end.at.triangle, &self.selected.tets[end.tet].0);
                on_mesh.len() == 3 && dot.sgn() <= 0 && (end.carrier.len() == 4 || flat())
            }
            ("lands", _) => true,
            ("twice", [one, two]) => {
                !equal(&self.on_mesh(one), &self.on_mesh(two))
                    && equal(&self.projected(one), &self.projected(two))
            }
            ("monodromy", [one, two]) => {
                equal(&self.on_mesh(one), &self.on_mesh(two)) && one.carrier != two.carrier
            }
            _ => false,
        }
    }

    fn on_mesh(&self, station: &Station<'_>) -> BTreeMap<usize, BigInt> {
        sums(self.world.mesh.triangles[station.at.triangle], station.at.weights.clone())
    }

    fn projected(&self, station: &Station<'_>) -> BTreeMap<usize, BigInt> {
        let names = self.selected.tets[station.tet].0.names;
        let coordinates = self.coordinates(station.at, station.tet);
        sums(names.map(|n| n / 3), coordinates.into_iter().flatten())
    }
}

/// Weights summed by id, without zeros.
fn sums(
    ids: impl IntoIterator<Item = usize>,
    weights: impl IntoIterator<Item = BigInt>,
) -> BTreeMap<usize, BigInt> {
    let mut map = BTreeMap::new();
    for (id, weight) in ids.into_iter().zip(weights).filter(|x| !x.1.is_zero()) {
        *map.entry(id).or_default() += weight;
    }
    map
}

/// Whether two weightings are equal after normalisation.
fn equal(a: &BTreeMap<usize, BigInt>, b: &BTreeMap<usize, BigInt>) -> bool {
    let (x, y): (BigInt, BigInt) = (a.values().sum(), b.values().sum());
    a.len() == b.len() && a.iter().zip(b).all(|((i, p), (j, q))| i == j && p * &y == q * &x)
}
