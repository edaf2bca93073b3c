//! Cases: named, seeded, mixed.

mod float;
mod lattice;
mod mesh;
mod scale;

use std::fmt;
use std::str::FromStr;

use super::Predicate;
use super::random::Random;
use super::symmetry::{self, Symmetry};

pub use mesh::Pool;

/// Where cases come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Generator {
    /// Coordinates uniform in `[-1, 1)`.
    Uniform,
    /// Integers from -4 to 4.
    Grid,
    /// A degenerate case with some coordinates moved by 0, 1 or 2 ulps.
    Near,
    /// Exactly degenerate by construction: affine combinations on a dyadic grid, lattice points of a circle.
    Degenerate,
    /// Another case with coordinates, points or axes multiplied by very different powers of two.
    Spread,
    /// Coordinates below `2^-1022`, or such mixed with others.
    Subnormal,
    /// Coordinates so large that their differences overflow.
    Overflow,
    /// Points and coordinates that coincide.
    Shared,
    /// One configuration in several orders: the answers must agree, whatever the truth is.
    Permutations,
    /// Points of meshes.
    Real,
    /// Other cases brought to size one, and multiplied by each power of two in turn.
    Sweep,
}

/// A text that names no generator.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "there is no generator `{0}`: uniform, grid, near, degenerate, spread, subnormal, overflow, shared, permutations, \
         real, sweep are wanted"
)]
pub struct UnknownGenerator(pub String);

impl Generator {
    /// All of them.
    pub const ALL: [Self; 11] = [
        Self::Uniform,
        Self::Grid,
        Self::Near,
        Self::Degenerate,
        Self::Spread,
        Self::Subnormal,
        Self::Overflow,
        Self::Shared,
        Self::Permutations,
        Self::Real,
        Self::Sweep,
    ];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Grid => "grid",
            Self::Near => "near",
            Self::Degenerate => "degenerate",
            Self::Spread => "spread",
            Self::Subnormal => "subnormal",
            Self::Overflow => "overflow",
            Self::Shared => "shared",
            Self::Permutations => "permutations",
            Self::Real => "real",
            Self::Sweep => "sweep",
        }
    }
}

impl fmt::Display for Generator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Generator {
    type Err = UnknownGenerator;

    fn from_str(name: &str) -> Result<Self, UnknownGenerator> {
        Self::ALL.into_iter().find(|g| g.name() == name).ok_or_else(|| UnknownGenerator(name.to_owned()))
    }
}

/// Where a case comes from: a generator, and for those that change the cases of others also the other one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
pub struct Origin {
    /// The generator.
    pub generator: Generator,
    /// Whose case it changed; its own name if it changed none.
    pub base: Generator,
}

impl Origin {
    const fn of(generator: Generator) -> Self {
        Self { generator, base: generator }
    }

    /// What failures are counted by: the base says something about a failure in the sweep alone.
    pub(super) const fn row(self) -> Self {
        match self.generator {
            Generator::Sweep => self,
            generator => Self::of(generator),
        }
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.generator == self.base {
            return self.generator.fmt(f);
        }
        write!(f, "{}/{}", self.generator, self.base)
    }
}

impl FromStr for Origin {
    type Err = UnknownGenerator;

    fn from_str(name: &str) -> Result<Self, UnknownGenerator> {
        match name.split_once('/') {
            Some((generator, base)) => Ok(Self { generator: generator.parse()?, base: base.parse()? }),
            None => name.parse().map(Self::of),
        }
    }
}

/// Cases one after the other.
#[derive(Clone, Debug, Default)]
pub(super) struct Batch {
    /// The cases' coordinates.
    pub(super) coordinates: Vec<f64>,
    /// One origin a case.
    pub(super) origins: Vec<Origin>,
    /// Cases that are images of earlier ones: index, index of the earlier one, and how.
    pub(super) images: Vec<(usize, usize, Symmetry)>,
}

/// The prism over the unit triangle, `lo` first.
const UNIT_PRISM: [[f64; 3]; 6] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];

/// Images of a configuration in [`Generator::Permutations`].
const IMAGES: usize = 3;

/// An endless, reproducible stream of cases.
#[derive(Debug)]
pub(super) struct Source<'a> {
    predicate: Predicate,
    generators: Vec<Generator>,
    random: Random,
    /// Turns so far; each is a case or a configuration with its images.
    turns: usize,
    pool: &'a Pool,
}

