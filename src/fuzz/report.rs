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
    /// Did the subject crash or hang so often that the rest was not asked?
    pub gave_up: bool,
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
        if self.gave_up {
            out.push_str(", given up after too many crashes");
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
        let (swept, others): (Vec<&Onset>, Vec<&Onset>) =
            self.onsets.iter().partition(|row| row.below.is_some() || row.above.is_some());
        if !swept.is_empty() {
            let _ = writeln!(
                out,
                "\n{:16}{:24}{:>12}  begin where the largest coordinate is",
                "class", "sweep of", "failures"
            );
        }
        for row in swept {
            let base = row.origin.trim_start_matches("sweep/");
            let _ = writeln!(out, "{:16}{base:24}{:>12}  {}", row.class.name(), row.failures, row.begin());
        }
        if !others.is_empty() {
            let heading = "largest exponents (least spread of exponents)";
            let _ = writeln!(out, "\n{:16}{:24}{:>12}  {heading}", "class", "generator", "failures");
        }
        for row in others {
            let _ = writeln!(
                out,
                "{:16}{:24}{:>12}  {}",
                row.class.name(),
                row.origin,
                row.failures,
                row.range()
            );
        }
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
            let _ = writeln!(
                out,
                "{} from {}: expected {}, got {}{minimal}",
                f.class, f.origin, f.expected, f.answer
            );
            let _ = writeln!(out, "  {}", f.case);
            if let Some(order) = &f.order {
                let _ = writeln!(out, "  contradicted in the order {order}");
            }
        }
    }
}

impl Onset {
    /// Where failures of a sweep begin.
    fn begin(&self) -> String {
        match (self.below, self.above) {
            // A handful of powers around one: no matter of scale.
            (Some(-8..), Some(..=8)) => "of any size".to_owned(),
            (Some(e @ -8..), None) => format!("of size 2^{e}, and below"),
            (None, Some(e @ ..=8)) => format!("of size 2^{e}, and above"),
            (Some(below), None) => format!("below 2^{}", below + 1),
            (None, Some(above)) => format!("2^{above} or more"),
            (Some(below), Some(above)) => format!("below 2^{}, or 2^{above} or more", below + 1),
            (None, None) => String::new(),
        }
    }

    /// Which exponents failing cases of another generator have.
    fn range(&self) -> String {
        match self.exponents {
            Some([low, high]) => format!("2^{low} to 2^{high} ({})", self.spread.unwrap_or(0)),
            None => "0".to_owned(),
        }
    }
}
