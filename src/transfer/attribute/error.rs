//! What keeps attributes from being read, carried or written.

use crate::mesh::{Domain, MeshError};
use crate::projection::SectionError;

/// Why attributes could not be read, carried or written.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum AttributeError {
    /// A PLY or OBJ file could not be read.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A fault in a text file.
    #[error("{file}: line {line}: {reason}")]
    Line {
        /// The file.
        file: String,
        /// The line, counted from 1.
        line: usize,
        /// What is wrong.
        reason: String,
    },
    /// A fault in a file that has no lines to name.
    #[error("{file}: {reason}")]
    File {
        /// The file.
        file: String,
        /// What is wrong.
        reason: String,
    },
    /// Values for another mesh.
    #[error("attribute {name}: {found} values for {expected} elements ({domain:?}) of the source mesh")]
    Count {
        /// The attribute.
        name: String,
        /// What its values belong to.
        domain: Domain,
        /// How many elements there are.
        expected: usize,
        /// How many have a value.
        found: usize,
    },
    /// A value that cannot be interpolated.
    #[error("attribute {name}: a number of element {element} is not finite")]
    NotFinite {
        /// The attribute.
        name: String,
        /// The vertex, triangle or corner.
        element: usize,
    },
    /// Corner values that cannot be interpolated.
    #[error("attribute {name}: labels on the corners of triangles are not carried")]
    CornerLabels {
        /// The attribute.
        name: String,
    },
    /// A vertex on no triangle is on no surface.
    #[error("vertex {vertex} of the target mesh is in no triangle")]
    LooseVertex {
        /// The vertex.
        vertex: usize,
    },
    /// The map has no answer.
    #[error("{element} {index} of the target mesh: {source}")]
    Map {
        /// `vertex` or `triangle`.
        element: &'static str,
        /// Which.
        index: usize,
        /// The reason.
        source: SectionError,
    },
    /// A table has rows of one kind only.
    #[error("a CSV file holds values of vertices or of triangles, not both: use .ply or .json")]
    BothDomains,
}
