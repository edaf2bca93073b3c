//! Writing and reading again gives the same mesh, bit for bit.

use super::*;
use proptest::prelude::*;
use std::cmp::Ordering;
use std::collections::HashMap;

/// Formats that keep vertices.
const INDEXED: [Format; 5] =
    [Format::Obj, Format::Off, Format::PlyAscii, Format::PlyBinaryLe, Format::PlyBinaryBe];

/// Any finite bits: subnormals, zeros of both signs and the largest numbers included.
fn coordinate() -> impl Strategy<Value = f64> {
    let special = prop::sample::select(vec![
        0.0,
        -0.0,
        f64::MAX,
        f64::MIN,
        f64::MIN_POSITIVE,
        f64::from_bits(1),
        -f64::from_bits(1),
        f64::from_bits((1 << 52) - 1),
        0.1,
        1e23,
        9_007_199_254_740_992.0,
        5e-324,
        1e16,
        1e-5,
    ]);
    let any = any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite());
    prop_oneof![1 => special, 3 => any]
}

fn mesh(coordinate: impl Strategy<Value = f64>) -> impl Strategy<Value = TriMesh> {
    prop::collection::vec(prop::array::uniform3(coordinate), 1..20).prop_flat_map(|vertices| {
        let n = u32::try_from(vertices.len()).unwrap();
        let faces = prop::collection::vec(prop::array::uniform3(0..n), 0..20);
        faces.prop_map(move |faces| TriMesh { vertices: vertices.clone(), faces })
    })
}

/// The mesh that reading a soup of these faces must give, from the definition: search, not a table.
fn welded(mesh: &TriMesh) -> TriMesh {
    let mut out = TriMesh::default();
    for face in &mesh.faces {
        let corners = face.map(|v| {
            let p = mesh.vertices[v as usize];
            let known = out.vertices.iter().position(|q| q.partial_cmp(&p) == Some(Ordering::Equal));
            u32::try_from(known.unwrap_or_else(|| {
                out.vertices.push(p);
                out.vertices.len() - 1
            }))
            .unwrap()
        });
        out.faces.push(corners);
    }
    out
}

proptest! {
    #[test]
    fn indexed_formats_keep_everything(mesh in mesh(coordinate())) {
        for format in INDEXED {
            let bytes = encode(&mesh, format, "test").unwrap();
            // OBJ has no mark; all others must be recognised.
            prop_assert_eq!(Format::from_content(&bytes).unwrap_or(Format::Obj), format);
            let file = parse(&bytes, format, "test").unwrap();
            prop_assert_eq!(bits(&file.mesh), bits(&mesh), "{}", format);
            prop_assert_eq!(&file.mesh.faces, &mesh.faces);
            prop_assert!(file.notes.is_empty());
            prop_assert_eq!(encode(&file.mesh, format, "test").unwrap(), bytes);
        }
    }

    #[test]
    fn text_stl_keeps_corners(mesh in mesh(coordinate())) {
        let encoded = encode(&mesh, Format::StlAscii, "test");
        if mesh.faces.is_empty() {
            prop_assert_eq!(encoded.unwrap_err().to_string(), "test: cannot write: the mesh has no faces");
        } else {
            let file = parse(&encoded.unwrap(), Format::StlAscii, "test").unwrap();
            let expected = welded(&mesh);
            prop_assert_eq!(bits(&file.mesh), bits(&expected));
            prop_assert_eq!(file.mesh.faces, expected.faces);
        }
    }

    #[test]
    fn binary_stl_keeps_f32(mesh in mesh(any::<f32>().prop_filter("finite", |x| x.is_finite()).prop_map(f64::from))) {
        prop_assume!(!mesh.faces.is_empty());
        let file = parse(&encode(&mesh, Format::StlBinary, "test").unwrap(), Format::StlBinary, "test").unwrap();
        let expected = welded(&mesh);
        prop_assert_eq!(bits(&file.mesh), bits(&expected));
        prop_assert_eq!(file.mesh.faces, expected.faces);
    }

    #[test]
    fn readers_survive_anything(bytes in prop::collection::vec(any::<u8>(), 0..400), seed in 0usize..6) {
        let heads = [b"".as_slice(), b"OFF 3 1 0\n", b"ply\nformat ascii 1.0\nelement vertex 1\n", b"solid\nfacet normal ", b"v 0 0 0\nf 1 ", b"OFF\n"];
        for format in Format::ALL {
            if let Err(e) = parse(&[heads[seed], &bytes].concat(), format, "test") {
                prop_assert!(!e.to_string().contains('\n'));
            }
        }
    }
}

