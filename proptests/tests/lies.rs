//! A lie detector for the certifier: certificates with one fact falsified, shown to be false from the definitions, are
//! rejected by both checkers. `HOMEO_LIES` says how many, `HOMEO_SEED` which.
#![allow(clippy::unwrap_used)]

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use homeo_proptests::lies::Text;
use homeo_proptests::lies::campaign::{Answer, run};

/// The Python checker, asked about many files in one process.
struct Python {
    child: Child,
    questions: ChildStdin,
    answers: BufReader<ChildStdout>,
    folder: tempfile::TempDir,
}

impl Python {
    fn start() -> Option<Self> {
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../reference/check_many.py");
        let mut command = Command::new("python3");
        command.arg("-B").arg(script).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().ok()?;
        let (questions, answers) = (child.stdin.take()?, BufReader::new(child.stdout.take()?));
        Some(Self { child, questions, answers, folder: tempfile::tempdir().ok()? })
    }

    fn ask(&mut self, certificate: &str, inputs: &[Vec<u8>]) -> Answer {
        let mut paths = Vec::new();
        let names = ["certificate", "bottom.off", "middle.off", "top.off", "mesh.off"];
        for (name, bytes) in
            names.into_iter().zip([certificate.as_bytes()].into_iter().chain(inputs.iter().map(|b| &b[..])))
        {
            let path = self.folder.path().join(name);
            std::fs::write(&path, bytes).unwrap();
            paths.push(path.to_str().unwrap().to_owned());
        }
        writeln!(self.questions, "{}", paths.join("\t")).unwrap();
        let mut answer = String::new();
        self.answers.read_line(&mut answer).unwrap();
        let mut words = answer.trim_end_matches('\n').split('\t');
        let (status, first) = (words.next().unwrap(), words.next().unwrap());
        assert!(!first.contains("internal"), "{answer}\n{certificate}");
        let claim = |line: &str| {
            let (name, verdict) = line.split_once(' ').unwrap();
            (name.to_owned(), verdict == "certified")
        };
        (status == "0").then(|| words.map(claim).collect())
    }
}

impl Drop for Python {
    fn drop(&mut self) {
        self.child.kill().ok();
        self.child.wait().ok();
    }
}

fn number(name: &str) -> Option<u64> {
    std::env::var(name).ok().map(|n| n.parse().unwrap())
}

#[test]
fn no_lie_is_accepted() {
    let mut python = Python::start();
    if python.is_none() {
        eprintln!("SKIPPED: the Python checker, which needs python3");
    }
    let mut checkers = |certificate: &str, inputs: &[Vec<u8>]| -> Vec<Answer> {
        let rust = homeo_certs::check(certificate.as_bytes(), inputs);
        let mut answers = vec![(rust.exit == 0).then_some(rust.claims)];
        answers.extend(python.as_mut().map(|p| p.ask(certificate, inputs)));
        answers
    };
    let tally = run(number("HOMEO_LIES").unwrap_or(2000), number("HOMEO_SEED").unwrap_or(1), &mut checkers)
        .unwrap_or_else(|e| panic!("{e}"));
    eprintln!("{tally:#?}");
    // Every kind of lie was told.
    for kind in homeo_proptests::lies::change::KINDS {
        assert!(tally.contains_key(&format!("by {kind}")), "no lie by a change of kind {kind}");
    }
}

/// A checker that believes what it can read is found out, and so is one that rejects all.
#[test]
fn the_detector_can_fail() {
    let mut believer = |certificate: &str, _: &[Vec<u8>]| -> Vec<Answer> {
        let claims = Text::read(certificate)
            .map(|text| text.claims.iter().map(|c| (c.0.to_owned(), c.1 == "certified")).collect::<Vec<_>>());
        vec![claims.ok()]
    };
    let error = run(100, 1, &mut believer).unwrap_err();
    assert!(error.starts_with("accepted, but False("), "{error}");
    let error = run(100, 1, &mut |_, _| vec![None]).unwrap_err();
    assert!(error.starts_with("an honest certificate is rejected"), "{error}");
}
