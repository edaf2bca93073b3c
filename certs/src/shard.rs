//! A part of the overlay (FORMAT section 3.2): cells that follow each other, made from the certificate's lines, with the
//! points at their corners.

use crate::complex::distinct;
use crate::number::{Integer, Vec3, cross, det, dot, sgn, sign_near};
use crate::pages::Rows;
use crate::parse::Overlay as Facts;
use crate::tets::Selected;
use crate::world::World;
use crate::{Res, part};
use ethnum::I256;
use num_bigint::BigInt;
use std::iter::Sum;
use std::ops::Mul;

/// All cells, and what they are checked against.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) world: &'a World,
    pub(crate) selected: &'a Selected<'a>,
    pub(crate) facts: &'a Facts<'a>,
}

/// Barycentric coordinates times a positive number: of which vertices (at most four), leading bits, exactly.
pub(crate) struct Weights {
    ids: [usize; 4],
    near: [i128; 4],
    exact: Vec<BigInt>,
}

/// A vertex of `K`: its coordinates on the vertices of the mesh, and on those of the shell, where names of one vertex each
/// have their own weight.
pub(crate) type Corner = [Weights; 2];

/// A cell: its line, its corners' places in the shard, the triangle of `T` and the prism, and the corners of both.
pub(crate) struct Cell {
    pub(crate) line: usize,
    pub(crate) corners: Vec<usize>,
    pub(crate) home: [usize; 2],
    pub(crate) within: [[usize; 3]; 2],
}

/// Some cells, and the `v` lines at their corners.
pub(crate) struct Shard<'a> {
    source: Source<'a>,
    /// The numbers of the cells, ascending, and their corners.
    pub(crate) numbers: Vec<usize>,
    pub(crate) cells: Rows,
    /// The numbers of the `v` lines, ascending; their mesh vertices and names.
    pub(crate) corners: Vec<usize>,
    pub(crate) carriers: [Rows; 2],
}

impl<'a> Source<'a> {
    /// How many shards the cells are in.
    pub(crate) fn shards(&self) -> usize {
        self.facts.cells.len().div_ceil(self.size())
    }

    /// How many cells a shard has, but for the last one.
    pub(crate) fn size(&self) -> usize {
        let [least, most] = if cfg!(test) { [2, 2] } else { [64, 1 << 15] };
        (self.facts.cells.len() / (8 * rayon::current_num_threads())).clamp(least, most)
    }

    /// The numbers of the cells of a shard.
    pub(crate) fn numbers(&self, shard: usize) -> Vec<usize> {
        part(self.facts.cells.len(), self.size(), shard).collect()
    }

    /// These cells, ascending.
    pub(crate) fn cells(&self, numbers: Vec<usize>) -> Res<Shard<'a>> {
        let cells = self.facts.cells.cells(&numbers)?;
        let shard = self.corners(distinct(cells.items().iter().copied()))?;
        Ok(Shard { numbers, cells, ..shard })
    }

    /// These `v` lines, ascending, without cells.
    pub(crate) fn corners(&self, corners: Vec<usize>) -> Res<Shard<'a>> {
        let carriers = self.facts.corners.carriers(&corners)?;
        Ok(Shard { source: *self, numbers: vec![], cells: Rows::default(), corners, carriers })
    }
}

