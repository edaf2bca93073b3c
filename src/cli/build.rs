//! `homeo build`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use super::CliError;
use super::output::{self, one_line};
use super::progress::Progress;
use crate::certify::{Claim, Options, Outcome, Silent, certify};
use crate::construct::{BuildError, InitialOptions, OptimiseOptions, initial, optimise};
use crate::mesh::{self, TriMesh};
use crate::shell::Shell;
use crate::shell::hdf5::{self, ShellFile};

/// Arguments of `homeo build`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The mesh (OBJ, OFF, PLY, STL): an oriented manifold without self-intersections
    mesh: PathBuf,
    /// Where the shell goes (HDF5, with the mesh); its certificate goes beside it, with `.cert` added to the name
    #[arg(short = 'o', long = "output", value_name = "OUT.h5")]
    output: PathBuf,
    /// Largest thickness of each half, as a share of the longest edge of the mesh's bounding box
    #[arg(long, value_name = "SHARE", default_value_t = 0.1)]
    thickness: f64,
    /// A shell that does not overlap itself, with the claim `disjoint-prisms` in its certificate
    #[arg(long)]
    no_overlap: bool,
    /// Keep the initial shell, whose middle surface is the mesh itself, refined
    #[arg(long)]
    initial: bool,
    /// Stop optimising after so many seconds, with the valid shell reached by then; Ctrl-C does the same
    #[arg(long, value_name = "SECONDS")]
    time_limit: Option<u64>,
    /// Write the shell without certifying it
    #[arg(long)]
    no_certify: bool,
    /// No progress on standard error
    #[arg(short, long)]
    quiet: bool,
}

/// Runs the command.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    if !(args.thickness.is_finite() && args.thickness > 0.0) {
        return Err(CliError::Usage("--thickness: a positive number is wanted".to_owned()));
    }
    let mesh = mesh::read(&args.mesh)?.mesh;
    let certificate = beside(&args.output);
    output::may_write(&args.output, &[args.mesh.as_path()])?;
    output::may_write(&certificate, &[args.mesh.as_path(), args.output.as_path()])?;
    let start = Instant::now();
    let (shell, how) = build(&mesh, args).map_err(|source| match source {
        BuildError::Certify(crate::certify::CertifyError::Cancelled) => CliError::Interrupted,
        source => CliError::Build { file: args.mesh.display().to_string(), source: Box::new(source) },
    })?;
    let seconds = start.elapsed().as_secs_f64();
    let mut out = format!(
        "{} prisms around {} triangles in {seconds:.1} s; {how}\n",
        shell.faces.len(),
        mesh.faces.len()
    );
    let outcome = if args.no_certify { None } else { Some(proved(&shell, &mesh, args)?) };
    let encode = |source| CliError::Encode { file: args.output.display().to_string(), source };
    let file = ShellFile { shell, mesh: Some(mesh), ..ShellFile::default() };
    output::replace(&args.output, &hdf5::to_bytes(&file).map_err(encode)?)?;
    let name = one_line(&args.output.display().to_string());
    let _ = writeln!(out, "Shell:       {name}");
    if let Some(outcome) = outcome {
        output::replace(&certificate, outcome.certificate.as_bytes())?;
        let cert = one_line(&certificate.display().to_string());
        let claims: Vec<&str> = outcome.claims.iter().map(|c| c.claim.name()).collect();
        let _ = writeln!(
            out,
            "Certified:   {}\nCertificate: {cert}\nCheck it:    homeo-check {cert} {name}",
            claims.join(", ")
        );
    }
    output::print(&out)?;
    Ok(ExitCode::SUCCESS)
}

/// The certificate's file name.
fn beside(shell: &Path) -> PathBuf {
    let mut name = shell.as_os_str().to_owned();
    name.push(".cert");
    PathBuf::from(name)
}

/// The shell, and how it came about in words.
fn build(mesh: &TriMesh, args: &Args) -> Result<(Shell, String), BuildError> {
    let progress = Progress::new(args.quiet);
    let first =
        initial(mesh, &InitialOptions { thickness: args.thickness, no_overlap: args.no_overlap }, &progress)?;
    let pinched = first.pinched.iter().filter(|p| **p).count();
    let prisms = first.shell.faces.len();
    let start = format!(
        "initial shell of {prisms} prisms, {} triangles beveled, {pinched} vertices pinched",
        first.beveled
    );
    if args.initial {
        return Ok((first.shell, start));
    }
    let options = OptimiseOptions {
        thickness: args.thickness,
        time_limit: args.time_limit.map(Duration::from_secs),
        no_overlap: args.no_overlap,
        ..OptimiseOptions::default()
    };
    let done = optimise(mesh, &first.shell, &options, &progress)?;
    let stopped = if done.stopped { "; optimisation was stopped early" } else { "" };
    Ok((done.shell, format!("{start}{stopped}")))
}

/// All claims, each certified: nothing else is written.
fn proved(shell: &Shell, mesh: &TriMesh, args: &Args) -> Result<Outcome, CliError> {
    let file = || args.mesh.display().to_string();
    // An interruption has ended the optimisation; what it left is still to be certified.
    let mut options = Options::default();
    options.claims.extend(args.no_overlap.then_some(Claim::DisjointPrisms));
    let outcome = certify(shell, Some(mesh), &options, &Silent)
        .map_err(|source| CliError::Certify { files: file(), source })?;
    match outcome.claims.iter().flat_map(|c| &c.refutations).next() {
        None => Ok(outcome),
        Some(refuted) => Err(CliError::NotProved { file: file(), reason: refuted.text.clone() }),
    }
}
