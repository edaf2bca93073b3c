//! What people and programs are told: JSON, and sentences. No decisions are made here.

mod certified;
mod sentence;

pub use certified::{
    CertifyReport, ClaimReport, MeshReport, PartReport, RefutationReport, ShellReport, StageReport,
};
pub use sentence::{Sources, sentence};
