//! `homeo demo`, `inspect`, `mesh-info` and `convert` as a user runs them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers outside of #[test] functions

mod command;

use command::{code, demo, homeo, path, schema, shells, stderr, stdout, validate};
use serde_json::Value;

fn json_of(arguments: &[&str], name: &str) -> (i32, Value) {
    let done = homeo(arguments);
    let value = serde_json::from_slice(&done.stdout).unwrap_or_else(|e| panic!("{e}: {}", stderr(&done)));
    validate(&value, &schema(name), name).unwrap();
    (code(&done), value)
}

#[test]
fn the_demo_proves_refutes_and_checks() {
    let done = homeo(&["demo"]);
    let text = stdout(&done);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert_eq!(text.matches("CERTIFIED").count(), 6);
    assert_eq!(text.matches("REFUTED").count(), 6);
    assert_eq!(text.lines().filter(|l| l.trim() == "valid").count(), 2);
    assert!(text.contains("Nothing was written"));
    let t = tempfile::tempdir().unwrap();
    let directory = t.path().join("new/demo");
    demo(&directory);
    let mut names: Vec<_> = std::fs::read_dir(&directory)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, ["damaged.cert", "damaged.h5", "demo.cert", "demo.h5"]);
    // A file in the directory's place.
    let file = path(t.path(), "file");
    std::fs::write(&file, "x").unwrap();
    let refused = homeo(&["demo", "--out", &file]);
    assert_eq!((code(&refused), stderr(&refused).lines().count()), (2, 1));
}

#[test]
fn inspect_counts_the_demo_shell() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let h5 = path(t.path(), "demo.h5");
    let (exit, report) = json_of(&["inspect", "--json", &h5], "inspect");
    assert_eq!(exit, 0);
    let shell = &report["shell"];
    // A sphere of 20 * 4^2 triangles: V - E + F = 2 and 2 E = 3 F.
    assert_eq!([&shell["prisms"], &shell["vertices"], &shell["sides"]], [320, 162, 480]);
    assert_eq!([&shell["euler_characteristic"], &shell["genus"], &shell["components"]], [2, 0, 1]);
    assert_eq!([&report["boundary_sides"], &shell["boundary_loops"]], [0, 0]);
    assert_eq!(report["mesh"]["faces"], 1280);
    let range = shell["approximate_top_thickness"].as_array().unwrap();
    assert!(range.iter().all(|x| (x.as_f64().unwrap() - 0.1875).abs() < 1e-12));
    assert!(stdout(&homeo(&["inspect", &h5])).contains("(approximate)"));
}

#[test]
fn pillars_of_real_shells_are_straight_bent_and_pinched() {
    let Some(directory) = shells("pillars") else { return };
    // Counted with rational arithmetic in another language.
    for (file, expected) in [
        ("cube.obj.h5", [15, 20, 0]),
        ("cube.obj.thick50.h5", [10, 21, 0]),
        ("tennis.off.h5", [32, 21, 1]),
        ("sphere.obj.h5.init", [336, 46, 0]),
        ("bunny.off.h5", [74, 55, 0]),
    ] {
        let (exit, report) = json_of(&["inspect", &path(&directory, file), "--json"], "inspect");
        let pillars = &report["shell"]["pillars"];
        assert_eq!(exit, 0);
        assert_eq!(["straight", "bent", "pinched"].map(|k| pillars[k].as_u64().unwrap()), expected, "{file}");
    }
}

#[test]
fn inspect_and_certify_name_a_broken_condition() {
    let t = tempfile::tempdir().unwrap();
    let mesh = path(t.path(), "two.off");
    // Two triangles that run along their common edge in the same direction.
    std::fs::write(&mesh, "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n3 0 1 2\n3 0 1 3\n").unwrap();
    let arguments = ["--bottom", &mesh, "--middle", &mesh, "--top", &mesh];
    let inspected = homeo(&[&["inspect"][..], &arguments].concat());
    assert_eq!(code(&inspected), 1, "{}", stderr(&inspected));
    assert!(stdout(&inspected).contains("BROKEN: "), "{}", stdout(&inspected));
    let certified = homeo(&[&["certify", "--claim", "positivity"][..], &arguments].concat());
    assert_eq!((code(&certified), stderr(&certified).lines().count()), (2, 1));
    assert!(stderr(&certified).contains("no valid input"), "{}", stderr(&certified));
    let (exit, report) = json_of(&["mesh-info", "--json", &mesh], "mesh-info");
    assert_eq!((exit, report["valid"].as_bool()), (1, Some(false)));
    assert_eq!(report["info"]["defects"], serde_json::json!([["inconsistent-orientation", 1]]));
}

#[test]
fn mesh_info_of_a_tetrahedron() {
    let t = tempfile::tempdir().unwrap();
    let mesh = path(t.path(), "t.obj");
    std::fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n")
        .unwrap();
    let (exit, report) = json_of(&["mesh-info", &mesh, "--json"], "mesh-info");
    assert_eq!((exit, report["valid"].as_bool()), (0, Some(true)));
    assert_eq!([&report["info"]["edges"], &report["info"]["euler_characteristic"]], [6, 2]);
    assert_eq!(report["info"]["bounding_box"], serde_json::json!([[0.0, 0.0, 0.0], [1.0, 1.0, 1.0]]));
    assert!(stdout(&homeo(&["mesh-info", &mesh])).contains("valid input"));
}

