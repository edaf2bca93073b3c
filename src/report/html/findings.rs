//! Violations and regions of a try, and crossings of the inputs, for the view.

use std::collections::BTreeMap;

use serde::Serialize;

use super::frame::{Frame, bytes, floats, integers};
use crate::audit::ExactPoint;
use crate::audit::report::{
    AttemptReport, AuditReport, CrossingReport, Region, SurveyReport, Violation, ViolationKind,
};
use crate::mesh::TriMesh;

/// What the legend says, by number.
pub(super) fn kinds() -> Vec<&'static str> {
    ViolationKind::ALL.map(ViolationKind::word).into_iter().chain(["triangles intersect"]).collect()
}

const CROSSING: usize = ViolationKind::ALL.len();
/// Where there is no triangle or prism.
const NONE: u32 = u32::MAX;
/// Bytes of exact texts that a try may have.
const TEXTS: usize = 2 << 20;
/// Regions that a try may list; the largest are kept.
const REGIONS: usize = 1000;

/// Arrays with one entry a violation.
#[derive(Debug, Serialize)]
pub(super) struct Findings<'a> {
    count: usize,
    /// 0 or 1: A or B.
    mesh: String,
    kind: String,
    triangle: String,
    other: String,
    prism: String,
    at: String,
    /// Exact texts, by position; of the first violation of each region, then of the others, as far as there is room.
    details: BTreeMap<usize, Detail<'a>>,
    /// The largest first.
    regions: Vec<Area>,
    region_count: usize,
}

/// The report's own words about a violation.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(untagged)]
enum Detail<'a> {
    Violation(&'a Violation),
    Crossing(&'a CrossingReport),
}

/// A region in the view.
#[derive(Debug, Serialize)]
struct Area {
    mesh: u8,
    kind: usize,
    triangles: usize,
    prisms: usize,
    violations: usize,
    /// The violation that is shown for it.
    first: usize,
    centre: [f32; 3],
    radius: f32,
}

struct Found<'a> {
    mesh: u8,
    kind: usize,
    triangle: Option<u32>,
    other: Option<u32>,
    prism: Option<u32>,
    at: [f32; 3],
    detail: Detail<'a>,
}

/// Everything that a try's surveys found.
pub(super) fn of_attempt<'a>(
    attempt: &'a AttemptReport,
    meshes: [&TriMesh; 2],
    frame: &Frame,
) -> Findings<'a> {
    let (mut found, mut areas) = (Vec::new(), Vec::new());
    for survey in &attempt.surveys {
        let (mesh, before) = (u8::from(survey.mesh == "B"), found.len());
        found.extend(survey.violations.iter().map(|v| Found {
            mesh,
            kind: number(v.kind),
            triangle: v.triangle,
            other: v.other.as_ref().map(|(f, _)| *f),
            prism: v.prism,
            at: frame.view(&v.point.approximate),
            detail: Detail::Violation(v),
        }));
        areas.extend(areas_of(survey, mesh, before, meshes[usize::from(mesh)], frame));
    }
    pack(&found, areas)
}

/// Pairs of intersecting triangles of both inputs.
pub(super) fn of_inputs<'a>(report: &'a AuditReport, frame: &Frame) -> Findings<'a> {
    let mut found = Vec::new();
    for (mesh, input) in (0..).zip(&report.inputs) {
        found.extend(input.self_intersections.iter().map(|c| Found {
            mesh,
            kind: CROSSING,
            triangle: Some(c.triangles[0]),
            other: Some(c.triangles[1]),
            prism: None,
            at: frame.view(&c.point.approximate),
            detail: Detail::Crossing(c),
        }));
    }
    let area = |(first, f): (usize, &Found<'_>)| Area {
        mesh: f.mesh,
        kind: CROSSING,
        triangles: 2,
        prisms: 0,
        violations: 1,
        first,
        centre: f.at,
        radius: 0.05,
    };
    let areas = found.iter().enumerate().map(area).collect();
    pack(&found, areas)
}

