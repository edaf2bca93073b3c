//! Closed boxes in the order keys of coordinates, and a tree that finds the boxes that meet one.

/// Least and greatest keys.
#[derive(Clone, Copy)]
pub(crate) struct Aabb([i64; 3], [i64; 3]);

const NOTHING: Aabb = Aabb([i64::MAX; 3], [i64::MIN; 3]);

impl Aabb {
    /// The box of some points.
    pub(crate) fn of(keys: &[[i64; 3]], points: &[usize]) -> Self {
        points.iter().fold(NOTHING, |b, &p| b.join(&Self(keys[p], keys[p])))
    }

    fn join(&self, other: &Self) -> Self {
        let (low, high) = (|i: usize| self.0[i].min(other.0[i]), |i: usize| self.1[i].max(other.1[i]));
        Self(std::array::from_fn(low), std::array::from_fn(high))
    }

    pub(crate) fn meets(&self, other: &Self) -> bool {
        (0..3).all(|i| self.0[i] <= other.1[i] && other.0[i] <= self.1[i])
    }

    fn middle(&self, axis: usize) -> i64 {
        self.0[axis] / 2 + self.1[axis] / 2
    }
}

/// A node with at most so many boxes has no children.
const LEAF: usize = 8;
/// Boxes that are kept while their part of a tree is built. More are made again whenever they are compared.
const KEPT: usize = 1 << 15;

/// A balanced tree: node `k` has the children `2k + 1` and `2k + 2`, each with half of the boxes. The boxes themselves are
/// not stored, but made when they are asked for.
pub(crate) struct Tree<'a> {
    boxes: Box<dyn Fn(usize) -> Aabb + Sync + Send + 'a>,
    order: Vec<u32>,
    nodes: Vec<Aabb>,
}

impl<'a> Tree<'a> {
    /// The tree of the boxes `0..n`.
    pub(crate) fn new(n: usize, boxes: impl Fn(usize) -> Aabb + Sync + Send + 'a) -> Self {
        let depth = (0..).find(|&d| n.div_ceil(1 << d) <= LEAF).unwrap_or(0);
        let nodes = vec![NOTHING; (2 << depth) - 1];
        let mut tree = Self { boxes: Box::new(boxes), nodes, order: vec![] };
        let mut order: Vec<u32> = (0..n as u32).collect();
        tree.split(0, &mut order, 0);
        tree.order = order;
        tree
    }

    fn split(&mut self, node: usize, order: &mut [u32], axis: usize) {
        if order.len() <= KEPT {
            let mut boxes: Vec<_> = order.iter().map(|&i| ((self.boxes)(i as usize), i)).collect();
            self.build(node, &mut boxes, axis);
            order.iter_mut().zip(boxes).for_each(|(i, b)| *i = b.1);
            return;
        }
        let half = order.len() / 2;
        order.select_nth_unstable_by_key(half, |&i| (self.boxes)(i as usize).middle(axis));
        let (left, right) = order.split_at_mut(half);
        self.split(2 * node + 1, left, (axis + 1) % 3);
        self.split(2 * node + 2, right, (axis + 1) % 3);
        self.nodes[node] = self.nodes[2 * node + 1].join(&self.nodes[2 * node + 2]);
    }

    fn build(&mut self, node: usize, boxes: &mut [(Aabb, u32)], axis: usize) {
        self.nodes[node] = boxes.iter().fold(NOTHING, |all, b| all.join(&b.0));
        if boxes.len() > LEAF {
            let half = boxes.len() / 2;
            boxes.select_nth_unstable_by_key(half, |b| b.0.middle(axis));
            let (left, right) = boxes.split_at_mut(half);
            self.build(2 * node + 1, left, (axis + 1) % 3);
            self.build(2 * node + 2, right, (axis + 1) % 3);
        }
    }

    /// The numbers of the boxes that meet `query`.
    pub(crate) fn meeting(&self, query: &Aabb) -> Vec<usize> {
        let (mut found, mut stack) = (Vec::new(), vec![(0, &self.order[..])]);
        while let Some((node, part)) = stack.pop() {
            if !self.nodes[node].meets(query) {
                continue;
            }
            if part.len() <= LEAF {
                let ids = part.iter().map(|&i| i as usize);
                found.extend(ids.filter(|&i| (self.boxes)(i).meets(query)));
            } else {
                let (left, right) = part.split_at(part.len() / 2);
                stack.extend([(2 * node + 1, left), (2 * node + 2, right)]);
            }
        }
        found
    }
}

#[cfg(test)]
mod tests;
