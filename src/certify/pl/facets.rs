//! Facets of cells, and what hangs together across them: from indices alone.

use crate::mesh::Cells;
use crate::mesh::connectivity::Sets;

/// The corners of a facet in ascending order; edges have [`NONE`] as the third.
pub(in crate::certify) type Key = [u32; 3];

/// No vertex.
pub(in crate::certify) const NONE: u32 = u32::MAX;

/// Facets as corners of their cell, in orientation order.
const OF_TRIANGLE: [[usize; 2]; 3] = [[1, 2], [2, 0], [0, 1]];
const OF_TET: [[usize; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// All facets of a list of cells, sorted by their vertices. Facet `k` of cell `c` has the number `K c + k`.
pub(in crate::certify) struct Facets<'a> {
    pub(in crate::certify) cells: &'a Cells,
    sorted: Vec<(Key, u32)>,
}

impl<'a> Facets<'a> {
    /// The caller has checked that `6 M` fits `u32`. O(M log M).
    pub(in crate::certify) fn new(cells: &'a Cells) -> Self {
        let k = cells.corners();
        let count = u32::try_from(cells.len() * k).unwrap_or(u32::MAX);
        let mut facets = Self { cells, sorted: Vec::new() };
        facets.sorted = (0..count).map(|f| (facets.key(f), f)).collect();
        facets.sorted.sort_unstable();
        facets
    }

    /// Corners of a cell.
    pub(in crate::certify) fn k(&self) -> usize {
        self.cells.corners()
    }

    /// The cell of a facet.
    pub(in crate::certify) fn cell(&self, facet: u32) -> u32 {
        facet / self.k() as u32
    }

    /// The positions of a facet's corners in its cell.
    pub(in crate::certify) fn places(&self, facet: u32) -> &'static [usize] {
        let at = facet as usize % self.k();
        if self.k() == 3 { &OF_TRIANGLE[at] } else { &OF_TET[at] }
    }

    /// The vertices of a facet, in orientation order.
    pub(in crate::certify) fn vertices(&self, facet: u32) -> Vec<u32> {
        let cell = self.cells.cell(self.cell(facet) as usize);
        self.places(facet).iter().map(|&i| cell[i]).collect()
    }

    pub(in crate::certify) fn key(&self, facet: u32) -> Key {
        let mut key = [NONE; 3];
        for (k, v) in key.iter_mut().zip(self.vertices(facet)) {
            *k = v;
        }
        key.sort_unstable();
        key
    }

    /// Facets with the same vertices, ascending.
    pub(in crate::certify) fn groups(&self) -> impl Iterator<Item = &[(Key, u32)]> {
        self.sorted.chunk_by(|a, b| a.0 == b.0)
    }

    /// Do two facets with the same vertices run the same way round?
    pub(in crate::certify) fn same_way(&self, f: u32, g: u32) -> bool {
        let (f, g) = (self.vertices(f), self.vertices(g));
        let shift = g.iter().position(|v| f.first() == Some(v)).unwrap_or(0);
        f.iter().enumerate().all(|(i, v)| g[(i + shift) % g.len()] == *v) && (f.len() == 3 || shift == 0)
    }

    /// Facets of one cell only, ascending.
    pub(in crate::certify) fn boundary(&self) -> Vec<u32> {
        let mut out: Vec<u32> = self.groups().filter(|g| g.len() == 1).map(|g| g[0].1).collect();
        out.sort_unstable();
        out
    }

    /// The smallest cell of each cell's component.
    pub(in crate::certify) fn components(&self) -> Vec<u32> {
        let mut parts = Sets::new(self.cells.len());
        for group in self.groups() {
            for pair in group.windows(2) {
                parts.join(self.cell(pair[0].1), self.cell(pair[1].1));
            }
        }
        (0..self.cells.len() as u32).map(|c| parts.find(c)).collect()
    }

    /// The smallest facet of every boundary component: facets joined at vertices (triangles) or edges (tets).
    pub(in crate::certify) fn boundary_roots(&self, boundary: &[u32]) -> Vec<u32> {
        let mut joints: Vec<([u32; 2], u32)> = Vec::new();
        for (i, &facet) in boundary.iter().enumerate() {
            let v = self.vertices(facet);
            match v[..] {
                [a, b] => joints.extend([([a, NONE], i as u32), ([b, NONE], i as u32)]),
                [a, b, c] => {
                    joints.extend([[a, b], [b, c], [c, a]].map(|[p, q]| ([p.min(q), p.max(q)], i as u32)));
                }
                _ => {}
            }
        }
        joints.sort_unstable();
        let mut parts = Sets::new(boundary.len());
        for pair in joints.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            parts.join(pair[0].1, pair[1].1);
        }
        (0..boundary.len() as u32).filter(|&i| parts.find(i) == i).map(|i| boundary[i as usize]).collect()
    }
}
