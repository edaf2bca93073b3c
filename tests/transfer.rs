//! `homeo transfer` as a user runs it.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers outside of #[test] functions

mod command;

use command::{code, demo, homeo, path, schema, shells, stderr, stdout, validate};
use serde_json::Value;
use std::path::Path;

fn read(file: &str) -> Value {
    serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap()
}

/// The demo's shell, a label for each triangle of its mesh, and a number for each vertex.
fn prepared(directory: &Path) -> [String; 3] {
    demo(directory);
    let [h5, face, vertex] = ["demo.h5", "face.csv", "vertex.csv"].map(|n| path(directory, n));
    let rows: String = (0..1280).map(|f| format!("{f},part{}\n", f % 3)).collect();
    std::fs::write(&face, "face,bc\n".to_owned() + &rows).unwrap();
    let rows: String = (0..642).map(|v| format!("{v},2.5,{v}\n")).collect();
    std::fs::write(&vertex, "vertex,constant,id\n".to_owned() + &rows).unwrap();
    [h5, face, vertex]
}

#[test]
fn attributes_are_carried_with_a_proof() {
    let t = tempfile::tempdir().unwrap();
    let [h5, face, vertex] = prepared(t.path());
    let out = path(t.path(), "out.json");
    let both = ["--attributes", &face, "--attributes", &vertex, "-o", &out];
    let done =
        homeo(&[&["transfer", &h5, "stored", "middle", "--json", "--compare-phong"][..], &both].concat());
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    let report: Value = serde_json::from_slice(&done.stdout).unwrap();
    validate(&report, &schema("transfer"), "transfer").unwrap();
    assert_eq!((report["proved"].as_bool(), report["proofs"].as_array().unwrap().len()), (Some(true), 2));
    assert_eq!(report["exact_round_trips"], report["measured"]["points"]);
    assert!(report["error_bound"].as_f64().unwrap() <= 1e-10);
    assert!(report["measured"]["largest"].as_f64().unwrap() <= report["measured"]["bound"].as_f64().unwrap());
    let carried = read(&out);
    let constant = carried["attributes"]["vertex"]["constant"].as_array().unwrap();
    assert!(constant.len() == 162 && constant.iter().all(|x| x.as_f64() == Some(2.5)));
    let points = carried["points"]["faces"].as_array().unwrap();
    for (label, point) in carried["attributes"]["face"]["bc"].as_array().unwrap().iter().zip(points) {
        assert_eq!(label.as_str().unwrap(), format!("part{}", point["face"].as_u64().unwrap() % 3));
    }
    // Exactly: weights are texts n/d.
    let done = homeo(&[&["transfer", &h5, "stored", "middle", "--exact"][..], &both].concat());
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stdout(&done).contains("(1000 of them equal to the start as rationals)"), "{}", stdout(&done));
    assert!(read(&out)["points"]["faces"][0]["weights"][0].as_str().unwrap().contains('/'));
    // A table holds values of one kind.
    let csv = path(t.path(), "out.csv");
    let done = homeo(&["transfer", &h5, "stored", "middle", "--attributes", &vertex, "-o", &csv]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert_eq!(std::fs::read_to_string(&csv).unwrap().lines().count(), 163);
    let mixed = [&["transfer", &h5, "stored", "middle", "-o", &csv][..], &both[..4]].concat();
    assert_eq!(code(&homeo(&mixed)), 2);
}

