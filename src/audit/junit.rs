//! JUnit XML, for continuous integration: one test case a stage.

use std::fmt::Write as _;

use super::report::{AuditReport, AuditVerdict};

/// A test case: its name, seconds, and why it fails.
struct Case {
    name: String,
    seconds: f64,
    failure: Option<String>,
}

/// The text of a JUnit file.
#[must_use]
pub fn junit(report: &AuditReport) -> String {
    let seconds = |stage: &str| report.stages.iter().filter(|s| s.stage == stage).map(|s| s.seconds).sum();
    let mut cases: Vec<Case> = report
        .inputs
        .iter()
        .map(|input| {
            let (defects, crossings) = (input.defects.len(), input.self_intersections.len());
            let failure = format!("{defects} defects, {crossings} pairs of intersecting triangles");
            Case {
                name: format!("{} is valid", input.name),
                seconds: seconds("validity") / 2.0,
                failure: (!input.valid).then_some(failure),
            }
        })
        .collect();
    if let Some(t) = &report.topology {
        let failure = t.difference.clone();
        cases.push(Case { name: "same topology".to_owned(), seconds: seconds("topology"), failure });
        if t.same {
            let failure = (report.verdict != AuditVerdict::Bijective).then(|| report.summary.clone());
            let spent = report.attempts.iter().flat_map(|a| a.seconds).sum();
            cases.push(Case { name: "bijective".to_owned(), seconds: spent, failure });
        }
    }
    text(&cases, &format!("{} -> {}", report.inputs[0].file, report.inputs[1].file))
}

fn text(cases: &[Case], suite: &str) -> String {
    let failures = cases.iter().filter(|c| c.failure.is_some()).count();
    let (suite, n) = (escaped(suite), cases.len());
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n\
         <testsuite name=\"homeo audit {suite}\" tests=\"{n}\" failures=\"{failures}\">\n"
    );
    for case in cases {
        let (name, seconds) = (escaped(&case.name), case.seconds);
        let _ = match &case.failure {
            None => writeln!(out, "<testcase classname=\"{suite}\" name=\"{name}\" time=\"{seconds:.3}\"/>"),
            Some(why) => writeln!(
                out,
                "<testcase classname=\"{suite}\" name=\"{name}\" time=\"{seconds:.3}\"><failure message=\"{}\"/></testcase>",
                escaped(why)
            ),
        };
    }
    out + "</testsuite>\n</testsuites>\n"
}

/// Text for an attribute; characters that XML cannot hold become spaces.
fn escaped(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut out, c| {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => out.push(' '),
            c => out.push(c),
        }
        out
    })
}
