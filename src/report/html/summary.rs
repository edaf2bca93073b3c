//! The tables at the top of the page.

use std::fmt::Write as _;

use super::escape::text;
use crate::audit::report::{AttemptReport, AttemptResult, InputReport, SurveyReport, Timing, ViolationKind};
use crate::audit::{AuditReport, AuditVerdict};

/// Defects and pairs listed for each input; the JSON has all.
const LISTED: usize = 20;
/// Characters of a witness that are shown at once.
const WITNESS: usize = 400;

/// The verdict and the files.
pub(super) fn title(report: &AuditReport) -> String {
    let [a, b] = report.inputs.each_ref().map(|i| text(&i.file));
    format!("{}: {a}, {b}", report.verdict.word())
}

/// Verdict, inputs, topology, tries, documents, and times.
pub(super) fn summary(report: &AuditReport) -> String {
    let class = match report.verdict {
        AuditVerdict::Bijective => "good",
        AuditVerdict::NotCertified => "open",
        AuditVerdict::NotHomeomorphic | AuditVerdict::InvalidInput => "bad",
    };
    let mut out = format!(
        "<h1><span class=\"verdict {class}\">{}</span></h1>\n<p id=\"verdict\">{}</p>\n",
        report.verdict.word(),
        text(&report.summary)
    );
    inputs(report, &mut out);
    topology(report, &mut out);
    if !report.attempts.is_empty() {
        tries(&report.attempts, &mut out);
    }
    documents(report, &mut out);
    times(report, &mut out);
    out
}

fn inputs(report: &AuditReport, out: &mut String) {
    *out += "<h2>Inputs</h2>\n<table><tr><th><th>file<th>vertices<th>triangles<th>embedded oriented manifold</tr>\n";
    for input in &report.inputs {
        let _ = writeln!(
            out,
            "<tr><td>{}<td><bdi>{}</bdi><td class=\"n\">{}<td class=\"n\">{}<td>{}</tr>",
            text(&input.name),
            text(&input.file),
            input.vertices,
            input.triangles,
            validity(input)
        );
    }
    *out += "</table>\n";
}

fn validity(input: &InputReport) -> String {
    let mut lines: Vec<String> = input.remarks.iter().map(|r| text(r)).collect();
    let (defects, pairs) = (input.defects.len(), input.self_intersections.len());
    lines.extend(input.defects.iter().take(LISTED).map(|d| text(&d.text)));
    if defects > LISTED {
        lines.push(format!("… and {} more defects", defects - LISTED));
    }
    if pairs > 0 {
        lines.push(format!("{pairs} pairs of intersecting triangles (in the view below)"));
    }
    let word = if input.valid { "yes" } else { "<b>no</b>" };
    let items = lines.iter().fold(String::new(), |s, line| s + "<br>" + line);
    format!("{word}{items}")
}

fn topology(report: &AuditReport, out: &mut String) {
    let Some(found) = &report.topology else { return };
    *out += "<h2>Topology</h2>\n<table><tr><th>components (genus, boundary loops)<th>A<th>B</tr>\n<tr><td>";
    *out += &found.difference.as_ref().map_or("the same".to_owned(), |d| format!("<b>{}</b>", text(d)));
    for components in [&found.a, &found.b] {
        let mut words: Vec<String> = components
            .iter()
            .take(LISTED)
            .map(|c| format!("({}, {})", c.genus(), c.boundary_loops))
            .collect();
        if components.len() > LISTED {
            words.push(format!("… {} in all", components.len()));
        }
        let _ = write!(out, "<td>{}", words.join(" "));
    }
    *out += "</tr></table>\n";
}

fn tries(attempts: &[AttemptReport], out: &mut String) {
    *out += "<h2>Shells tried</h2>\n<table><tr><th>try<th>result<th>prisms<th>A is a section<th>B is a section\
             <th>violations<th>seconds (build, certify, survey)</tr>\n";
    for (number, attempt) in (1..).zip(attempts) {
        let result = match attempt.result {
            AttemptResult::Certified => "<b>certified</b>".to_owned(),
            AttemptResult::NotSections => "not sections".to_owned(),
            AttemptResult::NoShell => "no shell".to_owned(),
        };
        let reason = attempt.reason.as_ref().filter(|r| !r.is_empty()).map(|r| format!(": {}", text(r)));
        let [a, b] = attempt.sections.map(|s| s.map_or("undecided", |s| if s { "yes" } else { "no" }));
        let [build, certify, survey] = attempt.seconds;
        let found: String = attempt.surveys.iter().map(about_survey).collect();
        let witnesses: String = attempt.witnesses.iter().map(|w| witness(w)).collect();
        let _ = writeln!(
            out,
            "<tr><td>{number}: {}<td>{result}{}<td class=\"n\">{}<td>{a}<td>{b}<td>{found}{witnesses}<td \
             class=\"n\">{build:.1}, {certify:.1}, {survey:.1}</tr>",
            text(&attempt.text),
            reason.unwrap_or_default(),
            attempt.prisms,
        );
    }
    *out += "</table>\n";
}

fn witness(words: &str) -> String {
    let start: String = words.chars().take(WITNESS).collect();
    let more = if start.len() < words.len() { " …" } else { "" };
    format!("<div class=\"witness\">{}{more}</div>", text(&start))
}

fn about_survey(survey: &SurveyReport) -> String {
    let mut out = format!(
        "<div>{}: {:.2} % of the area in clean triangles",
        text(&survey.mesh),
        100.0 * survey.clean_area_share
    );
    for kind in ViolationKind::ALL {
        let regions = survey.regions.iter().filter(|r| r.kind == kind);
        let (count, places) = regions.fold((0, 0), |(n, p), r| (n + 1, p + r.violations.len()));
        if count > 0 {
            let _ = write!(out, "; {}: {places} in {count} regions", kind.word());
        }
    }
    if let Some(d) = survey.largest_distance_outside {
        let _ = write!(out, "; up to {d:.3e} outside");
    }
    out + "</div>"
}

fn documents(report: &AuditReport, out: &mut String) {
    if report.documents.is_empty() {
        return;
    }
    *out += "<h2>Documents</h2>\n<p>Files of the directory that <code>-o</code> wrote, for the independent checkers.</p>\n\
             <table><tr><th>says<th>bytes<th>to check it</tr>\n";
    for document in &report.documents {
        let _ = writeln!(
            out,
            "<tr><td>{}<td class=\"n\">{}<td><code>homeo-check {}</code></tr>",
            witness(&document.says),
            document.bytes,
            text(&document.arguments.join(" "))
        );
    }
    if report.verdict == AuditVerdict::Bijective {
        *out += "<tr><td>both together: A and B are homeomorphic by the map through the shell<td><td>\
                 <code>homeo-check compose a.cert b.cert shell.h5 a.off b.off</code></tr>\n";
    }
    *out += "</table>\n";
}

fn times(report: &AuditReport, out: &mut String) {
    let stage = |t: &Timing| format!("{} {:.1} s", text(&t.stage), t.seconds);
    let stages: Vec<String> = report.stages.iter().map(stage).collect();
    let _ = writeln!(out, "<p>{:.1} s in all: {}.</p>", report.seconds, stages.join(", "));
}
