//! The tets of a prism, and the set that a vertex order selects (FORMAT section 1).

use crate::{line::Names4, world::World};
use rayon::prelude::*;

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
}

/// The orders of three corners, even permutations first.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

impl Tet {
    /// Differences of points whose determinant is the tet's.
    pub(crate) fn rows(&self) -> [[usize; 2]; 3] {
        let [a, b, c, d] = self.names;
        if self.odd { [[a, c], [a, b], [a, d]] } else { [[a, b], [a, c], [a, d]] }
    }

    /// Whether its determinant is positive.
    pub(crate) fn positive(&self, world: &World) -> bool {
        world.sign(self.rows()) > 0
    }
}

/// The tets that the `i`-th of [`ORDERS`] selects in a prism.
fn of_order(world: &World, prism: usize, i: usize) -> impl Iterator<Item = Tet> {
    let corners = ORDERS[i].map(|corner| world.shell.of(prism)[corner]);
    let layers = [0, 1, 2].map(|layer| corners.map(|v| world.name(v, layer)));
    let all = [0, 1].into_iter().flat_map(move |slab| [0, 1, 2].map(|carried| (slab, carried)));
    all.map(move |(slab, carried)| (layers[slab], layers[slab + 1], carried))
        .filter(|(lo, hi, carried)| lo[*carried] != hi[*carried])
        .map(move |(lo, hi, carried)| {
            // The lower ends up to the carried pillar, the upper ends from there on.
            let mut names: Names4 = std::array::from_fn(|i| if i <= carried { lo[i] } else { hi[i - 1] });
            let greater = |i: usize, j: usize| usize::from(names[i] > names[j]);
            let inversions = (0..4).flat_map(|j| (0..j).map(move |i| (i, j))).map(|(i, j)| greater(i, j));
            let odd = (inversions.sum::<usize>() + usize::from(i >= 3) + carried) % 2 == 1;
            names.sort_unstable();
            Tet { prism, names, odd, pillar: [lo[carried], hi[carried]] }
        })
}

/// The different ones of a prism's 24 tets, by ascending names.
pub(crate) fn all(world: &World, prism: usize) -> Vec<Tet> {
    let mut tets: Vec<Tet> = (0..6).flat_map(|i| of_order(world, prism, i)).collect();
    // Tets with the same names carry the same pillar and have the same orientation.
    tets.sort_unstable_by_key(|t| t.names);
    tets.dedup_by_key(|t| t.names);
    tets
}

/// Those with which triangle `f` has a dot that is not positive.
pub(crate) fn steep(world: &World, f: usize, prism: usize) -> Vec<Tet> {
    let mut tets = if world.rises(f, prism) { Vec::new() } else { all(world, prism) };
    tets.retain(|tet| world.sign(world.dot(f, tet.pillar)) <= 0);
    tets
}

/// `S_<`: the tets that a vertex order selects. They are made anew whenever they are asked for: to keep them takes more
/// memory than everything else.
pub(crate) struct Selected<'a> {
    world: &'a World,
    /// The place of each vertex in the order.
    rank: Vec<usize>,
}

impl<'a> Selected<'a> {
    /// The order has the vertices of `first`, then those of `order`; a vertex stands where it is named first.
    pub(crate) fn new(world: &'a World, first: &[usize], order: &[usize]) -> Self {
        let mut rank = vec![usize::MAX; order.len()];
        for (i, &v) in first.iter().chain(order).enumerate() {
            rank[v] = rank[v].min(i);
        }
        Self { world, rank }
    }

    /// Those of one prism.
    pub(crate) fn of(&self, prism: usize) -> impl Iterator<Item = Tet> {
        let corners = self.world.shell.of(prism);
        let chosen = ORDERS.iter().position(|o| o.is_sorted_by_key(|&i| self.rank[corners[i]]));
        of_order(self.world, prism, chosen.unwrap_or(0))
    }

    /// All of them.
    pub(crate) fn tets(&self) -> impl Iterator<Item = Tet> {
        (0..self.world.shell.len()).flat_map(|prism| self.of(prism))
    }

    /// Whether all are positive.
    pub(crate) fn positive(&self) -> bool {
        let prisms = (0..self.world.shell.len()).into_par_iter();
        prisms.all(|prism| self.of(prism).all(|tet| tet.positive(self.world)))
    }

    /// The skin: the faces of just one tet, as ascending names, in ascending order.
    pub(crate) fn skin(&self) -> Vec<[usize; 3]> {
        let faces = |tet: Tet| [3, 2, 1, 0].map(|k| [0, 1, 2].map(|i| tet.names[i + usize::from(i >= k)]));
        let mut skin: Vec<_> = self.tets().flat_map(faces).collect();
        skin.sort_unstable();
        skin.chunk_by(|a, b| a == b).filter(|same| same.len() == 1).map(|same| same[0]).collect()
    }

    /// The tets that hold all the names (at least one).
    pub(crate) fn holding(&self, names: &[usize]) -> impl Iterator<Item = Tet> {
        // A tet has names of all three vertices of its prism.
        let ids: Vec<usize> = names.iter().map(|n| n / 3).collect();
        let tets = self.world.shell.holding(ids).flat_map(|prism| self.of(prism));
        tets.filter(move |tet| names.iter().all(|n| tet.names.contains(n)))
    }
}
