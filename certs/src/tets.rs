//! The tets of a prism, and the set that a vertex order selects (FORMAT section 1).

use crate::{line::Names4, world::World};

/// A tet of a prism's slab.
#[derive(Clone, Copy)]
pub(crate) struct Tet {
    pub(crate) prism: usize,
    /// Its names, ascending.
    pub(crate) names: Names4,
    /// Whether they are listed with the opposite of the tet's orientation.
    odd: bool,
    /// The names at the lower and the upper end of the pillar half that it carries.
    pub(crate) pillar: [usize; 2],
    /// Bit `i` is set if it is a tet of the `i`-th of [`ORDERS`].
    orders: u8,
    /// Whether its determinant is positive.
    pub(crate) positive: bool,
}

/// The orders of three corners, even permutations first.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

impl Tet {
    /// Differences of points whose determinant is the tet's.
    pub(crate) fn rows(&self) -> [[usize; 2]; 3] {
        let [a, b, c, d] = self.names;
        if self.odd { [[a, c], [a, b], [a, d]] } else { [[a, b], [a, c], [a, d]] }
    }
}

/// The different ones of a prism's 24 tets, by ascending names.
pub(crate) fn all(world: &World, prism: usize) -> Vec<Tet> {
    let mut tets: Vec<Tet> = Vec::with_capacity(24);
    for (i, slab) in (0..6).flat_map(|i| [(i, 0), (i, 1)]) {
        let corners = ORDERS[i].map(|corner| world.shell.triangles[prism][corner]);
        let [lo, hi] = [slab, slab + 1].map(|layer| corners.map(|v| world.name(v, layer)));
        for carried in (0..3).filter(|&c| lo[c] != hi[c]) {
            // The lower ends up to the carried pillar, the upper ends from there on.
            let mut names: Names4 = std::array::from_fn(|i| if i <= carried { lo[i] } else { hi[i - 1] });
            let greater = |i: usize, j: usize| usize::from(names[i] > names[j]);
            let inversions = (0..4).flat_map(|j| (0..j).map(move |i| (i, j))).map(|(i, j)| greater(i, j));
            let odd = (inversions.sum::<usize>() + usize::from(i >= 3) + carried) % 2 == 1;
            names.sort_unstable();
            // Tets with the same names carry the same pillar and have the same orientation.
            if let Some(tet) = tets.iter_mut().find(|t| t.names == names) {
                tet.orders |= 1 << i;
                continue;
            }
            let pillar = [lo[carried], hi[carried]];
            tets.push(Tet { prism, names, odd, pillar, orders: 1 << i, positive: false });
        }
    }
    tets.sort_unstable_by_key(|t| t.names);
    tets.iter_mut().for_each(|tet| tet.positive = world.sign(tet.rows()) > 0);
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

    /// The skin: the faces of just one tet, as ascending names, in ascending order.
    pub(crate) fn skin(&self) -> Vec<[usize; 3]> {
        let faces = |tet: &Tet| [3, 2, 1, 0].map(|k| [0, 1, 2].map(|i| tet.names[i + usize::from(i >= k)]));
        let mut skin: Vec<_> = self.tets.iter().flat_map(faces).collect();
        skin.retain(|face| self.holding(face).count() == 1);
        skin.sort_unstable();
        skin
    }

    /// The tets that hold all the names (at least one), by looking at the name with the fewest tets.
    pub(crate) fn holding(&self, names: &[usize]) -> impl Iterator<Item = usize> {
        let short = names.iter().map(|&n| self.star[n].as_slice()).min_by_key(|s| s.len()).unwrap_or(&[]);
        short.iter().copied().filter(|&t| names.iter().all(|n| self.tets[t].names.contains(n)))
    }
}
