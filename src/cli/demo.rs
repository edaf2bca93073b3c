//! `homeo demo`: the main job, on a shell made on the spot.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::CliError;
use super::check::{answer, first_line};
use super::output;
use crate::certify::{Options, Outcome, Silent, VertexOrder, certify};
use crate::construct::{dent, sample};
use crate::report::{Sources, sentence};
use crate::shell::hdf5::{self, ShellFile};

/// Arguments of `homeo demo`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Keep the shells and their certificates in this directory (made if missing); default: nothing is written
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The vertex whose top point is pushed through the shell.
const DENTED: usize = 7;

/// Runs the command: 0 when the sound shell is certified, the damaged one refuted, and the checker accepts both.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let out = args.out.as_deref();
    if let Some(dir) = out {
        std::fs::create_dir_all(dir)
            .map_err(|e| CliError::Write { file: dir.display().to_string(), reason: e.to_string() })?;
    }
    let made = sample(2);
    let mut text = format!(
        "1. A shell of {} prisms around an icosphere, and a bumpy mesh of {} triangles inside it.\n   Is the projection \
         along the shell a bijection from the mesh onto the middle surface?\n\n",
        made.shell.prism_count(),
        made.mesh.faces.len(),
    );
    let sound = ShellFile { shell: made.shell, mesh: Some(made.mesh), ..ShellFile::default() };
    let proved = act(&sound, "demo", out, &mut text)?;
    let _ =
        writeln!(text, "\n2. The same shell, damaged: top point t{DENTED} is pushed down to b{DENTED}.\n");
    let damaged = ShellFile { shell: dent(&sound.shell, DENTED), ..sound };
    let refuted = act(&damaged, "damaged", out, &mut text)?;
    let as_expected = proved && !refuted;
    let end = match out {
        Some(_) => "Certificates and refutations are plain text: have a look.",
        None => "Nothing was written; `--out DIR` keeps the shells and their certificates.",
    };
    let _ = writeln!(text, "\n{end}");
    output::print(&text)?;
    Ok(ExitCode::from(u8::from(!as_expected)))
}

/// Certifies one shell, lets the independent checker judge the certificate, keeps the files; are all claims certified?
fn act(file: &ShellFile, name: &str, out: Option<&Path>, text: &mut String) -> Result<bool, CliError> {
    let (shell_name, cert_name) = (format!("{name}.h5"), format!("{name}.cert"));
    let options = Options::default();
    let outcome = certify(&file.shell, file.mesh.as_ref(), &options, &Silent)
        .map_err(|source| CliError::Certify { files: shell_name.clone(), source })?;
    describe(file, &shell_name, &outcome, text);
    let bytes =
        hdf5::to_bytes(file).map_err(|source| CliError::Encode { file: shell_name.clone(), source })?;
    let checked = homeo_certs::check(outcome.certificate.as_bytes(), std::slice::from_ref(&bytes));
    let size = outcome.certificate.len();
    let _ = writeln!(text, "\n   homeo-check {cert_name} {shell_name}   ({size} bytes of certificate)");
    for line in answer(&checked).lines() {
        let _ = writeln!(text, "      {line}");
    }
    if checked.exit != 0 {
        return Err(CliError::Disagreement(first_line(&checked)));
    }
    if let Some(dir) = out {
        for (name, bytes) in [(&shell_name, bytes.as_slice()), (&cert_name, outcome.certificate.as_bytes())] {
            let path = dir.join(name);
            output::may_write(&path, &[])?;
            output::replace(&path, bytes)?;
            let _ = writeln!(text, "   wrote {}", path.display());
        }
    }
    Ok(outcome.all_certified())
}

fn describe(file: &ShellFile, name: &str, outcome: &Outcome, text: &mut String) {
    let sizes = (file.shell.prism_count(), file.mesh.as_ref().map_or(0, |m| m.faces.len()));
    let order = match VertexOrder::default() {
        VertexOrder::Id => "by vertex id".to_owned(),
        VertexOrder::List(_) => "of a list".to_owned(),
    };
    let sources = Sources::new(name, None, sizes, order);
    for result in &outcome.claims {
        for line in sentence(result, &sources).lines() {
            let _ = writeln!(text, "   {line}");
        }
    }
}
