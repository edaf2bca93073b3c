//! Exactly degenerate cases: every coordinate is an integer of less than 53 bits, so nothing is rounded.

use super::UNIT_PRISM;
use crate::fuzz::Predicate;
use crate::fuzz::random::Random;
use crate::shell::decomposition::TETS;

type Point = [f64; 3];

/// Numerators of weights are over this.
const PARTS: i32 = 8;

/// A point with coordinates that are multiples of 8 and below `2^(bits + 3)`.
fn point(random: &mut Random, bits: u32) -> Point {
    [(); 3].map(|()| {
        let wide = random.next() & ((2 << bits) - 1);
        // Below 2^50: exact.
        (wide.cast_signed() - (1 << bits)) as f64 * f64::from(PARTS)
    })
}

/// Widths of coordinates: the more bits, the longer the expansions that an implementation needs.
fn width(random: &mut Random) -> u32 {
    [1, 3, 8, 16, 26, 36, 44, 46][random.below(8)]
}

/// An affine combination with weights that are multiples of 1/8: a convex one (perhaps of fewer points), or
/// one with weights from -1 to 2.
fn combination(points: &[Point], convex: bool, random: &mut Random) -> Point {
    let mut weights = vec![0_i32; points.len()];
    let last = weights.len().saturating_sub(1);
    let mut left = PARTS;
    for weight in weights.iter_mut().take(last) {
        *weight = if convex { random.integer(0, left) } else { random.integer(-4, 8) };
        left -= *weight;
    }
    if let Some(weight) = weights.last_mut() {
        *weight = left;
    }
    let mut out = [0.0; 3];
    for (k, out) in out.iter_mut().enumerate() {
        *out = weights.iter().zip(points).map(|(w, p)| f64::from(*w) * (p[k] / f64::from(PARTS))).sum();
    }
    out
}

fn plus(p: &Point, q: &Point, factor: f64) -> Point {
    [p[0] + factor * q[0], p[1] + factor * q[1], p[2] + factor * q[2]]
}

/// A point of the convex hull of a random non-empty subset.
fn on_hull(points: &[Point], random: &mut Random) -> Point {
    let mut chosen: Vec<Point> = points.iter().filter(|_| random.below(2) == 0).copied().collect();
    if chosen.is_empty() {
        chosen.extend(points.get(random.below(points.len())));
    }
    combination(&chosen, true, random)
}

/// A degenerate case of the predicate.
pub(super) fn degenerate(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    let bits = width(random);
    let mut p: Vec<Point> = (0..predicate.points()).map(|_| point(random, bits)).collect();
    match predicate {
        Predicate::Orient2d => p[2] = combination(&p[..2], false, random),
        Predicate::Orient3d => p[3] = combination(&p[..3], false, random),
        Predicate::Incircle => p = circle(random),
        Predicate::Insphere => p = sphere(random),
        Predicate::DotSign => p[4] = parallel(&p[3], &p[..3], random),
        Predicate::PointInTet if random.below(4) == 0 => {
            p[3] = combination(&p[..3], false, random);
            p[4] = combination(&p[..3], true, random);
        }
        Predicate::PointInTet => p[4] = on_hull(&p[..3], random),
        Predicate::TriangleTriangle => {
            let (one, two) = p.split_at_mut(3);
            touching(one, two, random);
        }
        Predicate::SegmentTriangle | Predicate::RayTriangle => {
            let (line, triangle) = p.split_at_mut(2);
            touching(triangle, line, random);
        }
        Predicate::PrismPositivity => prism(&mut p, random),
        Predicate::SectionDot => section(&mut p, random),
    }
    if matches!(predicate, Predicate::Orient2d | Predicate::Orient3d) {
        let i = random.below(p.len());
        p.rotate_left(i);
    }
    p.iter().flat_map(|q| q.iter().take(predicate.dimension()).copied()).collect()
}

/// `from` moved by a combination of two sides of a triangle.
fn parallel(from: &Point, triangle: &[Point], random: &mut Random) -> Point {
    let sides = [1, 2].map(|i| plus(&triangle[i], &triangle[0], -1.0));
    let corners = [*from, plus(from, &sides[0], 1.0), plus(from, &sides[1], 1.0)];
    combination(&corners, false, random)
}

