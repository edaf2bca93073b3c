//! Minimal cases of disagreements that random cases found.
#![allow(clippy::unwrap_used)]

use homeo::certify::{CertifyError, Claim, Options, Silent, certify};
use homeo::mesh::TriMesh;
use homeo::shell::Shell;
use homeo_proptests::Case;
use homeo_proptests::campaign::{certified, compare, holds};
use homeo_proptests::judged::inputs;
use homeo_proptests::oracle::World;
use homeo_proptests::recipe::{Move, Recipe};
use homeo_proptests::sheets::Edit;

fn tetrahedron() -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let points = vec![[4., 4., 4.], [4., -4., -4.], [-4., 4., -4.], [-4., -4., 4.]];
    (points, vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
}

/// Vertices 0 and 2 pinched: the edge between them lies in bottom and top.
fn pinched_edge(mesh: TriMesh) -> Case {
    let (middle, faces) = tetrahedron();
    let scale = |s: f64| {
        let at = |(v, p): (usize, &[f64; 3])| if v % 2 == 0 { *p } else { p.map(|x| x * s) };
        middle.iter().enumerate().map(at).collect()
    };
    let shell = Shell { bottom: scale(0.5), top: scale(1.5), middle: middle.clone(), faces };
    Case { shell, mesh, order: vec![0, 1, 2, 3] }
}

/// All claims are refuted but C1 and the mesh's own embedding, and the checker accepts that.
fn refuted(case: &Case) {
    assert!(World::new(&case.shell, &case.mesh).positivity());
    compare(case).unwrap();
    let outcome = certified(case, true).unwrap().unwrap();
    assert!(holds(&outcome, Claim::Positivity));
    assert!(!holds(&outcome, Claim::Section));
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(case));
    assert_eq!((answer.exit, answer.code), (0, ""), "{}\n{}", answer.message, outcome.certificate);
}

/// A mesh that leaves the shell through such an edge got no verdict ("the tets wind more than once", though C1 holds).
#[test]
fn leaving_through_an_edge_with_two_pinched_ends() {
    let (mut vertices, _) = tetrahedron();
    vertices.push([1., 0., 2.]);
    let faces = vec![[0, 1, 2], [0, 2, 4], [0, 3, 1], [1, 3, 2], [2, 3, 4], [3, 0, 4]];
    refuted(&pinched_edge(TriMesh { vertices, faces }));
}

/// The middle surface itself runs along such an edge: off bottom and top it is not, whether or not it has a vertex there.
#[test]
fn running_along_an_edge_with_two_pinched_ends() {
    let (mut vertices, faces) = tetrahedron();
    refuted(&pinched_edge(TriMesh { vertices: vertices.clone(), faces }));
    vertices.push([0., 4., 0.]);
    let split = vec![[0, 1, 4], [4, 1, 2], [4, 2, 3], [0, 4, 3], [0, 3, 1], [1, 3, 2]];
    refuted(&pinched_edge(TriMesh { vertices, faces: split }));
}

/// Around the middle pillar the prisms wind twice although C1 holds; a mesh triangle that holds the pillar is a fold.
#[test]
fn a_pillar_wound_around_twice() {
    let rim = [[6., 0., 0.], [-2., 4., 0.], [-2., -4., 0.]];
    let middle: Vec<[f64; 3]> = [vec![[0.; 3]], rim.to_vec(), rim.to_vec()].concat();
    let lift = |h: f64| middle.iter().map(|p| [p[0], p[1], p[2] + h]).collect::<Vec<_>>();
    let faces: Vec<[u32; 3]> = (0..6u32).map(|i| [0, 1 + i, 1 + (i + 1) % 6]).collect();
    let shell = Shell { bottom: lift(-4.), top: lift(4.), middle: middle.clone(), faces: faces.clone() };
    let same = TriMesh { vertices: middle.clone(), faces: faces.clone() };
    let case = Case { shell, mesh: same, order: (0..7).collect() };
    compare(&case).unwrap();
    let outcome = certified(&case, true).unwrap().unwrap();
    assert!(holds(&outcome, Claim::Section), "the middle surface is a section of itself, wound or not");
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(&case));
    assert_eq!((answer.exit, answer.code), (0, ""), "{}", answer.message);
    // Vertex 7 is above the centre: the triangle 0 1 7 stands on edge.
    let mut mesh = TriMesh { vertices: middle, faces };
    mesh.vertices.push([0., 0., 2.]);
    mesh.faces.extend([[1, 2, 7], [2, 0, 7]]);
    mesh.faces[0] = [0, 1, 7];
    let case = Case { mesh, ..case };
    compare(&case).unwrap();
    assert!(!holds(&certified(&case, true).unwrap().unwrap(), Claim::Section));
}

