//! Small pairs with known answers. Every document is accepted by the independent checker before `audit` returns; what is
//! tested here is that the answer is the right one, and that the violations hold by definition.

use super::report::{AttemptResult, SurveyReport, ViolationKind};
use super::*;
use crate::certify::Silent;
use crate::construct::icosphere;
use crate::mesh::TriMesh;
use crate::shell::Shell;
use crate::testing::torus;

fn subject<'a>(name: &'static str, mesh: &'a TriMesh) -> Subject<'a> {
    Subject { name, file: format!("{name}.off"), mesh }
}

fn run(a: &TriMesh, b: &TriMesh, shell: Option<&Shell>) -> Audit {
    let options = AuditOptions {
        tries: vec![Try::A, Try::JointA],
        only_given: shell.is_some(),
        ..AuditOptions::default()
    };
    audit(&[subject("A", a), subject("B", b)], shell, &options, &Silent).unwrap()
}

/// A shell of pillars around a mesh that point away from the origin, bottom and top at these multiples of it.
fn away(middle: TriMesh, [bottom, top]: [f64; 2]) -> Shell {
    let layer = |s: f64| middle.vertices.iter().map(|p| p.map(|x| x * s)).collect();
    Shell { bottom: layer(bottom), top: layer(top), middle: middle.vertices, faces: middle.faces }
}

fn radial(level: u32) -> Shell {
    away(icosphere(level), [0.8, 1.25])
}

/// Distances from it along the axes are exact in doubles.
fn octahedron() -> TriMesh {
    let axis =
        |i: usize| std::array::from_fn(|k| if k == i % 3 { if i < 3 { 1.0 } else { -1.0 } } else { 0.0 });
    let faces = vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    TriMesh { vertices: (0..6).map(axis).collect(), faces }
}

fn survey(audit: &Audit) -> &SurveyReport {
    audit.report.attempts.first().and_then(|a| a.surveys.first()).unwrap()
}

fn kinds(survey: &SurveyReport) -> Vec<ViolationKind> {
    let mut out: Vec<ViolationKind> = survey.regions.iter().map(|r| r.kind).collect();
    out.dedup();
    out
}

#[test]
fn a_finer_and_a_coarser_sphere_are_bijective() {
    let (coarse, fine) = (icosphere(1), icosphere(2));
    for (a, b) in [(&coarse, &fine), (&fine, &coarse)] {
        let out = run(a, b, None);
        assert_eq!(out.report.verdict, AuditVerdict::Bijective, "{}", words(&out.report));
        let files: Vec<&str> = out.documents.iter().map(|d| d.file.as_str()).collect();
        assert_eq!(files[..3], ["a.off", "b.off", "same-topology.cert"]);
        assert_eq!(files[files.len() - 3..], ["shell.h5", "a.cert", "b.cert"]);
    }
}

#[test]
fn compose_refuses_other_shells_orders_and_refutations() {
    let out = run(&icosphere(1), &icosphere(2), None);
    let bytes = |name: &str| &out.documents.iter().find(|d| d.file == name).unwrap().bytes[..];
    let (shell, meshes) = (bytes("shell.h5"), [bytes("a.off"), bytes("b.off")]);
    let (a, b) = (bytes("a.cert"), bytes("b.cert"));
    let code = |certs, shell: &[u8], meshes| homeo_certs::compose(certs, shell, meshes).code;
    assert_eq!(homeo_certs::compose([a, b], shell, meshes).status, "valid");
    assert_eq!(code([b, a], shell, meshes), "hash");
    assert_eq!(code([a, b], shell, [meshes[1], meshes[0]]), "hash");
    // Another shell of which both are sections: its certificate is valid by itself.
    let other = run(&icosphere(1), &icosphere(2), Some(&radial(1)));
    let find = |name: &str| &other.documents.iter().find(|d| d.file == name).unwrap().bytes[..];
    assert_eq!(code([a, find("b.cert")], shell, meshes), "hash");
    // Another order on the same shell.
    let in_memory = radial(1);
    let n = in_memory.middle.len() as u32;
    let options = crate::certify::Options {
        claims: vec![crate::certify::Claim::Bijection],
        order: crate::certify::VertexOrder::List((0..n).rev().collect()),
    };
    let turned = crate::certify::certify(&in_memory, Some(&icosphere(2)), &options, &Silent).unwrap();
    assert!(turned.all_certified());
    assert_eq!(code([find("a.cert"), turned.certificate.as_bytes()], find("shell.h5"), meshes), "orders");
    assert_eq!(code([find("a.cert"), b"homeo-meshes 1\nend\n"], find("shell.h5"), meshes), "magic");
}

