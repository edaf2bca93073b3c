//! Stage (d): every place where a mesh is no section of a shell, with exact points.

use std::collections::HashSet;

use dashu_ratio::RBig;

use super::distance::{Caps, unit};
use super::error::AuditError;
use super::point::{ExactPoint, coordinates, rounded, rounded_dyadic};
use super::regions::regions;
use super::report::{SurveyReport, Violation, ViolationKind};
use super::run::Subject;
use crate::certify::complex::{Boundary, MeshView, TetComplex};
use crate::certify::coverage::{Coverage, Twice, Uncovered, coverage};
use crate::certify::exact::normalised;
use crate::certify::lift::Lifting;
use crate::certify::survey::{Failure, Outside, survey};
use crate::certify::write::{names, value};
use crate::certify::{Ending, Observer, VertexOrder};
use crate::mesh::Connectivity;
use crate::predicate::StageCounts;
use crate::shell::Shell;

/// Surveys a valid mesh in a valid shell; `None` where a tet of the order is not positive, so that there is nothing to
/// compare with.
pub(crate) fn places(
    subject: &Subject<'_>,
    connectivity: &Connectivity,
    shell: &Shell,
    observer: &dyn Observer,
) -> Result<Option<SurveyReport>, AuditError> {
    let failed = |source| AuditError::Mesh { name: "shell", source: Box::new(source) };
    let middle = Connectivity::new(shell.middle.len(), &shell.faces).map_err(failed)?;
    let (edge, wall) = (Boundary::new(connectivity), Boundary::new(&middle));
    let mesh = MeshView {
        vertices: &subject.mesh.vertices,
        faces: &subject.mesh.faces,
        connectivity,
        boundary: &edge,
    };
    let complex = TetComplex::new(shell, &middle, &wall, &VertexOrder::Id.ranks(shell.middle.len()));
    if complex.first_not_positive(&mut StageCounts::default()).is_some() {
        return Ok(None);
    }
    let cx = Lifting { mesh: &mesh, complex: &complex };
    let found = survey(cx, observer)?;
    let covered = coverage(cx, &found, observer)?;
    let far = farthest(&mesh, shell, &found.outside);
    let places = Places { cx };
    let mut violations = places.of_triangles(&found.outside, &found.failures);
    violations.extend(places.of_coverage(&covered));
    let regions = regions(&violations, connectivity, &middle);
    let marked: HashSet<u32> = violations
        .iter()
        .flat_map(|v| v.triangle.into_iter().chain(v.other.as_ref().map(|(f, _)| *f)))
        .collect();
    let (clean_area_share, clean_triangles) = clean(&mesh, &marked);
    Ok(Some(SurveyReport {
        mesh: subject.name.to_owned(),
        clean_area_share,
        clean_triangles,
        largest_distance_outside: far,
        largest_distance_share: far.map(|d| d / diagonal(mesh.vertices)).filter(|x| x.is_finite()),
        regions,
        violations,
    }))
}

struct Places<'a> {
    cx: Lifting<'a>,
}

