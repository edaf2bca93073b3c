//! Round trips, named errors, and hostile bytes.

use super::{MetaEdge, Metadata, ReadError, Separation, ShellFile, Tracks, parse, read, to_bytes, write};
use crate::mesh::TriMesh;
use crate::shell::Shell;
use crate::shell::tests::FACTS;
use crate::testing::shell_directory;
use hdf5_pure::{File, FileBuilder};

/// A small file with everything in it.
fn sample() -> ShellFile {
    let points = |z: f64| vec![[0.0, -0.0, z], [1.0, 5e-324, z], [0.1, 1.0, z], [1e308, 1.0, z]];
    ShellFile {
        shell: Shell {
            bottom: points(-1.0),
            middle: points(0.25),
            top: points(1.0),
            faces: vec![[0, 1, 2], [2, 1, 3]],
        },
        mesh: Some(TriMesh { vertices: points(0.0), faces: vec![[0, 1, 2]] }),
        tracks: Tracks::new(vec![1, 0], vec![0]),
        meta_edges: Some(vec![
            MetaEdge { edge: [0, 1], curve: 7, chain: vec![3, 1, 2] },
            MetaEdge { edge: [1, 2], curve: -1, chain: vec![] },
        ]),
        metadata: Some(Metadata { version: 1, separation: Separation::Surface, pinched: 0 }),
        notes: Vec::new(),
    }
}

fn bits(points: &[[f64; 3]]) -> Vec<u64> {
    points.as_flattened().iter().map(|x| x.to_bits()).collect()
}

/// Equality with every bit of every coordinate.
fn assert_same(left: &ShellFile, right: &ShellFile) {
    assert_eq!(left, right);
    for (a, b) in [(&left.shell.bottom, &right.shell.bottom), (&left.shell.middle, &right.shell.middle)] {
        assert_eq!(bits(a), bits(b));
    }
    assert_eq!(bits(&left.shell.top), bits(&right.shell.top));
    let vertices = |file: &ShellFile| file.mesh.as_ref().map(|mesh| bits(&mesh.vertices));
    assert_eq!(vertices(left), vertices(right));
}

#[test]
fn sample_round_trip() {
    let file = sample();
    let bytes = to_bytes(&file).unwrap();
    assert_same(&parse("sample", bytes.clone()).unwrap(), &file);
    assert_eq!(&bytes[..8], b"\x89HDF\r\n\x1a\n");
    let bare = ShellFile { shell: file.shell, ..ShellFile::default() };
    let read = parse("bare", to_bytes(&bare).unwrap()).unwrap();
    assert_eq!(read.shell, bare.shell);
    assert_eq!((read.mesh, read.tracks, read.meta_edges, read.metadata), (None, None, None, None));
    assert_eq!(read.notes, ["the file holds no mesh (ref.V, ref.F)"]);
    let empty = parse("empty", to_bytes(&ShellFile::default()).unwrap()).unwrap();
    assert_eq!(empty.shell, Shell::default());
}

#[test]
fn real_files_round_trip() {
    let Some(directory) = shell_directory() else { return };
    for (name, ..) in FACTS {
        let path = directory.join(name);
        let file = read(&path).unwrap_or_else(|error| panic!("{error}"));
        assert_same(&parse(name, to_bytes(&file).unwrap()).unwrap(), &file);
    }
}

#[test]
fn tracks_by_prism() {
    let tracks = Tracks::new(vec![2, 0, 1], vec![5, 9, 4]).unwrap();
    assert_eq!(
        (tracks.of(0), tracks.of(1), tracks.of(2), tracks.of(3)),
        (&[5, 9][..], &[][..], &[4][..], &[][..])
    );
    assert_eq!(Tracks::new(vec![2, 0], vec![5]), None);
    assert_eq!(Tracks::new(vec![u32::MAX; 3], vec![5]), None);
}

