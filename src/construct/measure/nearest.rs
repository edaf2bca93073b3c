//! The triangle nearest to a point. Floats, in units in which all coordinates are below 1: a proposal; but the boxes hold
//! their triangles.

use rstar::{AABB, PointDistance, RTree, RTreeObject};

use crate::construct::direction::{float_cross, float_dot};

type Point = [f64; 3];

/// A triangle of the mesh.
#[derive(Clone, Copy, Debug)]
struct Leaf {
    id: u32,
    corners: [Point; 3],
}

impl RTreeObject for Leaf {
    type Envelope = AABB<Point>;

    /// One ulp larger on every side than the corners, which may be rounded.
    fn envelope(&self) -> Self::Envelope {
        let [a, b, c] = self.corners;
        let low = [0, 1, 2].map(|i| a[i].min(b[i]).min(c[i]).next_down());
        let high = [0, 1, 2].map(|i| a[i].max(b[i]).max(c[i]).next_up());
        AABB::from_corners(low, high)
    }
}

impl PointDistance for Leaf {
    fn distance_2(&self, point: &Point) -> f64 {
        let d = squared(point, &at(&self.corners, &closest(&self.corners, point)));
        // The tree compares: it must not see NaN.
        if d.is_nan() { f64::INFINITY } else { d }
    }
}

/// The triangles of a mesh.
#[derive(Debug)]
pub(super) struct Nearest(RTree<Leaf>);

impl Nearest {
    /// O(n log n).
    pub(super) fn new(triangles: impl Iterator<Item = [Point; 3]>) -> Self {
        Self(RTree::bulk_load((0..).zip(triangles).map(|(id, corners)| Leaf { id, corners }).collect()))
    }

    /// A triangle near to the point, and the square of its distance.
    pub(super) fn to(&self, point: &Point) -> Option<(u32, f64)> {
        self.0.nearest_neighbor(point).map(|leaf| (leaf.id, leaf.distance_2(point)))
    }

    /// All triangles that may meet the box.
    pub(super) fn meeting(&self, [low, high]: [Point; 2]) -> impl Iterator<Item = u32> + '_ {
        self.0.locate_in_envelope_intersecting(&AABB::from_corners(low, high)).map(|leaf| leaf.id)
    }
}

fn minus(p: &Point, q: &Point) -> Point {
    [0, 1, 2].map(|i| p[i] - q[i])
}

/// The square of the distance.
pub(super) fn squared(p: &Point, q: &Point) -> f64 {
    let d = minus(p, q);
    float_dot(&d, &d)
}

/// The point with these weights.
pub(super) fn at(corners: &[Point; 3], weights: &[f64; 3]) -> Point {
    [0, 1, 2].map(|i| (0..3).map(|k| weights[k] * corners[k][i]).sum())
}

/// The weights of the triangle's point that is closest.
pub(super) fn closest(corners: &[Point; 3], point: &Point) -> [f64; 3] {
    let [a, b, c] = corners;
    let n = float_cross(&minus(b, a), &minus(c, a));
    let area = float_dot(&n, &n);
    let part = |p: &Point, q: &Point| float_dot(&n, &float_cross(&minus(q, p), &minus(point, p))) / area;
    let inside = [part(b, c), part(c, a), part(a, b)];
    if inside.iter().all(|w| *w >= 0.0) {
        return inside;
    }
    let side = |k: usize| {
        let (p, q) = (&corners[k], &corners[(k + 1) % 3]);
        let along = minus(q, p);
        let t = float_dot(&along, &minus(point, p)) / float_dot(&along, &along);
        let t = if t.is_nan() { 0.0 } else { t.clamp(0.0, 1.0) };
        let mut weights = [0.0; 3];
        weights[k] = 1.0 - t;
        weights[(k + 1) % 3] = t;
        weights
    };
    let far = |w: &[f64; 3]| squared(point, &at(corners, w));
    let sides = [side(0), side(1), side(2)];
    sides.into_iter().min_by(|v, w| far(v).total_cmp(&far(w))).unwrap_or([1.0, 0.0, 0.0])
}
