//! Segments and rays against triangles by computing the common point, in integers.

use dashu_base::Signed;
use dashu_int::IBig;

use crate::number::dyadic::scale_points;

type Vector = [IBig; 3];

/// How far from its first point through its second one a piece of a line goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reach {
    /// To the second point.
    Segment,
    /// Without end.
    Ray,
}

impl Reach {
    /// Is `0 <= numerator / denominator`, and `<= 1` for a segment?
    fn holds(self, numerator: &IBig, denominator: &IBig) -> bool {
        let (numerator, denominator) = if denominator.is_negative() {
            (-numerator, -denominator)
        } else {
            (numerator.clone(), denominator.clone())
        };
        !numerator.is_negative() && (self == Self::Ray || numerator <= denominator)
    }
}

fn minus(p: &Vector, q: &Vector) -> Vector {
    [&p[0] - &q[0], &p[1] - &q[1], &p[2] - &q[2]]
}

fn dot(p: &Vector, q: &Vector) -> IBig {
    &p[0] * &q[0] + &p[1] * &q[1] + &p[2] * &q[2]
}

fn cross(p: &Vector, q: &Vector) -> Vector {
    [&p[1] * &q[2] - &p[2] * &q[1], &p[2] * &q[0] - &p[0] * &q[2], &p[0] * &q[1] - &p[1] * &q[0]]
}

fn is_zero(v: &Vector) -> bool {
    v.iter().all(|x| *x == IBig::ZERO)
}

/// Does the segment or ray meet the closed triangle? `None` if its area or their length is zero.
pub(super) fn reaches(reach: Reach, [s, t]: [&[f64; 3]; 2], [a, b, c]: [&[f64; 3]; 3]) -> Option<bool> {
    let (points, _) = scale_points(&[*s, *t, *a, *b, *c]);
    let [s, t, a, b, c] = <[Vector; 5]>::try_from(points).ok()?;
    let along = minus(&t, &s);
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    if is_zero(&normal) || is_zero(&along) {
        return None;
    }
    // The point s + (height / slope) along lies in the plane.
    let (height, slope) = (dot(&normal, &minus(&a, &s)), dot(&normal, &along));
    let edges = [[&a, &b], [&b, &c], [&c, &a]];
    if slope == IBig::ZERO {
        return Some(
            height == IBig::ZERO
                && (edges.iter().all(|[p, q]| inner(&normal, p, q, &s, &IBig::ONE))
                    || edges.iter().any(|edge| meets_edge(reach, &s, &along, &normal, *edge))),
        );
    }
    if !reach.holds(&height, &slope) {
        return Some(false);
    }
    // That point times the slope, with a positive slope.
    let (height, slope) = if slope.is_negative() { (-height, -slope) } else { (height, slope) };
    let foot = [0, 1, 2].map(|k| &s[k] * &slope + &along[k] * &height);
    Some(edges.iter().all(|[p, q]| inner(&normal, p, q, &foot, &slope)))
}

/// Is the point `x / weight` of the plane on the inner side of the edge from `p` to `q`, or on its line?
fn inner(normal: &Vector, p: &Vector, q: &Vector, x: &Vector, weight: &IBig) -> bool {
    let scaled = [0, 1, 2].map(|k| &x[k] - &p[k] * weight);
    !dot(normal, &cross(&minus(q, p), &scaled)).is_negative()
}

/// Does the segment or ray `s + l along` meet the closed edge from `p` to `q`, all in one plane?
fn meets_edge(reach: Reach, s: &Vector, along: &Vector, normal: &Vector, [p, q]: [&Vector; 2]) -> bool {
    let (edge, from) = (minus(q, p), minus(p, s));
    let area = |v: &Vector, w: &Vector| dot(normal, &cross(v, w));
    let denominator = area(along, &edge);
    if denominator != IBig::ZERO {
        // s + l along = p + m edge.
        return reach.holds(&area(&from, &edge), &denominator)
            && Reach::Segment.holds(&area(&from, along), &denominator);
    }
    if area(&from, along) != IBig::ZERO {
        return false;
    }
    // On one line: an end of the edge on the piece. A piece within the edge begins in the triangle.
    let length = dot(along, along);
    [p, q].into_iter().any(|end| reach.holds(&dot(&minus(end, s), along), &length))
}

/// Does `p` lie in the convex hull of three points, collinear ones included?
pub(super) fn point_in_hull(p: &[f64; 3], [a, b, c]: [&[f64; 3]; 3]) -> bool {
    let (points, _) = scale_points(&[*p, *a, *b, *c]);
    let Ok([p, a, b, c]) = <[Vector; 4]>::try_from(points) else { return false };
    let edges = [[&a, &b], [&b, &c], [&c, &a]];
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    if is_zero(&normal) {
        return edges.iter().any(|[u, v]| {
            let (along, from) = (minus(v, u), minus(&p, u));
            is_zero(&cross(&along, &from))
                && if is_zero(&along) {
                    is_zero(&from)
                } else {
                    Reach::Segment.holds(&dot(&from, &along), &dot(&along, &along))
                }
        });
    }
    dot(&normal, &minus(&p, &a)) == IBig::ZERO
        && edges.iter().all(|[u, v]| inner(&normal, u, v, &p, &IBig::ONE))
}
