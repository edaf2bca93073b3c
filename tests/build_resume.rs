//! `homeo build --checkpoint`: killed at any moment, the same command ends with the same files.
// Helpers of tests may panic; clippy knows that only inside `#[test]` functions.
#![allow(clippy::unwrap_used)]

use std::fmt::Write as _;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A subdivided octahedron with bumps: 8 * 4^levels triangles.
fn bumpy(levels: usize) -> String {
    let n = 1i32 << levels;
    let mut ids = std::collections::HashMap::new();
    let mut points = String::new();
    let mut count = 0usize;
    let mut id = |p: [i32; 3]| {
        *ids.entry(p).or_insert_with(|| {
            let noise = f64::from((p[0] * 7 + p[1] * 13 + p[2] * 29).rem_euclid(17)) / 17.0;
            let x = p.map(f64::from);
            let length = x.iter().map(|x| x * x).sum::<f64>().sqrt() / (1.0 + 0.01 * noise);
            writeln!(points, "{} {} {}", x[0] / length, x[1] / length, x[2] / length).unwrap();
            count += 1;
            count - 1
        })
    };
    let mut faces = Vec::new();
    for [sx, sy, sz] in (0..8).map(|k| [0, 1, 2].map(|i| 1 - 2 * (k >> i & 1))) {
        let at = |i: i32, j: i32| [sx * i, sy * j, sz * (n - i - j)];
        for i in 0..n {
            for j in 0..n - i {
                let mut add = |mut t: [[i32; 3]; 3]| {
                    if sx * sy * sz < 0 {
                        t.swap(1, 2);
                    }
                    faces.push(t.map(&mut id));
                };
                add([at(i, j), at(i + 1, j), at(i, j + 1)]);
                if i + j + 1 < n {
                    add([at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
                }
            }
        }
    }
    let mut out = format!("OFF\n{count} {} 0\n{points}", faces.len());
    for [a, b, c] in faces {
        writeln!(out, "3 {a} {b} {c}").unwrap();
    }
    out
}

fn command(dir: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homeo"));
    command.current_dir(dir).args(args).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

fn homeo(dir: &Path, args: &[&str]) -> Output {
    command(dir, args).output().unwrap()
}

const KEPT: [&str; 8] = ["build", "m.off", "-o", "s.h5", "--checkpoint", "work", "--checkpoint-every", "0"];

/// Waits until the file is there, or the process is over.
fn wait_for(file: &Path, child: &mut Child) -> bool {
    let start = Instant::now();
    while start.elapsed() < Duration::from_secs(300) {
        if file.exists() {
            return true;
        }
        if child.try_wait().unwrap().is_some() {
            return false;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    false
}

#[test]
fn a_build_that_is_killed_again_and_again_ends_with_the_same_files() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name);
    std::fs::write(path("m.off"), bumpy(4)).unwrap();
    let whole = homeo(dir.path(), &["build", "m.off", "-o", "whole.h5", "--threads", "1"]);
    assert_eq!(whole.status.code(), Some(0), "{whole:?}");
    let mut kills = 0;
    for round in 0..12u64 {
        let mut child = command(dir.path(), &KEPT).spawn().unwrap();
        if !wait_for(&path("work"), &mut child) {
            break;
        }
        std::thread::sleep(Duration::from_millis(5 + 11 * (round * 7 % 5)));
        child.kill().unwrap();
        child.wait().unwrap();
        if !path("work").exists() {
            break;
        }
        kills += 1;
    }
    assert!(kills > 2, "killed {kills} times only");
    let last = homeo(dir.path(), &KEPT);
    assert_eq!(last.status.code(), Some(0), "{last:?}");
    assert_eq!(std::fs::read(path("s.h5")).unwrap(), std::fs::read(path("whole.h5")).unwrap());
    assert!(!path("work").exists(), "removed after success");
}

#[test]
fn what_was_stopped_is_valid_and_goes_on() {
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name);
    std::fs::write(path("m.off"), bumpy(3)).unwrap();
    assert!(homeo(dir.path(), &["build", "m.off", "-o", "whole.h5"]).status.success());
    let stopped = homeo(dir.path(), &[&KEPT[..], &["--time-limit", "0"]].concat());
    assert_eq!(stopped.status.code(), Some(0), "{stopped:?}");
    assert!(path("work").exists(), "kept for going on");
    assert!(homeo(dir.path(), &["check", "s.h5.cert", "s.h5"]).status.success());
    // Other options and another mesh are refused by name, and the checkpoint stays.
    let refused = homeo(dir.path(), &[&KEPT[..], &["--seed", "3"]].concat());
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("work: the checkpoint is of other options"));
    std::fs::write(path("n.off"), bumpy(2)).unwrap();
    let refused = homeo(dir.path(), &["build", "n.off", "-o", "n.h5", "--checkpoint", "work"]);
    assert!(String::from_utf8_lossy(&refused.stderr).contains("work: the checkpoint is of another mesh"));
    let own = homeo(dir.path(), &["build", "m.off", "-o", "n.h5", "--checkpoint", "m.off"]);
    assert_eq!(own.status.code(), Some(2), "never over an input");
    assert!(homeo(dir.path(), &KEPT).status.success());
    assert_eq!(std::fs::read(path("s.h5")).unwrap(), std::fs::read(path("whole.h5")).unwrap());
    assert!(!path("work").exists());
}