#[test]
fn file_is_replaced_only_by_a_complete_one() {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("shell.h5");
    write(&path, &sample()).unwrap();
    assert_same(&read(&path).unwrap(), &sample());
    let mut bad = sample();
    bad.shell.top.pop();
    assert_eq!(
        write(&path, &bad).unwrap_err().to_string(),
        "the shell has 4 bottom, 4 middle and 3 top points"
    );
    let mut large = sample();
    large.shell.faces[1][2] = 1 << 31;
    let message = write(&path, &large).unwrap_err().to_string();
    assert_eq!(message, "mF: 2147483648 does not fit into a signed 32-bit integer");
    assert_same(&read(&path).unwrap(), &sample());
    assert_eq!(std::fs::read_dir(directory.path()).unwrap().count(), 1, "no temporary file stays");
    assert!(matches!(read(directory.path()), Err(ReadError::NotAFile { .. })));
    assert!(matches!(read(&directory.path().join("none")), Err(ReadError::Io { .. })));
}

type Edit<'a> = (&'a str, &'a dyn Fn(&mut FileBuilder));

/// The sample's required datasets by another writer (new-style groups), one of them changed.
fn edited((skip, add): Edit<'_>) -> Result<ShellFile, ReadError> {
    let shell = sample().shell;
    let mut builder = FileBuilder::new();
    let layers = [("mbase", &shell.bottom), ("mV", &shell.middle), ("mtop", &shell.top)];
    for (name, points) in layers.into_iter().filter(|(name, _)| *name != skip) {
        builder.create_dataset(name).with_f64_data(points.as_flattened()).with_shape(&[4, 3]);
    }
    if skip != "mF" {
        builder.create_dataset("mF").with_i32_data(&[0, 1, 2, 2, 1, 3]).with_shape(&[2, 3]);
    }
    add(&mut builder);
    parse("x.h5", builder.finish().unwrap())
}

#[test]
fn other_valid_encodings() {
    let whole = edited(("", &|_| ())).unwrap();
    assert_eq!(whole.shell, sample().shell);
    let wide = edited(("mF", &|b| {
        b.create_dataset("mF").with_i64_data(&[0, 1, 2, 2, 1, 3]).with_shape(&[2, 3]);
    }));
    assert_eq!(wide.unwrap().shell, sample().shell);
    let packed = edited(("mV", &|b| {
        let middle = sample().shell.middle;
        let set = b.create_dataset("mV").with_f64_data(middle.as_flattened()).with_shape(&[4, 3]);
        set.with_chunks(&[2, 3]).with_deflate(6);
    }));
    assert_eq!(packed.unwrap().shell, sample().shell);
    let single = edited(("mtop", &|b| {
        b.create_dataset("mtop").with_f32_data(&[0.1; 12]).with_shape(&[4, 3]);
    }));
    assert_eq!(single.unwrap().shell.top, vec![[f64::from(0.1_f32); 3]; 4]);
    let extra = edited(("", &|b| {
        b.create_dataset("colour").with_f64_data(&[0.5]);
        b.create_dataset("metadata").with_i32_data(&[2, 9, 3]);
    }));
    let notes = [
        "dataset colour is ignored",
        "the file holds no mesh (ref.V, ref.F)",
        "metadata states 3 pinched vertices, the data has 0",
        "metadata states version 2; version 1 is known",
        "metadata states type 9; types 0, 1 and 2 are known",
    ];
    assert_eq!(extra.unwrap().notes, notes);
}

