//! Compares homeo with CGAL: predicates, projections, whole shells, self-intersections of meshes. Equal answers, equal
//! numbers, equal rationals; there is no tolerance. Exit 1 on any disagreement, 2 on an error.

mod cases;
mod findings;
mod meshes;
mod predicates;
mod projections;
mod shells;

use std::error::Error;
use std::process::ExitCode;

use clap::Parser;
use homeo_benches::cgal::Cgal;

use findings::Findings;

/// A part of the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    Predicates,
    Projections,
    Shells,
    Meshes,
}

/// Compares homeo with CGAL. Quick by default; the data are those of $HOMEO_DATA, else ../shared/data.
#[derive(Debug, Parser)]
#[command(name = "homeo-cross-validate")]
struct Options {
    /// Cases of predicates compared with EPICK, in all
    #[arg(long, value_name = "N", default_value_t = 400_000)]
    cases: usize,
    /// Cases of predicates compared with EPECK, in all
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    exact_cases: usize,
    /// Points projected by CGAL's exact constructions, with EPECK and with Gmpq
    #[arg(long, value_name = "N", default_value_t = 10_000)]
    projections: usize,
    /// The numbers of the campaign: 10 million cases, 2 million with EPECK, 1 million projections
    #[arg(long, conflicts_with_all = ["cases", "exact_cases", "projections"])]
    full: bool,
    /// Seed of all cases and points
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Only these parts
    #[arg(long, value_name = "PART", value_enum, value_delimiter = ',')]
    only: Vec<Part>,
}

fn main() -> ExitCode {
    let mut options = Options::parse();
    if options.full {
        (options.cases, options.exact_cases, options.projections) = (10_000_000, 2_000_000, 1_000_000);
    }
    let Some(cgal) = Cgal::build(&[]) else {
        // Nothing was compared: that is no success.
        eprintln!("no CGAL, so nothing was compared");
        return ExitCode::from(3);
    };
    let mut findings = Findings::default();
    if let Err(error) = run(&options, &cgal, &mut findings) {
        eprintln!("error: {error}");
        return ExitCode::from(2);
    }
    println!("{} disagreements", findings.count());
    ExitCode::from(u8::from(findings.count() > 0))
}

fn run(options: &Options, cgal: &Cgal, findings: &mut Findings) -> Result<(), Box<dyn Error>> {
    let wants = |part| options.only.is_empty() || options.only.contains(&part);
    if wants(Part::Predicates) {
        predicates::run(cgal, options.cases, options.exact_cases, options.seed, findings)?;
    }
    if wants(Part::Projections) {
        projections::run(cgal, options.projections, options.seed, findings)?;
    }
    if wants(Part::Shells) {
        shells::run(cgal, findings)?;
    }
    if wants(Part::Meshes) {
        meshes::run(cgal, findings)?;
    }
    Ok(())
}
