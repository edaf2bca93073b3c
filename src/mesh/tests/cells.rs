//! Readers of formats for cells of several dimensions: known facts of real files, variants of one mesh, hostile files.

use super::*;
use crate::number::Rat;
use crate::predicate::orient3d;
use base64::Engine as _;
use std::io::Write as _;

fn complex(bytes: &[u8], format: Format) -> ComplexFile {
    parse_complex(bytes, format, "test").expect("must parse")
}

fn tets(file: &ComplexFile) -> (&[[f64; 3]], &[[u32; 4]]) {
    match (&file.complex.positions, &file.complex.cells) {
        (Positions::Float(p), Cells::Tets(t)) => (p, t),
        other => panic!("no tets in doubles: {other:?}"),
    }
}

/// Positive, zero and negative tets.
fn signs(points: &[[f64; 3]], tets: &[[u32; 4]]) -> [usize; 3] {
    let mut out = [0; 3];
    for t in tets {
        let [a, b, c, d] = t.map(|v| &points[v as usize]);
        out[match orient3d(a, b, c, d).as_i8() {
            1 => 0,
            0 => 1,
            _ => 2,
        }] += 1;
    }
    out
}

#[test]
fn tet_meshes_have_the_listed_facts() {
    let Some(data) = data("") else { return };
    // Vertices, tets and inverted tets of INDEX.md; no tet is flat.
    let facts = [
        ("octopus-low.mesh", 452, 1140, 0, Format::Medit),
        ("thingi10k_83715_domain.ovm", 303, 607, 0, Format::Ovm),
        ("notch_domain.ovm", 502, 1850, 0, Format::Ovm),
        ("sphere1K.msh", 1760, 6851, 0, Format::Gmsh),
        ("cylinder.ovm", 2275, 9764, 0, Format::Ovm),
        ("bunny.msh", 4670, 19379, 0, Format::Gmsh),
        ("hand.mesh", 7234, 29998, 0, Format::Medit),
        ("Armadillo13K.msh", 13230, 54985, 0, Format::Gmsh),
        ("torus.msh", 200, 491, 0, Format::Gmsh),
        ("P1.msh", 1585, 6414, 8, Format::Gmsh),
    ];
    for (name, vertices, count, inverted, format) in facts {
        let file = read_complex(&data.join("tet").join(name)).unwrap();
        let (points, cells) = tets(&file);
        assert_eq!((points.len(), cells.len(), file.format), (vertices, count, format), "{name}");
        let [positive, zero, negative] = signs(points, cells);
        assert_eq!(zero, 0, "{name}");
        // The sign of the whole mesh is a matter of the program that wrote it.
        assert_eq!(positive.min(negative), inverted, "{name}");
        if format == Format::Ovm {
            assert_eq!(negative, 0, "{name}: half-faces look inward");
        }
        let refused = read(&data.join("tet").join(name)).unwrap_err().to_string();
        assert!(refused.contains("tets) where a surface is wanted"), "{refused}");
    }
}

#[test]
fn exact_positions_of_openvolumemesh() {
    let Some(data) = data("") else { return };
    let maps = data.join("thirdparty/tetmaps");
    let file = read_complex(&maps.join("thingi10k_83715_tet_codomain.ovm")).unwrap();
    assert_eq!(file.complex.cells.len(), 1937);
    let names: Vec<&str> = file.exact.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["str_exact_position", "str_domain_exact_position"]);
    let first = &file.exact("str_exact_position").unwrap()[0];
    let wanted = [
        "3145783822515053/18014398509481984",
        "-5230756655079245/72057594037927936",
        "5181208584992259/9007199254740992",
    ];
    assert_eq!(first.each_ref().map(ToString::to_string), wanted);
    assert!(file.exact.iter().all(|(_, points)| points.len() == 556));

    let points = read_rational(&maps.join("example_rational.txt")).unwrap();
    assert_eq!(points.len(), 9);
    assert_eq!(points[8][1], Rat::from(-1) / Rat::from(3));
}

