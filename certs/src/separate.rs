//! Planes that separate, and the claims `disjoint-*` and `i2` (FORMAT sections 3.5 and 3.6, rule R3 of THEORY).

use crate::boxes::{Aabb, Tree};
use crate::line::Plane;
use crate::number::{Num, Vec3, cross, dot};
use crate::parse::{Crossing, Separation};
use crate::tets::{self, Tet};
use crate::world::World;
use crate::{Res, ensure, invalid, show};
use num_bigint::BigInt;
use num_traits::Zero;
use std::iter::Peekable;
use std::slice::Iter;

/// Points `x` with `normal . (x - base) = 0`.
struct Level<N> {
    normal: Vec3<N>,
    base: usize,
}

/// The planes as functions; `i` is the mesh triangle of `l:`.
fn levels<N: Num>(world: &World<N>, i: usize, planes: &[Plane]) -> Vec<Level<N>> {
    let level = |plane: &Plane| {
        let (a, b, third) = match *plane {
            Plane::Through(a, b, c) => (a, b, Some(c)),
            Plane::Line(a, b) | Plane::Normal(a, b) => (a, b, None),
        };
        let (a, b) = (world.point(a), world.point(b));
        let along = world.offset(a, b);
        let normal = match (plane, third) {
            (_, Some(c)) => world.normal_of([a, b, world.point(c)]),
            (Plane::Line(..), None) => cross(&along, world.normal(i)),
            _ => along,
        };
        Level { normal, base: a }
    };
    planes.iter().map(level).collect()
}

/// The plane of three points.
fn through<N: Num>(world: &World<N>, points: [usize; 3]) -> [Level<N>; 1] {
    [Level { normal: world.normal_of(points), base: points[0] }]
}

/// Whether each plane has what remains of `a` on one closed side and of `b` on the other, and the remainder is harmless.
fn separate<N: Num>(
    world: &World<N>,
    planes: &[Level<N>],
    a: &[usize],
    b: &[usize],
    harmless: impl Fn(&[usize]) -> bool,
) -> bool {
    let (mut a, mut b) = (a.to_vec(), b.to_vec());
    for plane in planes {
        let side = |x: &usize| dot(&plane.normal, &world.offset(plane.base, *x)).sgn();
        let (of_a, of_b): (Vec<i32>, Vec<i32>) = (a.iter().map(side).collect(), b.iter().map(side).collect());
        let apart = |s: i32| of_a.iter().all(|x| x * s >= 0) && of_b.iter().all(|x| x * s <= 0);
        if !apart(1) && !apart(-1) {
            return false;
        }
        let mut keep = of_a.iter();
        a.retain(|_| keep.next() == Some(&0));
        let mut keep = of_b.iter();
        b.retain(|_| keep.next() == Some(&0));
    }
    harmless(&a) || harmless(&b)
}

/// Whether a remainder is empty or one point with the coordinates of a pinched one of the vertices.
fn at_pinch<N>(world: &World<N>, vertices: &[usize], rest: &[usize]) -> bool {
    let same =
        |x: usize| vertices.iter().any(|&v| world.pinched[v] && world.keys[x] == world.keys[3 * v + 1]);
    rest.is_empty() || (rest.len() == 1 && same(rest[0]))
}

/// What the mesh is compared with: itself, or a layer of the shell.
fn others<N: Num>(world: &World<N>, layer: Option<usize>, j: usize) -> [usize; 3] {
    match layer {
        None => world.corners(j),
        Some(layer) => world.shell.triangles[j].map(|v| 3 * v + layer),
    }
}

/// `disjoint-mesh` (no layer), `disjoint-bottom` (layer 0), `disjoint-top` (layer 2) certified.
pub(crate) fn disjoint<N: Num>(world: &World<N>, layer: Option<usize>, seps: &[Separation]) -> Res {
    let many = if layer.is_none() { world.mesh.triangles.len() } else { world.shell.triangles.len() };
    let boxes = (0..many).map(|j| Aabb::of(&world.keys, &others(world, layer, j))).collect();
    let tree = Tree::new(boxes);
    let mut seps = seps.iter().peekable();
    for i in 0..world.mesh.triangles.len() {
        let a = world.corners(i);
        let bounds = Aabb::of(&world.keys, &a);
        let mut pairs = tree.meeting(&bounds);
        pairs.retain(|&j| layer.is_some() || i < j);
        for j in merge(pairs, i, seps.clone()) {
            let sep = seps.next_if(|s| s.pair == (i, j));
            let at = || {
                format!("triangle {i} and {j}{}", sep.map_or(String::new(), |s| format!(", line {}", s.line)))
            };
            ensure(bounds.meets(tree.get(j)), "superfluous", at)?;
            let b = others(world, layer, j);
            let common: Vec<usize> = a.iter().copied().filter(|x| b.contains(x)).collect();
            let harmless = |rest: &[usize]| match layer {
                None => rest.len() == common.len() && rest.iter().all(|x| common.contains(x)),
                Some(_) => at_pinch(world, &world.shell.triangles[j], rest),
            };
            let alone = [a, b].into_iter().any(|t| separate(world, &through(world, t), &a, &b, harmless));
            judge(world, alone, sep, (i, &a, &b), harmless, at)?;
        }
    }
    Ok(())
}

/// The found partners of `i` and those of the next separations, ascending, each once.
fn merge(mut found: Vec<usize>, i: usize, seps: Peekable<Iter<'_, Separation>>) -> Vec<usize> {
    found.extend(seps.take_while(|s| s.pair.0 == i).map(|s| s.pair.1));
    crate::complex::distinct(&found)
}

