//! The signs of the determinants of cells that fill their space.

use rayon::prelude::*;

use super::facets::Facets;
use super::points::Point;
use super::witness::Witness;
use crate::predicate::{Axis, Sign};

/// How many cells have which sign.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct SignCounts {
    /// Determinant greater than zero.
    pub positive: u64,
    /// Exactly zero.
    pub zero: u64,
    /// Less than zero.
    pub negative: u64,
}

/// The sign of every cell's determinant.
pub(super) fn of_cells<P: Point>(facets: &Facets<'_>, points: &[P]) -> Vec<Sign> {
    let at = |v: u32| &points[v as usize];
    let sign = |c: u32| match *facets.cells.cell(c as usize) {
        [a, b, c] => P::orient2d(at(a), at(b), at(c), Axis::Z),
        [a, b, c, d] => P::orient3d(at(a), at(b), at(c), at(d)),
        _ => Sign::Zero,
    };
    (0..facets.cells.len() as u32).into_par_iter().map(sign).collect()
}

pub(super) fn count(signs: &[Sign]) -> SignCounts {
    let of = |sign: Sign| signs.iter().filter(|&&s| s == sign).count() as u64;
    SignCounts { positive: of(Sign::Positive), zero: of(Sign::Zero), negative: of(Sign::Negative) }
}

/// For every cell that has not the strict sign of the first cell of its component: a witness, at most `limit`.
pub(super) fn witnesses(signs: &[Sign], components: &[u32], limit: usize) -> Vec<Witness> {
    let mut majority = vec![0_i64; signs.len()];
    for (sign, root) in signs.iter().zip(components) {
        majority[*root as usize] += i64::from(sign.as_i8());
    }
    let ordinary = |root: u32| if majority[root as usize] < 0 { Sign::Negative } else { Sign::Positive };
    // One cell of the more frequent sign for each component, to hold the others against.
    let mut example: Vec<Option<u32>> = vec![None; signs.len()];
    for (cell, (sign, &root)) in signs.iter().zip(components).enumerate() {
        if *sign == ordinary(root) {
            example[root as usize].get_or_insert(cell as u32);
        }
    }
    let odd = (0..signs.len() as u32).filter(|&c| signs[c as usize] != ordinary(components[c as usize]));
    odd.filter_map(|c| match signs[c as usize] {
        Sign::Zero => Some(Witness::Sign([c, c])),
        _ => example[components[c as usize] as usize].map(|e| Witness::Sign([c.min(e), c.max(e)])),
    })
    .take(limit)
    .collect()
}
