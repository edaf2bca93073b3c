//! The certificate file, as `certs/FORMAT.md` wants it.

use std::fmt::{Display, Write as _};
use std::io;

use dashu_int::IBig;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use sha2::{Digest, Sha256};

use super::CertifyError;
use super::claim::{Claim, Verdict};
use super::disjoint::Disjoint;
use super::i2::Contacts;
use super::lift::{Carriers, Lift};
use super::observer::Observer;
use super::orders::AllOrders;
use super::prisms::Prisms;
use super::proof::{Facts, Implied, Subject};
use super::section::Section;
use super::separate::PlaneName;
use super::witness::{BadTet, NoLift, Root};
use crate::mesh::TriMesh;
use crate::shell::{Name, Shell, VertexOrder};

/// Where a certificate goes.
pub(crate) type Sink<'w> = dyn io::Write + Send + 'w;

/// A certificate on its way out: a few shards of it are in memory, no more.
struct Out<'w> {
    sink: &'w mut Sink<'w>,
    observer: &'w dyn Observer,
    /// Shards that are made, but not written yet.
    ready: Vec<String>,
    /// The lines after them.
    text: String,
    /// Fact lines of each block so far.
    counts: Vec<u64>,
    /// Why nothing more is written.
    failed: Option<CertifyError>,
}

/// Items that one core makes the lines of.
const SHARE: usize = 1 << 12;

/// Shards for each core that are made while those before them are written.
const SHARDS: usize = 2;

/// Bytes of single lines that are written at once.
const BYTES: usize = 1 << 16;

fn write_all(sink: &mut Sink<'_>, texts: &[String]) -> io::Result<()> {
    texts.iter().try_for_each(|text| sink.write_all(text.as_bytes()))
}

impl Out<'_> {
    fn line(&mut self, line: std::fmt::Arguments<'_>) {
        // Writing to a `String` cannot fail.
        let _ = self.text.write_fmt(line);
        self.text.push('\n');
        if self.text.len() >= BYTES {
            self.end_shard();
            self.beside(|| ());
        }
    }

    fn begin(&mut self, block: &str) {
        self.line(format_args!("begin {block}"));
        self.counts.push(0);
    }

    fn fact(&mut self, line: std::fmt::Arguments<'_>) {
        self.line(line);
        if let Some(count) = self.counts.last_mut() {
            *count += 1;
        }
    }

    /// A line for each item, all cores; the same text for any number of them.
    fn facts<T: Sync>(&mut self, items: &[T], write: impl Fn(&mut String, &T) -> std::fmt::Result + Sync) {
        let text = |items: &[T]| {
            let mut text = String::new();
            for item in items {
                let _ = write(&mut text, item);
                text.push('\n');
            }
            text
        };
        self.end_shard();
        for part in items.chunks(SHARE * SHARDS * rayon::current_num_threads()) {
            if self.failed.is_some() {
                return;
            }
            self.ready = self.beside(|| part.par_chunks(SHARE).map(text).collect());
        }
        if let Some(count) = self.counts.last_mut() {
            *count += items.len() as u64;
        }
    }

    fn end_shard(&mut self) {
        if !self.text.is_empty() {
            self.ready.push(std::mem::take(&mut self.text));
        }
    }

    /// Does some work while what is ready is written.
    fn beside<R: Send>(&mut self, work: impl FnOnce() -> R + Send) -> R {
        let ready = std::mem::take(&mut self.ready);
        if self.failed.is_none() && self.observer.cancelled() {
            self.failed = Some(CertifyError::Cancelled);
        }
        if self.failed.is_some() {
            return work();
        }
        let (done, written) = rayon::join(work, || write_all(self.sink, &ready));
        self.failed = written.err().map(CertifyError::Write);
        done
    }

    /// Writes the rest.
    fn end(mut self) -> Result<(), CertifyError> {
        self.end_shard();
        self.beside(|| ());
        self.failed.map_or(Ok(()), Err)?;
        self.sink.flush().map_err(CertifyError::Write)
    }
}

/// Items joined by a separator, written without a string of their own.
struct List<'a, T>(&'a [T], char);

impl<T: Display> Display for List<'_, T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (i, item) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_char(self.1)?;
            }
            item.fmt(f)?;
        }
        Ok(())
    }
}

/// Items joined by a separator.
pub(crate) fn joined<T: Display>(items: impl IntoIterator<Item = T>, separator: &str) -> String {
    let mut out = String::new();
    for (i, item) in items.into_iter().enumerate() {
        if i > 0 {
            out.push_str(separator);
        }
        let _ = write!(out, "{item}");
    }
    out
}

/// `b1,m2,t3`.
pub(crate) fn names(names: &[Name]) -> String {
    joined(names, ",")
}

