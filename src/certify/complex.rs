//! The tets of a shell under one vertex order, and what a lift needs to know of their neighbourhood.

use std::ops::Range;

use rayon::prelude::*;
use rustc_hash::FxHashSet;

use crate::mesh::connectivity::{Connectivity, Side};
use crate::predicate::{StageCounts, orient3d_staged};
use crate::shell::{Layer, Name, Shell, Tet};

/// Edges and vertices on the boundary of an oriented manifold of triangles.
#[derive(Debug, Default)]
pub(crate) struct Boundary {
    edges: FxHashSet<[u32; 2]>,
    vertices: FxHashSet<u32>,
}

impl Boundary {
    pub(crate) fn new(connectivity: &Connectivity) -> Self {
        let mut out = Self::default();
        for side in connectivity.boundary() {
            let [a, b] = connectivity.ends(side);
            out.edges.insert([a.min(b), a.max(b)]);
            out.vertices.extend([a, b]);
        }
        out
    }

    /// Do the vertices (any number, repeated ones allowed) lie in one boundary edge?
    pub(crate) fn holds(&self, ids: impl IntoIterator<Item = u32>) -> bool {
        // A closed surface has none; it is asked for every side of every piece.
        if self.edges.is_empty() {
            return false;
        }
        let mut ends = [None; 2];
        for id in ids {
            match ends {
                [None, _] => ends[0] = Some(id),
                [Some(u), _] if u == id => {}
                [_, None] => ends[1] = Some(id),
                [_, Some(w)] if w == id => {}
                _ => return false,
            }
        }
        match ends {
            [Some(v), None] => self.vertices.contains(&v),
            [Some(u), Some(w)] => self.edges.contains(&[u.min(w), u.max(w)]),
            _ => false,
        }
    }
}

/// Tets that one core looks at.
const SHARE: usize = 1 << 12;

/// `S_<`: the tets that one vertex order selects, indexed by the names that they hold.
#[derive(Debug)]
pub(crate) struct TetComplex<'a> {
    pub(crate) shell: &'a Shell,
    pub(crate) tets: Vec<Tet>,
    /// The middle complex.
    pub(crate) middle: &'a Connectivity,
    pub(crate) boundary: &'a Boundary,
    /// Tets by name, as ranges of `by_name`; name `3 v + layer`.
    starts: Vec<u32>,
    by_name: Vec<u32>,
    /// The first tet of each prism, and their number.
    first: Vec<u32>,
    pinched: Vec<bool>,
}

fn code(name: Name) -> usize {
    3 * name.vertex as usize
        + match name.layer {
            Layer::Bottom => 0,
            Layer::Middle => 1,
            Layer::Top => 2,
        }
}

