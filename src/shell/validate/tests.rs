//! Each condition violated alone, and the real shells, which meet all of them.

use super::{Remarks, ShellError, validate};
use crate::shell::{Layer, Name, Shell, hdf5};

/// A valid shell with straight pillars over the given faces; the positions play no part here.
fn shell(vertices: u32, faces: &[[u32; 3]]) -> Shell {
    let layer = |z: f64| (0..vertices).map(|v| [f64::from(v), f64::from(v * v), z]).collect();
    Shell { bottom: layer(-1.0), middle: layer(0.0), top: layer(1.0), faces: faces.to_vec() }
}

fn pinch(mut shell: Shell, vertices: &[usize]) -> Shell {
    for &v in vertices {
        shell.bottom[v] = shell.middle[v];
        shell.top[v] = shell.middle[v];
    }
    shell
}

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];

#[test]
fn good_shells() {
    assert_eq!(validate(&shell(4, &TETRAHEDRON)), Ok(Remarks::default()));
    let open = validate(&shell(5, &TETRAHEDRON[..2])).unwrap();
    assert_eq!(open, Remarks { unreferenced: vec![4], boundary_sides: 4 });
    assert_eq!(validate(&Shell::default()), Ok(Remarks::default()));
    assert!(validate(&pinch(shell(4, &TETRAHEDRON), &[0, 2])).is_ok(), "two pinched corners are allowed");
    let mut half = shell(4, &TETRAHEDRON);
    half.bottom = half.middle.clone();
    assert!(validate(&half).is_ok(), "a pillar without a bottom half is refuted, not refused");
}

#[test]
fn layers_and_points() {
    let mut bad = shell(4, &TETRAHEDRON);
    bad.top.pop();
    assert_eq!(validate(&bad), Err(ShellError::Lengths { layer: Layer::Top, points: 3, expected: 4 }));
    let mut bad = shell(4, &TETRAHEDRON);
    bad.middle[2][1] = f64::NEG_INFINITY;
    let name = Name { vertex: 2, layer: Layer::Middle };
    assert_eq!(validate(&bad), Err(ShellError::NotFinite { name, point: [2.0, f64::NEG_INFINITY, 0.0] }));
    bad.middle[2][1] = f64::NAN;
    assert!(validate(&bad).unwrap_err().to_string().starts_with("point m2 is not finite: [2.0, NaN"));
}

#[test]
fn corners() {
    let bad = shell(3, &[[0, 1, 2], [0, 3, 1]]);
    assert_eq!(validate(&bad), Err(ShellError::IndexOutOfRange { prism: 1, vertex: 3, vertices: 3 }));
    for (face, vertex) in [([1, 1, 0], 1), ([1, 0, 1], 1), ([0, 1, 1], 1)] {
        assert_eq!(validate(&shell(3, &[face])), Err(ShellError::RepeatedCorner { prism: 0, vertex }));
    }
    let bad = pinch(shell(4, &TETRAHEDRON), &[0, 2, 3]);
    assert_eq!(validate(&bad), Err(ShellError::ThreePinched { prism: 3, corners: [2, 3, 0] }));
}

#[test]
fn middle_complex() {
    let same = ShellError::SameCorners { first: 0, second: 1, corners: [0, 1, 2] };
    assert_eq!(validate(&shell(3, &[[0, 1, 2], [2, 1, 0]])), Err(same));
    let flipped = shell(4, &[[0, 1, 2], [0, 1, 3]]);
    assert_eq!(validate(&flipped), Err(ShellError::Orientation { edge: [0, 1], first: 0, second: 1 }));
    let book = shell(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    let edge = ShellError::NonManifoldEdge { edge: [0, 1], prisms: vec![0, 1, 2] };
    assert_eq!(validate(&book), Err(edge));
    let bow_tie = shell(5, &[[0, 1, 2], [2, 3, 4]]);
    assert_eq!(validate(&bow_tie), Err(ShellError::NonManifoldVertex { vertex: 2, first: 0, second: 1 }));
    let mut two_tops: Vec<[u32; 3]> = TETRAHEDRON.to_vec();
    two_tops.extend(TETRAHEDRON.map(|face| face.map(|v| if v == 0 { 0 } else { v + 3 })));
    let touching = validate(&shell(7, &two_tops));
    assert_eq!(touching, Err(ShellError::NonManifoldVertex { vertex: 0, first: 0, second: 4 }));
}

#[test]
fn real_shells_are_closed_manifolds() {
    let Some(directory) = crate::testing::shell_directory() else { return };
    for (name, ..) in crate::shell::tests::FACTS {
        let file = hdf5::read(&directory.join(name)).unwrap_or_else(|error| panic!("{error}"));
        let remarks = validate(&file.shell).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(remarks, Remarks::default(), "{name}");
    }
}
