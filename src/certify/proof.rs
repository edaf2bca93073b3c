//! The certifier: decides the requested claims in the order in which they rest on each other.

use std::collections::BTreeSet;
use std::io;
use std::time::Instant;

use super::claim::{Claim, Part, Verdict};
use super::complex::{Boundary, MeshView, TetComplex};
use super::disjoint::{self, About, Disjoint};
use super::i2::{self, Contacts};
use super::lift::Lifting;
use super::observer::Observer;
use super::orders::{self, AllOrders};
use super::positivity::{self, Positivity};
use super::prisms::{self, Prisms};
use super::results::result;
use super::section::{self, Section};
use super::{CertifyError, write};
use crate::mesh::{self, Connectivity, TriMesh};
use crate::predicate::StageCounts;
use crate::shell::{Shell, VertexOrder, validate};

/// What to certify.
#[derive(Clone, Debug)]
pub struct Options {
    /// The claims; those that they rest on are decided, too. Default: [`Claim::STANDARD`].
    pub claims: Vec<Claim>,
    /// The vertex order of C2 and C4. Default: by id.
    pub order: VertexOrder,
}

impl Default for Options {
    fn default() -> Self {
        Self { claims: Claim::STANDARD.to_vec(), order: VertexOrder::Id }
    }
}

/// A number about the work done for a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Count {
    /// What is counted.
    pub what: &'static str,
    /// How many.
    pub count: u64,
}

/// Why a claim is refuted, in ids and exact values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refutation {
    /// The kind of witness: `tet`, `cap`, `wall`, `boundary`, `fold`, `outside`, `twice`, `monodromy`, `lands`, `components`,
    /// `euler`, `crossing`, `contact`, `overlap`, or the name of the claim that this one rests on.
    pub kind: &'static str,
    /// The witness in words.
    pub text: String,
    /// Prisms named by the witness.
    pub prisms: Vec<u32>,
    /// Mesh triangles named by the witness.
    pub triangles: Vec<u32>,
    /// The exact value that is not positive, where there is one.
    pub value: Option<String>,
}

/// The answer to one claim.
#[derive(Clone, Debug)]
pub struct ClaimResult {
    /// The claim.
    pub claim: Claim,
    /// Its verdict.
    pub verdict: Verdict,
    /// Wall-clock seconds spent on it beyond those of the claims before. `section` and `disjoint` are decided at the same
    /// time, so that their sum may exceed the time of the whole.
    pub seconds: f64,
    /// Counts. `decided_by_filter`, `decided_by_fixed_width` and `decided_by_big_integer` are there for every claim that was
    /// looked at, not only implied: how the signs of determinants and dots of input points were decided that the verdict took
    /// (of `i2`: without the hull condition). Comparisons of coordinates and the exact points of witnesses are no such signs. A sign that two
    /// threads took, where one thread takes it once, counts once.
    pub counts: Vec<Count>,
    /// Of [`Claim::Disjoint`]: its parts.
    pub parts: Vec<Part>,
    /// At least one entry when refuted; at most [`Refutation::LISTED`].
    pub refutations: Vec<Refutation>,
}

impl Refutation {
    /// How many refutations of one claim are put in words.
    pub const LISTED: usize = 100;
}

/// All verdicts with their proof.
#[derive(Debug)]
pub struct Outcome {
    /// One entry for each claim, in the order of [`Claim::ALL`].
    pub claims: Vec<ClaimResult>,
    /// The certificate file.
    pub certificate: String,
}

impl Outcome {
    /// Are all claims certified?
    #[must_use]
    pub fn all_certified(&self) -> bool {
        all_certified(&self.claims)
    }
}

fn all_certified(claims: &[ClaimResult]) -> bool {
    claims.iter().all(|c| c.verdict == Verdict::Certified)
}

/// All verdicts, and what shows them: the certificate is written from it.
#[derive(Debug)]
pub struct Proof<'a> {
    subject: Subject<'a>,
    facts: Facts,
    claims: Vec<ClaimResult>,
}

