//! What keeps a verdict from being reached.

use crate::mesh::MeshError;
use crate::shell::validate::ShellError;
use crate::shell::{Name, OrderError};

/// Why there is no verdict. None of these says anything about a claim.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CertifyError {
    /// The shell breaks an input condition of THEORY section 1.
    #[error("the shell is no valid input: {0}")]
    Shell(#[from] ShellError),
    /// The mesh breaks an input condition of THEORY section 1.
    #[error("the mesh is no valid input: {0}")]
    Mesh(#[from] MeshError),
    /// A claim about a mesh, but no mesh.
    #[error("claim `{claim}` is about a mesh, but there is none: give one, or claim `positivity` only")]
    NoMesh {
        /// The claim.
        claim: &'static str,
    },
    /// A vertex order that is no permutation of the shell's vertices.
    #[error(transparent)]
    Order(#[from] OrderError),
    /// Positive tets that wind around an edge more than once: the lift across it is not unique, and neither a
    /// certificate nor a witness can be given. Only possible where `positivity` is refuted.
    #[error("the tets around {} wind more than once, so that the lift is not unique; repair the shell (C1 fails)", listed(.names))]
    Branched {
        /// The simplex that the tets wind around.
        names: Vec<Name>,
    },
    /// The shell overlaps itself and the mesh has several lifts: the one that proves `section` in the given order is no
    /// section in another order, in which some other lift is one. Neither a certificate nor a witness of
    /// `section-all-orders` can be given then.
    #[error(
        "section-all-orders: the shell overlaps itself, and in the vertex order that begins {} only another lift of the \
         mesh is a section; claim `section` for the orders wanted", numbers(.first)
    )]
    SeveralLifts {
        /// The vertices that come first in that order.
        first: Vec<u32>,
    },
    /// A bottom or top triangle without area has a pinched vertex within an edge, and a mesh triangle goes through it just there:
    /// no other point is common, as `disjoint` wants, but no planes show it. Only possible where `positivity` is refuted.
    #[error(
        "disjoint: triangle {triangle} goes through a flat triangle of prism {prism} at its pinched vertex, which can be neither \
         proved to be all nor refuted; repair the shell (C1 fails)"
    )]
    FlatAtPinch {
        /// The mesh triangle.
        triangle: u32,
        /// The prism.
        prism: u32,
    },
    /// The caller asked to stop.
    #[error("interrupted before a verdict")]
    Cancelled,
    /// The certificate could not be written.
    #[error("the certificate: not written: {0}")]
    Write(#[source] std::io::Error),
    /// The program contradicts itself. Never a verdict; please report it with the input.
    #[error("internal contradiction: {what}")]
    Internal {
        /// What was found.
        what: &'static str,
    },
}

fn listed(names: &[Name]) -> String {
    names.iter().map(ToString::to_string).collect::<Vec<_>>().join("-")
}

fn numbers(ids: &[u32]) -> String {
    ids.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}
