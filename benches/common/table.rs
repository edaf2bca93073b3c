//! Plain tables that are Markdown at the same time, and medians.

use std::fmt::Write;

/// The median of a few measurements, of an even number the mean of the two in the middle; NaN for none.
#[must_use]
pub fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = |i: usize| sorted.get(i).copied().unwrap_or(f64::NAN);
    let half = sorted.len() / 2;
    if sorted.len() % 2 == 1 { at(half) } else { 0.5 * (at(half.wrapping_sub(1)) + at(half)) }
}

/// The smallest of a few measurements; infinite for none.
#[must_use]
pub fn smallest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

/// A table with one header row.
#[derive(Clone, Debug)]
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table of these columns.
    #[must_use]
    pub fn new(header: &[&str]) -> Self {
        Self { rows: vec![header.iter().map(ToString::to_string).collect()] }
    }

    /// One more row.
    pub fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// As Markdown, with columns padded to equal width.
    #[must_use]
    pub fn render(&self) -> String {
        let columns = self.rows.iter().map(Vec::len).max().unwrap_or(0);
        let cell = |row: &[String], k: usize| row.get(k).cloned().unwrap_or_default();
        let width = |k: usize| self.rows.iter().map(|r| cell(r, k).chars().count()).max().unwrap_or(0);
        let widths: Vec<usize> = (0..columns).map(width).collect();
        let mut out = String::new();
        for (i, row) in self.rows.iter().enumerate() {
            for (k, w) in widths.iter().enumerate() {
                let _ = write!(out, "| {:w$} ", cell(row, k));
            }
            out.push_str("|\n");
            if i == 0 {
                widths.iter().for_each(|w| out.push_str(&format!("|{}", "-".repeat(w + 2))));
                out.push_str("|\n");
            }
        }
        out
    }
}