impl Shard<'_> {
    /// The number of cells.
    pub(crate) fn len(&self) -> usize {
        self.cells.len()
    }

    /// Where a `v` line is in the shard; there is none that is asked for and not there.
    pub(crate) fn place(&self, corner: usize) -> Res<usize> {
        self.corners
            .binary_search(&corner)
            .map_err(|_| bad!("isolated", "corner {corner} is not in its shard"))
    }

    /// Whether the names of two corners together are in a cap.
    pub(crate) fn in_cap(&self, (a, b): (usize, usize)) -> bool {
        self.source.world.in_cap(&[self.carriers[1].of(a), self.carriers[1].of(b)])
    }

    /// The corners, checked.
    pub(crate) fn all(&self) -> Res<Vec<Corner>> {
        (0..self.corners.len()).map(|at| self.corner(at)).collect()
    }

    fn corner(&self, at: usize) -> Res<Corner> {
        let Source { world, selected, facts } = self.source;
        let line = facts.corners.number(self.corners[at]);
        let [ids, names] = self.carriers.each_ref().map(|rows| rows.of(at));
        ensure!(world.mesh.holding(ids).next().is_some(), "mesh-carrier", "line {line}");
        ensure!(selected.holding(names).next().is_some(), "shell-carrier", "line {line}");
        ensure!(!world.in_cap(&[names]), "cap", "line {line}");
        meet(world, line, ids, names)
    }

    pub(crate) fn cell(&self, i: usize) -> Res<Cell> {
        let Source { world, facts, .. } = self.source;
        let line = facts.cells.number(self.numbers[i]);
        let corners = self.cells.of(i).iter().map(|&x| self.place(x)).collect::<Res<Vec<_>>>()?;
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
    pub(crate) fn check(&self, cell: &Cell, corners: &[Corner]) -> Res {
        let names = distinct(self.carried(&cell.corners, 1));
        let within = self.source.selected.holding(&names).next().is_some();
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
}

/// The fan triangles of a cell as coordinates in its mesh triangle or prism.
pub(crate) fn triangles(cell: &Cell, corners: &[Corner], side: usize) -> Vec<[Vec3; 3]> {
    let row = |at: usize| corners[at][side].row_of(cell.within[side]);
    fans(&cell.corners).map(|fan| fan.map(row)).collect()
}

/// The triangles `(c0, ci, ci+1)` that a cell stands for.
pub(crate) fn fans(corners: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    corners.windows(2).skip(1).map(|w| [corners[0], w[0], w[1]])
}

impl Weights {
    fn new<T: Integer>(ids: impl Iterator<Item = usize>, exact: &[T]) -> Self {
        let (mut all, mut near) = ([0; 4], [0; 4]);
        all.iter_mut().zip(ids).for_each(|(to, id)| *to = id);
        near.iter_mut().zip(T::leading(exact)).for_each(|(to, x)| *to = x);
        Self { ids: all, near, exact: exact.iter().map(T::big).collect() }
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
    let others = &points[1..];
    let result = match world.is_narrow() {
        // Differences below 2^81 give coefficients below 2^248.
        true => weights(others, |x| world.narrow_offset([points[0], x]).map(I256::from), ids, names),
        false => weights(others, |x| world.offset([points[0], x]), ids, names),
    };
    result.map_err(|code| match code {
        "no-point" => bad!(code, "line {line}: the carriers' hulls do not meet in one point"),
        _ => bad!(code, "line {line}: the point is not inside its carriers"),
    })
}

/// The corner at that point, or the code of what is wrong; the differences to the first mesh vertex are given.
fn weights<T: Integer>(
    others: &[usize],
    offset: impl Fn(usize) -> Vec3<T>,
    ids: &[usize],
    names: &[usize],
) -> Result<Corner, &'static str>
where
    for<'x> &'x T: Mul<&'x T, Output = T>,
{
    let zero = || T::from(0);
    let offsets: Vec<_> = others.iter().map(|&x| offset(x)).collect();
    let all = dependence(&offsets).ok_or("no-point")?;
    let (on_mesh, on_shell) = all.split_at(ids.len());
    let sum = on_mesh.iter().fold(zero(), |sum, x| sum + x.clone());
    let turned = |x: &T, turn: bool| if turn { -x.clone() } else { x.clone() };
    let [on_mesh, on_shell]: [Vec<T>; 2] = [(on_mesh, sum < zero()), (on_shell, sum > zero())]
        .map(|(part, turn)| part.iter().map(|x| turned(x, turn)).collect());
    if sum == zero() {
        return Err("no-point");
    }
    if !on_mesh.iter().chain(&on_shell).all(|x| *x > zero()) {
        return Err("outside-carrier");
    }
    let pillars = names.iter().map(|n| n / 3);
    Ok([Weights::new(ids.iter().copied(), &on_mesh), Weights::new(pillars, &on_shell)])
}

/// The coefficients `c` with `sum c = 0` and `sum c x = 0` of points whose differences to the first one are given, when
/// they are unique up to a factor. The differences are completed with axes to four vectors: where these have one
/// dependence only, each of its coefficients is a minor. It is that of the differences if it has no axis.
fn dependence<T: Integer>(offsets: &[Vec3<T>]) -> Option<Vec<T>>
where
    for<'x> &'x T: Mul<&'x T, Output = T>,
{
    let count = offsets.len();
    let missing = 4usize.checked_sub(count)?;
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|axis: [i8; 3]| axis.map(T::from));
    let zero = |x: &T| *x == T::from(0);
    let mut tail = (0..3).find_map(|first| {
        let mut d = offsets.to_vec();
        d.extend(axes.iter().cycle().skip(first).take(missing).cloned());
        let (front, back) = (cross(&d[0], &d[1]), cross(&d[2], &d[3]));
        let all = vec![dot(&d[1], &back), -dot(&d[0], &back), dot(&d[3], &front), -dot(&d[2], &front)];
        (!all.iter().all(zero) && all[count..].iter().all(zero)).then_some(all)
    })?;
    tail.truncate(count);
    let head = -tail.iter().fold(T::from(0), |sum, x| sum + x.clone());
    Some(std::iter::once(head).chain(tail).collect())
}
