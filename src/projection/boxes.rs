//! Boxes around tets and triangles: a filter that never loses a candidate.
//!
//! The tree is one array in the order in which a search visits it, so that a search needs no stack, and many points can go
//! down together: that is what the trees of libraries do not offer, and what [`BoxTree::pairs`] is for.
//!
//! Its boxes take half of the memory of boxes of doubles: coordinates are counted from the middle of all boxes, in units of
//! about their extent, and rounded outwards to floats of 32 bits. A difference to a constant and a product with a positive
//! constant are rounded monotonically (also where they overflow or underflow), so a point within a box stays within it. Boxes
//! that are small beside the spacing of floats so far from the middle would all look alike: then halves of space get a middle
//! of their own.

use std::cmp::Ordering;

/// A closed box of doubles.
#[derive(Clone, Copy, Debug)]
struct Bounds {
    low: [f64; 3],
    high: [f64; 3],
}

/// A subtree: its nodes are this one, those of its left half, those of its right half.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// At most the lowest coordinates.
    low: [f32; 3],
    /// At least the highest ones.
    high: [f32; 3],
    /// The place after the subtree's last node.
    end: u32,
    /// The number of the box, where there is only one.
    id: u32,
}

/// Closed boxes, numbered in the order in which they were given. At most `2^31` of them; 64 bytes each.
#[derive(Debug)]
pub(super) struct BoxTree {
    /// Of all boxes.
    frame: Frame,
    /// One, unless boxes are small beside their distances.
    parts: Vec<Part>,
}

/// Coordinates from a middle in units of about an extent.
#[derive(Clone, Copy, Debug)]
struct Frame {
    middle: [f64; 3],
    /// Powers of two.
    scale: [f64; 3],
}

/// A tree over boxes near each other.
#[derive(Debug)]
struct Part {
    frame: Frame,
    nodes: Vec<Node>,
}

/// What [`BoxTree::pairs`] needs again and again; only the memory is used.
#[derive(Debug, Default)]
pub(super) struct Walk {
    local: Vec<[f64; 3]>,
    list: Vec<u32>,
}

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

    fn all(items: &[(Self, u32)]) -> Option<Self> {
        items.iter().map(|(b, _)| *b).reduce(|all, b| all.with(&b))
    }

    /// Half the length along an axis; halved for the same reason as in `center`.
    fn extent(&self, axis: usize) -> f64 {
        self.high[axis] / 2.0 - self.low[axis] / 2.0
    }

    fn longest(&self) -> usize {
        (1..3).fold(0, |best, axis| if self.extent(axis) > self.extent(best) { axis } else { best })
    }

    /// Halved before the addition: the sum of two doubles may overflow.
    fn center(&self, axis: usize) -> f64 {
        self.low[axis] / 2.0 + self.high[axis] / 2.0
    }
}

/// A power of two that brings a finite length `h >= 0` between about 1 and 4, or a shorter one below 4.
fn scale(h: f64) -> f64 {
    let biased = h.to_bits() >> 52 & 0x7ff;
    f64::from_bits(2046_u64.saturating_sub(biased).max(1) << 52)
}

/// The largest float of 32 bits that is not above a number.
fn below(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) > x { near.next_down() } else { near }
}

fn above(x: f64) -> f32 {
    -below(-x)
}

impl Node {
    fn new(bounds: &Bounds, end: u32, id: u32) -> Self {
        Self { low: bounds.low.map(below), high: bounds.high.map(above), end, id }
    }

    /// Without jumps: they would be hard to predict.
    #[inline]
    fn holds(&self, p: &[f64; 3]) -> bool {
        (0..3).fold(true, |all, i| all & (f64::from(self.low[i]) <= p[i]) & (p[i] <= f64::from(self.high[i])))
    }

    fn meets(&self, low: &[f64; 3], high: &[f64; 3]) -> bool {
        (0..3).all(|i| f64::from(self.low[i]) <= high[i] && low[i] <= f64::from(self.high[i]))
    }
}

impl Frame {
    fn around(all: &Bounds) -> Self {
        Self { middle: [0, 1, 2].map(|i| all.center(i)), scale: [0, 1, 2].map(|i| scale(all.extent(i))) }
    }

    #[inline]
    fn local(&self, p: &[f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| (p[i] - self.middle[i]) * self.scale[i])
    }

    /// Is a box larger than the spacing of floats of 32 bits there? Changes no answer, only what a search visits.
    fn resolves(&self, b: &Bounds) -> bool {
        let far = |i: usize| (b.low[i] - self.middle[i]).abs().max((b.high[i] - self.middle[i]).abs());
        let size = b.extent(b.longest());
        (0..3).all(|i| far(i) * f64::from(f32::EPSILON) <= size)
    }
}

/// Halved so often at most, to bound time and the number of parts.
const HALVINGS: u32 = 8;

/// Fewer boxes are not worth a part of their own.
const FEW: usize = 32;

/// The parts of some boxes.
fn divide(items: &mut [(Bounds, u32)], halvings: u32, parts: &mut Vec<Part>) {
    let Some(all) = Bounds::all(items) else { return };
    let frame = Frame::around(&all);
    let blurred = items.iter().filter(|(b, _)| !frame.resolves(b)).count();
    if halvings > 0 && items.len() > FEW && blurred > items.len() / 8 {
        let axis = all.longest();
        items.sort_unstable_by(|a, b| a.0.center(axis).total_cmp(&b.0.center(axis)));
        let below = items.partition_point(|(b, _)| b.center(axis) < frame.middle[axis]);
        let (left, right) = items.split_at_mut(below);
        if !left.is_empty() && !right.is_empty() {
            divide(left, halvings - 1, parts);
            divide(right, halvings - 1, parts);
            return;
        }
    }
    for (Bounds { low, high }, _) in items.iter_mut() {
        (*low, *high) = (frame.local(low), frame.local(high));
    }
    let mut nodes = Vec::with_capacity(2 * items.len());
    build(items, &mut nodes);
    parts.push(Part { frame, nodes });
}