impl<'a> TetComplex<'a> {
    /// Builds the complex for the order `rank[v]`. Linear time and memory.
    pub(crate) fn new(
        shell: &'a Shell,
        middle: &'a Connectivity,
        boundary: &'a Boundary,
        ranks: &[u32],
    ) -> Self {
        let prisms = u32::try_from(shell.faces.len()).unwrap_or(u32::MAX);
        let rank = |v: u32| ranks.get(v as usize).copied().unwrap_or(v);
        let tets: Vec<Tet> =
            (0..prisms).into_par_iter().flat_map_iter(|p| shell.tets_of_order(p, rank)).collect();
        let mut starts = vec![0u32; 3 * shell.middle.len() + 1];
        for name in tets.iter().flat_map(|t| t.names) {
            starts[code(name) + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut fill = starts.clone();
        let mut by_name = vec![0u32; 4 * tets.len()];
        for (id, tet) in tets.iter().enumerate() {
            for name in tet.names {
                let slot = &mut fill[code(name)];
                by_name[*slot as usize] = u32::try_from(id).unwrap_or(u32::MAX);
                *slot += 1;
            }
        }
        let mut first = vec![0u32; shell.faces.len() + 1];
        tets.iter().for_each(|tet| first[tet.prism as usize + 1] += 1);
        for i in 1..first.len() {
            first[i] += first[i - 1];
        }
        let pinched = (0..shell.middle.len()).map(|v| shell.is_pinched(v as u32)).collect();
        Self { shell, tets, middle, boundary, starts, by_name, first, pinched }
    }

    /// The four points of a tet, in its positive order.
    pub(crate) fn points(&self, tet: u32) -> [&'a [f64; 3]; 4] {
        self.tets[tet as usize].names.map(|n| self.shell.position(n))
    }

    /// The tets that hold `name`, ascending.
    pub(crate) fn with_name(&self, name: Name) -> &[u32] {
        let c = code(name);
        &self.by_name[self.starts[c] as usize..self.starts[c + 1] as usize]
    }

    /// The tets that hold all the names (at least one), ascending.
    pub(crate) fn star<'s>(&'s self, names: &'s [Name]) -> impl Iterator<Item = u32> + 's {
        let shortest = names.iter().map(|&n| self.with_name(n)).min_by_key(|list| list.len());
        let holds_all = |&t: &u32| names.iter().all(|n| self.tets[t as usize].names.contains(n));
        shortest.unwrap_or(&[]).iter().copied().filter(holds_all)
    }

    /// The tets that hold all the names, which are names of `tet`, ascending: [`star`](Self::star) without a search where they
    /// are three or four, as three lie in one prism or in two that share a wall.
    pub(crate) fn around<'s>(&'s self, tet: u32, names: &'s [Name]) -> impl Iterator<Item = u32> + 's {
        let holds_all = |&t: &u32| names.iter().all(|n| self.tets[t as usize].names.contains(n));
        let (listed, prisms) = match names {
            [_, _, _, _] => (None, [tet..tet + 1, 0..0]),
            [_, _, _] => (None, self.prisms_with(self.tets[tet as usize].prism, names)),
            _ => (Some(self.star(names)), [0..0, 0..0]),
        };
        let of_prisms = prisms.into_iter().flatten().filter(holds_all);
        listed.into_iter().flatten().chain(of_prisms)
    }

    /// The tets of `prism`, and where the names have only two vertices those of the prism across, in the order of prisms.
    fn prisms_with(&self, prism: u32, names: &[Name]) -> [Range<u32>; 2] {
        let face = self.shell.faces[prism as usize];
        let tets = |p: u32| self.first[p as usize]..self.first[p as usize + 1];
        let missing = (0..3u32).find(|&i| names.iter().all(|n| n.vertex != face[i as usize]));
        match missing.and_then(|i| self.middle.mate(Side::new(prism, i))).map(Side::face) {
            None => [tets(prism), 0..0],
            Some(other) => [tets(prism.min(other)), tets(prism.max(other))],
        }
    }

    pub(crate) fn is_pinched(&self, vertex: u32) -> bool {
        self.pinched.get(vertex as usize).copied().unwrap_or(false)
    }

    /// Do the names lie within the bottom or within the top of the shell (rule R2.4)? A pinched vertex counts as
    /// both; alone it is allowed.
    pub(crate) fn in_cap(&self, names: &[Name]) -> bool {
        let within = |layer| names.iter().all(|n| n.layer == layer || self.is_pinched(n.vertex));
        let lone_pinch = matches!(names, [n] if self.is_pinched(n.vertex));
        !lone_pinch && (within(Layer::Bottom) || within(Layer::Top))
    }

    /// Do the names lie in a wall on the boundary of the shell?
    pub(crate) fn in_boundary_wall(&self, names: &[Name]) -> bool {
        self.boundary.holds(names.iter().map(|n| n.vertex))
    }

    /// The first tet that is not positive. Counts the tets up to it, whatever other threads have looked at beyond.
    pub(crate) fn first_not_positive(&self, stages: &mut StageCounts) -> Option<u32> {
        let first_of = |tets: &[Tet]| {
            let mut counts = StageCounts::default();
            let bad = |tet: &Tet| {
                let [a, b, c, d] = tet.names.map(|n| self.shell.position(n));
                !counts.note(orient3d_staged(a, b, c, d)).is_positive()
            };
            (tets.iter().position(bad), counts)
        };
        let parts: Vec<_> = self.tets.par_chunks(SHARE).map(first_of).collect();
        for (k, (first, counts)) in parts.into_iter().enumerate() {
            *stages += counts;
            if let Some(i) = first {
                return u32::try_from(k * SHARE + i).ok();
            }
        }
        None
    }
}

/// A mesh as the certifier uses it.
#[derive(Debug)]
pub(crate) struct MeshView<'a> {
    pub(crate) vertices: &'a [[f64; 3]],
    pub(crate) faces: &'a [[u32; 3]],
    pub(crate) connectivity: &'a Connectivity,
    pub(crate) boundary: &'a Boundary,
}

impl<'a> MeshView<'a> {
    /// The corners of a triangle.
    pub(crate) fn points(&self, f: u32) -> [&'a [f64; 3]; 3] {
        self.faces[f as usize].map(|v| &self.vertices[v as usize])
    }

    /// The triangle across side `i` (opposite corner `i`).
    pub(crate) fn across(&self, f: u32, side: u32) -> Option<u32> {
        self.connectivity.mate(Side::new(f, side)).map(Side::face)
    }
}
