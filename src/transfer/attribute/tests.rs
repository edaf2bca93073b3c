//! Tests of attributes: reading, carrying, writing.
#![allow(clippy::float_cmp)]

use super::{
    Attribute, AttributeError, Domain, Sample, Samples, Values, Weights, carry, from_csv, from_json,
};
use super::{read, to_csv, to_json, to_ply};
use crate::mesh::TriMesh;
use crate::number::Rat;
use crate::projection::Projection;
use crate::shell::VertexOrder;
use crate::transfer::tests::generated;
use crate::transfer::{ExactPoint, Transfer};

fn numbers(width: usize, data: &[f64]) -> Values {
    Values::Numbers { width, data: data.to_vec(), bytes: false }
}

fn square() -> TriMesh {
    let vertices = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    TriMesh { vertices, faces: vec![[0, 1, 2], [0, 2, 3]] }
}

/// A function that is linear on every middle triangle is carried to a mesh as it is, and its value there is the
/// one at the point below. With values that are small integers nothing is rounded but the result.
#[test]
fn a_linear_function_on_the_middle_surface_stays_exact() {
    let (shell, mesh, _) = generated();
    let middle = TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() };
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &middle, &mesh).unwrap();
    let data: Vec<f64> = (0..middle.vertices.len()).map(|v| (v * v % 17) as f64).collect();
    let values = numbers(1, &data);
    let attribute = Attribute { name: "f".to_owned(), domain: Domain::Vertex, values };
    let samples = Samples::new(&transfer, &mesh, true).unwrap();
    let carried = carry(&attribute, &middle, &samples).unwrap();
    let Values::Numbers { data: found, .. } = carried.values else { panic!() };
    assert_eq!(found.len(), mesh.vertices.len());
    for (v, p) in mesh.vertices.iter().enumerate() {
        // The slow exact projection of the vertex, and the function there.
        let below = projection.project_exactly(p).unwrap();
        let corners = middle.faces[below.prism as usize];
        let value = (0..3).map(|k| &below.weights[k] * Rat::try_from(data[corners[k] as usize]).unwrap());
        assert_eq!(found[v], value.fold(Rat::ZERO, |s, x| s + x).to_f64().value());
    }
    // In doubles the same to within the bound: three weights, values below 17.
    let near = Samples::new(&transfer, &mesh, false).unwrap();
    let Values::Numbers { data: rounded, .. } = carry(&attribute, &middle, &near).unwrap().values else {
        panic!()
    };
    for (v, (x, y)) in found.iter().zip(&rounded).enumerate() {
        assert!((x - y).abs() <= 3.0 * 17.0 * near.vertices[v].error + 1e-14);
    }
}

/// Every triangle's label goes to the triangles whose centroid it holds.
#[test]
fn face_labels_go_where_the_centroids_are() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    let names: Vec<String> = (0..7).map(|i| format!("part {i}")).collect();
    let of: Vec<u32> = (0..a.faces.len() as u32).map(|f| f % 7).collect();
    let labels =
        Attribute { name: "bc".to_owned(), domain: Domain::Face, values: Values::Labels { of, names } };
    let samples = Samples::new(&transfer, &b, false).unwrap();
    let Values::Labels { of, .. } = carry(&labels, &a, &samples).unwrap().values else { panic!() };
    for (face, label) in (0..b.faces.len() as u32).zip(of) {
        let at = transfer.backward(&ExactPoint::from_f64(face, [1.0; 3]).unwrap()).unwrap();
        assert_eq!(label, at.face % 7);
    }
}

