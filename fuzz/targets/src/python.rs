//! The Python checkers, in one process that lives as long as this one.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::{LazyLock, Mutex};

use homeo_certs::Outcome;
use tempfile::TempDir;

/// Reads lines `SCRIPT PATH...`, separated by tabs; answers lines of exit code, error code and claims, as [`line`] does.
const PROGRAM: &str = r#"
import sys
sys.path.insert(0, sys.argv[1])
import check, check_meshes
for line in sys.stdin:
    script, *paths = line.rstrip("\n").split("\t")
    status, text = {"check": check, "check_meshes": check_meshes}[script].run(paths)
    head, *claims = text.split("\n")
    code = (head.split(" : ")[0].split(" ") + [""])[1]
    print("\t".join([str(status), code, *claims]), flush=True)
"#;

struct Worker {
    child: Child,
    answers: BufReader<ChildStdout>,
    folder: TempDir,
}

static WORKER: LazyLock<Mutex<Option<Worker>>> = LazyLock::new(|| Mutex::new(Worker::new()));

impl Worker {
    fn new() -> Option<Self> {
        let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../reference");
        let mut command = Command::new("python3");
        command.args(["-B", "-c", PROGRAM]).arg(scripts).stdin(Stdio::piped()).stdout(Stdio::piped());
        let Ok(mut child) = command.spawn() else {
            eprintln!("SKIPPED: the Python checkers need python3");
            return None;
        };
        let answers = BufReader::new(child.stdout.take()?);
        Some(Self { child, answers, folder: tempfile::tempdir().ok()? })
    }

    fn ask(&mut self, script: &str, certificate: &[u8], inputs: &[Vec<u8>]) -> std::io::Result<String> {
        let mut question = script.to_owned();
        for (i, bytes) in std::iter::once(certificate).chain(inputs.iter().map(Vec::as_slice)).enumerate() {
            let path = self.folder.path().join(i.to_string());
            std::fs::write(&path, bytes)?;
            question += &format!("\t{}", path.display());
        }
        let Some(stdin) = &mut self.child.stdin else { return Err(std::io::ErrorKind::BrokenPipe.into()) };
        writeln!(stdin, "{question}")?;
        let mut answer = String::new();
        self.answers.read_line(&mut answer)?;
        Ok(answer.trim_end_matches('\n').to_owned())
    }
}

/// What a Python checker says; `None` without Python.
///
/// # Panics
/// If the process ends, or cannot be spoken to.
pub(crate) fn answer(script: &str, certificate: &[u8], inputs: &[Vec<u8>]) -> Option<String> {
    let mut worker = WORKER.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
    Some(worker.as_mut()?.ask(script, certificate, inputs).expect("the Python process answers"))
}

/// The same of the checker in Rust.
pub(crate) fn line(outcome: &Outcome) -> String {
    let mut out = format!("{}\t{}", outcome.exit, outcome.code);
    for (name, certified) in &outcome.claims {
        out += &format!("\t{name} {}", if *certified { "certified" } else { "refuted" });
    }
    out
}
