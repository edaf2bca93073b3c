//! One list of results from several.

use std::collections::{BTreeMap, BTreeSet};

use super::journal::ResultLine;

/// Why results do not fit together.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{name}` ({key}) is `{first}` in one file and `{second}` in another")]
pub struct MergeError {
    /// The name of the audit.
    pub name: String,
    /// Its key.
    pub key: String,
    /// One verdict.
    pub first: String,
    /// The other.
    pub second: String,
}

/// Every result once, by name and key. Of two with one key the first stays; a result takes the place of an error, also of
/// one with another key: a file that could not be read has no content to make a key of.
///
/// # Errors
/// [`MergeError`] for two different verdicts on one key.
pub fn merge(lines: impl IntoIterator<Item = ResultLine>) -> Result<Vec<ResultLine>, MergeError> {
    let mut by_key: BTreeMap<String, ResultLine> = BTreeMap::new();
    for line in lines {
        let Some(known) = by_key.get(&line.key) else {
            by_key.insert(line.key.clone(), line);
            continue;
        };
        match (known.verdict.as_str(), line.verdict.as_str()) {
            (_, "error") => {}
            ("error", _) => {
                by_key.insert(line.key.clone(), line);
            }
            (first, second) if first == second => {}
            (first, second) => {
                let (first, second) = (first.to_owned(), second.to_owned());
                return Err(MergeError { name: line.name, key: line.key, first, second });
            }
        }
    }
    let audit = |l: &ResultLine| (l.kind, l.name.clone(), l.files.clone());
    let done: BTreeSet<_> = by_key.values().filter(|l| l.verdict != "error").map(audit).collect();
    let mut out: Vec<ResultLine> =
        by_key.into_values().filter(|l| l.verdict != "error" || !done.contains(&audit(l))).collect();
    out.sort_by(|a, b| (&a.name, &a.key).cmp(&(&b.name, &b.key)));
    Ok(out)
}
