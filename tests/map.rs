//! `homeo map` and `mesh-info` of tet meshes as a user runs them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers outside of #[test] functions

mod command;

use command::{code, homeo, path, schema, stderr, stdout, validate};
use serde_json::Value;

fn json_of(arguments: &[&str], name: &str) -> (i32, Value) {
    let done = homeo(&[arguments, &["--json", "-"]].concat());
    let value: Value =
        serde_json::from_str(&stdout(&done)).unwrap_or_else(|e| panic!("{e}: {}", stderr(&done)));
    validate(&value, &schema(name), name).unwrap();
    (code(&done), value)
}

const TET: &str = "MeshVersionFormatted 1\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n1 2 3 4 0\nEnd\n";

#[test]
fn tets_with_two_position_sets() {
    let t = tempfile::tempdir().unwrap();
    let [a, moved, flat, cert] =
        ["a.mesh", "moved.txt", "flat.txt", "out.cert"].map(|name| path(t.path(), name));
    std::fs::write(&a, TET).unwrap();
    std::fs::write(&moved, "0 0 0\n1/3 0 0\n0 1/7 0\n5 5 1/9\n").unwrap();
    std::fs::write(&flat, "0 0 0\n1/3 0 0\n0 1/7 0\n5 5 0\n").unwrap();
    let directory = path(t.path(), "");
    let (exit, report) =
        json_of(&["map", "-q", &a, &moved, "-o", &cert, "--write-inputs", &directory], "map");
    assert_eq!((exit, report["verdict"].as_str()), (0, Some("certified")));
    let text = std::fs::read_to_string(&cert).unwrap();
    assert!(text.starts_with("homeo-meshes 1\nclaim pl-homeomorphism certified\ninput a "));
    let b = std::fs::read_to_string(path(t.path(), "b.complex")).unwrap();
    assert_eq!(
        b,
        "homeo-complex 1\nspace 3\ncorners 4\nvertices 4\n0 0 0\n1/3 0 0\n0 1/7 0\n5 5 1/9\ncells 1\n0 1 2 3\nend\n"
    );
    let (exit, report) = json_of(&["map", "-q", &a, &flat], "map");
    assert_eq!((exit, report["verdict"].as_str()), (1, Some("refuted")));
    assert_eq!(report["inputs"][1]["reasons"][0]["line"], "sign b 0 0");
    let (exit, report) = json_of(&["mesh-info", &a], "tet-info");
    assert_eq!((exit, report["tets"]["least_determinant"]["exact"].as_str()), (0, Some("1*2^0")));
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\n";

#[test]
fn texture_maps() {
    let t = tempfile::tempdir().unwrap();
    let file = path(t.path(), "uv.obj");
    let with = |last: &str| std::fs::write(&file, format!("{SQUARE}{last}\n")).unwrap();
    with("f 1/1 3/3 4/4");
    let (exit, report) = json_of(&["map", "-q", &file], "map");
    assert_eq!((exit, &report["inputs"][1]["dimension"]), (0, &Value::from(2)));
    // The last corner on the wrong side of the diagonal.
    with("vt 1 0\nf 1/1 3/3 4/5");
    assert_eq!(code(&homeo(&["map", "-q", &file])), 1);
    // A seam along the diagonal.
    with("vt 5 5\nvt 6 6\nf 1/5 3/6 4/4");
    let seams = homeo(&["map", "-q", &file]);
    assert_eq!(code(&seams), 2);
    assert!(stderr(&seams).contains("seams cut the surface: 2 vertices"), "{}", stderr(&seams));
    let (exit, report) = json_of(&["map", "-q", "--cut", &file], "map");
    // Cut open, the surface still touches itself along the seam in space; in the plane it does not.
    assert_eq!((exit, report["inputs"][0]["embedded"].as_bool()), (1, Some(false)));
}

#[test]
fn correspondences_and_embedding() {
    let t = tempfile::tempdir().unwrap();
    let [mesh, places] = ["m.off", "places.txt"].map(|name| path(t.path(), name));
    std::fs::write(&mesh, "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n").unwrap();
    let map = |last: &str| {
        std::fs::write(&places, format!("0 1 0 0\n0 0 1 0\n0 0 0 2\n{last}\n")).unwrap();
        homeo(&["map", "--correspondence", &places, &mesh, &mesh])
    };
    let fits = map("1 0 0 1/3");
    assert_eq!(code(&fits), 0);
    // Nothing is called certified that no checker can be asked about.
    assert!(stdout(&fits).starts_with("map by correspondence: homeomorphism\n"), "{}", stdout(&fits));
    assert_eq!(code(&map("0 0 1 0")), 1);
    let bent = map("0 0 1 1");
    assert_eq!(code(&bent), 1, "{}", stderr(&bent));
    let negative = map("1 0 -1 2");
    assert_eq!(code(&negative), 2);
    assert!(stderr(&negative).contains("places.txt:4: expected a weight >= 0"), "{}", stderr(&negative));
    let none = map("");
    assert!(stderr(&none).contains("3 places for 4 vertices"), "{}", stderr(&none));
    let (exit, report) = json_of(&["map", "-q", "--embedded", &mesh], "map");
    assert_eq!((exit, report["claim"].as_str()), (0, Some("embedded")));
}