/// A dyadic value: `0`, `-3`, `5*2^-12`.
pub(crate) fn value((mantissa, exponent): &(IBig, i32)) -> String {
    if *exponent == 0 { mantissa.to_string() } else { format!("{mantissa}*2^{exponent}") }
}

fn hash<'p>(points: impl Iterator<Item = &'p [f64; 3]>, faces: &[[u32; 3]]) -> String {
    let mut sha = Sha256::new();
    for x in points.flatten() {
        sha.update(x.to_le_bytes());
    }
    for v in faces.iter().flatten() {
        sha.update(v.to_le_bytes());
    }
    hex(&sha.finalize())
}

/// Bytes in hexadecimal.
pub(crate) fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut out, byte| {
        let _ = write!(out, "{byte:02x}");
        out
    })
}

/// The SHA-256 of a shell, as in certificates.
pub(crate) fn shell_hash(shell: &Shell) -> String {
    hash(shell.bottom.iter().chain(&shell.middle).chain(&shell.top), &shell.faces)
}

/// The SHA-256 of a mesh, as in certificates.
pub(crate) fn mesh_hash(mesh: &TriMesh) -> String {
    hash(mesh.vertices.iter(), &mesh.faces)
}

/// The whole file, made by all cores while what is made is written. Holds a few shards of lines, whatever its length.
///
/// # Errors
/// [`CertifyError::Write`], or [`CertifyError::Cancelled`] by the observer; part of the file may be written then.
pub(crate) fn certificate(
    subject: &Subject<'_>,
    facts: &Facts,
    sink: &mut Sink<'_>,
    observer: &dyn Observer,
) -> Result<(), CertifyError> {
    let (ready, text, counts) = (Vec::new(), String::new(), Vec::new());
    let mut out = Out { sink, observer, ready, text, counts, failed: None };
    header(subject, facts, &mut out);
    if let Some(p) = facts.positivity.as_ref().filter(|p| !p.bad.is_empty()) {
        out.begin("positivity");
        p.bad.iter().for_each(|bad| tet(bad, &mut out));
    }
    match &facts.section {
        Some(Section::Certified(lifts)) => overlay(lifts, &mut out),
        Some(Section::Refuted(witness)) => {
            out.begin("no-section");
            no_lift(witness, &mut out);
        }
        None => {}
    }
    if let Some(Implied::Decided(AllOrders::Refuted { first, witness, .. })) = &facts.all_orders {
        out.begin("no-order");
        out.fact(format_args!("first {}", joined(first, " ")));
        no_lift(witness, &mut out);
    }
    if let Some(parts) = &facts.disjoint {
        for (name, part) in ["disjoint-mesh", "disjoint-bottom", "disjoint-top"].into_iter().zip(parts) {
            out.begin(name);
            disjoint(part, &mut out);
        }
    }
    if let Some(Implied::Decided(found)) = &facts.contacts {
        out.begin("i2");
        contacts(found, &mut out);
    }
    if let Some(found) = &facts.prisms {
        out.begin("disjoint-prisms");
        prisms(found, &mut out);
    }
    if out.counts.is_empty() {
        out.line(format_args!("counts"));
    } else {
        let counts = joined(&out.counts, " ");
        out.line(format_args!("counts {counts}"));
    }
    out.line(format_args!("end"));
    out.end()
}

fn header(subject: &Subject<'_>, facts: &Facts, out: &mut Out<'_>) {
    out.line(format_args!("homeo-certificate 1"));
    for claim in Claim::ALL {
        let Some(verdict) = facts.verdict(claim) else { continue };
        match (claim, &facts.disjoint) {
            (Claim::Disjoint, Some(parts)) => {
                for (about, part) in ["mesh", "bottom", "top"].into_iter().zip(parts) {
                    let verdict = Verdict::of(part.crossings.is_empty());
                    out.line(format_args!("claim disjoint-{about} {verdict}"));
                }
            }
            _ => out.line(format_args!("claim {claim} {verdict}")),
        }
    }
    let shell = subject.shell;
    let (of_shell, of_mesh) = rayon::join(|| shell_hash(shell), || subject.mesh.map(mesh_hash));
    out.line(format_args!("shell {of_shell} {} {}", shell.middle.len(), shell.faces.len()));
    if let Some((mesh, hash)) = subject.mesh.zip(of_mesh) {
        out.line(format_args!("mesh {hash} {} {}", mesh.vertices.len(), mesh.faces.len()));
    }
    match subject.order {
        VertexOrder::Id => out.line(format_args!("order id")),
        VertexOrder::List(list) => out.line(format_args!("order list {}", joined(list, " "))),
    }
    let removed = 24 * shell.faces.len() - shell.tet_count();
    let pinched: String = shell.pinched_vertices().iter().map(|v| format!(" {v}")).collect();
    out.line(format_args!("pinched {removed}{pinched}"));
}

