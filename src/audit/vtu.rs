//! Witness points for ParaView: one vertex cell a violation.

use std::fmt::Write as _;

use super::report::{AuditReport, Violation, ViolationKind};

/// The text of a VTU file with the points of all violations of all tries; cell data: `try` (from 1), `mesh` (0 A, 1 B),
/// `kind` (position in [`ViolationKind::ALL`]), `triangle` and `prism` (-1: none).
#[must_use]
pub fn vtu(report: &AuditReport) -> String {
    let mut points = Vec::new();
    for (number, attempt) in (1..).zip(&report.attempts) {
        for survey in &attempt.surveys {
            let mesh = i64::from(survey.mesh == "B");
            for v in &survey.violations {
                points.push((v.point.approximate, data(number, mesh, v, v.triangle)));
                if let Some((triangle, point)) = &v.other {
                    points.push((point.approximate, data(number, mesh, v, Some(*triangle))));
                }
            }
        }
    }
    for (mesh, input) in (0..).zip(&report.inputs) {
        for c in &input.self_intersections {
            points.push((c.point.approximate, [0, mesh, -1, i64::from(c.triangles[0]), -1]));
        }
    }
    text(&points)
}

fn data(number: i64, mesh: i64, violation: &Violation, triangle: Option<u32>) -> [i64; 5] {
    let kind = ViolationKind::ALL.iter().position(|k| *k == violation.kind);
    let id = |x: Option<u32>| x.map_or(-1, i64::from);
    [number, mesh, kind.map_or(-1, number_of), id(triangle), id(violation.prism)]
}

fn text(points: &[([f64; 3], [i64; 5])]) -> String {
    let n = points.len();
    let mut out = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{n}\" NumberOfCells=\"{n}\">\n<Points>\n"
    );
    let coordinates: String = points.iter().fold(String::new(), |mut s, (p, _)| {
        let _ = writeln!(s, "{:?} {:?} {:?}", p[0], p[1], p[2]);
        s
    });
    array(&mut out, "Float64", "Points", " NumberOfComponents=\"3\"", &coordinates);
    out += "</Points>\n<Cells>\n";
    array(&mut out, "Int64", "connectivity", "", &lines((0..n).map(number_of)));
    array(&mut out, "Int64", "offsets", "", &lines((1..=n).map(number_of)));
    array(&mut out, "UInt8", "types", "", &lines((0..n).map(|_| 1)));
    out += "</Cells>\n<CellData>\n";
    for (i, name) in ["try", "mesh", "kind", "triangle", "prism"].into_iter().enumerate() {
        array(&mut out, "Int64", name, "", &lines(points.iter().map(|(_, d)| d[i])));
    }
    out + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
}

/// Positions are far below 2^63.
fn number_of(position: usize) -> i64 {
    i64::try_from(position).unwrap_or(i64::MAX)
}

fn lines(values: impl Iterator<Item = i64>) -> String {
    values.fold(String::new(), |mut s, x| {
        let _ = writeln!(s, "{x}");
        s
    })
}

fn array(out: &mut String, kind: &str, name: &str, more: &str, values: &str) {
    let _ = writeln!(
        out,
        "<DataArray type=\"{kind}\" Name=\"{name}\"{more} format=\"ascii\">\n{values}</DataArray>"
    );
}
