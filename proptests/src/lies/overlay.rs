//! Is an overlay what it says: polygons that tile the mesh and, projected, the middle surface?

use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};

use dashu_int::IBig;
use dashu_ratio::RBig;

use super::text::{ids, names, number};
use super::{Flaw, Judge, Judged, holds};
use crate::oracle::exact::{Weights, overlap, positive};
use crate::oracle::tets::Code;
use crate::oracle::{World, components, fan_area};

/// Mesh vertices and names.
type Carrier = (Vec<u32>, Vec<Code>);

/// All pairs of carriers whose hulls meet in one point inside both: the supports of the corners of all intersections of
/// a triangle with a tet. (A point is a corner of the intersection of two simplices exactly if the hulls of the smallest
/// faces that hold it meet there alone.)
pub(super) struct Carriers {
    points: BTreeMap<Carrier, (Weights, Weights)>,
    tets: Vec<(usize, Vec<Code>)>,
    positive: bool,
}

impl Carriers {
    pub(super) fn new(world: &World<'_>, selected: &[usize]) -> Self {
        let positive = selected.iter().all(|&t| positive(&world.determinants[t]));
        let tets = selected.iter().map(|&t| {
            let tet = &world.tets.all[t];
            (tet.prism, super::sorted(tet.names))
        });
        let mut out = Self { points: BTreeMap::new(), tets: tets.collect(), positive };
        if !positive {
            return out;
        }
        for (f, face) in world.mesh.faces.iter().enumerate() {
            for &t in selected {
                for (on_face, in_tet) in world.meet(f, t) {
                    let (ids, weights) = support(face, &on_face);
                    let (names, coordinates) = support(&world.tets.all[t].names, &in_tet);
                    out.points.insert((ids, names), (weights, coordinates));
                }
            }
        }
        out
    }
}

/// The vertices with positive weight, ascending, and these weights.
pub(super) fn support(vertices: &[u32], weights: &Weights) -> (Vec<u32>, Weights) {
    let mut both: Vec<(u32, IBig)> = vertices.iter().copied().zip(weights.iter().cloned()).collect();
    both.retain(|(_, w)| *w != IBig::ZERO);
    both.sort();
    both.into_iter().unzip()
}

/// The weight of each of the corners.
fn row<const N: usize>(corners: &[u32; N], all: &[(u32, IBig)]) -> Weights {
    corners.map(|v| all.iter().filter(|x| x.0 == v).map(|x| x.1.clone()).sum()).to_vec()
}

/// A vertex of the overlay: carriers, weights by mesh vertex, weights by shell vertex.
struct Corner {
    carrier: Carrier,
    on: [Vec<(u32, IBig)>; 2],
}

struct Cell {
    corners: Vec<usize>,
    /// Mesh triangle, prism.
    of: [usize; 2],
}

pub(super) fn judge(judge: &Judge<'_>, carriers: &Carriers, lines: &[Vec<&str>]) -> Judged {
    holds(carriers.positive, "a tet of the order is not positive")?;
    let of = |word: &str| lines.iter().filter(|l| l[0] == word).map(|l| &l[1..]).collect::<Vec<_>>();
    let (vertices, cells, named) = (of("v"), of("c"), of("d"));
    if vertices.len() + cells.len() + named.len() != lines.len() {
        return Err(Flaw::Unreadable);
    }
    let corners: Vec<Corner> = vertices.into_iter().map(|l| corner(carriers, l)).collect::<Result<_, _>>()?;
    holds(!corners.iter().any(|c| judge.cap(&c.carrier.1)), "a corner on a cap")?;
    let distinct: BTreeSet<&Carrier> = corners.iter().map(|c| &c.carrier).collect();
    holds(distinct.len() == corners.len(), "a corner twice")?;
    let cells: Vec<Cell> =
        cells.into_iter().map(|l| cell(judge, carriers, &corners, l)).collect::<Result<_, _>>()?;
    closed(judge, &corners, &cells)?;
    for which in 0..2 {
        tiling(judge, which, &corners, &cells)?;
    }
    degree_lines(judge, &cells, &named)
}

fn corner(carriers: &Carriers, line: &[&str]) -> Result<Corner, Flaw> {
    let [mesh, shell] = line else { return Err(Flaw::Unreadable) };
    let carrier = (ids(mesh)?, names(shell)?);
    let found = carriers.points.get(&carrier);
    let (weights, coordinates) = found.ok_or(Flaw::False("carriers that meet in no point"))?;
    let mesh = carrier.0.iter().copied().zip(weights.iter().cloned()).collect();
    let middle = carrier.1.iter().map(|c| c / 3).zip(coordinates.iter().cloned()).collect();
    Ok(Corner { carrier, on: [mesh, middle] })
}

