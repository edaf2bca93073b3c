//! `homeo certify` and `homeo check` as a user runs them.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers outside of #[test] functions

mod command;

use command::{code, demo, homeo, path, schema, shells, stderr, stdout, validate};
use serde_json::Value;

fn json_of(arguments: &[&str]) -> (i32, Value) {
    let done = homeo(arguments);
    let value = serde_json::from_slice(&done.stdout).unwrap_or_else(|e| panic!("{e}: {}", stderr(&done)));
    validate(&value, &schema("certify"), "certify").unwrap();
    (code(&done), value)
}

/// Verdicts in the order positivity, section, bijection, section-all-orders, disjoint, i2: `c`, `r` or `n`.
fn verdicts(report: &Value) -> String {
    report["claims"].as_array().unwrap().iter().map(|c| &c["verdict"].as_str().unwrap()[..1]).collect()
}

struct Expected {
    file: &'static str,
    triangles: u64,
    prisms: u64,
    tets: u64,
    bad: u64,
    /// Pairs of mesh triangles with bottom and with top triangles.
    hits: [u64; 2],
    verdicts: &'static str,
}

const fn valid(file: &'static str, triangles: u64, prisms: u64, tets: u64) -> Expected {
    Expected { file, triangles, prisms, tets, bad: 0, hits: [0, 0], verdicts: "cccccc" }
}

/// From the index that comes with the shells: found with other programs.
const SHELLS: &[Expected] = &[
    valid("cube.obj.h5", 12, 66, 1584),
    valid("cube.obj.h5.init", 12, 156, 3744),
    valid("cube.obj.thick50.h5", 12, 58, 1392),
    valid("sphere.obj.h5", 760, 760, 18240),
    valid("sphere.obj.h5.init", 760, 760, 18240),
    valid("bumpy.off.h5", 2496, 162, 3888),
    valid("bumpy.off.h5.init", 2496, 2496, 59904),
    valid("c_spot.obj.h5", 5856, 238, 5712),
    valid("bunny.off.h5", 6966, 254, 6096),
    valid("bunny.off.h5.init", 6966, 13954, 334_896),
    valid("c_homer.obj.h5", 12000, 512, 12288),
    valid("c_homer.obj.h5.init", 12000, 16628, 399_072),
    valid("decimated-knight.off.h5", 1000, 620, 14880),
    valid("decimated-knight.off.h5.init", 1000, 11416, 273_984),
    valid("fandisk.off.h5", 14454, 146, 3504),
    // In these two the index counts 16 tets for a prism with a pinched corner, as `homeo` does.
    valid("tennis.off.h5", 94, 104, 2384),
    valid("tennis.off.h5.init", 94, 1318, 30480),
    Expected {
        file: "decimated-knight.off.h5.extract.h5",
        triangles: 1000,
        prisms: 720,
        tets: 17280,
        bad: 16,
        hits: [0, 0],
        verdicts: "rrrrcr",
    },
    Expected {
        file: "bunny.off.h5.extract.h5",
        triangles: 6966,
        prisms: 260,
        tets: 6240,
        bad: 2,
        hits: [0, 0],
        verdicts: "rccrcr",
    },
    Expected {
        file: "bunny.off.allowint.h5",
        triangles: 6966,
        prisms: 104,
        tets: 2496,
        bad: 0,
        hits: [618, 1498],
        verdicts: "crrrrr",
    },
];

#[test]
fn real_shells_have_the_verdicts_that_other_programs_found() {
    let Some(directory) = shells("real shells") else { return };
    let temporary = tempfile::tempdir().unwrap();
    let cert = path(temporary.path(), "out.cert");
    for shell in SHELLS {
        let file = path(&directory, shell.file);
        let (exit, report) = json_of(&["certify", &file, "-o", &cert, "--json"]);
        assert_eq!(verdicts(&report), shell.verdicts, "{}", shell.file);
        assert_eq!(exit, i32::from(shell.verdicts != "cccccc"), "{}", shell.file);
        assert_eq!(report["verdict"] == "certified", exit == 0);
        assert_eq!(report["mesh"]["triangles"], shell.triangles, "{}", shell.file);
        assert_eq!(report["shell"]["prisms"], shell.prisms, "{}", shell.file);
        assert_eq!(report["shell"]["tets"], shell.tets, "{}", shell.file);
        assert_eq!(report["claims"][0]["counts"]["tets_not_positive"], shell.bad, "{}", shell.file);
        let hits =
            [1, 2].map(|part: usize| report["claims"][4]["parts"][part]["crossings"].as_u64().unwrap());
        assert_eq!(hits, shell.hits, "{}", shell.file);
        assert_eq!(report["checked"], "valid");
        let checked = homeo(&["check", &cert, &file]);
        assert_eq!((code(&checked), stdout(&checked).lines().next()), (0, Some("valid")), "{}", shell.file);
    }
}

