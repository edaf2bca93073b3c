//! Input files, their binding to the certificate, the input conditions.
mod common;
use common::{Case, off, one_prism, tetrahedron};
use homeo_certs::check;
use std::path::Path;

fn with_inputs(case: &Case, inputs: &[Vec<u8>]) -> (u8, &'static str) {
    let got = check(case.text().as_bytes(), inputs);
    (got.exit, got.code)
}

#[test]
fn inputs() {
    let case = one_prism();
    let files = case.inputs();
    assert_eq!(with_inputs(&case, &files), (0, ""));
    let obj = b"# x\nv 0 0 0 7\nv 1e0 -0.e5 .0\nv 0 +1 0\nvn 1\nf 1/2/3 2//1 3\n".to_vec();
    assert_eq!(
        with_inputs(&case, &[files[0].clone(), files[1].clone(), files[2].clone(), obj]),
        (1, "hash"),
        "-0 is not 0"
    );
    let obj = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/2/3 2//1 3\n".to_vec();
    assert_eq!(with_inputs(&case, &[files[0].clone(), files[1].clone(), files[2].clone(), obj]), (0, ""));
    for n in [0, 1, 2, 3] {
        assert_eq!(with_inputs(&case, &files[..n]), (2, "input"), "{n} files");
    }
    assert_eq!(with_inputs(&case, &[files.clone(), files.clone()].concat()), (2, "input"));
    for bad in [
        "",
        "OFF",
        "OFF 99999999999999999999 1 0",
        "OFF 1099511627776 1 0",
        "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 3",
        "OFF 03 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2",
        "OFF 3 01 0 0 0 0 1 0 0 0 1 0 3 0 1 2",
        "OFF 3 1 0 0 0 0 1 0 0 0 1 0 4 0 1 2 2",
        "OFF 3 1 0 nan 0 0 1 0 0 0 1 0 3 0 1 2",
        "OFF 3 1 0 1e999 0 0 1 0 0 0 1 0 3 0 1 2",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 1 2",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 1",
        "v 0 0",
    ] {
        let mut some = files.clone();
        some[3] = bad.as_bytes().to_vec();
        assert_eq!(with_inputs(&case, &some), (2, "input"), "{bad}");
    }
    let mut some = files.clone();
    some[1] = off(&case.layers[1], &[[0, 2, 1]]);
    assert_eq!(with_inputs(&case, &some), (2, "input"));
    let hdf = [b"\x89HDF\r\n\x1a\n".to_vec(), vec![0xff; 200]].concat();
    assert_eq!(with_inputs(&case, &[hdf]), (2, "input"));
}

#[test]
fn hash() {
    let mut other = one_prism();
    other.points[2][2] = f64::from_bits(1);
    assert_eq!(with_inputs(&one_prism(), &other.inputs()), (1, "hash"));
    let mut other = one_prism();
    other.layers[0][2][2] = -1.5;
    assert_eq!(with_inputs(&one_prism(), &other.inputs()), (1, "hash"));
}

#[test]
fn conditions() {
    let shell = |edit: fn(&mut Case)| {
        let mut case = tetrahedron();
        edit(&mut case);
        case.reject("shell-conditions");
    };
    shell(|c| c.prisms[0] = [0, 1, 1]);
    shell(|c| c.prisms[0] = [0, 2, 1]);
    shell(|c| c.prisms = vec![[0, 1, 2], [0, 2, 1]]);
    let mut flat = one_prism();
    flat.layers[0] = flat.layers[1].clone();
    flat.layers[2] = flat.layers[1].clone();
    flat.reject("shell-conditions");
    // Two triangles that share just a vertex.
    let mut bow = one_prism();
    bow.points.extend([[2.0, 2.0, 2.0], [3.0, 2.0, 2.0]]);
    bow.triangles.push([0, 3, 4]);
    bow.reject("mesh-conditions");
    let mut flat = one_prism();
    flat.points[2] = [0.5, 0.0, 0.0];
    flat.reject("mesh-conditions");
    let mut stated = one_prism();
    stated.pinched = "pinched 8 0".into();
    stated.reject("pinched");
}

#[test]
fn usage() {
    let none: [&Path; 0] = [];
    let got = homeo_certs::check_files(Path::new("no/such/file"), &none);
    assert_eq!((got.exit, got.code), (2, "usage"));
    let got = homeo_certs::check_files(Path::new(env!("CARGO_MANIFEST_DIR")), &none);
    assert_eq!((got.exit, got.code), (2, "usage"));
}
