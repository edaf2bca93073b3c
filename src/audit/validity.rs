//! Stage (a): is an input an embedded oriented manifold of triangles with area? Every defect.

use super::error::AuditError;
use super::point::ExactPoint;
use super::report::{CrossingReport, DefectReport, InputReport};
use super::run::Subject;
use crate::certify::disjoint::self_crossings;
use crate::certify::{CertifyError, Crossing, Observer};
use crate::mesh::{self, Connectivity, Defect, TriMesh};

/// Everything that is wrong with an input. Self-intersections are looked for where triangles have area and indices are in
/// range; connectivity is given for valid inputs.
pub(crate) struct Validity {
    pub(crate) report: InputReport,
    pub(crate) connectivity: Option<Connectivity>,
}

/// Defects of one input. O((n + k) log n) for k pairs of triangles whose boxes meet.
pub(crate) fn validity(subject: &Subject<'_>, observer: &dyn Observer) -> Result<Validity, AuditError> {
    observer.stage("input", None);
    let mesh = subject.mesh;
    let failed = |source| AuditError::Mesh { name: subject.name, source: Box::new(source) };
    let found = mesh::validate_listing(mesh, usize::MAX).map_err(failed)?;
    let defects: Vec<&Defect> = found.listed.iter().filter(|d| !d.kind().is_allowed()).collect();
    // What keeps the pair tests from having a meaning.
    let unfit = |d: &&Defect| {
        matches!(
            d,
            Defect::NoFaces
                | Defect::IndexOutOfRange { .. }
                | Defect::NotFinite { .. }
                | Defect::RepeatedCorner { .. }
                | Defect::ZeroArea { .. }
        )
    };
    let crossings = if defects.iter().any(unfit) { Vec::new() } else { crossings(subject, observer)? };
    let allowed = found.info.defects.iter().filter(|(kind, _)| kind.is_allowed());
    let report = InputReport {
        name: subject.name.to_owned(),
        file: subject.file.clone(),
        vertices: mesh.vertices.len(),
        triangles: mesh.faces.len(),
        valid: defects.is_empty() && crossings.is_empty(),
        defects: defects.iter().map(|d| DefectReport { kind: kind_word(d), text: d.to_string() }).collect(),
        self_intersections: crossings,
        remarks: allowed.map(|(kind, n)| format!("{n} {kind}")).collect(),
    };
    let connectivity = match report.valid {
        true => Some(Connectivity::new(mesh.vertices.len(), &mesh.faces).map_err(failed)?),
        false => None,
    };
    Ok(Validity { report, connectivity })
}

/// The word for the kind of defect in JSON.
fn kind_word(defect: &Defect) -> String {
    serde_json::to_value(defect.kind())
        .ok()
        .and_then(|v| v.as_str().map(ToOwned::to_owned))
        .unwrap_or_default()
}

/// All self-intersections.
fn crossings(subject: &Subject<'_>, observer: &dyn Observer) -> Result<Vec<CrossingReport>, AuditError> {
    let mesh = subject.mesh;
    let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces)
        .map_err(|source| AuditError::Mesh { name: subject.name, source: Box::new(source) })?;
    observer.stage("self-intersections", Some(mesh.faces.len() as u64));
    let found = self_crossings(mesh, &connectivity, observer)?;
    let report = |c| {
        let lost = CertifyError::Internal { what: "a crossing without a point" };
        crossing_report(mesh, c).ok_or_else(|| lost.into())
    };
    found.iter().map(report).collect()
}

fn crossing_report(mesh: &TriMesh, crossing: &Crossing) -> Option<CrossingReport> {
    let face = mesh.faces.get(crossing.first as usize)?;
    let corners = face.map(|v| &mesh.vertices[v as usize]);
    let point = ExactPoint::from_integers(&crossing.in_first, corners)?;
    Some(CrossingReport { triangles: [crossing.first, crossing.second], point })
}
