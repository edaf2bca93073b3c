//! What keeps a map from being built, and a point from being mapped.

use super::Rat;
use crate::shell::Name;
use crate::shell::validate::ShellError;

/// Why there is no projection for a shell and an order.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProjectionError {
    /// The shell breaks an input condition of THEORY section 1.
    #[error("the shell is no valid input: {0}")]
    Shell(#[from] ShellError),
    /// A tet of the decomposition has no positive volume, so the map is not defined on it.
    #[error("prism {prism}: tet {} does not have positive volume under this vertex order, so the shell has no projection \
             (`certify` gives a witness)", listed(.names))]
    NotPositive {
        /// The prism.
        prism: u32,
        /// The tet's vertices.
        names: [Name; 4],
    },
    /// The order is no permutation of the shell's vertices.
    #[error("vertex order: {entries} entries for {vertices} vertices, or one comes twice")]
    Order {
        /// The length of the list.
        entries: usize,
        /// The number of vertices.
        vertices: usize,
    },
    /// There are more tets than 32 bits can count.
    #[error("the shell has {prisms} prisms, too many for a projection")]
    TooMany {
        /// The number of prisms.
        prisms: usize,
    },
}

/// Why coordinates name no point of the shell.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PointError {
    /// A prism that does not exist.
    #[error("there is no prism {prism}: the shell has {prisms}")]
    NoSuchPrism {
        /// The prism asked for.
        prism: u32,
        /// How many there are.
        prisms: usize,
    },
    /// Weights on corners that are negative or do not add up to one.
    #[error("prism {prism}: weights {weights:?} are not barycentric (none negative, sum one)")]
    Weights {
        /// The prism.
        prism: u32,
        /// The weights.
        weights: Box<[Rat; 3]>,
    },
    /// A height beyond bottom or top. At a pinched corner the shell has no thickness.
    #[error(
        "prism {prism}: height {height} is out of range: the shell reaches from -{limit} to {limit} there"
    )]
    Height {
        /// The prism.
        prism: u32,
        /// The height asked for.
        height: Box<Rat>,
        /// The sum of the weights on corners that are not pinched.
        limit: Box<Rat>,
    },
}

/// Why a point of a mesh or of the middle surface has no image.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SectionError {
    /// The mesh is not well formed.
    #[error("the mesh is no valid input: {0}")]
    Mesh(String),
    /// Coordinates that name no point of the shell.
    #[error(transparent)]
    Point(#[from] PointError),
    /// Weights that name no point of a mesh triangle.
    #[error(
        "mesh triangle {face}: it does not exist, or the weights are not barycentric (none negative, sum one)"
    )]
    MeshPoint {
        /// The triangle asked for.
        face: u32,
    },
    /// The point lies in no tet: the mesh is not in the shell.
    #[error("mesh triangle {face}: the point is outside of the shell, so the mesh is not a section")]
    Outside {
        /// The triangle.
        face: u32,
    },
    /// Several images: the shell overlaps itself there, and only a lift can choose.
    #[error("mesh triangle {face}: the shell overlaps itself there and the point has {count} images")]
    SeveralImages {
        /// The triangle.
        face: u32,
        /// How many.
        count: usize,
    },
    /// The fibre does not meet the mesh: not a section.
    #[error("prism {prism}: the fibre does not meet the mesh, so the mesh is not a section")]
    NoPreimage {
        /// The prism.
        prism: u32,
    },
    /// The fibre meets the mesh in several points: not a section, or a shell that overlaps itself.
    #[error("prism {prism}: the fibre meets the mesh in {count} points")]
    SeveralPreimages {
        /// The prism.
        prism: u32,
        /// How many.
        count: usize,
    },
}

fn listed(names: &[Name; 4]) -> String {
    names.map(|n| n.to_string()).join("-")
}
