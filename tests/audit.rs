//! `homeo audit` as a user runs it, above all a batch that is killed again and again.
#![allow(clippy::unwrap_used, clippy::panic)]

mod command;

use std::collections::HashSet;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use command::{schema, validate};
use homeo::construct::icosphere;
use homeo::mesh::{Format, TriMesh, write};

fn homeo(arguments: &[&str], folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_homeo"));
    command.args(arguments).current_dir(folder);
    command
}

fn run(arguments: &[&str], folder: &Path) -> Output {
    homeo(arguments, folder).output().unwrap()
}

fn fits(file: &Path, name: &str) {
    let value: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap();
    validate(&value, &schema(name), name).unwrap();
}

fn scaled(level: u32, factor: f64) -> TriMesh {
    let mut mesh = icosphere(level);
    mesh.vertices.iter_mut().for_each(|p| *p = p.map(|x| factor * x));
    mesh
}

fn save(folder: &Path, name: &str, mesh: &TriMesh) {
    write(&folder.join(name), mesh, Format::Off).unwrap();
}

#[test]
fn a_pair_leaves_a_directory_that_the_checkers_accept() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    save(at, "a.off", &icosphere(1));
    save(at, "b.off", &icosphere(2));
    let out = run(
        &[
            "audit", "a.off", "b.off", "-o", "out", "--junit", "j.xml", "--vtu", "v.vtu", "--html", "r.html",
            "-q",
        ],
        at,
    );
    let text = String::from_utf8(out.stdout).unwrap();
    assert_eq!(out.status.code(), Some(0), "{text}{}", String::from_utf8_lossy(&out.stderr));
    assert!(text.contains("VERDICT  bijective: "));
    let composed = ["check", "compose", "a.cert", "b.cert", "shell.h5", "a.off", "b.off"];
    let checked = run(&composed, &at.join("out"));
    assert_eq!(String::from_utf8(checked.stdout).unwrap(), "valid\ncomposition certified\n");
    for file in ["out/audit.json", "j.xml", "v.vtu", "r.html"] {
        assert!(at.join(file).is_file(), "{file}");
    }
    fits(&at.join("out/audit.json"), "audit");
    // Far away: every kind of member is there.
    save(at, "far.off", &scaled(2, 9.0));
    let out = run(&["audit", "a.off", "far.off", "--try", "a", "-o", "far", "-q"], at);
    assert_eq!(out.status.code(), Some(1));
    fits(&at.join("far/audit.json"), "audit");
    let out = run(&["audit", "a.off"], at);
    assert_eq!(out.status.code(), Some(2));
    assert_eq!(run(&["audit", "a.off", "none.off"], at).status.code(), Some(2));
}

#[test]
fn a_cage_is_nested_or_not() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    save(at, "mesh.off", &icosphere(2));
    save(at, "cage.off", &scaled(1, 1.5));
    let out = run(&["audit", "--cage", "cage.off", "mesh.off", "-o", "out", "-q"], at);
    assert_eq!(out.status.code(), Some(0), "{}", String::from_utf8_lossy(&out.stderr));
    let checked = run(&["check", "nested.cert", "mesh.off", "cage.off"], &at.join("out"));
    assert_eq!(String::from_utf8(checked.stdout).unwrap(), "valid\nnested certified\n");
    fits(&at.join("out/audit.json"), "audit-cage");
    let out = run(&["audit", "--cage", "mesh.off", "cage.off", "-o", "not", "-q"], at);
    assert_eq!(out.status.code(), Some(1));
    let checked = run(&["check", "nested.cert", "mesh.off", "cage.off"], &at.join("not"));
    assert_eq!(String::from_utf8(checked.stdout).unwrap(), "valid\nnested refuted\n");
    fits(&at.join("not/audit.json"), "audit-cage");
}

/// Keys of all whole lines.
fn keys(file: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(file).unwrap_or_default();
    let whole = text.rfind('\n').map_or("", |i| &text[..i]);
    let key = |l: &str| -> String {
        let value: serde_json::Value = serde_json::from_str(l).unwrap_or_else(|e| panic!("{e}: {l}"));
        value["key"].as_str().unwrap().to_owned()
    };
    whole.lines().map(key).collect()
}

