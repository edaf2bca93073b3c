//! The memory of `homeo-check` on a certificate of about 1 GB, which is not kept in memory.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use homeo_benches::built::program;
use homeo_benches::run::peak_memory_of;

use crate::error::{PeersError, Res};
use crate::plan::Plan;
use crate::report::{Asked, Report, Row};

/// What is given to `homeo-check`, as `homeo-profile` names it.
const FILES: [&str; 5] = ["certificate.cert", "bottom.off", "middle.off", "top.off", "mesh.off"];

pub(crate) fn run(plan: &Plan, report: &mut Report) -> Res {
    let io = |source| PeersError::Io { what: "a long certificate".to_owned(), source };
    let folder = tempfile::tempdir().map_err(io)?;
    let argument = format!("simplified:{}", plan.options.size(170, 12));
    let failed = |program, text: String| PeersError::Program { program, argument: argument.clone(), text };
    let certifier = program("homeo-profile").map_err(io)?;
    let certified =
        Command::new(certifier).args([&argument, "write"]).arg(folder.path()).output().map_err(io)?;
    if !certified.status.success() {
        return Err(failed("homeo-profile", String::from_utf8_lossy(&certified.stderr).trim().to_owned()));
    }
    let files = FILES.map(|name| folder.path().join(name));
    let megabytes = |path: &Path| fs::metadata(path).map_or(f64::NAN, |found| found.len() as f64 / 1e6);
    let (certificate, inputs) =
        (megabytes(&files[0]), files[1..].iter().map(|path| megabytes(path)).sum::<f64>());
    let start = Instant::now();
    let checker = program("homeo-check").map_err(io)?;
    let mut child = Command::new(checker).args(&files).stdout(Stdio::piped()).spawn().map_err(io)?;
    let (process, mut peak) = (child.id().to_string(), None);
    // The peak only grows; what it is in the last moments is lost.
    while child.try_wait().map_err(io)?.is_none() {
        peak = peak_memory_of(&process).or(peak);
        std::thread::sleep(Duration::from_millis(10));
    }
    let output = child.wait_with_output().map_err(io)?;
    let text = String::from_utf8_lossy(&output.stdout);
    if !text.starts_with("valid\n") {
        return Err(failed("homeo-check", text.trim().to_owned()));
    }
    let what = format!("peak memory of check, certificate of {certificate:.0} MB");
    let (against, asked) = ("MB", Some(Asked::AtMost(500.0)));
    let meaning = format!(
        "MB (10^6 bytes); inputs of {inputs:.0} MB, {:.0} s, all cores",
        start.elapsed().as_secs_f64()
    );
    report.row(match peak {
        Some(mib) => Row::value(&what, against, asked, mib * 1.048_576, &meaning),
        None => Row::absent(&what, against, asked, "the system does not say"),
    });
    Ok(())
}