#[test]
fn a_certificate_of_another_shell_is_invalid() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, cert, other] = ["demo.h5", "demo.cert", "damaged.h5"].map(|n| path(t.path(), n));
    assert_eq!(code(&homeo(&["check", &cert, &h5])), 0);
    let wrong = homeo(&["check", &cert, &other]);
    assert_eq!(code(&wrong), 1);
    assert!(stdout(&wrong).starts_with("invalid hash"), "{}", stdout(&wrong));
}

#[test]
fn words_say_what_was_decided_and_how_to_check_it() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, damaged, cert] = ["demo.h5", "damaged.h5", "new.cert"].map(|n| path(t.path(), n));
    let good = homeo(&["certify", &h5, "-o", &cert]);
    assert_eq!(code(&good), 0);
    assert_eq!(stdout(&good).matches("CERTIFIED").count(), 6);
    assert!(stdout(&good).contains(&format!("homeo-check {cert} {h5}")));
    assert_eq!(stderr(&good), "");
    let bad = homeo(&["certify", &damaged, "-o", &cert]);
    assert_eq!(code(&bad), 1);
    assert!(
        stdout(&bad).contains("REFUTED    positivity: 20 of the 7680 different tets"),
        "{}",
        stdout(&bad)
    );
}

#[test]
fn only_requested_claims_count_and_all_six_are_reported() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, damaged] = ["demo.h5", "damaged.h5"].map(|n| path(t.path(), n));
    let (exit, report) = json_of(&["certify", &h5, "--claim", "positivity", "--json"]);
    assert_eq!((exit, verdicts(&report).as_str()), (0, "cnnnnn"));
    let (exit, report) = json_of(&["certify", "--claim", "section", "disjoint", "--json", &h5]);
    assert_eq!((exit, verdicts(&report).as_str()), (0, "nccncn"));
    let (exit, report) = json_of(&["certify", "--json", "--claim", "positivity,bijection", &damaged]);
    assert_eq!((exit, verdicts(&report).as_str()), (1, "rrrnnn"));
    let requested: Vec<bool> =
        report["claims"].as_array().unwrap().iter().map(|c| c["requested"] == true).collect();
    assert_eq!(requested, [true, false, true, false, false, false]);
    let unknown = homeo(&["certify", &h5, "--claim", "truth"]);
    assert_eq!(code(&unknown), 2);
    assert!(stderr(&unknown).contains("`truth`"));
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    for name in ["demo", "damaged"] {
        let h5 = path(t.path(), &format!("{name}.h5"));
        let certificates = ["1", "2", "5"].map(|threads| {
            let out = path(t.path(), "threads.cert");
            homeo(&["certify", &h5, "--threads", threads, "-o", &out]);
            std::fs::read(out).unwrap()
        });
        assert!(certificates.iter().all(|c| *c == certificates[0]), "{name}");
        assert_eq!(certificates[0], std::fs::read(path(t.path(), &format!("{name}.cert"))).unwrap());
    }
    for threads in ["0", "-1", "x", "4000000000"] {
        let argument = format!("--threads={threads}");
        assert_eq!(code(&homeo(&["certify", &path(t.path(), "demo.h5"), &argument])), 2);
    }
}

#[test]
fn nothing_is_overwritten_unless_there_is_a_verdict() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, cert, junk] = ["demo.h5", "out.cert", "junk.h5"].map(|n| path(t.path(), n));
    std::fs::write(&cert, "precious").unwrap();
    std::fs::write(&junk, "junk").unwrap();
    for arguments in [
        vec!["certify", &junk, "-o", &cert],
        vec!["certify", &h5, "--mesh", &junk, "-o", &cert],
        vec!["certify", &h5, "--order", &junk, "-o", &cert],
        vec!["certify", &h5, "--claim", "none", "-o", &cert],
        vec!["convert", &junk, &cert],
    ] {
        assert_eq!(code(&homeo(&arguments)), 2, "{arguments:?}");
        assert_eq!(std::fs::read_to_string(&cert).unwrap(), "precious", "{arguments:?}");
    }
    assert_eq!(code(&homeo(&["certify", &h5, "-o", &cert])), 0);
    assert!(std::fs::read_to_string(&cert).unwrap().starts_with("homeo-certificate 1\n"));
}

