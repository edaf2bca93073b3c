//! `homeo fuzz`.

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

use super::CliError;
use super::input::read_regular;
use super::output::{self, Json};
use super::progress::{Progress, Style};
use crate::fuzz::{
    self, BuiltIn, Flipped, Generator, Limit, Mode, Options, Pool, Predicate, Process, ProcessOptions,
    Report, Subject, SubjectError, corpus,
};
use crate::mesh;

/// Seconds of a run that says nothing about its length.
const SECONDS: f64 = 60.0;

/// Arguments of `homeo fuzz`.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The predicate: orient2d, orient3d, incircle, insphere, dot_sign, point_in_tet, triangle_triangle,
    /// segment_triangle, ray_triangle, prism_positivity, section_dot (docs/SUBJECTS.md)
    predicate: Predicate,
    /// What to judge: geometry-predicates, robust, geogram, f64, fast, or a command in the protocol of docs/SUBJECTS.md
    #[arg(long, value_name = "NAME|CMD")]
    subject: String,
    /// Talk to the command in batches of doubles
    #[arg(long)]
    binary: bool,
    /// The subject has the opposite convention: negate its signs
    #[arg(long)]
    flip: bool,
    /// How long to run (default 60)
    #[arg(long, conflicts_with = "cases")]
    seconds: Option<f64>,
    /// How many cases to ask, in place of a time
    #[arg(long)]
    cases: Option<u64>,
    /// Seed of all that is random
    #[arg(long, default_value_t = 0)]
    seed: u64,
    /// Generators to mix (default: all; `real` needs --mesh): uniform, grid, near, degenerate, spread, subnormal, overflow,
    /// shared, permutations, real, sweep
    #[arg(long, value_delimiter = ',')]
    generators: Vec<Generator>,
    /// A mesh that gives points to the generator `real`; may be repeated
    #[arg(long = "mesh", value_name = "FILE")]
    meshes: Vec<PathBuf>,
    /// Seconds without an answer after which a command counts as hung; with --binary a millisecond more a case of the batch
    #[arg(long, value_name = "SECONDS", default_value_t = 2.0)]
    timeout: f64,
    /// Ask the cases of a corpus file again, and no others
    #[arg(long, value_name = "FILE", conflicts_with_all = ["seconds", "cases", "generators", "meshes"])]
    replay: Option<PathBuf>,
    /// Directory for corpus.txt, table.txt and report.json
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// JSON to a file, or in place of the words to standard output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    json: Option<PathBuf>,
    /// How progress is shown on standard error
    #[arg(long, value_enum, default_value_t = Style::Auto)]
    progress: Style,
    /// No progress
    #[arg(short, long)]
    quiet: bool,
}

/// Runs the command: 0 if all answers were right, 1 if not.
pub(super) fn run(args: &Args) -> Result<ExitCode, CliError> {
    let json = Json::of(args.json.clone());
    let inputs: Vec<&Path> = args.meshes.iter().chain(&args.replay).map(PathBuf::as_path).collect();
    if let Some(file) = json.file() {
        output::may_write(file, &inputs)?;
    }
    let files = targets(args.output.as_deref(), &inputs)?;
    let mut subject = subject(args)?;
    quiet_about_findings();
    let report = match &args.replay {
        Some(file) => replay(subject.as_mut(), args.predicate, file)?,
        None => {
            let options = options(args)?;
            let progress = Progress::styled(args.quiet, args.progress);
            fuzz::run(subject.as_mut(), &options, &progress).map_err(CliError::Subject)?
        }
    };
    if report.cases == 0 {
        return Err(CliError::Usage("no case was asked, so there is nothing to say".to_owned()));
    }
    if let Some([corpus, table, whole]) = &files {
        output::replace(corpus, corpus::write(&report).as_bytes())?;
        output::replace(table, report.words().as_bytes())?;
        output::replace(whole, output::json(&report)?.as_bytes())?;
    }
    json.emit(&report, &report.words())?;
    Ok(ExitCode::from(u8::from(!report.is_clean())))
}

