//! What each reader makes of small files.

use super::*;

const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

#[test]
fn off_variants() {
    let plain = parsed("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Format::Off);
    assert_eq!(plain.mesh, TriMesh { vertices: TRIANGLE.to_vec(), faces: vec![[0, 1, 2]] });
    assert_eq!((plain.format, plain.notes.len()), (Format::Off, 0));
    for text in [
        "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
        "# c\n\nOFF # d\n\n3 1\n0 0 0 # e\n\n1 0 0\n# f\n0 1 0\n3 0 1 2 255 0 0\n# end\n\n",
        "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
        "OFF\r3 1 0\r0 0 0\r1 0 0\r0 1 0\r3 0 1 2\r",
        "\u{feff}OFF\n3 1 0\n\t0 0 0\n1e0 0 0\n0 1. 0\n3 0 1 2\n",
    ] {
        let file = parsed(text, Format::from_content(text.as_bytes()).expect("has a header"));
        assert_eq!(file, plain, "{text:?}");
    }
    for (word, tail) in [("COFF", " 1 2 3 4"), ("NOFF", " 0 0 1"), ("STCNOFF", " 0 0 1 9 9 9 9 0 0")] {
        let text = format!("{word}\n3 1 0\n0 0 0{tail}\n1 0 0{tail}\n0 1 0{tail}\n3 0 1 2\n");
        let file = parsed(&text, Format::Off);
        assert_eq!(file.mesh, plain.mesh);
        assert_eq!(file.notes, ["OFF: ignored extra columns of 3 vertices"]);
    }
    let bare = parsed("3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", Format::Off);
    assert_eq!(
        (bare.mesh, bare.notes.as_slice()),
        (plain.mesh, ["OFF: the word OFF is missing".to_owned()].as_slice())
    );
}

#[test]
fn off_errors() {
    let case = |text: &str| refused(text.as_bytes(), Format::Off);
    assert_eq!(case("OFF\n3 1 0\n0 0 0\n1 x 0\n"), "test:4: expected 3 coordinates, found \"x\"");
    assert_eq!(case("OFF\n3 1 0\n0 0 0\n1 0\n"), "test:4: expected 3 coordinates, found the end of the line");
    assert_eq!(case("OFF\n3 1 0\n0 0 0\n1 0 0\n"), "test: the file ends after 2 of 3 vertices");
    assert_eq!(case("OFF\n1 1 0\n0 0 0\n"), "test: the file ends after 0 of 1 faces");
    assert_eq!(case("OFF\n1 0 0\n0 0 0\n3 0 0 0"), "test:4: unexpected data after the last face");
    assert_eq!(case("OFF\n1 1 0\n0 0 nan\n"), "test:3: coordinate \"nan\" is not a finite f64");
    assert_eq!(case("OFF\n1 1 0\n0 -1e309 0\n"), "test:3: coordinate \"-1e309\" is not a finite f64");
    let index = "is out of range (the mesh has 1 vertices)";
    for i in ["1", "-1", "4294967296"] {
        assert_eq!(
            case(&format!("OFF\n1 1 0\n0 0 0\n3 0 0 {i}")),
            format!("test:4: vertex index {i} {index}")
        );
    }
    assert_eq!(case("OFF\n1 1 0\n0 0 0\n2 0 0"), "test:4: a face needs at least 3 corners, found 2");
    assert_eq!(case("OFF\n1 1 0\n0 0 0\n4 0 0 0"), "test:4: expected 4 vertex indices, found 3");
    assert_eq!(case("OFF\n0 0 0\n"), "test: the mesh has no vertices");
    assert_eq!(case("4OFF\n0 0 0\n"), "test:1: \"4OFF\" (coordinates that are not three) is not supported");
    assert_eq!(case("OFF BINARY\n"), "test:1: binary OFF is not supported");
    assert_eq!(case("OFF\n1 2 3 4\n"), "test:2: expected 2 or 3 counts, found \"4\"");
    assert_eq!(case("OFF"), "test: the file ends after 1 of 2 header lines");
}

#[test]
fn polygons_are_fans() {
    let faces = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [4, 3, 2]];
    let notes = ["polygons fan-triangulated"];
    let vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 .5 0\n";
    let off = format!("OFF\n5 2 0\n{vertices}5 0 1 2 3 4\n3 4 3 2\n");
    let obj =
        format!("{}f 1 2 3 4 5\nf 5 4 3\n", vertices.lines().map(|l| format!("v {l}\n")).collect::<String>());
    let ply = format!(
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
         element face 2\nproperty list uchar int vertex_index\nend_header\n{vertices}5 0 1 2 3 4\n3 4 3 2\n"
    );
    for (text, format, name) in
        [(off, Format::Off, "OFF"), (obj, Format::Obj, "OBJ"), (ply, Format::PlyAscii, "PLY")]
    {
        let file = parsed(&text, format);
        assert_eq!(file.mesh.faces, faces);
        assert_eq!(file.notes, [format!("{name}: 1 {}", notes[0])]);
    }
}

