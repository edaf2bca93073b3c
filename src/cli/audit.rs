//! `homeo audit`: a pair, a cage, or a manifest of many.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use serde::Serialize;

use super::CliError;
use super::output::{self, Json, one_line};
use super::progress::Progress;
use super::{audit_batch, error};
use crate::audit::batch::Shard;
use crate::audit::{self, AuditOptions, AuditVerdict, Document, Subject, Try};
use crate::mesh;
use crate::report::html;
use crate::shell::{Shell, hdf5};

/// Arguments of `homeo audit`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// A B: the original and the remeshed surface; with --cage: the cage and the mesh that it is to contain
    #[arg(num_args = 0..=2, value_name = "FILE", required_unless_present = "manifest")]
    pub(super) files: Vec<PathBuf>,
    /// Is the second file strictly nested in the first (C7), and has the cage handles that the mesh lacks (C7b)?
    #[arg(long, conflicts_with_all = ["shell", "tries", "junit", "vtu", "html", "manifest"])]
    cage: bool,
    /// Try this shell first (HDF5)
    #[arg(long, value_name = "SHELL")]
    shell: Option<PathBuf>,
    /// Try no other shell
    #[arg(long, requires = "shell")]
    only_shell: bool,
    /// Shells to try, in this order: a, joint-a, joint-b, thick-joint-a, b. Default: all of them, joint-b before joint-a
    /// if B has fewer triangles than A
    #[arg(long = "try", value_name = "NAME", value_delimiter = ',')]
    tries: Vec<String>,
    /// Largest thickness of each half of a shell, as a share of the longest edge of its mesh's bounding box
    #[arg(long, value_name = "SHARE", default_value_t = 0.1)]
    thickness: f64,
    /// Stop each optimisation after so many seconds, with what it has reached. Results then depend on the machine
    #[arg(long, value_name = "SECONDS")]
    time_limit: Option<u64>,
    /// Directory for audit.json, the shells, and all certificates and witnesses with their inputs; made if it is missing
    #[arg(short = 'o', long = "out", value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// JSON to a file; `-` for standard output, in place of the words
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// JUnit XML, for continuous integration
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// Points of all violations, for ParaView
    #[arg(long, value_name = "FILE")]
    vtu: Option<PathBuf>,
    /// A page with tables and a 3D view of meshes, shells and violations; one file that needs no network
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Audit all pairs and cages of a manifest (TOML: `[[pair]]` with a, b and perhaps name, shell; `[[cage]]` with mesh,
    /// cage); results go to DIR/results.jsonl, one line each (entries of one name and content are one audit)
    #[arg(long, value_name = "FILE", requires = "out", conflicts_with_all = ["files", "shell", "json", "junit", "vtu", "html"])]
    pub(super) manifest: Option<PathBuf>,
    /// How many audits of a manifest run at a time
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub(super) jobs: u16,
    /// Go on with the results that are there
    #[arg(long, requires = "manifest")]
    pub(super) resume: bool,
    /// Only every N-th audit of the manifest, from the I-th on; `homeo merge` joins the results
    #[arg(long, value_name = "I/N", requires = "manifest")]
    pub(super) shard: Option<Shard>,
    /// No progress on standard error
    #[arg(short, long)]
    pub(super) quiet: bool,
}

impl Args {
    /// The options of audits of pairs.
    pub(super) fn options(&self) -> Result<AuditOptions, CliError> {
        if !(self.thickness.is_finite() && self.thickness > 0.0) {
            return Err(CliError::Usage("--thickness: a positive number is wanted".to_owned()));
        }
        let known = || Try::ALL.map(Try::name).join(", ");
        let find = |name: &String| {
            Try::from_name(name)
                .ok_or_else(|| CliError::Usage(format!("--try: there is no `{name}`; there are {}", known())))
        };
        let tries = self.tries.iter().map(find).collect::<Result<Vec<_>, _>>()?;
        let time_limit = self.time_limit.map(Duration::from_secs);
        Ok(AuditOptions { thickness: self.thickness, time_limit, tries, only_given: self.only_shell })
    }

    fn outputs(&self) -> Result<Outputs<'_>, CliError> {
        let json = Json::of(self.json.clone());
        let mut taken: Vec<&Path> = self.files.iter().chain(&self.shell).map(PathBuf::as_path).collect();
        if let Some(directory) = &self.out {
            let mut there =
                self.documents().into_iter().map(|name| directory.join(name)).filter(|path| path.exists());
            there.try_for_each(|path| output::may_write(&path, &taken))?;
        }
        let others = [&self.junit, &self.vtu, &self.html].into_iter().flatten().map(PathBuf::as_path);
        for file in json.file().into_iter().chain(others) {
            output::may_write(file, &taken)?;
            taken.push(file);
        }
        Ok(Outputs { directory: self.out.as_deref(), json: json.clone() })
    }

    /// Names of all documents of `--out` that meshes and shells may have, too: in the inputs' own directory these
    /// would be replaced.
    fn documents(&self) -> Vec<String> {
        let fixed =
            ["a.off", "b.off", "mesh.off", "cage.off", "shell.h5", "audit.json"].map(ToOwned::to_owned);
        let tries = || Try::ALL.into_iter().chain([Try::Given]);
        let shells = (1..=self.tries.len().max(Try::ALL.len()) + 1)
            .flat_map(|number| tries().map(move |which| format!("try{number}-{}.h5", which.name())));
        fixed.into_iter().chain(shells).collect()
    }
}

