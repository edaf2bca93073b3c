//! What people and programs are told: JSON, sentences, and pages. No decisions are made here.

mod built;
mod certified;
mod html;
mod sentence;

pub use built::{
    BuildReport, DistanceReport, InputReport, OptionsReport, OutputReport, Parts, StageSeconds,
    ThicknessReport, Vertices, claims,
};
pub use certified::{
    CertifyReport, ClaimReport, MeshReport, PartReport, RefutationReport, ShellReport, StageReport,
};
pub use html::html;
pub use sentence::{Sources, sentence};