/// A subject's panic is a finding and is told in the report, not thousands of times on standard error.
fn quiet_about_findings() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !fuzz::asking() {
            usual(panic);
        }
    }));
}

/// The three files of `--output`, in a directory that is made if need be.
fn targets(directory: Option<&Path>, inputs: &[&Path]) -> Result<Option<[PathBuf; 3]>, CliError> {
    let Some(directory) = directory else { return Ok(None) };
    std::fs::create_dir_all(directory)
        .map_err(|e| CliError::Write { file: directory.display().to_string(), reason: e.to_string() })?;
    let files = ["corpus.txt", "table.txt", "report.json"].map(|name| directory.join(name));
    for file in &files {
        output::may_write(file, inputs)?;
    }
    Ok(Some(files))
}

fn seconds(value: f64, option: &str) -> Result<Duration, CliError> {
    Duration::try_from_secs_f64(value)
        .map_err(|_| CliError::Usage(format!("{option}: {value} is no number of seconds")))
}

fn subject(args: &Args) -> Result<Box<dyn Subject>, CliError> {
    let subject: Box<dyn Subject> = match args.subject.parse::<BuiltIn>() {
        Ok(_) if args.binary => {
            return Err(CliError::Usage(format!("--binary: {} is built in, not a command", args.subject)));
        }
        Ok(subject) => Box::new(subject),
        Err(_) => {
            let options = ProcessOptions {
                mode: if args.binary { Mode::Binary } else { Mode::Text },
                timeout: seconds(args.timeout, "--timeout")?,
                ..ProcessOptions::default()
            };
            Box::new(Process::new(&args.subject, options).map_err(CliError::Subject)?)
        }
    };
    Ok(if args.flip { Box::new(Flipped(subject)) } else { subject })
}

fn options(args: &Args) -> Result<Options, CliError> {
    let limit = match args.cases {
        Some(cases) => Limit::Cases(cases),
        None => Limit::Time(seconds(args.seconds.unwrap_or(SECONDS), "--seconds")?),
    };
    let mut meshes = Vec::new();
    for file in &args.meshes {
        meshes.push(mesh::read(file)?.mesh);
    }
    let meshes = Pool::new(meshes);
    if meshes.is_empty() && !args.meshes.is_empty() {
        return Err(CliError::Usage("--mesh: there are no triangles to take points from".to_owned()));
    }
    let mut generators = args.generators.clone();
    if generators.is_empty() {
        generators.extend(Generator::ALL.into_iter().filter(|g| *g != Generator::Real || !meshes.is_empty()));
    } else if generators.contains(&Generator::Real) && meshes.is_empty() {
        return Err(CliError::Usage("the generator `real` needs --mesh FILE".to_owned()));
    }
    Ok(Options { predicate: args.predicate, generators, seed: args.seed, limit, meshes })
}

fn replay(subject: &mut dyn Subject, predicate: Predicate, file: &Path) -> Result<Report, CliError> {
    let refuse = |reason: String| CliError::Read { file: file.display().to_string(), reason };
    let bytes = read_regular(file)?;
    let text = String::from_utf8(bytes).map_err(|e| refuse(e.to_string()))?;
    let entries = corpus::read(&text).map_err(|e| refuse(e.to_string()))?;
    if !entries.iter().any(|entry| entry.predicate == predicate) {
        return Err(refuse(format!("there is no case of {predicate}")));
    }
    fuzz::replay(subject, predicate, &entries).map_err(CliError::Subject)
}

/// What a user who misspelt a built-in subject needs to know.
pub(super) fn explain(error: &SubjectError) -> String {
    match error {
        SubjectError::Start { .. } => {
            let names: Vec<&str> = BuiltIn::ALL.iter().map(|s| BuiltIn::name(*s)).collect();
            format!("{error} (built in: {})", names.join(", "))
        }
        other => other.to_string(),
    }
}