impl Proof<'_> {
    /// One entry for each claim, in the order of [`Claim::ALL`].
    #[must_use]
    pub fn claims(&self) -> &[ClaimResult] {
        &self.claims
    }

    /// Are all claims certified?
    #[must_use]
    pub fn all_certified(&self) -> bool {
        all_certified(&self.claims)
    }

    /// The claims, without what shows their verdicts.
    #[must_use]
    pub fn into_claims(self) -> Vec<ClaimResult> {
        self.claims
    }

    /// Writes the certificate file: always the same bytes, in pieces of some hundred kilobytes that all cores make while earlier
    /// ones are written. Linear time; besides the proof, memory for a number (four bytes) and a reference for each corner of
    /// the overlay.
    ///
    /// # Errors
    /// [`CertifyError::Write`] when the writer fails, [`CertifyError::Cancelled`] by the observer. Then a part of the file may have
    /// been written.
    pub fn write(
        &self,
        to: &mut (dyn io::Write + Send),
        observer: &dyn Observer,
    ) -> Result<(), CertifyError> {
        observer.stage("writing", None);
        write::certificate(&self.subject, &self.facts, to, observer)
    }
}

/// All that was found; what the certificate is written from.
#[derive(Debug, Default)]
pub(crate) struct Facts {
    pub(crate) positivity: Option<Positivity>,
    pub(crate) section: Option<Section>,
    /// How signs were decided on the way to it.
    pub(crate) section_stages: StageCounts,
    pub(crate) all_orders: Option<Implied<AllOrders>>,
    /// Against the mesh itself, bottom and top.
    pub(crate) disjoint: Option<[Disjoint; 3]>,
    pub(crate) contacts: Option<Implied<Contacts>>,
    pub(crate) prisms: Option<Prisms>,
}

/// A claim that was decided, or that is refuted because a claim which it rests on is.
#[derive(Debug)]
pub(crate) enum Implied<T> {
    Decided(T),
    Refuted(Claim),
}

impl Facts {
    /// The verdict on a claim that was decided.
    pub(crate) fn verdict(&self, claim: Claim) -> Option<Verdict> {
        let holds = match claim {
            Claim::Positivity => self.positivity.as_ref()?.bad.is_empty(),
            Claim::Section | Claim::Bijection => matches!(self.section.as_ref()?, Section::Certified(_)),
            Claim::SectionAllOrders => {
                matches!(self.all_orders.as_ref()?, Implied::Decided(AllOrders::Certified(_)))
            }
            Claim::Disjoint => self.disjoint.as_ref()?.iter().all(|d| d.crossings.is_empty()),
            Claim::DisjointPrisms => self.prisms.as_ref()?.holds(),
            Claim::I2 => {
                matches!(self.contacts.as_ref()?, Implied::Decided(c) if c.contacts.is_empty())
            }
        };
        Some(Verdict::of(holds))
    }
}

/// Everything that the claims are about.
#[derive(Debug)]
pub(crate) struct Subject<'a> {
    pub(crate) shell: &'a Shell,
    pub(crate) mesh: Option<&'a TriMesh>,
    pub(crate) order: &'a VertexOrder,
}

/// Decides claims as [`prove`] does, with the whole certificate in memory.
///
/// # Errors
/// As [`prove`].
pub fn certify(
    shell: &Shell,
    mesh: Option<&TriMesh>,
    options: &Options,
    observer: &dyn Observer,
) -> Result<Outcome, CertifyError> {
    let proof = prove(shell, mesh, options, observer)?;
    let mut text = Vec::new();
    proof.write(&mut text, observer)?;
    let broken = |_| CertifyError::Internal { what: "a certificate that is no text" };
    Ok(Outcome { certificate: String::from_utf8(text).map_err(broken)?, claims: proof.into_claims() })
}