#[test]
fn rules_for_labels_and_seams_by_hand() {
    let mesh = square();
    let sample = |face, weights| Sample { face, weights: Weights::Float(weights), error: 0.0 };
    let samples = Samples {
        vertices: vec![
            sample(0, [0.25, 0.5, 0.25]),
            sample(0, [0.5, 0.0, 0.5]),
            sample(1, [0.1, 0.45, 0.45]),
        ],
        faces: vec![sample(1, [1.0, 0.0, 0.0])],
    };
    let labels =
        Values::Labels { of: vec![0, 1, 2, 3], names: ["a", "b", "c", "d"].map(str::to_owned).to_vec() };
    let at = |domain, values| carry(&Attribute { name: "x".to_owned(), domain, values }, &mesh, &samples);
    let Values::Labels { of, .. } = at(Domain::Vertex, labels.clone()).unwrap().values else { panic!() };
    // The heaviest corner; of equal ones the smaller vertex: 0 before 2, and 2 before 3.
    assert_eq!(of, [1, 0, 2]);
    assert_eq!(
        at(Domain::Vertex, Values::Set(vec![true, false, true, false])).unwrap().values,
        Values::Set(vec![false, true, true])
    );
    assert_eq!(at(Domain::Face, numbers(2, &[1.0, 2.0, 3.0, 4.0])).unwrap().values, numbers(2, &[3.0, 4.0]));
    // Corners 0 to 2 belong to triangle 0, 3 to 5 to triangle 1.
    let corners = at(Domain::Corner, numbers(1, &[0.0, 4.0, 8.0, 100.0, 200.0, 200.0])).unwrap();
    assert_eq!((corners.domain, corners.values), (Domain::Vertex, numbers(1, &[4.0, 4.0, 190.0])));
    let missing = at(Domain::Vertex, numbers(1, &[0.0; 3]));
    assert!(matches!(missing, Err(AttributeError::Count { expected: 4, found: 3, .. })), "{missing:?}");
    let six = Values::Labels { of: vec![0; 6], names: vec!["a".to_owned()] };
    assert!(matches!(at(Domain::Corner, six), Err(AttributeError::CornerLabels { .. })));
}

#[test]
fn tables_and_json_read_back() {
    let mesh = square();
    let text = "vertex,t,zone\n2,2.5,in\n0,0,out\n\n1,-1e3,in\n3,7,out\n";
    let read = from_csv(text.as_bytes(), "x.csv", &mesh).unwrap();
    assert_eq!(read[0].values, numbers(1, &[0.0, -1e3, 2.5, 7.0]));
    let zone = Values::Labels { of: vec![0, 1, 1, 0], names: vec!["out".to_owned(), "in".to_owned()] };
    assert_eq!(read[1].values, zone);
    assert_eq!(from_csv(&to_csv(&read).unwrap(), "x.csv", &mesh).unwrap(), read);
    let text = r#"{"vertex": {"v": [[1,2],[3,4],[5,6],[7,8.5]]}, "face": {"bc": ["wall","inlet"]},
                   "sets": {"face": {"hot": [1]}, "vertex": {"rim": [0, 3]}}}"#;
    let read = from_json(text.as_bytes(), "x.json", &mesh).unwrap();
    assert_eq!(read.len(), 4);
    let again = from_json(to_json(&read).to_string().as_bytes(), "x.json", &mesh).unwrap();
    assert!(read.iter().all(|a| again.contains(a)));
    assert_eq!(to_csv(&read), Err(AttributeError::BothDomains));
}

#[test]
fn bad_tables_are_refused_with_their_place() {
    let mesh = square();
    for (text, line) in [
        ("", 1),
        ("id,t\n0,1\n", 1),
        ("vertex\n0\n", 1),
        ("vertex,t\n0,1\n4,1\n", 3),
        ("vertex,t\n0,1\n0,1\n", 3),
        ("vertex,t\n0\n", 2),
        ("face,t\n-1,0\n", 2),
        ("vertex,t\n0,\"a\"\n", 2),
    ] {
        match from_csv(text.as_bytes(), "x.csv", &mesh) {
            Err(AttributeError::Line { line: found, .. }) => assert_eq!(found, line, "{text:?}"),
            other => panic!("{text:?}: {other:?}"),
        }
    }
    assert!(matches!(from_csv(b"vertex,t\n0,1\n", "x", &mesh), Err(AttributeError::File { .. })));
    assert!(from_csv(b"vertex,\xff\n", "x", &mesh).is_err());
    for text in [
        "",
        "[]",
        r#"{"edge": {}}"#,
        r#"{"vertex": []}"#,
        r#"{"vertex": {"a": 1}}"#,
        r#"{"vertex": {"a": [1, "x"]}}"#,
        r#"{"vertex": {"a": [[1], [1, 2]]}}"#,
        r#"{"vertex": {"a": [null]}}"#,
        r#"{"sets": {"edge": {}}}"#,
        r#"{"sets": {"face": {"a": [2]}}}"#,
        r#"{"sets": {"face": {"a": [-1]}}}"#,
    ] {
        assert!(
            matches!(from_json(text.as_bytes(), "x", &mesh), Err(AttributeError::File { .. })),
            "{text:?}"
        );
    }
}

