//! Do two closed simplices meet, and in what dimension? Exact, all degenerate cases included.
//!
//! The common part of two closed convex sets is convex, so its dimension says all that a test for
//! forbidden contacts needs: two triangles that share an edge and no more meet in a [`Meeting::Segment`].

use super::position::{ZeroMask, ends, lexicographic, point_on_segment, same_point};
use super::{
    Axis, Sign, collinear, det_sign, orient2d, orient3d, point_in_tet, point_in_triangle, projection_axis,
};

/// The common part of two closed simplices, by dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Meeting {
    /// Empty.
    Disjoint,
    /// One point.
    Point,
    /// A segment of positive length.
    Segment,
    /// A convex polygon of positive area.
    Area,
}

impl Meeting {
    /// Is the common part not empty?
    #[inline]
    pub const fn meets(self) -> bool {
        !matches!(self, Self::Disjoint)
    }

    fn point_if(holds: bool) -> Self {
        if holds { Self::Point } else { Self::Disjoint }
    }

    /// The common part of two closed intervals of a line, given the order of every end of the first against
    /// every end of the second (each interval may name an end twice), and whether both are `proper`: of
    /// positive length.
    ///
    /// They meet exactly when some end of the first is not after some end of the second, and some end is not
    /// before some; with "before" and "after" strict, proper intervals share more than a point.
    fn of_intervals(orders: &[Sign], proper: bool) -> Self {
        let (before, after) =
            (orders.iter().any(|o| o.is_negative()), orders.iter().any(|o| o.is_positive()));
        let touch = orders.iter().any(|o| o.is_zero());
        match (before && after, touch) {
            (true, _) if proper => Self::Segment,
            (true, _) | (_, true) => Self::Point,
            _ => Self::Disjoint,
        }
    }
}

/// All signs equal and not zero?
fn strictly_one_side<const N: usize>(signs: [Sign; N]) -> bool {
    let sum: i8 = signs.iter().map(|sign| sign.as_i8()).sum();
    usize::from(sum.unsigned_abs()) == N
}

/// The ordered pairs `(i, j)` of corners with `signs[i] >= 0 >= signs[j]`, not both zero: the lines through
/// them meet the line (plane) that the signs refer to in the ends of its common part with the triangle.
fn crossing_edges(signs: [Sign; 3]) -> impl Iterator<Item = (usize, usize)> + Clone {
    (0..3)
        .flat_map(move |i| (0..3).map(move |j| (i, j)))
        .filter(move |&(i, j)| !signs[i].is_negative() && !signs[j].is_positive() && signs[i] != signs[j])
}

/// Does a triangle whose corners have these signs (not all zero) meet the line (plane) in a segment?
fn cut_is_proper(signs: [Sign; 3]) -> bool {
    let has = |wanted| signs.contains(&wanted);
    has(Sign::Positive) && has(Sign::Negative) || signs.iter().filter(|sign| sign.is_zero()).count() == 2
}

/// The common part of two closed segments.
pub fn segment_segment([a, b]: [&[f64; 3]; 2], [c, d]: [&[f64; 3]; 2]) -> Meeting {
    if same_point(a, b) {
        return Meeting::point_if(point_on_segment(a, [c, d]));
    }
    if same_point(c, d) {
        return Meeting::point_if(point_on_segment(c, [a, b]));
    }
    if !orient3d(a, b, c, d).is_zero() {
        return Meeting::Disjoint;
    }
    match projection_axis(a, b, c).or_else(|| projection_axis(a, b, d)) {
        None => collinear_segments([a, b], [c, d]),
        Some(axis) => {
            // In one plane, on two different lines: at most one common point.
            let sides =
                |[p, q]: [&[f64; 3]; 2], points: [&[f64; 3]; 2]| points.map(|r| orient2d(p, q, r, axis));
            let apart = strictly_one_side(sides([a, b], [c, d])) || strictly_one_side(sides([c, d], [a, b]));
            Meeting::point_if(!apart)
        }
    }
}

/// For two segments of positive length on one line.
fn collinear_segments(first: [&[f64; 3]; 2], second: [&[f64; 3]; 2]) -> Meeting {
    let orders = first.map(|p| second.map(|q| Sign::from(lexicographic(p, q))));
    Meeting::of_intervals(orders.as_flattened(), true)
}