#[test]
fn errors_name_file_dataset_and_reason() {
    let ints = |name: &'static str, values: &'static [i32]| {
        move |b: &mut FileBuilder| {
            b.create_dataset(name).with_i32_data(values);
        }
    };
    let points = |rows: u64, value: f64| {
        move |b: &mut FileBuilder| {
            let mut values = vec![0.5; 3 * rows as usize];
            values[4] = value;
            b.create_dataset("mV").with_f64_data(&values).with_shape(&[rows, 3]);
        }
    };
    let faces = |values: &'static [i32]| {
        move |b: &mut FileBuilder| {
            b.create_dataset("mF").with_i32_data(values).with_shape(&[values.len() as u64 / 3, 3]);
        }
    };
    let both = |b: &mut FileBuilder, first: (&str, &[i32]), second: (&str, &[i32])| {
        b.create_dataset(first.0).with_i32_data(first.1);
        b.create_dataset(second.0).with_i32_data(second.1);
    };
    let cases: [(Edit<'_>, &str); 21] = [
        (("mtop", &|_| ()), "dataset mtop: is missing"),
        (("mF", &|_| ()), "dataset mF: is missing"),
        (("", &ints("ref.F", &[0, 1, 2])), "dataset ref.V: is missing, while ref.F is there"),
        (("", &ints("track_size", &[0, 0])), "dataset track_flat: is missing, while track_size is there"),
        (("mF", &ints("mF", &[0, 1, 2])), "dataset mF: has shape [3] instead of n x 3"),
        (("mV", &ints("mV", &[0; 12])), "dataset mV: its values are not IEEE floating-point"),
        (("mV", &points(4, f64::NAN)), "dataset mV: row 1 is not finite: [0.5, NaN, 0.5]"),
        (("mV", &points(4, f64::INFINITY)), "dataset mV: row 1 is not finite: [0.5, inf, 0.5]"),
        (("mV", &points(3, 0.0)), "dataset mbase: has 4 points, while mV has 3"),
        (("mF", &faces(&[0, 1, 2, 2, -1, 3])), "dataset mF: row 1: -1 is negative"),
        (("mF", &faces(&[0, 1, 4])), "dataset mF: row 0: 4 is out of range: at most 4 exist"),
        (
            ("mF", &|b| {
                b.create_dataset("mF").with_f64_data(&[0.0, 1.0, 2.0]).with_shape(&[1, 3]);
            }),
            "dataset mF: its values are not integers",
        ),
        (("", &ints("metadata", &[1, 1])), "dataset metadata: has 2 entries instead of 3"),
        (
            ("", &|b| {
                b.create_dataset("metadata").with_i64_data(&[1, 1, 1 << 40]);
            }),
            "dataset metadata: entry 2 does not fit into 32 bits: 1099511627776",
        ),
        (
            ("", &|b| both(b, ("track_size", &[1]), ("track_flat", &[0]))),
            "dataset track_size: has 1 entries, while there are 2 prisms",
        ),
        (
            ("", &|b| both(b, ("track_size", &[1, 1]), ("track_flat", &[0]))),
            "dataset track_flat: has 1 entries, while track_size adds up to 2",
        ),
        (
            ("", &|b| both(b, ("track_size", &[2, -1]), ("track_flat", &[0]))),
            "dataset track_size: row 1: -1 is negative",
        ),
        (
            ("", &|b| both(b, ("meta_edges_flat", &[1, 2, 3, 4]), ("meta_edges_ind", &[0, 2, 4]))),
            "dataset meta_edges_ind: entry 1 ends at 2: no record of three or more of the 4 numbers",
        ),
        (
            ("", &|b| both(b, ("meta_edges_flat", &[1, 2, 3]), ("meta_edges_ind", &[0, 2_000_000_000]))),
            "dataset meta_edges_ind: entry 1 ends at 2000000000: no record",
        ),
        (
            ("", &|b| both(b, ("meta_edges_flat", &[1, 2, 3, 4]), ("meta_edges_ind", &[3]))),
            "dataset meta_edges_flat: has 1 numbers after the last record",
        ),
        (
            ("", &|b| {
                b.create_dataset("ref.V").with_f64_data(&[0.0; 3]).with_shape(&[1, 3]);
                b.create_dataset("ref.F").with_i32_data(&[0, 0, 1]).with_shape(&[1, 3]);
            }),
            "dataset ref.F: row 0: 1 is out of range: at most 1 exist",
        ),
    ];
    for (edit, expected) in cases {
        let message = edited(edit).unwrap_err().to_string();
        assert!(message.starts_with(&format!("x.h5: {expected}")), "{message}");
    }
}

/// Parses damaged bytes. The result is free, but a failure must come as an error of the parser's
/// own, not as a panic that had to be caught.
fn survive(bytes: Vec<u8>) -> bool {
    match parse("damaged", bytes) {
        Ok(_) => true,
        Err(error) => {
            let message = error.to_string();
            assert!(!message.contains("failed on this damaged file"), "{message}");
            assert!(!message.contains('\n'), "{message}");
            false
        }
    }
}

/// The sample's shell in compressed chunks, by another writer.
fn chunked() -> Vec<u8> {
    let shell = sample().shell;
    let mut builder = FileBuilder::new();
    for (name, points) in [("mbase", &shell.bottom), ("mV", &shell.middle), ("mtop", &shell.top)] {
        let set = builder.create_dataset(name).with_f64_data(points.as_flattened()).with_shape(&[4, 3]);
        set.with_chunks(&[2, 2]).with_deflate(6);
    }
    builder.create_dataset("mF").with_i32_data(&[0, 1, 2, 2, 1, 3]).with_shape(&[2, 3]).with_chunks(&[1, 3]);
    builder.finish().unwrap()
}

