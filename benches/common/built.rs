//! Running `homeo build` and the checkers as programs, and what they say.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

/// How a program ended.
#[derive(Clone, Debug)]
pub struct Ended {
    /// Standard output.
    pub stdout: String,
    /// Standard error.
    pub stderr: String,
    /// The exit code; `None` after a signal, or when time was up.
    pub code: Option<i32>,
    /// Wall-clock seconds.
    pub seconds: f64,
    /// Was it ended because time was up?
    pub late: bool,
}

/// Runs a program, at most for so long.
///
/// # Errors
/// It cannot be started.
pub fn run(command: &mut Command, limit: Duration) -> std::io::Result<Ended> {
    let dir = tempfile::tempdir()?;
    let [out, err] = ["out", "err"].map(|name| dir.path().join(name));
    let start = Instant::now();
    // Files, not pipes: nobody has to read while it runs.
    let mut child = command
        .stdin(Stdio::null())
        .stdout(std::fs::File::create(&out)?)
        .stderr(std::fs::File::create(&err)?)
        .spawn()?;
    let mut late = false;
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if start.elapsed() > limit {
            late = true;
            child.kill()?;
        }
        std::thread::sleep(Duration::from_millis(10));
    };
    let seconds = start.elapsed().as_secs_f64();
    let read = |path: &Path| std::fs::read(path).map(|b| String::from_utf8_lossy(&b).into_owned());
    Ok(Ended { stdout: read(&out)?, stderr: read(&err)?, code: status.code(), seconds, late })
}

/// A release build of a program of this workspace, beside this program.
///
/// # Errors
/// The place of this program is unknown.
pub fn program(name: &str) -> std::io::Result<PathBuf> {
    Ok(std::env::current_exe()?.with_file_name(name))
}

/// Runs `homeo build MESH -o SHELL --json` with further arguments; its report, or why there is none.
///
/// # Errors
/// The program cannot be started.
pub fn build(
    mesh: &Path,
    shell: &Path,
    more: &[&str],
    limit: Duration,
) -> std::io::Result<Result<Value, String>> {
    let mut command = Command::new(program("homeo")?);
    command.arg("build").arg(mesh).arg("-o").arg(shell).args(["--json", "--quiet"]).args(more);
    let ended = run(&mut command, limit)?;
    if ended.late {
        return Ok(Err(format!("not done after {} s", limit.as_secs())));
    }
    if ended.code != Some(0) {
        return Ok(Err(ended.stderr.trim().to_owned()));
    }
    Ok(serde_json::from_str(&ended.stdout).map_err(|e| format!("not JSON: {e}")))
}

/// The first word of a checker's answer about a certificate beside its shell, and its seconds.
///
/// # Errors
/// The program cannot be started.
pub fn verdict(checker: &mut Command, shell: &Path, limit: Duration) -> std::io::Result<(String, f64)> {
    let mut certificate = shell.as_os_str().to_owned();
    certificate.push(".cert");
    let ended = run(checker.arg(certificate).arg(shell), limit)?;
    let word = ended.stdout.split_whitespace().next().unwrap_or("no answer").to_owned();
    Ok((if ended.late { format!("not done after {} s", limit.as_secs()) } else { word }, ended.seconds))
}
