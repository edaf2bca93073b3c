//! `homeo check`, and the certifier's check of its own certificate.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::CliError;
use super::input::{Loaded, is_regular};
use super::output;
use crate::shell::hdf5;

/// Arguments of `homeo check`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The certificate, then its inputs: a shell file; a shell file and a mesh; bottom, middle and top mesh; or these
    /// three and a mesh. Or `compose A.cert B.cert SHELL A B`
    #[arg(value_name = "CERT INPUT...")]
    files: Vec<PathBuf>,
}

/// Runs the command: the answer and the exit code are those of `homeo-check`.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let Some((certificate, inputs)) = args.files.split_first() else {
        output::print("malformed usage : no certificate given, see --help\n")?;
        return Ok(ExitCode::from(2));
    };
    let outcome = if certificate.as_os_str() == "compose" {
        homeo_certs::compose_files(inputs)
    } else {
        homeo_certs::check_files(certificate, inputs)
    };
    output::print(&answer(&outcome))?;
    Ok(ExitCode::from(outcome.exit))
}

/// What `homeo-check` prints: the status with its code, then one line a claim.
pub(super) fn answer(outcome: &homeo_certs::Outcome) -> String {
    let mut out = first_line(outcome);
    out.push('\n');
    for (claim, certified) in &outcome.claims {
        let verdict = if *certified { "certified" } else { "refuted" };
        out += &format!("{claim} {verdict}\n");
    }
    out
}

/// The status with its code and message.
pub(super) fn first_line(outcome: &homeo_certs::Outcome) -> String {
    let mut out = outcome.status.to_owned();
    for (before, part) in [(" ", outcome.code), (" : ", outcome.message.as_str())] {
        if !part.is_empty() {
            out = out + before + &part.replace('\n', " ");
        }
    }
    out
}

/// That the independent checker has accepted a certificate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Checked {
    /// It does not read the input files in their format, and was given the same shell and mesh, bit by bit, in the
    /// HDF5 layout that it reads.
    pub(super) converted: bool,
}

/// Has a certificate file checked by the independent checker against the input files themselves, where it reads their
/// format. Anything but `valid` is a contradiction between the two programs and no verdict.
pub(super) fn self_check(certificate: &Path, loaded: &Loaded) -> Result<Checked, CliError> {
    let files = loaded.inputs();
    files.iter().try_for_each(|path| is_regular(path))?;
    let direct = homeo_certs::check_files(certificate, &files);
    if direct.exit == 0 {
        return Ok(Checked { converted: false });
    }
    if direct.code != "input" {
        return Err(CliError::Disagreement(first_line(&direct)));
    }
    let copy = hdf5::ShellFile {
        shell: loaded.file.shell.clone(),
        mesh: loaded.file.mesh.clone(),
        ..hdf5::ShellFile::default()
    };
    // Beside the certificate, where there is room for files.
    let file = output::beside(certificate)
        .map_err(|e| CliError::Write { file: certificate.display().to_string(), reason: e.to_string() })?;
    let name = || file.path().display().to_string();
    let bytes = hdf5::to_bytes(&copy).map_err(|source| CliError::Encode { file: name(), source })?;
    drop(copy);
    let failed = |e: std::io::Error| CliError::Write { file: name(), reason: e.to_string() };
    fs::write(file.path(), bytes).map_err(failed)?;
    verdict(&homeo_certs::check_files(certificate, &[file.path()]))?;
    Ok(Checked { converted: true })
}

/// Lets the independent checker check a certificate against the contents of its inputs.
pub(super) fn accepted(certificate: &str, files: &[Vec<u8>]) -> Result<(), CliError> {
    verdict(&homeo_certs::check(certificate.as_bytes(), files))
}

fn verdict(outcome: &homeo_certs::Outcome) -> Result<(), CliError> {
    if outcome.exit == 0 { Ok(()) } else { Err(CliError::Disagreement(first_line(outcome))) }
}