fn tet(bad: &BadTet, out: &mut Out<'_>) {
    out.fact(format_args!("tet {} {} {}", bad.prism, names(&bad.names), value(&bad.value)));
}

/// Overlay vertices numbered by first use, cells in the order of the flood, and the two degree tests.
fn overlay(lifts: &[Lift], out: &mut Out<'_>) {
    out.begin("overlay");
    let count = lifts.iter().map(|l| l.corners.len()).sum();
    let mut ids: FxHashMap<&Carriers, u32> = FxHashMap::default();
    let (mut vertices, mut corners) = (Vec::new(), Vec::with_capacity(count));
    for (_, carriers) in lifts.iter().flat_map(|l| &l.corners) {
        let id = *ids.entry(carriers).or_insert_with(|| {
            vertices.push(carriers);
            vertices.len() as u32 - 1
        });
        corners.push(id);
    }
    drop(ids);
    out.facts(&vertices, |text, v| write!(text, "v {} {}", List(v.mesh(), ','), List(v.shell(), ',')));
    let mut cells = Vec::with_capacity(lifts.iter().map(|l| l.pieces.len()).sum());
    let mut rest = corners.as_slice();
    for lift in lifts {
        for piece in 0..lift.pieces.len() as u32 {
            let (cell, others) = rest.split_at(lift.corners_of(piece).len());
            cells.push(cell);
            rest = others;
        }
    }
    out.facts(&cells, |text, cell| write!(text, "c {}", List(cell, ' ')));
    // The first piece of each lift has passed the degree test in both charts.
    let mut cell = 0;
    let mut firsts = Vec::with_capacity(lifts.len());
    for lift in lifts {
        firsts.push((lift.middle_component, cell));
        cell += lift.pieces.len();
    }
    firsts.iter().for_each(|(_, cell)| out.fact(format_args!("d mesh {cell} 0")));
    firsts.sort_unstable();
    firsts.iter().for_each(|(_, cell)| out.fact(format_args!("d middle {cell} 0")));
}

fn no_lift(witness: &NoLift, out: &mut Out<'_>) {
    match witness {
        NoLift::Components { mesh, middle } => out.fact(format_args!("topology components {mesh} {middle}")),
        NoLift::Euler { mesh, middle } => out.fact(format_args!("topology euler {mesh} {middle}")),
        NoLift::Tet(bad) => tet(bad, out),
        NoLift::Roots(roots) => roots.iter().for_each(|r| root(r, out)),
    }
}

fn root(root: &Root, out: &mut Out<'_>) {
    out.fact(format_args!("root {} {}", root.face, joined(&root.weights, " ")));
    for branch in &root.branches {
        out.fact(format_args!("branch {}", names(&branch.carrier)));
        for leg in &branch.legs {
            out.fact(format_args!("start {}", names(&leg.start)));
            for step in &leg.steps {
                let (weights, tet) = (joined(&step.weights, " "), names(&step.tet));
                out.fact(format_args!("step {} {weights} {tet}", step.face));
            }
        }
        out.fact(format_args!("{}", branch.ending.word()));
    }
}

fn planes(planes: &[PlaneName]) -> String {
    joined(planes, " ")
}

fn disjoint(part: &Disjoint, out: &mut Out<'_>) {
    if part.crossings.is_empty() {
        out.facts(&part.separations, |text, (i, j, list)| write!(text, "sep {i} {j} {}", List(list, ' ')));
    }
    for c in &part.crossings {
        let (a, b) = (joined(&c.in_first, " "), joined(&c.in_second, " "));
        out.fact(format_args!("cross {} {} {a} {b}", c.first, c.second));
    }
}

fn contacts(found: &Contacts, out: &mut Out<'_>) {
    if found.contacts.is_empty() {
        for s in &found.separations {
            let list = planes(&s.planes);
            out.fact(format_args!("contact-sep {} {} {} {list}", s.face, s.prism, names(&s.names)));
        }
    }
    for c in &found.contacts {
        let (a, b) = (joined(&c.in_face, " "), joined(&c.in_tet, " "));
        let (tet, value) = (names(&c.names), value(&c.value));
        out.fact(format_args!("contact {} {} {tet} {a} {b} {value}", c.face, c.prism));
    }
}

fn prisms(found: &Prisms, out: &mut Out<'_>) {
    if let Some(bad) = &found.bad {
        tet(bad, out);
    } else if found.overlaps.is_empty() {
        for (i, j, list) in &found.separations {
            out.fact(format_args!("sep {i} {j} {}", planes(list)));
        }
    }
    for overlap in &found.overlaps {
        let [a, b] =
            [0, 1].map(|k| format!("{} {}", names(&overlap.tets[k]), joined(&overlap.weights[k], " ")));
        out.fact(format_args!("overlap {a} {b}"));
    }
}
