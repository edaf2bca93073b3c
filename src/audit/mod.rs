//! Audits of remeshed surfaces: is there a certified homeomorphism from A to B, and if not, why not?
//!
//! [`audit()`] goes through the stages that a person would: are both inputs valid ([`validity`]), have they the same
//! topology ([`topology`]), is there a shell of which both are sections ([`attempt`]; that is C5: `P_B^-1 P_A` is a
//! homeomorphism), and where is a mesh no section ([`places`], grouped into regions). Verdicts are `bijective` and
//! `not homeomorphic`, each with a proof, `invalid input`, and `not certified`, which says what was tried and where each
//! try failed, and proves nothing. [`cage()`] audits a cage (C7).
//!
//! Everything that a viewer needs is in [`AuditReport`]; proofs and witnesses are [`Document`]s for the checkers.

pub mod attempt;
pub mod batch;
pub mod cage;
mod distance;
mod documents;
mod error;
pub mod joint;
pub mod junit;
mod options;
mod orientation;
pub mod places;
mod point;
mod regions;
pub mod report;
mod run;
mod sha;
pub mod topology;
pub mod validity;
pub mod vtu;
mod words;

#[cfg(test)]
mod tests;

pub use cage::cage;
pub use documents::{Document, canonical};
pub use error::AuditError;
pub use options::{AuditOptions, Try};
pub use point::ExactPoint;
pub use report::{AuditReport, AuditVerdict};
pub use run::{Audit, Subject, audit};
pub use words::words;
