//! Where the certified map takes vertices: to the middle surface of the shell.
//!
//! A point of A and its image on B have one middle point, so a pattern that is a function of the middle point is carried
//! from A to B. The view has it exactly (up to rounding) at vertices and linearly in between.

use crate::mesh::TriMesh;
use crate::projection::{FloatPoint, Projection};
use crate::shell::{Shell, VertexOrder};

/// The middle point of every vertex, in space. A vertex outside of the shell, which no section has, stays where it is;
/// where a shell overlaps itself, a vertex may get the point of the other sheet. `None` if the shell has no projection.
pub(super) fn middle_points(shell: &Shell, meshes: [&TriMesh; 2]) -> Option<[Vec<[f64; 3]>; 2]> {
    let projection = Projection::new(shell, &VertexOrder::Id).ok()?;
    let down = |(p, q): (&[f64; 3], Option<FloatPoint>)| {
        let Some(q) = q else { return *p };
        let corners = shell.faces[q.prism as usize].map(|v| shell.middle[v as usize]);
        std::array::from_fn(|i| (0..3).map(|k| q.weights[k] * corners[k][i]).sum())
    };
    Some(meshes.map(|mesh| {
        mesh.vertices.iter().zip(projection.project_batch_f64(&mesh.vertices)).map(down).collect()
    }))
}
