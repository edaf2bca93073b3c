//! Three meshes, and VTU.

use super::three::{ThreeError, from_meshes, to_meshes};
use super::validate::ShellError;
use super::{Layer, Shell, vtu};

fn prism() -> Shell {
    let layer = |z: f64| vec![[0.0, -0.0, z], [0.1, 5e-324, z], [0.0, 1e300, z]];
    Shell { bottom: layer(-1.0), middle: layer(0.5), top: layer(1.0), faces: vec![[0, 1, 2]] }
}

#[test]
fn three_meshes_round_trip() {
    let [bottom, middle, top] = to_meshes(&prism());
    assert_eq!(from_meshes(bottom, middle, top), Ok(prism()));
}

#[test]
fn meshes_that_differ() {
    let [bottom, middle, top] = to_meshes(&prism());
    let mut short = top.clone();
    short.vertices.pop();
    let error = ThreeError::VertexCount { layer: Layer::Top, count: 2, expected: 3 };
    assert_eq!(from_meshes(bottom.clone(), middle.clone(), short), Err(error));
    let mut turned = bottom.clone();
    turned.faces[0] = [1, 2, 0];
    let error = ThreeError::Face { layer: Layer::Bottom, index: 0, face: [1, 2, 0], expected: [0, 1, 2] };
    assert_eq!(from_meshes(turned, middle.clone(), top.clone()), Err(error));
    let mut more = top.clone();
    more.faces.push([0, 1, 2]);
    let error = ThreeError::FaceCount { layer: Layer::Top, count: 2, expected: 1 };
    assert_eq!(from_meshes(bottom.clone(), middle.clone(), more), Err(error));
    let wrong = [bottom, middle, top].map(|mut mesh| {
        mesh.faces[0][2] = 3;
        mesh
    });
    let [bottom, middle, top] = wrong;
    let error = ShellError::IndexOutOfRange { prism: 0, vertex: 3, vertices: 3 };
    assert_eq!(from_meshes(bottom, middle, top), Err(ThreeError::Shell(error)));
}

/// The appended bytes of the array called `name`.
fn array<'a>(file: &'a [u8], name: &str) -> &'a [u8] {
    let start = file.windows(2).position(|window| window == b"\n_").unwrap() + 2;
    let header = std::str::from_utf8(&file[..start]).unwrap();
    let (_, rest) = header.split_once(&format!("Name=\"{name}\"")).unwrap();
    let (_, rest) = rest.split_once("offset=\"").unwrap();
    let offset: usize = rest.split('"').next().unwrap().parse().unwrap();
    let data = &file[start + offset..];
    let length = u64::from_le_bytes(data[..8].try_into().unwrap()) as usize;
    &data[8..8 + length]
}

fn longs(file: &[u8], name: &str) -> Vec<i64> {
    array(file, name).as_chunks::<8>().0.iter().map(|&bytes| i64::from_le_bytes(bytes)).collect()
}

#[test]
fn wedges() {
    let shell = prism();
    let file = vtu::to_bytes(&shell).unwrap();
    let bits =
        |points: &[[f64; 3]]| points.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect::<Vec<_>>();
    assert_eq!(array(&file, "Points"), [bits(&shell.bottom), bits(&shell.middle), bits(&shell.top)].concat());
    // VTK: the first triangle's normal points away from the second triangle.
    assert_eq!(longs(&file, "connectivity"), [3, 4, 5, 0, 1, 2, 6, 7, 8, 3, 4, 5]);
    assert_eq!(longs(&file, "offsets"), [6, 12]);
    assert_eq!(array(&file, "types"), [13, 13]);
    assert_eq!(longs(&file, "prism"), [0, 0]);
    assert_eq!(array(&file, "slab"), [0, 1]);
    assert_eq!(longs(&file, "vertex"), [0, 1, 2, 0, 1, 2, 0, 1, 2]);
    assert_eq!(array(&file, "height"), [255, 255, 255, 0, 0, 0, 1, 1, 1]);
    assert!(file.ends_with(b"\n</AppendedData>\n</VTKFile>\n"));
}

#[test]
fn vtu_file_and_errors() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("shell.vtu");
    vtu::write(&path, &prism()).unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), vtu::to_bytes(&prism()).unwrap());
    let mut bad = prism();
    bad.faces[0][1] = 9;
    assert!(matches!(vtu::write(&path, &bad), Err(vtu::VtuError::Shell(ShellError::IndexOutOfRange { .. }))));
    assert_eq!(std::fs::read(&path).unwrap(), vtu::to_bytes(&prism()).unwrap());
    assert!(matches!(vtu::write(directory.path(), &prism()), Err(vtu::VtuError::Io { .. })));
    assert_eq!(std::fs::read_dir(directory.path()).unwrap().count(), 1, "no temporary file stays");
}
