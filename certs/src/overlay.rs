//! `section` and `bijection` certified: the overlay (FORMAT section 3.2, rule R2 of THEORY).

use crate::complex::sides;
use crate::number::{Vec3, cross, dot, sgn};
use crate::shard::{Source, fans, triangles};
use crate::{Fail, Res, Set, all, complex::distinct, each, orders, part};
use num_bigint::BigInt;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// The edges of `K` without their reverse: a `v` line, the vertex ids of the ends' names, the names.
type Rim = (usize, Vec<usize>, Vec<usize>);

/// A checked overlay. It is not kept: cells are made from the certificate's lines, a shard at a time.
pub(crate) struct Overlay<'a> {
    source: Source<'a>,
    pub(crate) boundary: Vec<Rim>,
    /// The first cell that is against `section-all-orders`, if that was asked for.
    pub(crate) against: Option<Fail>,
}

/// What is known of all cells when each has been checked.
struct Tally {
    /// The `v` lines that are corners of cells.
    used: Vec<AtomicBool>,
    /// How many directed edges there are, and whether one is in a cap.
    edges: AtomicUsize,
    caps: AtomicBool,
    /// Whether cells are asked about all orders, too, and the first one that fails.
    all_orders: bool,
    against: Mutex<Option<(usize, Fail)>>,
}

/// As many edges are compared in one pass.
const EDGES: usize = if cfg!(test) { 8 } else { 1 << 23 };

/// As many `v` lines or edges are read together.
const FEW: usize = 64;

/// An edge between two corners, the smaller one first, and its direction.
type Edge = (u32, u32);

impl<'a> Overlay<'a> {
    /// With `all_orders`, the cells' part of FORMAT section 3.3 is decided on the way.
    pub(crate) fn check(source: Source<'a>, all_orders: bool) -> Res<Self> {
        ensure!(source.selected.positive(), "not-positive", "a tet of the order");
        let mut overlay = Self { source, boundary: Vec::new(), against: None };
        let count = source.facts.corners.len();
        let used = (0..count).map(|_| AtomicBool::new(false)).collect();
        let (edges, caps, against) = Default::default();
        let tally = Tally { used, edges, caps, all_orders, against };
        let cells = overlay.check_cells(&tally);
        let all_used = tally.used.iter().all(|used| used.load(Relaxed));
        // A line in some cell has been checked there. Its error comes before all others, in the order of the lines.
        if cells.is_err() || !all_used {
            each(count.div_ceil(FEW), |at| source.corners(part(count, FEW, at).collect())?.all().map(drop))?;
        }
        let beside = cells?;
        overlay.boundary = overlay.check_edges(&tally)?;
        ensure!(all_used, "isolated", "a `v` line is in no cell");
        overlay.check_degree(&beside)?;
        let against = tally.against.into_inner().unwrap_or_else(PoisonError::into_inner);
        overlay.against = against.map(|(_, fail)| fail);
        Ok(overlay)
    }

    /// Checks every cell and the `v` lines at its corners. Those in a triangle or a prism that has a cell of a `d` line: the
    /// side, the triangle or prism, the cell; ascending.
    fn check_cells(&self, tally: &Tally) -> Res<Vec<(usize, usize, usize)>> {
        // If one of them has no home, its error is found below.
        let named = [self.named(0)?, self.named(1)?];
        let named = named.map(|named| named.into_iter().flatten().collect::<Set<usize>>());
        let beside = all(self.source.shards(), |at| {
            let (shard, mut beside) = (self.source.cells(self.source.numbers(at))?, Vec::new());
            let corners = shard.all()?;
            shard.corners.iter().for_each(|&x| tally.used[x].store(true, Relaxed));
            for (i, &number) in shard.numbers.iter().enumerate() {
                let cell = shard.cell(i)?;
                shard.check(&cell, &corners)?;
                let edges = || fans(&cell.corners).flat_map(sides);
                tally.edges.fetch_add(edges().count(), Relaxed);
                if edges().any(|edge| shard.in_cap(edge)) {
                    tally.caps.store(true, Relaxed);
                }
                let fans = || triangles(&cell, &corners, 0);
                if tally.all_orders
                    && let Err(fail) = orders::check_cell(self.source.world, &cell, fans)
                {
                    tally.fails(number, fail);
                }
                let sides = [0, 1].into_iter().filter(|&side| named[side].contains(&cell.home[side]));
                beside.extend(sides.map(|side| (side, cell.home[side], number)));
            }
            Ok(beside)
        })?;
        let mut beside = beside.concat();
        beside.sort_unstable();
        Ok(beside)
    }

