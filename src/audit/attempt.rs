//! Stage (c): is there a shell of which A and B are sections?

use std::time::Instant;

use super::documents::{self, Document};
use super::error::AuditError;
use super::joint::shell_of;
use super::options::{AuditOptions, Try};
use super::places::places;
use super::report::{AttemptReport, AttemptResult};
use super::run::Subject;
use crate::certify::{CertifyError, Claim, Observer, Options, Outcome, certify};
use crate::construct::BuildError;
use crate::mesh::Connectivity;
use crate::shell::Shell;
use crate::shell::hdf5::{self, ShellFile};

/// A pair of valid meshes with one topology.
pub(crate) struct Pair<'a> {
    pub(crate) subjects: [Subject<'a>; 2],
    pub(crate) connectivity: [&'a Connectivity; 2],
    /// A and B as files for the checkers.
    pub(crate) files: [Document; 2],
    pub(crate) options: &'a AuditOptions,
}

/// A try with its files.
pub(crate) struct Attempt {
    pub(crate) report: AttemptReport,
    pub(crate) documents: Vec<Document>,
}

impl Pair<'_> {
    /// Makes a try; it is the `number`-th.
    pub(crate) fn attempt(
        &self,
        number: usize,
        which: Try,
        given: Option<&Shell>,
        observer: &dyn Observer,
    ) -> Result<Attempt, AuditError> {
        let start = Instant::now();
        let meshes = self.subjects.each_ref().map(|s| s.mesh);
        let built = match (shell_of(which, meshes, self.options, observer), given) {
            (Some(built), _) => built,
            (None, Some(shell)) => Ok(shell.clone()),
            (None, None) => return Ok(Attempt::without_shell(which, "no shell was given", 0.0)),
        };
        let seconds = start.elapsed().as_secs_f64();
        match built {
            Ok(shell) if shell.faces.is_empty() => {
                Ok(Attempt::without_shell(which, "the shell has no prism", seconds))
            }
            Ok(shell) => self.judge(number, which, &shell, seconds, observer),
            Err(BuildError::Certify(CertifyError::Cancelled)) => Err(CertifyError::Cancelled.into()),
            Err(error) => Ok(Attempt::without_shell(which, &error.to_string(), seconds)),
        }
    }

    fn judge(
        &self,
        number: usize,
        which: Try,
        shell: &Shell,
        built: f64,
        observer: &dyn Observer,
    ) -> Result<Attempt, AuditError> {
        let start = Instant::now();
        let mut out = Attempt::without_shell(which, "", built);
        out.report.prisms = shell.faces.len();
        let mut outcomes = Vec::with_capacity(2);
        for subject in &self.subjects {
            match sections(shell, subject, observer) {
                Ok(outcome) => outcomes.push(outcome),
                Err(CertifyError::Cancelled) => return Err(CertifyError::Cancelled.into()),
                Err(CertifyError::Internal { what }) => return Err(CertifyError::Internal { what }.into()),
                Err(error) => {
                    out.report.reason = Some(error.to_string());
                    return Ok(out);
                }
            }
        }
        let holds: Vec<bool> = outcomes.iter().map(Outcome::all_certified).collect();
        out.report.reason = None;
        out.report.sections = std::array::from_fn(|i| holds.get(i).copied());
        let all = holds.iter().all(|h| *h);
        out.report.result = if all { AttemptResult::Certified } else { AttemptResult::NotSections };
        let stem = if all { "shell".to_owned() } else { format!("try{number}-{}", which.name()) };
        self.write(&stem, shell, &outcomes, &mut out)?;
        out.report.seconds[1] = start.elapsed().as_secs_f64();
        let start = Instant::now();
        for (i, _) in holds.iter().enumerate().filter(|(_, h)| !**h) {
            let found = places(&self.subjects[i], self.connectivity[i], shell, observer)?;
            out.report.surveys.extend(found);
        }
        out.report.seconds[2] = start.elapsed().as_secs_f64();
        Ok(out)
    }

    fn write(
        &self,
        stem: &str,
        shell: &Shell,
        outcomes: &[Outcome],
        out: &mut Attempt,
    ) -> Result<(), AuditError> {
        let file = ShellFile { shell: shell.clone(), ..ShellFile::default() };
        let shell_file = Document::input(&format!("{stem}.h5"), hdf5::to_bytes(&file)?);
        out.report.shell = Some(shell_file.file.clone());
        for (i, outcome) in outcomes.iter().enumerate() {
            let letter = ["a", "b"][i.min(1)];
            let name =
                if stem == "shell" { format!("{letter}.cert") } else { format!("{stem}.{letter}.cert") };
            let refuted = outcome.claims.iter().flat_map(|c| &c.refutations).next();
            let says = match refuted {
                None => "is a section of the shell, and bijective to its middle surface".to_owned(),
                Some(r) => format!("is no section of the shell: {}", r.text),
            };
            if refuted.is_some() {
                out.report.witnesses.push(format!("{} {says}", self.subjects[i].name));
            }
            let says = format!("{} {says}", self.subjects[i].name);
            let text = outcome.certificate.clone();
            out.documents.push(documents::checked(&name, text, &says, &[&shell_file, &self.files[i]])?);
        }
        if let (AttemptResult::Certified, [a, b]) = (out.report.result, &out.documents[..]) {
            let meshes = self.files.each_ref().map(|d| d.bytes.as_slice());
            let answer = homeo_certs::compose([&a.bytes, &b.bytes], &shell_file.bytes, meshes);
            documents::accepted("a.cert and b.cert", &answer)?;
        }
        out.documents.insert(0, shell_file);
        Ok(())
    }
}

impl Attempt {
    fn without_shell(which: Try, reason: &str, seconds: f64) -> Self {
        let report = AttemptReport {
            name: which.name().to_owned(),
            text: which.sentence().to_owned(),
            result: AttemptResult::NoShell,
            reason: Some(reason.to_owned()),
            shell: None,
            prisms: 0,
            sections: [None; 2],
            witnesses: Vec::new(),
            surveys: Vec::new(),
            seconds: [seconds, 0.0, 0.0],
        };
        Self { report, documents: Vec::new() }
    }
}

/// C2 and C4 in the order by id.
fn sections(shell: &Shell, subject: &Subject<'_>, observer: &dyn Observer) -> Result<Outcome, CertifyError> {
    let options = Options { claims: vec![Claim::Bijection], ..Options::default() };
    certify(shell, Some(subject.mesh), &options, observer)
}
