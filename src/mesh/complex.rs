//! Complexes of triangles or tets, with positions as exact as their file has them.

use super::TriMesh;
use super::format::Format;
use crate::number::Rat;

/// A tet mesh: `vertices[i]` are finite `f64` coordinates, `tets[k]` four vertex indices, in the order of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TetMesh {
    /// Coordinates, one row a vertex.
    pub vertices: Vec<[f64; 3]>,
    /// Vertex indices, one row a tet.
    pub tets: Vec<[u32; 4]>,
}

/// Exact positions, one row a vertex. In the plane the third coordinate is zero.
#[derive(Clone, Debug, PartialEq)]
pub enum Positions {
    /// Finite `f64`.
    Float(Vec<[f64; 3]>),
    /// Rational numbers.
    Exact(Vec<[Rat; 3]>),
}

impl Positions {
    /// Number of vertices.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Float(points) => points.len(),
            Self::Exact(points) => points.len(),
        }
    }

    /// Is there no vertex?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Cells of one dimension, in orientation order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cells {
    /// Three vertex indices a cell.
    Triangles(Vec<[u32; 3]>),
    /// Four vertex indices a cell.
    Tets(Vec<[u32; 4]>),
}

impl Cells {
    /// Number of cells.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::Triangles(cells) => cells.len(),
            Self::Tets(cells) => cells.len(),
        }
    }

    /// Is there no cell?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Corners of a cell: 3 or 4.
    #[must_use]
    pub fn corners(&self) -> usize {
        match self {
            Self::Triangles(_) => 3,
            Self::Tets(_) => 4,
        }
    }

    /// All corners, cell after cell.
    #[must_use]
    pub fn flat(&self) -> &[u32] {
        match self {
            Self::Triangles(cells) => cells.as_flattened(),
            Self::Tets(cells) => cells.as_flattened(),
        }
    }

    /// The corners of one cell; empty where there is none.
    #[must_use]
    pub fn cell(&self, index: usize) -> &[u32] {
        match self {
            Self::Triangles(cells) => cells.get(index).map_or(&[], |c| c.as_slice()),
            Self::Tets(cells) => cells.get(index).map_or(&[], |c| c.as_slice()),
        }
    }
}

/// Where the vertices lie: in a plane or in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Two coordinates.
    Plane,
    /// Three coordinates.
    Space,
}

impl Space {
    /// 2 or 3.
    #[must_use]
    pub fn dimension(self) -> usize {
        match self {
            Self::Plane => 2,
            Self::Space => 3,
        }
    }
}

/// A simplicial complex with positions.
#[derive(Clone, Debug, PartialEq)]
pub struct Complex {
    /// Where the vertices lie.
    pub space: Space,
    /// Their positions.
    pub positions: Positions,
    /// The cells; all indices are in range.
    pub cells: Cells,
}

impl From<TriMesh> for Complex {
    fn from(mesh: TriMesh) -> Self {
        Self {
            space: Space::Space,
            positions: Positions::Float(mesh.vertices),
            cells: Cells::Triangles(mesh.faces),
        }
    }
}

impl From<TetMesh> for Complex {
    fn from(mesh: TetMesh) -> Self {
        Self {
            space: Space::Space,
            positions: Positions::Float(mesh.vertices),
            cells: Cells::Tets(mesh.tets),
        }
    }
}

/// A complex as it came from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct ComplexFile {
    /// The complex: vertices and cells in the file's order.
    pub complex: Complex,
    /// Further exact positions of the same vertices by name (OpenVolumeMesh string properties).
    pub exact: Vec<(String, Vec<[Rat; 3]>)>,
    /// The format found in the file.
    pub format: Format,
    /// What was changed or left out, one sentence each.
    pub notes: Vec<String>,
}

impl ComplexFile {
    /// The positions stored under a name, if there are any.
    #[must_use]
    pub fn exact(&self, name: &str) -> Option<&[[Rat; 3]]> {
        self.exact.iter().find(|(n, _)| n == name).map(|(_, points)| points.as_slice())
    }
}
