//! The claims about meshes, certified or recomputed (MESHES sections 4.1 to 4.4).

use super::cells::{Cells, Structure};
use super::pairs::{self, Faces};
use super::parse::Cert;
use super::points::Points;
use super::{rays, witness};
use crate::number::sgn;
use crate::{Map, Res, each};
use num_bigint::BigInt;

/// An input: its cells, the number of its first point, and whether a cell has an inside in its space.
pub(super) struct Input {
    pub(super) cells: Cells,
    pub(super) base: usize,
    pub(super) full: bool,
}

impl Input {
    /// The point numbers of vertices.
    pub(super) fn points(&self, ids: &[usize]) -> Vec<usize> {
        ids.iter().map(|v| self.base + v).collect()
    }

    /// The sign of the determinant of a cell of a full complex; of another one, 1 unless it is flat.
    pub(super) fn sign(&self, points: &Points, c: usize) -> i32 {
        let ids = self.points(self.cells.cell(c));
        match (self.full, ids.as_slice()) {
            (false, &[a, b, c]) => i32::from(points.normal([a, b, c]).iter().any(|x| sgn(x) != 0)),
            _ => points.orient(&ids),
        }
    }

    fn solid(&self, points: &Points) -> Res<Structure> {
        let structure = self.cells.sound()?;
        self.not_flat(points)?;
        Ok(structure)
    }

    pub(super) fn not_flat(&self, points: &Points) -> Res {
        each(self.cells.len(), |c| {
            ensure!(self.sign(points, c) != 0, "mesh-conditions", "cell {c} is flat");
            Ok(())
        })
    }

    /// All triangles.
    pub(super) fn triangles(&self) -> Faces {
        let corners = (0..self.cells.len()).map(|c| self.cells.triangle(c).map(|v| self.base + v)).collect();
        Faces { ids: (0..self.cells.len()).collect(), corners }
    }

    /// The boundary facets.
    fn rim(&self, structure: &Structure) -> Faces {
        let ids: Vec<usize> = structure.rim.iter().map(|r| r.0).collect();
        let shift = |v: usize| v.saturating_add(self.base); // the filling stays what it is
        Faces { corners: ids.iter().map(|&f| self.cells.facet(f).map(shift)).collect(), ids }
    }
}

/// Checks the claim.
pub(super) fn check(cert: &Cert, inputs: &[Input], points: &Points) -> Res {
    match (cert.claim, inputs) {
        ("same-topology", [a, b]) => {
            let differ = topology(a)? != topology(b)?;
            ensure!(differ || cert.certified, "not-refuted", "the topology is the same");
            ensure!(!differ || !cert.certified, "topology", "of the components differs");
        }
        ("nested-topology", [a, b]) => {
            let (a, b) = (topology(a)?, topology(b)?);
            let (a, b) = (closed_genus(&a)?, closed_genus(&b)?);
            ensure!(b > a, "not-refuted", "twice the genus of a is {a}, of b {b}");
        }
        (_, _) if !cert.certified => witness::check(cert, inputs, points)?,
        ("nested", [a, b]) => nested(cert, a, b, points)?,
        ("pl-homeomorphism", _) => {
            let structure = inputs[0].cells.sound()?;
            for (input, lines) in inputs.iter().zip(&cert.planes) {
                if !input.full {
                    input.not_flat(points)?;
                    pairs::separated(points, &input.triangles(), None, lines)?;
                    continue;
                }
                one_sign(input, &structure, points)?;
                let rim = input.rim(&structure);
                match input.cells.k {
                    3 => pairs::no_crossing(points, &rim)?,
                    _ => pairs::separated(points, &rim, None, lines)?,
                }
                covered_once(input, &structure, points, &rim)?;
            }
        }
        (_, [a, ..]) => {
            a.solid(points)?;
            if let [lines] = &cert.planes[..] {
                pairs::separated(points, &a.triangles(), None, lines)?;
            }
        }
        _ => {}
    }
    Ok(())
}

/// Euler characteristic and number of boundary loops of the components, ascending.
fn topology(input: &Input) -> Res<Vec<(i64, usize)>> {
    let (cells, structure) = (&input.cells, input.cells.sound()?);
    let mut found = vec![(0, 0); structure.parts];
    let part = |c: usize| structure.part[c];
    // A triangle has half an edge for each side, the boundary the other halves.
    for c in 0..cells.len() {
        found[part(c)].0 -= 1;
    }
    let mut last = Map::default();
    for &(f, in_loop) in &structure.rim {
        found[part(f / 3)].0 -= 1;
        last.insert(in_loop, part(f / 3));
    }
    found.iter_mut().for_each(|x| x.0 /= 2);
    let mut home = vec![usize::MAX; cells.vertices];
    for (at, &v) in cells.corners.iter().enumerate() {
        home[v] = part(at / 3);
    }
    home.iter().filter(|&&p| p != usize::MAX).for_each(|&p| found[p].0 += 1);
    last.values().for_each(|&p| found[p].1 += 1);
    found.sort_unstable();
    Ok(found)
}