#[test]
fn freesurfer_surfaces_share_their_triangles() {
    let Some(data) = data("") else { return };
    let [white, pial] =
        ["white", "pial"].map(|name| read(&data.join(format!("pairs/{name}_left.gii.gz"))).unwrap());
    for file in [&white, &pial] {
        assert_eq!(
            (file.mesh.vertices.len(), file.mesh.faces.len(), file.format),
            (10242, 20480, Format::Gifti)
        );
        assert!(validate(&file.mesh).unwrap().is_valid());
    }
    assert_eq!(white.mesh.faces, pial.mesh.faces);
    assert_ne!(white.mesh.vertices, pial.mesh.vertices);
}

const POINTS: [[f64; 3]; 5] =
    [[0.0, 0.0, 0.0], [1.5, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 0.1], [-1.0, 0.0, 0.25]];
const TETS: [[u32; 4]; 2] = [[0, 1, 2, 3], [0, 2, 4, 3]];
const FACES: [[u32; 3]; 3] = [[0, 1, 2], [1, 3, 2], [4, 0, 2]];

/// Bytes of numbers in one order.
#[derive(Clone, Copy)]
struct Order(bool);

impl Order {
    fn put<const N: usize>(self, out: &mut Vec<u8>, little: [u8; N]) {
        let mut bytes = little;
        if self.0 {
            bytes.reverse();
        }
        out.extend(bytes);
    }

    fn ints(self, out: &mut Vec<u8>, values: &[i32]) {
        values.iter().for_each(|v| self.put(out, v.to_le_bytes()));
    }

    fn longs(self, out: &mut Vec<u8>, values: &[u64]) {
        values.iter().for_each(|v| self.put(out, v.to_le_bytes()));
    }

    fn doubles(self, out: &mut Vec<u8>, values: &[f64]) {
        values.iter().for_each(|v| self.put(out, v.to_le_bytes()));
    }
}

fn vtk(binary: bool, new_layout: bool) -> Vec<u8> {
    let version = if new_layout { "5.1" } else { "4.2" };
    let encoding = if binary { "BINARY" } else { "ASCII" };
    let order = Order(true);
    let mut out = format!(
        "# vtk DataFile Version {version}\na title\n{encoding}\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 double\n"
    )
    .into_bytes();
    let numbers = |out: &mut Vec<u8>, values: &[u64], wide: bool| {
        match (binary, wide) {
            (false, _) => values.iter().for_each(|v| out.extend(format!("{v} ").bytes())),
            (true, true) => order.longs(out, values),
            (true, false) => order.ints(out, &values.iter().map(|v| *v as i32).collect::<Vec<_>>()),
        }
        out.push(b'\n');
    };
    if binary {
        order.doubles(&mut out, POINTS.as_flattened());
    } else {
        POINTS.as_flattened().iter().for_each(|x| out.extend(format!("{x:?} ").bytes()));
    }
    out.push(b'\n');
    let flat: Vec<u64> = TETS.iter().flatten().map(|&v| v.into()).collect();
    if new_layout {
        out.extend(b"METADATA\nINFORMATION 0\n\nCELLS 3 8\nOFFSETS vtktypeint64\n");
        numbers(&mut out, &[0, 4, 8], true);
        out.extend(b"CONNECTIVITY vtktypeint64\n");
        numbers(&mut out, &flat, true);
    } else {
        out.extend(b"CELLS 2 10\n");
        let with_sizes: Vec<u64> =
            flat.chunks(4).flat_map(|c| std::iter::once(4).chain(c.iter().copied())).collect();
        numbers(&mut out, &with_sizes, false);
    }
    out.extend(b"CELL_TYPES 2\n");
    numbers(&mut out, &[10, 10], false);
    out.extend(b"CELL_DATA 2\nSCALARS s int\nLOOKUP_TABLE default\n1\n2\n");
    out
}

/// Tags are not in order and not dense.
const TAGS: [u64; 5] = [70, 3, 11, 500, 4];