#[test]
fn obj_statements() {
    let text = "# c:\\dir\\\nmtllib a b.mtl\no x\nv 0 0 0 1 0 0\nv 1 0 \\\n 0\n\nvt 0 0\nvn 0 0 1\ng a # b\nv 0 1 0\n\
                v 0 0 1\ns off\nusemtl m\nf 1/1/1 2//1 3/1\nf -4 -2/-1 -1\nf \\\n1 \\\n4 2\nl 1 2\np 1\n";
    let file = parsed(text, Format::Obj);
    assert_eq!(file.mesh.vertices, [TRIANGLE[0], TRIANGLE[1], TRIANGLE[2], [0.0, 0.0, 1.0]]);
    assert_eq!(file.mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 3, 1]]);
    assert_eq!(file.notes, ["OBJ: ignored 2 lines and points", "OBJ: ignored extra columns of 1 vertices"]);
    // A face may name vertices that come later; unused vertices stay.
    let forward = parsed("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 9 9 9\n", Format::Obj);
    assert_eq!((forward.mesh.vertices.len(), forward.mesh.faces), (4, vec![[0, 1, 2]]));
}

#[test]
fn obj_errors() {
    let case = |text: &str| refused(text.as_bytes(), Format::Obj);
    assert_eq!(
        case("v 0 0 0\nf 1 1 2\n"),
        "test:2: vertex index 2 is out of range (the mesh has 1 vertices)"
    );
    assert_eq!(
        case("v 0 0 0\nf 0 1 1\n"),
        "test:2: vertex index 0 is out of range (the mesh has 1 vertices)"
    );
    assert_eq!(
        case("v 0 0 0\nf -2 1 1\n"),
        "test:2: vertex index -2 is out of range (the mesh has 1 vertices)"
    );
    assert_eq!(
        case("f -9223372036854775808 1 1\n"),
        "test:1: vertex index -9223372036854775808 is out of range (the mesh has 0 vertices)"
    );
    assert_eq!(case("v 0 0 0\nf 1 1 1.5\n"), "test:2: expected a face corner, found \"1.5\"");
    assert_eq!(case("v 0 0 0\nf 1/1/1/1 1 1\n"), "test:2: expected a face corner, found \"1/1/1/1\"");
    assert_eq!(case("v 0 0 0\nf 1 1\n"), "test:2: a face needs at least 3 corners, found 2");
    assert_eq!(case("v 0 0 inf\n"), "test:1: coordinate \"inf\" is not a finite f64");
    assert_eq!(case("\n\nv 0 \\\n0\n"), "test:3: expected 3 coordinates, found the end of the line");
    assert_eq!(case("hello\n"), "test:1: expected an OBJ statement, found \"hello\"");
    assert_eq!(case("cstype bezier\n"), "test:1: the statement \"cstype\" is not supported");
    assert_eq!(case("# nothing\n"), "test: the mesh has no vertices");
}

const PLY_TEXT: &str = "ply\r\nformat ascii 1.0\r\ncomment hi\r\nelement colour 2\r\nproperty uchar r\r\n\
    element vertex 3\r\nproperty double z\r\nproperty list uchar float w\r\nproperty int y\r\nproperty float x\r\n\
    element nothing 1099511627776\r\nelement face 1\r\nproperty uchar flags\r\n\
    property list uchar uint vertex_indices\r\nend_header\r\n\
    7\r\n8\r\n0 0 0 0\r\n\r\n0 2 nan 1 0 1\r\n0.1 1 5 1 0\r\n9 3 2 1 0\r\n";

