//! What people and programs are told: JSON, sentences, and pages. No decisions are made here.

mod certified;
mod html;
mod sentence;

pub use certified::{
    CertifyReport, ClaimReport, MeshReport, PartReport, RefutationReport, ShellReport, StageReport,
};
pub use html::html;
pub use sentence::{Sources, sentence};
