//! Corpus files: cases that went wrong, to be asked again.
//!
//! The first line is `homeo-fuzz 1`. Empty lines and lines that begin with `#` say nothing. Every other line is a case
//! as in the protocol's text mode, and then perhaps `; key value` pairs: `origin` and `order` are read again,
//! `class`, `expected`, `answer` and `count` are for people.

use std::fmt::Write as _;

use super::generate::{Generator, Origin};
use super::report::Report;
use super::symmetry::Symmetry;
use super::{Predicate, hex};

/// First line of a corpus file.
const MAGIC: &str = "homeo-fuzz 1";

/// A case of a corpus.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The predicate.
    pub predicate: Predicate,
    /// Its coordinates.
    pub case: Vec<f64>,
    /// Where it came from.
    pub origin: Origin,
    /// An order of the points that got a contradicting answer.
    pub symmetry: Option<Symmetry>,
}

/// Why a text is no corpus.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {reason}")]
pub struct CorpusError {
    /// The line, from 1.
    pub line: usize,
    /// The reason.
    pub reason: String,
}

/// The findings of a report as a corpus file.
#[must_use]
pub fn write(report: &Report) -> String {
    let mut out =
        format!("{MAGIC}\n# {} by {}\n", report.predicate, report.subject.replace(['\n', '\r'], " "));
    for f in &report.findings {
        let answer = f.answer.replace([';', '\n', '\r'], " ");
        let _ = write!(
            out,
            "{} ; class {} ; origin {} ; expected {} ; answer {answer} ; count {}",
            f.case, f.class, f.origin, f.expected, f.count
        );
        if let Some(order) = &f.order {
            let _ = write!(out, " ; order {order}");
        }
        out.push('\n');
    }
    out
}

/// Reads a corpus file.
///
/// # Errors
/// [`CorpusError`] with the first line that is not as it should be.
pub fn read(text: &str) -> Result<Vec<Entry>, CorpusError> {
    let mut lines = text.lines().enumerate();
    if lines.next().is_none_or(|(_, line)| line.trim_end() != MAGIC) {
        return Err(CorpusError { line: 1, reason: format!("expected `{MAGIC}`") });
    }
    let said = lines.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    said.map(|(i, line)| entry(line).map_err(|reason| CorpusError { line: i + 1, reason })).collect()
}

fn entry(line: &str) -> Result<Entry, String> {
    let mut parts = line.split(';').map(str::trim);
    let mut words = parts.next().unwrap_or_default().split_whitespace();
    let predicate: Predicate = words.next().unwrap_or_default().parse().map_err(|e| format!("{e}"))?;
    let number = |word: &str| hex::parse(word).ok_or_else(|| format!("`{word}` is no finite double"));
    let case: Vec<f64> = words.map(number).collect::<Result<_, _>>()?;
    if !predicate.accepts(&case) {
        let arity = predicate.arity();
        return Err(if case.len() == arity {
            format!("{predicate} does not take this case: a triangle, segment or ray is degenerate")
        } else {
            format!("{} coordinates, {predicate} takes {arity}", case.len())
        });
    }
    let mut out = Entry {
        predicate,
        case,
        origin: Origin { generator: Generator::Real, base: Generator::Real },
        symmetry: None,
    };
    for part in parts {
        let (key, value) = part.split_once(' ').unwrap_or((part, ""));
        match key {
            "origin" => out.origin = value.parse().map_err(|e| format!("{e}"))?,
            "order" => {
                let order = Symmetry::parse(value, predicate)
                    .ok_or_else(|| format!("`{value}` is no order of the points"))?;
                if !order.is_of(predicate) {
                    return Err(format!("`{order}` is no symmetry of {predicate}"));
                }
                out.symmetry = Some(order);
            }
            "class" | "expected" | "answer" | "count" => {}
            other => return Err(format!("there is no key `{other}`")),
        }
    }
    Ok(out)
}
