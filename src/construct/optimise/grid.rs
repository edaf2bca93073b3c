//! A set of boxes that changes, queried by box. Comparisons and monotone functions of stored coordinates decide: exact.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::tree::Box3;

type Cell = [i64; 3];

/// Things with boxes, in grids of cells of side `2^k`: each in the grid whose cells are about as large as its box, in all
/// (few) cells that the box meets.
#[derive(Clone, Debug)]
pub(crate) struct Grid<T> {
    levels: BTreeMap<i32, FxHashMap<Cell, Vec<(Box3, T)>>>,
}

impl<T> Default for Grid<T> {
    fn default() -> Self {
        Self { levels: BTreeMap::new() }
    }
}

/// The exponent of a power of two above the largest side of a box; the cast of an infinite one is as good as any.
fn level(bounds: &Box3) -> i32 {
    let extent = bounds.sides().into_iter().fold(0.0, f64::max);
    // At most 11 bits are left.
    i32::try_from(extent.to_bits() >> 52 & 0x7ff).unwrap_or(0) - 1022
}

/// The cells that hold the box's least and greatest corner. Monotone in every coordinate, whatever is rounded, also
/// where the factor is zero or the product not finite: boxes that meet have a common cell.
fn range(level: i32, bounds: &Box3) -> [Cell; 2] {
    let factor = 2f64.powi(-level);
    bounds.ends().map(|p| p.map(|x| (x * factor).floor() as i64))
}

/// All cells from the least to the greatest one.
fn cells([low, high]: [Cell; 2]) -> impl Iterator<Item = Cell> {
    let axis = move |i: usize| low[i]..=high[i];
    axis(0).flat_map(move |x| axis(1).flat_map(move |y| axis(2).map(move |z| [x, y, z])))
}

impl<T: Copy + PartialEq> Grid<T> {
    pub(crate) fn insert(&mut self, bounds: Box3, item: T) {
        let level = level(&bounds);
        let grid = self.levels.entry(level).or_default();
        for cell in cells(range(level, &bounds)) {
            grid.entry(cell).or_default().push((bounds, item));
        }
    }

    /// Takes out what was inserted with the same box.
    pub(crate) fn remove(&mut self, bounds: Box3, item: T) {
        let level = level(&bounds);
        let Some(grid) = self.levels.get_mut(&level) else { return };
        for cell in cells(range(level, &bounds)) {
            if let Some(list) = grid.get_mut(&cell) {
                list.retain(|(_, other)| *other != item);
                if list.is_empty() {
                    grid.remove(&cell);
                }
            }
        }
        if grid.is_empty() {
            self.levels.remove(&level);
        }
    }

    /// How often things stand in cells.
    #[cfg(test)]
    pub(crate) fn len(&self) -> usize {
        self.levels.values().flat_map(FxHashMap::values).map(Vec::len).sum()
    }

    /// Does `holds` answer `true` for everything whose box meets the box? Each is asked about once.
    pub(crate) fn all(&self, wanted: &Box3, mut holds: impl FnMut(&T) -> bool) -> bool {
        self.levels.iter().all(|(&level, grid)| {
            let ends @ [low, high] = range(level, wanted);
            // In the first common cell only.
            let first = |cell: Cell, bounds: &Box3| {
                let [own, _] = range(level, bounds);
                (0..3).all(|i| cell[i] == own[i].max(low[i]))
            };
            let mut visit = |cell: Cell, list: &[(Box3, T)]| {
                list.iter().all(|(b, item)| !(b.meets(wanted) && first(cell, b)) || holds(item))
            };
            let many = (0..3).map(|i| high[i] as f64 - low[i] as f64 + 1.0).product::<f64>();
            if many > grid.len() as f64 {
                let within = |cell: &Cell| (0..3).all(|i| low[i] <= cell[i] && cell[i] <= high[i]);
                grid.iter().filter(|(cell, _)| within(cell)).all(|(cell, list)| visit(*cell, list))
            } else {
                cells(ends).all(|cell| grid.get(&cell).is_none_or(|list| visit(cell, list)))
            }
        })
    }
}