#[test]
fn certificates_take_the_place_of_certifying() {
    let t = tempfile::tempdir().unwrap();
    let [h5, _, vertex] = prepared(t.path());
    let [out, mine, middle, other] = ["o.ply", "mine.cert", "middle.cert", "m"].map(|n| path(t.path(), n));
    assert_eq!(code(&homeo(&["convert", &h5, "--to-meshes", &other, "--format", "off"])), 0);
    let mesh = format!("{other}.middle.off");
    for arguments in [vec!["-o", &mine], vec!["--mesh", &mesh, "-o", &middle]] {
        let done = homeo(&[&["certify", &h5, "--claim", "bijection"][..], &arguments].concat());
        assert_eq!(code(&done), 0, "{}", stderr(&done));
    }
    let run = |first: &str, second: &str| {
        let rest = ["--certificate", first, "--certificate", second, "--attributes", &vertex, "-o", &out];
        homeo(&[&["transfer", &h5, "stored", &mesh][..], &rest].concat())
    };
    let done = run(&mine, &middle);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stdout(&done).contains("mine.cert; the independent checker accepts it"), "{}", stdout(&done));
    assert!(homeo::mesh::read(Path::new(&out)).is_ok());
    // Certificates for each other's mesh.
    std::fs::remove_file(&out).unwrap();
    let done = run(&middle, &mine);
    assert_eq!(code(&done), 2);
    assert!(stderr(&done).contains("not certified as a section"), "{}", stderr(&done));
    // One that certifies less, and one about another order.
    let less = path(t.path(), "less.cert");
    assert_eq!(code(&homeo(&["certify", &h5, "--claim", "positivity", "-o", &less])), 0);
    let done = run(&less, &middle);
    assert!(code(&done) == 2 && stderr(&done).contains("does not certify `bijection`"), "{}", stderr(&done));
    let backwards = path(t.path(), "order.txt");
    std::fs::write(&backwards, (0..162).rev().map(|v| format!("{v}\n")).collect::<String>()).unwrap();
    let rest = ["--certificate", &mine, "--certificate", &middle, "--attributes", &vertex, "-o", &out];
    let done = homeo(&[&["transfer", &h5, "stored", &mesh, "--order", &backwards][..], &rest].concat());
    assert!(code(&done) == 2 && stderr(&done).contains("another vertex order"), "{}", stderr(&done));
    assert!(!Path::new(&out).exists());
}

#[test]
fn what_is_not_proved_is_refused_unless_asked_for() {
    let t = tempfile::tempdir().unwrap();
    let [h5, _, vertex] = prepared(t.path());
    let [out, prefix] = ["o.json", "m"].map(|n| path(t.path(), n));
    assert_eq!(code(&homeo(&["convert", &h5, "--to-meshes", &prefix, "--format", "off"])), 0);
    // The top surface is in the shell, but no section.
    let top = format!("{prefix}.top.off");
    let arguments = ["transfer", &h5, "stored", &top, "--attributes", &vertex, "-o", &out];
    let done = homeo(&arguments);
    assert_eq!((code(&done), stderr(&done).lines().count()), (2, 1));
    assert!(
        stderr(&done).contains("`bijection` is refuted") || stderr(&done).contains("`section` is refuted")
    );
    assert!(stderr(&done).contains("--unproved") && !Path::new(&out).exists());
    let done = homeo(&[&arguments[..], &["--unproved"]].concat());
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stdout(&done).contains("UNPROVED"));
    assert_eq!(read(&out)["proved"], false);
    let ply = path(t.path(), "o.ply");
    let last = arguments.len() - 1;
    let done = homeo(&[&arguments[..last], &[&ply, "--unproved"]].concat());
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(std::fs::read_to_string(&ply).unwrap().contains("\ncomment unproved"));
}

#[test]
fn usage_errors_write_nothing() {
    let t = tempfile::tempdir().unwrap();
    let [h5, face, vertex] = prepared(t.path());
    let [txt, ply] = ["o.txt", "o.ply"].map(|n| path(t.path(), n));
    for arguments in [
        vec!["--attributes", &vertex, "-o", &txt],
        vec!["-o", &ply],
        vec!["--attributes", &vertex, "-o", &vertex],
        vec!["--attributes", &h5, "-o", &ply],
        vec!["--attributes", "absent.csv", "-o", &ply],
        vec!["--attributes", &vertex, "-o", &ply, "--certificate", &face],
    ] {
        let done = homeo(&[&["transfer", &h5, "stored", "middle"][..], &arguments].concat());
        assert_eq!((code(&done), stderr(&done).lines().count()), (2, 1), "{arguments:?}: {}", stderr(&done));
        assert!(!Path::new(&ply).exists() && !Path::new(&txt).exists());
    }
}

#[test]
fn real_shells_carry_to_their_sections() {
    let Some(directory) = shells("transfer") else { return };
    let t = tempfile::tempdir().unwrap();
    let out = path(t.path(), "o.json");
    let [h5, section] = ["bumpy.off.h5", "bumpy.off.h5.section.ply"].map(|n| path(&directory, n));
    let done =
        homeo(&["transfer", &h5, "stored", &section, "-o", &out, "--measure", "9000", "--compare-phong"]);
    assert_eq!(code(&done), 0, "{}", stderr(&done));
    assert!(stdout(&done).contains("(9000 of them equal to the start as rationals)"), "{}", stdout(&done));
    eprintln!("{}", stdout(&done));
}
