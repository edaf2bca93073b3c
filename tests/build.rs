//! `homeo build`: what it writes certifies, and what it refuses leaves nothing behind.
// Helpers of tests may panic; clippy knows that only inside `#[test]` functions.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod command;

use std::path::Path;
use std::process::{Command, Output};

use command::{schema, validate};
use serde_json::Value;

const TETRAHEDRON: &str =
    "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
/// Two crossing triangles.
const CROSSING: &str = "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n5 5 0\n3 0 1 2\n3 3 4 5\n";
/// Two triangles in the plane: all four vertices are on the boundary.
const SQUARE: &str = "OFF\n4 2 0\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n3 0 1 2\n3 0 2 3\n";

fn homeo(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_homeo")).current_dir(dir).args(args).output().unwrap()
}

fn json_of(dir: &Path, args: &[&str]) -> Value {
    let done = homeo(dir, args);
    assert_eq!(done.status.code(), Some(0), "{done:?}");
    let value = serde_json::from_slice(&done.stdout).unwrap();
    validate(&value, &schema("build"), "build").unwrap();
    value
}

#[test]
fn what_is_built_certifies() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("t.off"), TETRAHEDRON).unwrap();
    for extra in [&[][..], &["--initial"], &["--time-limit", "0"]] {
        let built = homeo(dir.path(), &[&["build", "t.off", "-o", "s.h5"], extra].concat());
        assert_eq!(built.status.code(), Some(0), "{built:?}");
        assert!(String::from_utf8_lossy(&built.stdout).contains("Checked:     valid\n"), "{built:?}");
        let checked = homeo(dir.path(), &["check", "s.h5.cert", "s.h5"]);
        assert!(String::from_utf8_lossy(&checked.stdout).starts_with("valid\n"), "{checked:?}");
        let words = String::from_utf8_lossy(&checked.stdout).into_owned();
        assert!(words.contains("i2 certified") && !words.contains("refuted"), "{words}");
    }
    // The same input and options give the same bytes.
    let bytes = |name: &str| {
        assert!(homeo(dir.path(), &["build", "t.off", "-o", name]).status.success());
        std::fs::read(dir.path().join(name)).unwrap()
    };
    assert_eq!(bytes("a.h5"), bytes("b.h5"));
}

#[test]
fn what_is_refused_leaves_nothing() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("x.off"), CROSSING).unwrap();
    std::fs::write(dir.path().join("t.off"), TETRAHEDRON).unwrap();
    let refused = homeo(dir.path(), &["build", "x.off", "-o", "x.h5"]);
    assert_eq!(refused.status.code(), Some(2));
    let said = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(said.contains("triangles 0 and 1 meet") && said.lines().count() == 1, "{said}");
    assert_eq!(homeo(dir.path(), &["build", "t.off", "-o", "t.off"]).status.code(), Some(2));
    for wrong in [
        &["--thickness", "0"][..],
        &["--thickness-absolute=-1"],
        &["--thickness", "0.1", "--thickness-absolute", "1"],
        &["--angle", "90"],
        &["--angle", "0"],
        &["--energy", "1.5"],
        &["--json", "t.off"],
        &["--json", "s.h5"],
    ] {
        let refused = homeo(dir.path(), &[&["build", "t.off", "-o", "s.h5"], wrong].concat());
        assert_eq!(refused.status.code(), Some(2), "{wrong:?}");
    }
    let left = std::fs::read_dir(dir.path()).unwrap().count();
    assert_eq!(left, 2, "only the inputs are there");
    assert_eq!(std::fs::read_to_string(dir.path().join("t.off")).unwrap(), TETRAHEDRON);
}

#[test]
fn the_json_says_what_was_built() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("t.off"), TETRAHEDRON).unwrap();
    let report = json_of(
        dir.path(),
        &["build", "t.off", "-o", "s.h5", "--json", "--distance", "--thickness-absolute", "0.25"],
    );
    assert_eq!(report["mesh"]["triangles"], 4);
    assert_eq!((&report["mesh"]["genus"], &report["mesh"]["longest_box_edge"]), (&0.into(), &2.0.into()));
    assert_eq!(report["options"]["thickness"], Value::Null);
    assert_eq!(report["options"]["thickness_absolute"], 0.25);
    assert_eq!(report["checked"], "valid");
    assert!(report["claims"].as_array().unwrap().iter().all(|c| c["verdict"] == "certified"));
    // Halves are no longer than asked for, up to rounding, and shares are of the box edge 2.
    let top = &report["thickness"]["top"];
    assert!(top["max"].as_f64().unwrap() <= 0.25 + 1e-12);
    let share = report["thickness"]["top_share"]["min"].as_f64().unwrap();
    assert!((share - top["min"].as_f64().unwrap() / 2.0).abs() < 1e-15);
    // The hashes are those of the certificate.
    let certificate = std::fs::read_to_string(dir.path().join("s.h5.cert")).unwrap();
    for part in ["shell", "mesh"] {
        let hash = report[part]["sha256"].as_str().unwrap();
        assert!(certificate.lines().any(|l| l.starts_with(&format!("{part} {hash} "))), "{part} {hash}");
    }
    assert_eq!(report["prisms"], report["shell"]["prisms"]);
    let distance = &report["distance"];
    assert!(distance["at_least"].as_f64().unwrap() <= distance["at_most"].as_f64().unwrap());

    std::fs::write(dir.path().join("q.off"), SQUARE).unwrap();
    let report =
        json_of(dir.path(), &["build", "--json", "q.off", "-o", "q.h5", "--no-certify", "--initial"]);
    for kind in ["boundary", "frozen"] {
        assert_eq!(report[kind]["ids"], serde_json::json!([0, 1, 2, 3]), "{kind}");
    }
    assert_eq!((&report["singular"]["count"], &report["mesh"]["boundary_loops"]), (&0.into(), &1.into()));
    assert_eq!((&report["checked"], &report["certificate"]), (&Value::Null, &Value::Null));
    assert!(report["claims"].as_array().unwrap().iter().all(|c| c["verdict"] == "not-run"));
    assert_eq!((&report["operations"], &report["distance"]), (&Value::Null, &Value::Null));
    assert!(!dir.path().join("q.h5.cert").exists());
}

