//! What the view shows, as JSON.

use serde::Serialize;

use super::carried::middle_points;
use super::findings::{self, Findings};
use super::frame::{Frame, integers};
use crate::audit::report::{AttemptReport, AttemptResult};
use crate::audit::{AuditReport, AuditVerdict};
use crate::mesh::TriMesh;
use crate::shell::Shell;

/// The scene.
#[derive(Debug, Serialize)]
pub(super) struct Scene<'a> {
    frame: Frame,
    kinds: Vec<&'static str>,
    certified: bool,
    meshes: Vec<Mesh>,
    /// The inputs, where they intersect themselves, then every try that has a shell.
    layers: Vec<Layer<'a>>,
}

#[derive(Debug, Serialize)]
struct Mesh {
    name: &'static str,
    points: String,
    faces: String,
}

#[derive(Debug, Serialize)]
struct Layer<'a> {
    title: String,
    shell: Option<Layers>,
    /// Of a certified try: the vertices of A and of B on the middle surface.
    carried: Option<[String; 2]>,
    findings: Findings<'a>,
}

/// The three surfaces of a shell.
#[derive(Debug, Serialize)]
struct Layers {
    bottom: String,
    middle: String,
    top: String,
    faces: String,
}

impl<'a> Scene<'a> {
    pub(super) fn new(report: &'a AuditReport, meshes: [&TriMesh; 2], shells: &[(String, Shell)]) -> Self {
        let of_shells = shells.iter().flat_map(|(_, s)| s.bottom.iter().chain(&s.top));
        let frame = Frame::new(meshes.iter().flat_map(|m| &m.vertices).chain(of_shells));
        let mesh = |(name, mesh): (&'static str, &TriMesh)| Mesh {
            name,
            points: frame.pack(mesh.vertices.iter()),
            faces: integers(mesh.faces.iter().flatten().copied()),
        };
        let mut layers = Vec::new();
        if report.inputs.iter().any(|i| !i.self_intersections.is_empty()) || report.attempts.is_empty() {
            let findings = findings::of_inputs(report, &frame);
            layers.push(Layer { title: "the inputs".to_owned(), shell: None, carried: None, findings });
        }
        let of_tries = report.attempts.iter().enumerate();
        layers.extend(of_tries.map(|(i, attempt)| layer(i + 1, attempt, meshes, shells, &frame)));
        Self {
            frame,
            kinds: findings::kinds(),
            certified: report.verdict == AuditVerdict::Bijective,
            meshes: ["A", "B"].into_iter().zip(meshes).map(mesh).collect(),
            layers,
        }
    }
}

fn layer<'a>(
    number: usize,
    attempt: &'a AttemptReport,
    meshes: [&TriMesh; 2],
    shells: &[(String, Shell)],
    frame: &Frame,
) -> Layer<'a> {
    let shell = shells.iter().find(|(name, _)| Some(name) == attempt.shell.as_ref()).map(|(_, s)| s);
    let certified = attempt.result == AttemptResult::Certified;
    let carried = shell.filter(|_| certified).and_then(|s| middle_points(s, meshes));
    Layer {
        title: format!("try {number}: {}", attempt.text),
        shell: shell.map(|s| Layers {
            bottom: frame.pack(s.bottom.iter()),
            middle: frame.pack(s.middle.iter()),
            top: frame.pack(s.top.iter()),
            faces: integers(s.faces.iter().flatten().copied()),
        }),
        carried: carried.map(|points| points.map(|p| frame.pack(p.iter()))),
        findings: findings::of_attempt(attempt, meshes, frame),
    }
}
