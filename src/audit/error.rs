//! What keeps an audit from having a verdict.

use crate::certify::CertifyError;
use crate::certify::pl::PlError;
use crate::mesh::MeshError;
use crate::shell::hdf5;

/// Why there is no verdict.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AuditError {
    /// An interruption, or a contradiction within the certifier.
    #[error(transparent)]
    Certify(Box<CertifyError>),
    /// A mesh is too large to be handled.
    #[error("mesh {name}: {source}")]
    Mesh {
        /// `A` or `B`.
        name: &'static str,
        /// The reason.
        source: Box<MeshError>,
    },
    /// The certifier of claims about meshes has no answer.
    #[error(transparent)]
    Pl(Box<PlError>),
    /// A shell that was found could not be encoded.
    #[error("a shell could not be encoded: {0}")]
    Encode(Box<hdf5::WriteError>),
    /// The independent checker does not accept what was written. Never a verdict.
    #[error(
        "internal contradiction, please report it with the input: about {document} the independent checker says `{answer}`"
    )]
    Disagreement {
        /// The document.
        document: String,
        /// The answer.
        answer: String,
    },
}

impl From<CertifyError> for AuditError {
    fn from(source: CertifyError) -> Self {
        Self::Certify(Box::new(source))
    }
}

impl From<hdf5::WriteError> for AuditError {
    fn from(source: hdf5::WriteError) -> Self {
        Self::Encode(Box::new(source))
    }
}

impl From<PlError> for AuditError {
    fn from(error: PlError) -> Self {
        match error {
            PlError::Certify(source) => source.into(),
            source => Self::Pl(Box::new(source)),
        }
    }
}

impl AuditError {
    /// Was the work interrupted?
    #[must_use]
    pub fn is_interruption(&self) -> bool {
        matches!(self, Self::Certify(source) if matches!(**source, CertifyError::Cancelled))
    }
}
