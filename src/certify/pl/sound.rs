//! Is a complex a compact oriented manifold (*sound* in `certs/MESHES.md`)? Positions play no part.

use super::facets::{Facets, NONE};
use super::witness::Witness;
use crate::mesh::connectivity::Sets;

/// One reason of the first kind for which a complex is not sound, or `None`. O(M log M).
pub(in crate::certify) fn defect(facets: &Facets<'_>, vertices: usize) -> Option<Witness> {
    repeated(facets)
        .or_else(|| twin(facets))
        .or_else(|| crowded(facets))
        .or_else(|| loose_vertex(facets, vertices))
        .or_else(
            || if facets.k() == 4 { loose_edge(facets).or_else(|| link(facets, vertices)) } else { None },
        )
}

/// A cell's vertices, ascending.
fn sorted(facets: &Facets<'_>, cell: u32) -> Vec<u32> {
    let mut v = facets.cells.cell(cell as usize).to_vec();
    v.sort_unstable();
    v
}

fn repeated(facets: &Facets<'_>) -> Option<Witness> {
    let mut cells = 0..facets.cells.len() as u32;
    cells.find(|&c| sorted(facets, c).windows(2).any(|w| w[0] == w[1])).map(Witness::Repeated)
}

fn twin(facets: &Facets<'_>) -> Option<Witness> {
    let mut all: Vec<(Vec<u32>, u32)> =
        (0..facets.cells.len() as u32).map(|c| (sorted(facets, c), c)).collect();
    all.sort_unstable();
    all.windows(2).find(|w| w[0].0 == w[1].0).map(|w| Witness::Twin([w[0].1, w[1].1]))
}

/// A facet of three cells, or of two cells the same way round.
fn crowded(facets: &Facets<'_>) -> Option<Witness> {
    facets.groups().find_map(|group| match group {
        [(key, f), (_, g), (_, h), ..] => {
            let ids = key.iter().copied().filter(|&v| v != NONE).collect();
            Some(Witness::Facet(ids, [*f, *g, *h].map(|x| facets.cell(x))))
        }
        [(_, f), (_, g)] if facets.same_way(*f, *g) => {
            Some(Witness::Direction([*f, *g].map(|x| facets.cell(x))))
        }
        _ => None,
    })
}

/// Where a vertex stands in a cell that has it.
fn place(facets: &Facets<'_>, cell: u32, vertex: u32) -> usize {
    facets.cells.cell(cell as usize).iter().position(|&v| v == vertex).unwrap_or(0)
}

fn loose_vertex(facets: &Facets<'_>, vertices: usize) -> Option<Witness> {
    let k = facets.k();
    let corner = |cell: u32, v: u32| cell * k as u32 + place(facets, cell, v) as u32;
    let mut parts = Sets::new(facets.cells.len() * k);
    for group in facets.groups().filter(|g| g.len() == 2) {
        let [c, d] = [group[0].1, group[1].1].map(|f| facets.cell(f));
        for v in facets.vertices(group[0].1) {
            parts.join(corner(c, v), corner(d, v));
        }
    }
    let mut first: Vec<Option<u32>> = vec![None; vertices];
    for (i, &v) in facets.cells.flat().iter().enumerate() {
        let root = parts.find(i as u32);
        let known = *first[v as usize].get_or_insert(root);
        if known != root {
            // The root is the smallest corner of its fan: its cell comes first.
            return Some(Witness::Vertex(v, [known / k as u32, i as u32 / k as u32]));
        }
    }
    None
}

/// The edges of a tet, as corners.
const EDGES: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

fn edge(facets: &Facets<'_>, cell: u32, i: usize) -> [u32; 2] {
    let v = facets.cells.cell(cell as usize);
    let [p, q] = EDGES[i].map(|k| v[k]);
    [p.min(q), p.max(q)]
}

/// Every edge of every tet, sorted: its vertices and `6 * tet + i`.
fn edges(facets: &Facets<'_>) -> Vec<([u32; 2], u32)> {
    let tets = 0..facets.cells.len() as u32;
    let mut all: Vec<_> = tets
        .flat_map(|c| (0..6).map(move |i| (c, i)))
        .map(|(c, i)| (edge(facets, c, i), 6 * c + i as u32))
        .collect();
    all.sort_unstable();
    all
}

fn loose_edge(facets: &Facets<'_>) -> Option<Witness> {
    let mut parts = Sets::new(6 * facets.cells.len());
    for group in facets.groups().filter(|g| g.len() == 2) {
        let [c, d] = [group[0].1, group[1].1].map(|f| facets.cell(f));
        for i in 0..6 {
            let here = edge(facets, c, i);
            let held = here.iter().all(|v| group[0].0.contains(v));
            let there = (0..6).find(|&j| edge(facets, d, j) == here).filter(|_| held);
            if let Some(j) = there {
                parts.join(6 * c + i as u32, 6 * d + j as u32);
            }
        }
    }
    edges(facets).windows(2).find_map(|w| {
        let loose = w[0].0 == w[1].0 && parts.find(w[0].1) != parts.find(w[1].1);
        loose.then(|| Witness::Edge(w[0].0, [w[0].1 / 6, w[1].1 / 6]))
    })
}

/// A vertex whose link has not the Euler characteristic of a disc or sphere.
fn link(facets: &Facets<'_>, vertices: usize) -> Option<Witness> {
    let mut euler = vec![0_i64; vertices];
    let mut open = vec![false; vertices];
    let mut used = vec![false; vertices];
    for &v in facets.cells.flat() {
        euler[v as usize] += 1;
        used[v as usize] = true;
    }
    for group in facets.groups() {
        for v in group[0].0 {
            euler[v as usize] -= 1;
            open[v as usize] |= group.len() == 1;
        }
    }
    for group in edges(facets).chunk_by(|a, b| a.0 == b.0) {
        for v in group[0].0 {
            euler[v as usize] += 1;
        }
    }
    let wrong = (0..vertices).find(|&v| used[v] && euler[v] != if open[v] { 1 } else { 2 });
    wrong.map(|v| Witness::Link(v as u32))
}