/// The common part of the closed segment `(s, t)` and the closed triangle.
pub fn segment_triangle([s, t]: [&[f64; 3]; 2], triangle: [&[f64; 3]; 3]) -> Meeting {
    let [a, b, c] = triangle;
    if same_point(s, t) {
        return Meeting::point_if(point_in_triangle(s, triangle).is_some());
    }
    let Some(axis) = projection_axis(a, b, c) else {
        return segment_segment([s, t], ends(triangle));
    };
    let sides = [s, t].map(|p| orient3d(a, b, c, p));
    if strictly_one_side(sides) {
        return Meeting::Disjoint;
    }
    if sides == [Sign::Zero; 2] {
        return coplanar_segment_triangle([s, t], triangle, axis);
    }
    // The segment holds exactly one point of the plane. It lies in the triangle when no two edges see the
    // segment's line turn in opposite directions.
    let turns = [[a, b], [b, c], [c, a]].map(|[p, q]| orient3d(s, t, p, q));
    Meeting::point_if(!(turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative)))
}

/// For a segment of positive length in the plane of a triangle whose projection along `axis` is proper.
fn coplanar_segment_triangle([s, t]: [&[f64; 3]; 2], triangle: [&[f64; 3]; 3], axis: Axis) -> Meeting {
    let sides = triangle.map(|p| orient2d(s, t, p, axis));
    if strictly_one_side(sides) {
        return Meeting::Disjoint;
    }
    // Let the line through the corners i (left of or on the segment's line) and j (right of or on it, not
    // both on it) meet the segment's line in x. Then orient2d(i, j, p) = |p - x| * (a positive number) for
    // p behind x in the direction from s to t, and minus that before x. `orders`: x against s and t.
    let mut orders = [Sign::Zero; 6];
    let mut count = 0;
    for (slot, (i, j)) in orders.chunks_mut(2).zip(crossing_edges(sides)) {
        for (order, p) in slot.iter_mut().zip([s, t]) {
            *order = -orient2d(triangle[i], triangle[j], p, axis);
            count += 1;
        }
    }
    Meeting::of_intervals(orders.get(..count).unwrap_or_default(), cut_is_proper(sides))
}

/// The common part of two closed triangles.
///
/// Adjacent triangles of a mesh are embedded exactly when they meet in what they must: a shared vertex in a
/// [`Meeting::Point`], a shared edge in a [`Meeting::Segment`].
pub fn triangle_triangle(first: [&[f64; 3]; 3], second: [&[f64; 3]; 3]) -> Meeting {
    let [a, b, c] = first;
    let [d, e, f] = second;
    let second_sides = second.map(|p| orient3d(a, b, c, p));
    // All signs of a triangle of zero area are zero, so this holds for proper triangles only.
    if strictly_one_side(second_sides) {
        return Meeting::Disjoint;
    }
    let first_sides = first.map(|p| orient3d(d, e, f, p));
    if strictly_one_side(first_sides) {
        return Meeting::Disjoint;
    }
    if collinear(a, b, c) {
        return segment_triangle(ends(first), second);
    }
    if collinear(d, e, f) {
        return segment_triangle(ends(second), first);
    }
    if second_sides == [Sign::Zero; 3] {
        return coplanar_triangles(first, second);
    }
    // The planes meet in a line, each triangle meets that line in an interval (its cut). Let x be an end of
    // the second cut, on the line through corners i (at or above the first plane) and j (at or below, not
    // both on it), and y an end of the first cut, on the line through k and l likewise. With n, m the
    // normals, D = n x m, p = l - k and q = j - i: orient3d(k, l, i, j) = (x - y) . (q x p), and
    // D . (p x q) = (n.p)(m.q) - (n.q)(m.p) = -(n.q)(m.p) < 0, as n.p = 0, n.q < 0 and m.p < 0. So the sign
    // of orient3d(k, l, i, j) is that of x - y along D, for all pairs of ends alike.
    let mut orders = [Sign::Zero; 9];
    let mut count = 0;
    let (first_edges, second_edges) = (crossing_edges(first_sides), crossing_edges(second_sides));
    let pairs = first_edges.flat_map(|edge| second_edges.clone().map(move |other| (edge, other)));
    for (order, ((k, l), (i, j))) in orders.iter_mut().zip(pairs) {
        *order = orient3d(first[k], first[l], second[i], second[j]);
        count += 1;
    }
    let proper = cut_is_proper(first_sides) && cut_is_proper(second_sides);
    Meeting::of_intervals(orders.get(..count).unwrap_or_default(), proper)
}