fn triangle(x: f64) -> TriMesh {
    TriMesh { vertices: vec![[x, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], faces: vec![[0, 1, 2]] }
}

#[test]
fn binary_stl_refuses_to_round() {
    for x in [0.1, 16_777_217.0, 1e300, f64::from_bits(1), 1e-46] {
        let message = encode(&triangle(x), Format::StlBinary, "a.stl").unwrap_err().to_string();
        let expected = format!(
            "a.stl: vertex 0: cannot write: coordinate {x:?} is not exactly representable in f32, which binary STL stores"
        );
        assert_eq!(message, expected);
    }
    for x in [-0.0, 0.5, 16_777_216.0, f64::from(f32::MAX), f64::from(f32::from_bits(1))] {
        assert!(encode(&triangle(x), Format::StlBinary, "a.stl").is_ok());
    }
}

#[test]
fn what_cannot_be_read_back_is_not_written() {
    for format in Format::ALL {
        let refused = |mesh: &TriMesh| encode(mesh, format, "m").unwrap_err().to_string();
        assert_eq!(refused(&TriMesh::default()), "m: cannot write: the mesh has no vertices");
        assert_eq!(
            refused(&triangle(f64::NAN)),
            "m: vertex 0: cannot write: coordinate NaN is not a finite f64"
        );
        let mut mesh = triangle(0.0);
        mesh.faces.push([0, 1, 3]);
        assert_eq!(
            refused(&mesh),
            "m: face 1: cannot write: vertex index 3 is out of range (the mesh has 3 vertices)"
        );
    }
}

#[test]
fn files_are_replaced_whole_or_not_at_all() {
    let directory = tempfile::tempdir().unwrap();
    let names: HashMap<Format, &str> = HashMap::from([
        (Format::Obj, "m.obj"),
        (Format::Off, "m.off"),
        (Format::PlyBinaryLe, "m.ply"),
        (Format::StlBinary, "m.stl"),
    ]);
    for (format, name) in names {
        let path = directory.path().join(name);
        assert_eq!(Format::from_extension(&path), Some(format));
        write(&path, &triangle(0.5), format).unwrap();
        let before = std::fs::read(&path).unwrap();
        assert!(write(&path, &triangle(f64::INFINITY), format).is_err());
        assert_eq!(std::fs::read(&path).unwrap(), before);
        write(&path, &triangle(0.25), format).unwrap();
        let file = read(&path).unwrap();
        assert_eq!((file.format, bits(&file.mesh)), (format, bits(&triangle(0.25))));
    }
    // A rename would replace a device or an empty directory.
    let taken = directory.path().join("d.off");
    std::fs::create_dir(&taken).unwrap();
    let message = write(&taken, &triangle(0.5), Format::Off).unwrap_err().to_string();
    assert!(message.ends_with("d.off: cannot write: not a regular file"), "{message}");
    std::fs::remove_dir(&taken).unwrap();
    // No temporary file stays, and a missing directory is an error with the file's name.
    assert_eq!(std::fs::read_dir(directory.path()).unwrap().count(), 4);
    let lost = directory.path().join("none").join("m.off");
    let message = write(&lost, &triangle(0.5), Format::Off).unwrap_err().to_string();
    assert!(message.contains("m.off: cannot write: ") && !message.contains('\n'), "{message}");
}

#[test]
fn real_meshes() {
    let Some(data) = data("") else { return };
    for name in [
        "surface/bunny.off",
        "surface/hull-mask.obj",
        "surface/fox.ply",
        "surface/88566.stl",
        "pairs/turbine_mo10.obj",
    ] {
        let file = read(&data.join(name)).expect(name);
        for format in INDEXED {
            let again = parse(&encode(&file.mesh, format, name).unwrap(), format, name).unwrap();
            assert_eq!(
                (bits(&again.mesh), again.mesh.faces),
                (bits(&file.mesh), file.mesh.faces.clone()),
                "{name}"
            );
        }
    }
    // A welded soup is a fixed point of STL, and its coordinates came from f32.
    let file = read(&data.join("surface/88566.stl")).unwrap();
    for format in [Format::StlAscii, Format::StlBinary] {
        let again = parse(&encode(&file.mesh, format, "x").unwrap(), format, "x").unwrap();
        assert_eq!((bits(&again.mesh), again.mesh.faces), (bits(&file.mesh), file.mesh.faces.clone()));
    }
}