fn gmsh(version: &str, binary: bool, big: bool) -> Vec<u8> {
    let order = Order(big);
    let mut out = format!("$MeshFormat\n{version} {} 8\n", u8::from(binary)).into_bytes();
    if binary {
        order.ints(&mut out, &[1]);
        out.push(b'\n');
    }
    out.extend(b"$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"a body\"\n$EndPhysicalNames\n$Nodes\n");
    let tag = |v: u32| TAGS[v as usize];
    let mut text = |s: String| out.extend(s.bytes());
    let point = |[x, y, z]: [f64; 3]| format!("{x:?} {y:?} {z:?}\n");
    match (version, binary) {
        ("2.2", false) => {
            text("5\n".to_owned());
            (0..5).for_each(|i| text(format!("{} {}", TAGS[i], point(POINTS[i]))));
            text("$EndNodes\n$Elements\n3\n9 15 2 0 0 70\n".to_owned());
            TETS.iter().for_each(|t| {
                text(format!("8 4 2 0 1 {} {} {} {}\n", tag(t[0]), tag(t[1]), tag(t[2]), tag(t[3])));
            });
        }
        ("2.2", true) => {
            text("5\n".to_owned());
            for (tag, point) in TAGS.iter().zip(POINTS) {
                order.ints(&mut out, &[*tag as i32]);
                order.doubles(&mut out, &point);
            }
            out.extend(b"\n$EndNodes\n$Elements\n3\n");
            order.ints(&mut out, &[15, 1, 2, 9, 0, 0, 70, 4, 2, 1]);
            TETS.iter().for_each(|t| {
                order.ints(
                    &mut out,
                    &[8, 1, tag(t[0]) as i32, tag(t[1]) as i32, tag(t[2]) as i32, tag(t[3]) as i32],
                );
            });
        }
        (_, false) => {
            text("2 5 3 500\n3 1 0 2\n70\n3\n".to_owned());
            (0..2).for_each(|i| text(point(POINTS[i])));
            // A parametric block: two further numbers a node.
            text("2 7 1 3\n11\n500\n4\n".to_owned());
            (2..5).for_each(|i| text(point(POINTS[i]).replace('\n', " 0.5 0.5\n")));
            text("$EndNodes\n$Elements\n1 2 1 2\n3 1 4 2\n".to_owned());
            TETS.iter()
                .for_each(|t| text(format!("8 {} {} {} {}\n", tag(t[0]), tag(t[1]), tag(t[2]), tag(t[3]))));
        }
        (_, true) => {
            order.longs(&mut out, &[1, 5, 3, 500]);
            order.ints(&mut out, &[3, 1, 0]);
            order.longs(&mut out, &[5]);
            order.longs(&mut out, &TAGS);
            order.doubles(&mut out, POINTS.as_flattened());
            out.extend(b"\n$EndNodes\n$Elements\n");
            order.longs(&mut out, &[1, 2, 1, 2]);
            order.ints(&mut out, &[3, 1, 4]);
            order.longs(&mut out, &[2]);
            TETS.iter().for_each(|t| order.longs(&mut out, &[8, tag(t[0]), tag(t[1]), tag(t[2]), tag(t[3])]));
        }
    }
    out.extend(b"\n$EndElements\n");
    out
}

fn medit() -> Vec<u8> {
    let mut out = String::from("MeshVersionFormatted 2\n\nDimension\n3\n# a comment\nVertices\n5\n");
    POINTS.iter().for_each(|[x, y, z]| out += &format!("{x:?} {y:?} {z:?} 0\n"));
    out += "Corners 1\n2\nTriangles\n1\n1 2 3 7\nTetrahedra\n2\n";
    TETS.iter().for_each(|t| out += &format!("{} {} {} {} 1\n", t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1));
    out += "End\n";
    out.into_bytes()
}

