//! Triangle meshes: connectivity apart from coordinates, readers and writers, validation.

/// A triangle mesh: `vertices[i]` are finite `f64` coordinates, `faces[k]` three vertex indices in
/// orientation order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriMesh {
    /// Coordinates, one row a vertex.
    pub vertices: Vec<[f64; 3]>,
    /// Vertex indices, one row a triangle.
    pub faces: Vec<[u32; 3]>,
}
