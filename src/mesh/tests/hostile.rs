//! Files that are no meshes: each is a one-line error, at once, with little memory.

use super::*;
use std::fs;
use std::path::Path;

const NAMES: [&str; 4] = ["off", "obj", "ply", "stl"];

#[test]
fn empty_and_blank() {
    for format in Format::ALL {
        for bytes in [b"".as_slice(), b"  \n\r\n\t", b"\xef\xbb\xbf"] {
            assert_eq!(refused(bytes, format), "test: the file is empty");
        }
    }
}

#[test]
fn every_truncation() {
    let mesh = TriMesh {
        vertices: vec![[0.5, 0.0, 0.0], [1.0, 0.25, 0.0], [0.0, 1.0, -3.0], [7.0, 7.0, 7.0]],
        faces: vec![[0, 1, 2], [3, 2, 1]],
    };
    for format in Format::ALL {
        let bytes = encode(&mesh, format, "test").unwrap();
        for end in 0..bytes.len() {
            // Text may lose its last line end, and OBJ whole lines, and still be a mesh.
            match parse(&bytes[..end], format, "test") {
                Ok(file) => assert!(file.mesh.faces.len() <= 2 && file.mesh.vertices.len() <= 4),
                Err(e) => assert!(!e.to_string().contains('\n')),
            }
        }
        let counted = !matches!(format, Format::Obj);
        let short = &bytes[..bytes.len() - 3];
        assert!(!counted || parse(short, format, "test").is_err(), "{format}");
    }
}

/// Bytes of a fixed linear congruential generator.
fn garbage(n: usize, mut state: u64) -> Vec<u8> {
    let mut step = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        state.to_be_bytes()[0]
    };
    (0..n).map(|_| step()).collect()
}

#[test]
fn binary_garbage() {
    for seed in 0..50 {
        for format in Format::ALL {
            refused(&garbage(10_000, seed), format);
            for magic in [b"OFF\n".as_slice(), b"ply\n", b"solid\n", b"v ", b"f 1 1 1 ", b"3 3 3\n"] {
                refused(&[magic, &garbage(300, seed)].concat(), format);
            }
        }
    }
}

#[test]
fn giant_counts() {
    let big = 1u64 << 40;
    let off = |v: u64, f: u64| refused(format!("OFF\n{v} {f} 0\n0 0 0\n").as_bytes(), Format::Off);
    assert_eq!(off(big, 1), "test:2: 1099511627776 vertices are more than 2^32 - 1");
    assert_eq!(off(1, big), "test:2: 1099511627776 faces are more than 2^32 - 1");
    assert_eq!(off(4_000_000_000, 1), "test: the file ends after 1 of 4000000000 vertices");
    assert_eq!(off(1, 4_000_000_000), "test: the file ends after 0 of 4000000000 faces");
    assert!(refused(b"OFF\n99999999999999999999999 1 0\n", Format::Off).contains("number of vertices"));
    assert!(
        refused(b"OFF\n1 1 0\n0 0 0\n1099511627776 0 0 0\n", Format::Off).contains("expected 1099511627776")
    );
    let obj = refused(b"v 0 0 0\nf 1 1 1099511627776\n", Format::Obj);
    assert_eq!(obj, "test:2: vertex index 1099511627776 is out of range (the mesh has 1 vertices)");

    for encoding in ["ascii", "binary_little_endian", "binary_big_endian"] {
        let ply = |v: u64, f: u64, w: u64, body: &[u8]| {
            let head = format!(
                "ply\nformat {encoding} 1.0\nelement w {w}\nproperty list uint double q\nelement vertex {v}\nproperty char x\n\
                 property char y\nproperty char z\nelement face {f}\nproperty list uint int vertex_index\nend_header\n"
            );
            refused(&[head.as_bytes(), body].concat(), Format::PlyAscii)
        };
        assert_eq!(ply(big, 1, 0, b"0 0 0"), "test: 1099511627776 vertices are more than 2^32 - 1");
        assert!(ply(4_000_000_000, 1, 0, b"1 1 1\n").contains("of 4000000000 vertex elements"));
        assert!(ply(1, big, 0, b"1 1 1\n").contains("of 1099511627776 face elements"));
        assert!(ply(1, 1, big, b"0\n0\n").contains("of 1099511627776 w elements"));
        assert!(ply(1, 1, 1, b"4294967295 1\n").contains("fits into its element"));
    }
    let mut stl = vec![0; 84];
    stl[80..].copy_from_slice(&u32::MAX.to_le_bytes());
    assert_eq!(
        refused(&stl, Format::StlBinary),
        "test: expected 214748364834 bytes for a binary STL of 4294967295 facets, found 84 bytes"
    );
}

