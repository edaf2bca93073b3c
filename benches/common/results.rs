//! Sections of `benches/RESULTS.md`: each program writes its own between two markers and leaves the others alone.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

/// A file in `benches/`.
#[must_use]
pub fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// Replaces a section of `RESULTS.md`, or adds it at the end.
///
/// # Errors
/// The file cannot be read or written.
pub fn put(section: &str, text: &str) -> io::Result<()> {
    let path = file("RESULTS.md");
    let old = match std::fs::read_to_string(&path) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => "# Results\n".to_owned(),
        other => other?,
    };
    std::fs::write(path, replaced(&old, section, text))
}

fn replaced(old: &str, section: &str, text: &str) -> String {
    let [begin, end] = ["begin", "end"].map(|edge| format!("<!-- {section}: {edge} -->"));
    let new = format!("{begin}\n{}\n{end}", text.trim());
    let range = old.find(&begin).zip(old.find(&end)).filter(|(b, e)| b < e);
    match range {
        Some((b, e)) => format!("{}{new}{}", &old[..b], &old[e + end.len()..]),
        None => format!("{}\n\n{new}\n", old.trim_end()),
    }
}

/// Processor, cores and memory, in general terms.
#[must_use]
pub fn machine() -> String {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let (cpu, memory) = (read("/proc/cpuinfo"), read("/proc/meminfo"));
    let value = |text: &str, key: &str| {
        let line = text.lines().find_map(|l| l.strip_prefix(key));
        line.and_then(|l| l.split_once(':')).map_or_else(String::new, |(_, v)| v.trim().to_owned())
    };
    let kib = value(&memory, "MemTotal").trim_end_matches(" kB").parse::<f64>().unwrap_or(0.0);
    let cores = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    format!("{}, {cores} cores, {:.0} GiB", value(&cpu, "model name"), kib / 1024.0 / 1024.0)
}

/// Members of objects as CSV (RFC 4180), their keys first; what is `null` or missing is empty.
#[must_use]
pub fn csv(keys: &[&str], rows: &[Value]) -> String {
    let cell = |value: &Value| match value {
        Value::Null => String::new(),
        Value::String(text) if text.contains([',', '"', '\n']) => {
            format!("\"{}\"", text.replace('"', "\"\""))
        }
        Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let mut out = keys.join(",") + "\n";
    for row in rows {
        let cells: Vec<String> = keys.iter().map(|k| row.get(*k).map_or_else(String::new, cell)).collect();
        out += &(cells.join(",") + "\n");
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{csv, replaced};

    #[test]
    fn csv_quotes_what_needs_it() {
        let rows =
            [serde_json::json!({ "a": "x, \"y\"", "b": null }), serde_json::json!({ "a": "z", "b": 1.5 })];
        assert_eq!(csv(&["a", "b"], &rows), "a,b\n\"x, \"\"y\"\"\",\nz,1.5\n");
    }

    #[test]
    fn a_section_is_added_then_replaced() {
        let one = replaced("# Results\n", "a", "first");
        let two = replaced(&one, "b", "second");
        assert_eq!(
            replaced(&two, "a", "third\n"),
            "# Results\n\n<!-- a: begin -->\nthird\n<!-- a: end -->\n\n<!-- b: begin -->\nsecond\n<!-- b: end -->\n"
        );
    }
}