impl BoxTree {
    /// A tree over the bounding boxes of point sets with finite coordinates; `O(n log n)`.
    // A lifetime in `impl Trait` needs a name on stable Rust, whatever the lint says.
    #[allow(single_use_lifetimes)]
    pub(super) fn new<'p, const N: usize>(sets: impl IntoIterator<Item = [&'p [f64; 3]; N]>) -> Self {
        let mut items: Vec<(Bounds, u32)> = sets.into_iter().map(Bounds::around).zip(0..).collect();
        let none = Frame { middle: [0.0; 3], scale: [1.0; 3] };
        let frame = Bounds::all(&items).map_or(none, |all| Frame::around(&all));
        let mut parts = Vec::new();
        divide(&mut items, HALVINGS, &mut parts);
        Self { frame, parts }
    }

    /// A place in the tree's own coordinates: within -4 and 4 in all boxes, unless the boxes are too wide to say.
    #[inline]
    pub(super) fn local(&self, p: &[f64; 3]) -> [f64; 3] {
        self.frame.local(p)
    }

    /// The numbers of all boxes that meet the closed box `low..high`, ascending; perhaps some that only come close.
    pub(super) fn meeting(&self, [low, high]: [[f64; 3]; 2]) -> Vec<u32> {
        let mut ids = Vec::new();
        for part in &self.parts {
            let (low, high) = (part.frame.local(&low), part.frame.local(&high));
            part.search(|node| node.meets(&low, &high), |id| ids.push(id));
        }
        ids.sort_unstable();
        ids
    }

    /// Visits all boxes that hold a point, in no particular order, perhaps some that only come close; none where a coordinate
    /// is not finite.
    #[inline]
    pub(super) fn holding(&self, p: &[f64; 3], mut visit: impl FnMut(u32)) {
        if p.iter().all(|x| x.is_finite()) {
            for part in &self.parts {
                let p = part.frame.local(p);
                part.search(|node| node.holds(&p), &mut visit);
            }
        }
    }

    /// Visits all boxes that hold points, each with the places of these in the list, as [`Self::holding`] would each point's
    /// boxes. The points go down the tree together: each node is fetched once for all that reach it.
    pub(super) fn pairs(&self, points: &[[f64; 3]], walk: &mut Walk, visit: &mut impl FnMut(&[u32], u32)) {
        let Walk { local, list } = walk;
        list.clear();
        let finite = |(_, p): &(u32, &[f64; 3])| p.iter().all(|x| x.is_finite());
        list.extend((0..).zip(points).filter(finite).map(|(i, _)| i));
        for part in &self.parts {
            local.clear();
            local.extend(points.iter().map(|p| part.frame.local(p)));
            part.descend(0, 0, local, list, visit);
        }
    }
}

impl Part {
    #[inline]
    fn search(&self, wanted: impl Fn(&Node) -> bool, mut visit: impl FnMut(u32)) {
        let mut at = 0;
        while let Some(node) = self.nodes.get(at) {
            let end = node.end as usize;
            if !wanted(node) {
                at = end;
                continue;
            }
            at += 1;
            if end == at {
                visit(node.id);
            }
        }
    }

    /// `list[from..]` are the points that reach the node's parent. As deep as the tree: the logarithm of its size.
    fn descend(
        &self,
        at: usize,
        from: usize,
        points: &[[f64; 3]],
        list: &mut Vec<u32>,
        visit: &mut impl FnMut(&[u32], u32),
    ) {
        let node = &self.nodes[at];
        let start = list.len();
        list.resize(2 * start - from, 0);
        let (above, own) = list.split_at_mut(start);
        let mut count = 0;
        for &i in &above[from..] {
            // Written in any case and kept if counted: no jump that would be hard to predict.
            own[count] = i;
            count += usize::from(node.holds(&points[i as usize]));
        }
        list.truncate(start + count);
        if count > 0 && node.end as usize == at + 1 {
            visit(&list[start..], node.id);
        } else if count > 0 {
            self.descend(at + 1, start, points, list, visit);
            self.descend(self.nodes[at + 1].end as usize, start, points, list, visit);
        }
        list.truncate(start);
    }
}

/// Appends the subtree of some boxes: halves by the middle of the longest axis.
fn build(items: &mut [(Bounds, u32)], nodes: &mut Vec<Node>) {
    let Some(&(first, id)) = items.first() else { return };
    let bounds = items.iter().fold(first, |all, (b, _)| all.with(b));
    let at = nodes.len();
    nodes.push(Node::new(&bounds, 0, id));
    if items.len() > 1 {
        let axis = bounds.longest();
        let by_center = |a: &(Bounds, u32), b: &(Bounds, u32)| -> Ordering {
            a.0.center(axis).total_cmp(&b.0.center(axis)).then(a.1.cmp(&b.1))
        };
        let middle = items.len() / 2;
        items.select_nth_unstable_by(middle, by_center);
        let (left, right) = items.split_at_mut(middle);
        build(left, nodes);
        build(right, nodes);
    }
    // A tree has less than two nodes a box.
    nodes[at].end = u32::try_from(nodes.len()).unwrap_or(u32::MAX);
}
