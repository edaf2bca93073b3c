//! Boundary edges in the plane that share only common vertices.

use dashu_int::IBig;

use super::super::CertifyError;
use super::super::exact::{Vec3, normalised, to_integers};
use super::super::observer::Observer;
use super::super::pairs::BoxTree;
use super::super::separate::Few;
use super::facets::Facets;
use super::points::Point;
use super::witness::Witness;
use crate::predicate::{Axis, Sign};

/// All pairs of boundary edges with a common point that is no common vertex, and the number of pairs looked at.
pub(super) fn crossings<P: Point>(
    facets: &Facets<'_>,
    boundary: &[u32],
    points: &[P],
    observer: &dyn Observer,
) -> Result<(u64, Vec<Witness>), CertifyError> {
    let ends: Vec<[u32; 2]> = boundary
        .iter()
        .map(|&f| match facets.vertices(f)[..] {
            [a, b] => [a, b],
            _ => [0, 0],
        })
        .collect();
    let corners: Vec<Vec<[f64; 3]>> =
        ends.iter().map(|e| e.iter().flat_map(|&v| points[v as usize].corners()).collect()).collect();
    let tree = BoxTree::new(corners.iter().map(|c| c.iter().collect::<Few<_>>()));
    let (mut pairs, mut out) = (0, Vec::new());
    for (i, edge) in ends.iter().enumerate() {
        if observer.cancelled() {
            return Err(CertifyError::Cancelled);
        }
        let near = tree.meeting(&corners[i].iter().collect::<Vec<_>>());
        for j in near.into_iter().map(|j| j as usize).filter(|&j| j > i) {
            pairs += 1;
            if let Some([w, x]) = common_point(*edge, ends[j], points) {
                // Edges of cells that are not flat have a length: without one a crossing would be lost here.
                let weights = shortest(&w).zip(shortest(&x));
                let (w, x) =
                    weights.ok_or(CertifyError::Internal { what: "a boundary edge without length" })?;
                out.push(witness(facets, [boundary[i], boundary[j]], &[w, x]));
            }
        }
    }
    Ok((pairs, out))
}

/// Weights on the ends of both edges of a common point that is no common vertex.
fn common_point<P: Point>(first: [u32; 2], second: [u32; 2], points: &[P]) -> Option<[[IBig; 2]; 2]> {
    let at = |v: u32| &points[v as usize];
    let side = |[a, b]: [u32; 2], p: u32| P::orient2d(at(a), at(b), at(p), Axis::Z);
    let (s, t) = (second.map(|p| side(first, p)), first.map(|p| side(second, p)));
    let apart = |signs: [Sign; 2]| signs[0] == signs[1] && !signs[0].is_zero();
    if apart(s) || apart(t) {
        return None;
    }
    let ids = [first[0], first[1], second[0], second[1]];
    let x = P::integers(&ids.map(at));
    let [a, b, c, d] = x.as_slice() else { return None };
    if s == [Sign::Zero; 2] {
        return on_one_line(first, second, [a, b, c, d]);
    }
    let shared = first.iter().any(|v| second.contains(v));
    // Not on one line: at most one common point, which is the common vertex if there is one.
    if shared {
        return None;
    }
    let area =
        |p: &Vec3, q: &Vec3, r: &Vec3| (&q[0] - &p[0]) * (&r[1] - &p[1]) - (&q[1] - &p[1]) * (&r[0] - &p[0]);
    // The point on `a b` has the weights of the other end's distances from the line `c d`.
    let weights = |p: IBig, q: IBig| {
        if p < IBig::ZERO || q > IBig::ZERO { [-q, p].map(absolute) } else { [q, p].map(absolute) }
    };
    Some([weights(area(c, d, a), area(c, d, b)), weights(area(a, b, c), area(a, b, d))])
}

/// The same point by weights without a common factor.
fn shortest(weights: &[IBig; 2]) -> Option<[IBig; 2]> {
    normalised(weights).map(|w| to_integers(&w))
}

fn absolute(x: IBig) -> IBig {
    if x < IBig::ZERO { -x } else { x }
}

/// The middle of the common part of two edges on one line, unless that is a common vertex.
fn on_one_line(first: [u32; 2], second: [u32; 2], [a, b, c, d]: [&Vec3; 4]) -> Option<[[IBig; 2]; 2]> {
    // A coordinate that varies orders the line.
    let axis = if a[0] == b[0] { 1 } else { 0 };
    let [p, q, r, s] = [a, b, c, d].map(|x| &x[axis]);
    let low = p.min(q).max(r.min(s));
    let high = p.max(q).min(r.max(s));
    let forced = low == high && first.iter().any(|v| second.contains(v));
    if low > high || forced {
        return None;
    }
    // Twice the middle; weights of a point m between p and q: (q - m) : (m - p).
    let middle = low + high;
    let weights =
        |p: &IBig, q: &IBig| [IBig::from(2) * q - &middle, &middle - IBig::from(2) * p].map(absolute);
    Some([weights(p, q), weights(r, s)])
}

/// Weights on the cells' corners.
fn witness(facets: &Facets<'_>, edges: [u32; 2], weights: &[[IBig; 2]; 2]) -> Witness {
    let side = |edge: u32, pair: &[IBig; 2]| {
        let mut out = vec![IBig::ZERO; 3];
        for (place, w) in facets.places(edge).iter().zip(pair) {
            out[*place] = w.clone();
        }
        (facets.cell(edge), out)
    };
    let mut sides = [side(edges[0], &weights[0]), side(edges[1], &weights[1])];
    sides.sort_by_key(|(cell, _)| *cell);
    let [(i, w), (j, x)] = sides;
    Witness::Cross([i, j], [w, x])
}
