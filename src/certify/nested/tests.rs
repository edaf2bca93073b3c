//! Small nested and not nested pairs; every document is judged by the independent checker.

use super::*;
use crate::certify::{Silent, Verdict};
use crate::construct::icosphere;
use crate::mesh::{Connectivity, Format, TriMesh, encode};
use crate::testing::{joined, torus};

fn ball(radius: f64, centre: [f64; 3], flipped: bool) -> TriMesh {
    let mut mesh = icosphere(1);
    for p in &mut mesh.vertices {
        *p = std::array::from_fn(|i| p[i] * radius + centre[i]);
    }
    if flipped {
        mesh.faces.iter_mut().for_each(|f| f.swap(1, 2));
    }
    mesh
}

fn judged(a: &TriMesh, b: &TriMesh, text: &str) -> &'static str {
    let bytes = [a, b].map(|m| encode(m, Format::Off, "m").unwrap());
    let answer = homeo_certs::check(text.as_bytes(), &bytes);
    assert_eq!((answer.status, answer.code), ("valid", ""), "{}\n{text}", answer.message);
    answer.status
}

fn verdict(a: &TriMesh, b: &TriMesh) -> NestedOutcome {
    let out = nested(a, b, &Silent).unwrap();
    judged(a, b, &out.certificate);
    out
}

const O: [f64; 3] = [0.0; 3];

#[test]
fn a_ball_in_a_larger_ball_is_nested() {
    let out = verdict(&ball(1.0, O, false), &ball(1.5, O, false));
    assert_eq!(out.verdict, Verdict::Certified);
    assert_eq!(out.rays.iter().map(|r| r.number).collect::<Vec<_>>(), [1, 0]);
}

#[test]
fn the_wrong_way_round_and_inside_out_are_not() {
    let (small, large) = (ball(1.0, O, false), ball(1.5, O, false));
    let out = verdict(&large, &small);
    assert_eq!(out.verdict, Verdict::Refuted);
    assert!(matches!(&out.reasons[0], Reason::Winding(r) if r.whose == Whose::A && r.number == 0));
    let out = verdict(&small, &ball(1.5, O, true));
    assert!(matches!(&out.reasons[0], Reason::Winding(r) if r.number == -1));
}

#[test]
fn a_component_outside_is_found() {
    let two = joined(&ball(1.0, O, false), &ball(1.0, [8.0, 0.5, 0.25], false));
    let out = verdict(&two, &ball(2.0, O, false));
    assert_eq!(out.verdict, Verdict::Refuted);
    let second = two.vertices.len() as u32 / 2;
    assert!(matches!(&out.reasons[..], [Reason::Winding(r)] if r.number == 0 && r.vertex >= second));
}

#[test]
fn surfaces_that_cross_or_touch_are_not_nested() {
    let out = verdict(&ball(1.0, O, false), &ball(1.0, [0.5, 0.0, 0.0], false));
    assert!(matches!(out.reasons[0], Reason::Meeting(_)));
    // The same surface: every triangle lies in one of the other.
    let out = verdict(&ball(1.0, O, false), &ball(1.0, O, false));
    assert!(matches!(out.reasons[0], Reason::Meeting(_)));
}

#[test]
fn open_and_defective_surfaces_are_refused_with_a_witness() {
    let (small, mut large) = (ball(1.0, O, false), ball(1.5, O, false));
    large.faces.pop();
    assert!(matches!(verdict(&small, &large).reasons[0], Reason::Open(crate::certify::pl::Input::B, _)));
    large.faces.push([0, 1, 1]);
    assert!(matches!(verdict(&small, &large).reasons[0], Reason::Defect(..)));
}

fn facts(mesh: &TriMesh) -> Vec<ComponentFacts> {
    component_facts(mesh, &Connectivity::new(mesh.vertices.len(), &mesh.faces).unwrap())
}

#[test]
fn components_are_told_apart_by_euler_characteristic_and_loops() {
    let (mut sphere, ring) = (ball(1.0, O, false), torus(6));
    let fact = |e, b| ComponentFacts { euler_characteristic: e, boundary_loops: b };
    assert_eq!(facts(&joined(&sphere, &ring)), [fact(2, 0), fact(0, 0)]);
    assert_eq!(facts(&ring)[0].genus(), 1);
    let (verdict, text) = same_topology(&sphere, &ring, [&facts(&sphere), &facts(&ring)]);
    assert_eq!(verdict, Verdict::Refuted);
    judged(&sphere, &ring, &text);
    let (verdict, text) = same_topology(&sphere, &sphere, [&facts(&sphere), &facts(&sphere)]);
    assert_eq!(verdict, Verdict::Certified);
    judged(&sphere, &sphere, &text);
    sphere.faces.pop();
    assert_eq!(facts(&sphere), [fact(1, 1)]);
}

#[test]
fn a_cage_with_a_handle_that_the_mesh_lacks_fails_the_topological_condition() {
    // A ball inside the tube of a torus is nested in it, but the torus has a handle.
    let (small, ring) = (ball(0.25, [3.0, 0.0, 0.0], false), torus(12));
    assert_eq!(verdict(&small, &ring).verdict, Verdict::Certified);
    let text = nested_topology(&small, &ring, [&facts(&small), &facts(&ring)]).unwrap();
    judged(&small, &ring, &text);
    assert!(nested_topology(&ring, &small, [&facts(&ring), &facts(&small)]).is_none());
}

#[test]
fn manifold_is_decided_with_a_witness() {
    let mut mesh = ball(1.0, O, false);
    let check = |mesh: &TriMesh, found: bool| {
        let (witness, text) = manifold(mesh).unwrap();
        assert_eq!(witness.is_some(), found);
        let answer = homeo_certs::check(text.as_bytes(), &[encode(mesh, Format::Off, "m").unwrap()]);
        assert_eq!(answer.status, "valid", "{} {}\n{text}", answer.code, answer.message);
    };
    check(&mesh, false);
    mesh.vertices.push([9.0, 9.0, 9.0]);
    let v = mesh.vertices.len() as u32 - 1;
    let [a, b, _] = mesh.faces[0];
    mesh.faces.push([a, b, v]);
    check(&mesh, true);
}
