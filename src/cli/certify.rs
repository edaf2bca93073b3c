//! `homeo certify`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use super::CliError;
use super::check::{Checked, self_check};
use super::input::{self, Loaded, ThreeMeshes};
use super::output::{self, Json, Staged, Temporary, one_line};
use super::progress::Progress;
use crate::certify::{CertifyError, Claim, ClaimResult, Options, Proof, VertexOrder, prove};
use crate::report::{CertifyReport, MeshReport, ShellReport, Sources, sentence};

/// Arguments of `homeo certify`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// Shell file (HDF5); its stored mesh is used unless --mesh gives one
    shell: Option<PathBuf>,
    /// The mesh (OBJ, OFF, PLY, STL)
    #[arg(long, value_name = "MESH")]
    mesh: Option<PathBuf>,
    #[command(flatten)]
    three: ThreeMeshes,
    /// Vertex order of `section` and `bijection`: `id`, or a file of all vertex ids, smallest first
    #[arg(long, value_name = "id|FILE", default_value = "id")]
    order: String,
    /// Claims to decide; default: positivity, section, bijection, section-all-orders, disjoint, i2. There is also
    /// disjoint-prisms: the shell does not overlap itself
    #[arg(long, value_name = "NAME", num_args = 1.., value_delimiter = ',')]
    claim: Vec<String>,
    /// Where the certificate (or the refutation) goes; an existing file is replaced, but only when there is a verdict
    #[arg(short = 'o', long = "output", value_name = "OUT.cert")]
    output: Option<PathBuf>,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
    /// Number of threads (1 to 1024); default: all cores. The result does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    /// Do not let the independent checker check the certificate
    #[arg(long)]
    no_check: bool,
    /// No progress on standard error
    #[arg(short, long)]
    quiet: bool,
}

impl Args {
    /// `--claim NAME... SHELL`: the last name that is no claim is the shell, when that is missing.
    fn settle_shell(&mut self) {
        if self.shell.is_none()
            && self.three.files().is_none()
            && self.claim.len() > 1
            && self.claim.last().is_some_and(|last| Claim::from_name(last).is_none())
        {
            self.shell = self.claim.pop().map(PathBuf::from);
        }
    }

    fn claims(&self) -> Result<Vec<Claim>, CliError> {
        if self.claim.is_empty() {
            return Ok(Claim::STANDARD.to_vec());
        }
        let known = Claim::ALL.map(Claim::name).join(", ");
        let find = |name: &String| {
            Claim::from_name(name).ok_or_else(|| {
                CliError::Usage(format!("--claim: there is no claim `{name}`; there are {known}"))
            })
        };
        self.claim.iter().map(find).collect()
    }
}

/// Runs the command.
pub(super) fn run(mut args: Args) -> Result<ExitCode, CliError> {
    args.settle_shell();
    let json = match args.three.files() {
        // With three meshes there is no positional argument that `--json` could have taken.
        Some(_) => Json::of(args.json.take()),
        None => Json::from_arguments(args.json.take(), &mut args.shell),
    };
    let claims = args.claims()?;
    super::threads(args.threads)?;
    let progress = Progress::new(args.quiet);
    let loaded = Loaded::read(args.shell.as_deref(), &args.three, args.mesh.as_deref())?;
    let order = input::order(&args.order, loaded.shell().vertex_count())?;
    let outputs = Outputs { certificate: args.output.as_deref(), json: &json };
    outputs.may_be_written(&loaded, &args.order)?;
    let options = Options { claims: claims.clone(), order };
    // Before the work: a place that takes no file is told at once.
    let mut written = Written::open(outputs.certificate, !args.no_check)?;
    let proof = prove(loaded.shell(), loaded.mesh(), &options, &progress)
        .map_err(|e| named(e, &loaded, &args.order))?;
    written.write(&proof, &progress)?;
    // What shows the verdicts is in the file now: the checker has its memory.
    let results = proof.into_claims();
    let checked = if args.no_check { None } else { written.check(&loaded)? };
    if progress.interrupted() {
        return Err(CliError::Interrupted);
    }
    drop(progress);
    written.place()?;
    let mut report = report(&results, &claims, &options.order, &loaded);
    report.checked = checked.as_ref().map(|_| "valid".to_owned());
    report.certificate = outputs.certificate.map(|path| path.display().to_string());
    let words = words(&results, &claims, &args, &loaded, checked.as_ref());
    json.emit(&report, &words)?;
    Ok(ExitCode::from(u8::from(!report.certified())))
}

