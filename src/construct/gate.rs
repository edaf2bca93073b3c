//! The input gate: what can be built on, or the exact reason why not.

use crate::certify::disjoint::self_crossings;
use crate::certify::{CertifyError, Crossing, Observer};
use crate::mesh::{self, Connectivity, MeshError, TriMesh};

/// Why no shell is built.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BuildError {
    /// Not an oriented manifold of triangles with area.
    #[error("{0}; repair the mesh first")]
    Mesh(#[from] MeshError),
    /// Triangles that share more than their common vertices.
    #[error("the mesh intersects itself: triangles {} and {} meet ({count} such pairs); repair it first or allow \
             self-intersections", .first.first, .first.second)]
    SelfIntersecting {
        /// The first pair, with a common point.
        first: Box<Crossing>,
        /// How many pairs there are.
        count: u64,
    },
    /// Two pinched vertices remain in one prism.
    #[error("vertices {} and {} would be pinched in one prism", .vertices[0], .vertices[1])]
    TwoPinched {
        /// The vertices.
        vertices: [u32; 2],
    },
    /// No thickness was found with which the prisms are positive.
    #[error("no positive thickness found at vertex {vertex} (mesh triangle {triangle}): {reason}")]
    NoThickness {
        /// A vertex of the middle surface.
        vertex: u32,
        /// The mesh triangle there.
        triangle: u32,
        /// What fails.
        reason: &'static str,
    },
    /// The list of origins does not fit the shell or the mesh.
    #[error("{origins} origins for {prisms} prisms, or one that is no triangle of the mesh")]
    Origin {
        /// How many prisms.
        prisms: usize,
        /// How many origins.
        origins: usize,
    },
    /// Between the mesh's parts there are hardly any doubles: rounding is as large as the room that is left.
    #[error(
        "too few digits: at vertex {vertex} of mesh triangle {triangle} coordinates are {spacing:e} apart, too coarse for \
             triangles as thin as there ({reason}); move the mesh to the origin or simplify it there"
    )]
    Coarse {
        /// A vertex of the middle surface.
        vertex: u32,
        /// The mesh triangle there.
        triangle: u32,
        /// The distance of neighbouring doubles there, as a share of the longest edge of the bounding box.
        spacing: f64,
        /// What fails.
        reason: &'static str,
    },
    /// Building scales by a power of two, which is exact but near the ends of the range of doubles.
    #[error(
        "vertex {vertex} at {point:?} is too near the end of the range of doubles: scaled by 2^{exponent} it loses \
             digits or overflows; scale the mesh first"
    )]
    Range {
        /// A vertex of the mesh or, on the way back, of the shell.
        vertex: u32,
        /// Where it is.
        point: [f64; 3],
        /// What it should have been scaled by.
        exponent: i32,
    },
    /// The shell overlaps itself.
    #[error("the shell overlaps itself: prisms {} and {} share more than a face ({count} such pairs of tets)", .prisms[0], .prisms[1])]
    Overlap {
        /// The first pair.
        prisms: [u32; 2],
        /// How many pairs of tets there are.
        count: usize,
    },
    /// The certifier did not answer.
    #[error(transparent)]
    Certify(#[from] CertifyError),
}

/// Checks the conditions on the input (THEORY section 1 and, unless self-intersections are allowed, C6).
pub(crate) fn check(
    mesh: &TriMesh,
    allow_self_intersections: bool,
    observer: &dyn Observer,
) -> Result<Connectivity, BuildError> {
    let valid = mesh::check(mesh)?;
    let connectivity = valid.connectivity().clone();
    if allow_self_intersections {
        return Ok(connectivity);
    }
    let crossings = self_crossings(mesh, &connectivity, observer)?;
    match crossings.first() {
        None => Ok(connectivity),
        Some(first) => Err(BuildError::SelfIntersecting {
            first: Box::new(first.clone()),
            count: crossings.len() as u64,
        }),
    }
}
