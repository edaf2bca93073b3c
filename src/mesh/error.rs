//! Errors of this module: each says which file, where in it, and why, on one line.

use super::validate::Defect;
use std::fmt;
use thiserror::Error;

/// Why a mesh could not be read, written or accepted.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum MeshError {
    /// A file could not be read, or its content is not a mesh.
    #[error("{file}{place}: {fault}")]
    Read {
        /// File name as given, control characters escaped.
        file: String,
        /// Where in the file.
        place: Place,
        /// What is wrong there.
        fault: Fault,
    },
    /// A mesh cannot be written in the format asked for, or the file cannot be created.
    #[error("{file}{place}: cannot write: {fault}")]
    Write {
        /// File name as given, control characters escaped.
        file: String,
        /// Which element of the mesh.
        place: Place,
        /// What is wrong with it.
        fault: Fault,
    },
    /// The mesh is well formed but not an oriented manifold without flat triangles.
    #[error("{0}")]
    Invalid(Defect),
    /// More faces than `u32` handles for their sides can name.
    #[error("the mesh has {faces} faces, more than the {limit} that can be handled")]
    TooManyFaces {
        /// Number of faces.
        faces: usize,
        /// Largest number supported.
        limit: usize,
    },
}

/// Where in a file or mesh a fault lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    Whole,
    /// A line of text, counted from 1.
    Line(usize),
    /// An element of binary data or of a mesh, counted from 0.
    Element {
        /// What kind: `vertex`, `face`, `facet` ...
        kind: String,
        /// Its position among its kind.
        index: u64,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Whole => Ok(()),
            Self::Line(n) => write!(f, ":{n}"),
            Self::Element { kind, index } => write!(f, ": {kind} {index}"),
        }
    }
}

/// What is wrong, apart from where.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Fault {
    /// Zero bytes, or only white space.
    #[error("the file is empty")]
    Empty,
    /// The operating system refused.
    #[error("{0}")]
    Io(String),
    /// A directory, device, socket or pipe.
    #[error("not a regular file")]
    NotAFile,
    /// Neither content nor name tells the format.
    #[error(
        "format not recognised (OFF, OBJ, PLY, STL, VTK, MEDIT, Gmsh, GIFTI and OpenVolumeMesh are read)"
    )]
    UnknownFormat,
    /// Something else stands where this was needed.
    #[error("expected {expected}, found {found}")]
    Expected {
        /// What was needed.
        expected: String,
        /// What stands there, quoted and shortened.
        found: String,
    },
    /// `nan`, `inf`, or a number beyond the range of `f64`.
    #[error("coordinate {0} is not a finite f64")]
    NotFinite(String),
    /// A face names a vertex that does not exist.
    #[error("vertex index {index} is out of range (the mesh has {vertices} vertices)")]
    IndexOutOfRange {
        /// The index as written in the file.
        index: String,
        /// Number of vertices.
        vertices: u64,
    },
    /// A face with fewer than three corners.
    #[error("a face needs at least 3 corners, found {0}")]
    FewCorners(u64),
    /// The file ends too early.
    #[error("the file ends after {found} of {expected} {what}")]
    Truncated {
        /// What is counted.
        what: String,
        /// How many were announced.
        expected: u64,
        /// How many there are.
        found: u64,
    },
    /// The file goes on after its announced end.
    #[error("unexpected data after the last {0}")]
    TrailingData(String),
    /// More elements than `u32` can index.
    #[error("{count} {what} are more than 2^32 - 1")]
    TooMany {
        /// What is counted.
        what: String,
        /// How many.
        count: u64,
    },
    /// A valid part of the format that this reader does not handle.
    #[error("{0} is not supported")]
    Unsupported(String),
    /// A header that contradicts itself.
    #[error("{0}")]
    BadHeader(String),
    /// Nothing to read or write.
    #[error("the mesh has no vertices")]
    NoVertices,
    /// A triangle soup format cannot hold a mesh without triangles.
    #[error("the mesh has no faces")]
    NoFaces,
    /// A coordinate that binary STL would round.
    #[error("coordinate {0} is not exactly representable in f32, which binary STL stores")]
    NotF32(String),
}

impl Fault {
    pub(super) fn expected(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self::Expected { expected: expected.into(), found: found.into() }
    }

    pub(super) fn at_line(self, line: usize) -> Located {
        Located { place: Place::Line(line), fault: self }
    }

    pub(super) fn at(self, kind: &str, index: usize) -> Located {
        let index = u64::try_from(index).unwrap_or(u64::MAX);
        Located { place: Place::Element { kind: kind.to_owned(), index }, fault: self }
    }
}

/// A fault and its place: what parsers return, before the file's name is added.
#[derive(Debug)]
pub(super) struct Located {
    pub(super) place: Place,
    pub(super) fault: Fault,
}

impl Located {
    pub(super) fn reading(self, file: &str) -> MeshError {
        MeshError::Read { file: escape(file), place: self.place, fault: self.fault }
    }

    pub(super) fn writing(self, file: &str) -> MeshError {
        MeshError::Write { file: escape(file), place: self.place, fault: self.fault }
    }
}

impl From<Fault> for Located {
    fn from(fault: Fault) -> Self {
        Self { place: Place::Whole, fault }
    }
}

/// Control characters escaped, so that an error stays on one line.
fn escape(name: &str) -> String {
    name.chars().flat_map(|c| if c.is_control() { c.escape_default().collect() } else { vec![c] }).collect()
}