fn originals() -> Vec<Vec<u8>> {
    let mut files = vec![to_bytes(&sample()).unwrap(), chunked()];
    if let Some(directory) = shell_directory() {
        files.push(std::fs::read(directory.join("cube.obj.h5")).unwrap());
    }
    files
}

#[test]
fn every_truncation_is_an_error() {
    for bytes in originals() {
        assert!(survive(bytes.clone()));
        // A file ends with data, which may be padded to a multiple of 8.
        for length in 0..bytes.len() - 8 {
            assert!(!survive(bytes[..length].to_vec()), "accepted {length} of {} bytes", bytes.len());
        }
    }
}

#[test]
fn every_single_bit_flip_is_survived() {
    for bytes in originals() {
        for bit in 0..8 * bytes.len() {
            let mut damaged = bytes.clone();
            damaged[bit / 8] ^= 1 << (bit % 8);
            survive(damaged);
        }
    }
}

#[test]
fn overwritten_fields_are_survived() {
    for bytes in originals() {
        // Headers lie on 4-byte boundaries: all of them with huge or zero counts and addresses.
        for at in (0..bytes.len() - 8).step_by(4) {
            for value in [0, 1 << 20, 1 << 31, 1 << 40, u64::MAX >> 1, u64::MAX, bytes.len() as u64, 96] {
                let mut damaged = bytes.clone();
                damaged[at..at + 8].copy_from_slice(&u64::to_le_bytes(value));
                survive(damaged);
            }
        }
    }
}

#[test]
fn no_hdf5_at_all() {
    let mut noise = Vec::new();
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for _ in 0..4096 {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        noise.push((state >> 56) as u8);
    }
    let mut signed = b"\x89HDF\r\n\x1a\n".to_vec();
    signed.extend(&noise);
    for bytes in [Vec::new(), vec![0; 1 << 16], vec![b'\n'; 1000], vec![b'7'; 10_000_000], noise, signed] {
        let error = parse("x", bytes).unwrap_err();
        assert!(matches!(error, ReadError::Format { .. }), "{error}");
    }
}

/// A dataset whose stored extent is changed to claim more than the file holds.
#[test]
fn huge_extents_are_refused_before_allocation() {
    let bytes = to_bytes(&sample()).unwrap();
    let good = [4_u64, 3].map(u64::to_le_bytes).concat();
    let at = bytes.windows(16).position(|window| window == good).unwrap();
    for rows in [5_u64, 1 << 20, 1 << 40, u64::MAX / 24, u64::MAX] {
        let mut damaged = bytes.clone();
        damaged[at..at + 8].copy_from_slice(&rows.to_le_bytes());
        let error = parse("x", damaged).unwrap_err();
        assert!(matches!(error, ReadError::Dataset { .. }), "{error}");
    }
}

/// The stored number type is compared as a whole: a float with another exponent bias, or an
/// integer of 31 bits, is not read as if it were an ordinary one.
#[test]
fn unusual_number_types_are_refused() {
    let bytes = to_bytes(&sample()).unwrap();
    let find = |pattern: &[u8]| bytes.windows(pattern.len()).position(|window| window == pattern).unwrap();
    let bias = find(&[52, 11, 0, 52, 0xff, 0x03, 0, 0]) + 4;
    let precision = find(&[0x10, 0x08, 0, 0, 4, 0, 0, 0, 0, 0, 32, 0]) + 10;
    for (at, value, expected) in [(bias, 0xfe, "not IEEE"), (precision, 31, "not integers")] {
        let mut damaged = bytes.clone();
        damaged[at] = value;
        let error = parse("x", damaged).unwrap_err().to_string();
        assert!(error.contains(expected), "{error}");
    }
    // The same file is readable as an HDF5 file.
    assert_eq!(
        File::from_bytes(bytes).unwrap().dataset("mF").unwrap().read_i32().unwrap(),
        [0, 1, 2, 2, 1, 3]
    );
}
