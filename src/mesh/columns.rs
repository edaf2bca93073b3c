//! Values that mesh files store beside the geometry: PLY properties, OBJ texture coordinates.

use std::path::Path;

use super::error::{Fault, Located, MeshError};
use super::format::{Format, load, strip_bom};
use super::{obj_texture, ply};

/// What a value belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Domain {
    /// One value a vertex.
    Vertex,
    /// One value a triangle.
    Face,
    /// One value for each corner of each triangle.
    Corner,
}

/// What a column's numbers are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// Reals.
    Real,
    /// Bytes.
    Byte,
    /// Integers of another width.
    Integer,
}

/// One named number for each element. Polygons were fan-triangulated: each of their triangles repeats
/// their value.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// The name in the file.
    pub name: String,
    /// What the values belong to.
    pub domain: Domain,
    /// What the file declares.
    pub kind: ColumnKind,
    /// Finite values in the order of the mesh; three a triangle for corners.
    pub values: Vec<f64>,
}

/// Reads all scalar properties of vertices (but the coordinates) and faces of a PLY file, or the texture
/// coordinates of an OBJ file as the corner columns `u` and `v`.
///
/// # Errors
/// [`MeshError::Read`] with file, place and reason; another format is unsupported.
pub fn columns(path: &Path) -> Result<Vec<Column>, MeshError> {
    let name = path.to_string_lossy();
    let read = || -> Result<Vec<Column>, Located> {
        let bytes = load(path)?;
        match Format::from_content(&bytes).or_else(|| Format::from_extension(path)) {
            Some(Format::PlyAscii | Format::PlyBinaryLe | Format::PlyBinaryBe) => ply::columns(&bytes),
            Some(Format::Obj) => obj_texture::columns(strip_bom(&bytes)),
            _ => {
                Err(Fault::Unsupported("a format without attributes (PLY and OBJ have them)".to_owned())
                    .into())
            }
        }
    };
    read().map_err(|located| located.reading(&name))
}
