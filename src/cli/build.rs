//! `homeo build`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use super::CliError;
use super::build_report::{Facts, report, words};
use super::check::first_line;
use super::checkpoint::{self, Keeper};
use super::output::{self, Json, Staged};
use super::progress::{Finishing, Progress, Style};
use crate::certify::{CertifyError, Claim, Observer as _, Options, Outcome, certify};
use crate::construct::measure::{Distance, distance};
use crate::construct::optimise::{Counts, Optimiser};
use crate::construct::{BuildError, Initial, InitialOptions, OptimiseOptions, Thickness, initial};
use crate::mesh::{self, TriMesh};
use crate::report::Parts;
use crate::shell::Shell;
use crate::shell::hdf5::{self, ShellFile};

/// What `--allow-self-intersections` gives up.
pub(super) const NOT_GUARANTEED: &str = "\
Not claimed: disjoint, i2 (self-intersections were allowed). The map is one between abstract surfaces, whatever crosses
             in space: where sheets cross, a point of space lies in several prisms and its projection is ambiguous, and
             a surface remeshed in the shell may cross itself, too.
";

/// Arguments of `homeo build`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The mesh (OBJ, OFF, PLY, STL): an oriented manifold without self-intersections
    mesh: Option<PathBuf>,
    /// Where the shell goes (HDF5, with the mesh); its certificate goes beside it, with `.cert` added to the name
    #[arg(short = 'o', long = "output", value_name = "OUT.h5")]
    pub(super) output: PathBuf,
    /// Largest thickness of each half, as a share of the longest edge of the mesh's bounding box
    #[arg(long, value_name = "SHARE", default_value_t = 0.1, conflicts_with = "thickness_absolute")]
    thickness: f64,
    /// Largest thickness of each half in the mesh's units
    #[arg(long, value_name = "LENGTH")]
    thickness_absolute: Option<f64>,
    /// Distortion bound: no operation makes the mesh lean further from a pillar that it is projected along; between 0
    /// and 90 degrees
    #[arg(long, value_name = "DEGREES", default_value_t = OptimiseOptions::default().max_angle_degrees)]
    angle: f64,
    /// Largest MIPS energy of a middle triangle that a collapse may make (2 is an equilateral triangle)
    #[arg(long, value_name = "ENERGY", default_value_t = OptimiseOptions::default().max_energy)]
    energy: f64,
    /// Rounds of flips and smoothing at the end
    #[arg(long, value_name = "ROUNDS", default_value_t = OptimiseOptions::default().polish)]
    polish: usize,
    /// Keep the initial shell, whose middle surface is the mesh itself, refined
    #[arg(long)]
    pub(super) initial: bool,
    /// Stop optimising after so many seconds, with the valid shell reached by then; Ctrl-C does the same
    #[arg(long, value_name = "SECONDS")]
    pub(super) time_limit: Option<u64>,
    /// Another order of operations, with another result
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Number of threads (1 to 1024); default: all cores. The result does not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    checkpoint: checkpoint::Args,
    /// A shell that does not overlap itself, with the claim `disjoint-prisms` in its certificate
    #[arg(long, conflicts_with = "allow_self_intersections")]
    no_overlap: bool,
    /// Build around a mesh that intersects itself, too. The map is then one between abstract surfaces: C1 to C4 are
    /// certified, but neither `disjoint` nor `i2`
    #[arg(long, conflicts_with = "checkpoint")]
    pub(super) allow_self_intersections: bool,
    /// Enclose the largest distance from the middle surface to the mesh
    #[arg(long)]
    distance: bool,
    /// Write the shell without certifying it, and without checking
    #[arg(long)]
    no_certify: bool,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
    /// How progress is shown on standard error
    #[arg(long, value_name = "STYLE", value_enum, default_value_t)]
    progress: Style,
    /// No progress on standard error
    #[arg(short, long)]
    quiet: bool,
}

impl Args {
    pub(super) fn thickness(&self) -> Thickness {
        self.thickness_absolute.map_or(Thickness::Share(self.thickness), Thickness::Absolute)
    }

    /// The options of the optimisation, if they make sense.
    pub(super) fn options(&self) -> Result<OptimiseOptions, CliError> {
        let refuse = |what: &str| Err(CliError::Usage(what.to_owned()));
        let (name, value) = match self.thickness() {
            Thickness::Share(share) => ("--thickness", share),
            Thickness::Absolute(length) => ("--thickness-absolute", length),
        };
        if !(value.is_finite() && value > 0.0) {
            return refuse(&format!("{name}: a positive number is wanted"));
        }
        if !(self.angle > 0.0 && self.angle < 90.0) {
            return refuse("--angle: degrees between 0 and 90 are wanted");
        }
        if !(self.energy.is_finite() && self.energy >= 2.0) {
            return refuse("--energy: a number that is at least 2 is wanted");
        }
        Ok(OptimiseOptions {
            thickness: self.thickness(),
            max_energy: self.energy,
            max_angle_degrees: self.angle,
            polish: self.polish,
            time_limit: self.time_limit.map(Duration::from_secs),
            seed: self.seed,
            no_overlap: self.no_overlap,
        })
    }
}