#[test]
fn ten_megabytes_of_one_line() {
    for filler in [b"1 ".as_slice(), b"x", b"\0", b"\\", b"9", b"v 0 0 0 ", b"\\\n", b"#"] {
        let long = filler.repeat(10_000_000 / filler.len());
        for head in [
            b"".as_slice(),
            b"OFF ",
            b"OFF\n",
            b"ply\n",
            b"ply\nformat ascii 1.0\ncomment ",
            b"solid ",
            b"f ",
            b"v ",
        ] {
            let bytes = [head, &long].concat();
            let format = Format::from_content(&bytes).unwrap_or(Format::Obj);
            match parse(&bytes, format, "test") {
                // Ten megabytes of columns after three coordinates are ignored.
                Ok(file) => assert_eq!(file.mesh.vertices.len(), 1),
                Err(e) => assert!(e.to_string().len() < 300 && !e.to_string().contains('\n'), "{e}"),
            }
        }
    }
}

#[test]
fn nan_and_infinity() {
    for word in ["nan", "NaN", "-nan", "inf", "-inf", "infinity", "+Infinity", "1e400", "-1e400"] {
        for (text, format) in [
            (format!("OFF\n1 0 0\n0 {word} 0\n"), Format::Off),
            (format!("v 0 0 {word}\n"), Format::Obj),
            (format!("solid\nfacet normal 0 0 0\nouter loop\nvertex {word} 0 0\n"), Format::StlAscii),
        ] {
            let message = refused(text.as_bytes(), format);
            assert!(message.contains("is not a finite f64"), "{message}");
        }
    }
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty double x\nproperty double y\nproperty double z\nend_header\n";
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let bytes = [head.as_bytes(), &[0; 16], &x.to_le_bytes()].concat();
        assert_eq!(
            refused(&bytes, Format::PlyAscii),
            format!("test: vertex 0: coordinate {x} is not a finite f64")
        );
    }
}

#[test]
fn not_a_file() {
    let directory = tempfile::tempdir().unwrap();
    for extension in NAMES {
        let path = directory.path().join(format!("d.{extension}"));
        let one_line = |e: MeshError| {
            let message = e.to_string();
            assert!(!message.contains('\n') && message.contains(&format!("d.{extension}")), "{message}");
            message
        };
        assert!(one_line(read(&path).unwrap_err()).contains("No such file"));
        fs::create_dir(&path).unwrap();
        assert!(one_line(read(&path).unwrap_err()).ends_with(": not a regular file"));
        assert!(one_line(read_as(&path, Format::Obj).unwrap_err()).ends_with(": not a regular file"));
    }
    let unknown = directory.path().join("x.dat");
    fs::write(&unknown, "hello").unwrap();
    assert!(read(&unknown).unwrap_err().to_string().contains("format not recognised"));
    fs::write(&unknown, " \n").unwrap();
    assert!(read(&unknown).unwrap_err().to_string().ends_with("the file is empty"));
    let odd = directory.path().join("line\nbreak.obj");
    assert!(!read(&odd).unwrap_err().to_string().contains('\n'));
}

#[cfg(unix)]
#[test]
fn unreadable() {
    use std::os::unix::fs::PermissionsExt as _;
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("secret.off");
    fs::write(&path, "OFF\n").unwrap();
    fs::set_permissions(&path, fs::Permissions::from_mode(0o0)).unwrap();
    if fs::File::open(&path).is_ok() {
        eprintln!("SKIPPED: this user may read everything, permissions cannot be tested");
    } else {
        assert!(read(&path).unwrap_err().to_string().contains("ermission denied"));
    }
    // A regular file that can be opened but not read, where the system has one.
    let memory = Path::new("/proc/self/mem");
    if memory.exists() {
        assert!(matches!(read(memory), Err(MeshError::Read { fault: Fault::Io(_), .. })));
    }
    assert!(matches!(read(Path::new("/dev/null")), Err(MeshError::Read { fault: Fault::NotAFile, .. })));
}