/// Moves the points `other` so that their hull touches the triangle, in one way of several.
fn touching(triangle: &[Point], other: &mut [Point], random: &mut Random) {
    let common = on_hull(triangle, random);
    match random.below(4) {
        0 => other[0] = common,
        1 => other[1] = common,
        // The middle of an edge.
        2 => {
            let mirrored = plus(&common, &plus(&common, &other[0], -1.0), 1.0);
            other[1] = mirrored;
        }
        _ => {
            for p in other {
                *p = combination(triangle, false, random);
            }
        }
    }
}

/// Four of the lattice points of a circle.
fn circle(random: &mut Random) -> Vec<Point> {
    const OF_65: [[i16; 2]; 5] = [[16, 63], [25, 60], [33, 56], [39, 52], [65, 0]];
    const OF_5: [[i16; 2]; 2] = [[3, 4], [5, 0]];
    let all: &[[i16; 2]] = if random.below(2) == 0 { &OF_65 } else { &OF_5 };
    on_round(4, random, |random| {
        let [x, y] = all[random.below(all.len())];
        let [x, y] = if random.below(2) == 0 { [x, y] } else { [y, x] };
        [x, y, 0]
    })
}

/// Five of the lattice points of a sphere.
fn sphere(random: &mut Random) -> Vec<Point> {
    const OF_9: [[i16; 3]; 4] = [[1, 4, 8], [4, 4, 7], [3, 6, 6], [9, 0, 0]];
    on_round(5, random, |random| {
        let mut v = OF_9[random.below(4)];
        v.rotate_left(random.below(3));
        if random.below(2) == 0 {
            v.swap(0, 1);
        }
        v
    })
}

/// Lattice vectors of one length with random signs, multiplied by one number and moved.
fn on_round(
    count: usize,
    random: &mut Random,
    mut vector: impl FnMut(&mut Random) -> [i16; 3],
) -> Vec<Point> {
    let bits = width(random).min(38);
    let factor = (1 + random.below(1 << (bits.min(30) + 1))) as f64;
    let centre = point(random, bits);
    let one = |random: &mut Random| {
        let signed =
            vector(random).map(|x| f64::from(x) * if random.below(2) == 0 { factor } else { -factor });
        plus(&centre, &signed, 1.0)
    };
    std::iter::repeat_n((), count)
        .map({
            let mut one = one;
            move |()| one(random)
        })
        .collect()
}

/// A prism over a large triangle, in which one of the 12 tets is flat.
fn prism(p: &mut [Point], random: &mut Random) {
    straight(p, random);
    let tet = TETS[random.below(TETS.len())];
    let at = tet.vertices.map(|(corner, upper)| usize::from(corner) + if upper { 3 } else { 0 });
    let last = random.below(4);
    let others: Vec<Point> = (0..4).filter(|&i| i != last).map(|i| p[at[i]]).collect();
    p[at[last]] = combination(&others, true, random);
}

/// The unit prism times a large number, corners moved by less than a quarter of it.
fn straight(p: &mut [Point], random: &mut Random) {
    let bits = width(random);
    let size = (1_u64 << (bits + 5)) as f64;
    for (p, unit) in p.iter_mut().zip(UNIT_PRISM) {
        *p = plus(&point(random, bits), &unit, size);
    }
}

/// Three pillars on the upper side of a triangle, one of them or more parallel to it.
fn section(p: &mut [Point], random: &mut Random) {
    // Small numbers: the normal is exact.
    let bits = [1, 3, 8, 16][random.below(4)];
    for p in p.iter_mut() {
        *p = point(random, bits);
    }
    let [u, v] = [1, 2].map(|i| plus(&p[i], &p[0], -1.0));
    let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let flat = random.below(3);
    for i in 0..3 {
        p[6 + i] = if i == flat || random.below(8) == 0 {
            parallel(&p[3 + i], &p[..3], random)
        } else {
            plus(&p[3 + i], &normal, 1.0)
        };
    }
}
