//! Does a ray meet a triangle?

use super::position::{lexicographic, point_on_segment, same_point};
use super::{Axis, Sign, dot_sign, orient2d, orient3d, point_in_triangle, projection_axis};

/// Do the closed ray from `o` through `p` and the closed triangle share a point?
///
/// A ray with `o = p` is that point; a triangle of zero area is the union of its edges. Exact for all finite
/// coordinates.
pub fn ray_triangle([o, p]: [&[f64; 3]; 2], triangle: [&[f64; 3]; 3]) -> bool {
    let [a, b, c] = triangle;
    if same_point(o, p) {
        return point_in_triangle(o, triangle).is_some();
    }
    let edges = [[a, b], [b, c], [c, a]];
    let Some(axis) = projection_axis(a, b, c) else {
        return edges.into_iter().any(|edge| ray_segment([o, p], edge));
    };
    let (side, along) = (orient3d(a, b, c, o), dot_sign(a, b, c, o, p));
    if along.is_zero() {
        // Parallel to the plane, or in it.
        return side.is_zero()
            && (point_in_triangle(o, triangle).is_some()
                || edges.into_iter().any(|edge| ray_edge_in_plane([o, p], edge, axis)));
    }
    if side == along {
        return false;
    }
    // The ray holds exactly one point of the plane: as in `segment_triangle`.
    let turns = edges.map(|[s, t]| orient3d(o, p, s, t));
    !(turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative))
}

/// For a ray and a segment in space, the ray of positive length.
fn ray_segment([o, p]: [&[f64; 3]; 2], [a, b]: [&[f64; 3]; 2]) -> bool {
    if point_on_segment(o, [a, b]) {
        return true;
    }
    if !orient3d(o, p, a, b).is_zero() {
        return false;
    }
    match projection_axis(o, p, a).or_else(|| projection_axis(o, p, b)) {
        None => ahead([o, p], a) || ahead([o, p], b),
        Some(axis) => ray_edge_in_plane([o, p], [a, b], axis),
    }
}

/// For a ray and a segment in one plane that keeps its dimension along `axis`: a common point?
fn ray_edge_in_plane([o, p]: [&[f64; 3]; 2], [a, b]: [&[f64; 3]; 2], axis: Axis) -> bool {
    let [left, right] = [a, b].map(|q| orient2d(o, p, q, axis));
    if left == right {
        // Strictly on one side of the ray's line, or on it.
        return left.is_zero() && (ahead([o, p], a) || ahead([o, p], b) || point_on_segment(o, [a, b]));
    }
    // The line meets the edge's line in the point o + t (p - o) with t = orient(a, b, o) / cross(p - o, b - a),
    // and that denominator is orient(o, p, b) - orient(o, p, a), whose sign their order tells.
    // The point lies on the edge, whose ends are not strictly on one side.
    !(orient2d(a, b, o, axis) * Sign::from(right.cmp(&left))).is_negative()
}

/// Does `q`, a point of the ray's line, lie on the ray?
fn ahead([o, p]: [&[f64; 3]; 2], q: &[f64; 3]) -> bool {
    let order = lexicographic(o, q);
    order.is_eq() || order == lexicographic(o, p)
}
