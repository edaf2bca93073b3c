//! Which of many polygons in a triangle can hold a point: a filter that never loses a candidate.

/// Rows of a polygon: it lies where none of these linear forms of the weights is negative.
pub(super) type Rows = Vec<[f64; 3]>;

/// No smaller squares than `2^-DEPTH`.
const DEPTH: u32 = 9;
/// Lists of this length are not divided.
const SHORT: usize = 6;
/// A point may be off by this much in each weight; see [`QuadTree::candidates`].
pub(super) const SLACK: f64 = 1e-12;

#[derive(Debug)]
enum Node {
    Leaf {
        from: u32,
        to: u32,
    },
    /// The first of four children.
    Split(u32),
}

/// Squares of the second and the third weight, each with the polygons that meet it.
#[derive(Debug)]
pub(super) struct QuadTree {
    nodes: Vec<Node>,
    items: Vec<u32>,
}

#[derive(Clone, Copy)]
struct Square {
    x: f64,
    y: f64,
    side: f64,
}

impl Square {
    fn quarter(self, k: u32) -> Self {
        let side = self.side / 2.0;
        Self { x: self.x + side * f64::from(k % 2), y: self.y + side * f64::from(k / 2), side }
    }

    /// Is the form negative all over the square, by more than a point's error can hide?
    ///
    /// The form's value at a corner is computed to within `1e-14` of the sum of the coefficients'
    /// absolute values, and changes by at most twice [`SLACK`] times that sum when the point does by
    /// `SLACK`: the margin is a hundred times as much. A comparison with NaN fails, which keeps the polygon.
    fn excludes(self, row: &[f64; 3]) -> bool {
        let [a, b, c] = *row;
        let (dx, dy) = (b - a, c - a);
        let at = a + dx * self.x + dy * self.y;
        let most = at + self.side * (dx.max(0.0) + dy.max(0.0));
        most < -1e-9 * (a.abs() + b.abs() + c.abs())
    }
}

impl QuadTree {
    /// `rows(item)` are the forms of a polygon. `O(n log n)` for small polygons.
    pub(super) fn new(items: Vec<u32>, rows: &dyn Fn(u32) -> Rows) -> Self {
        let mut tree = Self { nodes: vec![Node::Leaf { from: 0, to: 0 }], items: Vec::new() };
        let polygons: Vec<(u32, Rows)> = items.into_iter().map(|i| (i, rows(i))).collect();
        let all: Vec<usize> = (0..polygons.len()).collect();
        tree.fill(0, Square { x: 0.0, y: 0.0, side: 1.0 }, &all, &polygons, 0);
        tree
    }

    fn fill(&mut self, node: usize, square: Square, mine: &[usize], polygons: &[(u32, Rows)], depth: u32) {
        let kept = |quarter: Square| -> Vec<usize> {
            if quarter.x + quarter.y > 1.0 + 1e-9 {
                return Vec::new();
            }
            let meets = |&&i: &&usize| !polygons[i].1.iter().any(|row| quarter.excludes(row));
            mine.iter().filter(meets).copied().collect()
        };
        if mine.len() > SHORT && depth < DEPTH {
            let parts = [0, 1, 2, 3].map(|k| kept(square.quarter(k)));
            // Polygons that fill the square are not told apart by smaller ones.
            if parts.iter().map(Vec::len).sum::<usize>() < 3 * mine.len() {
                let first = self.nodes.len();
                self.nodes[node] = Node::Split(number(first));
                self.nodes.extend((0..4).map(|_| Node::Leaf { from: 0, to: 0 }));
                for (k, part) in (0_u32..).zip(parts) {
                    self.fill(first + k as usize, square.quarter(k), &part, polygons, depth + 1);
                }
                return;
            }
        }
        let from = number(self.items.len());
        self.items.extend(mine.iter().map(|&i| polygons[i].0));
        self.nodes[node] = Node::Leaf { from, to: number(self.items.len()) };
    }

    /// All polygons that hold a point whose weights differ from these by at most [`SLACK`].
    pub(super) fn candidates(&self, weights: [f64; 3]) -> &[u32] {
        let [_, x, y] = weights.map(|w| w.clamp(0.0, 1.0));
        let mut square = Square { x: 0.0, y: 0.0, side: 1.0 };
        let mut node = 0;
        loop {
            match self.nodes[node] {
                Node::Leaf { from, to } => return &self.items[from as usize..to as usize],
                Node::Split(first) => {
                    let half = square.side / 2.0;
                    let k = u32::from(x >= square.x + half) + 2 * u32::from(y >= square.y + half);
                    square = square.quarter(k);
                    node = (first + k) as usize;
                }
            }
        }
    }
}

/// Lengths here are far below `2^32`: every list holds numbers of pieces, at most `4^9` squares a triangle.
fn number(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}