impl Places<'_> {
    /// One violation of each kind a triangle.
    fn of_triangles(&self, outside: &[Outside], failures: &[Failure]) -> Vec<Violation> {
        let mut seen: HashSet<(u32, ViolationKind)> = HashSet::new();
        let mut out: Vec<Violation> = Vec::new();
        for place in outside {
            seen.insert((place.face, ViolationKind::Outside));
            out.push(self.outside(place));
        }
        for failure in failures {
            let violation = self.failure(failure);
            if seen.insert((failure.face, violation.kind)) {
                out.push(violation);
            }
        }
        out.sort_by_key(|v| (v.triangle, v.kind));
        out
    }

    fn outside(&self, place: &Outside) -> Violation {
        let share = rounded(&place.share);
        Violation {
            kind: ViolationKind::Outside,
            triangle: Some(place.face),
            prism: None,
            tet: None,
            point: ExactPoint::new(&place.weights, self.cx.mesh.points(place.face)),
            middle: None,
            other: None,
            value: None,
            share: Some(share),
            text: format!("{:.1} % of the triangle's area is in no tet, nor is the point", 100.0 * share),
        }
    }

    fn failure(&self, failure: &Failure) -> Violation {
        let tet = &self.cx.complex.tets[failure.tet as usize];
        let (kind, text) = match failure.ending {
            Ending::Fold => (ViolationKind::Fold, "n . V is not positive in this tet"),
            Ending::Wall => (ViolationKind::Boundary, "inside the mesh, but on a boundary wall of the shell"),
            Ending::Boundary => (ViolationKind::Boundary, "on the mesh's boundary, but not on the shell's"),
            _ => (ViolationKind::Outside, "on the shell's bottom or top"),
        };
        let exact =
            |v: &(dashu_int::IBig, i32)| (value(v), Some(rounded_dyadic(v)).filter(|x| x.is_finite()));
        Violation {
            kind,
            triangle: Some(failure.face),
            prism: Some(tet.prism),
            tet: Some(names(&tet.sorted_names())),
            point: ExactPoint::new(&failure.weights, self.cx.mesh.points(failure.face)),
            middle: None,
            other: None,
            value: failure.value.as_ref().map(exact),
            share: None,
            text: text.to_owned(),
        }
    }

    fn of_coverage(&self, found: &Coverage) -> Vec<Violation> {
        let twice = found.twice.iter().map(|t| self.twice(t));
        found.uncovered.iter().map(|u| self.uncovered(u)).chain(twice).collect()
    }

    fn middle(&self, prism: u32) -> [&[f64; 3]; 3] {
        let shell = self.cx.complex.shell;
        shell.faces[prism as usize].map(|v| &shell.middle[v as usize])
    }

    fn uncovered(&self, place: &Uncovered) -> Violation {
        let share = rounded(&place.share);
        Violation {
            kind: ViolationKind::NotCovered,
            triangle: None,
            prism: Some(place.prism),
            tet: None,
            point: ExactPoint::new(&place.weights, self.middle(place.prism)),
            middle: None,
            other: None,
            value: None,
            share: Some(share),
            text: format!("{:.1} % of the middle triangle has nothing that faces up over it", 100.0 * share),
        }
    }

    fn twice(&self, place: &Twice) -> Violation {
        let at = |i: usize| {
            (place.faces[i], ExactPoint::new(&place.on_faces[i], self.cx.mesh.points(place.faces[i])))
        };
        let (triangle, point) = at(0);
        Violation {
            kind: ViolationKind::CoveredTwice,
            triangle: Some(triangle),
            prism: Some(place.prism),
            tet: None,
            point,
            middle: Some(ExactPoint::new(&place.weights, self.middle(place.prism))),
            other: Some(at(1)),
            value: None,
            share: None,
            text: format!("triangles {triangle} and {} lie over the same middle point", place.faces[1]),
        }
    }
}

/// The largest distance of a corner of a part outside, in floating point.
fn farthest(mesh: &MeshView<'_>, shell: &Shell, outside: &[Outside]) -> Option<f64> {
    let caps = (!outside.is_empty()).then(|| Caps::new(shell))?;
    let corners = outside.iter().flat_map(|place| {
        let polygons = place.polygons.iter().flatten();
        polygons.filter_map(normalised).map(|w: [RBig; 3]| (place.face, w))
    });
    let distances = corners.map(|(face, weights)| {
        let at = coordinates(&weights, mesh.points(face));
        caps.distance(at.each_ref().map(rounded))
    });
    distances.reduce(f64::max).filter(|x| x.is_finite())
}

fn diagonal(vertices: &[[f64; 3]]) -> f64 {
    let extent = |i: usize| {
        let x = || vertices.iter().map(|p| p[i]);
        x().fold(f64::NEG_INFINITY, f64::max) - x().fold(f64::INFINITY, f64::min)
    };
    let unit = unit(vertices.iter());
    unit * (0..3).map(|i| (extent(i) / unit).powi(2)).sum::<f64>().sqrt()
}

/// The share of area and the number of triangles that are not marked, in floating point.
fn clean(mesh: &MeshView<'_>, marked: &HashSet<u32>) -> (f64, usize) {
    let (mut all, mut clean, mut count) = (0.0, 0.0, 0);
    let unit = unit(mesh.vertices.iter());
    for f in 0..mesh.faces.len() as u32 {
        let [a, b, c] = mesh.points(f).map(|p| glam::DVec3::from(*p) / unit);
        let area = (b - a).cross(c - a).length();
        all += area;
        if !marked.contains(&f) {
            clean += area;
            count += 1;
        }
    }
    (if all > 0.0 { clean / all } else { 0.0 }, count)
}