#[test]
fn ply_any_order_of_properties() {
    let file = parsed(PLY_TEXT, Format::PlyAscii);
    assert_eq!(file.mesh.vertices, [TRIANGLE[0], TRIANGLE[1], [0.0, 1.0, 0.1]]);
    assert_eq!(file.mesh.faces, [[2, 1, 0]]);
    assert_eq!(
        file.notes,
        [
            "PLY: ignored element \"colour\"",
            "PLY: ignored 1 properties of element vertex",
            "PLY: ignored 1 properties of element face"
        ]
    );
}

/// The elements of `PLY_TEXT` in binary.
fn binary_ply(big_endian: bool) -> Vec<u8> {
    let name = if big_endian { "binary_big_endian" } else { "binary_little_endian" };
    let (header, _) = PLY_TEXT.split_at(PLY_TEXT.find("end_header").unwrap());
    let mut out = format!("{}end_header\r\n", header.replace("ascii", name)).into_bytes();
    let mut put = |mut bytes: Vec<u8>| {
        if big_endian {
            bytes.reverse();
        }
        out.extend(bytes);
    };
    put(vec![7]);
    put(vec![8]);
    for (z, w, y, x) in
        [(0.0f64, vec![], 0i32, 0.0f32), (0.0, vec![f32::NAN, 1.0], 0, 1.0), (0.1, vec![5.0], 1, 0.0)]
    {
        put(z.to_le_bytes().into());
        put(vec![u8::try_from(w.len()).unwrap()]);
        for x in w {
            put(x.to_le_bytes().into());
        }
        put(y.to_le_bytes().into());
        put(x.to_le_bytes().into());
    }
    put(vec![9]);
    put(vec![3]);
    for i in [2u32, 1, 0] {
        put(i.to_le_bytes().into());
    }
    out
}

#[test]
fn ply_binary_equals_text() {
    let text = parsed(PLY_TEXT, Format::PlyAscii);
    for (big_endian, format) in [(false, Format::PlyBinaryLe), (true, Format::PlyBinaryBe)] {
        let bytes = binary_ply(big_endian);
        assert_eq!(Format::from_content(&bytes), Some(format));
        let file = parse(&bytes, Format::PlyAscii, "test").unwrap();
        assert_eq!((file.format, &file.mesh, &file.notes), (format, &text.mesh, &text.notes));
        for end in 0..bytes.len() {
            refused(&bytes[..end], format);
        }
        let mut longer = bytes.clone();
        longer.push(0);
        assert_eq!(refused(&longer, format), "test: unexpected data after the last element");
    }
}

#[test]
fn ply_errors() {
    let case = |text: &str| refused(text.as_bytes(), Format::PlyAscii);
    let head = |v: &str, f: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 1\n{v}element face 1\nproperty list char {f} vertex_indices\nend_header\n"
        )
    };
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    let body = |b: &str| case(&(head(xyz, "int") + b));
    assert_eq!(body(""), "test: the file ends after 0 of 1 vertex elements");
    assert_eq!(body("0 0 0\n"), "test: the file ends after 0 of 1 face elements");
    assert_eq!(body("0 0\n"), "test:10: expected a number, found the end of the line");
    assert_eq!(body("0 0 0 0\n"), "test:10: expected the end of the line, found \"0\"");
    assert_eq!(body("0 0 nan\n"), "test:10: coordinate \"nan\" is not a finite f64");
    assert_eq!(
        body("0 0 0\n3 0 0 -1\n"),
        "test:11: vertex index -1 is out of range (the mesh has 1 vertices)"
    );
    assert_eq!(body("0 0 0\n3 0 0 1\n"), "test:11: vertex index 1 is out of range (the mesh has 1 vertices)");
    assert_eq!(body("0 0 0\n2 0 0\n"), "test:11: a face needs at least 3 corners, found 2");
    assert_eq!(
        body("0 0 0\n-3 0 0\n"),
        "test:11: expected a list that fits into its element, found length -3"
    );
    assert_eq!(body("0 0 0\n3 0 0 0\n7\n"), "test:12: unexpected data after the last element");
    assert_eq!(
        case(&(head("property float x\n", "int") + "0\n")),
        "test: the header has no property y of vertex"
    );
    assert_eq!(
        case(&(head(xyz, "float") + "0 0 0\n3 0 0 0.5\n")),
        "test: property vertex_indices of face is not a list of integers"
    );
    assert_eq!(case("ply\nformat ascii 2.0\n"), "test:2: expected version 1.0, found \"2.0\"");
    assert_eq!(case("ply\nelement vertex 1\nend_header\n"), "test:3: no format line");
    assert_eq!(case("ply\nproperty int x\n"), "test:2: a property before the first element");
    assert_eq!(case("ply\nelement a 1\nelement a 1\n"), "test:3: element \"a\" is declared twice");
    assert_eq!(
        case("ply\nformat ascii 1.0\nelement vertex 0\nelement tristrips 0\nend_header\n"),
        "test: the element tristrips is not supported"
    );
}