    /// The triangles or prisms of the cells in the `d` lines; none for one that fails.
    fn named(&self, side: usize) -> Res<Vec<Option<usize>>> {
        let cells = || self.source.facts.degree[side].iter().map(|line| line.1);
        let shard = self.source.cells(distinct(cells()))?;
        let homes: Vec<_> =
            (0..shard.len()).map(|i| shard.cell(i).ok().map(|cell| cell.home[side])).collect();
        let place = |cell: usize| shard.numbers.binary_search(&cell).ok();
        Ok(cells().map(|cell| homes[place(cell)?]).collect())
    }

    /// Edges of a cell as they are compared.
    fn edges(corners: &[usize]) -> impl Iterator<Item = Edge> {
        let edge = |(a, b): (usize, usize)| (a.min(b) as u32, 2 * a.max(b) as u32 + u32::from(a > b));
        fans(corners).flat_map(sides).map(edge)
    }

    fn check_edges(&self, tally: &Tally) -> Res<Vec<Rim>> {
        let (count, caps) = (tally.edges.load(Relaxed), tally.caps.load(Relaxed));
        let passes = count.div_ceil(EDGES).max(1);
        let (mut twice, mut open) = (Set::default(), Vec::new());
        for pass in 0..passes {
            let edges = self.edges_of(pass, passes, count)?;
            for same in edges.chunk_by(|x, y| (x.0, x.1 / 2) == (y.0, y.1 / 2)) {
                twice.extend(same.windows(2).filter(|w| w[0] == w[1]).map(|w| w[0]));
                ensure!(caps || twice.is_empty(), "edge-twice", "corners {} {}", same[0].0, same[0].1 / 2);
                open.extend((same.len() == 1).then_some(same[0]));
            }
        }
        if caps {
            return Err(self.first_bad(&twice));
        }
        let parts = all(open.len().div_ceil(FEW), |at| self.rim(&open[part(open.len(), FEW, at)]))?;
        Ok(parts.into_iter().flatten().collect())
    }

    /// The edges of one of the passes, in ascending order; of all there are `count`. An edge and its reverse are in the
    /// same pass.
    fn edges_of(&self, pass: usize, passes: usize, count: usize) -> Res<Vec<Edge>> {
        // A little more than its share: to grow a list takes twice its memory.
        let found = Mutex::new(Vec::with_capacity(count / passes + count / passes / 16));
        // The corners take turns: cells that follow each other have corners that do.
        let mine = |edge: &Edge| edge.0 as usize % passes == pass;
        each(self.source.shards(), |at| {
            let cells = self.source.facts.cells.cells(&self.source.numbers(at))?;
            let edges: Vec<Edge> =
                (0..cells.len()).flat_map(|i| Self::edges(cells.of(i))).filter(mine).collect();
            found.lock().unwrap_or_else(PoisonError::into_inner).extend(edges);
            Ok(())
        })?;
        let mut edges = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        edges.par_sort_unstable();
        Ok(edges)
    }

    /// The error of the first edge that is in a cap, or is one of those that occur twice and has occurred.
    fn first_bad(&self, twice: &Set<Edge>) -> Fail {
        let mut seen = Set::default();
        let mut search = |at: usize| {
            let shard = self.source.cells(self.source.numbers(at))?;
            for i in 0..shard.len() {
                let line = self.source.facts.cells.number(shard.numbers[i]);
                for edge in Self::edges(shard.cells.of(i)) {
                    ensure!(!twice.contains(&edge) || seen.insert(edge), "edge-twice", "line {line}");
                    let ends = (shard.place(edge.0 as usize)?, shard.place(edge.1 as usize / 2)?);
                    ensure!(!shard.in_cap(ends), "cap", "line {line}: an edge");
                }
            }
            Ok(())
        };
        (0..self.source.shards()).find_map(|at| search(at).err()).unwrap_or_else(|| bad!("cap", "an edge"))
    }

