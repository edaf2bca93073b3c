//! The stages of an audit in their order.

use std::time::Instant;

use super::attempt::Pair;
use super::documents::{self, Document, checked};
use super::error::AuditError;
use super::options::{AuditOptions, Try};
use super::orientation;
use super::report::{AttemptReport, AttemptResult, AuditReport, AuditVerdict, Timing, TopologyReport};
use super::topology;
use super::validity::{Validity, validity};
use crate::certify::nested::{component_facts, manifold, same_topology};
use crate::certify::pl::{self, PlError};
use crate::certify::{CertifyError, Observer, Verdict};
use crate::mesh::{Connectivity, TriMesh};
use crate::shell::Shell;

#[cfg(test)]
mod tests;

/// A mesh under audit.
#[derive(Clone, Debug)]
pub struct Subject<'a> {
    /// `A` or `B`.
    pub name: &'static str,
    /// What its file is called in reports.
    pub file: String,
    /// The mesh: finite coordinates, indices in range.
    pub mesh: &'a TriMesh,
}

/// The answer, and the files that prove it.
#[derive(Debug)]
pub struct Audit {
    /// The report.
    pub report: AuditReport,
    /// Documents and their inputs, to be written into one directory.
    pub documents: Vec<Document>,
}

/// Audits a pair: A is the original, B the remeshed surface.
///
/// The time is that of building and optimising a shell for each try; other stages are linear up to logarithms in the
/// sizes of meshes and overlays.
///
/// # Errors
/// [`AuditError`]: an interruption, or a contradiction between certifier and checker. Never a verdict.
pub fn audit(
    subjects: &[Subject<'_>; 2],
    shell: Option<&Shell>,
    options: &AuditOptions,
    observer: &dyn Observer,
) -> Result<Audit, AuditError> {
    let start = Instant::now();
    let options = &options.for_pair(subjects.each_ref().map(|s| s.mesh.faces.len()));
    let mut work = Work::default();
    let files = ["a.off", "b.off"].into_iter().zip(subjects).map(|(file, s)| documents::off(file, s.mesh));
    work.documents = files.collect();
    let first = validity(&subjects[0], observer)?;
    let second = validity(&subjects[1], observer)?;
    work.lap("validity");
    let verdict = match (&first.connectivity, &second.connectivity) {
        (Some(a), Some(b)) => work.valid(subjects, [a, b], shell, options, observer)?,
        _ => work.invalid(subjects, [&first, &second], observer)?,
    };
    let report = AuditReport {
        format: 1,
        verdict,
        summary: work.summary,
        inputs: [first.report, second.report],
        topology: work.topology,
        attempts: work.attempts,
        documents: work.documents.iter().filter_map(Document::report).collect(),
        options: options.clone(),
        stages: work.stages,
        seconds: start.elapsed().as_secs_f64(),
    };
    Ok(Audit { report, documents: work.documents })
}

struct Work {
    documents: Vec<Document>,
    topology: Option<TopologyReport>,
    attempts: Vec<AttemptReport>,
    stages: Vec<Timing>,
    summary: String,
    since: Instant,
}

impl Default for Work {
    fn default() -> Self {
        Self {
            documents: Vec::new(),
            topology: None,
            attempts: Vec::new(),
            stages: Vec::new(),
            summary: String::new(),
            since: Instant::now(),
        }
    }
}

/// The document that refutes `embedded` of a mesh whose only fault are crossings, else `manifold`, and the claim's name;
/// `None` for a mesh that no document can be about: one without triangles, or with indices or coordinates that are none.
fn witness(
    mesh: &TriMesh,
    only_crossings: bool,
    observer: &dyn Observer,
) -> Result<Option<(&'static str, String)>, AuditError> {
    if only_crossings {
        let found = pl::embedded(&mesh.clone().into(), observer)?;
        return match found.verdict {
            Verdict::Refuted => Ok(Some(("embedded", found.certificate))),
            Verdict::Certified => {
                Err(CertifyError::Internal { what: "two searches for self-intersections differ" }.into())
            }
        };
    }
    match manifold(mesh) {
        Ok((found, text)) => Ok(found.map(|_| ("manifold", text))),
        Err(PlError::NoCells | PlError::Index { .. } | PlError::NotFinite { .. }) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

impl Work {
    fn lap(&mut self, stage: &str) {
        let seconds = self.since.elapsed().as_secs_f64();
        self.stages.push(Timing { stage: stage.to_owned(), seconds });
        self.since = Instant::now();
    }

    /// A witness for each input that is no embedded oriented manifold.
    fn invalid(
        &mut self,
        subjects: &[Subject<'_>; 2],
        found: [&Validity; 2],
        observer: &dyn Observer,
    ) -> Result<AuditVerdict, AuditError> {
        let mut reasons = Vec::new();
        for (i, (subject, validity)) in subjects.iter().zip(found).enumerate() {
            let report = &validity.report;
            if report.valid {
                continue;
            }
            let (defects, crossings) = (report.defects.len(), report.self_intersections.len());
            let first = report.defects.first().map(|d| d.text.clone()).or_else(|| {
                let [s, t] = report.self_intersections.first()?.triangles;
                Some(format!("triangles {s} and {t} intersect"))
            });
            let name = subject.name;
            reasons.push(format!(
                "{name} has {defects} defects and {crossings} pairs of intersecting triangles; first: {}",
                first.unwrap_or_default()
            ));
            let letter = ["a", "b"][i];
            let witness = witness(subject.mesh, defects == 0, observer)?;
            if let (Some((claim, text)), Some(input)) = (witness, self.documents.get(i).cloned()) {
                let says = format!("{name}: `{claim}` is refuted");
                self.documents.push(checked(&format!("{letter}.{claim}.cert"), text, &says, &[&input])?);
            }
        }
        self.summary = format!("invalid input: {}.", reasons.join("; "));
        Ok(AuditVerdict::InvalidInput)
    }

    fn valid(
        &mut self,
        subjects: &[Subject<'_>; 2],
        connectivity: [&Connectivity; 2],
        shell: Option<&Shell>,
        options: &AuditOptions,
        observer: &dyn Observer,
    ) -> Result<AuditVerdict, AuditError> {
        observer.stage("topology", None);
        let facts = [0, 1].map(|i| component_facts(subjects[i].mesh, connectivity[i]));
        let (verdict, text) = same_topology(subjects[0].mesh, subjects[1].mesh, [&facts[0], &facts[1]]);
        let [a, b] = facts;
        let compared = topology::compare(a, b);
        if compared.same != (verdict == Verdict::Certified) {
            return Err(CertifyError::Internal { what: "two comparisons of topology differ" }.into());
        }
        let says = format!("A and B: `same-topology` is {verdict}");
        let document = match &self.documents[..] {
            [a, b, ..] => checked("same-topology.cert", text, &says, &[a, b])?,
            _ => return Err(CertifyError::Internal { what: "inputs without documents" }.into()),
        };
        self.documents.push(document);
        let difference = compared.difference.clone();
        self.topology = Some(compared);
        self.lap("topology");
        if let Some(difference) = difference {
            self.summary = format!("not homeomorphic: {difference}.");
            return Ok(AuditVerdict::NotHomeomorphic);
        }
        self.tries(subjects, connectivity, shell, options, observer)
    }

    fn tries(
        &mut self,
        subjects: &[Subject<'_>; 2],
        connectivity: [&Connectivity; 2],
        shell: Option<&Shell>,
        options: &AuditOptions,
        observer: &dyn Observer,
    ) -> Result<AuditVerdict, AuditError> {
        let [a, b, ..] = &self.documents[..] else {
            return Err(CertifyError::Internal { what: "inputs without documents" }.into());
        };
        let files = [a.clone(), b.clone()];
        let pair = Pair { subjects: subjects.clone(), connectivity, files, options };
        let given = shell.map(|_| Try::Given);
        for (number, which) in given.into_iter().chain(options.tries.iter().copied()).enumerate() {
            let attempt = pair.attempt(number + 1, which, shell, observer)?;
            let certified = attempt.report.result == AttemptResult::Certified;
            self.documents.extend(attempt.documents);
            self.attempts.push(attempt.report);
            self.lap(which.name());
            if certified {
                self.summary = format!(
                    "bijective: both meshes are sections of {}, so the projection from A onto its middle surface followed \
                     by the inverse of that from B is a certified homeomorphism from A to B.",
                    which.sentence()
                );
                return Ok(AuditVerdict::Bijective);
            }
        }
        let tried: Vec<&str> = self.attempts.iter().map(|a| a.name.as_str()).collect();
        self.summary = format!(
            "not certified: none of the shells tried ({}) has both meshes as sections. This is no proof that no \
             homeomorphism exists.",
            tried.join(", ")
        );
        let meshes = subjects.each_ref().map(|s| s.mesh);
        if orientation::seems_opposite(meshes, connectivity) {
            self.summary += " B seems to be oriented the other way round: one surface encloses what it bounds, the other \
                             everything else; reverse the order of the corners of B's triangles and audit again.";
        }
        Ok(AuditVerdict::NotCertified)
    }
}
