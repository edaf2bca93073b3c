//! Boxes around tets and triangles: a filter that never loses a candidate.

use rstar::primitives::{GeomWithData, Rectangle};
use rstar::{AABB, RTree};

type Item = GeomWithData<Rectangle<[f64; 3]>, u32>;

/// Closed boxes, numbered in the order in which they were given. Minima and maxima of stored
/// doubles and comparisons only, so nothing is rounded.
#[derive(Debug)]
pub(super) struct BoxTree(RTree<Item>);

impl BoxTree {
    /// A tree over the bounding boxes of point sets with finite coordinates; `O(n log n)`.
    // A lifetime in `impl Trait` needs a name on stable Rust, whatever the lint says.
    #[allow(single_use_lifetimes)]
    pub(super) fn new<'p, const N: usize>(sets: impl IntoIterator<Item = [&'p [f64; 3]; N]>) -> Self {
        let item = |(id, points): (u32, [&[f64; 3]; N])| {
            let corner = |pick: fn(f64, f64) -> f64, from: f64| {
                [0, 1, 2].map(|axis| points.iter().map(|p| p[axis]).fold(from, pick))
            };
            let (low, high) = (corner(f64::min, f64::INFINITY), corner(f64::max, f64::NEG_INFINITY));
            GeomWithData::new(Rectangle::from_corners(low, high), id)
        };
        Self(RTree::bulk_load((0..).zip(sets).map(item).collect()))
    }

    /// The numbers of all boxes that meet the closed box `low..high`, ascending.
    pub(super) fn meeting(&self, [low, high]: [[f64; 3]; 2]) -> Vec<u32> {
        let near = self.0.locate_in_envelope_intersecting(&AABB::from_corners(low, high));
        let mut ids: Vec<u32> = near.map(|item| item.data).collect();
        ids.sort_unstable();
        ids
    }
}