#[test]
fn properties_go_through_ply_files() {
    let mesh = square();
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("a.ply");
    let colour = Values::Numbers { width: 1, data: vec![0.0, 127.6, 300.0, -1.0], bytes: true };
    let at = |name: &str, domain, values| Attribute { name: name.to_owned(), domain, values };
    let named = Values::Labels { of: vec![0, 1], names: vec!["in let".to_owned(), "wall".to_owned()] };
    let attributes = [
        at("red", Domain::Vertex, colour),
        at("x", Domain::Vertex, numbers(1, &[0.1, 0.2, 0.3, 1e-300])),
        at("v", Domain::Vertex, numbers(2, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0])),
        at("bc", Domain::Face, named),
        at("part", Domain::Face, Values::Labels { of: vec![0, 0], names: vec!["-7".to_owned()] }),
    ];
    std::fs::write(&path, to_ply(&mesh, &attributes, "a\nb")).unwrap();
    // The geometry is not disturbed, and every value comes back.
    assert_eq!(crate::mesh::read(&path).unwrap().mesh, mesh);
    let back = read(&path, &mesh).unwrap();
    let names: Vec<&str> = back.iter().map(|a| a.name.as_str()).collect();
    assert_eq!(names, ["red", "x_2", "v_0", "v_1", "bc", "part"]);
    assert_eq!(back[0].values, Values::Numbers { width: 1, data: vec![0.0, 128.0, 255.0, 0.0], bytes: true });
    assert_eq!(back[1].values, numbers(1, &[0.1, 0.2, 0.3, 1e-300]));
    assert_eq!(back[3].values, numbers(1, &[2.0, 4.0, 6.0, 8.0]));
    assert_eq!(
        back[4].values,
        Values::Labels { of: vec![0, 1], names: vec!["0".to_owned(), "1".to_owned()] }
    );
    assert_eq!(back[5].values, Values::Labels { of: vec![0, 0], names: vec!["-7".to_owned()] });
    let text = String::from_utf8(std::fs::read(&path).unwrap()).unwrap();
    assert!(text.contains("comment label bc 0 in_let\ncomment label bc 1 wall\n"));
}

#[test]
fn polygons_and_texture_coordinates() {
    let directory = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = directory.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    // A quad is two triangles with one value.
    let ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
               element face 1\nproperty list uchar int vertex_indices\nproperty float q\nend_header\n\
               0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 0.5\n";
    let path = write("quad.ply", ply);
    assert_eq!(crate::mesh::read(&path).unwrap().mesh, square());
    assert_eq!(read(&path, &square()).unwrap()[0].values, numbers(1, &[0.5, 0.5]));
    assert!(read(&write("nan.ply", &ply.replace("0.5", "nan")), &square()).is_err());
    let many = format!("{} 0 1 2 {} 0.5", 3 + 100, "3 ".repeat(100));
    assert!(read(&write("many.ply", &ply.replace("4 0 1 2 3 0.5", &many)), &square()).is_err());
    let obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0.5\nvt 0.25\nf 1/1 2/2 3/3 4/-1\n";
    let path = write("quad.obj", obj);
    let uv = read(&path, &square()).unwrap();
    let expected = [0.0, 0.0, 1.0, 0.5, 0.25, 0.0, 0.0, 0.0, 0.25, 0.0, 0.25, 0.0];
    assert_eq!(
        (uv[0].name.as_str(), uv[0].domain, &uv[0].values),
        ("uv", Domain::Corner, &numbers(2, &expected))
    );
    for bad in ["4/4", "4", "4//1", "4/-4", "4/x", "4/9223372036854775807"] {
        assert!(read(&write("bad.obj", &obj.replace("4/-1", bad)), &square()).is_err(), "{bad}");
    }
    assert!(read(&write("a.stl", "solid\nendsolid\n"), &square()).is_err());
}

#[test]
fn a_loose_vertex_is_named() {
    let (shell, a, mut b) = generated();
    b.vertices.push([0.0; 3]);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    let vertex = b.vertices.len() - 1;
    assert_eq!(Samples::new(&transfer, &b, false), Err(AttributeError::LooseVertex { vertex }));
}

#[test]
fn numbers_that_are_not_finite_are_not_carried() {
    let (shell, a, b) = generated();
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let transfer = Transfer::new(&projection, &a, &b).unwrap();
    let mut data = vec![1.0; 2 * a.vertices.len()];
    data[7] = f64::NAN;
    let bad = Attribute { name: "x".to_owned(), domain: Domain::Vertex, values: numbers(2, &data) };
    for exact in [false, true] {
        let samples = Samples::new(&transfer, &b, exact).unwrap();
        let refused = carry(&bad, &a, &samples);
        assert_eq!(refused, Err(AttributeError::NotFinite { name: "x".to_owned(), element: 3 }));
    }
}