impl<'a> Source<'a> {
    /// Mixes `generators` evenly. [`Generator::Real`] without meshes gives uniform cases.
    pub(super) fn new(predicate: Predicate, generators: &[Generator], seed: u64, pool: &'a Pool) -> Self {
        Self { predicate, generators: generators.to_vec(), random: Random(seed), turns: 0, pool }
    }

    /// The next `count` cases. A configuration at the end of the batch may have fewer images.
    pub(super) fn batch(&mut self, count: usize) -> Batch {
        let mut out = Batch::default();
        while out.origins.len() < count {
            let room = count - out.origins.len() - 1;
            let generator = self.generators.get(self.turns % self.generators.len().max(1));
            let generator = generator.copied().unwrap_or(Generator::Uniform);
            let images = if generator == Generator::Permutations { IMAGES.min(room) } else { 0 };
            let round = self.turns / self.generators.len().max(1);
            let (origin, case) = self.case(generator, round);
            let first = out.origins.len();
            for i in 0..images {
                let symmetry = symmetry::random(self.predicate, &mut self.random);
                out.images.push((first + 1 + i, first, symmetry));
            }
            out.coordinates.extend(&case);
            out.origins.push(origin);
            let fresh = out.images.len() - images;
            for (_, _, symmetry) in &out.images[fresh..] {
                out.coordinates.extend(symmetry.image(&case, self.predicate.dimension()));
                out.origins.push(origin);
            }
            self.turns += 1;
        }
        out
    }

    /// A case that the predicate accepts.
    fn case(&mut self, generator: Generator, round: usize) -> (Origin, Vec<f64>) {
        for _ in 0..32 {
            let (base, case) = self.propose(generator, round);
            if self.predicate.accepts(&case) {
                return (Origin { generator, base }, case);
            }
        }
        loop {
            // Accepted but for a set of measure zero.
            let case = float::uniform(self.predicate, &mut self.random);
            if self.predicate.accepts(&case) {
                return (Origin { generator, base: Generator::Uniform }, case);
            }
        }
    }

    fn propose(&mut self, generator: Generator, round: usize) -> (Generator, Vec<f64>) {
        match generator {
            Generator::Spread => {
                let (base, case) = self.one_of(&[
                    Generator::Uniform,
                    Generator::Degenerate,
                    Generator::Near,
                    Generator::Grid,
                ]);
                (base, scale::spread(self.predicate, case, &mut self.random))
            }
            Generator::Permutations => {
                let any = [
                    Generator::Uniform,
                    Generator::Grid,
                    Generator::Near,
                    Generator::Degenerate,
                    Generator::Spread,
                    Generator::Subnormal,
                    Generator::Overflow,
                    Generator::Shared,
                    Generator::Sweep,
                ];
                let base = any[self.random.below(any.len())];
                let round = self.random.below(1 << 20);
                (base, self.propose(base, round).1)
            }
            Generator::Sweep => {
                let bases = [Generator::Degenerate, Generator::Near, Generator::Uniform];
                let base = bases[round % bases.len()];
                let case = self.propose(base, round).1;
                (base, scale::swept(case, round / bases.len()))
            }
            plain => (plain, self.plain(plain)),
        }
    }

    fn one_of(&mut self, generators: &[Generator]) -> (Generator, Vec<f64>) {
        let generator = generators[self.random.below(generators.len())];
        (generator, self.plain(generator))
    }

    /// A case of a generator that changes no other one's.
    fn plain(&mut self, generator: Generator) -> Vec<f64> {
        let (predicate, random) = (self.predicate, &mut self.random);
        match generator {
            Generator::Grid => float::grid(predicate, random),
            Generator::Near => float::near(predicate, random),
            Generator::Degenerate => lattice::degenerate(predicate, random),
            Generator::Subnormal => float::subnormal(predicate, random),
            Generator::Overflow => float::overflow(predicate, random),
            Generator::Shared => float::shared(predicate, random),
            Generator::Real => {
                self.pool.case(predicate, random).unwrap_or_else(|| float::uniform(predicate, random))
            }
            _ => float::uniform(predicate, random),
        }
    }
}
