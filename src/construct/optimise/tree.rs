//! A static tree of boxes over the mesh's triangles. Only comparisons of stored coordinates decide: exact.

use crate::mesh::TriMesh;

/// A closed box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Box3 {
    low: [f64; 3],
    high: [f64; 3],
}

impl Box3 {
    /// The smallest box of some points.
    pub(crate) fn of<'p>(points: impl IntoIterator<Item = &'p [f64; 3]>) -> Self {
        let mut out = Self { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3] };
        for p in points {
            for ((low, high), x) in out.low.iter_mut().zip(&mut out.high).zip(p) {
                *low = low.min(*x);
                *high = high.max(*x);
            }
        }
        out
    }

    fn joined(&self, other: &Self) -> Self {
        Self::of([&self.low, &self.high, &other.low, &other.high])
    }

    /// The corner with the least and that with the greatest coordinates.
    pub(crate) fn ends(&self) -> [[f64; 3]; 2] {
        [self.low, self.high]
    }

    /// The lengths of the sides, rounded.
    pub(crate) fn sides(&self) -> [f64; 3] {
        [0, 1, 2].map(|i| self.high[i] - self.low[i])
    }

    /// Do the closed boxes share a point?
    pub(crate) fn meets(&self, other: &Self) -> bool {
        // Without short cuts: six comparisons are cheaper than six branches.
        let mut apart = false;
        for i in 0..3 {
            apart |= (self.high[i] < other.low[i]) | (other.high[i] < self.low[i]);
        }
        !apart
    }
}

/// The tree: an implicit binary tree over leaves of up to [`Tree::LEAF`] triangles.
#[derive(Debug)]
pub(crate) struct Tree {
    /// Boxes of the triangles in `order`.
    boxes: Vec<Box3>,
    order: Vec<u32>,
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Box3,
    /// Range in `order`.
    from: u32,
    to: u32,
    /// The second child (the first one follows its parent); 0 for a leaf.
    second: u32,
}

impl Tree {
    const LEAF: usize = 4;

    /// O(n log n).
    pub(crate) fn new(mesh: &TriMesh) -> Self {
        let all: Vec<Box3> =
            mesh.faces.iter().map(|f| Box3::of(f.iter().map(|&v| &mesh.vertices[v as usize]))).collect();
        let mut order: Vec<u32> = (0..all.len()).map(|i| u32::try_from(i).unwrap_or(u32::MAX)).collect();
        let mut nodes = Vec::with_capacity(all.len());
        if !order.is_empty() {
            let end = order.len();
            split(&all, &mut order, &mut nodes, 0, end);
        }
        let boxes = order.iter().map(|&i| all[i as usize]).collect();
        Self { boxes, order, nodes }
    }

    /// Calls `visit` with every triangle whose box meets the box, until it answers `false`; was it never `false`?
    pub(crate) fn all(&self, wanted: &Box3, mut visit: impl FnMut(u32) -> bool) -> bool {
        // Depth is at most log2 of 2^32 triangles, and every level leaves one entry.
        let mut stack = [0u32; 64];
        let mut height = 0;
        let mut next = if self.nodes.is_empty() { None } else { Some(0u32) };
        while let Some(k) = next {
            let node = &self.nodes[k as usize];
            if node.bounds.meets(wanted) {
                if node.second != 0 {
                    stack[height] = node.second;
                    height += 1;
                    next = Some(k + 1);
                    continue;
                }
                for i in node.from as usize..node.to as usize {
                    if self.boxes[i].meets(wanted) && !visit(self.order[i]) {
                        return false;
                    }
                }
            }
            next = height.checked_sub(1).map(|h| {
                height = h;
                stack[h]
            });
        }
        true
    }
}

/// Appends the nodes of `order[from..to]`.
fn split(all: &[Box3], order: &mut [u32], nodes: &mut Vec<Node>, from: usize, to: usize) {
    let part = &mut order[from..to];
    let bounds = part.iter().skip(1).fold(all[part[0] as usize], |b, &i| b.joined(&all[i as usize]));
    let id = nodes.len();
    let range = |x: usize| u32::try_from(x).unwrap_or(u32::MAX);
    nodes.push(Node { bounds, from: range(from), to: range(to), second: 0 });
    if to - from <= Tree::LEAF {
        return;
    }
    let axis = (0..3)
        .max_by(|&i, &j| (bounds.high[i] - bounds.low[i]).total_cmp(&(bounds.high[j] - bounds.low[j])))
        .unwrap_or(0);
    // Half the sum overflows for no finite box.
    let centre = |i: u32| 0.5 * all[i as usize].low[axis] + 0.5 * all[i as usize].high[axis];
    let half = (to - from) / 2;
    part.select_nth_unstable_by(half, |&i, &j| centre(i).total_cmp(&centre(j)).then(i.cmp(&j)));
    split(all, order, nodes, from, from + half);
    nodes[id].second = range(nodes.len());
    split(all, order, nodes, from + half, to);
}
