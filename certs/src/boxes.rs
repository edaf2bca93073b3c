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
}

/// A balanced tree: node `k` has the children `2k + 1` and `2k + 2`, each with half of the boxes.
pub(crate) struct Tree {
    boxes: Vec<(Aabb, usize)>,
    nodes: Vec<Aabb>,
}

impl Tree {
    pub(crate) fn new(boxes: impl Iterator<Item = Aabb>) -> Self {
        let boxes: Vec<_> = boxes.enumerate().map(|(i, b)| (b, i)).collect();
        let nodes = vec![NOTHING; 2 * boxes.len().next_power_of_two()];
        let mut tree = Self { nodes, boxes };
        tree.build(0, 0, tree.boxes.len(), 0);
        tree
    }

    fn build(&mut self, node: usize, from: usize, to: usize, axis: usize) {
        let boxes = &mut self.boxes[from..to];
        self.nodes[node] = boxes.iter().fold(NOTHING, |all, b| all.join(&b.0));
        if boxes.len() > 1 {
            let half = boxes.len() / 2;
            boxes.select_nth_unstable_by_key(half, |b| b.0.0[axis] / 2 + b.0.1[axis] / 2);
            self.build(2 * node + 1, from, from + half, (axis + 1) % 3);
            self.build(2 * node + 2, from + half, to, (axis + 1) % 3);
        }
    }

    /// The numbers of the boxes that meet `query`.
    pub(crate) fn meeting(&self, query: &Aabb) -> Vec<usize> {
        let (mut found, mut stack) = (Vec::new(), vec![(0, 0, self.boxes.len())]);
        while let Some((node, from, to)) = stack.pop() {
            if from < to && self.nodes[node].meets(query) {
                let middle = from + (to - from) / 2;
                match to - from {
                    1 => found.push(self.boxes[from].1),
                    _ => stack.extend([(2 * node + 1, from, middle), (2 * node + 2, middle, to)]),
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests;
