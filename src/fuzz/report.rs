//! What a run has found, as a value and as a table.

use std::fmt::Write as _;

use serde::Serialize;

use super::finding::Finding;
use super::onset::Onset;
use super::{Class, Predicate};

/// Cases of one origin.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct OriginCount {
    /// The generator, `generator/base` where it changed another one's case.
    pub origin: String,
    /// Cases asked.
    pub cases: u64,
    /// Wrong answers among them.
    pub mismatches: u64,
}

/// The result of a run.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Report {
    /// The predicate.
    pub predicate: Predicate,
    /// The subject.
    pub subject: String,
    /// The seed.
    pub seed: u64,
    /// Cases asked.
    pub cases: u64,
    /// Cases that the subject does not judge.
    pub unsupported: u64,
    /// Wrong answers. Contradictions between orders of the points are not counted here: one of the two is wrong.
    pub mismatches: u64,
    /// Cases by origin.
    pub origins: Vec<OriginCount>,
    /// Failures by class and origin, with the magnitudes at which they begin.
    pub onsets: Vec<Onset>,
    /// Failures by class, origin and band of magnitudes, each with one case.
    pub findings: Vec<Finding>,
}

/// Findings that are shown in words.
const SHOWN: usize = 8;

impl Report {
    /// Is nothing wrong?
    #[must_use]
    pub fn is_clean(&self) -> bool {
        self.findings.is_empty()
    }

    /// The tables for people.
    #[must_use]
    pub fn words(&self) -> String {
        let mut out = format!(
            "{} by {}: {} cases, seed {}, {} wrong answers",
            self.predicate, self.subject, self.cases, self.seed, self.mismatches
        );
        if self.unsupported > 0 {
            let _ = write!(out, ", {} not supported", self.unsupported);
        }
        out.push('\n');
        self.write_origins(&mut out);
        if !self.onsets.is_empty() {
            self.write_onsets(&mut out);
            self.write_findings(&mut out);
        }
        out
    }

    fn write_origins(&self, out: &mut String) {
        let _ = writeln!(out, "\n{:24}{:>12}{:>12}", "generator", "cases", "wrong");
        for row in &self.origins {
            let _ = writeln!(out, "{:24}{:>12}{:>12}", row.origin, row.cases, row.mismatches);
        }
    }

    /// One line a class and origin.
    fn write_onsets(&self, out: &mut String) {
        let _ = writeln!(out, "\n{:16}{:24}{:>10}  failures begin", "class", "generator", "failures");
        for row in &self.onsets {
            let class = row.class.name();
            let _ = writeln!(out, "{class:16}{:24}{:>10}  {}", row.origin, row.failures, row.place());
        }
        out.push_str(
            "(sweep: the largest coordinate is in [2^e, 2^(e+1)); others: range of e, and the least difference of exponents)\n",
        );
    }

    /// The simplest finding of each class, and some more.
    fn write_findings(&self, out: &mut String) {
        let mut shown: Vec<&Finding> = Vec::new();
        let length = |f: &&Finding| (!f.minimal, f.case.len());
        for class in Class::ALL {
            shown.extend(self.findings.iter().filter(|f| f.class == class).min_by_key(length));
        }
        let _ = writeln!(out, "\n{} findings; the simplest of each class:", self.findings.len());
        for f in shown.into_iter().take(SHOWN) {
            let minimal = if f.minimal { "" } else { " (not minimal)" };
            let _ = writeln!(out, "{} from {}: expected {}, got {}{minimal}", f.class, f.origin, f.expected, f.answer);
            let _ = writeln!(out, "  {}", f.case);
            if let Some(order) = &f.order {
                let _ = writeln!(out, "  contradicted in the order {order}");
            }
        }
    }
}

impl Onset {
    /// Where they begin, in words.
    fn place(&self) -> String {
        match (self.below, self.above, self.exponents) {
            // A handful of powers around one: no matter of scale.
            (Some(-8..), Some(..=8), _) => "at every scale".to_owned(),
            (Some(e @ -8..), None, _) => format!("at e = {e}, and below"),
            (None, Some(e @ ..=8), _) => format!("at e = {e}, and above"),
            (Some(below), None, _) => format!("below 2^{}", below + 1),
            (None, Some(above), _) => format!("above 2^{above}"),
            (Some(below), Some(above), _) => format!("below 2^{} and above 2^{above}", below + 1),
            (None, None, Some([low, high])) => {
                format!("e from {low} to {high}, spread {}", self.spread.unwrap_or(0))
            }
            (None, None, None) => "all coordinates zero".to_owned(),
        }
    }
}
