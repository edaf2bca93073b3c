//! Fuzz targets as plain functions: each takes any bytes and panics exactly when something is wrong.
//!
//! `cargo fuzz run NAME --features libfuzzer` explores; `cargo test` runs the regressions and a bounded number of random
//! mutations on a stable toolchain.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // What a target panics about is what it finds.

mod checkers;
mod corpus;
mod python;
mod readers;
mod seeds;
mod shells;
mod signs;
mod source;

pub use checkers::{certificate, checkers, document};
pub use corpus::Corpus;
pub use readers::{complex, mesh, shell};
pub use seeds::{Random, seeds};
pub use shells::{projection, verdict};
pub use signs::signs;

/// A target.
pub type Target = fn(&[u8]);

/// All targets by name: `fuzz_targets/NAME.rs` is the libFuzzer entry, `regressions/NAME/` holds what once went wrong.
pub const TARGETS: [(&str, Target); 9] = [
    ("mesh", mesh),
    ("complex", complex),
    ("shell", shell),
    ("certificate", certificate),
    ("document", document),
    ("checkers", checkers),
    ("signs", signs),
    ("verdict", verdict),
    ("projection", projection),
];
