//! Standard output, standard error, and files that are replaced only on success.

use std::fmt::Display;
use std::fs;
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use serde::Serialize;

use super::CliError;

/// One line on standard error. File names and messages of others may hold line breaks and control characters.
pub(super) fn complain(error: &dyn Display) {
    let _ = writeln!(io::stderr(), "homeo: {}", one_line(&error.to_string()));
}

/// The text without control characters, at most 2000 characters of it.
pub(super) fn one_line(text: &str) -> String {
    text.chars().take(2000).map(|c| if c.is_control() { ' ' } else { c }).collect()
}

/// Text to standard output. A reader that went away (`| head`) is no error.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != io::ErrorKind::BrokenPipe => {
            Err(CliError::Write { file: "standard output".to_owned(), reason: e.to_string() })
        }
        _ => Ok(()),
    }
}

/// A value as JSON text with a final line break.
pub(super) fn json<T: Serialize>(value: &T) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(value)
        .map_err(|e| CliError::Write { file: "JSON".to_owned(), reason: e.to_string() })?;
    Ok(text + "\n")
}

/// Where JSON goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Json {
    /// Words are wanted.
    None,
    /// In place of the words.
    Stdout,
    /// Into a file, and words on standard output.
    File(PathBuf),
}

impl Json {
    /// From `--json [FILE]` and a positional argument. The first of `--json FILE` and `FILE --json` also parses
    /// without the JSON file; when the positional argument is missing it is what `--json` took.
    pub(super) fn from_arguments(json: Option<PathBuf>, positional: &mut Option<PathBuf>) -> Self {
        match json {
            Some(file) if file.as_os_str() != "-" && positional.is_none() => {
                *positional = Some(file);
                Self::Stdout
            }
            json => Self::of(json),
        }
    }

    /// From `--json FILE` alone, where no positional argument can be missing.
    pub(super) fn of(json: Option<PathBuf>) -> Self {
        match json {
            None => Self::None,
            Some(file) if file.as_os_str() == "-" => Self::Stdout,
            Some(file) => Self::File(file),
        }
    }

    /// The file, if it is one.
    pub(super) fn file(&self) -> Option<&Path> {
        match self {
            Self::File(file) => Some(file),
            _ => None,
        }
    }

    /// Prints words or JSON, as asked; a JSON file is written first.
    pub(super) fn emit<T: Serialize>(&self, value: &T, words: &str) -> Result<(), CliError> {
        match self {
            Self::None => print(words),
            Self::Stdout => print(&json(value)?),
            Self::File(file) => {
                replace(file, json(value)?.as_bytes())?;
                print(words)
            }
        }
    }
}

/// Checks before long work that a file can be put there: not an input, not an existing directory or device, and in a
/// directory that exists.
pub(super) fn may_write(path: &Path, inputs: &[&Path]) -> Result<(), CliError> {
    let refuse =
        |reason: &str| CliError::Write { file: path.display().to_string(), reason: reason.to_owned() };
    if path.as_os_str().is_empty() {
        return Err(refuse("the file name is empty"));
    }
    if inputs.iter().any(|input| same_file(path, input)) {
        return Err(refuse("it is an input file"));
    }
    match fs::metadata(path) {
        Ok(there) if !there.is_file() => return Err(refuse("there is something that is not a regular file")),
        _ => {}
    }
    match fs::metadata(parent(path)) {
        Ok(there) if there.is_dir() => Ok(()),
        Ok(_) => Err(refuse("its directory is not a directory")),
        Err(e) => Err(refuse(&format!("its directory: {e}"))),
    }
}

fn parent(path: &Path) -> &Path {
    path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

fn same_file(a: &Path, b: &Path) -> bool {
    let (Ok(there), Ok(other)) = (fs::metadata(a), fs::metadata(b)) else {
        // One of them does not exist yet: the same name in the same directory.
        let place =
            |path: &Path| fs::canonicalize(parent(path)).ok().zip(path.file_name().map(ToOwned::to_owned));
        return a == b || place(a).is_some_and(|a| Some(a) == place(b));
    };
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt as _;
        (there.dev(), there.ino()) == (other.dev(), other.ino())
    }
    #[cfg(not(unix))]
    {
        let _ = (there, other);
        matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
    }
}

/// Puts all bytes into a temporary file in the same directory and renames it: an existing file is replaced whole or
/// not at all. A link is followed.
pub(super) fn replace(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    Staged::new(path, bytes)?.place()
}

