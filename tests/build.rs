//! `homeo build`: what it writes certifies, and what it refuses leaves nothing behind.
// Helpers of tests may panic; clippy knows that only inside `#[test]` functions.
#![allow(clippy::unwrap_used)]

use std::path::Path;
use std::process::{Command, Output};

const TETRAHEDRON: &str =
    "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n";
/// Two crossing triangles.
const CROSSING: &str = "OFF\n6 2 0\n0 0 0\n4 0 0\n0 4 0\n1 1 -1\n1 1 1\n5 5 0\n3 0 1 2\n3 3 4 5\n";

fn homeo(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_homeo")).current_dir(dir).args(args).output().unwrap()
}

#[test]
fn what_is_built_certifies() {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("t.off"), TETRAHEDRON).unwrap();
    for extra in [&[][..], &["--initial"], &["--time-limit", "0"]] {
        let built = homeo(dir.path(), &[&["build", "t.off", "-o", "s.h5"], extra].concat());
        assert_eq!(built.status.code(), Some(0), "{built:?}");
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
    assert_eq!(
        homeo(dir.path(), &["build", "t.off", "-o", "s.h5", "--thickness", "0"]).status.code(),
        Some(2)
    );
    let left = std::fs::read_dir(dir.path()).unwrap().count();
    assert_eq!(left, 2, "only the inputs are there");
    assert_eq!(std::fs::read_to_string(dir.path().join("t.off")).unwrap(), TETRAHEDRON);
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