/// Decides claims about a shell and, except for `positivity` and `disjoint-prisms`, a mesh; the result does not depend
/// on the number of threads.
///
/// Time is linear up to logarithms in the size of the shell, the mesh and their overlay; memory likewise.
///
/// # Errors
/// See [`CertifyError`]: input conditions that do not hold, an interruption, or a contradiction. Never a verdict.
pub fn prove<'a>(
    shell: &'a Shell,
    mesh: Option<&'a TriMesh>,
    options: &'a Options,
    observer: &dyn Observer,
) -> Result<Proof<'a>, CertifyError> {
    let wanted: BTreeSet<Claim> =
        options.claims.iter().flat_map(|c| c.with_prerequisites()).copied().collect();
    let needs_mesh = wanted.iter().find(|c| c.needs_mesh());
    observer.stage("reading", None);
    validate::validate(shell)?;
    let order = &options.order;
    if let VertexOrder::List(list) = order {
        VertexOrder::from_list(list.clone(), shell.middle.len())?;
    }
    let mut facts = Facts::default();
    let mut seconds = Seconds::default();
    if wanted.contains(&Claim::Positivity) {
        observer.stage("positivity", Some(shell.faces.len() as u64));
        facts.positivity = Some(seconds.of(Claim::Positivity, || positivity::decide(shell, observer))?);
    }
    let subject = Subject { shell, mesh: needs_mesh.and(mesh), order };
    if let Some(claim) = needs_mesh {
        let mesh = mesh.ok_or(CertifyError::NoMesh { claim: claim.name() })?;
        about_mesh(&subject, mesh, &wanted, &mut facts, &mut seconds, observer)?;
    }
    if wanted.contains(&Claim::DisjointPrisms) {
        observer.stage("disjoint-prisms", None);
        let decide = || prisms::decide(shell, order, observer);
        facts.prisms = Some(seconds.of(Claim::DisjointPrisms, decide)?);
    }
    let decided = |&claim: &Claim| {
        // A claim that fell out of the list would count as certified.
        let verdict =
            facts.verdict(claim).ok_or(CertifyError::Internal { what: "a claim without a verdict" })?;
        Ok(result(shell, claim, verdict, &facts, &seconds))
    };
    let claims = wanted.iter().map(decided).collect::<Result<_, CertifyError>>()?;
    Ok(Proof { subject, facts, claims })
}

/// The claims that are about a mesh, too.
fn about_mesh(
    subject: &Subject<'_>,
    tri_mesh: &TriMesh,
    wanted: &BTreeSet<Claim>,
    facts: &mut Facts,
    seconds: &mut Seconds,
    observer: &dyn Observer,
) -> Result<(), CertifyError> {
    let shell = subject.shell;
    let (valid, middle) =
        rayon::join(|| mesh::check(tri_mesh), || Connectivity::new(shell.middle.len(), &shell.faces));
    let (valid, middle) = (valid?, middle?);
    let (edge, wall) = (Boundary::new(valid.connectivity()), Boundary::new(&middle));
    let mesh = MeshView {
        vertices: &tri_mesh.vertices,
        faces: &tri_mesh.faces,
        connectivity: valid.connectivity(),
        boundary: &edge,
    };
    let both = wanted.contains(&Claim::Section) && wanted.contains(&Claim::Disjoint);
    let (about, total) = match wanted.contains(&Claim::Section) {
        true if both => ("section, disjoint", None),
        true => ("section", None),
        false => ("disjoint", Some(3 * mesh.faces.len() as u64)),
    };
    observer.stage(about, total);
    let lift = || -> Result<_, CertifyError> {
        let ranks = subject.order.ranks(shell.middle.len());
        let complex = TetComplex::new(shell, &middle, &wall, &ranks);
        lifted(Lifting { mesh: &mesh, complex: &complex }, subject.order, wanted, facts, observer)
    };
    let apart = || Seconds::measured(Claim::Disjoint, || disjoint_from_all(&mesh, shell, observer));
    // Pieces are added one after another, and a lift that is narrow is looked ahead of by nobody: others have work that is about as
    // long beside it.
    let (lifts, parts) = rayon::join(
        || wanted.contains(&Claim::Section).then(lift),
        || wanted.contains(&Claim::Disjoint).then(apart),
    );
    if let Some(Lifted { section, stages, all_orders, seconds: spent }) = lifts.transpose()? {
        (facts.section, facts.section_stages, facts.all_orders) = (Some(section), stages, all_orders);
        seconds.0.extend(spent.0);
    }
    if let Some((parts, spent)) = parts {
        facts.disjoint = Some(parts?);
        seconds.0.extend(spent.0);
    }
    if wanted.contains(&Claim::I2) {
        observer.stage("i2", Some(mesh.faces.len() as u64));
        facts.contacts = Some(seconds.of(Claim::I2, || contacts(&mesh, shell, facts, observer))?);
    }
    Ok(())
}