/// A pair that needs no planes must have none; any other must have planes that separate it.
fn judge<N: Num>(
    world: &World<N>,
    alone: bool,
    sep: Option<&Separation>,
    (i, a, b): (usize, &[usize], &[usize]),
    harmless: impl Fn(&[usize]) -> bool,
    at: impl Fn() -> String,
) -> Res {
    match sep {
        None => ensure(alone, "missing-separation", at),
        Some(_) if alone => invalid("superfluous", at()),
        Some(sep) => {
            ensure(separate(world, &levels(world, i, &sep.planes), a, b, harmless), "not-separated", at)
        }
    }
}

/// `i2` certified.
pub(crate) fn no_contact<N: Num>(world: &World<N>, seps: &[Separation]) -> Res {
    let nine = |prism: &[usize; 3]| prism.map(|v| [3 * v, 3 * v + 1, 3 * v + 2]).concat();
    let boxes = world.shell.triangles.iter().map(|prism| Aabb::of(&world.keys, &nine(prism))).collect();
    let tree = Tree::new(boxes);
    let mut seps = seps.iter().peekable();
    for f in 0..world.mesh.triangles.len() {
        let corners = world.corners(f);
        let bounds = Aabb::of(&world.keys, &corners);
        let found = tree.meeting(&bounds);
        for p in merge(found, f, seps.clone()) {
            let mut open = Vec::new();
            if !world.rises(f, p) {
                open = tets::all(&world.pinched, world.shell.triangles[p]);
                open.retain(|tet| is_open(world, f, &corners, &bounds, tet));
            }
            let mut open = open.iter().map(|t| t.names).peekable();
            loop {
                let listed = seps.peek().copied().filter(|s| s.pair == (f, p));
                let at = || {
                    format!(
                        "triangle {f}, prism {p}{}",
                        listed.map_or(String::new(), |s| format!(", line {}", s.line))
                    )
                };
                match (listed.and_then(|s| s.tet), open.peek()) {
                    (None, None) => break,
                    (Some(tet), Some(name)) if tet == *name => {
                        let vertices = tet.map(|n| n / 3);
                        judge(
                            world,
                            false,
                            listed,
                            (f, &corners, &tet),
                            |r| at_pinch(world, &vertices, r),
                            at,
                        )?;
                        seps.next();
                        open.next();
                    }
                    (Some(tet), name) if name.is_none_or(|n| tet < *n) => {
                        return invalid("superfluous", at());
                    }
                    (_, name) => {
                        return invalid(
                            "missing-separation",
                            format!("{}: tet {}", at(), show(name.unwrap_or(&[0; 4]))),
                        );
                    }
                }
            }
        }
    }
    Ok(())
}

/// Whether the dot of `f` with the tet is not positive, their boxes meet, and the plane of neither `f` nor a face separates.
fn is_open<N: Num>(world: &World<N>, f: usize, corners: &[usize; 3], bounds: &Aabb, tet: &Tet) -> bool {
    let [a, b, c, d] = tet.names;
    let vertices = tet.names.map(|n| n / 3);
    let apart = |plane: [usize; 3]| {
        separate(world, &through(world, plane), corners, &tet.names, |r| at_pinch(world, &vertices, r))
    };
    world.dot(f, tet).sgn() <= 0
        && Aabb::of(&world.keys, &tet.names).meets(bounds)
        && ![*corners, [b, c, d], [a, c, d], [a, b, d], [a, b, c]].into_iter().any(apart)
}

/// `disjoint-*` refuted.
pub(crate) fn crossing<N: Num>(world: &World<N>, layer: Option<usize>, crossings: &[Crossing]) -> Res {
    for fact in crossings {
        let at = || format!("line {}", fact.line);
        let (a, b) = (world.corners(fact.pair.0), others(world, layer, fact.pair.1));
        ensure(meet(world, fact, &a, &b), "wrong-point", at)?;
        let (left, right) = (carrier(&a, &fact.first), carrier(&b, &fact.second));
        let forced = match layer {
            None => left == right,
            Some(_) => right.len() == 1 && world.pinched[right[0] / 3],
        };
        ensure(!forced, "not-refuted", at)?;
    }
    Ok(())
}

/// `i2` refuted.
pub(crate) fn contact<N: Num>(world: &World<N>, contacts: &[Crossing]) -> Res {
    for fact in contacts {
        let at = || format!("line {}", fact.line);
        let Some((names, value)) = &fact.contact else { continue };
        let tets = tets::all(&world.pinched, world.shell.triangles[fact.pair.1]);
        let Some(tet) = tets.iter().find(|t| t.names == *names) else { return invalid("unknown-tet", at()) };
        ensure(meet(world, fact, &world.corners(fact.pair.0), names), "wrong-point", at)?;
        let dot = world.dot(fact.pair.0, tet);
        ensure(world.value(&dot) == *value, "wrong-value", at)?;
        let carrier = carrier(names, &fact.second);
        let pinch = carrier.len() == 1 && world.pinched[carrier[0] / 3];
        ensure(dot.sgn() <= 0 && !pinch, "not-refuted", at)?;
    }
    Ok(())
}

/// Whether the two weighted points are equal.
fn meet<N: Num>(world: &World<N>, fact: &Crossing, a: &[usize], b: &[usize]) -> bool {
    let ((x, xw), (y, yw)) = (world.mean(a, &fact.first), world.mean(b, &fact.second));
    x.iter().zip(&y).all(|(x, y)| x * &yw == y * &xw)
}

/// The ids with a weight, ascending.
pub(crate) fn carrier(ids: &[usize], weights: &[BigInt]) -> Vec<usize> {
    let some: Vec<usize> = ids.iter().zip(weights).filter(|(_, w)| !w.is_zero()).map(|(&id, _)| id).collect();
    crate::complex::distinct(&some)
}
