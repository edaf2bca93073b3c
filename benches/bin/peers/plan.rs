//! What to measure, and how much of it.

use clap::{Parser, ValueEnum};
use homeo_benches::cgal::Cgal;

/// A part of the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Part {
    /// Single calls of orient3d
    Orient3d,
    /// Batched orient3d, streamed and indexed, at every level of vector instructions
    Batch,
    /// Claim C1 on generated and real shells
    Positivity,
    /// Projection of a point, exact and in f64
    Projection,
    /// All claims against a CGAL program; two threads against one; check against certify
    Whole,
    /// Check against certify on real shells (needs the data)
    Real,
    /// Time and memory of certify and check against the size
    Growth,
    /// Memory of the checker on a certificate of 1 GB
    Long,
    /// Decisions and time by stage
    Stages,
}

/// Measures homeo beside its peers, turn by turn in one run. Writes benches/peers.json, benches/peers.svg and a section of
/// benches/RESULTS.md; with --quick, --only or --max-triangles only files of these names in target/peers
#[derive(Debug, Parser)]
#[command(name = "homeo-peers")]
pub(crate) struct Options {
    /// Rounds of short measurements; whole runs have a fifth of them
    #[arg(long, value_name = "N", default_value_t = 15)]
    pub(crate) rounds: usize,
    /// Small inputs: to see that everything runs
    #[arg(long)]
    pub(crate) quick: bool,
    /// Only these parts
    #[arg(long, value_name = "PART", value_enum, value_delimiter = ',')]
    pub(crate) only: Vec<Part>,
    /// The largest input of `growth`
    #[arg(long, value_name = "N")]
    pub(crate) max_triangles: Option<u32>,
}

impl Options {
    /// Is this the whole comparison?
    pub(crate) fn whole(&self) -> bool {
        !self.quick && self.only.is_empty() && self.max_triangles.is_none()
    }

    pub(crate) fn wants(&self, part: Part) -> bool {
        self.only.is_empty() || self.only.contains(&part)
    }

    /// One of two sizes.
    pub(crate) fn size<T>(&self, full: T, quick: T) -> T {
        if self.quick { quick } else { full }
    }

    /// Rounds of a whole run of the certifier: a fifth, at least one.
    pub(crate) fn few_rounds(&self) -> usize {
        (self.rounds / 5).max(1)
    }
}

/// The options, and the CGAL programs if they could be built.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) options: Options,
    pub(crate) cgal: Option<Cgal>,
}

/// What a row says where the CGAL programs are not there.
pub(crate) const NOT_BUILT: &str = "not built";
