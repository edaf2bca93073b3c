//! Complexes of triangles or tets: facets, neighbours, components, and the conditions of MESHES section 1.

use crate::complex::{classes, distinct};
use crate::{Map, Res, Set, each};

/// Vertices of a facet. One of two vertices ends with `NONE`.
pub(super) type Facet = [usize; 3];

pub(super) const NONE: usize = usize::MAX;

pub(super) struct Cells {
    /// 3 or 4 corners a cell.
    pub(super) k: usize,
    /// All corners, cell by cell.
    pub(super) corners: Vec<usize>,
    pub(super) vertices: usize,
}

/// The first of its rotations: the same for facets that are the same way round.
pub(super) fn turned([a, b, c]: Facet) -> Facet {
    [a, b, c].min([b, c, a]).min([c, a, b])
}

pub(super) fn reverse([a, b, c]: Facet) -> Facet {
    if c == NONE { [b, a, NONE] } else { [c, b, a] }
}

/// The different vertices, ascending, filled up with `NONE`.
fn set(facet: Facet) -> Facet {
    let [a, b, c] = facet;
    let mut set = [a, if a == b { NONE } else { b }, if a == c || b == c { NONE } else { c }];
    set.sort_unstable();
    set
}

/// What a sound complex is asked for.
pub(super) struct Structure {
    /// The cell's component, numbered by smallest cell.
    pub(super) part: Vec<usize>,
    pub(super) parts: usize,
    /// Boundary facets, ascending, and the part of the boundary that each is in, numbered by smallest facet.
    pub(super) rim: Vec<(usize, usize)>,
    pub(super) loops: usize,
}

impl Cells {
    pub(super) fn len(&self) -> usize {
        self.corners.len() / self.k
    }

    pub(super) fn cell(&self, c: usize) -> &[usize] {
        &self.corners[self.k * c..self.k * (c + 1)]
    }

    pub(super) fn triangle(&self, c: usize) -> Facet {
        let cell = self.cell(c);
        [cell[0], cell[1], cell[2]]
    }

    /// A facet as its cell orients it.
    pub(super) fn facet(&self, f: usize) -> Facet {
        match (self.cell(f / self.k), f % self.k) {
            (&[_, b, c], 0) => [b, c, NONE],
            (&[a, _, c], 1) => [c, a, NONE],
            (&[a, b, _], _) => [a, b, NONE],
            (&[_, b, c, d], 0) => [b, c, d],
            (&[a, _, c, d], 1) => [a, d, c],
            (&[a, b, _, d], 2) => [a, b, d],
            (&[a, b, c, _], _) => [a, c, b],
            _ => [NONE; 3],
        }
    }

    pub(super) fn facets(&self, c: usize) -> impl Iterator<Item = usize> {
        self.k * c..self.k * (c + 1)
    }

