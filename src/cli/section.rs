//! That a mesh is a section of a shell and the projection a bijection on it: proved here, or by a certificate.

use std::fmt;
use std::path::Path;

use serde_json::{Value, json};

use super::CliError;
use super::input::read_regular;
use super::output::one_line;
use crate::certify::{Claim, Options, Silent, Verdict, VertexOrder, certify};
use crate::mesh::TriMesh;
use crate::shell::{Shell, hdf5};

/// What shows the claim `bijection` of a mesh.
#[derive(Debug)]
pub(super) struct Proof {
    mesh: String,
    /// The file; none where the claim was certified on the spot.
    certificate: Option<String>,
}

impl Proof {
    pub(super) fn json(&self) -> Value {
        json!({"mesh": self.mesh, "claim": "bijection", "certificate": self.certificate})
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let how = self.certificate.as_deref().unwrap_or("certified now");
        write!(f, "CERTIFIED  bijection of {} ({how}; the independent checker accepts it)", self.mesh)
    }
}

/// Certifies `bijection`, or takes a certificate of it for this order; the independent checker has to accept it
/// either way. It is given the shell and the mesh as they were read, bit by bit, in the layout that it reads.
pub(super) fn prove(
    shell: &Shell,
    mesh: &TriMesh,
    name: &str,
    order: &VertexOrder,
    certificate: Option<&Path>,
) -> Result<Proof, CliError> {
    let refuse = |reason: String| CliError::Unproved { mesh: name.to_owned(), reason };
    let text = match certificate {
        Some(path) => {
            let text = read_regular(path)?;
            if !is_about(&text, order) {
                return Err(refuse("the certificate is about another vertex order".to_owned()));
            }
            text
        }
        None => certified(shell, mesh, name, order)?,
    };
    let copy =
        hdf5::ShellFile { shell: shell.clone(), mesh: Some(mesh.clone()), ..hdf5::ShellFile::default() };
    let bytes =
        hdf5::to_bytes(&copy).map_err(|source| CliError::Encode { file: "memory".to_owned(), source })?;
    let outcome = homeo_certs::check(&text, &[bytes]);
    let certificate = certificate.map(|p| one_line(&p.display().to_string()));
    if outcome.exit != 0 {
        let said = one_line(&format!("{} {} {}", outcome.status, outcome.code, outcome.message));
        return Err(match certificate {
            Some(_) => refuse(format!("the independent checker says `{said}` of the certificate")),
            None => CliError::Disagreement(said),
        });
    }
    if !outcome.claims.iter().any(|(claim, holds)| claim == Claim::Bijection.name() && *holds) {
        return Err(refuse("the certificate does not certify `bijection`".to_owned()));
    }
    Ok(Proof { mesh: name.to_owned(), certificate })
}

fn certified(shell: &Shell, mesh: &TriMesh, name: &str, order: &VertexOrder) -> Result<Vec<u8>, CliError> {
    let options = Options { claims: vec![Claim::Bijection], order: order.clone() };
    let outcome = certify(shell, Some(mesh), &options, &Silent)
        .map_err(|source| CliError::Certify { files: name.to_owned(), source })?;
    let failed = outcome.claims.iter().find(|c| c.verdict == Verdict::Refuted);
    match failed {
        None => Ok(outcome.certificate.into_bytes()),
        Some(claim) => {
            let reason = claim.refutations.first().map_or_else(String::new, |r| format!(": {}", r.text));
            Err(CliError::Unproved {
                mesh: name.to_owned(),
                reason: format!("`{}` is refuted{reason}", claim.claim),
            })
        }
    }
}

/// Does the certificate's `order` line name this order? The checker judges the rest of it.
fn is_about(certificate: &[u8], order: &VertexOrder) -> bool {
    let expected = match order {
        VertexOrder::Id => "order id".to_owned(),
        VertexOrder::List(list) => {
            list.iter().fold("order list".to_owned(), |text, id| text + " " + &id.to_string())
        }
    };
    let mut lines = certificate.split(|&b| b == b'\n').filter(|line| line.starts_with(b"order "));
    lines.next() == Some(expected.as_bytes()) && lines.next().is_none()
}