/// Runs the command: 0 bijective or nested, 1 for every other verdict.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let options = args.options()?;
    if let Some(manifest) = &args.manifest {
        return audit_batch::run(args, manifest, &options);
    }
    let [first, second] = &args.files[..] else {
        return Err(CliError::Usage("two files are wanted, or --manifest".to_owned()));
    };
    let outputs = args.outputs()?;
    if args.cage {
        cage(args, first, second, &outputs)
    } else {
        pair(args, first, second, &options, &outputs)
    }
}

struct Outputs<'a> {
    directory: Option<&'a Path>,
    json: Json,
}

fn pair(
    args: &Args,
    first: &Path,
    second: &Path,
    options: &AuditOptions,
    outputs: &Outputs<'_>,
) -> Result<ExitCode, CliError> {
    let (a, b) = (mesh::read(first)?.mesh, mesh::read(second)?.mesh);
    let shell = args.shell.as_deref().map(hdf5::read).transpose()?.map(|f| f.shell);
    let progress = Progress::new(args.quiet);
    let subject = |name, file: &Path, mesh| Subject { name, file: file.display().to_string(), mesh };
    let subjects = [subject("A", first, &a), subject("B", second, &b)];
    let done = audit::audit(&subjects, shell.as_ref(), options, &progress)
        .map_err(|e| error::of_audit(e, &[first, second]))?;
    if progress.interrupted() {
        return Err(CliError::Interrupted);
    }
    drop(progress);
    let report = &done.report;
    if let Some(file) = &args.junit {
        output::replace(file, audit::junit::junit(report).as_bytes())?;
    }
    if let Some(file) = &args.vtu {
        output::replace(file, audit::vtu::vtu(report).as_bytes())?;
    }
    if let Some(file) = &args.html {
        output::replace(file, html(report, [&a, &b], &shells(&done.documents)?).as_bytes())?;
    }
    let mut words = audit::words(report);
    if let Some(directory) = outputs.directory {
        write_all(directory, &done.documents, report)?;
        words += &how_to_check(directory, &done.documents);
        if report.verdict == AuditVerdict::Bijective {
            words += "Both together: homeo-check compose a.cert b.cert shell.h5 a.off b.off\n";
        }
    }
    outputs.json.emit(report, &words)?;
    Ok(ExitCode::from(u8::from(report.verdict != AuditVerdict::Bijective)))
}

/// The shells among the documents, by name.
fn shells(documents: &[Document]) -> Result<Vec<(String, Shell)>, CliError> {
    let files = documents.iter().filter(|d| d.file.ends_with(".h5"));
    files.map(|d| Ok((d.file.clone(), hdf5::parse(&d.file, d.bytes.clone())?.shell))).collect()
}

fn cage(args: &Args, cage: &Path, mesh: &Path, outputs: &Outputs<'_>) -> Result<ExitCode, CliError> {
    let (outer, inner) = (mesh::read(cage)?.mesh, mesh::read(mesh)?.mesh);
    let progress = Progress::new(args.quiet);
    let files = [mesh, cage].map(|f| f.display().to_string());
    let done =
        audit::cage(&inner, &outer, files, &progress).map_err(|e| error::of_audit(e, &[mesh, cage]))?;
    if progress.interrupted() {
        return Err(CliError::Interrupted);
    }
    drop(progress);
    let mut words = done.report.words();
    if let Some(directory) = outputs.directory {
        write_all(directory, &done.documents, &done.report)?;
        words += &how_to_check(directory, &done.documents);
    }
    outputs.json.emit(&done.report, &words)?;
    Ok(ExitCode::from(u8::from(done.report.verdict != "nested")))
}

/// All documents, then the report: a directory with a report is complete.
pub(super) fn write_all<T: Serialize>(
    directory: &Path,
    documents: &[Document],
    report: &T,
) -> Result<(), CliError> {
    std::fs::create_dir_all(directory)
        .map_err(|e| CliError::Write { file: directory.display().to_string(), reason: e.to_string() })?;
    for document in documents {
        output::replace(&directory.join(&document.file), &document.bytes)?;
    }
    output::replace(&directory.join("audit.json"), output::json(report)?.as_bytes())
}

fn how_to_check(directory: &Path, documents: &[Document]) -> String {
    let mut out = format!("Written to {}; in it:\n", one_line(&directory.display().to_string()));
    for document in documents.iter().filter(|d| !d.says.is_empty()) {
        out += &format!("    homeo-check {} {}\n", document.file, document.arguments.join(" "));
    }
    out
}