#[test]
fn a_sphere_and_a_torus_are_not_homeomorphic() {
    let out = run(&icosphere(1), &torus(8), None);
    assert_eq!(out.report.verdict, AuditVerdict::NotHomeomorphic);
    assert!(out.report.attempts.is_empty());
    assert!(out.documents.iter().any(|d| d.file == "same-topology.cert"));
    let open = {
        let mut mesh = icosphere(1);
        mesh.faces.pop();
        mesh
    };
    assert_eq!(run(&icosphere(1), &open, None).report.verdict, AuditVerdict::NotHomeomorphic);
}

#[test]
fn a_vertex_pulled_through_is_not_certified_and_the_fold_is_shown() {
    let mut folded = icosphere(2);
    // Pulled up and sideways beyond a neighbour: it overhangs, within the shell and without intersections.
    let moved =
        folded.faces.iter().find(|f| f.contains(&100)).map(|f| *f.iter().find(|v| **v != 100).unwrap());
    let to = folded.vertices[moved.unwrap() as usize];
    let from = folded.vertices[100];
    let beyond: [f64; 3] = std::array::from_fn(|i| to[i] + 0.6 * (to[i] - from[i]));
    let radius = beyond.iter().map(|x| x * x).sum::<f64>().sqrt();
    folded.vertices[100] = beyond.map(|x| 1.2 * x / radius);
    let out = run(&icosphere(2), &folded, Some(&radial(2)));
    assert_eq!(out.report.verdict, AuditVerdict::NotCertified, "{}", words(&out.report));
    assert_eq!(out.report.attempts[0].sections, [Some(true), Some(false)]);
    let found = survey(&out);
    let near: Vec<u32> =
        (0..folded.faces.len() as u32).filter(|&f| folded.faces[f as usize].contains(&100)).collect();
    assert!(kinds(found).contains(&ViolationKind::Fold), "{}", words(&out.report));
    assert!(kinds(found).contains(&ViolationKind::CoveredTwice));
    assert!(!kinds(found).contains(&ViolationKind::NotCovered));
    for v in found.violations.iter().filter(|v| v.kind == ViolationKind::Fold) {
        assert!(near.contains(&v.triangle.unwrap()));
        assert!(v.value.as_ref().unwrap().1.unwrap() <= 0.0);
    }
    let folds: usize = found.regions.iter().filter(|r| r.kind == ViolationKind::Fold).count();
    assert_eq!(folds, 1);
}

#[test]
fn a_sphere_outside_covers_nothing_and_is_as_far_away_as_it_is() {
    let mut large = octahedron();
    large.vertices.iter_mut().for_each(|p| *p = p.map(|x| 4.0 * x));
    let out = run(&octahedron(), &large, Some(&away(octahedron(), [0.75, 1.25])));
    let found = survey(&out);
    assert_eq!(kinds(found), [ViolationKind::Outside, ViolationKind::NotCovered]);
    // All triangles, wholly; all prisms, wholly; each kind in one piece.
    assert_eq!(found.regions.len(), 2);
    assert_eq!((found.regions[0].triangles.len(), found.regions[1].prisms.len()), (8, 8));
    assert!(found.violations.iter().all(|v| v.share == Some(1.0)));
    assert_eq!(found.largest_distance_outside.map(f64::to_bits), Some((4.0_f64 - 1.25).to_bits()));
    assert_eq!((found.clean_triangles, found.clean_area_share.to_bits()), (0, 0));
}

