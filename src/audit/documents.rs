//! Documents for the checkers, each accepted by the independent one before it is handed over.

use super::error::AuditError;
use super::report::DocumentReport;
use crate::mesh::{self, TriMesh};

/// A file that proves something.
#[derive(Clone, Debug)]
pub struct Document {
    /// Its name in the output directory.
    pub file: String,
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// What it says; empty for an input of other documents.
    pub says: String,
    /// Names of the inputs that the checkers need with it; empty for an input.
    pub arguments: Vec<String>,
}

impl Document {
    /// A file that other documents are about.
    pub(crate) fn input(file: &str, bytes: Vec<u8>) -> Self {
        Self { file: file.to_owned(), bytes, says: String::new(), arguments: Vec::new() }
    }

    /// The entry of the report; `None` for an input.
    pub(crate) fn report(&self) -> Option<DocumentReport> {
        (!self.says.is_empty()).then(|| DocumentReport {
            file: self.file.clone(),
            says: self.says.clone(),
            arguments: std::iter::once(self.file.clone()).chain(self.arguments.iter().cloned()).collect(),
            bytes: self.bytes.len(),
        })
    }
}

/// A document with what it says, checked against its inputs.
pub(crate) fn checked(
    file: &str,
    text: String,
    says: &str,
    inputs: &[&Document],
) -> Result<Document, AuditError> {
    let bytes: Vec<Vec<u8>> = inputs.iter().map(|d| d.bytes.clone()).collect();
    accepted(file, &homeo_certs::check(text.as_bytes(), &bytes))?;
    Ok(Document {
        file: file.to_owned(),
        bytes: text.into_bytes(),
        says: says.to_owned(),
        arguments: inputs.iter().map(|d| d.file.clone()).collect(),
    })
}

/// Anything but `valid` is a contradiction between the two programs and no verdict.
pub(crate) fn accepted(file: &str, answer: &homeo_certs::Outcome) -> Result<(), AuditError> {
    if answer.exit == 0 {
        return Ok(());
    }
    let answer = [answer.status, answer.code, answer.message.as_str()].join(" ");
    Err(AuditError::Disagreement { document: file.to_owned(), answer })
}

/// A mesh as an OFF file, which both checkers read and which keeps every bit. Meshes that come from readers are finite and
/// in range, but may be empty, which OFF holds, too.
pub(crate) fn off(file: &str, mesh: &TriMesh) -> Document {
    Document::input(file, mesh::write::off(mesh))
}

/// The bytes that stand for a mesh in keys of results: every bit of every coordinate, and all triangles.
#[must_use]
pub fn canonical(mesh: &TriMesh) -> Vec<u8> {
    off("", mesh).bytes
}
