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
        Self(
            std::array::from_fn(|i| self.0[i].min(other.0[i])),
            std::array::from_fn(|i| self.1[i].max(other.1[i])),
        )
    }

    pub(crate) fn meets(&self, other: &Self) -> bool {
        (0..3).all(|i| self.0[i] <= other.1[i] && other.0[i] <= self.1[i])
    }
}

/// A balanced tree: node `k` has the children `2k + 1` and `2k + 2`, each with half of the boxes.
pub(crate) struct Tree {
    boxes: Vec<Aabb>,
    items: Vec<usize>,
    nodes: Vec<Aabb>,
}

impl Tree {
    pub(crate) fn new(boxes: Vec<Aabb>) -> Self {
        let nodes = vec![NOTHING; 2 * boxes.len().next_power_of_two()];
        let mut tree = Self { items: (0..boxes.len()).collect(), boxes, nodes };
        tree.build(0, 0, tree.items.len(), 0);
        tree
    }

    fn build(&mut self, node: usize, from: usize, to: usize, axis: usize) {
        let boxes = &self.boxes;
        let items = &mut self.items[from..to];
        self.nodes[node] = items.iter().fold(NOTHING, |b, &i| b.join(&boxes[i]));
        if items.len() > 1 {
            let half = items.len() / 2;
            items.select_nth_unstable_by_key(half, |&i| boxes[i].0[axis] / 2 + boxes[i].1[axis] / 2);
            self.build(2 * node + 1, from, from + half, (axis + 1) % 3);
            self.build(2 * node + 2, from + half, to, (axis + 1) % 3);
        }
    }

    /// The boxes that meet `query`, ascending.
    pub(crate) fn meeting(&self, query: &Aabb) -> Vec<usize> {
        let (mut found, mut stack) = (Vec::new(), vec![(0, 0, self.items.len())]);
        while let Some((node, from, to)) = stack.pop() {
            if from == to || !self.nodes[node].meets(query) {
                continue;
            }
            if to - from == 1 {
                found.push(self.items[from]);
                continue;
            }
            let middle = from + (to - from) / 2;
            stack.extend([(2 * node + 1, from, middle), (2 * node + 2, middle, to)]);
        }
        found.sort_unstable();
        found
    }

    pub(crate) fn get(&self, i: usize) -> &Aabb {
        &self.boxes[i]
    }
}

#[cfg(test)]
mod tests;
