//! `section` and `bijection` certified: the overlay (FORMAT section 3.2, rule R2 of THEORY).

use crate::complex::{distinct, sides};
use crate::number::{Vec3, cross, det, dot, leading, sgn, sign_near};
use crate::parse::Overlay as Facts;
use crate::tets::Selected;
use crate::world::World;
use crate::{Res, Set, all};
use num_bigint::BigInt;
use std::iter::Sum;

/// Barycentric coordinates times a positive number: of which vertices, exactly, leading bits.
struct Weights {
    ids: Vec<usize>,
    exact: Vec<BigInt>,
    near: Vec<i128>,
}

/// A vertex of `K`.
struct Corner<'a> {
    names: &'a [usize],
    /// On the vertices of the mesh; on those of the shell, where names of one vertex each have their own weight.
    weights: [Weights; 2],
}

/// A cell, the triangle of `T` that it lies in and the prism.
pub(crate) struct Cell<'a> {
    pub(crate) line: usize,
    corners: &'a [usize],
    pub(crate) home: [usize; 2],
    /// The corners of both.
    within: [[usize; 3]; 2],
}

/// A checked overlay.
pub(crate) struct Overlay<'a> {
    corners: Vec<Corner<'a>>,
    pub(crate) cells: Vec<Cell<'a>>,
    /// The edges of `K` without their reverse: a cell's line, the vertex ids of the ends' names, the names.
    pub(crate) boundary: Vec<Rim>,
}

type Rim = (usize, Vec<usize>, Vec<usize>);

impl<'a> Overlay<'a> {
    pub(crate) fn check(world: &World, selected: &Selected<'_>, facts: &'a Facts) -> Res<Self> {
        ensure!(selected.positive(), "not-positive", "a tet of the order");
        let corners = all(facts.ids.len(), |i| {
            let (line, ids, names) = (facts.ids.line(i), facts.ids.of(i), facts.names.of(i));
            ensure!(world.mesh.holding(ids).next().is_some(), "mesh-carrier", "line {line}");
            ensure!(selected.holding(names).next().is_some(), "shell-carrier", "line {line}");
            ensure!(!world.in_cap(&[names]), "cap", "line {line}");
            meet(world, line, ids, names)
        })?;
        let mut overlay = Self { corners, cells: Vec::new(), boundary: Vec::new() };
        overlay.cells = all(facts.cells.len(), |i| overlay.cell(world, selected, facts, i))?;
        overlay.boundary = overlay.check_edges(world)?;
        let mut used = vec![false; overlay.corners.len()];
        overlay.cells.iter().flat_map(|c| c.corners).for_each(|&x| used[x] = true);
        ensure!(!used.contains(&false), "isolated", "a `v` line is in no cell");
        overlay.check_degree(world, facts)?;
        Ok(overlay)
    }

