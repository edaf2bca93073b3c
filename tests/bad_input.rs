//! Every command, given files that are no input: one line on standard error, exit code 2, no panic, nothing written.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // helpers outside of #[test] functions

mod command;

use std::path::Path;

use command::{code, demo, homeo, path, stderr, stdout};

/// Files that are wrong in every way, by name and content.
fn bad_files(directory: &Path) -> Vec<String> {
    demo(directory);
    let shell = std::fs::read(directory.join("demo.h5")).unwrap();
    let noise: Vec<u8> = (0_u32..5000).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let mut files: Vec<(&str, Vec<u8>)> = vec![
        ("empty.off", Vec::new()),
        ("empty.h5", Vec::new()),
        ("truncated.h5", shell[..shell.len() / 2].to_vec()),
        ("header.h5", shell[..60].to_vec()),
        ("truncated.off", b"OFF\n3 1 0\n0 0 0\n1 0".to_vec()),
        ("garbage.h5", noise.clone()),
        ("garbage.obj", noise.clone()),
        ("garbage.ply", noise.clone()),
        ("garbage.stl", noise),
        ("giant.off", b"OFF\n1099511627776 1099511627776 0\n0 0 0\n".to_vec()),
        ("giant.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 1099511627776\n".to_vec()),
        ("giant.ply", b"ply\nformat ascii 1.0\nelement vertex 1099511627776\nproperty double x\nproperty double y\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n".to_vec()),
        ("nan.off", b"OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n".to_vec()),
        ("inf.obj", b"v 0 0 0\nv 1 0 inf\nv 0 1 0\nf 1 2 3\n".to_vec()),
        ("line.off", vec![b'7'; 10_000_000]),
        ("line.obj", [b"v ".to_vec(), vec![b'7'; 10_000_000]].concat()),
    ];
    // A count of 2^40 where the shell file states how many rows a dataset has.
    let rows = 162_u64.to_le_bytes();
    let places: Vec<usize> = (0..shell.len() - 8).filter(|&i| shell[i..i + 8] == rows).collect();
    assert!(!places.is_empty());
    let mut giant = shell.clone();
    for place in places {
        giant[place..place + 8].copy_from_slice(&(1_u64 << 40).to_le_bytes());
    }
    files.push(("giant.h5", giant));
    // NaN in place of the first coordinate of the icosahedron, wherever it is stored.
    let g = 0.5 * (1.0 + 5_f64.sqrt());
    let first = (-1.0 / (1.0 + g * g).sqrt()).to_le_bytes();
    let nan_at = (0..shell.len() - 8).find(|&i| shell[i..i + 8] == first).expect("the first coordinate");
    let mut nan = shell;
    nan[nan_at..nan_at + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    files.push(("nan.h5", nan));
    let mut out: Vec<String> = files
        .into_iter()
        .map(|(name, bytes)| {
            let file = path(directory, name);
            std::fs::write(&file, bytes).unwrap();
            file
        })
        .collect();
    std::fs::create_dir(directory.join("directory.h5")).unwrap();
    out.push(path(directory, "directory.h5"));
    out.push(path(directory, "missing.off"));
    out.extend(unreadable(directory));
    out
}

/// A file that may not be read; none when the user is root, who may read everything.
fn unreadable(directory: &Path) -> Option<String> {
    use std::os::unix::fs::PermissionsExt as _;
    let file = path(directory, "unreadable.h5");
    std::fs::write(&file, "x").unwrap();
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o000)).unwrap();
    if std::fs::read(&file).is_ok() {
        eprintln!("SKIPPED: the unreadable file: this user may read everything");
        return None;
    }
    Some(file)
}

fn refused(arguments: &[&str]) {
    let done = homeo(arguments);
    let error = stderr(&done);
    assert_eq!(code(&done), 2, "{arguments:?}: {error}");
    assert_eq!(error.lines().count(), 1, "{arguments:?}: {error}");
    assert!(error.starts_with("homeo: ") && error.len() < 2100, "{arguments:?}: {error}");
    assert!(!error.contains("panicked"), "{arguments:?}: {error}");
    assert_eq!(stdout(&done), "", "{arguments:?}");
}

#[test]
fn no_command_accepts_a_bad_file() {
    let t = tempfile::tempdir().unwrap();
    let files = bad_files(t.path());
    let [good, out, prefix, out_off] = ["demo.h5", "out.cert", "parts", "out.off"].map(|n| path(t.path(), n));
    let [json, vtu] = ["out.json", "out.vtu"].map(|n| path(t.path(), n));
    let json_argument = format!("--json={json}");
    for bad in &files {
        refused(&["certify", bad, "-o", &out, &json_argument]);
        refused(&["certify", &good, "--mesh", bad, "-o", &out]);
        refused(&["certify", "--bottom", bad, "--middle", bad, "--top", bad, "-o", &out]);
        refused(&["certify", &good, "--order", bad, "-o", &out]);
        refused(&["inspect", bad, &json_argument]);
        refused(&["mesh-info", bad, &json_argument]);
        refused(&["project", bad, "--point", "0", "0", "0", &json_argument]);
        refused(&["project", &good, "--points", bad, &json_argument]);
        refused(&["convert", bad, &out_off]);
        refused(&["convert", bad, &vtu]);
        refused(&["convert", bad, "--to-meshes", &prefix]);
        refused(&["convert", "--bottom", bad, "--middle", bad, "--top", bad, &vtu]);
    }
    for written in [out, json, vtu, out_off, format!("{prefix}.bottom.off"), format!("{prefix}.mesh.off")] {
        assert!(!Path::new(&written).exists(), "{written}");
    }
}

#[test]
fn the_checker_calls_bad_files_malformed() {
    let t = tempfile::tempdir().unwrap();
    let files = bad_files(t.path());
    let [good, cert] = ["demo.h5", "demo.cert"].map(|n| path(t.path(), n));
    for bad in &files {
        for arguments in [["check", bad, &good], ["check", &cert, bad]] {
            let done = homeo(&arguments);
            assert_eq!(code(&done), 2, "{arguments:?}: {}", stdout(&done));
            assert!(stdout(&done).starts_with("malformed "), "{arguments:?}: {}", stdout(&done));
            assert_eq!(stdout(&done).lines().count(), 1, "{arguments:?}");
            assert!(!stderr(&done).contains("panicked"));
        }
    }
    let nothing = homeo(&["check"]);
    assert_eq!(code(&nothing), 2);
    assert!(stdout(&nothing).starts_with("malformed usage"));
}

#[test]
fn wrong_usage_is_exit_code_2() {
    for arguments in [
        vec![],
        vec!["frobnicate"],
        vec!["certify"],
        vec!["certify", "--json"],
        vec!["certify", "a", "b"],
        vec!["certify", "--bottom", "x"],
        vec!["inspect"],
        vec!["mesh-info"],
        vec!["convert"],
        vec!["convert", "a"],
        vec!["convert", "a", "b", "c"],
        vec!["demo", "--out"],
    ] {
        let done = homeo(&arguments);
        assert_eq!(code(&done), 2, "{arguments:?}");
        assert!(!stderr(&done).contains("panicked") && !stderr(&done).is_empty(), "{arguments:?}");
    }
    for arguments in [["--help"], ["--version"]] {
        assert_eq!(code(&homeo(&arguments)), 0);
    }
}
