//! A shell as three meshes of one connectivity.

use super::validate::{self, ShellError};
use super::{Layer, Shell};
use crate::mesh::TriMesh;

/// Why three meshes are no shell.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThreeError {
    /// The numbers of vertices differ.
    #[error("the {layer:?} mesh has {count} vertices, the middle mesh {expected}")]
    VertexCount {
        /// The mesh that differs from the middle one.
        layer: Layer,
        /// Its number of vertices.
        count: usize,
        /// The middle mesh's number of vertices.
        expected: usize,
    },
    /// The numbers of triangles differ.
    #[error("the {layer:?} mesh has {count} triangles, the middle mesh {expected}")]
    FaceCount {
        /// The mesh that differs from the middle one.
        layer: Layer,
        /// Its number of triangles.
        count: usize,
        /// The middle mesh's number of triangles.
        expected: usize,
    },
    /// A triangle differs; also one that starts with another of the same corners.
    #[error("triangle {index} is {face:?} in the {layer:?} mesh, {expected:?} in the middle mesh")]
    Face {
        /// The mesh that differs from the middle one.
        layer: Layer,
        /// The first triangle that differs.
        index: usize,
        /// Its corners there.
        face: [u32; 3],
        /// Its corners in the middle mesh.
        expected: [u32; 3],
    },
    /// A corner out of range, a coordinate that is not finite, or too many elements.
    #[error(transparent)]
    Shell(#[from] ShellError),
}

/// The shell with the given bottom, middle and top surface. The result has passed
/// [`validate::lengths`], [`validate::finite`] and [`validate::indices`].
///
/// # Errors
/// [`ThreeError`], naming the first element that differs.
pub fn from_meshes(bottom: TriMesh, middle: TriMesh, top: TriMesh) -> Result<Shell, ThreeError> {
    for (layer, mesh) in [(Layer::Bottom, &bottom), (Layer::Top, &top)] {
        same_connectivity(layer, mesh, &middle)?;
    }
    let shell =
        Shell { bottom: bottom.vertices, middle: middle.vertices, top: top.vertices, faces: middle.faces };
    validate::lengths(&shell)?;
    validate::finite(&shell)?;
    validate::indices(&shell)?;
    Ok(shell)
}

fn same_connectivity(layer: Layer, mesh: &TriMesh, middle: &TriMesh) -> Result<(), ThreeError> {
    let (count, expected) = (mesh.vertices.len(), middle.vertices.len());
    if count != expected {
        return Err(ThreeError::VertexCount { layer, count, expected });
    }
    let mut pairs = mesh.faces.iter().zip(&middle.faces).enumerate();
    if let Some((index, (&face, &expected))) = pairs.find(|(_, (face, expected))| face != expected) {
        return Err(ThreeError::Face { layer, index, face, expected });
    }
    let (count, expected) = (mesh.faces.len(), middle.faces.len());
    if count != expected {
        return Err(ThreeError::FaceCount { layer, count, expected });
    }
    Ok(())
}

/// The bottom, middle and top surface as meshes.
#[must_use]
pub fn to_meshes(shell: &Shell) -> [TriMesh; 3] {
    [Layer::Bottom, Layer::Middle, Layer::Top]
        .map(|layer| TriMesh { vertices: shell.layer(layer).to_vec(), faces: shell.faces.clone() })
}