fn ovm() -> Vec<u8> {
    // Edges of tet 0 1 2 3, then those of 4. Faces of the first tet as seen from inside, then those of the second.
    let mut out = String::from("OVM ASCII\nVertices\n5\n");
    POINTS.iter().for_each(|[x, y, z]| out += &format!("{x:?} {y:?} {z:?}\n"));
    out += "Edges\n9\n0 1\n1 2\n2 0\n0 3\n1 3\n2 3\n0 4\n4 2\n3 4\n";
    // 0: (0 1 2), 1: (0 3 1), 2: (1 3 2), 3: (2 3 0), 4: (0 2 4), 5: (4 3 0), 6: (2 3 4).
    out += "Faces\n7\n3 0 2 4\n3 6 9 1\n3 8 11 3\n3 10 7 5\n3 5 15 13\n3 17 7 12\n3 10 16 14\n";
    // The second tet, 0 2 4 3: (0 2 4), (0 3 2) which is face 3 reversed, (2 3 4), (4 3 0).
    out += "Polyhedra\n2\n4 0 2 4 6\n4 8 7 12 10\n";
    out += "VProp string \"str_exact_position\"\n7:0;0;1/3\n6:1;2;-3\n5:0;0;1\n5:0;0;1\n5:0;0;1\nEProp bool \"b\"\n";
    out += &"1\n".repeat(9);
    out.into_bytes()
}

fn gifti(encoding: &str) -> Vec<u8> {
    let order = Order(false);
    let array = |intent: &str, kind: &str, rows: usize, raw: Vec<u8>, text: String| {
        let data = match encoding {
            "ASCII" => text,
            "Base64Binary" => base64::engine::general_purpose::STANDARD.encode(raw),
            _ => {
                let mut z = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
                z.write_all(&raw).unwrap();
                base64::engine::general_purpose::STANDARD.encode(z.finish().unwrap())
            }
        };
        format!(
            "<DataArray Intent=\"NIFTI_INTENT_{intent}\" DataType=\"NIFTI_TYPE_{kind}\" ArrayIndexingOrder=\"RowMajorOrder\" \
             Dimensionality=\"2\" Dim0=\"{rows}\" Dim1=\"3\" Encoding=\"{encoding}\" Endian=\"LittleEndian\">\n<MetaData/>\n\
             <Data>{data}</Data></DataArray>\n"
        )
    };
    let words = |values: Vec<String>| values.join(" ");
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    order.doubles(&mut points, POINTS.as_flattened());
    order.ints(&mut faces, &FACES.as_flattened().iter().map(|v| v.cast_signed()).collect::<Vec<_>>());
    let text_points = words(POINTS.as_flattened().iter().map(|x| format!("{x:?}")).collect());
    let text_faces = words(FACES.as_flattened().iter().map(ToString::to_string).collect());
    let mut out = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\">\n<GIFTI>\n",
    );
    out += &array("POINTSET", "FLOAT64", 5, points, text_points);
    out += &array("TRIANGLE", "INT32", 3, faces, text_faces);
    out += "</GIFTI>\n";
    out.into_bytes()
}

/// Every way to write the small tet mesh.
fn tet_files() -> Vec<(String, Format, Vec<u8>)> {
    let mut out = vec![("medit".to_owned(), Format::Medit, medit()), ("ovm".to_owned(), Format::Ovm, ovm())];
    for (binary, new) in [(false, false), (false, true), (true, false), (true, true)] {
        out.push((format!("vtk {binary} {new}"), Format::Vtk, vtk(binary, new)));
    }
    for version in ["2.2", "4.1"] {
        out.push((format!("gmsh {version} text"), Format::Gmsh, gmsh(version, false, false)));
        for big in [false, true] {
            out.push((format!("gmsh {version} binary {big}"), Format::Gmsh, gmsh(version, true, big)));
        }
    }
    out
}

#[test]
fn all_encodings_are_one_mesh() {
    for (name, format, bytes) in tet_files() {
        assert_eq!(Format::from_content(&bytes), Some(format), "{name}");
        let file = parse_complex(&bytes, format, &name).unwrap_or_else(|e| panic!("{name}: {e}"));
        let (points, cells) = tets(&file);
        assert_eq!(points.to_vec(), POINTS.to_vec(), "{name}");
        // OVM has no order of corners, only an orientation.
        if format == Format::Ovm {
            assert_eq!(signs(points, cells), [2, 0, 0]);
            assert_eq!(file.exact("str_exact_position").unwrap()[0][2], Rat::from(1) / Rat::from(3));
        } else {
            assert_eq!(cells, TETS, "{name}");
        }
    }
    for encoding in ["ASCII", "Base64Binary", "GZipBase64Binary"] {
        let bytes = gifti(encoding);
        assert_eq!(Format::from_content(&bytes), Some(Format::Gifti));
        let file = parse(&bytes, Format::Gifti, encoding).unwrap();
        assert_eq!((file.mesh.vertices.as_slice(), file.mesh.faces.as_slice()), (&POINTS[..], &FACES[..]));
    }
}