    fn cell(&self, world: &World, selected: &Selected<'_>, facts: &'a Facts, i: usize) -> Res<Cell<'a>> {
        let (line, corners) = (facts.cells.line(i), facts.cells.of(i));
        let ids =
            |side: usize| distinct(corners.iter().flat_map(|&x| &self.corners[x].weights[side].ids).copied());
        let names = distinct(corners.iter().flat_map(|&x| self.corners[x].names).copied());
        let [triangle, prism] = [world.mesh.with_corners(&ids(0)), world.shell.with_corners(&ids(1))];
        let triangle = triangle.ok_or_else(|| bad!("cell-mesh", "line {line}: not one triangle"))?;
        let prism = prism.filter(|_| selected.holding(&names).next().is_some());
        let prism = prism.ok_or_else(|| bad!("cell-shell", "line {line}: not one tet that fills a prism"))?;
        let within = [world.mesh.triangles[triangle], world.shell.triangles[prism]];
        let cell = Cell { line, corners, home: [triangle, prism], within };
        for (i, fan) in fans(corners).enumerate() {
            for (side, code) in [(0, "area-mesh"), (1, "area-middle")] {
                let weights = fan.map(|x| &self.corners[x].weights[side]);
                let near = weights.map(|w| w.row(cell.within[side], &w.near));
                let exact = || sgn(&det(&self.rows(side, &cell, fan)));
                let sign = sign_near(&near, false).unwrap_or_else(exact);
                ensure!(sign > 0, code, "line {line}: fan triangle {i}");
            }
        }
        Ok(cell)
    }

    /// The coordinates of three corners in a cell's triangle or prism.
    fn rows(&self, side: usize, cell: &Cell<'_>, fan: [usize; 3]) -> [Vec3; 3] {
        fan.map(|x| &self.corners[x].weights[side]).map(|w| w.row(cell.within[side], &w.exact))
    }

    /// The fan triangles of a cell as coordinates in its mesh triangle.
    pub(crate) fn pieces(&self, cell: &Cell<'_>) -> Vec<Vec<Vec3>> {
        fans(cell.corners).map(|fan| self.rows(0, cell, fan).to_vec()).collect()
    }

    fn check_edges(&self, world: &World) -> Res<Vec<Rim>> {
        let directed =
            || self.cells.iter().flat_map(|c| fans(c.corners).flat_map(sides).map(|e| (c.line, e)));
        // Half as long as pairs of `usize`.
        let short = |(a, b): (usize, usize)| (a as u32, b as u32);
        let mut edges = Set::default();
        for (line, edge) in directed() {
            ensure!(edges.insert(short(edge)), "edge-twice", "line {line}: corners {edge:?}");
            let names = [edge.0, edge.1].map(|x| self.corners[x].names);
            ensure!(!world.in_cap(&names), "cap", "line {line}: corners {edge:?}");
        }
        let mut boundary = Vec::new();
        for (line, (a, b)) in directed().filter(|&(_, (a, b))| !edges.contains(&short((b, a)))) {
            let ends = [a, b].map(|x| &self.corners[x]);
            let [on_mesh, ids] =
                [0, 1].map(|side| distinct(ends.map(|c| c.weights[side].ids.clone()).concat()));
            let on_both = world.mesh.on_boundary(on_mesh) && world.shell.on_boundary(ids.iter().copied());
            ensure!(on_both, "boundary", "line {line}: corners {a} {b}");
            boundary.push((line, ids, ends.map(|c| c.names).concat()));
        }
        Ok(boundary)
    }

    fn check_degree(&self, world: &World, facts: &Facts) -> Res {
        for side in [0, 1] {
            let complex = [&world.mesh, &world.shell][side];
            let named = facts.degree[side].iter().map(|d| complex.part[self.cells[d.1].home[side]]);
            ensure!(named.eq(0..complex.parts), "degree-component", "not one `d` line a component");
        }
        for side in [0, 1] {
            let mut cells: Vec<&Cell<'_>> = self.cells.iter().collect();
            cells.sort_unstable_by_key(|c| c.home[side]);
            for &(line, named, fan) in &facts.degree[side] {
                let named = &self.cells[named];
                let triangle = fans(named.corners).nth(fan).ok_or_else(|| bad!("degree", "line {line}"))?;
                let [a, b, c] = triangle.map(|x| self.corners[x].weights[side].exact.iter().sum::<BigInt>());
                let (rows, scales) = (self.rows(side, named, triangle), [&b * &c, &a * &c, &a * &b]);
                let centre: Vec3 = std::array::from_fn(|i| (0..3).map(|j| &rows[j][i] * &scales[j]).sum());
                let first = cells.partition_point(|c| c.home[side] < named.home[side]);
                for other in cells[first..].iter().take_while(|c| c.home[side] == named.home[side]) {
                    for (i, triangle) in fans(other.corners).enumerate() {
                        let [a, b, c] = &self.rows(side, named, triangle);
                        let sides = [(a, b), (b, c), (c, a)];
                        let holds = sides.iter().all(|(x, y)| sgn(&dot(&cross(x, y), &centre)) >= 0);
                        let itself = (other.line, i) == (named.line, fan);
                        ensure!(itself || !holds, "degree", "line {line}: also in line {}", other.line);
                    }
                }
            }
        }
        Ok(())
    }
}

/// The triangles `(c0, ci, ci+1)` that a cell stands for.
fn fans(corners: &[usize]) -> impl Iterator<Item = [usize; 3]> {
    corners.windows(2).skip(1).map(|w| [corners[0], w[0], w[1]])
}

impl Weights {
    fn new(ids: impl Iterator<Item = usize>, exact: Vec<BigInt>) -> Self {
        Self { ids: ids.collect(), near: leading(exact.iter()).collect(), exact }
    }

    /// Values, exact or near ones, summed by the corner that they are on. At most two of a sum are not zero.
    fn row<'b, T: Sum<&'b T>>(&self, corners: [usize; 3], values: &'b [T]) -> [T; 3] {
        let on = |corner| self.ids.iter().zip(values).filter(move |(id, _)| **id == corner);
        corners.map(|corner| on(corner).map(|(_, value)| value).sum())
    }
}

/// The one common point of the affine hulls, with positive coordinates in both carriers.
fn meet<'a>(world: &World, line: usize, ids: &'a [usize], names: &'a [usize]) -> Res<Corner<'a>> {
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
    let weights = [Weights::new(ids.iter().copied(), on_mesh), Weights::new(pillars, on_shell)];
    Ok(Corner { names, weights })
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
