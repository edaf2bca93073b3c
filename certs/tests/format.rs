//! Points of FORMAT that two readings found open.
#![allow(clippy::panic)]
mod common;
use common::one_prism;
use homeo_certs::check;

#[test]
fn vertical_tab_is_no_white_space() {
    let case = one_prism();
    let with = |space: &str| {
        let mut files = case.inputs();
        let text = String::from_utf8_lossy(&files[3]).replacen(' ', space, 1);
        files[3] = text.into_bytes();
        let got = check(case.text().as_bytes(), &files);
        (got.exit, got.code)
    };
    for space in [" ", "\t", "\r", "\x0c", "\n", " \t"] {
        assert_eq!(with(space), (0, ""), "{space:?}");
    }
    assert_eq!(with("\x0b"), (2, "input"));
}

#[test]
fn counts_and_numbers_of_off() {
    let case = one_prism();
    let points = "0 0 0 1E0 0 0 0 +1.e-0 0";
    let with = |head: &str, face: &str| {
        let mut files = case.inputs();
        files[3] = format!("OFF {head} {points} {face}").into_bytes();
        let got = check(case.text().as_bytes(), &files);
        (got.exit, got.code)
    };
    assert_eq!(with("3 1 0", "3 0 1 2"), (0, ""));
    // The number of edges and the indices may be written anyhow.
    assert_eq!(with("3 1 00099999999999999999999999999", "3 0 01 0000000000000000000000002"), (0, ""));
    assert_eq!(with("3 1 -1", "3 0 1 2"), (2, "input"));
    assert_eq!(with("03 1 0", "3 0 1 2"), (2, "input"));
    assert_eq!(with("3 01 0", "3 0 1 2"), (2, "input"));
    assert_eq!(with("3 1 0", "03 0 1 2"), (2, "input"));
}

#[test]
fn a_given_mesh_is_read_also_when_not_needed() {
    let case = one_prism().only(&[("positivity", true)], &[]);
    let mut files = case.inputs();
    assert_eq!(check(case.text().as_bytes(), &files[..3]).code, "");
    files[3] = b"OFF".to_vec();
    assert_eq!(check(case.text().as_bytes(), &files).code, "input");
}

#[test]
fn a_plane_through_a_name_that_does_not_exist_separates_nothing() {
    let with = |plane: &str| {
        let sep = format!("sep 0 1 {plane}");
        let mut case = one_prism().only(&[("disjoint-mesh", true)], &[("disjoint-mesh", sep.as_str())]);
        let pinch = [3.0, 3.0, -1.0];
        case.layers.iter_mut().for_each(|layer| layer[0] = pinch);
        case.pinched = "pinched 8 0".into();
        let floor = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        case.points = [&floor[..], &[pinch, [3.0, 3.0, 1.0], [5.0, 5.0, 0.0], [5.0, 5.0, -1.0]]].concat();
        case.triangles = vec![[0, 1, 2], [3, 4, 5]];
        case
    };
    with("n:g3,g6").accept();
    with("n:m0,g6").accept();
    with("n:b0,g6").reject("not-separated");
    with("n:t0,g6").reject("not-separated");
    with("n:b1,b1 n:m0,g6").accept();
}

#[test]
fn a_file_over_the_limit_is_an_input_error() {
    let Ok(folder) = tempfile::tempdir() else { panic!("no temporary folder") };
    let [cert, mesh] = ["a.cert", "b.off"].map(|name| folder.path().join(name));
    assert!(std::fs::write(&cert, one_prism().text()).is_ok());
    // A sparse file: nothing is written.
    assert!(std::fs::File::create(&mesh).and_then(|file| file.set_len((1 << 30) + 1)).is_ok());
    let got = homeo_certs::check_files(&cert, &[mesh]);
    assert_eq!((got.exit, got.code), (2, "input"));
    assert!(got.message.contains("2^30"), "{}", got.message);
}