fn cell(judge: &Judge<'_>, carriers: &Carriers, corners: &[Corner], line: &[&str]) -> Result<Cell, Flaw> {
    let list: Vec<usize> = line.iter().map(|w| number(w)).collect::<Result<_, _>>()?;
    let distinct: BTreeSet<usize> = list.iter().copied().collect();
    if list.len() < 3 || distinct.len() != list.len() || list.iter().any(|&i| i >= corners.len()) {
        return Err(Flaw::Unreadable);
    }
    let union =
        |k: usize| list.iter().flat_map(|&i| corners[i].on[k].iter().map(|x| x.0)).collect::<BTreeSet<_>>();
    let find = |faces: &[[u32; 3]], ids: BTreeSet<u32>| {
        faces.iter().position(|f| f.iter().copied().collect::<BTreeSet<_>>() == ids)
    };
    let face = find(&judge.case.mesh.faces, union(0)).ok_or(Flaw::False("a cell in no triangle"))?;
    let prism = find(&judge.case.shell.faces, union(1)).ok_or(Flaw::False("a cell in no prism"))?;
    let names: BTreeSet<Code> = list.iter().flat_map(|&i| corners[i].carrier.1.iter().copied()).collect();
    let in_tet =
        |(p, tet): &(usize, Vec<Code>)| *p == prism && names.iter().all(|n| tet.binary_search(n).is_ok());
    holds(carriers.tets.iter().any(in_tet), "a cell in no tet")?;
    Ok(Cell { corners: list, of: [face, prism] })
}

/// Every side is a side of another cell the other way round, or lies in both boundaries; no cap, no idle corner.
fn closed(judge: &Judge<'_>, corners: &[Corner], cells: &[Cell]) -> Judged {
    let mut sides: HashSet<(usize, usize)> = HashSet::new();
    for cell in cells {
        let n = cell.corners.len();
        for i in 0..n {
            let side = (cell.corners[i], cell.corners[(i + 1) % n]);
            holds(sides.insert(side), "a side twice")?;
            let names: BTreeSet<Code> =
                [side.0, side.1].iter().flat_map(|&c| corners[c].carrier.1.iter().copied()).collect();
            let names: Vec<Code> = names.into_iter().collect();
            holds(!judge.cap(&names), "a side in a cap")?;
        }
    }
    for &(a, b) in sides.iter().filter(|(a, b)| !sides.contains(&(*b, *a))) {
        for which in 0..2 {
            let ids: Vec<u32> =
                [a, b].iter().flat_map(|&c| corners[c].on[which].iter().map(|x| x.0)).collect();
            holds(judge.on_boundary(which, &ids), "a hole")?;
        }
    }
    let used: HashSet<usize> = cells.iter().flat_map(|c| c.corners.iter().copied()).collect();
    holds(used.len() == corners.len(), "a corner of no cell")
}

/// On each triangle of the mesh (0) or of the middle complex (1): positive areas that sum to one, and no overlap.
fn tiling(judge: &Judge<'_>, which: usize, corners: &[Corner], cells: &[Cell]) -> Judged {
    let faces = [&judge.case.mesh.faces, &judge.case.shell.faces][which];
    let mut fans: HashMap<usize, Vec<[Weights; 3]>> = HashMap::new();
    for cell in cells {
        let face = &faces[cell.of[which]];
        let at = |i: usize| row(face, &corners[cell.corners[i]].on[which]);
        let fan = (1..cell.corners.len() - 1).map(|i| [at(0), at(i), at(i + 1)]);
        fans.entry(cell.of[which]).or_default().extend(fan);
    }
    for face in 0..faces.len() {
        let pieces = fans.get(&face).map_or(&[][..], Vec::as_slice);
        let areas: Vec<RBig> = pieces.iter().map(|p| fan_area(p)).collect();
        holds(areas.iter().all(|a| *a > RBig::ZERO), "a piece turned over")?;
        holds(
            areas.into_iter().fold(RBig::ZERO, |sum, a| sum + a) == RBig::ONE,
            "pieces that do not cover a triangle once",
        )?;
        let apart = |(i, p): (usize, &[Weights; 3])| pieces[..i].iter().all(|q| overlap(p, q).len() < 3);
        holds(pieces.iter().enumerate().all(apart), "pieces that overlap")?;
    }
    Ok(())
}

/// One line for each component, of a cell that lies in it.
fn degree_lines(judge: &Judge<'_>, cells: &[Cell], lines: &[&[&str]]) -> Judged {
    for (which, word) in ["mesh", "middle"].into_iter().enumerate() {
        let faces = [&judge.case.mesh.faces, &judge.case.shell.faces][which];
        let parts = components(faces);
        let mut found = Vec::new();
        for line in lines.iter().filter(|l| l.first() == Some(&word)) {
            let [_, cell, fan] = line else { return Err(Flaw::Unreadable) };
            let (cell, fan): (usize, usize) = (number(cell)?, number(fan)?);
            let cell = cells.get(cell).filter(|c| fan + 2 < c.corners.len()).ok_or(Flaw::Unreadable)?;
            found.push(parts[cell.of[which]]);
        }
        let wanted: Vec<usize> = (0..=parts.iter().copied().max().unwrap_or(0)).collect();
        holds(found == wanted, "a component's cell is not named")?;
    }
    Ok(())
}
