//! Tracked triangles: for a mesh that intersects itself (*Shell* section 6) a prism is judged only against the part of
//! the surface that runs through it, not against other sheets that cross it.
//!
//! Each prism keeps a list of mesh triangles: at least all those of which a lifted piece touches one of its 24 tets.
//! An operation leaves the walls around the prisms that it replaces as they are, so that the pieces between them stay
//! the same: the new prisms' lists come from the union of the old ones.

use std::sync::Arc;

use super::prism::Prism;
use super::tree::Box3;
use crate::mesh::{Connectivity, TriMesh};
use crate::predicate::triangle_tet;
use crate::shell::Slab;

/// The lists of all prisms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Tracked {
    lists: Vec<Vec<u32>>,
    triangles: Arc<Vec<[[f64; 3]; 3]>>,
}

impl Tracked {
    /// Of an initial shell, whose prism `i` lies on the mesh triangle `origin[i]`: the triangles that share a vertex
    /// with that one and meet the prism.
    pub(crate) fn new(
        mesh: &TriMesh,
        connectivity: &Connectivity,
        origin: &[u32],
        prism: impl Fn(usize) -> Prism,
    ) -> Self {
        let triangles = mesh.faces.iter().map(|f| f.map(|v| mesh.vertices[v as usize])).collect();
        let mut out = Self { lists: vec![Vec::new(); origin.len()], triangles: Arc::new(triangles) };
        for (i, &f) in origin.iter().enumerate() {
            let around = around(mesh, connectivity, f);
            out.set(i, &prism(i), &around);
        }
        out
    }

    /// The triangles that one of these prisms tracks, ascending.
    pub(crate) fn union(&self, prisms: impl IntoIterator<Item = u32>) -> Vec<u32> {
        let lists = prisms.into_iter().filter_map(|p| self.lists.get(p as usize));
        let mut out: Vec<u32> = lists.flatten().copied().collect();
        out.sort_unstable();
        out.dedup();
        out
    }

    /// Prism `i` tracks those of the candidates that meet it.
    pub(crate) fn set(&mut self, i: usize, prism: &Prism, candidates: &[u32]) {
        if self.lists.len() <= i {
            self.lists.resize(i + 1, Vec::new());
        }
        let bounds = Box3::of(prism.points());
        let meets = |f: u32| {
            let triangle = self.triangles[f as usize].each_ref();
            let near = Box3::of(triangle);
            let touches =
                |tet: [&[f64; 3]; 4]| near.meets(&Box3::of(tet)) && triangle_tet(triangle, tet).meets();
            near.meets(&bounds) && Slab::BOTH.into_iter().any(|s| prism.tets(s).any(|(_, tet)| touches(tet)))
        };
        self.lists[i] = candidates.iter().copied().filter(|&f| meets(f)).collect();
    }
}

/// The triangles that share a vertex with `f`, itself included, ascending.
pub(crate) fn around(mesh: &TriMesh, connectivity: &Connectivity, f: u32) -> Vec<u32> {
    let stars = mesh.faces[f as usize].into_iter().flat_map(|v| connectivity.star(v));
    let mut out: Vec<u32> = stars.map(|c| c.face()).collect();
    out.sort_unstable();
    out.dedup();
    out
}