/// The certificate in a file of its own, which is gone when this is dropped.
enum Written {
    /// In the directory of the output.
    Kept(Staged),
    /// To be checked only.
    Unplaced(Temporary),
    /// Nobody wants it.
    Not,
}

impl Written {
    /// An empty file beside the output, or where there is none but a check in the system's directory for temporary files.
    fn open(output: Option<&Path>, check: bool) -> Result<Self, CliError> {
        Ok(match output {
            Some(path) => Self::Kept(Staged::empty(path)?),
            None if check => Self::Unplaced(Temporary::unplaced()?),
            None => Self::Not,
        })
    }

    /// Writes the certificate while it is made: it is never in memory as a whole.
    fn write(&mut self, proof: &Proof<'_>, progress: &Progress) -> Result<(), CliError> {
        let (name, file) = match self {
            Self::Kept(staged) => (staged.name().to_owned(), staged.file()),
            Self::Unplaced(file) => (file.path().display().to_string(), file),
            Self::Not => return Ok(()),
        };
        proof.write(file, progress).map_err(|e| match e {
            CertifyError::Cancelled => CliError::Interrupted,
            CertifyError::Write(e) => CliError::Write { file: name, reason: e.to_string() },
            source => CliError::Certify { files: name, source },
        })
    }

    /// Lets the independent checker read the file.
    fn check(&self, loaded: &Loaded) -> Result<Option<Checked>, CliError> {
        match self {
            Self::Kept(staged) => self_check(staged.path(), loaded).map(Some),
            Self::Unplaced(file) => self_check(file.path(), loaded).map(Some),
            Self::Not => Ok(None),
        }
    }

    /// Puts the file into its place, if it is to be kept.
    fn place(self) -> Result<(), CliError> {
        match self {
            Self::Kept(staged) => staged.place(),
            Self::Unplaced(_) | Self::Not => Ok(()),
        }
    }
}

/// The files to be written.
struct Outputs<'a> {
    certificate: Option<&'a Path>,
    json: &'a Json,
}

impl Outputs<'_> {
    fn may_be_written(&self, loaded: &Loaded, order: &str) -> Result<(), CliError> {
        let mut taken = loaded.inputs();
        taken.push(Path::new(order));
        if let Some(path) = self.certificate {
            output::may_write(path, &taken)?;
            taken.push(path);
        }
        self.json.file().map_or(Ok(()), |path| output::may_write(path, &taken))
    }
}

/// The certifier's error with the file that it is about.
fn named(error: CertifyError, loaded: &Loaded, order: &str) -> CliError {
    match error {
        CertifyError::Shell(source) => CliError::InvalidShell { file: loaded.shell_name(), source },
        CertifyError::Mesh(source) => CliError::InvalidMesh { file: loaded.mesh_name(), source },
        CertifyError::Cancelled => CliError::Interrupted,
        CertifyError::Order(e) => CliError::Read { file: order.to_owned(), reason: e.to_string() },
        source => CliError::Certify { files: loaded.shell_name(), source },
    }
}

fn report(results: &[ClaimResult], claims: &[Claim], order: &VertexOrder, loaded: &Loaded) -> CertifyReport {
    let files = loaded.shell_files.iter().map(|f| f.display().to_string()).collect();
    let shell = ShellReport::new(loaded.shell(), files);
    let mesh = loaded.mesh().map(|mesh| MeshReport::new(mesh, loaded.mesh_name()));
    let mut report = CertifyReport::new(results, claims, order, shell, mesh);
    report.notes.clone_from(&loaded.file.notes);
    report
}