/// Twice the sum of the genera of the components of a closed surface.
fn closed_genus(found: &[(i64, usize)]) -> Res<i64> {
    ensure!(found.iter().all(|x| x.1 == 0), "not-closed", "there are boundary edges");
    Ok(found.iter().map(|x| 2 - x.0).sum())
}

fn nested(cert: &Cert, a: &Input, b: &Input, points: &Points) -> Res {
    let structures = [a.solid(points)?, b.solid(points)?];
    let open = |s: &Structure| s.rim.first().copied();
    for (x, s) in ["a", "b"].iter().zip(&structures) {
        ensure!(open(s).is_none(), "not-closed", "{x} has a boundary");
    }
    let faces = [a.triangles(), b.triangles()];
    pairs::separated(points, &faces[0], None, &cert.planes[0])?;
    pairs::separated(points, &faces[1], None, &cert.planes[1])?;
    pairs::separated(points, &faces[0], Some(&faces[1]), &cert.planes[2])?;
    let inputs = [a, b];
    for (x, structure) in structures.iter().enumerate() {
        let lines: Vec<_> = cert.rays.iter().filter(|ray| ray.input == x).collect();
        let cells = &inputs[x].cells;
        let mut home = vec![usize::MAX; cells.vertices];
        for (at, &v) in cells.corners.iter().enumerate() {
            home[v] = structure.part[at / 3];
        }
        let in_place = lines.iter().enumerate().all(|(i, ray)| home[ray.vertex] == i);
        ensure!(
            lines.len() == structure.parts && in_place,
            "ray-component",
            "a ray for each component, in order"
        );
    }
    let trees = [faces[0].tree(points), faces[1].tree(points)];
    each(cert.rays.len(), |at| {
        let ray = &cert.rays[at];
        let (x, y) = (ray.input, 1 - ray.input);
        let number = rays::number(points, inputs[x].base + ray.vertex, ray, &faces[y], &trees[y])?;
        ensure!(number == winding(x), "winding", "line {}: the number is {number}", ray.line);
        Ok(())
    })
}

/// What the winding number must be about the components of an input.
pub(super) fn winding(input: usize) -> i64 {
    if input == 0 { 1 } else { 0 }
}

/// All cells of a component have determinants of one strict sign.
fn one_sign(input: &Input, structure: &Structure, points: &Points) -> Res {
    let mut first = vec![None; structure.parts];
    for c in 0..input.cells.len() {
        let sign = input.sign(points, c);
        let first = *first[structure.part[c]].get_or_insert(sign);
        ensure!(sign != 0 && sign == first, "sign", "of cell {c}");
    }
    Ok(())
}

/// The centroid of the first facet of every part of the boundary lies in no other cell.
fn covered_once(input: &Input, structure: &Structure, points: &Points, rim: &Faces) -> Res {
    let cells = &input.cells;
    let bounds = |c: usize| crate::boxes::Aabb::of(&points.keys, &input.points(cells.cell(c)));
    let tree = crate::boxes::Tree::new(cells.len(), bounds);
    let mut first = vec![None; structure.loops];
    for (at, &(_, part)) in structure.rim.iter().enumerate() {
        first[part].get_or_insert(at);
    }
    let first: Vec<usize> = first.into_iter().flatten().collect();
    each(first.len(), |part| {
        let at = first[part];
        let f = rim.ids[at];
        let centroid = centroid(input, f, points);
        // The facet's box has its centroid.
        for c in tree.meeting(&rim.bounds(points, at)) {
            let twice = c != f / cells.k && points.holds(&input.points(cells.cell(c)), &centroid);
            ensure!(!twice, "twice", "the centroid of facet {f} in cell {c}");
        }
        Ok(())
    })
}

pub(super) fn centroid(input: &Input, facet: usize, points: &Points) -> super::points::Hom {
    let ids: Vec<usize> = input.cells.facet(facet).into_iter().filter(|&v| v != super::cells::NONE).collect();
    points.mean(&input.points(&ids), &vec![BigInt::from(1); ids.len()])
}
