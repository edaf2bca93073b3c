//! Pairs of elements whose closed bounding boxes meet.

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

/// A tree over boxes. Only comparisons of stored coordinates decide, so the answer is exact.
pub(crate) struct BoxTree {
    tree: RTree<GeomWithData<Rectangle<[f64; 3]>, u32>>,
}

fn corners(points: &[&[f64; 3]]) -> ([f64; 3], [f64; 3]) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in points {
        for i in 0..3 {
            low[i] = low[i].min(p[i]);
            high[i] = high[i].max(p[i]);
        }
    }
    (low, high)
}

impl BoxTree {
    /// A tree over the boxes of point sets, numbered as they come. O(n log n).
    pub(crate) fn new<'p, P: AsRef<[&'p [f64; 3]]>>(sets: impl IntoIterator<Item = P>) -> Self {
        let leaf = |(id, points): (usize, P)| {
            let (low, high) = corners(points.as_ref());
            GeomWithData::new(Rectangle::from_corners(low, high), u32::try_from(id).unwrap_or(u32::MAX))
        };
        Self { tree: RTree::bulk_load(sets.into_iter().enumerate().map(leaf).collect()) }
    }

    /// The sets whose box meets the box of the points, ascending.
    pub(crate) fn meeting(&self, points: &[&[f64; 3]]) -> Vec<u32> {
        let (low, high) = corners(points);
        let envelope = AABB::from_corners(low, high);
        let mut out: Vec<u32> =
            self.tree.locate_in_envelope_intersecting(&envelope).map(|g| g.data).collect();
        out.sort_unstable();
        out
    }
}
