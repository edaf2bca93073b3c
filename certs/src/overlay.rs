//! `section` and `bijection` certified: the overlay (FORMAT section 3.2, rule R2 of THEORY).

use crate::number::{Num, Vec3, det};
use crate::parse::Overlay as Facts;
use crate::tets::Selected;
use crate::world::World;
use crate::{Res, ensure, invalid};
use num_bigint::BigInt;
use std::collections::HashSet;

/// A vertex of `K`: barycentric coordinates times `weight > 0` on its mesh ids and on its names.
struct Corner<'a> {
    ids: &'a [usize],
    names: &'a [usize],
    on_mesh: Vec<BigInt>,
    on_shell: Vec<BigInt>,
    weight: BigInt,
}

/// A cell, the triangle of `T` that it lies in and the prism.
pub(crate) struct Cell<'a> {
    pub(crate) line: usize,
    corners: &'a [usize],
    pub(crate) triangle: usize,
    pub(crate) prism: usize,
}

/// A checked overlay.
pub(crate) struct Overlay<'a> {
    corners: Vec<Corner<'a>>,
    pub(crate) cells: Vec<Cell<'a>>,
    /// The edges of `K` without their reverse, and a line that has them.
    boundary: Vec<(usize, usize, usize)>,
}

/// Three barycentric coordinates times a positive number.
pub(crate) type Row = Vec3<BigInt>;