/// A pillar wound around twice: in the order that flips a boundary wall the proved lift fails, but one turn further
/// another lift does not. This was an internal contradiction; it is a named "no verdict".
#[test]
fn another_lift_in_another_order() {
    let recipe = Recipe {
        shape: 12,
        pinched: vec![],
        moves: vec![Move { at: 153, by: [0, 1, 0] }],
        edge: None,
        edits: vec![Edit { kind: 11, at: 106, pick: [188, 0, 0] }],
        order: 0,
    };
    let case = recipe.build();
    let answer = certify(&case.shell, Some(&case.mesh), &Options::default(), &Silent);
    assert!(matches!(answer, Err(CertifyError::SeveralLifts { .. })), "{answer:?}");
}

/// One prism with corner 0 pinched at the origin; the other corners of its bottom and the mesh are given.
fn pinched_prism(bottom: [[f64; 3]; 2], mesh: [[f64; 3]; 3]) -> Case {
    let o = [0.0; 3];
    let shell = Shell {
        bottom: vec![o, bottom[0], bottom[1]],
        middle: vec![o, [4., 0., 0.], [0., 4., 0.]],
        top: vec![o, [4., 0., 1.], [0., 4., 1.]],
        faces: vec![[0, 1, 2]],
    };
    let mesh = TriMesh { vertices: mesh.to_vec(), faces: vec![[0, 1, 2]] };
    Case { shell, mesh, order: vec![0, 1, 2] }
}

/// What C6 says of the bottom; both it and the definitions agree, and the checker accepts.
fn off_the_bottom(case: &Case) -> bool {
    compare(case).unwrap();
    let outcome = certified(case, false).unwrap().unwrap();
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(case));
    assert_eq!((answer.exit, answer.code), (0, ""), "{}\n{}", answer.message, outcome.certificate);
    outcome.certificate.contains("claim disjoint-bottom certified")
}

/// Flat bottoms at a pinched vertex: allowed is what is at its place, whatever corner is there, too. A review found that one
/// claim could be certified and refuted there.
#[test]
fn flat_bottoms_at_a_pinched_vertex() {
    let (o, back) = ([0.0; 3], [0., 4., -1.]);
    let through = [[8., -4., 0.], [-4., 8., 0.], [-4., -4., 0.]];
    // A second corner at the pinched vertex, which is a vertex of the mesh or within a triangle of it.
    assert!(off_the_bottom(&pinched_prism([o, back], [o, [4., 0., 4.], [0., 4., 4.]])));
    assert!(off_the_bottom(&pinched_prism([o, back], through)));
    assert!(!off_the_bottom(&pinched_prism([o, [0., 1., 0.]], through)));
    // The pinched vertex is the middle of an edge, and of what the mesh has of it: another point must be named.
    let edge = [[0., -4., 0.], [0., 4., 0.]];
    assert!(!off_the_bottom(&pinched_prism(edge, [[8., 0., 0.], [-8., 8., 0.], [-8., -8., 0.]])));
    // The mesh goes through that edge there, and only there: no planes say so, and no point says otherwise.
    let case = pinched_prism(edge, [[8., 0., -4.], [-8., 0., -4.], [0., 0., 8.]]);
    assert!(World::new(&case.shell, &case.mesh).cap_disjoint(0));
    let options = Options { claims: vec![Claim::Disjoint], ..Options::default() };
    let answer = certify(&case.shell, Some(&case.mesh), &options, &Silent);
    assert!(matches!(answer, Err(CertifyError::FlatAtPinch { triangle: 0, prism: 0 })), "{answer:?}");
}
