//! A file in the format of `certs/MESHES.md`.

use std::fmt::Write as _;

use super::super::claim::Verdict;
use super::super::pl::{Input, complex_file, write};
use super::super::write::joined;
use crate::mesh::Complex;

/// A document under construction; writing to a `String` cannot fail.
pub(super) struct Document {
    text: String,
    counts: Vec<usize>,
}

impl Document {
    pub(super) fn new(claim: &str, verdict: Verdict) -> Self {
        Self { text: format!("homeo-meshes 1\nclaim {claim} {verdict}\n"), counts: Vec::new() }
    }

    pub(super) fn input(&mut self, name: Input, complex: &Complex) {
        self.text += &write::input(name, complex, &complex_file(complex));
    }

    pub(super) fn block(&mut self, name: &str, lines: Vec<String>) {
        let _ = writeln!(self.text, "begin {name}");
        self.counts.push(lines.len());
        for line in lines {
            self.text += &line;
            self.text.push('\n');
        }
    }

    pub(super) fn text(mut self) -> String {
        self.text += "counts";
        if !self.counts.is_empty() {
            let _ = write!(self.text, " {}", joined(self.counts, " "));
        }
        self.text += "\nend\n";
        self.text
    }
}