impl<'a> Overlay<'a> {
    pub(crate) fn check<N: Num>(world: &World<N>, selected: &Selected, facts: &'a Facts) -> Res<Self> {
        if let Some((tet, prism, _)) = selected.tets.iter().find(|t| !t.2) {
            return invalid("not-positive", format!("prism {prism}: tet {}", crate::show(&tet.names)));
        }
        let used = world.mesh.used(world.points_in_mesh());
        let corner = |(line, ids, names): &'a (usize, Vec<usize>, Vec<usize>)| {
            ensure(world.mesh.is_simplex(ids, &used), "mesh-carrier", || format!("line {line}"))?;
            ensure(selected.holding(names).next().is_some(), "shell-carrier", || format!("line {line}"))?;
            ensure(!world.in_cap(names), "cap", || format!("line {line}"))?;
            meet(world, *line, ids, names)
        };
        let corners = facts.corners.iter().map(corner).collect::<Res<Vec<_>>>()?;
        let mut overlay = Self { corners, cells: Vec::new(), boundary: Vec::new() };
        for (line, ids) in &facts.cells {
            let cell = overlay.place(world, selected, *line, ids)?;
            overlay.check_areas(world, &cell)?;
            overlay.cells.push(cell);
        }
        overlay.check_edges(world)?;
        let mut isolated = vec![true; overlay.corners.len()];
        overlay.cells.iter().flat_map(|c| c.corners).for_each(|&x| isolated[x] = false);
        if let Some(x) = isolated.iter().position(|&i| i) {
            return invalid("isolated", format!("line {}: in no cell", facts.corners[x].0));
        }
        overlay.check_degree(world, facts)?;
        Ok(overlay)
    }

    fn place<N: Num>(
        &self,
        world: &World<N>,
        selected: &Selected,
        line: usize,
        corners: &'a [usize],
    ) -> Res<Cell<'a>> {
        let gather = |part: fn(&Corner<'a>) -> &'a [usize]| -> Vec<usize> {
            crate::complex::distinct(
                &corners.iter().flat_map(|&x| part(&self.corners[x])).copied().collect::<Vec<_>>(),
            )
        };
        let Some(triangle) = world.mesh.with_corners(&gather(|c| c.ids)) else {
            return invalid(
                "cell-mesh",
                format!("line {line}: the carriers in the mesh are not those of a triangle"),
            );
        };
        let names = gather(|c| c.names);
        let ids: Vec<usize> = names.iter().map(|n| n / 3).collect();
        match world.shell.with_corners(&ids) {
            Some(prism) if selected.in_prism(prism, &names) => Ok(Cell { line, corners, triangle, prism }),
            _ => invalid("cell-shell", format!("line {line}: the carriers in the shell do not fill one tet")),
        }
    }

    /// A corner's coordinates in triangle `f`, in its corner order.
    fn mesh_row<N: Num>(&self, world: &World<N>, f: usize, x: usize) -> Row {
        let corner = &self.corners[x];
        row(world.mesh.triangles[f], corner.ids, &corner.on_mesh)
    }

    /// A corner's projected coordinates in a prism.
    fn shell_row<N: Num>(&self, world: &World<N>, prism: usize, x: usize) -> Row {
        let corner = &self.corners[x];
        let ids: Vec<usize> = corner.names.iter().map(|n| n / 3).collect();
        row(world.shell.triangles[prism], &ids, &corner.on_shell)
    }

    /// The fan triangles of a cell as coordinates in its mesh triangle.
    pub(crate) fn pieces<N: Num>(&self, world: &World<N>, cell: &Cell<'_>) -> Vec<[Row; 3]> {
        fans(cell.corners).map(|fan| fan.map(|x| self.mesh_row(world, cell.triangle, x))).collect()
    }

    fn check_areas<N: Num>(&self, world: &World<N>, cell: &Cell<'_>) -> Res {
        for (i, fan) in fans(cell.corners).enumerate() {
            let at = || format!("line {}: fan triangle {i}", cell.line);
            let [a, b, c] = fan.map(|x| self.mesh_row(world, cell.triangle, x));
            ensure(det(&a, &b, &c).sgn() > 0, "area-mesh", at)?;
            let [a, b, c] = fan.map(|x| self.shell_row(world, cell.prism, x));
            ensure(det(&a, &b, &c).sgn() > 0, "area-middle", at)?;
        }
        Ok(())
    }

    fn check_edges<N: Num>(&mut self, world: &World<N>) -> Res {
        let mut edges = HashSet::new();
        let all = || {
            let cells = self.cells.iter();
            cells.flat_map(|c| fans(c.corners).flat_map(crate::complex::sides).map(|(a, b)| (c.line, a, b)))
        };
        for (line, a, b) in all() {
            ensure(edges.insert((a, b)), "edge-twice", || format!("line {line}: corners {a} {b}"))?;
        }
        self.boundary = all().filter(|&(_, a, b)| !edges.contains(&(b, a))).collect();
        for &(line, a, b) in &self.boundary {
            let ids = [self.corners[a].ids, self.corners[b].ids].concat();
            let on_both = world.mesh.on_boundary(&ids) && world.shell.on_boundary(&self.pillars(a, b));
            ensure(on_both, "boundary", || format!("line {line}: corners {a} {b}"))?;
        }
        Ok(())
    }

    /// The vertex ids of the names of two corners.
    fn pillars(&self, a: usize, b: usize) -> Vec<usize> {
        self.corners[a].names.iter().chain(self.corners[b].names).map(|n| n / 3).collect()
    }

    /// The boundary edges of `K`: a line, the vertex ids of the names, the names.
    pub(crate) fn boundary(&self) -> impl Iterator<Item = (usize, Vec<usize>, Vec<usize>)> {
        self.boundary.iter().map(|&(line, a, b)| {
            let names = [self.corners[a].names, self.corners[b].names].concat();
            (line, crate::complex::distinct(&self.pillars(a, b)), names)
        })
    }

    fn check_degree<N: Num>(&self, world: &World<N>, facts: &Facts) -> Res {
        let [on_mesh, on_shell] = [|c: &Cell<'_>| c.triangle, |c: &Cell<'_>| c.prism];
        let place = [on_mesh, on_shell];
        for (side, complex) in [&world.mesh, &world.shell].into_iter().enumerate() {
            let lines = &facts.degree[side];
            let named = lines.iter().map(|l| complex.part[place[side](&self.cells[l.1])]);
            ensure(named.eq(0..complex.parts), "degree-component", || {
                format!("line {}: the `d` lines do not name one cell for each component", lines[0].0)
            })?;
        }
        for (side, lines) in facts.degree.iter().enumerate() {
            let size = [world.mesh.triangles.len(), world.shell.triangles.len()][side];
            let mut inside: Vec<Vec<usize>> = vec![Vec::new(); size];
            self.cells.iter().enumerate().for_each(|(i, c)| inside[place[side](c)].push(i));
            for &(line, cell, fan) in lines {
                let home = place[side](&self.cells[cell]);
                let rows = |[a, b, c]: [usize; 3]| {
                    [a, b, c].map(|x| {
                        if side == 0 { self.mesh_row(world, home, x) } else { self.shell_row(world, home, x) }
                    })
                };
                let Some(named) = fans(self.cells[cell].corners).nth(fan) else { continue };
                let [a, b, c] = named.map(|x| &self.corners[x].weight);
                let scales = [b * c, a * c, a * b];
                let corners = rows(named);
                let centre: Row = std::array::from_fn(|i| (0..3).map(|j| &corners[j][i] * &scales[j]).sum());
                for &other in &inside[home] {
                    for (i, triangle) in fans(self.cells[other].corners).enumerate() {
                        let [a, b, c] = rows(triangle);
                        let sides = [(&a, &b), (&b, &c), (&c, &a)];
                        let holds = sides.iter().all(|(x, y)| det(x, y, &centre).sgn() >= 0);
                        ensure((other, i) == (cell, fan) || !holds, "degree", || {
                            format!(
                                "line {line}: the centroid lies also in line {}, fan triangle {i}",
                                self.cells[other].line
                            )
                        })?;
                    }
                }
            }
        }
        Ok(())
    }
}