#[test]
fn the_bound_on_distortion_is_used() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("m.off"), bumpy(2)).unwrap();
    let prisms = |angle: &str| {
        let made =
            ["build", "m.off", "-o", "m.h5", "--json", "--no-certify", "--polish", "2", "--angle", angle];
        json_of(dir.path(), &made)["prisms"].as_u64().unwrap()
    };
    assert!(prisms("50") > prisms("89"));
}

/// An icosphere with bumps, as OFF.
fn bumpy(level: u32) -> String {
    let mesh = homeo::construct::icosphere(level);
    let mut text = format!("OFF\n{} {} 0\n", mesh.vertices.len(), mesh.faces.len());
    for (i, p) in mesh.vertices.iter().enumerate() {
        let f = 1.0 + 0.002 * ((i as u64).wrapping_mul(2_654_435_761) >> 7 & 15) as f64;
        text += &format!("{} {} {}\n", p[0] * f, p[1] * f, p[2] * f);
    }
    for [a, b, c] in &mesh.faces {
        text += &format!("3 {a} {b} {c}\n");
    }
    text
}

#[cfg(unix)]
mod interrupted {
    use std::io::{BufRead as _, BufReader, Read as _};
    use std::process::{Child, Command, Stdio};

    use super::{bumpy, homeo};

    fn interrupt(child: &Child) {
        let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
        assert!(sent.success());
    }

    #[test]
    fn the_best_shell_so_far_is_written_and_certifies() {
        let dir = tempfile::tempdir().unwrap();
        std::fs::write(dir.path().join("m.off"), bumpy(5)).unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_homeo"))
            .current_dir(dir.path())
            .args(["build", "m.off", "-o", "m.h5", "--progress", "plain", "--distance"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
        // Every line names a stage; optimisation begins with `coarsening`.
        let seen =
            lines.by_ref().map(Result::unwrap).find(|l| l.contains("coarsening")).expect("no such line");
        assert!(seen.starts_with("homeo: coarsening") && seen.contains(" prisms, "), "{seen}");
        interrupt(&child);
        for _ in lines {}
        let mut said = String::new();
        child.stdout.take().unwrap().read_to_string(&mut said).unwrap();
        assert_eq!(child.wait().unwrap().code(), Some(0), "{said}");
        assert!(said.contains("stopped early") && said.contains("Checked:     valid"), "{said}");
        assert!(said.starts_with("note: interrupted: the distance was not enclosed\n"), "{said}");
        let checked = homeo(dir.path(), &["check", "m.h5.cert", "m.h5"]);
        assert!(String::from_utf8_lossy(&checked.stdout).starts_with("valid\n"), "{checked:?}");
        let certified = homeo(dir.path(), &["certify", "m.h5", "--claim", "positivity"]);
        assert_eq!(certified.status.code(), Some(0), "{certified:?}");
    }

    #[test]
    fn a_second_interruption_ends_at_once() {
        let dir = tempfile::tempdir().unwrap();
        std::fs::write(dir.path().join("m.off"), bumpy(5)).unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_homeo"))
            .current_dir(dir.path())
            .args(["build", "m.off", "-o", "m.h5", "--progress", "plain"])
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
        lines.by_ref().map(Result::unwrap).find(|l| l.contains("coarsening")).expect("no such line");
        interrupt(&child);
        // The shell is being certified, which takes seconds.
        // Signals that are pending together are one signal.
        std::thread::sleep(std::time::Duration::from_millis(300));
        interrupt(&child);
        assert_eq!(child.wait().unwrap().code(), Some(2));
        assert!(!dir.path().join("m.h5").exists() && !dir.path().join("m.h5.cert").exists());
    }
}

#[test]
fn self_intersections_can_be_allowed() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("x.off"), CROSSING).unwrap();
    let built = homeo(dir.path(), &["build", "x.off", "-o", "x.h5", "--allow-self-intersections"]);
    assert_eq!(built.status.code(), Some(0), "{built:?}");
    let said = String::from_utf8_lossy(&built.stdout).into_owned();
    assert!(said.contains("section-all-orders") && said.contains("Not claimed: disjoint, i2"), "{said}");
    let checked = homeo(dir.path(), &["check", "x.h5.cert", "x.h5"]);
    assert!(String::from_utf8_lossy(&checked.stdout).starts_with("valid\n"), "{checked:?}");
}
