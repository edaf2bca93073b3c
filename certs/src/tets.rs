//! The tets of a prism, and the set that a vertex order selects (FORMAT section 1).

use crate::line::Tet as Names;
use crate::number::Num;
use crate::world::World;

/// A tet of a prism's slab.
#[derive(Clone, Copy)]
pub(crate) struct Tet {
    pub(crate) names: Names,
    /// Whether the ascending names have the opposite of the tet's orientation.
    odd: bool,
    /// The names at the lower and the upper end of the pillar half that it carries.
    pub(crate) pillar: (usize, usize),
}

/// The orders of three corners, and whether each is an even permutation.
const ORDERS: [([usize; 3], bool); 6] = [
    ([0, 1, 2], true),
    ([1, 2, 0], true),
    ([2, 0, 1], true),
    ([0, 2, 1], false),
    ([2, 1, 0], false),
    ([1, 0, 2], false),
];

/// A prism's tets in an order; for a pinched corner `lo` and `hi` are both its name `m`.
fn of_order(pinched: &[bool], prism: [usize; 3], (order, even): ([usize; 3], bool)) -> Vec<Tet> {
    let [u, v, w] = order.map(|i| prism[i]);
    let mut tets = Vec::new();
    for slab in 0..2 {
        let lo = |x: usize| if pinched[x] { 3 * x + 1 } else { 3 * x + slab };
        let hi = |x: usize| if pinched[x] { 3 * x + 1 } else { 3 * x + slab + 1 };
        let listed = [
            (w, [lo(u), lo(v), lo(w), hi(w)], even),
            (v, [lo(u), lo(v), hi(v), hi(w)], !even),
            (u, [lo(u), hi(u), hi(v), hi(w)], even),
        ];
        for (carried, mut names, positive) in listed.into_iter().filter(|t| !pinched[t.0]) {
            let inversions =
                (0..4).flat_map(|j| (0..j).map(move |i| (i, j))).filter(|&(i, j)| names[i] > names[j]);
            let odd = positive == (inversions.count() % 2 == 1);
            names.sort_unstable();
            tets.push(Tet { names, odd, pillar: (lo(carried), hi(carried)) });
        }
    }
    tets
}

/// The different ones of a prism's 24 tets, by ascending names.
pub(crate) fn all(pinched: &[bool], prism: [usize; 3]) -> Vec<Tet> {
    let mut tets: Vec<Tet> = ORDERS.iter().flat_map(|&order| of_order(pinched, prism, order)).collect();
    tets.sort_unstable_by_key(|t| t.names);
    tets.dedup_by_key(|t| t.names);
    tets
}

impl Tet {
    /// The determinant with the tet's orientation.
    pub(crate) fn det<N: Num>(&self, world: &World<N>) -> N {
        let [a, b, c, d] = self.names;
        if self.odd { world.orient(a, c, b, d) } else { world.orient(a, b, c, d) }
    }
}

/// `S_<`: the tets that a vertex order selects.
pub(crate) struct Selected {
    /// Tet, prism, whether its determinant is positive.
    pub(crate) tets: Vec<(Tet, usize, bool)>,
    /// The range of each prism's tets: `first[p] .. first[p + 1]`.
    first: Vec<usize>,
    /// The tets that hold each name.
    star: Vec<Vec<usize>>,
}

impl Selected {
    /// `rank[v]` is the place of vertex `v` in the order.
    pub(crate) fn new<N: Num>(world: &World<N>, rank: &[usize]) -> Self {
        let (mut tets, mut first, mut star) = (Vec::new(), vec![0], vec![Vec::new(); 3 * rank.len()]);
        for (p, &prism) in world.shell.triangles.iter().enumerate() {
            let ascending = |o: &&([usize; 3], bool)| o.0.is_sorted_by_key(|i| rank[prism[*i]]);
            for tet in ORDERS.iter().find(ascending).iter().flat_map(|&&o| of_order(&world.pinched, prism, o))
            {
                tet.names.iter().for_each(|&name| star[name].push(tets.len()));
                tets.push((tet, p, tet.det(world).sgn() > 0));
            }
            first.push(tets.len());
        }
        Self { tets, first, star }
    }

    /// The tets that hold all the names, by looking at the name with the fewest tets.
    pub(crate) fn holding<'a>(&'a self, names: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        let short =
            names.iter().map(|&n| self.star[n].as_slice()).min_by_key(|star| star.len()).unwrap_or(&[]);
        short.iter().copied().filter(|&t| names.iter().all(|n| self.tets[t].0.names.contains(n)))
    }

    /// The index of the tet with these names.
    pub(crate) fn find(&self, names: &Names) -> Option<usize> {
        self.holding(names).next()
    }

    /// Whether some tet of the prism holds all the names.
    pub(crate) fn in_prism(&self, prism: usize, names: &[usize]) -> bool {
        let range = self.first[prism]..self.first[prism + 1];
        self.tets[range].iter().any(|(t, _, _)| names.iter().all(|n| t.names.contains(n)))
    }
}