#[test]
fn conversions_lose_no_bit() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, prefix, again] = ["demo.h5", "p", "again.h5"].map(|n| path(t.path(), n));
    for (format, extension) in
        [("off", "off"), ("obj", "obj"), ("ply", "ply"), ("ply-ascii", "ply"), ("ply-be", "ply")]
    {
        let parted = homeo(&["convert", &h5, "--to-meshes", &prefix, "--format", format]);
        assert_eq!(code(&parted), 0, "{}", stderr(&parted));
        let [b, m, top, mesh] =
            ["bottom", "middle", "top", "mesh"].map(|p| format!("{prefix}.{p}.{extension}"));
        let joined =
            homeo(&["convert", &again, "--bottom", &b, "--middle", &m, "--top", &top, "--mesh", &mesh]);
        assert_eq!(code(&joined), 0, "{}", stderr(&joined));
        assert_eq!(std::fs::read(&again).unwrap(), std::fs::read(&h5).unwrap(), "{format}");
    }
    let vtu = path(t.path(), "demo.vtu");
    assert_eq!(code(&homeo(&["convert", &h5, &vtu])), 0);
    assert!(std::fs::read(&vtu).unwrap().starts_with(b"<?xml"));
    let [off, obj, back] = ["m.off", "m.obj", "b.off"].map(|n| path(t.path(), n));
    for pair in [[&h5, &off], [&off, &obj], [&obj, &back]] {
        let done = homeo(&["convert", pair[0].as_str(), pair[1].as_str()]);
        assert_eq!(code(&done), 0, "{}", stderr(&done));
    }
    assert_eq!(std::fs::read(&off).unwrap(), std::fs::read(&back).unwrap());
    let no_shell = homeo(&["convert", &off, &again]);
    assert_eq!((code(&no_shell), stderr(&no_shell).lines().count()), (2, 1));
    let no_format = homeo(&["convert", &off, &path(t.path(), "x.xyz")]);
    assert_eq!((code(&no_format), stderr(&no_format).lines().count()), (2, 1));
}

#[test]
fn a_mesh_format_unknown_to_the_checker_is_converted_for_it() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, ply, cert] = ["demo.h5", "m.ply", "m.cert"].map(|n| path(t.path(), n));
    assert_eq!(code(&homeo(&["convert", &h5, &ply])), 0);
    let done = homeo(&["certify", &h5, "--mesh", &ply, "-o", &cert]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stdout(&done).contains("homeo convert"), "{}", stdout(&done));
    assert_eq!(std::fs::read(&cert).unwrap(), std::fs::read(path(t.path(), "demo.cert")).unwrap());
}

#[test]
fn project_gives_exact_images_of_a_known_prism() {
    let t = tempfile::tempdir().unwrap();
    let meshes = ["-1", "0", "1"].map(|z| {
        let file = path(t.path(), &format!("z{z}.off"));
        std::fs::write(&file, format!("OFF\n3 1 0\n0 0 {z}\n1 0 {z}\n0 1 {z}\n3 0 1 2\n")).unwrap();
        file
    });
    let points = path(t.path(), "points.txt");
    std::fs::write(&points, "# two points\n0.25 0.5 0.75\n\n 5 5 5 \n").unwrap();
    let [b, m, top] = &meshes;
    let shell = ["project", "--bottom", b, "--middle", m, "--top", top];
    let inside = homeo(&[&shell[..], &["--json", "--point", "0.125", "0.25", "-0.5"]].concat());
    let report: Value = serde_json::from_slice(&inside.stdout).unwrap();
    validate(&report, &schema("project"), "project").unwrap();
    let image = &report["points"][0]["images"][0];
    // In a straight unit prism the image is the point itself.
    assert_eq!(image["weights"], serde_json::json!(["5/8", "1/8", "1/4"]));
    assert_eq!((&image["height"], &image["prism"]), (&serde_json::json!("-1/2"), &serde_json::json!(0)));
    assert_eq!(code(&inside), 0);
    let outside = homeo(&[&shell[..], &["--points", &points]].concat());
    assert_eq!(code(&outside), 1);
    assert!(stdout(&outside).contains("exactly 1/4 1/4 1/2, height 3/4"), "{}", stdout(&outside));
    assert!(stdout(&outside).contains("outside of the shell"));
    for bad in ["0 0", "0 0 0 0", "0 0 nan", "a b c"] {
        std::fs::write(&points, format!("0 0 0\n{bad}\n")).unwrap();
        let done = homeo(&[&shell[..], &["--points", &points]].concat());
        assert_eq!((code(&done), stderr(&done).lines().count()), (2, 1), "{bad}");
        assert!(stderr(&done).contains("line 2"), "{}", stderr(&done));
    }
    let nan = homeo(&[&shell[..], &["--point", "nan", "0", "0"]].concat());
    assert_eq!((code(&nan), stderr(&nan).lines().count()), (2, 1));
}
