//! Audits of many pairs: a manifest, a file of result lines that survives any interruption, and summaries.

mod journal;
mod manifest;
mod merge;
mod summary;

#[cfg(test)]
mod tests;

pub use journal::{Journal, JournalError, ResultLine, read_lines};
pub use manifest::{Item, Kind, Manifest, ManifestError, Shard};
pub use merge::{MergeError, merge};
pub use summary::{html, markdown};