/// A shell, and how it came about.
pub(super) struct Built {
    pub(super) shell: Shell,
    pub(super) first: Initial,
    pub(super) counts: Option<Counts>,
    pub(super) stopped: bool,
}

/// Runs the command.
pub(super) fn run(mut args: Args) -> Result<ExitCode, CliError> {
    let options = args.options()?;
    let json = Json::from_arguments(args.json.take(), &mut args.mesh);
    let path = args.mesh.take().ok_or_else(|| CliError::Usage("no mesh: give a mesh file".to_owned()))?;
    let certificate = beside(&args.output);
    may_write(&path, &args.output, &certificate, &json)?;
    let mut keeper = Keeper::new(&args.checkpoint, &others(&path, &args.output, &certificate, &json))?;
    super::threads(args.threads)?;
    let progress = Progress::styled(args.quiet, args.progress);
    let mut parts = Parts::default();
    let (read, seconds) = timed(|| mesh::read(&path));
    let read = read?;
    parts.read = seconds;
    let name = || path.display().to_string();
    let (built, seconds) = timed(|| build(&path, &read.mesh, (&args, &options), &mut keeper, &progress));
    let built = built?;
    parts.build = seconds;
    let stages = progress.stages();
    let outcome = if args.no_certify {
        None
    } else {
        let (outcome, seconds) = timed(|| proved(&built.shell, &read.mesh, claims(&args), name(), &progress));
        parts.certify = Some(seconds);
        Some(outcome?)
    };
    let mut notes = read.notes;
    let mut enclosed = None;
    if args.distance {
        let (found, seconds) = timed(|| measured(&built.shell, &read.mesh, name(), &progress));
        enclosed = found?;
        match enclosed {
            Some(_) => parts.distance = Some(seconds),
            None => notes.push("interrupted: the distance was not enclosed".to_owned()),
        }
    }
    progress.stage("writing", None);
    let file = ShellFile { shell: built.shell.clone(), mesh: Some(read.mesh), ..ShellFile::default() };
    parts.check = write(&file, outcome.as_ref(), &args.output, &certificate)?;
    if !built.stopped {
        keeper.remove()?;
    }
    drop(progress);
    let facts = Facts {
        args: &args,
        file: name(),
        notes,
        mesh: file.mesh.as_ref(),
        built: &built,
        outcome: outcome.as_ref(),
        distance: enclosed.as_ref(),
        certificate: &certificate,
        stages,
        parts,
    };
    let report = report(&facts)?;
    let mut words = words(&report);
    if args.allow_self_intersections {
        words.push_str(NOT_GUARANTEED);
    }
    json.emit(&report, &words)?;
    Ok(ExitCode::SUCCESS)
}

/// A result with the wall-clock seconds that it took.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let out = work();
    (out, start.elapsed().as_secs_f64())
}

fn may_write(mesh: &Path, shell: &Path, certificate: &Path, json: &Json) -> Result<(), CliError> {
    output::may_write(shell, &[mesh])?;
    output::may_write(certificate, &[mesh, shell])?;
    json.file().map_or(Ok(()), |file| output::may_write(file, &[mesh, shell, certificate]))
}

/// All files but the checkpoint.
fn others<'p>(mesh: &'p Path, shell: &'p Path, certificate: &'p Path, json: &'p Json) -> Vec<&'p Path> {
    [mesh, shell, certificate].into_iter().chain(json.file()).collect()
}

/// The certificate's file name.
fn beside(shell: &Path) -> PathBuf {
    let mut name = shell.as_os_str().to_owned();
    name.push(".cert");
    PathBuf::from(name)
}

/// From the checkpoint, if there is one. Its initial shell is built once more all the same: the report is about it, too.
fn build(
    path: &Path,
    mesh: &TriMesh,
    (args, options): (&Args, &OptimiseOptions),
    keeper: &mut Keeper<'_>,
    progress: &Progress,
) -> Result<Built, CliError> {
    let failed = |source| checkpoint::failed(path, source);
    let resumed = if args.initial { None } else { keeper.resumed(mesh, options)? };
    let allow_self_intersections = args.allow_self_intersections;
    let (thickness, no_overlap) = (options.thickness, options.no_overlap);
    let first = InitialOptions { thickness, allow_self_intersections, no_overlap };
    let first = initial(mesh, &first, progress).map_err(failed)?;
    progress.prisms(first.shell.faces.len() as u64);
    if args.initial {
        return Ok(Built { shell: first.shell.clone(), first, counts: None, stopped: false });
    }
    let mut work = match resumed {
        Some(work) => work,
        None if allow_self_intersections => {
            Optimiser::local(mesh, &first.shell, &first.origin, options).map_err(failed)?
        }
        None => Optimiser::new(mesh, &first.shell, options).map_err(failed)?,
    };
    keeper.save(&work)?;
    let stopped = work.run(progress, |work| keeper.save_if_due(work))?;
    keeper.save(&work)?;
    Ok(Built { shell: work.shell().map_err(failed)?, first, counts: Some(work.counts()), stopped })
}

