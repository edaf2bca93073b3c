//! The tets of a shell, from the text of THEORY section 1: for all six orders of every prism.

use std::collections::BTreeMap;

use homeo::shell::Shell;

use super::exact::{Point, orient, positive};
use dashu_int::IBig;

/// A point of the shell: `3 v + layer`, layers bottom, middle, top; of a pinched vertex only `3 v + 1`.
pub type Code = u32;

/// The six orders of three corners.
pub const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// A tet.
#[derive(Clone, Debug)]
pub struct Tet {
    /// Its prism.
    pub prism: usize,
    /// Its names, so that it is positive in the straight unit prism.
    pub names: [Code; 4],
    /// Lower and upper end of the pillar half that it carries.
    pub field: [Code; 2],
}

/// All tets of all orders, and which of them an order selects in a prism.
#[derive(Debug)]
pub struct Tets {
    /// The different ones.
    pub all: Vec<Tet>,
    /// `selected[prism][k]`: those of the order [`ORDERS`]`[k]`.
    pub selected: Vec<[Vec<usize>; 6]>,
}

/// A name before pinched vertices are merged: corner of the prism, upper end or not.
type Local = (usize, bool);

fn reference(slab: u32, (corner, hi): Local) -> Point {
    let z = i64::from(slab) + i64::from(hi);
    [i64::from(corner == 1), i64::from(corner == 2), z].map(IBig::from)
}

/// Tets by names.
#[must_use]
pub fn tets(shell: &Shell, pinched: &[bool]) -> Tets {
    let mut out = Tets { all: Vec::new(), selected: Vec::new() };
    let mut known: BTreeMap<(usize, Vec<Code>), usize> = BTreeMap::new();
    for (prism, corners) in shell.faces.iter().enumerate() {
        let mut selected: [Vec<usize>; 6] = Default::default();
        for (k, [u, v, w]) in ORDERS.into_iter().enumerate() {
            for slab in 0..2u32 {
                let of_order: [([Local; 4], usize); 3] = [
                    ([(u, false), (v, false), (w, false), (w, true)], w),
                    ([(u, false), (v, false), (v, true), (w, true)], v),
                    ([(u, false), (u, true), (v, true), (w, true)], u),
                ];
                for (mut local, pillar) in of_order {
                    if pinched[corners[pillar] as usize] {
                        continue;
                    }
                    let [a, b, c, d] = local.map(|l| reference(slab, l));
                    if !positive(&orient(&a, &b, &c, &d)) {
                        local.swap(0, 1);
                    }
                    let code = |(corner, hi): Local| {
                        let v = corners[corner];
                        3 * v + if pinched[v as usize] { 1 } else { slab + u32::from(hi) }
                    };
                    let names = local.map(code);
                    let mut key = names.to_vec();
                    key.sort_unstable();
                    let field = [code((pillar, false)), code((pillar, true))];
                    let id = *known.entry((prism, key)).or_insert_with(|| {
                        out.all.push(Tet { prism, names, field });
                        out.all.len() - 1
                    });
                    selected[k].push(id);
                }
            }
        }
        out.selected.push(selected);
    }
    out
}