/// For two triangles of positive area in one plane.
///
/// Two convex polygons are disjoint exactly when an edge of one has the other strictly outside, and have
/// disjoint interiors exactly when an edge of one has the other outside or on its line (the edges of the
/// Minkowski difference are parallel to edges of the two).
fn coplanar_triangles(first: [&[f64; 3]; 3], second: [&[f64; 3]; 3]) -> Meeting {
    let [a, b, c] = first;
    let Some(axis) = projection_axis(a, b, c) else { return segment_triangle(ends(first), second) };
    let mut contact = None;
    for (inner, outer) in [(first, second), (second, first)] {
        let turn = orient2d(inner[0], inner[1], inner[2], axis);
        for (i, j) in [(0, 1), (1, 2), (2, 0)] {
            let edge = [inner[i], inner[j]];
            let sides = outer.map(|p| orient2d(edge[0], edge[1], p, axis) * turn);
            if sides == [Sign::Negative; 3] {
                return Meeting::Disjoint;
            }
            if !sides.contains(&Sign::Positive) {
                contact = Some((edge, outer, sides));
            }
        }
    }
    let Some((edge, outer, sides)) = contact else { return Meeting::Area };
    // The common part lies on the edge's line, so it is the common part of the edge and of the other
    // triangle's corner or edge on that line.
    let mut on_line = outer.into_iter().zip(sides).filter(|(_, side)| side.is_zero()).map(|(p, _)| p);
    match (on_line.next(), on_line.next()) {
        (Some(p), Some(q)) => segment_segment(edge, [p, q]),
        (Some(p), None) => Meeting::point_if(point_on_segment(p, edge)),
        _ => Meeting::Disjoint,
    }
}

/// The common part of a closed triangle and a closed tet of any orientation; at most [`Meeting::Area`].
///
/// A common part within the tet's boundary lies in one face (it is convex). One that reaches the interior
/// has the dimension of the triangle.
pub fn triangle_tet(triangle: [&[f64; 3]; 3], tet: [&[f64; 3]; 4]) -> Meeting {
    let [a, b, c, d] = tet;
    let faces = [[b, c, d], [a, c, d], [a, b, d], [a, b, c]];
    let boundary = || faces.iter().map(|face| triangle_triangle(triangle, *face)).max();
    if orient3d(a, b, c, d).is_zero() {
        return boundary().unwrap_or(Meeting::Disjoint);
    }
    for (face, opposite) in faces.into_iter().zip(tet) {
        let [p, q, r] = face;
        let inner = orient3d(p, q, r, opposite);
        let sides = triangle.map(|x| orient3d(p, q, r, x) * inner);
        if sides == [Sign::Negative; 3] {
            return Meeting::Disjoint;
        }
        if !sides.contains(&Sign::Positive) {
            return triangle_triangle(triangle, face);
        }
    }
    let inside = triangle.into_iter().any(|x| point_in_tet(x, tet).is_some_and(ZeroMask::is_interior));
    if inside || !weakly_separated(triangle, tet) {
        dimension(triangle)
    } else {
        boundary().unwrap_or(Meeting::Disjoint)
    }
}

/// What a triangle meets itself in.
fn dimension([a, b, c]: [&[f64; 3]; 3]) -> Meeting {
    if !collinear(a, b, c) {
        Meeting::Area
    } else if same_point(a, b) && same_point(a, c) {
        Meeting::Point
    } else {
        Meeting::Segment
    }
}

/// The edges of a tet, each with the two corners that are not on it.
const TET_EDGES: [(usize, usize, usize, usize); 6] =
    [(0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2), (1, 2, 0, 3), (1, 3, 0, 2), (2, 3, 0, 1)];

/// The edges of a triangle, each with the corner that is not on it.
const TRIANGLE_EDGES: [(usize, usize, usize); 3] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];