fn facet(points: [[&str; 3]; 3]) -> String {
    let vertices: String = points.iter().map(|p| format!("  vertex {}\n", p.join(" "))).collect();
    format!(" facet normal nan 0 0\n outer loop\n{vertices} endloop\n endfacet\n")
}

#[test]
fn stl_text_is_welded_by_value() {
    let (a, b, c, d) = (["0", "0", "-0"], ["1.0", "0", "0"], ["0", "1", "0"], ["0", "0", "1"]);
    let text = format!(
        "solid x y\n{}{}endsolid x\nSOLID\n{}endsolid",
        facet([a, b, c]),
        facet([["-0", "0", "0"], c, d]),
        facet([["1", "0", "0"], d, c])
    );
    assert_eq!(Format::from_content(text.as_bytes()), Some(Format::StlAscii));
    let file = parsed(&text, Format::StlBinary);
    assert_eq!(file.format, Format::StlAscii);
    assert_eq!(file.mesh.faces, [[0, 1, 2], [0, 2, 3], [1, 3, 2]]);
    // +0 and -0 are one number; the first occurrence gives the bits.
    assert_eq!(file.mesh.vertices[0].map(f64::to_bits), [0.0f64, 0.0, -0.0].map(f64::to_bits));
    assert_eq!(file.notes, ["STL: welded 9 corners to 4 vertices", "STL: 2 solids read as one mesh"]);
}

#[test]
fn stl_errors() {
    let case = |text: &str| refused(text.as_bytes(), Format::StlAscii);
    assert_eq!(case("solid\n"), "test: expected endsolid, found the end of the file");
    assert_eq!(case("solid\nendsolid\n"), "test: the mesh has no vertices");
    assert_eq!(
        case("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0\n"),
        "test:4: expected 3 coordinates, found the end of the line"
    );
    assert_eq!(
        case("solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 inf\n"),
        "test:4: coordinate \"inf\" is not a finite f64"
    );
    assert_eq!(
        case("solid\nfacet normal 0 0 0\nouter loop\nendloop\n"),
        "test:4: expected \"vertex\", found \"endloop\""
    );
    let mut bytes = vec![b' '; 84 + 100];
    bytes[80..84].copy_from_slice(&2u32.to_le_bytes());
    assert_eq!(Format::from_content(&bytes), Some(Format::StlBinary));
    bytes[84 + 50 + 12..84 + 50 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(refused(&bytes, Format::StlBinary), "test: facet 1: coordinate NaN is not a finite f64");
    bytes.pop();
    assert_eq!(
        refused(&bytes, Format::StlBinary),
        "test: expected 184 bytes for a binary STL of 2 facets, found 183 bytes"
    );
}

#[test]
fn binary_stl_that_begins_with_solid() {
    let mesh = TriMesh { vertices: TRIANGLE.to_vec(), faces: vec![[0, 1, 2]] };
    let mut bytes = encode(&mesh, Format::StlBinary, "test").unwrap();
    bytes[..5].copy_from_slice(b"solid");
    let file = parse(&bytes, Format::from_content(&bytes).unwrap(), "test").unwrap();
    assert_eq!((file.format, file.mesh), (Format::StlBinary, mesh));
}