/// A file that is not in its place yet; dropped, it is gone.
pub(super) struct Staged {
    file: Temporary,
    target: PathBuf,
    name: String,
}

impl Staged {
    /// Writes all bytes into a temporary file in the directory of `path`.
    pub(super) fn new(path: &Path, bytes: &[u8]) -> Result<Self, CliError> {
        let mut out = Self::empty(path)?;
        let written = out.file.file.write_all(bytes);
        written.map_err(|e| CliError::Write { file: out.name.clone(), reason: e.to_string() })?;
        Ok(out)
    }

    /// An empty temporary file in the directory of `path`.
    pub(super) fn empty(path: &Path) -> Result<Self, CliError> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        let name = path.display().to_string();
        let file =
            beside(&target).map_err(|e| CliError::Write { file: name.clone(), reason: e.to_string() })?;
        Ok(Self { file, target, name })
    }

    /// Where the bytes are.
    pub(super) fn path(&self) -> &Path {
        self.file.path()
    }

    /// What it will be called.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// The file, to be written from front to back.
    pub(super) fn file(&mut self) -> &mut Temporary {
        &mut self.file
    }

    /// Puts it into its place by renaming.
    pub(super) fn place(self) -> Result<(), CliError> {
        let Self { file, target, name } = self;
        let placed = file.file.persist(target);
        placed.map(|_| ()).map_err(|e| CliError::Write { file: name, reason: e.error.to_string() })
    }
}

/// Temporary files that are there now, for the end of the process without unwinding.
static THERE: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A temporary file. It is gone when it is dropped, and after [`end_at_once`].
pub(super) struct Temporary {
    file: tempfile::NamedTempFile,
    // Dropped after the file.
    _there: There,
}

/// An entry of [`THERE`].
struct There(PathBuf);

impl Drop for There {
    fn drop(&mut self) {
        THERE.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.0);
    }
}

impl Temporary {
    /// For what is not to be kept: in the system's directory for temporary files, for this user alone.
    pub(super) fn unplaced() -> Result<Self, CliError> {
        let directory = std::env::temp_dir();
        let fail = |e: io::Error| CliError::Write {
            file: format!("a temporary file in {}", directory.display()),
            reason: e.to_string(),
        };
        Self::new(&tempfile::Builder::new(), &directory).map_err(fail)
    }

    fn new(builder: &tempfile::Builder<'_, '_>, directory: &Path) -> io::Result<Self> {
        // Nobody ends the process between the file and its entry.
        let mut there = THERE.lock().unwrap_or_else(PoisonError::into_inner);
        let file = builder.tempfile_in(directory)?;
        let path = file.path().to_owned();
        there.push(path.clone());
        Ok(Self { file, _there: There(path) })
    }

    pub(super) fn path(&self) -> &Path {
        self.file.path()
    }
}

impl io::Write for Temporary {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        // The file itself: its wrapper would name the temporary path in every error.
        self.file.as_file_mut().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.as_file_mut().flush()
    }
}

/// Ends the process without unwinding, but leaves no temporary file behind.
pub(super) fn end_at_once(code: i32) -> ! {
    // Held until the end, so that no further file is made.
    let there = THERE.lock().unwrap_or_else(PoisonError::into_inner);
    for path in there.iter() {
        let _ = fs::remove_file(path);
    }
    std::process::exit(code);
}

/// An empty file in the directory of `target`.
pub(super) fn beside(target: &Path) -> io::Result<Temporary> {
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        // The umask applies, as to any other new file; the default would be private to the user.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    Temporary::new(&builder, parent(target))
}

#[cfg(test)]
mod tests {
    use super::{Staged, THERE};
    use std::path::Path;

    /// What [`end_at_once`](super::end_at_once) removes.
    fn is_there(path: &Path) -> bool {
        THERE.lock().unwrap().iter().any(|p| p == path)
    }

    #[test]
    fn temporary_files_are_known_as_long_as_they_are_there() {
        let dir = tempfile::tempdir().unwrap();
        let target = dir.path().join("target");
        let (placed, dropped) =
            (Staged::new(&target, b"new").unwrap(), Staged::new(&target, b"other").unwrap());
        let paths = [placed.path().to_owned(), dropped.path().to_owned()];
        assert!(paths.iter().all(|p| p.exists() && is_there(p)));
        placed.place().unwrap();
        drop(dropped);
        assert!(paths.iter().all(|p| !p.exists() && !is_there(p)));
        assert_eq!(std::fs::read(target).unwrap(), b"new");
    }
}