#[test]
fn inputs_and_devices_are_never_written() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, link, cert] = ["demo.h5", "link.h5", "x.cert"].map(|n| path(t.path(), n));
    let before = std::fs::read(&h5).unwrap();
    std::fs::hard_link(&h5, &link).unwrap();
    let json_input = format!("--json={h5}");
    let json_cert =
        format!("--json={}/../{}/x.cert", t.path().display(), t.path().file_name().unwrap().display());
    for arguments in [
        vec!["certify", &h5, "-o", &h5],
        vec!["certify", &h5, "-o", &link],
        vec!["certify", &h5, &json_input],
        vec!["certify", &h5, "-o", &cert, &json_cert],
        vec!["certify", &h5, "-o", t.path().to_str().unwrap()],
        vec!["certify", &h5, "-o", "/dev/null"],
        vec!["certify", &h5, "-o", "/nonexistent/x.cert"],
        vec!["convert", &h5, &h5],
    ] {
        let done = homeo(&arguments);
        assert_eq!(code(&done), 2, "{arguments:?}");
        assert_eq!(stderr(&done).lines().count(), 1, "{arguments:?}: {}", stderr(&done));
        assert_eq!(std::fs::read(&h5).unwrap(), before, "{arguments:?}");
    }
    assert!(!std::path::Path::new(&cert).exists());
}

#[test]
fn an_order_file_selects_the_decomposition() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, order, cert] = ["demo.h5", "order.txt", "o.cert"].map(|n| path(t.path(), n));
    let reversed: String = (0..162).rev().map(|v| format!("{v}\n")).collect();
    std::fs::write(&order, reversed).unwrap();
    let (exit, report) = json_of(&["certify", &h5, "--order", &order, "-o", &cert, "--json"]);
    assert_eq!((exit, report["order"].as_str()), (0, Some("list")));
    assert!(std::fs::read_to_string(&cert).unwrap().contains("\norder list 161 160 "));
    assert_eq!(code(&homeo(&["check", &cert, &h5])), 0);
    for (text, reason) in
        [("0 1 x", "line 1"), ("0\n1\n1", "3 entries"), ("", "0 entries"), ("0\n-1", "line 2")]
    {
        std::fs::write(&order, text).unwrap();
        let done = homeo(&["certify", &h5, "--order", &order]);
        assert_eq!(code(&done), 2);
        assert!(stderr(&done).contains(&order) && stderr(&done).contains(reason), "{}", stderr(&done));
    }
}

#[test]
fn three_meshes_give_the_same_certificate_as_the_shell_file() {
    let t = tempfile::tempdir().unwrap();
    demo(t.path());
    let [h5, prefix, cert] = ["demo.h5", "p", "three.cert"].map(|n| path(t.path(), n));
    assert_eq!(code(&homeo(&["convert", &h5, "--to-meshes", &prefix])), 0);
    let [b, m, top, mesh] = ["bottom", "middle", "top", "mesh"].map(|p| format!("{prefix}.{p}.off"));
    let arguments =
        ["certify", "--bottom", &b, "--middle", &m, "--top", &top, "--mesh", &mesh, "-o", &cert, "--json"];
    let (exit, report) = json_of(&arguments);
    assert_eq!((exit, verdicts(&report).as_str()), (0, "cccccc"));
    assert_eq!(std::fs::read(&cert).unwrap(), std::fs::read(path(t.path(), "demo.cert")).unwrap());
    assert_eq!(code(&homeo(&["check", &cert, &b, &m, &top, &mesh])), 0);
    let no_mesh = homeo(&["certify", "--bottom", &b, "--middle", &m, "--top", &top]);
    assert_eq!(code(&no_mesh), 2);
    assert!(stderr(&no_mesh).contains("there is none"), "{}", stderr(&no_mesh));
    let shell_only =
        homeo(&["certify", "--bottom", &b, "--middle", &m, "--top", &top, "--claim", "positivity"]);
    assert_eq!(code(&shell_only), 0);
    let mixed = homeo(&["certify", "--bottom", &b, "--middle", &top, "--top", &mesh]);
    assert_eq!(code(&mixed), 2);
}

#[test]
fn an_interrupt_ends_with_exit_code_2_and_writes_nothing() {
    let Some(directory) = shells("an interrupt") else { return };
    let t = tempfile::tempdir().unwrap();
    let cert = path(t.path(), "x.cert");
    let file = path(&directory, "c_homer.obj.h5.init");
    let child = std::process::Command::new(env!("CARGO_BIN_EXE_homeo"))
        .args(["certify", &file, "-o", &cert, "--threads", "1"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    // The handler is there before the file that the certificate is written to.
    let files = || std::fs::read_dir(t.path()).unwrap().count();
    let start = std::time::Instant::now();
    while files() == 0 && start.elapsed().as_secs() < 60 {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let signalled =
        std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(signalled.success());
    let done = child.wait_with_output().unwrap();
    assert_eq!((code(&done), stderr(&done).as_str()), (2, "homeo: interrupted; nothing was written\n"));
    assert_eq!(stdout(&done), "");
    assert_eq!(files(), 0, "neither the certificate nor a temporary file");
}