#[test]
fn the_part_outside_is_exact() {
    // One spike: its tip is outside, so a share of each triangle at it.
    let mut spike = octahedron();
    spike.vertices[0] = spike.vertices[0].map(|x| 2.0 * x);
    let out = run(&octahedron(), &spike, Some(&away(octahedron(), [0.75, 1.25])));
    let found = survey(&out);
    let outside: Vec<_> = found.violations.iter().filter(|v| v.kind == ViolationKind::Outside).collect();
    assert_eq!(outside.len(), 4);
    for v in outside {
        assert!(v.share.unwrap() > 0.0 && v.share.unwrap() < 1.0);
        // The witness is a point of no tet: beyond the top, whose coordinates have absolute sum 5/4.
        let sum: f64 = v.point.approximate.iter().map(|x| x.abs()).sum();
        assert!(sum > 1.25, "{sum}");
    }
    assert_eq!(found.largest_distance_outside.map(f64::to_bits), Some(0.75_f64.to_bits()));
}

#[test]
fn an_inside_out_sphere_is_one_fold() {
    let mut flipped = icosphere(1);
    flipped.faces.iter_mut().for_each(|f| f.swap(1, 2));
    let out = run(&icosphere(1), &flipped, Some(&radial(1)));
    assert_eq!(kinds(survey(&out)), [ViolationKind::Fold, ViolationKind::NotCovered]);
    assert_eq!(survey(&out).regions.len(), 2);
    assert_eq!(survey(&out).regions[0].triangles.len(), 80);
}

#[test]
fn defects_are_listed_and_self_intersections_too() {
    let mut fin = icosphere(1);
    let v = fin.vertices.len() as u32;
    fin.vertices.push([3.0, 3.0, 3.0]);
    let [a, b, _] = fin.faces[0];
    fin.faces.push([a, b, v]);
    let out = run(&icosphere(1), &fin, None);
    assert_eq!(out.report.verdict, AuditVerdict::InvalidInput);
    assert!(out.report.inputs[0].valid && !out.report.inputs[1].valid);
    assert!(out.report.inputs[1].defects.iter().any(|d| d.kind == "non-manifold-edge"));
    assert!(out.documents.iter().any(|d| d.file == "b.manifold.cert"));
    let mut crossing = icosphere(1);
    crossing.vertices[0] = crossing.vertices[0].map(|x| -2.0 * x);
    let out = run(&crossing, &icosphere(1), None);
    assert_eq!(out.report.verdict, AuditVerdict::InvalidInput);
    assert!(!out.report.inputs[0].self_intersections.is_empty());
    assert!(out.documents.iter().any(|d| d.file == "a.embedded.cert"));
    let empty = TriMesh::default();
    assert_eq!(run(&empty, &empty, None).report.verdict, AuditVerdict::InvalidInput);
}

#[test]
fn reports_survive_json_and_are_well_formed() {
    let mut large = icosphere(0);
    large.vertices.iter_mut().for_each(|p| *p = p.map(|x| 4.0 * x));
    let report = run(&icosphere(0), &large, Some(&radial(0))).report;
    let text = serde_json::to_string(&report).unwrap();
    let back: AuditReport = serde_json::from_str(&text).unwrap();
    assert_eq!(serde_json::to_string(&back).unwrap(), text);
    let points = survey_points(&report);
    assert!(vtu::vtu(&report).contains(&format!("NumberOfPoints=\"{points}\"")));
    let junit = junit::junit(&report);
    assert!(junit.contains("tests=\"4\" failures=\"1\""), "{junit}");
}

fn survey_points(report: &AuditReport) -> usize {
    let surveys = report.attempts.iter().flat_map(|a| &a.surveys);
    surveys.flat_map(|s| &s.violations).map(|v| 1 + usize::from(v.other.is_some())).sum()
}

#[test]
fn a_shell_that_is_none_is_a_try_without_verdict() {
    let out = run(&icosphere(0), &icosphere(1), Some(&Shell::default()));
    assert_eq!(out.report.verdict, AuditVerdict::NotCertified);
    assert_eq!(out.report.attempts[0].result, AttemptResult::NoShell);
}