fn words(
    results: &[ClaimResult],
    claims: &[Claim],
    args: &Args,
    loaded: &Loaded,
    checked: Option<&Checked>,
) -> String {
    let mut out = String::new();
    for note in &loaded.file.notes {
        let _ = writeln!(out, "note: {}", one_line(note));
    }
    let order =
        if args.order == "id" { "by vertex id".to_owned() } else { format!("of {}", one_line(&args.order)) };
    let sizes = (loaded.shell().prism_count(), loaded.mesh().map_or(0, |m| m.faces.len()));
    let mesh_file = loaded.mesh_file.as_ref().map(|_| loaded.mesh_name());
    let sources = Sources::new(&loaded.shell_name(), mesh_file.as_deref(), sizes, order);
    for result in results {
        out += &sentence(result, &sources);
        if !claims.contains(&result.claim) {
            let _ = writeln!(out, "             (not asked for; another claim rests on it)");
        }
    }
    if checked.is_some() {
        let _ = writeln!(out, "The independent checker accepts this certificate.");
    }
    match &args.output {
        None => {
            let _ = writeln!(out, "No certificate was kept; -o OUT.cert keeps it.");
        }
        Some(path) => {
            let path = one_line(&path.display().to_string());
            let files: Vec<String> =
                loaded.inputs().iter().map(|p| one_line(&p.display().to_string())).collect();
            let _ = writeln!(out, "Certificate: {path}\nCheck it:    homeo-check {path} {}", files.join(" "));
            if checked.is_some_and(|c| c.converted) {
                let _ = writeln!(
                    out,
                    "             (this checker does not read that input format: make one that it reads with\n             \
                     `homeo convert`, which keeps every bit, and check against that)"
                );
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{CliError, Loaded, Progress, Staged, Temporary, ThreeMeshes, Written};
    use crate::certify::{Options, prove};
    use crate::construct::sample;
    use crate::shell::hdf5;
    use std::io::Write as _;

    #[test]
    fn a_certificate_that_the_checker_does_not_accept_is_not_left() {
        let dir = tempfile::tempdir().unwrap();
        let [shell, cert] = ["s.h5", "s.cert"].map(|name| dir.path().join(name));
        let made = sample(0);
        let file = hdf5::ShellFile { shell: made.shell, mesh: Some(made.mesh), ..hdf5::ShellFile::default() };
        std::fs::write(&shell, hdf5::to_bytes(&file).unwrap()).unwrap();
        let loaded = Loaded::read(Some(&shell), &ThreeMeshes::default(), None).unwrap();
        let (options, progress) = (Options::default(), Progress::new(true));
        let proof = prove(loaded.shell(), loaded.mesh(), &options, &progress).unwrap();
        let written = || {
            let mut written = Written::open(Some(&cert), true).unwrap();
            written.write(&proof, &progress).unwrap();
            written
        };
        let good = written();
        assert!(!good.check(&loaded).unwrap().unwrap().converted);
        let Written::Kept(staged) = &good else { panic!("it is not kept") };
        let text = std::fs::read_to_string(staged.path()).unwrap();
        // Before it is placed there is nothing under its name, and after it was dropped nothing at all.
        assert!(!cert.exists());
        drop(good);
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
        let forged = text.replacen("claim section refuted", "claim section certified", 1);
        assert_ne!(forged, text);
        let refused = Written::Kept(Staged::new(&cert, forged.as_bytes()).unwrap()).check(&loaded);
        assert!(matches!(refused, Err(CliError::Disagreement(_))));
        let mut unplaced = Temporary::unplaced().unwrap();
        unplaced.write_all(forged.as_bytes()).unwrap();
        let path = unplaced.path().to_owned();
        assert!(path.exists());
        let refused = Written::Unplaced(unplaced).check(&loaded);
        assert!(matches!(refused, Err(CliError::Disagreement(_))));
        assert!(!path.exists());
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
        written().place().unwrap();
        assert_eq!(std::fs::read_to_string(&cert).unwrap(), text);
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2);
    }
}
