//! The tets of a prism, and the set that a vertex order selects (FORMAT section 1).

use crate::line::Names4;
use crate::world::World;

/// A tet of a prism's slab.
#[derive(Clone, Copy)]
pub(crate) struct Tet {
    pub(crate) prism: usize,
    /// Its names, ascending.
    pub(crate) names: Names4,
    /// Differences of points whose determinant is the tet's.
    pub(crate) rows: [[usize; 2]; 3],
    /// The names at the lower and the upper end of the pillar half that it carries.
    pub(crate) pillar: [usize; 2],
    /// Bit `i` is set if it is a tet of the `i`-th of [`ORDERS`].
    orders: u8,
    /// Whether its determinant is positive.
    pub(crate) positive: bool,
}

/// The orders of three corners, even permutations first.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// The different ones of a prism's 24 tets, by ascending names.
pub(crate) fn all(world: &World, prism: usize) -> Vec<Tet> {
    let mut tets = Vec::new();
    for (i, order) in ORDERS.iter().enumerate() {
        let [u, v, w] = order.map(|corner| world.shell.triangles[prism][corner]);
        for slab in 0..2 {
            let [lo, hi] = [slab, slab + 1].map(|layer| [u, v, w].map(|x| world.name(x, layer)));
            let listed = [
                (2, [lo[0], lo[1], lo[2], hi[2]]),
                (1, [lo[0], lo[1], hi[1], hi[2]]),
                (0, [lo[0], hi[0], hi[1], hi[2]]),
            ];
            for (carried, mut names) in listed.into_iter().filter(|t| lo[t.0] != hi[t.0]) {
                let [a, b, c, d] = names;
                // Listed with the tet's orientation, or with two points to be exchanged.
                let even = (i < 3) == (carried != 1);
                let rows = if even { [[a, b], [a, c], [a, d]] } else { [[a, c], [a, b], [a, d]] };
                names.sort_unstable();
                let pillar = [lo[carried], hi[carried]];
                tets.push(Tet { prism, names, rows, pillar, orders: 1 << i, positive: false });
            }
        }
    }
    tets.sort_unstable_by_key(|t| t.names);
    // Tets with the same names carry the same pillar and have the same orientation.
    tets.dedup_by(|tet, kept| {
        let same = tet.names == kept.names;
        kept.orders |= if same { tet.orders } else { 0 };
        same
    });
    tets.iter_mut().for_each(|tet| tet.positive = world.sign(tet.rows) > 0);
    tets
}

/// `S_<`: the tets that a vertex order selects.
pub(crate) struct Selected {
    pub(crate) tets: Vec<Tet>,
    /// The tets that hold each name.
    star: Vec<Vec<usize>>,
}

impl Selected {
    /// The order has the vertices of `first`, then those of `order`; a vertex stands where it is named first.
    pub(crate) fn new(world: &World, first: &[usize], order: &[usize]) -> Self {
        let mut rank = vec![usize::MAX; order.len()];
        for (i, &v) in first.iter().chain(order).enumerate() {
            rank[v] = rank[v].min(i);
        }
        let (mut tets, mut star) = (Vec::new(), vec![Vec::new(); 3 * order.len()]);
        for (prism, all) in world.shell.triangles.iter().zip(&world.tets) {
            let chosen = ORDERS.iter().position(|o| o.is_sorted_by_key(|&i| rank[prism[i]])).unwrap_or(0);
            for tet in all.iter().filter(|t| t.orders >> chosen & 1 == 1) {
                tet.names.iter().for_each(|&name| star[name].push(tets.len()));
                tets.push(*tet);
            }
        }
        Self { tets, star }
    }

    /// The tets that hold all the names (at least one), by looking at the name with the fewest tets.
    pub(crate) fn holding(&self, names: &[usize]) -> impl Iterator<Item = usize> {
        let short = names.iter().map(|&n| self.star[n].as_slice()).min_by_key(|s| s.len()).unwrap_or(&[]);
        short.iter().copied().filter(|&t| names.iter().all(|n| self.tets[t].names.contains(n)))
    }
}
