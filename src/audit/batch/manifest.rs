//! What is to be audited: a TOML file with `[[pair]]` and `[[cage]]` entries.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::super::options::AuditOptions;
use super::super::sha::sha256;

/// Why a manifest was not understood.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct ManifestError(String);

/// The kind of audit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// Original and remeshed surface.
    Pair,
    /// Mesh and cage.
    Cage,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entries {
    #[serde(default)]
    pair: Vec<PairEntry>,
    #[serde(default)]
    cage: Vec<CageEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PairEntry {
    name: Option<String>,
    a: PathBuf,
    b: PathBuf,
    shell: Option<PathBuf>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CageEntry {
    name: Option<String>,
    mesh: PathBuf,
    cage: PathBuf,
}

/// One audit to be made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Item {
    /// What is audited.
    pub kind: Kind,
    /// Its name in results; default: the names of both files.
    pub name: String,
    /// A and B, or mesh and cage; of a pair perhaps a shell.
    pub files: Vec<PathBuf>,
}

impl Item {
    fn new(kind: Kind, name: Option<String>, files: Vec<PathBuf>) -> Self {
        let stem = |p: &PathBuf| p.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let name = name.unwrap_or_else(|| files.iter().map(stem).collect::<Vec<_>>().join(" "));
        Self { kind, name, files }
    }

    /// The key of the result: a hash of its name, of what the files hold and of the options that matter for the result.
    /// The name is in it because remeshers that made the same file are still two audits, each with a result.
    #[must_use]
    pub fn key(&self, contents: &[Vec<u8>], options: &AuditOptions) -> String {
        let kind = if self.kind == Kind::Pair { "pair" } else { "cage" };
        // A structure of numbers and words: it always has a JSON text.
        let options = if self.kind == Kind::Pair {
            serde_json::to_string(options).unwrap_or_default()
        } else {
            String::new()
        };
        let head = [kind.as_bytes(), self.name.as_bytes(), options.as_bytes()];
        sha256(head.into_iter().chain(contents.iter().map(Vec::as_slice)))
    }
}

/// All audits to be made, in the order of the file: pairs, then cages.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Manifest {
    /// The audits.
    pub items: Vec<Item>,
}

impl Manifest {
    /// Reads a manifest's text; file names are relative to `directory`.
    ///
    /// # Errors
    /// [`ManifestError`] with the line and the reason.
    pub fn parse(text: &str, directory: &Path) -> Result<Self, ManifestError> {
        let entries: Entries = toml::from_str(text).map_err(|e| ManifestError(e.to_string()))?;
        if entries.pair.is_empty() && entries.cage.is_empty() {
            // "All are bijective" would be true of nothing.
            return Err(ManifestError("there is no [[pair]] and no [[cage]]".to_owned()));
        }
        let at = |file: PathBuf| directory.join(file);
        let pairs = entries.pair.into_iter().map(|p| {
            let files = [Some(p.a), Some(p.b), p.shell].into_iter().flatten().map(at).collect();
            Item::new(Kind::Pair, p.name, files)
        });
        let cages =
            entries.cage.into_iter().map(|c| Item::new(Kind::Cage, c.name, vec![at(c.mesh), at(c.cage)]));
        Ok(Self { items: pairs.chain(cages).collect() })
    }

    /// The items of a shard, in order.
    pub fn of_shard(&self, shard: Shard) -> impl Iterator<Item = &Item> {
        let step = usize::try_from(shard.of).unwrap_or(usize::MAX).max(1);
        let first = usize::try_from(shard.index - 1).unwrap_or(usize::MAX);
        self.items.iter().skip(first).step_by(step)
    }
}

/// A part of a manifest: every `of`-th item from the `index`-th on, counted from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    index: u32,
    of: u32,
}

impl Shard {
    /// All items.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// The name of the shard's file of results.
    #[must_use]
    pub fn file_name(self) -> String {
        if self == Self::WHOLE {
            "results.jsonl".to_owned()
        } else {
            format!("results-{}-of-{}.jsonl", self.index, self.of)
        }
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || format!("`{text}` is no shard: I/N with 1 <= I <= N is wanted, as in 2/8");
        let (index, of) = text.split_once('/').ok_or_else(wrong)?;
        match (index.parse(), of.parse()) {
            (Ok(index), Ok(of)) if 1 <= index && index <= of => Ok(Self { index, of }),
            _ => Err(wrong()),
        }
    }
}
