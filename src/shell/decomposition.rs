//! The six decompositions of a slab and the 12 tets that they use (THEORY section 1).
//!
//! Corners are local: corner `k` of a prism is `faces[prism][k]`, so 0, 1, 2 run counter-clockwise
//! when seen from the top. A side face's diagonal runs from the `lo` of the smaller corner to the
//! `hi` of the larger one.

/// A vertex of a slab: its corner (0, 1, 2), and whether it lies in the slab's upper layer.
pub type LocalVertex = (u8, bool);

/// One of the 12 tets of a slab.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LocalTet {
    /// The four vertices, ordered so that `det[p1-p0, p2-p0, p3-p0]` is positive in the straight
    /// unit prism.
    pub vertices: [LocalVertex; 4],
    /// The corner whose pillar (both `lo` and `hi`) is an edge of the tet.
    pub pillar: u8,
    /// The decompositions that use this tet: bit `k` is set for `ORDERS[k]`.
    pub orders: u8,
}

/// The six orders of the corners, smallest corner first, lexicographically.
pub const ORDERS: [[u8; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

const fn tet(vertices: [LocalVertex; 4], pillar: u8, orders: u8) -> LocalTet {
    LocalTet { vertices, pillar, orders }
}

const LO: bool = false;
const HI: bool = true;

/// The 12 tets of a slab.
///
/// * `TETS[w]`, `w = 0, 1, 2`: `(lo lo lo hi_w)`, for the two orders with largest corner `w`;
/// * `TETS[3 + u]`: `(lo_u hi hi hi)`, for the two orders with smallest corner `u`;
/// * `TETS[6 + k]`: `(lo_u lo_v hi_v hi_w)`, for `ORDERS[k] = [u, v, w]` alone.
pub const TETS: [LocalTet; 12] = [
    tet([(0, LO), (1, LO), (2, LO), (0, HI)], 0, 0b10_1000),
    tet([(0, LO), (1, LO), (2, LO), (1, HI)], 1, 0b01_0010),
    tet([(0, LO), (1, LO), (2, LO), (2, HI)], 2, 0b00_0101),
    tet([(0, LO), (0, HI), (1, HI), (2, HI)], 0, 0b00_0011),
    tet([(1, LO), (0, HI), (1, HI), (2, HI)], 1, 0b00_1100),
    tet([(2, LO), (0, HI), (1, HI), (2, HI)], 2, 0b11_0000),
    tet([(0, LO), (1, LO), (2, HI), (1, HI)], 1, 0b00_0001),
    tet([(0, LO), (2, LO), (2, HI), (1, HI)], 2, 0b00_0010),
    tet([(1, LO), (0, LO), (0, HI), (2, HI)], 0, 0b00_0100),
    tet([(1, LO), (2, LO), (0, HI), (2, HI)], 2, 0b00_1000),
    tet([(2, LO), (0, LO), (1, HI), (0, HI)], 0, 0b01_0000),
    tet([(2, LO), (1, LO), (1, HI), (0, HI)], 1, 0b10_0000),
];

/// The index in [`ORDERS`] of `order`; `None` unless it is a permutation of 0, 1, 2.
#[must_use]
pub fn order_index(order: [u8; 3]) -> Option<usize> {
    ORDERS.iter().position(|&o| o == order)
}

/// The order of the corners (smallest first) in which their ranks ascend. Equal ranks are taken
/// in corner order.
#[must_use]
pub fn order_of_ranks(ranks: [u32; 3]) -> [u8; 3] {
    let mut order = [0_u8, 1, 2];
    order.sort_by_key(|&corner| ranks[usize::from(corner)]);
    order
}

/// The three tets of `ORDERS[index]` as indices into [`TETS`], from the lowest tet to the highest:
/// they carry the pillars of the order's last, middle and first corner.
#[must_use]
pub const fn decomposition_of_index(index: usize) -> Option<[usize; 3]> {
    if index >= ORDERS.len() {
        return None;
    }
    let [smallest, _, largest] = ORDERS[index];
    Some([largest as usize, 6 + index, 3 + smallest as usize])
}

/// As [`decomposition_of_index`], for an order given by its corners, smallest first.
///
/// # Panics
/// Unless `order` is a permutation of 0, 1, 2: it names one of the const [`ORDERS`].
#[must_use]
#[allow(clippy::panic)] // A programming error: an order never comes from a file.
pub fn decomposition(order: [u8; 3]) -> [usize; 3] {
    match order_index(order).and_then(decomposition_of_index) {
        Some(tets) => tets,
        None => panic!("{order:?} is not an order of the corners 0, 1, 2"),
    }
}
