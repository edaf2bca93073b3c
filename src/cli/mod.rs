//! The `homeo` command line: one file a command; parses, calls the library, prints. No geometry.
//!
//! Exit codes: 0 certified (or: done, valid), 1 refuted (or: has defects), 2 usage or input error. `check` has the
//! codes of `homeo-check`: 0 valid, 1 invalid, 2 malformed, 3 limit reached. `build` stopped by a first Ctrl-C while it
//! optimises ends with 0: the shell is written and certified; a second Ctrl-C ends any command at once, with 2.

// Errors here end the process: their size does not matter.
#![allow(clippy::result_large_err)]

mod audit;
mod audit_batch;
mod build;
mod build_report;
mod certify;
mod check;
mod checkpoint;
mod convert;
mod demo;
mod error;
mod fuzz;
mod input;
mod inspect;
mod map;
mod map_input;
mod mesh_info;
mod output;
mod progress;
mod project;
mod section;
mod tet_info;
mod transfer;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

pub use error::CliError;

/// Exact proofs that maps between triangle meshes are bijections.
#[derive(Debug, Parser)]
#[command(name = "homeo", version, about, long_about = None, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Make a small mesh with a shell, certify it, check the certificate, damage it, show the refutation
    Demo(demo::Args),
    /// Decide claims about a shell and a mesh; write the certificate or the refutation
    Certify(certify::Args),
    /// Build a shell around a mesh, optimise it, and write it with its certificate
    Build(build::Args),
    /// Is a remeshed surface provably bijective to the original; is a cage nested? Many at a time with --manifest
    Audit(audit::Args),
    /// Join files of results of `audit --manifest --shard`
    Merge(audit_batch::MergeArgs),
    /// Check a certificate against its input files (the same as `homeo-check`)
    Check(check::Args),
    /// Project points along a shell, exactly
    Project(project::Args),
    /// Carry attributes from one section of a shell to another, exactly or in f64
    Transfer(transfer::Args),
    /// Facts about a shell file, and whether it is a valid input
    Inspect(inspect::Args),
    /// Convert meshes and shells between file formats
    Convert(convert::Args),
    /// Decide whether two position sets of one complex give a homeomorphism: tets, surfaces, UV maps
    Map(map::Args),
    /// Judge an implementation of geometric predicates, exactly
    Fuzz(fuzz::Args),
    /// Facts about a mesh, and its defects
    MeshInfo(mesh_info::Args),
}

/// Runs the command line of this process.
#[must_use]
pub fn main() -> ExitCode {
    let cli = match Cli::try_parse() {
        Ok(cli) => cli,
        Err(usage) => {
            // Help and version go to standard output with code 0, usage errors to standard error with code 2.
            let _ = usage.print();
            return if usage.use_stderr() { ExitCode::from(2) } else { ExitCode::SUCCESS };
        }
    };
    let done = match cli.command {
        Command::Demo(args) => demo::run(&args),
        Command::Build(args) => build::run(args),
        Command::Audit(args) => audit::run(&args),
        Command::Merge(args) => audit_batch::merge(&args),
        Command::Convert(args) => convert::run(&args),
        Command::Certify(args) => certify::run(args),
        Command::Check(args) => check::run(&args),
        Command::Project(args) => project::run(args),
        Command::Transfer(args) => transfer::run(&args),
        Command::Inspect(args) => inspect::run(args),
        Command::Map(args) => map::run(&args),
        Command::Fuzz(args) => fuzz::run(&args),
        Command::MeshInfo(args) => mesh_info::run(args),
    };
    done.unwrap_or_else(|error| {
        output::complain(&error);
        ExitCode::from(2)
    })
}

/// Sets the number of threads, if one is asked for.
fn threads(number: Option<u16>) -> Result<(), CliError> {
    let Some(number) = number else { return Ok(()) };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(usize::from(number));
    pool.build_global().map_err(|e| CliError::Threads(e.to_string()))
}
