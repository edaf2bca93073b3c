//! `section` and `bijection` certified: the overlay (FORMAT section 3.2, rule R2 of THEORY).

use crate::complex::{distinct, sides};
use crate::number::{Vec3, cross, det, dot, leading, sgn, sign_near};
use crate::pages::Rows;
use crate::parse::Overlay as Facts;
use crate::tets::Selected;
use crate::world::World;
use crate::{Fail, Res, Set, all, each, orders};
use num_bigint::BigInt;
use rayon::prelude::*;
use std::iter::Sum;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// Barycentric coordinates times a positive number: of which vertices (at most four), leading bits, exactly.
struct Weights {
    ids: [usize; 4],
    near: [i128; 4],
    exact: Vec<BigInt>,
}

/// A vertex of `K`: its coordinates on the vertices of the mesh, and on those of the shell, where names of one vertex each
/// have their own weight.
type Corner = [Weights; 2];

/// A cell: its line, its corners' places in the shard, the triangle of `T` and the prism, and the corners of both.
pub(crate) struct Cell {
    pub(crate) line: usize,
    corners: Vec<usize>,
    pub(crate) home: [usize; 2],
    within: [[usize; 3]; 2],
}

/// The edges of `K` without their reverse: a `v` line, the vertex ids of the ends' names, the names.
type Rim = (usize, Vec<usize>, Vec<usize>);

/// A checked overlay. It is not kept: cells are made from the certificate's lines, a shard at a time.
pub(crate) struct Overlay<'a> {
    world: &'a World,
    selected: &'a Selected<'a>,
    facts: &'a Facts<'a>,
    pub(crate) boundary: Vec<Rim>,
    /// The first cell that is against `section-all-orders`, if that was asked for.
    pub(crate) against: Option<Fail>,
}

/// Cells that follow each other, and the `v` lines at their corners.
pub(crate) struct Shard<'a> {
    overlay: &'a Overlay<'a>,
    first: usize,
    cells: Rows,
    /// The numbers of the `v` lines, ascending; their mesh vertices and names.
    corners: Vec<usize>,
    carriers: [Rows; 2],
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
const EDGES: usize = 1 << 24;

/// An edge between two corners, the smaller one first, and its direction.
type Edge = (u32, u32);

impl<'a> Overlay<'a> {
    /// With `all_orders`, the cells' part of FORMAT section 3.3 is decided on the way.
    pub(crate) fn check(
        world: &'a World,
        selected: &'a Selected<'a>,
        facts: &'a Facts<'a>,
        all_orders: bool,
    ) -> Res<Self> {
        ensure!(selected.positive(), "not-positive", "a tet of the order");
        let mut overlay = Self { world, selected, facts, boundary: Vec::new(), against: None };
        let used = (0..facts.corners.len()).map(|_| AtomicBool::new(false)).collect();
        let (edges, caps, against) = Default::default();
        let tally = Tally { used, edges, caps, all_orders, against };
        let cells = overlay.check_cells(&tally);
        let all_used = tally.used.iter().all(|used| used.load(Relaxed));
        // A line in some cell has been checked there. Its error comes before all others, in the order of the lines.
        if cells.is_err() || !all_used {
            let page = |at: usize| at * 64..facts.corners.len().min((at + 1) * 64);
            each(facts.corners.len().div_ceil(64), |at| {
                overlay.corners(page(at).collect())?.all().map(drop)
            })?;
        }
        let beside = cells?;
        overlay.boundary = overlay.check_edges(&tally)?;
        ensure!(all_used, "isolated", "a `v` line is in no cell");
        overlay.check_degree(beside)?;
        let against = tally.against.into_inner().unwrap_or_else(PoisonError::into_inner);
        overlay.against = against.map(|(_, fail)| fail);
        Ok(overlay)
    }

    /// How many shards the cells are in.
    pub(crate) fn shards(&self) -> usize {
        self.facts.cells.len().div_ceil(self.size())
    }

    fn size(&self) -> usize {
        (self.facts.cells.len() / (8 * rayon::current_num_threads())).clamp(64, 1 << 15)
    }

    fn range(&self, shard: usize) -> Range<usize> {
        shard * self.size()..self.facts.cells.len().min((shard + 1) * self.size())
    }

