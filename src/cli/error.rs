//! Usage and input errors: everything that ends with exit code 2.

use std::path::Path;

use crate::audit::AuditError;
use crate::audit::batch::JournalError;
use crate::certify::CertifyError;
use crate::construct::BuildError;
use crate::construct::optimise::checkpoint::CheckpointError;
use crate::fuzz::SubjectError;
use crate::mesh::{MeshError, UvError};
use crate::shell::hdf5;
use crate::shell::three::ThreeError;
use crate::shell::validate::ShellError;
use crate::shell::vtu::VtuError;
use crate::transfer::attribute::AttributeError;

/// Why a command has no answer. Printed as one line on standard error; exit code 2.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CliError {
    /// Arguments that do not fit together.
    #[error("{0}")]
    Usage(String),
    /// A file could not be read.
    #[error("{file}: {reason}")]
    Read {
        /// The file.
        file: String,
        /// The reason, with the line or element.
        reason: String,
    },
    /// A file could not be written.
    #[error("{file}: not written: {reason}")]
    Write {
        /// The file.
        file: String,
        /// The reason.
        reason: String,
    },
    /// A mesh could not be read or written.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// A shell file could not be read.
    #[error(transparent)]
    Shell(#[from] hdf5::ReadError),
    /// Three meshes that are no shell.
    #[error("{files}: {source}")]
    Three {
        /// The three files.
        files: String,
        /// The reason.
        source: ThreeError,
    },
    /// A shell could not be encoded.
    #[error("{file}: not written: {source}")]
    Encode {
        /// The output file.
        file: String,
        /// The reason.
        source: hdf5::WriteError,
    },
    /// No shell could be built around a mesh.
    #[error("{file}: {source}")]
    Build {
        /// The mesh file.
        file: String,
        /// The reason.
        source: Box<BuildError>,
    },
    /// A checkpoint is not resumed from.
    #[error("{file}: {source}")]
    Checkpoint {
        /// The checkpoint file.
        file: String,
        /// The reason.
        source: Box<CheckpointError>,
    },
    /// A shell that was built did not certify; nothing was written. An error of the program: please report it.
    #[error("{file}: the shell that was built does not certify, so nothing was written: {reason}")]
    NotProved {
        /// The mesh file.
        file: String,
        /// The first refutation.
        reason: String,
    },
    /// The independent checker did not accept the files as written; they were removed. An error of the program.
    #[error(
        "{file}: internal contradiction, please report it with the input: the independent checker says `{answer}` about the \
         shell and the certificate as written; nothing was left in place"
    )]
    NotAccepted {
        /// The shell file.
        file: String,
        /// The checker's first line.
        answer: String,
    },
    /// A map that is not known to be a bijection.
    #[error(
        "{mesh}: not certified as a section of this shell, so nothing was carried: {reason} (--unproved carries on all the same)"
    )]
    Unproved {
        /// The mesh.
        mesh: String,
        /// The reason.
        reason: String,
    },
    /// Attributes that could not be read, carried or written.
    #[error(transparent)]
    Attribute(#[from] AttributeError),
    /// A shell could not be written for ParaView.
    #[error(transparent)]
    Vtu(#[from] VtuError),
    /// A shell that is no valid input.
    #[error("{file}: the shell is no valid input: {source}")]
    InvalidShell {
        /// The file.
        file: String,
        /// The reason.
        source: ShellError,
    },
    /// A mesh that is no valid input.
    #[error("{file}: the mesh is no valid input: {source}")]
    InvalidMesh {
        /// The file.
        file: String,
        /// The reason.
        source: MeshError,
    },
    /// No verdict for another reason.
    #[error("{files}: {source}")]
    Certify {
        /// The input files.
        files: String,
        /// The reason.
        source: CertifyError,
    },
    /// No verdict about two position sets.
    #[error("{files}: {source}")]
    Map {
        /// The input files.
        files: String,
        /// The reason.
        source: crate::certify::pl::PlError,
    },
    /// Texture coordinates that are no positions of the surface's vertices.
    #[error("{file}: {source}; --cut audits the surface cut open there")]
    Uv {
        /// The file.
        file: String,
        /// The reason.
        source: UvError,
    },
    /// A correspondence of vertices that is no map.
    #[error(
        "{file}: not a map: {count} triangles of B (first: {first}) have their places in no closed triangle of A together, so \
         it is not said how they run"
    )]
    NotAMap {
        /// The file.
        file: String,
        /// How many triangles.
        count: usize,
        /// The first of them.
        first: u32,
    },
    /// No verdict of an audit.
    #[error("{files}: {source}")]
    Audit {
        /// The input files.
        files: String,
        /// The reason.
        source: Box<AuditError>,
    },
    /// Results of audits could not be read or recorded.
    #[error(transparent)]
    Journal(#[from] JournalError),
    /// A subject of `fuzz` that cannot be asked.
    #[error("{}", super::fuzz::explain(.0))]
    Subject(SubjectError),
    /// The user pressed Ctrl-C during audits of a manifest.
    #[error("interrupted after {results} results, which are kept; --resume goes on")]
    Stopped {
        /// How many results there are.
        results: usize,
    },
    /// The user pressed Ctrl-C.
    #[error("interrupted; nothing was written")]
    Interrupted,
    /// The independent checker does not accept what the certifier wrote. Never a verdict.
    #[error("internal contradiction, please report it with the input: the independent checker says `{0}`")]
    Disagreement(String),
    /// The worker threads could not be started.
    #[error("--threads: {0}")]
    Threads(String),
}

/// An audit's error with the files that it is about.
pub(super) fn of_audit(source: AuditError, files: &[&Path]) -> CliError {
    if source.is_interruption() {
        return CliError::Interrupted;
    }
    let files = files.iter().map(|f| f.display().to_string()).collect::<Vec<_>>().join(", ");
    CliError::Audit { files, source: Box::new(source) }
}

/// A failure to record is one of writing.
pub(super) fn of_journal(source: JournalError) -> CliError {
    match source {
        JournalError::Io { file, source } => CliError::Write { file, reason: source.to_string() },
        source => CliError::Journal(source),
    }
}
