//! Why a comparison has no result.

use homeo::certify::CertifyError;
use homeo::mesh::MeshError;
use homeo::predicate::batch::BatchError;
use homeo::projection::ProjectionError;
use homeo::shell::hdf5::ReadError;
use homeo_benches::cgal::CgalError;

#[derive(Debug, thiserror::Error)]
pub(crate) enum PeersError {
    #[error(transparent)]
    Cgal(#[from] CgalError),
    #[error(transparent)]
    Certify(#[from] CertifyError),
    #[error(transparent)]
    Mesh(#[from] MeshError),
    #[error(transparent)]
    Batch(#[from] BatchError),
    #[error(transparent)]
    Projection(#[from] ProjectionError),
    #[error(transparent)]
    Shell(#[from] ReadError),
    #[error(transparent)]
    Pool(#[from] rayon::ThreadPoolBuildError),
    #[error("{what}: {source}")]
    Io {
        /// What was tried.
        what: String,
        source: std::io::Error,
    },
    #[error("the results cannot be written as JSON: {0}")]
    Json(#[from] serde_json::Error),
    #[error("the plot cannot be drawn: {0}")]
    Plot(String),
    /// Whatever is compared must give the same answers.
    #[error("{who} disagrees with homeo: {what}")]
    Disagrees { who: String, what: String },
    /// A program of this workspace says something unexpected.
    #[error("{program} {argument}: {text}")]
    Program { program: &'static str, argument: String, text: String },
}

pub(crate) type Res<T = ()> = Result<T, PeersError>;
