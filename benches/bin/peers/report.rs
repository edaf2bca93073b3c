//! What was measured: rows with a demand and rows without, tables, and data for JSON.

use homeo_benches::ratio::Spread;
use homeo_benches::table::{Table, median};
use serde::Serialize;
use serde_json::{Map, Value, json};

/// The figure that is asked for.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Asked {
    AtLeast(f64),
    AtMost(f64),
}

impl Asked {
    fn met(self, value: f64) -> bool {
        match self {
            Self::AtLeast(limit) => value >= limit,
            Self::AtMost(limit) => value <= limit,
        }
    }

    fn text(self) -> String {
        match self {
            Self::AtLeast(limit) => format!(">= {limit}"),
            Self::AtMost(limit) => format!("<= {limit}"),
        }
    }
}

/// What was found.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Found {
    /// `theirs / ours`, with the medians of both in seconds (of one call where calls are compared).
    Ratio { ratio: Spread, ours_seconds: f64, theirs_seconds: f64 },
    /// A number without a peer, and what it is.
    Value { value: f64, meaning: String },
    /// Nothing, and why.
    Absent { reason: String },
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) what: String,
    pub(crate) against: String,
    pub(crate) asked: Option<Asked>,
    pub(crate) found: Found,
}

impl Row {
    /// `theirs / ours`, round by round.
    pub(crate) fn ratio(
        what: &str,
        against: &str,
        asked: Option<Asked>,
        theirs: &[f64],
        ours: &[f64],
    ) -> Self {
        let found = Found::Ratio {
            ratio: Spread::of_ratios(theirs, ours),
            ours_seconds: median(ours),
            theirs_seconds: median(theirs),
        };
        Self { what: what.to_owned(), against: against.to_owned(), asked, found }
    }

    pub(crate) fn value(what: &str, against: &str, asked: Option<Asked>, value: f64, meaning: &str) -> Self {
        let found = Found::Value { value, meaning: meaning.to_owned() };
        Self { what: what.to_owned(), against: against.to_owned(), asked, found }
    }

    pub(crate) fn absent(what: &str, against: &str, asked: Option<Asked>, reason: &str) -> Self {
        let found = Found::Absent { reason: reason.to_owned() };
        Self { what: what.to_owned(), against: against.to_owned(), asked, found }
    }

    /// Whether the demand is met; `None` where there is none or nothing was found.
    fn met(&self) -> Option<bool> {
        let value = match &self.found {
            Found::Ratio { ratio, .. } => ratio.median,
            Found::Value { value, .. } => *value,
            Found::Absent { .. } => return None,
        };
        self.asked.map(|asked| asked.met(value))
    }

    fn cells(&self) -> Vec<String> {
        let [measured, spread, ours, theirs] = match &self.found {
            Found::Ratio { ratio, ours_seconds, theirs_seconds } => [
                times(ratio.median),
                format!("{} .. {}", times(ratio.quartiles[0]), times(ratio.quartiles[1])),
                duration(*ours_seconds),
                duration(*theirs_seconds),
            ],
            Found::Value { value, meaning } => {
                [format!("{value:.3}"), String::new(), meaning.clone(), String::new()]
            }
            Found::Absent { reason } => [reason.clone(), String::new(), String::new(), String::new()],
        };
        let met = self.met().map_or("", |met| if met { "yes" } else { "NO" }).to_owned();
        let asked = self.asked.map_or_else(String::new, Asked::text);
        vec![self.what.clone(), self.against.clone(), asked, measured, spread, met, ours, theirs]
    }
}

/// A ratio with about three digits.
fn times(x: f64) -> String {
    match x {
        x if x >= 100.0 => format!("{x:.0}"),
        x if x >= 10.0 => format!("{x:.1}"),
        x => format!("{x:.2}"),
    }
}

/// Seconds in a unit that leaves a short number.
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 1e-6 => format!("{:.1} ns", s * 1e9),
        s if s < 1e-3 => format!("{:.2} us", s * 1e6),
        s if s < 1.0 => format!("{:.2} ms", s * 1e3),
        s => format!("{s:.2} s"),
    }
}

/// Everything, in the order in which it was measured.
#[derive(Debug, Default)]
pub(crate) struct Report {
    rows: Vec<Row>,
    details: Vec<String>,
    data: Map<String, Value>,
}

impl Report {
    pub(crate) fn row(&mut self, row: Row) {
        let cells = row.cells();
        eprintln!("  {} | {} | {} | {} | {}", cells[0], cells[1], cells[2], cells[3], cells[4]);
        self.rows.push(row);
    }

    /// A table under a title, after those of the rows.
    pub(crate) fn detail(&mut self, title: &str, text: &str, table: &Table) {
        self.details.push(format!("### {title}\n\n{text}\n\n{}", table.render()));
    }

    /// More numbers for JSON.
    pub(crate) fn data(&mut self, key: &str, value: Value) {
        self.data.insert(key.to_owned(), value);
    }

    /// Rows whose demand is not met.
    pub(crate) fn missed(&self) -> usize {
        self.rows.iter().filter(|row| row.met() == Some(false)).count()
    }

    pub(crate) fn markdown(&self, head: &str, foot: &str) -> String {
        let header = ["what", "against", "asked", "measured", "quartiles", "met", "homeo", "the other"];
        let table = |asked: bool| {
            let mut table = Table::new(&header);
            let rows = self.rows.iter().filter(|row| row.asked.is_some() == asked);
            rows.for_each(|row| table.row(row.cells()));
            table.render()
        };
        format!(
            "{head}\n\n### Numbers asked for\n\n{}\n### Further peers\n\n{}\n{}\n{foot}\n",
            table(true),
            table(false),
            self.details.join("\n")
        )
    }

    pub(crate) fn json(&self, head: &Value) -> Value {
        let rows: Vec<Value> = self.rows.iter().map(|row| json!({ "row": row, "met": row.met() })).collect();
        json!({ "run": head, "rows": rows, "data": self.data })
    }
}
