//! Triangle and tet meshes: connectivity apart from coordinates, readers and writers, validation.
//!
//! Readers keep what certificates name: the order of vertices and faces, and every bit of every
//! coordinate (decimal text is rounded once, to the nearest `f64`). That is why the OBJ reader is
//! written here: the usual crate, `tobj`, renumbers vertices by first use and drops the others,
//! and it works in `f32` by default.
//!
//! A mesh that was read is only well formed (finite coordinates, indices in range). Whether it is
//! an oriented manifold without flat triangles is the question of [`validate`] and [`check`].

mod area;
mod columns;
mod complex;
pub mod connectivity;
mod correspondence;
mod error;
mod format;
mod gifti;
mod gmsh;
mod medit;
mod obj;
mod obj_texture;
mod off;
mod ovm;
mod parts;
mod ply;
mod rational;
mod scan;
mod stl;
mod text;
mod uv;
mod validate;
mod vtk;
pub(crate) mod write;

#[cfg(test)]
mod tests;

pub use area::is_zero_area;
pub use columns::{Column, ColumnKind, Domain, columns};
pub use complex::{Cells, Complex, ComplexFile, Positions, Space, TetMesh};
pub use connectivity::Connectivity;
pub use correspondence::{Place as SurfacePoint, read_correspondence};
pub use error::{Fault, MeshError, Place};
pub use format::{Format, MeshFile, parse, parse_complex, read, read_as, read_complex};
pub use rational::read_rational;
pub use uv::{UvError, UvMesh, read_uv};
pub use validate::{
    Defect, DefectKind, LISTED, MeshInfo, Report, ValidMesh, check, mesh_info, validate, validate_listing,
};
pub use write::{encode, write};

/// A triangle mesh: `vertices[i]` are finite `f64` coordinates, `faces[k]` three vertex indices in
/// orientation order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TriMesh {
    /// Coordinates, one row a vertex.
    pub vertices: Vec<[f64; 3]>,
    /// Vertex indices, one row a triangle.
    pub faces: Vec<[u32; 3]>,
}
