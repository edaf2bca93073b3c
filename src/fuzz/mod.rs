//! A judge for any implementation of geometric predicates.
//!
//! [`run`] makes cases (plain, nearly and exactly degenerate, tiny, huge, mixed, taken from meshes), asks a [`Subject`], and
//! compares its answers with [`judge`], which decides by big integers and is exact for all finite doubles. Wrong answers are
//! classed ([`Class`]), collected, and shrunk to cases with few bits; a sweep over all powers of two tells at which
//! magnitudes they begin. `docs/SUBJECTS.md` defines the predicates, and the protocol for subjects that are programs.
//!
//! ```
//! use homeo::certify::Silent;
//! use homeo::fuzz::{self, Answer, Class, Limit, Options, Predicate};
//!
//! // Orientation in the plane with plain doubles.
//! let mut naive = fuzz::from_fn("naive", |_, x| {
//!     Answer::of_value((x[2] - x[0]) * (x[5] - x[1]) - (x[3] - x[1]) * (x[4] - x[0]))
//! });
//! let options = Options { limit: Limit::Cases(20_000), ..Options::new(Predicate::Orient2d) };
//! let report = fuzz::run(&mut naive, &options, &Silent)?;
//! assert!(report.onsets.iter().any(|row| row.class == Class::Nan && row.above.is_some()));
//! println!("{}", report.words());
//!
//! // What this library decides with.
//! let clean = fuzz::run(&mut fuzz::BuiltIn::Fast, &options, &Silent)?;
//! assert!(clean.is_clean());
//! # Ok::<(), fuzz::SubjectError>(())
//! ```

mod answer;
mod bits;
mod campaign;
pub mod corpus;
mod finding;
mod generate;
mod hex;
mod judge;
mod onset;
mod points;
mod predicate;
pub(crate) mod random;
mod report;
mod shrink;
mod subject;
mod symmetry;
#[cfg(test)]
mod tests;

pub use answer::{Answer, Class};
pub use campaign::{Limit, Options, replay, run};
pub use finding::Finding;
pub use generate::{Generator, Origin, Pool, UnknownGenerator};
pub use judge::judge;
pub use onset::Onset;
pub use predicate::{Predicate, UnknownPredicate};
pub use report::{OriginCount, Report};
pub use subject::{
    BuiltIn, Flipped, Function, Mode, Pace, Process, ProcessOptions, Subject, SubjectError, UnknownSubject,
    asking, from_fn,
};
pub use symmetry::Symmetry;