#[test]
fn surfaces_in_formats_for_all_dimensions() {
    let polydata = b"# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nTIME 1 1 double\n0.5\nPOINTS 4 float\n\
        0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 1 5\n4 0 1 2 3\n";
    let file = parse(polydata, Format::Vtk, "test").unwrap();
    assert_eq!(file.mesh.faces, [[0, 1, 2], [0, 2, 3]]);
    let flat = b"MeshVersionFormatted 1 Dimension 2 Vertices 3 0 0 1 1 0 1 0 1 1 Triangles 1 1 2 3 0 End";
    let file = complex(flat, Format::Medit);
    assert_eq!((file.complex.space, file.complex.cells), (Space::Plane, Cells::Triangles(vec![[0, 1, 2]])));
    let msh = b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n5 0 0 0\n1 1 0 0\n9 0 1 0\n$EndNodes\n$Elements\n1\n1 2 2 0 0 9 5 1\n$EndElements\n";
    assert_eq!(parse(msh, Format::Gmsh, "test").unwrap().mesh.faces, [[2, 0, 1]]);
}

#[test]
fn truncated_files_are_errors_or_shorter() {
    let mut files = tet_files();
    for encoding in ["ASCII", "Base64Binary", "GZipBase64Binary"] {
        files.push((encoding.to_owned(), Format::Gifti, gifti(encoding)));
    }
    for (name, format, bytes) in files {
        for end in 0..bytes.len() {
            match parse_complex(&bytes[..end], format, "test") {
                Ok(file) => {
                    assert!(file.complex.cells.len() <= 3 && file.complex.positions.len() <= 5, "{name}");
                }
                Err(e) => assert!(!e.to_string().contains('\n') && e.to_string().len() < 300, "{name}: {e}"),
            }
        }
    }
}

#[test]
fn damaged_bytes_never_panic() {
    let mut files = tet_files();
    for encoding in ["ASCII", "Base64Binary", "GZipBase64Binary"] {
        files.push((encoding.to_owned(), Format::Gifti, gifti(encoding)));
    }
    for (_, format, bytes) in files {
        for at in 0..bytes.len() {
            for value in [0, 1, 0x20, 0x2d, 0x39, 0x7f, 0xff] {
                let mut damaged = bytes.clone();
                damaged[at] = value;
                if let Ok(file) = parse_complex(&damaged, format, "test") {
                    let n = file.complex.positions.len();
                    assert!(file.complex.cells.flat().iter().all(|&v| (v as usize) < n));
                }
            }
        }
    }
}

