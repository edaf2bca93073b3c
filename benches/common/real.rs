//! The real shell files, where they are at hand.

use std::path::{Path, PathBuf};

/// The folder of test data: `$HOMEO_DATA`, else `../shared/data` beside the repository.
#[must_use]
pub fn data() -> PathBuf {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/data");
    std::env::var_os("HOMEO_DATA").map_or_else(beside, PathBuf::from)
}

/// All shell files (`*.h5`, `*.h5.init`) there, by name; empty where there are none.
#[must_use]
pub fn shells() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(data().join("thirdparty/shells"));
    let is_shell = |p: &PathBuf| p.to_str().is_some_and(|s| s.ends_with(".h5") || s.ends_with(".h5.init"));
    let mut out: Vec<PathBuf> =
        entries.into_iter().flatten().flatten().map(|entry| entry.path()).filter(is_shell).collect();
    out.sort();
    out
}

/// The last part of a path, for tables.
#[must_use]
pub fn name(path: &Path) -> String {
    path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default()
}
