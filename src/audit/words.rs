//! A report in words.

use std::fmt::Write as _;

use super::report::{AttemptReport, AttemptResult, AuditReport, InputReport, SurveyReport, ViolationKind};

/// Defects, witnesses and regions listed for people; the JSON has all.
const LISTED: usize = 4;

/// The report, a stage after the other.
#[must_use]
pub fn words(report: &AuditReport) -> String {
    let mut out = String::new();
    for input in &report.inputs {
        out += &about_input(input);
    }
    if let Some(t) = &report.topology {
        let _ = match &t.difference {
            None => writeln!(out, "Topology: the same ({} components).", t.a.len()),
            Some(difference) => writeln!(out, "Topology: different: {difference}."),
        };
    }
    for (number, attempt) in (1..).zip(&report.attempts) {
        out += &about_attempt(number, attempt);
    }
    let _ = writeln!(out, "VERDICT  {}", report.summary);
    out
}

fn about_input(input: &InputReport) -> String {
    let (v, f) = (input.vertices, input.triangles);
    let mut out = format!("{} = {} ({v} vertices, {f} triangles): ", input.name, input.file);
    if input.valid {
        return out + "an embedded oriented manifold.\n";
    }
    let (defects, crossings) = (input.defects.len(), input.self_intersections.len());
    let _ = writeln!(out, "{defects} defects, {crossings} pairs of intersecting triangles.");
    for d in input.defects.iter().take(LISTED) {
        let _ = writeln!(out, "    {}", d.text);
    }
    for c in input.self_intersections.iter().take(LISTED) {
        let [x, y, z] = c.point.approximate;
        let _ = writeln!(
            out,
            "    triangles {} and {} meet near ({x}, {y}, {z})",
            c.triangles[0], c.triangles[1]
        );
    }
    out
}

fn about_attempt(number: usize, attempt: &AttemptReport) -> String {
    let prisms = attempt.prisms;
    let mut out = format!("Try {number}, {}: ", attempt.text);
    match (attempt.result, &attempt.reason) {
        (AttemptResult::Certified, _) => {
            let _ = writeln!(out, "A and B are sections ({prisms} prisms).");
        }
        (AttemptResult::NoShell, reason) => {
            let _ = writeln!(out, "no shell: {}", reason.as_deref().unwrap_or(""));
        }
        (AttemptResult::NotSections, _) => {
            let _ = writeln!(out, "{prisms} prisms.");
        }
    }
    for witness in attempt.witnesses.iter().take(LISTED) {
        let text: String = witness.chars().take(240).collect();
        let _ = writeln!(out, "    {text}");
    }
    attempt.surveys.iter().for_each(|s| out += &about_survey(s));
    out
}

fn about_survey(survey: &SurveyReport) -> String {
    let share = 100.0 * survey.clean_area_share;
    let mut out =
        format!("    {}: {share:.2} % of its area is in triangles without violations;", survey.mesh);
    for kind in ViolationKind::ALL {
        let regions = survey.regions.iter().filter(|r| r.kind == kind);
        let (count, places) = regions.fold((0, 0), |(n, p), r| (n + 1, p + r.violations.len()));
        if count > 0 {
            let _ = write!(out, " {}: {places} in {count} regions;", kind.word());
        }
    }
    if let (Some(d), Some(s)) = (survey.largest_distance_outside, survey.largest_distance_share) {
        let _ = write!(out, " up to {d:.3e} outside ({:.3} % of the diagonal);", 100.0 * s);
    }
    out.pop();
    out + ".\n"
}
