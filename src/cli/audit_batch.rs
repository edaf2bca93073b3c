//! `homeo audit --manifest`.

use std::collections::HashSet;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use super::CliError;
use super::audit::{Args, write_all};
use super::error;
use super::input::read_regular;
use super::output::{self, one_line};
use super::progress::Progress;
use crate::audit::batch::{self, Item, Journal, JournalError, Kind, Manifest, ResultLine, Shard};
use crate::audit::{self, AuditOptions, Document, Subject};
use crate::certify::Observer;
use crate::mesh::{self, TriMesh};
use crate::shell::{Shell, hdf5};

/// Passes on the wish to stop, no progress: several audits run at a time.
struct Quiet<'a>(&'a Progress);

impl Observer for Quiet<'_> {
    fn cancelled(&self) -> bool {
        self.0.interrupted()
    }
}

/// Runs all audits: 0 if all are bijective or nested, else 1.
pub(super) fn run(args: &Args, manifest: &Path, options: &AuditOptions) -> Result<ExitCode, CliError> {
    let items = read_manifest(manifest)?;
    let Some(directory) = args.out.as_deref() else {
        return Err(CliError::Usage("--manifest needs --out DIR".to_owned()));
    };
    std::fs::create_dir_all(directory)
        .map_err(|e| CliError::Write { file: directory.display().to_string(), reason: e.to_string() })?;
    let shard = args.shard.unwrap_or(Shard::WHOLE);
    let journal =
        Journal::open(&directory.join(shard.file_name()), args.resume).map_err(error::of_journal)?;
    let progress = Progress::new(true);
    let work = Work {
        items: items.of_shard(shard).collect(),
        next: AtomicUsize::new(0),
        journal: Mutex::new(journal),
        keys: Mutex::new(HashSet::new()),
        failed: Mutex::new(None),
        directory,
        options,
        observer: Quiet(&progress),
        quiet: args.quiet,
    };
    std::thread::scope(|scope| {
        for _ in 0..args.jobs {
            scope.spawn(|| work.run());
        }
    });
    if let Some(failed) = work.failed.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner) {
        return Err(failed);
    }
    let journal = work.journal.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    if progress.interrupted() {
        return Err(CliError::Stopped { results: journal.lines().len() });
    }
    let keys = work.keys.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    // Earlier results of files that have changed since, or are not in the manifest, stay in the journal.
    let lines: Vec<ResultLine> = journal.lines().iter().filter(|l| keys.contains(&l.key)).cloned().collect();
    summarise(directory, &shard.file_name(), &lines)?;
    let good = |l: &ResultLine| matches!(l.verdict.as_str(), "bijective" | "nested");
    Ok(ExitCode::from(u8::from(!lines.iter().all(good))))
}

fn read_manifest(path: &Path) -> Result<Manifest, CliError> {
    let fail = |reason: String| CliError::Read { file: path.display().to_string(), reason };
    let text = String::from_utf8(read_regular(path)?).map_err(|e| fail(e.to_string()))?;
    let directory = path.parent().unwrap_or(Path::new(""));
    Manifest::parse(&text, directory).map_err(|e| fail(e.to_string()))
}

/// The summary pages beside a file of results, and the Markdown one to standard output.
pub(super) fn summarise(directory: &Path, results: &str, lines: &[ResultLine]) -> Result<(), CliError> {
    let stem = results.trim_end_matches(".jsonl").replacen("results", "summary", 1);
    let page = batch::markdown(lines);
    output::replace(&directory.join(format!("{stem}.md")), page.as_bytes())?;
    output::replace(&directory.join(format!("{stem}.html")), batch::html(lines).as_bytes())?;
    output::print(&page)
}

struct Work<'a> {
    items: Vec<&'a Item>,
    next: AtomicUsize,
    journal: Mutex<Journal>,
    /// Keys of the manifest's audits as its files are now.
    keys: Mutex<HashSet<String>>,
    /// What ended the run.
    failed: Mutex<Option<CliError>>,
    directory: &'a Path,
    options: &'a AuditOptions,
    observer: Quiet<'a>,
    quiet: bool,
}

/// Input files as read.
struct Inputs {
    meshes: [TriMesh; 2],
    shell: Option<Shell>,
    /// What the key is made of.
    contents: Vec<Vec<u8>>,
}