#[test]
fn faults_are_named_with_their_place() {
    let case = |text: &str, format| refused(text.as_bytes(), format);
    let head = "# vtk DataFile Version 4.2\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n";
    let vtk = |rest: &str| case(&format!("{head}{rest}"), Format::Vtk);
    assert!(vtk("POINTS 4000000000 double\n0 0 0\n").starts_with("test:7: expected a coordinate"));
    assert!(vtk("POINTS 1 double\n0 nan 0\n").starts_with("test:6: coordinate"));
    let one = "POINTS 3 double\n0 0 0 1 0 0 0 1 0\n";
    assert_eq!(
        vtk(&format!("{one}CELLS 1 4\n3 0 1 3\nCELL_TYPES 1\n5\n")),
        "test: cell 0: vertex index 3 is out of range (the mesh has 3 vertices)"
    );
    assert!(
        vtk(&format!("{one}CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n12\n"))
            .contains("cell 0: VTK cell type 12 is not supported")
    );
    assert!(
        vtk(&format!("{one}CELLS 1 9\n3 0 1 2\nCELL_TYPES 1\n5\n"))
            .contains("9 numbers of cells are announced, 4 found")
    );
    let cells = "CELLS 1 4\n3 0 1 2\n";
    assert!(vtk(&format!("{one}{cells}{cells}CELL_TYPES 1\n5\n")).contains("there are two sections CELLS"));
    let types = "CELL_TYPES 1\n5\n";
    assert!(vtk(&format!("{one}{cells}{types}{types}")).contains("there are two sections CELL_TYPES"));
    let nodes = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n1 0 0 0\n1 1 0 0\n$EndNodes\n";
    assert_eq!(case(nodes, Format::Gmsh), "test:7: two nodes have the tag 1");
    assert!(
        case("$MeshFormat\n4.0 0 8\n$EndMeshFormat\n", Format::Gmsh)
            .contains("Gmsh format version \"4.0\" is not supported")
    );
    let medit = "MeshVersionFormatted 1\nDimension 3\nVertices 1\n0 0 0 0\nTriangles 1\n1 1 2 0\n";
    assert_eq!(
        case(medit, Format::Medit),
        "test:6: vertex index 2 is out of range (the mesh has 1 vertices)"
    );
    let ovm = "OVM ASCII\nVertices\n1\n0 0 0\nEdges\n1\n0 1\n";
    assert_eq!(case(ovm, Format::Ovm), "test:7: vertex index 1 is out of range (the mesh has 1 vertices)");
    let bomb = "<GIFTI><DataArray Intent=\"NIFTI_INTENT_POINTSET\" DataType=\"NIFTI_TYPE_FLOAT32\" Dimensionality=\"2\" \
        Dim0=\"4000000000\" Dim1=\"3\" Encoding=\"Base64Binary\" Endian=\"LittleEndian\"><Data>AAAA</Data></DataArray></GIFTI>";
    assert!(case(bomb, Format::Gifti).starts_with("test: array 0: expected 48000000000 bytes of numbers"));
    // Read by rows, a file by columns would be another surface: an order that is not understood is no default.
    let ordered = |order: &str| {
        let text = String::from_utf8(gifti("ASCII")).unwrap();
        case(&text.replacen("ArrayIndexingOrder=\"RowMajorOrder\"", order, 1), Format::Gifti)
    };
    assert_eq!(
        ordered("ArrayIndexingOrder=\"Columns\""),
        "test: array 0: ArrayIndexingOrder \"Columns\" is not supported"
    );
    assert!(ordered("ArrayIndexingOrder=ColumnMajorOrder").starts_with("test: array 0: XML: "));
}

#[test]
fn texture_coordinates() {
    let square =
        "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    let read = obj::parse_uv(square.as_bytes()).unwrap();
    let [space, plane] = read.whole().unwrap();
    assert_eq!((space.space, plane.space, &space.cells), (Space::Space, Space::Plane, &plane.cells));
    assert_eq!(
        plane.positions,
        Positions::Float(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
    );
    // Corner 1 of the second triangle is elsewhere in the plane.
    let seam = square.replace("f 1/1 3/3 4/4", "vt 5 5\nf 1/-1 3/3 4/4");
    let read = obj::parse_uv(seam.as_bytes()).unwrap();
    assert_eq!(read.whole(), Err(UvError::Seams { vertices: 1, vertex: 0 }));
    let [space, plane] = read.cut().unwrap();
    assert_eq!((space.positions.len(), plane.cells), (5, Cells::Triangles(vec![[0, 1, 2], [3, 2, 4]])));
    let missing = obj::parse_uv(b"v 0 0 0\nf 1 1 1\n").unwrap_err().reading("test").to_string();
    assert_eq!(missing, "test:2: expected a face corner with a texture coordinate, found \"1\"");
    let mut holed = obj::parse_uv(square.as_bytes()).unwrap();
    holed.uv.pop();
    assert_eq!(
        (holed.whole(), holed.cut()),
        (Err(UvError::Index { triangle: 1 }), Err(UvError::Index { triangle: 1 }))
    );
    holed.uv_faces.pop();
    assert_eq!(holed.cut(), Err(UvError::Index { triangle: 1 }));
}
