//! Proofs and refutations of the claims C1-C6 about a shell and a mesh (THEORY section 2).
//!
//! [`certify`] decides every requested claim: *certified* or *refuted*, never a third answer, and writes one file that
//! proves all its verdicts: certificates for what holds, witnesses for what does not. The file is checked by
//! `homeo-check` and by `reference/check.py`; its format is `certs/FORMAT.md`. [`prove`] does the same, but leaves it to the caller where
//! the file is written to.

mod ahead;
mod claim;
mod clip;
pub(crate) mod complex;
pub(crate) mod coverage;
pub(crate) mod disjoint;
mod error;
pub(crate) mod exact;
pub(crate) mod i2;
pub(crate) mod lift;
pub mod nested;
mod observer;
mod orders;
pub(crate) mod pairs;
pub(crate) mod path;
pub mod pl;
pub(crate) mod point;
pub(crate) mod polygon;
pub(crate) mod positivity;
pub(crate) mod prisms;
mod proof;
mod results;
mod section;
mod separate;
pub(crate) mod survey;
mod witness;
pub(crate) mod write;

#[cfg(test)]
mod tests;

pub use crate::shell::{OrderError, VertexOrder};
pub use claim::{Claim, Part, Verdict};
pub use disjoint::{About, Crossing, self_intersections};
pub use error::CertifyError;
pub use i2::{Contact, ContactSeparation};
pub use observer::{Observer, Silent};
pub use prisms::Overlap;
pub use proof::{ClaimResult, Count, Options, Outcome, Proof, Refutation, certify, prove};
pub use separate::{PlaneName, PointName};
pub use witness::{BadTet, Branch, Ending, Leg, NoLift, Root, Step};
pub(crate) use write::{mesh_hash, shell_hash};
