//! The `homeo-check` command.

use std::io::Write;
use std::process::ExitCode;

const HELP: &str = "\
Checks a homeo certificate against the files that it is about (certs/FORMAT.md).

Usage: homeo-check CERTIFICATE INPUT...
       homeo-check compose A.cert B.cert SHELL A B

INPUT: one HDF5 shell that also holds the mesh; or an HDF5 shell and a mesh (OFF, OBJ);
       or the bottom, middle and top meshes of a shell; or these three and the mesh.
       For a certificate about meshes (certs/MESHES.md): one or two meshes (OFF, OBJ, complex files).
compose: do the certificates of A and of B on one shell prove a homeomorphism from A to B?

Exit code: 0 valid, 1 invalid, 2 malformed or unreadable, 3 limit reached.
";

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args_os().skip(1).collect();
    let first = arguments.first().and_then(|a| a.to_str()).unwrap_or("");
    let (text, exit) = match first {
        "--help" | "-h" => (HELP.to_owned(), 0),
        "--version" | "-V" => (format!("homeo-check {}\n", env!("CARGO_PKG_VERSION")), 0),
        _ => answer(&arguments),
    };
    // A closed pipe must not change the exit code.
    let _ = std::io::stdout().write_all(text.as_bytes());
    ExitCode::from(exit)
}

fn answer(arguments: &[std::ffi::OsString]) -> (String, u8) {
    let option = arguments.iter().find(|a| a.to_string_lossy().starts_with('-'));
    let (cert, inputs) = match (option, arguments.split_first()) {
        (None, Some((cert, inputs))) => (cert, inputs),
        (Some(option), _) => {
            return (format!("malformed usage : unknown option {}\n", option.to_string_lossy()), 2);
        }
        (None, None) => return ("malformed usage : no certificate given, see --help\n".to_owned(), 2),
    };
    let outcome = if cert == "compose" {
        homeo_certs::compose_files(inputs)
    } else {
        homeo_certs::check_files(cert.as_ref(), inputs)
    };
    let mut text = [outcome.status, outcome.code].join(" ").trim_end().to_owned();
    if !outcome.message.is_empty() {
        text.extend([" : ", &outcome.message.replace('\n', " ")]);
    }
    text.push('\n');
    for (name, certified) in &outcome.claims {
        text.extend([name.as_str(), if *certified { " certified\n" } else { " refuted\n" }]);
    }
    (text, outcome.exit)
}