impl Work<'_> {
    fn run(&self) {
        while let Some(item) = self.items.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            if self.observer.cancelled() || lock(&self.failed).is_some() {
                return;
            }
            match self.item(item) {
                Ok(()) | Err(CliError::Interrupted) => {}
                Err(error) => {
                    lock(&self.failed).get_or_insert(error);
                }
            }
        }
    }

    fn item(&self, item: &Item) -> Result<(), CliError> {
        let start = Instant::now();
        let read = read(item);
        let key = match &read {
            Ok(inputs) => item.key(&inputs.contents, self.options),
            Err(_) => {
                item.key(&names(item).into_iter().map(String::into_bytes).collect::<Vec<_>>(), self.options)
            }
        };
        lock(&self.keys).insert(key.clone());
        if lock(&self.journal).has(&key) {
            return Ok(());
        }
        let mut line = ResultLine {
            kind: item.kind,
            name: item.name.clone(),
            files: names(item),
            verdict: "error".to_owned(),
            summary: String::new(),
            directory: None,
            document_bytes: 0,
            seconds: 0.0,
            key,
        };
        match read.and_then(|inputs| self.audit(item, &inputs, &mut line)) {
            Err(CliError::Interrupted) => return Err(CliError::Interrupted),
            // The disk is full, or the like: not a result about the pair.
            Err(error @ CliError::Write { .. }) => return Err(error),
            Err(error) => line.summary = one_line(&error.to_string()),
            Ok(()) => {}
        }
        line.seconds = start.elapsed().as_secs_f64();
        let said = format!("{}: {} ({:.1} s)", one_line(&line.name), line.verdict, line.seconds);
        let done = {
            let mut journal = lock(&self.journal);
            journal.record(line).map_err(error::of_journal)?;
            journal.lines().len()
        };
        if !self.quiet {
            let _ = writeln!(std::io::stderr(), "[{done}/{}] {said}", self.items.len());
        }
        Ok(())
    }

    fn audit(&self, item: &Item, inputs: &Inputs, line: &mut ResultLine) -> Result<(), CliError> {
        let files: Vec<&Path> = item.files.iter().map(PathBuf::as_path).collect();
        let name: String = line.key.chars().take(16).collect();
        let directory = self.directory.join(&name);
        let failed = |e| error::of_audit(e, &files);
        let [first, second] = &inputs.meshes;
        let file = |i: usize| line.files.get(i).cloned().unwrap_or_default();
        let documents = match item.kind {
            Kind::Pair => {
                let subject = |name, i, mesh| Subject { name, file: file(i), mesh };
                let subjects = [subject("A", 0, first), subject("B", 1, second)];
                let done = audit::audit(&subjects, inputs.shell.as_ref(), self.options, &self.observer)
                    .map_err(failed)?;
                write_all(&directory, &done.documents, &done.report)?;
                done.report.verdict.word().clone_into(&mut line.verdict);
                line.summary = done.report.summary;
                done.documents
            }
            Kind::Cage => {
                let done = audit::cage(first, second, [file(0), file(1)], &self.observer).map_err(failed)?;
                write_all(&directory, &done.documents, &done.report)?;
                let report = done.report;
                line.summary = report.reasons.first().map_or_else(
                    || format!("nested; topological condition: {}", report.topology),
                    |[sentence, _]| sentence.clone(),
                );
                line.verdict = report.verdict;
                done.documents
            }
        };
        line.directory = Some(name);
        line.document_bytes = proofs(&documents);
        Ok(())
    }
}

fn proofs(documents: &[Document]) -> usize {
    documents.iter().filter(|d| !d.says.is_empty()).map(|d| d.bytes.len()).sum()
}

fn names(item: &Item) -> Vec<String> {
    item.files.iter().map(|f| f.display().to_string()).collect()
}

fn read(item: &Item) -> Result<Inputs, CliError> {
    let [first, second, rest @ ..] = &item.files[..] else {
        return Err(CliError::Usage("an audit needs two files".to_owned()));
    };
    let meshes = [mesh::read(first)?.mesh, mesh::read(second)?.mesh];
    let mut contents: Vec<Vec<u8>> = meshes.iter().map(audit::canonical).collect();
    let shell = match rest.first() {
        None => None,
        Some(path) => {
            let bytes = read_regular(path)?;
            let shell = hdf5::parse(&path.display().to_string(), bytes.clone())?.shell;
            contents.push(bytes);
            Some(shell)
        }
    };
    Ok(Inputs { meshes, shell, contents })
}

/// A thread that panicked leaves whole data behind: lines are recorded whole.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

/// Arguments of `homeo merge`.
#[derive(Debug, clap::Args)]
pub(super) struct MergeArgs {
    /// Files of results (`results-I-of-N.jsonl`)
    #[arg(required = true, value_name = "RESULTS")]
    files: Vec<PathBuf>,
    /// Where all results go, each once, with a summary page beside it
    #[arg(short = 'o', long = "out", value_name = "OUT.jsonl")]
    out: PathBuf,
}

/// Runs `homeo merge`.
pub(super) fn merge(args: &MergeArgs) -> Result<ExitCode, CliError> {
    let inputs: Vec<&Path> = args.files.iter().map(PathBuf::as_path).collect();
    output::may_write(&args.out, &inputs)?;
    let mut lines = Vec::new();
    for file in inputs {
        let name = file.display().to_string();
        lines.extend(batch::read_lines(&name, &read_regular(file)?).map_err(error::of_journal)?);
    }
    let merged = batch::merge(lines).map_err(|e| CliError::Usage(e.to_string()))?;
    let mut text = String::new();
    for line in &merged {
        let line = serde_json::to_string(line).map_err(|e| {
            error::of_journal(JournalError::Io { file: args.out.display().to_string(), source: e.into() })
        })?;
        text += &line;
        text.push('\n');
    }
    output::replace(&args.out, text.as_bytes())?;
    let directory = args.out.parent().unwrap_or(Path::new(""));
    let name = args.out.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let page = if name.starts_with("results") { name } else { format!("results-{name}") };
    summarise(directory, &page, &merged)?;
    Ok(ExitCode::SUCCESS)
}