fn number(kind: ViolationKind) -> usize {
    ViolationKind::ALL.iter().position(|k| *k == kind).unwrap_or(0)
}

fn areas_of(survey: &SurveyReport, mesh: u8, before: usize, of: &TriMesh, frame: &Frame) -> Vec<Area> {
    let corners = |f: u32| of.faces.get(f as usize).into_iter().flatten();
    let area = |region: &Region| {
        let triangles = region.triangles.iter().flat_map(|f| corners(*f));
        let witnesses = region.violations.iter().filter_map(|v| survey.violations.get(*v));
        let points: Vec<[f32; 3]> = triangles
            .filter_map(|v| of.vertices.get(*v as usize))
            .chain(witnesses.map(|v| &v.point.approximate))
            .map(|p| frame.view(p))
            .collect();
        let (centre, radius) = ball(&points);
        Area {
            mesh,
            kind: number(region.kind),
            triangles: region.triangles.len(),
            prisms: region.prisms.len(),
            violations: region.violations.len(),
            first: before + region.violations.first().copied().unwrap_or(0),
            centre,
            radius,
        }
    };
    survey.regions.iter().map(area).collect()
}

/// A ball around points: the middle of their box, and the largest distance from it.
fn ball(points: &[[f32; 3]]) -> ([f32; 3], f32) {
    let extreme = |i: usize, f: fn(f32, f32) -> f32| points.iter().map(|p| p[i]).reduce(f).unwrap_or(0.0);
    let centre: [f32; 3] = std::array::from_fn(|i| f32::midpoint(extreme(i, f32::min), extreme(i, f32::max)));
    let distance = |p: &[f32; 3]| (0..3).map(|i| (p[i] - centre[i]).powi(2)).sum::<f32>().sqrt();
    (centre, points.iter().map(distance).fold(0.0, f32::max))
}

#[expect(clippy::cast_possible_truncation, reason = "there are six kinds")]
fn pack<'a>(found: &[Found<'a>], mut areas: Vec<Area>) -> Findings<'a> {
    areas.sort_by_key(|a| std::cmp::Reverse(a.violations));
    let region_count = areas.len();
    areas.truncate(REGIONS);
    let column = |of: fn(&Found<'a>) -> Option<u32>| integers(found.iter().map(|f| of(f).unwrap_or(NONE)));
    let octets = |of: fn(&Found<'a>) -> u8| bytes(&found.iter().map(of).collect::<Vec<_>>());
    Findings {
        count: found.len(),
        mesh: octets(|f| f.mesh),
        kind: octets(|f| f.kind as u8),
        triangle: column(|f| f.triangle),
        other: column(|f| f.other),
        prism: column(|f| f.prism),
        at: floats(found.iter().map(|f| f.at)),
        details: details(found, &areas),
        regions: areas,
        region_count,
    }
}

fn details<'a>(found: &[Found<'a>], areas: &[Area]) -> BTreeMap<usize, Detail<'a>> {
    let mut out = BTreeMap::new();
    let mut room = TEXTS;
    for i in areas.iter().map(|a| a.first).chain(0..found.len()) {
        let Some(f) = found.get(i).filter(|_| !out.contains_key(&i)) else { continue };
        let Some(left) = room.checked_sub(f.detail.size()) else { break };
        room = left;
        out.insert(i, f.detail);
    }
    out
}

impl Detail<'_> {
    /// About its number of bytes in JSON.
    fn size(&self) -> usize {
        let of = |p: &ExactPoint| 150 + p.exact.iter().chain(&p.weights).map(String::len).sum::<usize>();
        match self {
            Self::Crossing(c) => of(&c.point),
            Self::Violation(v) => {
                let other = v.other.as_ref().map(|(_, p)| p);
                let points = [Some(&v.point), v.middle.as_ref(), other];
                let value = v.value.as_ref().map_or(0, |(exact, _)| exact.len());
                150 + v.text.len() + value + points.into_iter().flatten().map(of).sum::<usize>()
            }
        }
    }
}