    /// What is asked of edges without their reverse, but for section 3.3.
    fn rim(&self, open: &[Edge]) -> Res<Vec<Rim>> {
        let ends = open.iter().map(|edge| [edge.0 as usize, edge.1 as usize / 2]);
        let shard = self.source.corners(distinct(ends.clone().flatten()))?;
        let rim = |[a, b]: [usize; 2]| {
            let (a_at, b_at) = (shard.place(a)?, shard.place(b)?);
            let [on_mesh, names] =
                [0, 1].map(|side| [shard.carriers[side].of(a_at), shard.carriers[side].of(b_at)].concat());
            let ids = distinct(names.iter().map(|n| n / 3));
            let on_both = self.source.world.mesh.on_boundary(on_mesh)
                && self.source.world.shell.on_boundary(ids.iter().copied());
            let line = self.source.facts.corners.number(a);
            ensure!(on_both, "boundary", "line {line}: the edge from here to corner {b}");
            Ok((line, ids, names))
        };
        ends.map(rim).collect()
    }

    fn check_degree(&self, beside: &[(usize, usize, usize)]) -> Res {
        let mut homes = Vec::new();
        for side in [0, 1] {
            let complex = [&self.source.world.mesh, &self.source.world.shell][side];
            homes.push(self.named(side)?);
            let parts = homes[side].iter().map(|home| home.map(|home| complex.part(home)));
            let each_once = parts.eq((0..complex.parts()).map(Some));
            ensure!(each_once, "degree-component", "not one `d` line a component");
        }
        for side in [0, 1] {
            for (line, home) in self.source.facts.degree[side].iter().zip(&homes[side]) {
                let place = |home: usize| beside.partition_point(|x| (x.0, x.1) < (side, home));
                let cells = &beside[home.map_or(0..0, |home| place(home)..place(home + 1))];
                let cells: Vec<usize> = cells.iter().map(|x| x.2).collect();
                self.covered_once(side, *line, &cells)?;
            }
        }
        Ok(())
    }

    /// Whether the middle of a named fan triangle lies in no other one of these cells, which are all in its triangle or prism.
    fn covered_once(&self, side: usize, named: (usize, usize, usize), cells: &[usize]) -> Res {
        let (line, named, fan) = named;
        let own = self.rows(side, &[named])?.into_iter().find(|x| (x.0, x.1) == (named, fan));
        let own = own.filter(|_| cells.contains(&named)).ok_or_else(|| bad!("degree", "line {line}"))?.2;
        let [a, b, c] = own.each_ref().map(|row| row.iter().sum::<BigInt>());
        let scales = [&b * &c, &a * &c, &a * &b];
        let centre: Vec3 = std::array::from_fn(|i| (0..3).map(|j| &own[j][i] * &scales[j]).sum());
        // A prism may have many cells.
        let size = self.source.size();
        each(cells.len().div_ceil(size), |at| {
            for (other, k, [a, b, c]) in self.rows(side, &cells[part(cells.len(), size, at)])? {
                let sides = [(&a, &b), (&b, &c), (&c, &a)];
                let holds = sides.iter().all(|(x, y)| sgn(&dot(&cross(x, y), &centre)) >= 0);
                let itself = (other, k) == (named, fan);
                ensure!(itself || !holds, "degree", "line {line}: also in cell {other}");
            }
            Ok(())
        })
    }

    /// The fan triangles of these cells, ascending: the cell, which of its triangles, the coordinates.
    fn rows(&self, side: usize, cells: &[usize]) -> Res<Vec<(usize, usize, [Vec3; 3])>> {
        let shard = self.source.cells(cells.to_vec())?;
        let (corners, mut rows) = (shard.all()?, Vec::new());
        for (i, &cell) in shard.numbers.iter().enumerate() {
            let fans = triangles(&shard.cell(i)?, &corners, side);
            rows.extend(fans.into_iter().enumerate().map(|(k, fan)| (cell, k, fan)));
        }
        Ok(rows)
    }
}

impl Tally {
    fn fails(&self, cell: usize, fail: Fail) {
        let mut first = self.against.lock().unwrap_or_else(PoisonError::into_inner);
        if first.as_ref().is_none_or(|(earlier, _)| cell < *earlier) {
            *first = Some((cell, fail));
        }
    }
}
