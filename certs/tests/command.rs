//! The `homeo-check` command: first line, claims, exit codes.
#![allow(clippy::expect_used)]
mod common;
use common::tetrahedron;
use std::process::Command;

fn run(arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_homeo-check")).args(arguments).output().expect("it runs");
    (output.status.code(), String::from_utf8(output.stdout).expect("ASCII"))
}

#[test]
fn answers() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).to_str().expect("UTF-8").to_owned();
    let case = tetrahedron();
    std::fs::write(path("cert"), case.text()).expect("written");
    for (i, bytes) in case.inputs().iter().enumerate() {
        std::fs::write(path(&i.to_string()), bytes).expect("written");
    }
    let files: Vec<String> = ["cert", "0", "1", "2", "3"].map(path).to_vec();
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    let (exit, text) = run(&files);
    assert_eq!(exit, Some(0));
    assert!(text.starts_with("valid\npositivity certified\nsection certified\n"), "{text}");
    assert!(text.ends_with("i2 refuted\n"), "{text}");
    let (exit, text) = run(&[files[0], files[3], files[2], files[1], files[4]]);
    assert_eq!(exit, Some(1));
    assert!(text.starts_with("invalid hash : "), "{text}");
    for (arguments, expected) in [
        (vec![], "malformed usage"),
        (vec!["--nothing"], "malformed usage"),
        (vec!["no-such-file"], "malformed usage"),
        (vec![files[0]], "malformed input"),
        (vec![files[0], "no-such-file"], "malformed input"),
        (vec![files[1], files[1]], "malformed truncated"),
    ] {
        let (exit, text) = run(&arguments);
        assert!(text.starts_with(expected), "{arguments:?}: {text}");
        assert_eq!(exit, Some(2));
    }
    // Two certificates: what is wrong with A is said before B is read.
    let none = "no-such-file";
    for (a, expected) in [(files[1], "malformed truncated : A: "), (none, "malformed usage : A: ")] {
        let (exit, text) = run(&["compose", a, none, none, none, none]);
        assert!(text.starts_with(expected), "{text}");
        assert_eq!(exit, Some(2));
    }
    assert_eq!(run(&["compose", files[0]]).0, Some(2));
    assert_eq!(run(&["--help"]).0, Some(0));
    assert_eq!(run(&["--version"]), (Some(0), format!("homeo-check {}\n", env!("CARGO_PKG_VERSION"))));
}

/// Who opens a pipe for a second time waits for a second writer, if the first one is done.
#[cfg(unix)]
#[test]
fn a_pipe_is_opened_once() {
    let folder = tempfile::tempdir().expect("a folder");
    let pipe = folder.path().join("pipe");
    if !Command::new("mkfifo").arg(&pipe).status().is_ok_and(|status| status.success()) {
        eprintln!("SKIPPED: needs mkfifo");
        return;
    }
    for _ in 0..20 {
        let mut child = Command::new(env!("CARGO_BIN_EXE_homeo-check"))
            .arg(&pipe)
            .stdout(std::process::Stdio::null())
            .spawn()
            .expect("it runs");
        std::fs::write(&pipe, "end\n").expect("written");
        let mut exit = || child.try_wait().expect("a child").map(|status| status.code());
        let pause = || std::thread::sleep(std::time::Duration::from_millis(10));
        let found = (0..3000).find_map(|_| exit().or_else(|| (pause(), None).1));
        child.kill().ok();
        assert_eq!(found, Some(Some(2)));
    }
}
