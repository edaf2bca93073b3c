//! Audits of cages (C7 and C7b).

use std::time::Instant;

use serde::{Deserialize, Serialize};

use super::documents::{self, Document, checked};
use super::error::AuditError;
use super::report::DocumentReport;
use crate::certify::nested::{ComponentFacts, component_facts, nested, nested_topology};
use crate::certify::{Observer, Verdict};
use crate::mesh::{Connectivity, TriMesh};

/// The answer about a cage.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct CageReport {
    /// Version of this structure: 1.
    pub format: u32,
    /// `nested` or `not nested` (both proved).
    pub verdict: String,
    /// The mesh's and the cage's file.
    pub files: [String; 2],
    /// Their triangles.
    pub triangles: [usize; 2],
    /// Reasons against nesting, of the first kind found: in words, and as the line of the document.
    pub reasons: Vec<[String; 2]>,
    /// Components of the mesh and of the cage; `null` unless nested.
    pub components: Option<[Vec<ComponentFacts>; 2]>,
    /// C7b, condition (ii) of *Nested Cages* section 1: `refuted` where the cage has more handles than the mesh, `not
    /// decided` where not, `not asked` where the cage is not nested.
    pub topology: String,
    /// Documents for the checkers.
    pub documents: Vec<DocumentReport>,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// An audit of a cage, and the files that prove it.
#[derive(Debug)]
pub struct CageAudit {
    /// The report.
    pub report: CageReport,
    /// Documents and their inputs, to be written into one directory.
    pub documents: Vec<Document>,
}

/// Is `mesh` nested in `cage` (C7), and has the cage handles that the mesh lacks (C7b)?
///
/// # Errors
/// [`AuditError`]: an interruption, an input without triangles, or a contradiction between certifier and checker.
pub fn cage(
    mesh: &TriMesh,
    cage: &TriMesh,
    files: [String; 2],
    observer: &dyn Observer,
) -> Result<CageAudit, AuditError> {
    let start = Instant::now();
    let inputs = [documents::off("mesh.off", mesh), documents::off("cage.off", cage)];
    let outcome = nested(mesh, cage, observer)?;
    let holds = outcome.verdict == Verdict::Certified;
    let says = if holds { "the mesh is nested in the cage" } else { "the mesh is not nested in the cage" };
    let [a, b] = &inputs;
    let mut found = vec![checked("nested.cert", outcome.certificate, says, &[a, b])?];
    let components = if holds { Some([facts("mesh", mesh)?, facts("cage", cage)?]) } else { None };
    let mut topology = if holds { "not decided" } else { "not asked" };
    if let Some([inner, outer]) = &components
        && let Some(text) = nested_topology(mesh, cage, [inner, outer])
    {
        topology = "refuted";
        let says = "the cage has handles that the mesh lacks: condition (ii) of Nested Cages fails";
        found.push(checked("nested-topology.cert", text, says, &[a, b])?);
    }
    let report = CageReport {
        format: 1,
        verdict: if holds { "nested" } else { "not nested" }.to_owned(),
        files,
        triangles: [mesh.faces.len(), cage.faces.len()],
        reasons: outcome.reasons.iter().map(|r| [r.sentence(), r.line()]).collect(),
        components,
        topology: topology.to_owned(),
        documents: found.iter().filter_map(Document::report).collect(),
        seconds: start.elapsed().as_secs_f64(),
    };
    Ok(CageAudit { report, documents: inputs.into_iter().chain(found).collect() })
}

fn facts(name: &'static str, mesh: &TriMesh) -> Result<Vec<ComponentFacts>, AuditError> {
    let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces)
        .map_err(|source| AuditError::Mesh { name, source: Box::new(source) })?;
    Ok(component_facts(mesh, &connectivity))
}

impl CageReport {
    /// In words.
    #[must_use]
    pub fn words(&self) -> String {
        let [mesh, cage] = &self.files;
        let mut out =
            format!("Mesh {mesh} ({} triangles), cage {cage} ({}).\n", self.triangles[0], self.triangles[1]);
        for [sentence, _] in self.reasons.iter().take(4) {
            out += &format!("    {sentence}\n");
        }
        if self.reasons.len() > 4 {
            out += &format!("    ... {} reasons in all\n", self.reasons.len());
        }
        let topology = match self.topology.as_str() {
            "refuted" => " The cage has handles that the mesh lacks: condition (ii) of Nested Cages fails.",
            "not decided" => {
                " Condition (ii) of Nested Cages is not refuted by counting handles, and not decided."
            }
            _ => "",
        };
        out + &format!("VERDICT  {}.{topology}\n", self.verdict)
    }
}
