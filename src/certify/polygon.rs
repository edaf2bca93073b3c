//! Convex polygons in a triangle's plane, exactly: what several of them cover, and what they leave over.
//!
//! Corners are integer weights on the triangle's corners, half spaces are linear functions on weights.

use dashu_ratio::RBig;

use super::exact::{Vec3, Weights, cross, cut, det3, has_area, normalised, sum, to_integers};

/// A convex polygon.
pub(crate) type Polygon = Vec<Weights>;

/// Corners without common factors. Each lies on two given lines, so their size stays bounded however often polygons
/// are cut; without this it would double with every cut.
fn reduced(polygon: Polygon) -> Polygon {
    polygon.into_iter().map(|w| normalised(&w).map_or(w, |x| to_integers(&x))).collect()
}

/// The part in all the half spaces; empty if it has no area.
pub(crate) fn within(polygon: &[Weights], halves: &[Vec3]) -> Polygon {
    let mut part = polygon.to_vec();
    for half in halves {
        part = reduced(cut(&part, half));
        if !has_area(&part) {
            return Polygon::new();
        }
    }
    part
}

/// What remains of disjoint polygons outside the intersection of half spaces, as disjoint polygons with area.
pub(crate) fn without(polygons: Vec<Polygon>, halves: &[Vec3]) -> Vec<Polygon> {
    let mut out = Vec::with_capacity(polygons.len());
    for polygon in polygons {
        if within(&polygon, halves).is_empty() {
            out.push(polygon);
            continue;
        }
        let mut rest = polygon;
        for half in halves {
            let beyond = reduced(cut(&rest, &half.each_ref().map(|x| -x)));
            if has_area(&beyond) {
                out.push(beyond);
            }
            rest = reduced(cut(&rest, half));
        }
    }
    out
}

/// The half spaces of a convex polygon with corners in counter-clockwise order.
pub(crate) fn sides(polygon: &[Weights]) -> Vec<Vec3> {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| cross(p, q)).collect()
}

/// The polygon's share of the triangle's area.
pub(crate) fn share(polygon: &[Weights]) -> RBig {
    let points: Vec<[RBig; 3]> = polygon.iter().filter_map(normalised).collect();
    let Some((first, rest)) = points.split_first() else { return RBig::ZERO };
    let total = sum(rest.windows(2).map(|pair| det3([first, &pair[0], &pair[1]])));
    if total < RBig::ZERO { -total } else { total }
}

/// Lower and upper bounds of each weight (sum one), as doubles: each quotient is rounded by at most one unit in the
/// last place, which stepping one double outwards undoes.
pub(crate) fn bounds(polygon: &[Weights]) -> [[f64; 2]; 3] {
    let mut out = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
    for point in polygon.iter().filter_map(normalised) {
        for (range, x) in out.iter_mut().zip(&point) {
            let x = x.to_f64().value();
            *range = [range[0].min(x.next_down()), range[1].max(x.next_up())];
        }
    }
    out
}
