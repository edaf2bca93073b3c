//! Boxes around tets and triangles: a filter that never loses a candidate.
//!
//! The tree is one array in the order in which a search visits it, so that a search needs no stack, and many points can go
//! down together: that is what the trees of libraries do not offer, and what [`BoxTree::pairs`] is for.

use std::cmp::Ordering;

/// A closed box.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

/// A subtree: its nodes are this one, those of its left half, those of its right half.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    /// The place after the subtree's last node.
    end: usize,
    /// The number of the box, where there is only one.
    id: u32,
}

/// Closed boxes, numbered in the order in which they were given. Minima and maxima of stored
/// doubles and comparisons only, so nothing is rounded. 128 bytes a box.
#[derive(Debug)]
pub(super) struct BoxTree(Vec<Node>);

impl Bounds {
    fn around<const N: usize>(points: [&[f64; 3]; N]) -> Self {
        let corner = |pick: fn(f64, f64) -> f64, from: f64| {
            [0, 1, 2].map(|axis| points.iter().map(|p| p[axis]).fold(from, pick))
        };
        Self { low: corner(f64::min, f64::INFINITY), high: corner(f64::max, f64::NEG_INFINITY) }
    }

    fn with(&self, other: &Self) -> Self {
        Self {
            low: [0, 1, 2].map(|i| self.low[i].min(other.low[i])),
            high: [0, 1, 2].map(|i| self.high[i].max(other.high[i])),
        }
    }

    /// Never where a coordinate is not finite. Without jumps: they would be hard to predict.
    #[inline]
    fn holds(&self, p: &[f64; 3]) -> bool {
        (0..3).fold(true, |all, i| all & (self.low[i] <= p[i]) & (p[i] <= self.high[i]))
    }

    fn meets(&self, low: &[f64; 3], high: &[f64; 3]) -> bool {
        (0..3).all(|i| self.low[i] <= high[i] && low[i] <= self.high[i])
    }

    /// Halved before the addition: the sum of two doubles may overflow.
    fn center(&self, axis: usize) -> f64 {
        self.low[axis] / 2.0 + self.high[axis] / 2.0
    }
}

impl BoxTree {
    /// A tree over the bounding boxes of point sets with finite coordinates; `O(n log n)`.
    // A lifetime in `impl Trait` needs a name on stable Rust, whatever the lint says.
    #[allow(single_use_lifetimes)]
    pub(super) fn new<'p, const N: usize>(sets: impl IntoIterator<Item = [&'p [f64; 3]; N]>) -> Self {
        let mut items: Vec<(Bounds, u32)> = sets.into_iter().map(Bounds::around).zip(0..).collect();
        let mut nodes = Vec::with_capacity(2 * items.len());
        build(&mut items, &mut nodes);
        Self(nodes)
    }

    /// The numbers of all boxes that meet the closed box `low..high`, ascending.
    pub(super) fn meeting(&self, [low, high]: [[f64; 3]; 2]) -> Vec<u32> {
        let mut ids = Vec::new();
        self.search(|bounds| bounds.meets(&low, &high), |id| ids.push(id));
        ids.sort_unstable();
        ids
    }

    /// Visits all boxes that hold a point, in no particular order; none where a coordinate is not finite.
    #[inline]
    pub(super) fn holding(&self, p: &[f64; 3], visit: impl FnMut(u32)) {
        self.search(|bounds| bounds.holds(p), visit);
    }

    #[inline]
    fn search(&self, wanted: impl Fn(&Bounds) -> bool, mut visit: impl FnMut(u32)) {
        let mut at = 0;
        while let Some(node) = self.0.get(at) {
            if !wanted(&node.bounds) {
                at = node.end;
                continue;
            }
            at += 1;
            if node.end == at {
                visit(node.id);
            }
        }
    }

    /// Visits all pairs of a point, by its place in the list, and a box that holds it. The points go down the tree
    /// together: each node is fetched once for all that reach it. Of `scratch` only the memory is used.
    pub(super) fn pairs(
        &self,
        points: &[[f64; 3]],
        scratch: &mut Vec<u32>,
        visit: &mut impl FnMut(usize, u32),
    ) {
        scratch.clear();
        scratch.extend((0..).zip(points).map(|(i, _): (u32, _)| i));
        if !self.0.is_empty() {
            self.descend(0, 0, points, scratch, visit);
        }
    }

    /// `list[from..]` are the points that reach the node's parent. As deep as the tree: the logarithm of its size.
    fn descend(
        &self,
        at: usize,
        from: usize,
        points: &[[f64; 3]],
        list: &mut Vec<u32>,
        visit: &mut impl FnMut(usize, u32),
    ) {
        let Node { bounds, end, id } = &self.0[at];
        let start = list.len();
        list.resize(2 * start - from, 0);
        let (above, own) = list.split_at_mut(start);
        let mut count = 0;
        for &i in &above[from..] {
            // Written in any case and kept if counted: no jump that would be hard to predict.
            own[count] = i;
            count += usize::from(bounds.holds(&points[i as usize]));
        }
        list.truncate(start + count);
        if *end == at + 1 {
            list[start..].iter().for_each(|&i| visit(i as usize, *id));
        } else if count > 0 {
            self.descend(at + 1, start, points, list, visit);
            self.descend(self.0[at + 1].end, start, points, list, visit);
        }
        list.truncate(start);
    }

    /// The box around all boxes; `None` if there is none.
    pub(super) fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        self.0.first().map(|root| [root.bounds.low, root.bounds.high])
    }
}

/// Appends the subtree of some boxes: halves by the middle of the longest axis.
fn build(items: &mut [(Bounds, u32)], nodes: &mut Vec<Node>) {
    let Some(&(first, id)) = items.first() else { return };
    let bounds = items.iter().fold(first, |all, (b, _)| all.with(b));
    let at = nodes.len();
    nodes.push(Node { bounds, end: at + 1, id });
    if items.len() == 1 {
        return;
    }
    // Halved for the same reason as in `center`.
    let extent = |axis: usize| bounds.high[axis] / 2.0 - bounds.low[axis] / 2.0;
    let axis = (1..3).fold(0, |best, axis| if extent(axis) > extent(best) { axis } else { best });
    let by_center = |a: &(Bounds, u32), b: &(Bounds, u32)| -> Ordering {
        a.0.center(axis).total_cmp(&b.0.center(axis)).then(a.1.cmp(&b.1))
    };
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, by_center);
    let (left, right) = items.split_at_mut(middle);
    build(left, nodes);
    build(right, nodes);
    nodes[at].end = nodes.len();
}
