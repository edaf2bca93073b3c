//! A smaller sample of certificates against the Python checker.

use std::path::Path;
use std::process::Command;

use homeo_proptests::campaign::{certified, run};
use homeo_proptests::judged::inputs;

#[test]
fn the_python_checker_agrees() {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reference/check.py");
    let script = std::env::var_os("HOMEO_CHECK_PY").map_or(script, Into::into);
    if !script.exists() || Command::new("python3").arg("--version").output().is_err() {
        eprintln!("SKIPPED: no {} or no python3", script.display());
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    run(8, |_, case| {
        let Some(outcome) = certified(case, false)? else { return Ok(vec!["refused".into()]) };
        let mut command = Command::new("python3");
        command.arg("-B").arg(&script);
        let mut files = vec![("certificate", outcome.certificate.clone().into_bytes())];
        files.extend(["bottom.off", "middle.off", "top.off", "mesh.off"].into_iter().zip(inputs(case)));
        for (name, bytes) in files {
            let path = folder.path().join(name);
            std::fs::write(&path, bytes).unwrap();
            command.arg(path);
        }
        let answer = command.output().unwrap();
        if answer.status.code() == Some(0) {
            return Ok(vec!["accepted".into()]);
        }
        let [out, err] = [answer.stdout, answer.stderr].map(|b| String::from_utf8_lossy(&b).into_owned());
        Err(format!("rejected: {out}{err}\n{}", outcome.certificate))
    });
}
