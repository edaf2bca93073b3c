use std::path::{Path, PathBuf};

/// A file or directory of the test data (`$HOMEO_DATA`, else `../shared/data`); `None`, and a loud word, where it is absent.
pub(crate) fn data(part: &str) -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    let path = std::env::var_os("HOMEO_DATA").map_or_else(beside, PathBuf::from).join(part);
    if path.exists() {
        return Some(path);
    }
    eprintln!("SKIPPED: {} is not there (set HOMEO_DATA)", path.display());
    None
}

/// The directory of the real shell files, if it is there.
pub(crate) fn shell_directory() -> Option<PathBuf> {
    data("thirdparty/shells")
}