    pub(crate) fn shard(&self, shard: usize) -> Res<Shard<'_>> {
        self.part(self.range(shard))
    }

    fn part(&self, cells: Range<usize>) -> Res<Shard<'_>> {
        let (first, cells) = (cells.start, self.facts.cells.cells(cells)?);
        let shard = self.corners(distinct(cells.items().iter().copied()))?;
        Ok(Shard { first, cells, ..shard })
    }

    /// These `v` lines, ascending, without cells.
    fn corners(&self, corners: Vec<usize>) -> Res<Shard<'_>> {
        let carriers = self.facts.corners.carriers(&corners)?;
        Ok(Shard { overlay: self, first: 0, cells: Rows::default(), corners, carriers })
    }

    /// Checks every cell and the `v` lines at its corners. Those in a triangle or a prism that has a cell of a `d` line: the
    /// side, the triangle or prism, the cell; ascending.
    fn check_cells(&self, tally: &Tally) -> Res<Vec<(usize, usize, usize)>> {
        let home = |d: &(usize, usize, usize)| Some(self.part(d.1..d.1 + 1).ok()?.cell(0).ok()?.home);
        let named = self.facts.degree.each_ref().map(|lines| lines.iter().filter_map(home));
        let [first, second] = named;
        let named: [Set<usize>; 2] = [first.map(|h| h[0]).collect(), second.map(|h| h[1]).collect()];
        let beside = all(self.shards(), |at| {
            let (shard, mut beside) = (self.shard(at)?, Vec::new());
            let corners = shard.all()?;
            shard.corners.iter().for_each(|&x| tally.used[x].store(true, Relaxed));
            for i in 0..shard.len() {
                let cell = shard.cell(i)?;
                shard.check(&cell, &corners)?;
                let edges = || fans(&cell.corners).flat_map(sides);
                tally.edges.fetch_add(edges().count(), Relaxed);
                if edges().any(|edge| shard.in_cap(edge)) {
                    tally.caps.store(true, Relaxed);
                }
                let fans = || triangles(&cell, |at| corners[at][0].row_of(cell.within[0]));
                if tally.all_orders
                    && let Err(fail) = orders::check_cell(self.world, &cell, fans)
                {
                    tally.fails(shard.first + i, fail);
                }
                let sides = [0, 1].into_iter().filter(|&side| named[side].contains(&cell.home[side]));
                beside.extend(sides.map(|side| (side, cell.home[side], shard.first + i)));
            }
            Ok(beside)
        })?;
        let mut beside = beside.concat();
        beside.sort_unstable();
        Ok(beside)
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
            let edges = self.edges_of(pass, passes)?;
            for same in edges.chunk_by(|x, y| (x.0, x.1 / 2) == (y.0, y.1 / 2)) {
                twice.extend(same.windows(2).filter(|w| w[0] == w[1]).map(|w| w[0]));
                ensure!(caps || twice.is_empty(), "edge-twice", "corners {} {}", same[0].0, same[0].1 / 2);
                open.extend((same.len() == 1).then_some(same[0]));
            }
        }
        if caps {
            return Err(self.first_bad(&twice));
        }
        let parts =
            all(open.len().div_ceil(64), |at| self.rim(&open[at * 64..open.len().min((at + 1) * 64)]))?;
        Ok(parts.into_iter().flatten().collect())
    }

    /// The edges of one of the passes, in ascending order. An edge and its reverse are in the same one.
    fn edges_of(&self, pass: usize, passes: usize) -> Res<Vec<Edge>> {
        let found = Mutex::new(Vec::new());
        // The corners take turns: cells that follow each other have corners that do.
        let mine = |edge: &Edge| edge.0 as usize % passes == pass;
        each(self.shards(), |at| {
            let cells = self.facts.cells.cells(self.range(at))?;
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
            let shard = self.shard(at)?;
            for i in 0..shard.len() {
                let line = self.facts.cells.number(shard.first + i);
                for edge in Self::edges(shard.cells.of(i)) {
                    ensure!(!twice.contains(&edge) || seen.insert(edge), "edge-twice", "line {line}");
                    let ends = [edge.0, edge.1 / 2].map(|x| shard.place(x as usize));
                    ensure!(!shard.in_cap((ends[0], ends[1])), "cap", "line {line}: an edge");
                }
            }
            Ok(())
        };
        (0..self.shards()).find_map(|at| search(at).err()).unwrap_or_else(|| bad!("cap", "an edge"))
    }

    /// What is asked of edges without their reverse, but for section 3.3.
    fn rim(&self, open: &[Edge]) -> Res<Vec<Rim>> {
        let ends = open.iter().map(|edge| [edge.0 as usize, edge.1 as usize / 2]);
        let shard = self.corners(distinct(ends.clone().flatten()))?;
        let rim = |[a, b]: [usize; 2]| {
            let [a_at, b_at] = [a, b].map(|x| shard.place(x));
            let [on_mesh, names] =
                [0, 1].map(|side| [shard.carriers[side].of(a_at), shard.carriers[side].of(b_at)].concat());
            let ids = distinct(names.iter().map(|n| n / 3));
            let on_both =
                self.world.mesh.on_boundary(on_mesh) && self.world.shell.on_boundary(ids.iter().copied());
            let line = self.facts.corners.number(a);
            ensure!(on_both, "boundary", "line {line}: the edge from here to corner {b}");
            Ok((line, ids, names))
        };
        ends.map(rim).collect()
    }

    fn check_degree(&self, beside: Vec<(usize, usize, usize)>) -> Res {
        let part = |cell: usize| self.part(cell..cell + 1);
        for side in [0, 1] {
            let complex = [&self.world.mesh, &self.world.shell][side];
            let home = |d: &(usize, usize, usize)| Ok(complex.part(part(d.1)?.cell(0)?.home[side]));
            let named = self.facts.degree[side].iter().map(home).collect::<Res<Vec<_>>>()?;
            ensure!(
                named.into_iter().eq(0..complex.parts()),
                "degree-component",
                "not one `d` line a component"
            );
        }
        for side in [0, 1] {
            for &(line, named, fan) in &self.facts.degree[side] {
                let own = part(named)?;
                let cell = own.cell(0)?;
                let home = cell.home[side];
                let triangle = own.triangles(side, &cell)?.into_iter().nth(fan);
                let rows = triangle.ok_or_else(|| bad!("degree", "line {line}"))?;
                let [a, b, c] = rows.each_ref().map(|row| row.iter().sum::<BigInt>());
                let scales = [&b * &c, &a * &c, &a * &b];
                let centre: Vec3 = std::array::from_fn(|i| (0..3).map(|j| &rows[j][i] * &scales[j]).sum());
                let [from, to] = [home, home + 1].map(|h| beside.partition_point(|x| (x.0, x.1) < (side, h)));
                for &(_, _, other) in &beside[from..to] {
                    let shard = part(other)?;
                    for (i, [a, b, c]) in shard.triangles(side, &shard.cell(0)?)?.iter().enumerate() {
                        let sides = [(a, b), (b, c), (c, a)];
                        let holds = sides.iter().all(|(x, y)| sgn(&dot(&cross(x, y), &centre)) >= 0);
                        let itself = (other, i) == (named, fan);
                        ensure!(itself || !holds, "degree", "line {line}: also in cell {other}");
                    }
                }
            }
        }
        Ok(())
    }
}

