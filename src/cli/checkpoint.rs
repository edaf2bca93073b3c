//! The file that a long build is resumed from.

use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::CliError;
use super::output;
use crate::construct::optimise::Optimiser;
use crate::construct::optimise::checkpoint::CheckpointError;
use crate::construct::{BuildError, OptimiseOptions};
use crate::mesh::TriMesh;

/// Arguments about checkpoints.
#[derive(Debug, clap::Args)]
// A group is named after its type, and the command has one of this name.
#[group(skip)]
pub(super) struct Args {
    /// Keep the work in this file, and resume from it if it is there; removed when the shell is complete and written.
    /// After a kill at any moment, the same command goes on and ends with the same shell
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// How often the checkpoint is written
    #[arg(long, value_name = "SECONDS", default_value_t = 10, requires = "checkpoint")]
    checkpoint_every: u64,
}

/// Writes the checkpoint when it is due.
pub(super) struct Keeper<'a> {
    file: Option<&'a Path>,
    every: Duration,
    last: Instant,
}

impl<'a> Keeper<'a> {
    /// Checks that the file can be written; it must be none of the others.
    pub(super) fn new(args: &'a Args, others: &[&Path]) -> Result<Self, CliError> {
        let file = args.checkpoint.as_deref();
        if let Some(file) = file {
            output::may_write(file, others)?;
        }
        Ok(Self { file, every: Duration::from_secs(args.checkpoint_every), last: Instant::now() })
    }

    /// The work that the file holds, if it is there.
    pub(super) fn resumed<'m>(
        &self,
        mesh: &'m TriMesh,
        options: &OptimiseOptions,
    ) -> Result<Option<Optimiser<'m>>, CliError> {
        let Some(file) = self.file else { return Ok(None) };
        match std::fs::read(file) {
            Ok(bytes) => Optimiser::resume(mesh, options, &bytes).map(Some).map_err(|e| refused(file, e)),
            Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(CliError::Read { file: file.display().to_string(), reason: e.to_string() }),
        }
    }

    /// Writes the file.
    pub(super) fn save(&mut self, work: &Optimiser<'_>) -> Result<(), CliError> {
        if let Some(file) = self.file {
            output::replace(file, &work.checkpoint().map_err(|e| refused(file, e))?)?;
            self.last = Instant::now();
        }
        Ok(())
    }

    /// Writes the file if it is due.
    pub(super) fn save_if_due(&mut self, work: &Optimiser<'_>) -> Result<(), CliError> {
        if self.file.is_some() && self.last.elapsed() >= self.every { self.save(work) } else { Ok(()) }
    }

    /// Removes the file: all is done. One that was never written is no error.
    pub(super) fn remove(&self) -> Result<(), CliError> {
        let Some(file) = self.file else { return Ok(()) };
        match std::fs::remove_file(file) {
            Err(e) if e.kind() != io::ErrorKind::NotFound => {
                Err(CliError::Write { file: file.display().to_string(), reason: e.to_string() })
            }
            _ => Ok(()),
        }
    }
}

fn refused(file: &Path, source: CheckpointError) -> CliError {
    CliError::Checkpoint { file: file.display().to_string(), source: Box::new(source) }
}

/// What ends a build.
pub(super) fn failed(mesh: &Path, source: BuildError) -> CliError {
    match source {
        BuildError::Certify(crate::certify::CertifyError::Cancelled) => CliError::Interrupted,
        source => CliError::Build { file: mesh.display().to_string(), source: Box::new(source) },
    }
}
