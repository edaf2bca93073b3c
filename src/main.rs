//! The `homeo` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    homeo::cli::main()
}
