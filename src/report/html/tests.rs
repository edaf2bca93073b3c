use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::escape;
use super::frame::Frame;
use super::html;
use crate::audit::{AuditOptions, AuditReport, Subject, audit};
use crate::certify::Silent;
use crate::construct::{Sample, dent, sample};
use crate::mesh::TriMesh;
use crate::projection::{MeshPoint, Projection, Rat, SectionMap};
use crate::shell::{Shell, VertexOrder};

const HOSTILE: &str = "</script><script>alert(1)</script><!--\" onload='x' &lt;{{scene}}.off";

/// The report on a mesh and the middle surface in a shell, and the shell by its name there.
fn audited(made: &Sample, shell: &Shell, file: &str) -> (AuditReport, TriMesh, Vec<(String, Shell)>) {
    let middle = TriMesh { vertices: made.shell.middle.clone(), faces: made.shell.faces.clone() };
    let options = AuditOptions { only_given: true, ..AuditOptions::default() };
    let subjects =
        [("A", &made.mesh), ("B", &middle)].map(|(name, mesh)| Subject { name, file: file.to_owned(), mesh });
    let report = audit(&subjects, Some(shell), &options, &Silent).unwrap().report;
    let name = report.attempts[0].shell.clone().unwrap_or_default();
    (report, middle, vec![(name, shell.clone())])
}

fn scene(page: &str) -> serde_json::Value {
    let (_, rest) = page.split_once("<script type=\"application/json\" id=\"scene\">").unwrap();
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

fn floats(value: &serde_json::Value) -> Vec<f32> {
    let bytes = STANDARD.decode(value.as_str().unwrap()).unwrap();
    bytes.chunks_exact(4).map(|c| f32::from_le_bytes(c.try_into().unwrap())).collect()
}

#[test]
fn no_text_from_outside_becomes_markup() {
    let made = sample(1);
    let (mut report, middle, shells) = audited(&made, &made.shell, HOSTILE);
    report.attempts[0].text = HOSTILE.to_owned();
    report.attempts[0].witnesses = vec![HOSTILE.to_owned()];
    report.inputs[0].remarks = vec![HOSTILE.to_owned()];
    report.documents[0].arguments.push(HOSTILE.to_owned());
    let page = html(&report, [&made.mesh, &middle], &shells);
    assert_eq!(page.matches("<script").count(), 2);
    assert_eq!(page.matches("</script").count(), 2);
    assert_eq!(page.matches("<!").count(), 1, "the doctype alone");
    assert!(page.contains("&lt;/script&gt;&lt;script&gt;alert(1)"));
    assert!(page.contains("{{scene}}.off"), "what is put in is not a template");
    assert_eq!(scene(&page)["layers"][0]["title"], format!("try 1: {HOSTILE}"));
    assert_eq!(escape::text("a\u{0}\n&"), "a\u{fffd}\u{fffd}&amp;");
}

#[test]
fn the_certified_map_carries_vertices_to_the_exact_middle_points() {
    let made = sample(1);
    let (report, middle, shells) = audited(&made, &made.shell, "a.off");
    let page = scene(&html(&report, [&made.mesh, &middle], &shells));
    assert_eq!(page["certified"], true);
    let frame = Frame::new(made.shell.bottom.iter().chain(&made.shell.top).chain(&made.mesh.vertices));
    let projection = Projection::new(&made.shell, &VertexOrder::Id).unwrap();
    let exact = SectionMap::new(&projection, &made.mesh).unwrap();
    let carried = floats(&page["layers"][0]["carried"][0]);
    assert_eq!(carried.len(), 3 * made.mesh.vertices.len());
    for (face, corners) in (0..).zip(&made.mesh.faces) {
        let point = MeshPoint { face, weights: [Rat::ONE, Rat::ZERO, Rat::ZERO] };
        let at = exact.to_middle(&point).unwrap();
        let p = projection.unproject(&at).unwrap().map(|x| x.to_f64().value());
        let v = 3 * corners[0] as usize;
        for (found, wanted) in carried[v..v + 3].iter().zip(frame.view(&p)) {
            // The middle point is rounded before it is a float.
            assert!((found - wanted).abs() < 1e-6, "vertex {}: {found} {wanted}", corners[0]);
        }
    }
}

#[test]
fn violations_keep_their_exact_texts() {
    let made = sample(1);
    let mut moved = made.mesh.clone();
    moved.vertices.iter_mut().for_each(|p| p[0] *= 3.0);
    let stretched = Sample { mesh: moved, ..sample(1) };
    let (report, middle, shells) = audited(&stretched, &made.shell, "a.off");
    let survey = &report.attempts[0].surveys[0];
    assert!(!survey.violations.is_empty());
    let text = html(&report, [&stretched.mesh, &middle], &shells);
    for (i, violation) in survey.violations.iter().enumerate() {
        assert!(text.contains(&format!("\"{i}\":{}", escape::json(violation))), "{i}");
    }
    let page = scene(&text);
    let found = &page["layers"][0]["findings"];
    assert_eq!(found["count"], survey.violations.len());
    let sizes: Vec<u64> =
        found["regions"].as_array().unwrap().iter().map(|r| r["violations"].as_u64().unwrap()).collect();
    assert!(sizes.is_sorted_by(|a, b| a >= b) && sizes.len() == survey.regions.len());
    // A shell without positive tets has no projection, and a page all the same.
    let (report, middle, shells) = audited(&made, &dent(&made.shell, 7), "a.off");
    let page = scene(&html(&report, [&made.mesh, &middle], &shells));
    assert!(page["layers"][0]["carried"].is_null());
}

#[test]
fn any_coordinates_fit_the_view() {
    let boxes: [[[f64; 3]; 2]; 5] = [
        [[-f64::MAX, 0.0, 0.0], [f64::MAX, 1.0, 1.0]],
        [[1e100, 1e100, 1e100], [2e100, 3e100, 1e100]],
        [[5e-324, 0.0, 0.0], [1.5e-323, 0.0, 0.0]],
        [[1e9, 1e9, 1e9], [1e9 + 1e-6, 1e9, 1e9]],
        [[7.0; 3]; 2],
    ];
    for points in boxes {
        let frame = Frame::new(points.iter());
        let [low, high] = points.map(|p| frame.view(&p));
        assert!(low.iter().chain(&high).all(|x| x.abs() <= 1.0), "{points:?}: {low:?} {high:?}");
        let extent = (0..3).map(|i| high[i] - low[i]).fold(0.0, f32::max);
        let one = points[0].map(f64::to_bits) == points[1].map(f64::to_bits);
        assert!(one || extent > 0.9, "{points:?}: {extent}");
    }
    let view = Frame::new([].iter()).view(&[f64::NAN, 1.0, 2.0]);
    assert_eq!(view.map(f32::to_bits), [0.0_f32, 1.0, 2.0].map(f32::to_bits));
}