/// The claims about the shell, with all that they rest on.
fn claims(args: &Args) -> Vec<Claim> {
    if args.allow_self_intersections {
        vec![Claim::SectionAllOrders]
    } else if args.no_overlap {
        Claim::ALL.to_vec()
    } else {
        Claim::STANDARD.to_vec()
    }
}

/// All claims, each certified: nothing else is written.
fn proved(
    shell: &Shell,
    mesh: &TriMesh,
    claims: Vec<Claim>,
    file: String,
    progress: &Progress,
) -> Result<Outcome, CliError> {
    // An interruption has ended the optimisation; what it left is still to be certified.
    let outcome =
        match certify(shell, Some(mesh), &Options { claims, ..Options::default() }, &Finishing(progress)) {
            Ok(outcome) => outcome,
            Err(source) => return Err(CliError::Certify { files: file, source }),
        };
    match outcome.claims.iter().flat_map(|c| &c.refutations).next() {
        None => Ok(outcome),
        Some(refuted) => Err(CliError::NotProved { file, reason: refuted.text.clone() }),
    }
}

/// The distance; `None` after Ctrl-C, which shall not lose the shell.
fn measured(
    shell: &Shell,
    mesh: &TriMesh,
    file: String,
    progress: &Progress,
) -> Result<Option<Distance>, CliError> {
    match distance(shell, mesh, progress) {
        Ok(found) => Ok(Some(found)),
        Err(BuildError::Certify(CertifyError::Cancelled)) => Ok(None),
        Err(source) => Err(CliError::Build { file, source: Box::new(source) }),
    }
}

/// Writes the shell and its certificate, if there is one, and puts them in place if the independent checker accepts what
/// was written; the seconds that it took.
fn write(
    file: &ShellFile,
    outcome: Option<&Outcome>,
    output: &Path,
    certificate: &Path,
) -> Result<Option<f64>, CliError> {
    let encode = |source| CliError::Encode { file: output.display().to_string(), source };
    let shell = Staged::new(output, &hdf5::to_bytes(file).map_err(encode)?)?;
    let Some(outcome) = outcome else {
        shell.place()?;
        return Ok(None);
    };
    let proof = Staged::new(certificate, outcome.certificate.as_bytes())?;
    let (accepted, seconds) = timed(|| accepted(&shell, &proof, output));
    accepted?;
    shell.place()?;
    proof.place()?;
    Ok(Some(seconds))
}

/// Lets the independent checker read both files back.
fn accepted(shell: &Staged, proof: &Staged, output: &Path) -> Result<(), CliError> {
    let answer = homeo_certs::check_files(proof.path(), &[shell.path()]);
    if answer.exit == 0 {
        return Ok(());
    }
    Err(CliError::NotAccepted { file: output.display().to_string(), answer: first_line(&answer) })
}

#[cfg(test)]
mod tests {
    use super::{CliError, Staged, beside, certify, write};
    use crate::certify::{Options, Silent};
    use crate::construct::sample;
    use crate::shell::hdf5::ShellFile;

    #[test]
    fn files_that_the_checker_does_not_accept_are_not_left() {
        let dir = tempfile::tempdir().unwrap();
        let (out, cert) = (dir.path().join("s.h5"), beside(&dir.path().join("s.h5")));
        let made = sample(0);
        let outcome = certify(&made.shell, Some(&made.mesh), &Options::default(), &Silent).unwrap();
        let mut file = ShellFile { shell: made.shell, mesh: Some(made.mesh), ..ShellFile::default() };
        file.shell.top[0][0] = file.shell.top[0][0].next_up();
        // What was there before stays.
        Staged::new(&out, b"before").unwrap().place().unwrap();
        let refused = write(&file, Some(&outcome), &out, &cert).unwrap_err();
        assert!(
            matches!(&refused, CliError::NotAccepted { answer, .. } if answer.starts_with("invalid hash")),
            "{refused}"
        );
        assert_eq!(std::fs::read(&out).unwrap(), b"before");
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1);
        file.shell.top[0][0] = file.shell.top[0][0].next_down();
        assert!(write(&file, Some(&outcome), &out, &cert).unwrap().is_some());
        assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2);
    }
}