/// The claims about a lift, and the time for each.
struct Lifted {
    section: Section,
    /// How signs were decided on the way to `section`.
    stages: StageCounts,
    all_orders: Option<Implied<AllOrders>>,
    seconds: Seconds,
}

/// Decides the claims about a lift.
fn lifted(
    cx: Lifting<'_>,
    order: &VertexOrder,
    wanted: &BTreeSet<Claim>,
    before: &Facts,
    observer: &dyn Observer,
) -> Result<Lifted, CertifyError> {
    let mut seconds = Seconds::default();
    let mut stages = StageCounts::default();
    let section = seconds.of(Claim::Section, || section::decide(cx, observer, &mut stages))?;
    if !wanted.contains(&Claim::SectionAllOrders) {
        return Ok(Lifted { section, stages, all_orders: None, seconds });
    }
    let all_orders = seconds.of(Claim::SectionAllOrders, || match &section {
        _ if before.verdict(Claim::Positivity) == Some(Verdict::Refuted) => {
            Ok(Implied::Refuted(Claim::Positivity))
        }
        Section::Refuted(_) => Ok(Implied::Refuted(Claim::Section)),
        Section::Certified(lifts) => orders::decide(cx, lifts, order, observer).map(Implied::Decided),
    })?;
    Ok(Lifted { section, stages, all_orders: Some(all_orders), seconds })
}

fn disjoint_from_all(
    mesh: &MeshView<'_>,
    shell: &Shell,
    observer: &dyn Observer,
) -> Result<[Disjoint; 3], CertifyError> {
    let decide = |about| disjoint::decide(mesh, shell, about, observer);
    Ok([decide(About::Mesh)?, decide(About::Bottom)?, decide(About::Top)?])
}

fn contacts(
    mesh: &MeshView<'_>,
    shell: &Shell,
    facts: &Facts,
    observer: &dyn Observer,
) -> Result<Implied<Contacts>, CertifyError> {
    if facts.verdict(Claim::SectionAllOrders) == Some(Verdict::Refuted) {
        return Ok(Implied::Refuted(Claim::SectionAllOrders));
    }
    if let Some([_, bottom, top]) = &facts.disjoint
        && !(bottom.crossings.is_empty() && top.crossings.is_empty())
    {
        return Ok(Implied::Refuted(Claim::Disjoint));
    }
    i2::decide(mesh, shell, observer).map(Implied::Decided)
}

/// Wall-clock time by claim.
#[derive(Debug, Default)]
pub(super) struct Seconds(Vec<(Claim, f64)>);

impl Seconds {
    /// The result of some work, and the time that it took.
    fn measured<T>(claim: Claim, work: impl FnOnce() -> T) -> (T, Self) {
        let mut seconds = Self::default();
        (seconds.of(claim, work), seconds)
    }

    fn of<T>(&mut self, claim: Claim, work: impl FnOnce() -> T) -> T {
        let start = Instant::now();
        let out = work();
        self.0.push((claim, start.elapsed().as_secs_f64()));
        out
    }

    pub(super) fn total(&self, claim: Claim) -> f64 {
        self.0.iter().filter(|(c, _)| *c == claim).fold(0.0, |total, (_, s)| total + s)
    }
}
