//! Points of meshes as cases.

use crate::fuzz::Predicate;
use crate::fuzz::random::Random;
use crate::mesh::TriMesh;

/// Meshes to take points from.
#[derive(Clone, Debug, Default)]
pub struct Pool {
    meshes: Vec<TriMesh>,
}

/// Faces that lie one after the other in a file are mostly near each other.
const NEAR: usize = 6;

impl Pool {
    /// Meshes without faces, with faces that name no vertex, and with coordinates that are not finite are left out.
    #[must_use]
    pub fn new(meshes: Vec<TriMesh>) -> Self {
        let usable = |mesh: &TriMesh| {
            let named = |v: &u32| usize::try_from(*v).is_ok_and(|v| v < mesh.vertices.len());
            !mesh.faces.is_empty()
                && mesh.faces.iter().flatten().all(named)
                && mesh.vertices.iter().flatten().all(|x| x.is_finite())
        };
        Self { meshes: meshes.into_iter().filter(usable).collect() }
    }

    /// Is there no mesh to take points from?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.meshes.is_empty()
    }

    /// A case of vertices of a few faces; `None` if there is no mesh.
    pub(super) fn case(&self, predicate: Predicate, random: &mut Random) -> Option<Vec<f64>> {
        let mesh = self.meshes.get(random.below(self.meshes.len()))?;
        let first = random.below(mesh.faces.len());
        let last = (first + NEAR).min(mesh.faces.len());
        let corners: Vec<u32> = mesh.faces.get(first..last)?.iter().flatten().copied().collect();
        let dropped = random.below(3);
        let mut out = Vec::with_capacity(predicate.arity());
        for i in 0..predicate.points() {
            // The first face's corners in order, mostly: triangles of the mesh.
            let corner = if i < 3 && random.below(2) == 0 { i } else { random.below(corners.len()) };
            let p = mesh.vertices.get(usize::try_from(*corners.get(corner)?).ok()?)?;
            let kept =
                p.iter().enumerate().filter(|(axis, _)| predicate.dimension() == 3 || *axis != dropped);
            out.extend(kept.map(|(_, x)| *x));
        }
        Some(out)
    }
}