/// Is there a plane with the (closed) triangle on one side or on it, and the interior of the tet on the
/// other, apart from the planes of the tet's faces, which the caller has tried?
///
/// The tet has positive volume, so its Minkowski difference with the triangle is a polytope with interior;
/// such a plane exists exactly when one exists that is parallel to a facet of that polytope. Facets are
/// parallel to a face of the tet, to the triangle, or to an edge of each.
fn weakly_separated(triangle: [&[f64; 3]; 3], tet: [&[f64; 3]; 4]) -> bool {
    let [u, v, w] = triangle;
    if splits(tet.map(|x| orient3d(u, v, w, x)), [Sign::Zero]) {
        return true;
    }
    // The plane through a tet edge (i, j), parallel to a triangle edge (k, l): i and j are on it, and k and l
    // are on the same side of it.
    TET_EDGES.into_iter().any(|(i, j, m, n)| {
        TRIANGLE_EDGES.into_iter().any(|(k, l, o)| {
            let side = |x| det_sign([tet[i], tet[j]], [triangle[k], triangle[l]], [tet[i], x]);
            let (first, second) = (side(tet[m]), side(tet[n]));
            // Opposite, or both zero because there is no plane: nothing is split.
            first != -second && splits([first, second], [side(triangle[k]), side(triangle[o])])
        })
    })
}

/// Is the tet on one side of the plane, not all in it, and the triangle on the other or on it? A plane that
/// is none (a zero normal, all signs zero) splits nothing.
fn splits<const N: usize, const M: usize>(tet: [Sign; N], triangle: [Sign; M]) -> bool {
    [Sign::Positive, Sign::Negative]
        .into_iter()
        .any(|side| tet.contains(&side) && !tet.contains(&-side) && !triangle.contains(&side))
}

/// Do a closed triangle and a closed tet of positive determinant share a point? What [`triangle_tet`] says of
/// them, with fewer signs: it does not ask for the dimension.
pub(crate) fn triangle_touches_tet(triangle: [&[f64; 3]; 3], tet: [&[f64; 3]; 4]) -> bool {
    // Meshes that share corners share many; signs of planes through them are zero, which takes longest.
    if triangle.iter().any(|x| tet.iter().any(|y| same_point(x, y))) {
        return true;
    }
    let [a, b, c, d] = tet;
    // Even permutations of the tet: the fourth corner is on the positive side of each face.
    let faces = [[a, b, c], [a, d, b], [a, c, d], [b, d, c]];
    let is_beyond = |x: &[f64; 3], [p, q, r]: [&[f64; 3]; 3]| orient3d(p, q, r, x).is_negative();
    if faces.into_iter().any(|face| triangle.into_iter().all(|x| is_beyond(x, face))) {
        return false;
    }
    let is_inside = |x: &[f64; 3]| !faces.into_iter().any(|face| is_beyond(x, face));
    triangle.into_iter().any(is_inside) || !strictly_separated(triangle, tet)
}

/// Is there a plane strictly between a triangle and a tet that has volume, apart from those parallel to faces of the
/// tet, which the caller has tried?
///
/// Their Minkowski difference is a polytope with interior. They are disjoint exactly when it does not hold the origin,
/// that is when the origin is strictly beyond a facet; facets are parallel to a face of the tet, to the triangle, or to
/// an edge of each. On the facet's plane through the edge of the tet, the tet is on one side or on it, and the triangle
/// strictly on the other.
fn strictly_separated(triangle: [&[f64; 3]; 3], tet: [&[f64; 3]; 4]) -> bool {
    let [u, v, w] = triangle;
    if strictly_one_side(tet.map(|x| orient3d(u, v, w, x))) {
        return true;
    }
    TET_EDGES.into_iter().any(|(i, j, m, n)| {
        TRIANGLE_EDGES.into_iter().any(|(k, l, o)| {
            let side = |x| det_sign([tet[i], tet[j]], [triangle[k], triangle[l]], [tet[i], x]);
            // The edge of the triangle is parallel to the plane: k stands for both of its ends.
            let beyond = side(triangle[k]);
            !beyond.is_zero()
                && side(triangle[o]) == beyond
                && side(tet[m]) != beyond
                && side(tet[n]) != beyond
        })
    })
}
