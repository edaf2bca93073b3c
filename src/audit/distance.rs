//! How far points are from a shell's bottom and top, in floating point: a number for people, no decision.

use glam::DVec3;
use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

use crate::shell::{Layer, Shell};

/// A power of two near the largest absolute value of a coordinate, or one: in this unit squares and products of
/// coordinates neither overflow nor vanish, and scaling to it rounds nothing in the normal range.
pub(crate) fn unit<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> f64 {
    let largest = points.flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    if largest > 0.0 {
        // Without its mantissa; of a subnormal number nothing would be left.
        f64::from_bits(largest.to_bits() & f64::INFINITY.to_bits()).max(f64::MIN_POSITIVE)
    } else {
        1.0
    }
}

/// Bottom and top triangles, to be searched.
pub(crate) struct Caps {
    unit: f64,
    tree: RTree<GeomWithData<Rectangle<[f64; 3]>, [DVec3; 3]>>,
}

impl Caps {
    pub(crate) fn new(shell: &Shell) -> Self {
        let unit = unit(shell.bottom.iter().chain(&shell.top));
        let triangles = [Layer::Bottom, Layer::Top].into_iter().flat_map(|layer| {
            let points = shell.layer(layer);
            shell.faces.iter().map(move |f| f.map(|v| DVec3::from(points[v as usize]) / unit))
        });
        let leaf = |t: [DVec3; 3]| {
            let corners = t.map(|p| p.to_array());
            let bounds = AABB::from_points(corners.iter());
            GeomWithData::new(Rectangle::from_aabb(bounds), t)
        };
        Self { unit, tree: RTree::bulk_load(triangles.map(leaf).collect()) }
    }

    /// The distance of a point to the nearest triangle; infinite without triangles.
    pub(crate) fn distance(&self, point: [f64; 3]) -> f64 {
        let p = DVec3::from(point) / self.unit;
        let mut best = f64::INFINITY;
        for (leaf, box_distance_2) in self.tree.nearest_neighbor_iter_with_distance_2(&p.to_array()) {
            if box_distance_2 >= best * best {
                break;
            }
            best = best.min(p.distance(nearest(p, leaf.data)));
        }
        best * self.unit
    }
}

/// The point of a triangle nearest to `p` (Ericson, *Real-Time Collision Detection*, 5.1.5).
fn nearest(p: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let scale = 1.0 / (va + vb + vc);
    a + ab * (vb * scale) + ac * (vc * scale)
}
