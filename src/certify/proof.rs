//! The certifier: decides the requested claims in the order in which they rest on each other.

use std::collections::BTreeSet;
use std::time::Instant;

use super::claim::{Claim, Part, Verdict};
use super::complex::{Boundary, MeshView, TetComplex};
use super::disjoint::{self, About, Disjoint};
use super::i2::{self, Contacts};
use super::lift::{Lift, Lifting};
use super::observer::Observer;
use super::orders::{self, AllOrders};
use super::positivity::{self, Positivity};
use super::prisms::{self, Prisms};
use super::section::{self, Section};
use super::witness::{Branch, Ending, NoLift};
use super::{CertifyError, write};
use crate::mesh::{self, Connectivity, TriMesh};
use crate::predicate::StageCounts;
use crate::shell::{Layer, Shell, VertexOrder, validate};

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
    /// (of `i2`: of the dots). Comparisons of coordinates and the exact points of witnesses are no such signs. A sign that two
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
        self.claims.iter().all(|c| c.verdict == Verdict::Certified)
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
pub(crate) struct Subject<'a> {
    pub(crate) shell: &'a Shell,
    pub(crate) mesh: Option<&'a TriMesh>,
    pub(crate) order: &'a VertexOrder,
}

/// Decides claims about a shell and, except for `positivity` and `disjoint-prisms`, a mesh; the result does not depend
/// on the number of threads.
///
/// Time is linear up to logarithms in the size of the shell, the mesh and their overlay; memory likewise.
///
/// # Errors
/// See [`CertifyError`]: input conditions that do not hold, an interruption, or a contradiction. Never a verdict.
pub fn certify(
    shell: &Shell,
    mesh: Option<&TriMesh>,
    options: &Options,
    observer: &dyn Observer,
) -> Result<Outcome, CertifyError> {
    let wanted: BTreeSet<Claim> =
        options.claims.iter().flat_map(|c| c.with_prerequisites()).copied().collect();
    let needs_mesh = wanted.iter().find(|c| c.needs_mesh());
    observer.stage("reading", None);
    validate::validate(shell)?;
    let order = VertexOrder::clone(&options.order);
    if let VertexOrder::List(list) = &order {
        VertexOrder::from_list(list.clone(), shell.middle.len())?;
    }
    let mut facts = Facts::default();
    let mut seconds = Seconds::default();
    if wanted.contains(&Claim::Positivity) {
        observer.stage("positivity", Some(shell.faces.len() as u64));
        facts.positivity = Some(seconds.of(Claim::Positivity, || positivity::decide(shell, observer))?);
    }
    let subject = Subject { shell, mesh: needs_mesh.and(mesh), order: &order };
    if let Some(claim) = needs_mesh {
        let mesh = mesh.ok_or(CertifyError::NoMesh { claim: claim.name() })?;
        about_mesh(&subject, mesh, &wanted, &mut facts, &mut seconds, observer)?;
    }
    if wanted.contains(&Claim::DisjointPrisms) {
        observer.stage("disjoint-prisms", None);
        let decide = || prisms::decide(shell, &order, observer);
        facts.prisms = Some(seconds.of(Claim::DisjointPrisms, decide)?);
    }
    let decided = |&claim: &Claim| {
        // A claim that fell out of the list would count as certified.
        let verdict =
            facts.verdict(claim).ok_or(CertifyError::Internal { what: "a claim without a verdict" })?;
        Ok(result(shell, claim, verdict, &facts, &seconds))
    };
    let claims = wanted.iter().map(decided).collect::<Result<_, CertifyError>>()?;
    observer.stage("writing", None);
    let certificate = write::certificate(&subject, &facts);
    Ok(Outcome { claims, certificate })
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
    if let Some((section, stages, all_orders, spent)) = lifts.transpose()? {
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
fn lifted(
    cx: Lifting<'_>,
    order: &VertexOrder,
    wanted: &BTreeSet<Claim>,
    before: &Facts,
    observer: &dyn Observer,
) -> Result<(Section, StageCounts, Option<Implied<AllOrders>>, Seconds), CertifyError> {
    let mut seconds = Seconds::default();
    let mut stages = StageCounts::default();
    let section = seconds.of(Claim::Section, || section::decide(cx, observer, &mut stages))?;
    if !wanted.contains(&Claim::SectionAllOrders) {
        return Ok((section, stages, None, seconds));
    }
    let all_orders = seconds.of(Claim::SectionAllOrders, || match &section {
        _ if before.verdict(Claim::Positivity) == Some(Verdict::Refuted) => {
            Ok(Implied::Refuted(Claim::Positivity))
        }
        Section::Refuted(_) => Ok(Implied::Refuted(Claim::Section)),
        Section::Certified(lifts) => orders::decide(cx, lifts, order, observer).map(Implied::Decided),
    })?;
    Ok((section, stages, Some(all_orders), seconds))
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
struct Seconds(Vec<(Claim, f64)>);

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

    fn total(&self, claim: Claim) -> f64 {
        self.0.iter().filter(|(c, _)| *c == claim).fold(0.0, |total, (_, s)| total + s)
    }
}

fn result(shell: &Shell, claim: Claim, verdict: Verdict, facts: &Facts, seconds: &Seconds) -> ClaimResult {
    let mut out = ClaimResult {
        claim,
        verdict,
        seconds: seconds.total(claim),
        counts: Vec::new(),
        parts: Vec::new(),
        refutations: Vec::new(),
    };
    match claim {
        Claim::Positivity => positivity_result(shell, facts, &mut out),
        Claim::Section | Claim::Bijection => section_result(facts, &mut out),
        Claim::SectionAllOrders => all_orders_result(facts, &mut out),
        Claim::Disjoint => disjoint_result(facts, &mut out),
        Claim::I2 => i2_result(facts, &mut out),
        Claim::DisjointPrisms => prisms_result(facts, &mut out),
    }
    out
}

impl ClaimResult {
    fn count(&mut self, what: &'static str, count: usize) {
        self.counts.push(Count { what, count: count as u64 });
    }

    fn stages(&mut self, stages: &StageCounts) {
        let parts = [
            ("decided_by_filter", stages.filter),
            ("decided_by_fixed_width", stages.fixed),
            ("decided_by_big_integer", stages.big),
        ];
        self.counts.extend(parts.map(|(what, count)| Count { what, count }));
    }

    fn refute(&mut self, kind: &'static str, text: String, prisms: Vec<u32>, triangles: Vec<u32>) {
        self.refutations.push(Refutation { kind, text, prisms, triangles, value: None });
    }

    fn implied(&mut self, by: Claim) {
        self.refute(by.name(), format!("it rests on `{by}`, which is refuted"), Vec::new(), Vec::new());
    }
}

fn positivity_result(shell: &Shell, facts: &Facts, out: &mut ClaimResult) {
    let Some(found) = &facts.positivity else { return };
    let prisms: BTreeSet<u32> = found.bad.iter().map(|b| b.prism).collect();
    out.count("tets", shell.tet_count());
    out.count("different_tets", usize::try_from(found.stages.total()).unwrap_or(usize::MAX));
    out.count("tets_not_positive", found.bad.len());
    out.count("prisms_not_positive", prisms.len());
    out.stages(&found.stages);
    for bad in found.bad.iter().take(Refutation::LISTED) {
        let value = write::value(&bad.value);
        let tet = write::names(&bad.names);
        out.refute(
            "tet",
            format!("tet {tet} of prism {} has determinant {value}", bad.prism),
            vec![bad.prism],
            Vec::new(),
        );
        out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
    }
}

fn section_result(facts: &Facts, out: &mut ClaimResult) {
    match &facts.section {
        Some(Section::Certified(lifts)) => {
            out.count("components", lifts.len());
            out.count("overlay_cells", lifts.iter().map(|l| l.pieces.len()).sum());
            let triangles = |l: &Lift| l.corners.len().saturating_sub(2 * l.pieces.len());
            out.count("overlay_triangles", lifts.iter().map(triangles).sum());
        }
        Some(Section::Refuted(witness)) => no_lift(witness, "", out),
        None => return,
    }
    out.stages(&facts.section_stages);
}

/// A witness against every lift, in words. "Not a section" is what it shows, never "not bijective".
fn no_lift(witness: &NoLift, under: &str, out: &mut ClaimResult) {
    match witness {
        NoLift::Components { mesh, middle } => out.refute(
            "components",
            format!("the mesh has {mesh} components, the middle surface {middle}: no homeomorphism exists"),
            Vec::new(),
            Vec::new(),
        ),
        NoLift::Euler { mesh, middle } => out.refute(
            "euler",
            format!("Euler characteristic {mesh} of the mesh, {middle} of the middle surface: no homeomorphism exists"),
            Vec::new(),
            Vec::new(),
        ),
        NoLift::Tet(bad) => {
            let (tet, value) = (write::names(&bad.names), write::value(&bad.value));
            let text = format!("not a section: tet {tet} of prism {} has determinant {value}{under}", bad.prism);
            out.refute("tet", text, vec![bad.prism], Vec::new());
            out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
        }
        NoLift::Roots(roots) => {
            for root in roots {
                let [a, b, c] = &root.weights;
                let at = format!("point {a}:{b}:{c} of mesh triangle {}", root.face);
                if root.branches.is_empty() {
                    let text = format!("not a section: {at} lies outside the shell{under}");
                    out.refute("outside", text, Vec::new(), vec![root.face]);
                }
                for branch in &root.branches {
                    let last = branch.legs.last().and_then(|l| l.steps.last());
                    let face = last.map_or(root.face, |s| s.face);
                    let text = format!("not a section: {}{under}", branch_text(&at, branch, face));
                    out.refute(branch.ending.word(), text, Vec::new(), vec![face]);
                }
            }
        }
    }
}

/// What is wrong with one lift of a root point, in words.
fn branch_text(at: &str, branch: &Branch, face: u32) -> String {
    let steps = branch.legs.iter().map(|l| l.steps.len()).max().unwrap_or(0);
    let carrier = write::names(&branch.carrier);
    let last = branch.legs.last().and_then(|l| l.steps.last());
    let tet = last.map(|s| s.tet).or_else(|| branch.legs.first().map(|l| l.start));
    let tet = tet.map_or_else(String::new, |t| write::names(&t));
    let way = match steps {
        0 => at.to_owned(),
        _ => format!("{at}, lifted to {carrier} and followed for {steps} steps to mesh triangle {face},"),
    };
    match branch.ending {
        Ending::Cap if steps == 0 => {
            let layer = if branch.carrier.iter().any(|n| n.layer == Layer::Top) { "top" } else { "bottom" };
            format!("{way} leaves the shell through the {layer} at {carrier}")
        }
        Ending::Cap => format!("{way} leaves the shell through bottom or top of tet {tet}"),
        Ending::Wall => {
            format!("{way} lies on a boundary wall of the shell, in tet {tet}, but inside the mesh")
        }
        Ending::Boundary => {
            format!("{way} is on the boundary of the mesh, but inside the shell, in tet {tet}")
        }
        Ending::Fold => format!("mesh triangle {face} does not face up in tet {tet}: n . V <= 0 at {way}"),
        Ending::Lands => format!("{way} lifts to tet {tet}, onto a component that another one needs"),
        Ending::Twice => format!("{way} and another point of the mesh have one image"),
        Ending::Monodromy => format!("{way} comes back in another tet, {tet}: the lift is not single-valued"),
    }
}

fn all_orders_result(facts: &Facts, out: &mut ClaimResult) {
    match &facts.all_orders {
        Some(Implied::Decided(AllOrders::Certified(stats))) => {
            out.counts.push(Count { what: "piece_prism_pairs", count: stats.pairs });
            out.counts.push(Count { what: "pairs_with_exact_test", count: stats.exceptions });
            out.stages(&stats.stages);
        }
        Some(Implied::Decided(AllOrders::Refuted { first, witness, stats })) => {
            out.stages(&stats.stages);
            let ids: Vec<String> = first.iter().map(ToString::to_string).collect();
            no_lift(witness, &format!(", in the vertex order that begins {}", ids.join(" ")), out);
        }
        Some(Implied::Refuted(by)) => out.implied(*by),
        None => {}
    }
}

fn disjoint_result(facts: &Facts, out: &mut ClaimResult) {
    let Some(found) = &facts.disjoint else { return };
    for (about, part) in ["mesh", "bottom", "top"].into_iter().zip(found) {
        out.parts.push(Part {
            about,
            verdict: Verdict::of(part.crossings.is_empty()),
            pairs: part.pairs,
            crossings: part.crossings.len() as u64,
        });
        for c in part.crossings.iter().take(Refutation::LISTED) {
            let (other, prisms, triangles) = match about {
                "mesh" => (format!("mesh triangle {}", c.second), Vec::new(), vec![c.first, c.second]),
                _ => (format!("the {about} of prism {}", c.second), vec![c.second], vec![c.first]),
            };
            let [a, b, d] = &c.in_first;
            let text = format!("mesh triangle {} meets {other} at its point {a}:{b}:{d}", c.first);
            out.refute("crossing", text, prisms, triangles);
        }
    }
    out.count("pairs", found.iter().map(|p| usize::try_from(p.pairs).unwrap_or(0)).sum());
    out.count("pairs_with_stated_planes", found.iter().map(|p| p.separations.len()).sum());
    out.stages(&found.iter().map(|p| p.stages).sum());
}

fn i2_result(facts: &Facts, out: &mut ClaimResult) {
    match &facts.contacts {
        Some(Implied::Decided(found)) => {
            out.counts.extend([
                Count { what: "triangle_prism_pairs", count: found.pairs },
                Count { what: "pairs_with_positive_dots", count: found.all_positive },
                Count { what: "triangle_tet_pairs_separated", count: found.tet_pairs },
                Count { what: "hull_condition_holds", count: u64::from(found.hull_condition) },
            ]);
            out.count("pairs_with_stated_planes", found.separations.len());
            out.count("contacts", found.contacts.len());
            out.stages(&found.stages);
            for c in found.contacts.iter().take(Refutation::LISTED) {
                let value = write::value(&c.value);
                let tet = write::names(&c.names);
                let text = format!(
                    "mesh triangle {} touches tet {tet} of prism {} with dot {value}",
                    c.face, c.prism
                );
                out.refute("contact", text, vec![c.prism], vec![c.face]);
                out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
            }
        }
        Some(Implied::Refuted(by)) => out.implied(*by),
        None => {}
    }
}

fn prisms_result(facts: &Facts, out: &mut ClaimResult) {
    let Some(found) = &facts.prisms else { return };
    out.stages(&found.stages);
    if let Some(bad) = &found.bad {
        let (tet, value) = (write::names(&bad.names), write::value(&bad.value));
        let text = format!("tet {tet} of prism {} has determinant {value}", bad.prism);
        out.refute("tet", text, vec![bad.prism], Vec::new());
        out.refutations.last_mut().into_iter().for_each(|r| r.value = Some(value.clone()));
        return;
    }
    out.count("skin_triangles", found.skin);
    out.count("pairs", usize::try_from(found.pairs).unwrap_or(usize::MAX));
    out.count("pairs_with_stated_planes", found.separations.len());
    out.count("overlaps", found.overlaps.len());
    for overlap in found.overlaps.iter().take(Refutation::LISTED) {
        let ([a, b], [p, q]) = (overlap.tets.each_ref().map(|t| write::names(t)), overlap.prisms);
        let text = format!("tet {a} of prism {p} and tet {b} of prism {q} share more than a face");
        out.refute("overlap", text, vec![p, q], Vec::new());
    }
}