    /// The cells with all of these vertices.
    pub(super) fn with<'a>(&'a self, ids: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        (0..self.len()).filter(|&c| self.has(c, ids))
    }

    pub(super) fn has(&self, c: usize, ids: &[usize]) -> bool {
        ids.iter().all(|id| self.cell(c).contains(id))
    }

    /// The class of each of these cells, connected where they share the vertex set of a facet that has all of `ids`.
    pub(super) fn around(&self, cells: &[usize], ids: &[usize]) -> Vec<u32> {
        let mut sets = Vec::new();
        for (at, &c) in cells.iter().enumerate() {
            let facets = self.facets(c).map(|f| set(self.facet(f)));
            sets.extend(facets.filter(|s| ids.iter().all(|id| s.contains(id))).map(|s| (s, at)));
        }
        sets.sort_unstable();
        let shared = sets.windows(2).filter(|w| w[0].0 == w[1].0).map(|w| (w[0].1, w[1].1));
        classes(cells.len(), shared)
    }

    /// Whether the link of `v`, whose tets are given, is a disc or a sphere as far as its Euler characteristic says.
    pub(super) fn round_link(&self, v: usize, tets: &[usize]) -> bool {
        let ends = distinct(tets.iter().flat_map(|&c| self.cell(c).iter().copied()).filter(|&u| u != v));
        let mut sets = Vec::new();
        for &c in tets {
            let mut own: Vec<_> =
                self.facets(c).map(|f| set(self.facet(f))).filter(|s| s.contains(&v)).collect();
            own.sort_unstable();
            own.dedup();
            sets.extend(own);
        }
        sets.sort_unstable();
        let runs: Vec<usize> = sets.chunk_by(|a, b| a == b).map(<[Facet]>::len).collect();
        let has_boundary = runs.contains(&1);
        ends.len() + tets.len() == runs.len() + if has_boundary { 1 } else { 2 }
    }

    /// For cells that share a facet's vertex set: two facets with it.
    fn shared(&self) -> Vec<(usize, usize)> {
        let mut first = Map::default();
        let facets = 0..self.corners.len();
        facets
            .filter_map(|f| Some((*first.entry(set(self.facet(f))).or_insert(f), f)).filter(|p| p.0 != p.1))
            .collect()
    }

    /// The smallest cell of each cell's component.
    pub(super) fn components(&self) -> Vec<u32> {
        classes(self.len(), self.shared().into_iter().map(|(f, g)| (f / self.k, g / self.k)))
    }

    /// Checks the conditions that need no coordinates.
    pub(super) fn sound(&self) -> Res<Structure> {
        let code = "mesh-conditions";
        ensure!(self.len() > 0, code, "no cell");
        let (mut sets, mut ways) = (Set::default(), Set::default());
        for c in 0..self.len() {
            let ids = distinct(self.cell(c).iter().copied());
            ensure!(ids.len() == self.k, code, "cell {c} repeats a vertex");
            ensure!(sets.insert(ids), code, "cell {c} has the vertices of an earlier one");
            for f in self.facets(c) {
                let new = ways.insert(turned(self.facet(f)));
                ensure!(new, code, "cell {c}: a facet is the same way round as another one");
            }
        }
        let mut stars: Vec<_> = self.corners.iter().enumerate().map(|(at, &v)| (v, at / self.k)).collect();
        stars.sort_unstable();
        let stars: Vec<_> = stars.chunk_by(|a, b| a.0 == b.0).collect();
        each(stars.len(), |at| {
            let star: Vec<usize> = stars[at].iter().map(|s| s.1).collect();
            self.round(stars[at][0].0, &star)
        })?;
        let parts = numbered(&self.components());
        let rim: Vec<usize> =
            (0..self.corners.len()).filter(|&f| !ways.contains(&turned(reverse(self.facet(f))))).collect();
        let rim_parts = numbered(&self.rim_classes(&rim));
        Ok(Structure {
            parts: parts.1,
            part: parts.0,
            rim: rim.into_iter().zip(rim_parts.0).collect(),
            loops: rim_parts.1,
        })
    }

    /// The conditions at a vertex with its cells.
    fn round(&self, v: usize, star: &[usize]) -> Res {
        let connected = |cells: &[usize], ids: &[usize]| self.around(cells, ids).iter().all(|&c| c == 0);
        ensure!(
            connected(star, &[v]),
            "mesh-conditions",
            "the cells at vertex {v} are not connected around it"
        );
        if self.k == 4 {
            let ends = star.iter().flat_map(|&c| self.cell(c).iter().map(move |&u| (u, c)));
            let mut ends: Vec<_> = ends.filter(|end| end.0 > v).collect();
            ends.sort_unstable();
            for edge in ends.chunk_by(|a, b| a.0 == b.0) {
                let (u, cells) = (edge[0].0, edge.iter().map(|end| end.1).collect::<Vec<_>>());
                ensure!(
                    connected(&cells, &[v, u]),
                    "mesh-conditions",
                    "the tets at {v} {u} are not connected around it"
                );
            }
            ensure!(
                self.round_link(v, star),
                "mesh-conditions",
                "the link of vertex {v} is no disc or sphere"
            );
        }
        Ok(())
    }

    /// Classes of boundary facets that share a vertex (of tets: an edge).
    fn rim_classes(&self, rim: &[usize]) -> Vec<u32> {
        let mut first = Map::default();
        let mut pairs = Vec::new();
        for (at, &f) in rim.iter().enumerate() {
            let [a, b, c] = set(self.facet(f));
            let faces = if c == NONE { [[a, a], [b, b], [b, b]] } else { [[a, b], [a, c], [b, c]] };
            pairs.extend(faces.map(|face| (*first.entry(face).or_insert(at), at)));
        }
        classes(rim.len(), pairs.into_iter())
    }
}

/// Classes given by their smallest members, numbered in this order, and how many there are.
fn numbered(classes: &[u32]) -> (Vec<usize>, usize) {
    let classes = || classes.iter().map(|&c| c as usize);
    let smallest = distinct(classes());
    (classes().map(|c| smallest.binary_search(&c).unwrap_or(0)).collect(), smallest.len())
}