/// The survey knows nothing of the certifier's lift: both must agree on whether a mesh is a section.
#[test]
fn there_are_violations_just_where_the_certifier_refutes() {
    use crate::certify::{Claim, Options, certify};
    use crate::mesh::Connectivity;
    let shell = radial(1);
    let mut verdicts = [0, 0];
    for seed in 0..24_u64 {
        let mut mesh = icosphere(1);
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state % 2001) as f64 / 1000.0 - 1.0
        };
        let size = 0.04 + 0.03 * (seed % 12) as f64;
        for p in &mut mesh.vertices {
            *p = p.map(|x| x + size * random());
        }
        let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces).unwrap();
        let found = places::places(&subject("B", &mesh), &connectivity, &shell, &Silent).unwrap().unwrap();
        let options = Options { claims: vec![Claim::Bijection], ..Options::default() };
        let certified = certify(&shell, Some(&mesh), &options, &Silent).unwrap().all_certified();
        assert_eq!(found.violations.is_empty(), certified, "seed {seed}");
        verdicts[usize::from(certified)] += 1;
        for v in &found.violations {
            assert_eq!(v.triangle.is_none(), v.kind == ViolationKind::NotCovered);
        }
        let in_regions: usize = found.regions.iter().map(|r| r.violations.len()).sum();
        assert_eq!(in_regions, found.violations.len());
    }
    assert!(verdicts.iter().all(|n| *n > 3), "{verdicts:?}");
}

/// Powers of two change no verdict, no weight and no share; squares of these coordinates overflow and vanish.
#[test]
fn numbers_for_people_do_not_depend_on_the_scale() {
    let survey = |exponent: i32| {
        let scale = 2.0_f64.powi(exponent);
        let scaled = |points: &mut Vec<[f64; 3]>| points.iter_mut().for_each(|p| *p = p.map(|x| x * scale));
        let (mut shell, mut a, mut b) = (radial(1), icosphere(1), icosphere(1));
        b.vertices[0] = b.vertices[0].map(|x| 4.0 * x);
        [&mut shell.bottom, &mut shell.middle, &mut shell.top, &mut a.vertices, &mut b.vertices]
            .into_iter()
            .for_each(scaled);
        let report = run(&a, &b, Some(&shell)).report;
        let found = report.attempts[0].surveys[0].clone();
        let far = found.largest_distance_outside.unwrap() / scale;
        (found.clean_area_share, found.clean_triangles, far, found.largest_distance_share.unwrap())
    };
    let (share, clean, far, relative) = survey(0);
    assert!(share > 0.1 && clean > 40 && far > 1.0 && relative > 0.1, "{share} {clean} {far} {relative}");
    assert_eq!(survey(600), (share, clean, far, relative));
    assert_eq!(survey(-600), (share, clean, far, relative));
}

#[test]
fn a_surface_turned_inside_out_gets_a_hint() {
    // One try is enough: the hint comes from the meshes.
    let options = AuditOptions { tries: vec![Try::A], ..AuditOptions::default() };
    let summary = |a: &TriMesh, b: &TriMesh| {
        let out = audit(&[subject("a", a), subject("b", b)], None, &options, &Silent).unwrap();
        assert_eq!(out.report.verdict, AuditVerdict::NotCertified);
        out.report.summary
    };
    let mesh = icosphere(1);
    let mut reversed = mesh.clone();
    reversed.faces.iter_mut().for_each(|f| f.reverse());
    assert!(summary(&mesh, &reversed).contains("oriented the other way round"));
    // Elsewhere and not closed: no reason to think so.
    let mut far = mesh.clone();
    far.vertices.iter_mut().for_each(|p| p[0] += 10.0);
    let open = |mesh: &TriMesh| TriMesh { vertices: mesh.vertices.clone(), faces: mesh.faces[1..].to_vec() };
    for (a, b) in [(&mesh, &far), (&open(&mesh), &open(&reversed))] {
        assert!(!summary(a, b).contains("oriented"));
    }
}

#[test]
fn the_usual_tries_start_with_fewer_triangles() {
    let place = |tries: &[Try], which: Try| tries.iter().position(|t| *t == which).unwrap();
    for (a, b, first, second) in [(9, 8, Try::JointB, Try::JointA), (8, 8, Try::JointA, Try::JointB)] {
        let tries = Try::usual(a, b);
        assert!(Try::ALL.iter().all(|t| tries.contains(t)));
        assert!(place(&tries, first) < place(&tries, second));
    }
    // What was asked for stays as it is, and the report says what was tried.
    let some = AuditOptions { tries: vec![Try::JointB, Try::A], ..AuditOptions::default() };
    assert_eq!(some.for_pair([8, 9]).tries, some.tries);
    assert_eq!(AuditOptions::default().for_pair([9, 8]).tries, Try::usual(9, 8));
    assert!(AuditOptions { only_given: true, ..some }.for_pair([9, 8]).tries.is_empty());
}