impl Shard<'_> {
    /// The number of cells.
    pub(crate) fn len(&self) -> usize {
        self.cells.len()
    }

    /// Where a `v` line is in the shard.
    fn place(&self, corner: usize) -> usize {
        self.corners.binary_search(&corner).unwrap_or(0)
    }

    /// Whether the names of two corners together are in a cap.
    fn in_cap(&self, (a, b): (usize, usize)) -> bool {
        self.overlay.world.in_cap(&[self.carriers[1].of(a), self.carriers[1].of(b)])
    }

    /// The corners, checked.
    fn all(&self) -> Res<Vec<Corner>> {
        (0..self.corners.len()).map(|at| self.corner(at)).collect()
    }

    fn corner(&self, at: usize) -> Res<Corner> {
        let Overlay { world, selected, facts, .. } = self.overlay;
        let line = facts.corners.number(self.corners[at]);
        let [ids, names] = self.carriers.each_ref().map(|rows| rows.of(at));
        ensure!(world.mesh.holding(ids).next().is_some(), "mesh-carrier", "line {line}");
        ensure!(selected.holding(names).next().is_some(), "shell-carrier", "line {line}");
        ensure!(!world.in_cap(&[names]), "cap", "line {line}");
        meet(world, line, ids, names)
    }

    pub(crate) fn cell(&self, i: usize) -> Res<Cell> {
        let Overlay { world, facts, .. } = self.overlay;
        let line = facts.cells.number(self.first + i);
        let corners: Vec<usize> = self.cells.of(i).iter().map(|&x| self.place(x)).collect();
        let ids = distinct(self.carried(&corners, 0));
        let pillars = distinct(self.carried(&corners, 1).map(|n| n / 3));
        let [triangle, prism] = [world.mesh.with_corners(&ids), world.shell.with_corners(&pillars)];
        let triangle = triangle.ok_or_else(|| bad!("cell-mesh", "line {line}: not one triangle"))?;
        let prism = prism.ok_or_else(|| bad!("cell-shell", "line {line}: not one prism"))?;
        let within = [world.mesh.of(triangle), world.shell.of(prism)];
        Ok(Cell { line, corners, home: [triangle, prism], within })
    }

    /// The mesh vertices, or the names, of some corners.
    fn carried(&self, corners: &[usize], side: usize) -> impl Iterator<Item = usize> {
        corners.iter().flat_map(move |&at| self.carriers[side].of(at)).copied()
    }

    /// Whether a cell lies in one tet, and the images of its fan triangles have positive areas in both.
    fn check(&self, cell: &Cell, corners: &[Corner]) -> Res {
        let names = distinct(self.carried(&cell.corners, 1));
        let within = self.overlay.selected.holding(&names).next().is_some();
        ensure!(within, "cell-shell", "line {}: not in one tet", cell.line);
        self.areas(cell, corners)
    }

    fn areas(&self, cell: &Cell, corners: &[Corner]) -> Res {
        for (i, fan) in fans(&cell.corners).enumerate() {
            for (side, code) in [(0, "area-mesh"), (1, "area-middle")] {
                let weights = fan.map(|at| &corners[at][side]);
                let near = weights.map(|w| w.row(cell.within[side], &w.near));
                let exact = || sgn(&det(&weights.map(|w| w.row_of(cell.within[side]))));
                let sign = sign_near(&near, false).unwrap_or_else(exact);
                ensure!(sign > 0, code, "line {}: fan triangle {i}", cell.line);
            }
        }
        Ok(())
    }

    /// The fan triangles of a cell as coordinates in its mesh triangle or prism.
    fn triangles(&self, side: usize, cell: &Cell) -> Res<Vec<[Vec3; 3]>> {
        let corners = self.all()?;
        Ok(triangles(cell, |at| corners[at][side].row_of(cell.within[side])))
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

/// The fan triangles of a cell, with the coordinates that its corners have.
fn triangles(cell: &Cell, row: impl Fn(usize) -> Vec3) -> Vec<[Vec3; 3]> {
    fans(&cell.corners).map(|fan| fan.map(&row)).collect()
}

/// The triangles `(c0, ci, ci+1)` that a cell stands for.
fn fans(corners: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    corners.windows(2).skip(1).map(|w| [corners[0], w[0], w[1]])
}

impl Weights {
    fn new(ids: impl Iterator<Item = usize>, exact: Vec<BigInt>) -> Self {
        let (mut all, mut near) = ([0; 4], [0; 4]);
        all.iter_mut().zip(ids).for_each(|(to, id)| *to = id);
        near.iter_mut().zip(leading(exact.iter())).for_each(|(to, x)| *to = x);
        Self { ids: all, near, exact }
    }

    /// The exact coordinates on three vertices.
    fn row_of(&self, corners: [usize; 3]) -> Vec3 {
        self.row(corners, &self.exact)
    }

    /// Values, exact or near ones, summed by the corner that they are on. At most two of a sum are not zero.
    fn row<'b, T: Sum<&'b T>>(&self, corners: [usize; 3], values: &'b [T]) -> [T; 3] {
        let on = |corner| self.ids.iter().zip(values).filter(move |(id, _)| **id == corner);
        corners.map(|corner| on(corner).map(|(_, value)| value).sum())
    }
}

/// The one common point of the affine hulls, with positive coordinates in both carriers.
fn meet(world: &World, line: usize, ids: &[usize], names: &[usize]) -> Res<Corner> {
    let points: Vec<usize> = ids.iter().map(|g| world.base + g).chain(names.iter().copied()).collect();
    let mut on_mesh = dependence(world, &points).unwrap_or_default();
    let mut on_shell = on_mesh.split_off(ids.len().min(on_mesh.len()));
    let sign = sgn(&on_mesh.iter().sum());
    ensure!(sign != 0, "no-point", "line {line}: the carriers' hulls do not meet in one point");
    on_mesh.iter_mut().for_each(|x| *x *= sign);
    on_shell.iter_mut().for_each(|x| *x *= -sign);
    let inside = on_mesh.iter().chain(&on_shell).all(|x| sgn(x) > 0);
    ensure!(inside, "outside-carrier", "line {line}: the point is not inside its carriers");
    let pillars = names.iter().map(|n| n / 3);
    Ok([Weights::new(ids.iter().copied(), on_mesh), Weights::new(pillars, on_shell)])
}

/// The coefficients `c` with `sum c = 0` and `sum c x = 0`, when they are unique up to a factor. The differences to the
/// first point are completed with axes to four vectors: where these have one dependence only, each of its coefficients
/// is a minor. It is that of the differences if it has no axis.
fn dependence(world: &World, points: &[usize]) -> Option<Vec<BigInt>> {
    let (&origin, others) = points.split_first()?;
    let missing = 4usize.checked_sub(others.len())?;
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis| axis.map(BigInt::from));
    let zero = |x: &BigInt| sgn(x) == 0;
    let mut tail = (0..3).find_map(|first| {
        let mut d: Vec<Vec3> = others.iter().map(|&p| world.offset([origin, p])).collect();
        d.extend(axes.iter().cycle().skip(first).take(missing).cloned());
        let (front, back) = (cross(&d[0], &d[1]), cross(&d[2], &d[3]));
        let all = vec![dot(&d[1], &back), -dot(&d[0], &back), dot(&d[3], &front), -dot(&d[2], &front)];
        (!all.iter().all(zero) && all[others.len()..].iter().all(zero)).then_some(all)
    })?;
    tail.truncate(others.len());
    let head = -tail.iter().sum::<BigInt>();
    Some(std::iter::once(head).chain(tail).collect())
}