/// Waits until the process has written more lines, or has ended; whether it has ended.
fn wait_for_more(child: &mut Child, file: &Path, than: usize) -> bool {
    let start = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            assert!(status.code().is_some_and(|c| c < 2), "{status}");
            return true;
        }
        if std::fs::read_to_string(file).unwrap_or_default().lines().count() > than {
            return false;
        }
        assert!(start.elapsed() < Duration::from_secs(300), "no result in five minutes");
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn a_batch_killed_at_every_line_loses_and_doubles_none() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    save(at, "mesh.off", &icosphere(1));
    let mut manifest = String::new();
    for i in 0..12_u32 {
        save(at, &format!("cage{i}.off"), &scaled(1, 1.5 + f64::from(i)));
        manifest += &format!("[[cage]]\nmesh = 'mesh.off'\ncage = 'cage{i}.off'\n");
    }
    // The same content under the same name, the same under another, and a file that is not there.
    manifest +=
        "[[cage]]\nmesh = 'mesh.off'\ncage = 'cage0.off'\n[[cage]]\nmesh = 'mesh.off'\ncage = 'none.off'\n";
    manifest += "[[cage]]\nname = 'again'\nmesh = 'mesh.off'\ncage = 'cage0.off'\n";
    std::fs::write(at.join("many.toml"), manifest).unwrap();
    let results = at.join("out/results.jsonl");
    let arguments = ["audit", "--manifest", "many.toml", "--out", "out", "--jobs", "2", "--resume", "-q"];
    let mut kills = 0;
    loop {
        let before = keys(&results);
        let mut child = homeo(&arguments, at).stdout(Stdio::null()).spawn().unwrap();
        let ended = wait_for_more(&mut child, &results, before.len());
        if !ended {
            child.kill().unwrap();
            kills += 1;
        }
        child.wait().unwrap();
        let after = keys(&results);
        assert_eq!(after[..before.len()], before, "a line was lost or changed");
        if ended {
            break;
        }
    }
    let all = keys(&results);
    assert_eq!(all.len(), 14);
    assert_eq!(all.iter().collect::<HashSet<_>>().len(), 14);
    assert!(kills > 0, "the batch was never killed");
    assert!(at.join("out/summary.md").is_file());
    // Again without --resume: refused. In shards and merged: the same results.
    let out = run(&["audit", "--manifest", "many.toml", "--out", "out"], at);
    assert_eq!(out.status.code(), Some(2));
    for shard in ["1/2", "2/2"] {
        run(&["audit", "--manifest", "many.toml", "--out", "shards", "--shard", shard, "-q"], at);
    }
    let files = ["shards/results-1-of-2.jsonl", "shards/results-2-of-2.jsonl"];
    let out = run(&["merge", files[0], files[1], "-o", "all.jsonl"], at);
    assert_eq!(out.status.code(), Some(0));
    let merged: HashSet<String> = keys(&at.join("all.jsonl")).into_iter().collect();
    assert_eq!(merged, all.into_iter().collect());
    // The file appears: its error is no result of this manifest any more.
    save(at, "none.off", &scaled(1, 40.0));
    let out = run(&arguments, at);
    assert_eq!(out.status.code(), Some(0));
    assert!(!std::fs::read_to_string(at.join("out/summary.md")).unwrap().contains("error"));
    assert_eq!(keys(&results).len(), 15);
}

#[test]
fn documents_do_not_replace_inputs() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    save(at, "a.off", &icosphere(0));
    save(at, "b.off", &icosphere(1));
    save(at, "mesh.off", &icosphere(1));
    save(at, "other.off", &icosphere(1));
    let before = std::fs::read(at.join("a.off")).unwrap();
    for arguments in [
        &["audit", "b.off", "a.off", "-o", ".", "-q"][..],
        &["audit", "a.off", "other.off", "-o", ".", "-q"],
        &["audit", "--cage", "other.off", "mesh.off", "-o", ".", "-q"],
    ] {
        assert_eq!(run(arguments, at).status.code(), Some(2), "{arguments:?}");
        assert_eq!(std::fs::read(at.join("a.off")).unwrap(), before);
    }
}