/// The triangles `(c0, ci, ci+1)` that a cell stands for.
fn fans(corners: &[usize]) -> impl Iterator<Item = [usize; 3]> + '_ {
    corners.windows(2).skip(1).map(|w| [corners[0], w[0], w[1]])
}

/// Coordinates summed by the corner that they are on.
fn row(corners: [usize; 3], ids: &[usize], coordinates: &[BigInt]) -> Row {
    let mut row = Row::default();
    for (id, value) in ids.iter().zip(coordinates) {
        corners.iter().zip(&mut row).filter(|(c, _)| *c == id).for_each(|(_, sum)| *sum += value);
    }
    row
}

/// The one common point of the affine hulls, with positive coordinates in both carriers.
fn meet<'a, N: Num>(world: &World<N>, line: usize, ids: &'a [usize], names: &'a [usize]) -> Res<Corner<'a>> {
    let points: Vec<usize> = ids.iter().map(|g| world.base + g).chain(names.iter().copied()).collect();
    // Six points or more have two independent dependences.
    let coefficients = if points.len() <= 5 { world.dependence(&points) } else { None };
    let all: Vec<BigInt> = coefficients.iter().flatten().map(N::big).collect();
    let on_mesh = all.get(..ids.len()).unwrap_or(&[]);
    let weight: BigInt = on_mesh.iter().sum();
    let sign = weight.sgn();
    ensure(sign != 0, "no-point", || format!("line {line}: the carriers' hulls do not meet in one point"))?;
    let on_mesh: Vec<BigInt> = on_mesh.iter().map(|x| x * sign).collect();
    let on_shell: Vec<BigInt> = all[ids.len()..].iter().map(|x| x * -sign).collect();
    let inside = on_mesh.iter().chain(&on_shell).all(|x| x.sgn() > 0);
    ensure(inside, "outside-carrier", || format!("line {line}: the point is not inside its carriers"))?;
    Ok(Corner { ids, names, on_mesh, on_shell, weight: weight * sign })
}
