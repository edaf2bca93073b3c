//! The independent checker of homeo certificates: reads a certificate and the files that it is about, and verifies
//! each claim exactly. The format, the rules and the error codes are in `FORMAT.md`; modules follow its sections.
//!
//! The *trusted core*, which decides whether a claim holds, is `number`, `complex`, `world`, `tets`, `boxes`, `shard`,
//! `overlay`, `orders`, `lift` and `separate`: under 1,350 lines of code (`tests/size.rs` counts them). Around it are the
//! readers: `line` and `parse` (the grammar), `pages` (lines that are read again whenever they are needed, so that a long
//! certificate need not be kept), `input` and `hdf5` (files); what they read is bound by hashes. This file joins the
//! two; `compose` puts two certificates together.
//!
//! Certificates about meshes without a shell (`MESHES.md`) have a core of their own in `meshes`.

/// The error of a check that does not hold.
macro_rules! bad {
    ($code:expr, $($message:tt)*) => { crate::Fail { exit: 1, code: $code, message: format!($($message)*) } };
}

/// Returns from a function with the error `invalid CODE` if something does not hold.
macro_rules! ensure {
    ($ok:expr, $code:expr, $($message:tt)*) => { if !$ok { return Err(bad!($code, $($message)*)); } };
}

mod boxes;
mod complex;
mod compose;
mod hdf5;
mod input;
mod lift;
mod line;
mod meshes;
mod number;
mod orders;
mod overlay;
mod pages;
mod parse;
mod separate;
mod shard;
#[cfg(test)]
mod tests;
mod tets;
mod world;

// The table of the corpus is read by tests within and without.
#[cfg(test)]
extern crate self as homeo_certs;

use complex::Complex;
use foldhash::fast::RandomState;
use input::{Files, Mesh, Shell};
use pages::Text;
use parse::{Block, Cert, TetFact};
use rayon::prelude::*;
use separate::Sets;
use shard::Source;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use tets::Selected;
use world::World;

/// Hash tables with a hasher that is fast on small keys and seeded anew in every process, since keys come from files.
type Map<K, V> = std::collections::HashMap<K, V, RandomState>;
type Set<T> = std::collections::HashSet<T, RandomState>;

/// The bytes that a file may have.
const LIMIT: usize = 1 << 30;

/// The answer of a check.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outcome {
    /// 0 valid, 1 invalid, 2 malformed, 3 limit.
    pub exit: u8,
    /// `valid`, `invalid`, `malformed` or `limit`.
    pub status: &'static str,
    /// The error code of FORMAT section 3; empty when valid.
    pub code: &'static str,
    /// What failed: the certificate's line, or the element. May be empty.
    pub message: String,
    /// The claims of a valid certificate, and whether each is certified (else refuted).
    pub claims: Vec<(String, bool)>,
}

struct Fail {
    exit: u8,
    code: &'static str,
    message: String,
}

type Res<T = ()> = Result<T, Fail>;

fn fail<T>(exit: u8, code: &'static str, message: impl Into<String>) -> Res<T> {
    Err(Fail { exit, code, message: message.into() })
}

fn malformed<T>(code: &'static str, message: impl Into<String>) -> Res<T> {
    fail(2, code, message)
}

/// Checks independent things in parallel; the error is that of the first one that fails.
fn each(n: usize, check: impl Fn(usize) -> Res + Sync + Send) -> Res {
    (0..n).into_par_iter().map(check).find_first(Result::is_err).unwrap_or(Ok(()))
}

/// Checks independent things in parallel and collects what is found; the error is that of the first one that fails.
fn all<T: Send>(n: usize, check: impl Fn(usize) -> Res<T> + Sync + Send) -> Res<Vec<T>> {
    // What comes after a failure need not be looked at.
    let failed = AtomicUsize::new(usize::MAX);
    let one = |i| match i > failed.load(Relaxed) {
        true => Err(bad!("", "behind a failure")),
        false => check(i).inspect_err(|_| _ = failed.fetch_min(i, Relaxed)),
    };
    (0..n).into_par_iter().map(one).collect::<Vec<_>>().into_iter().collect()
}

/// The `at`-th range of `size` numbers of `0..n`, of which there are `n.div_ceil(size)`.
fn part(n: usize, size: usize, at: usize) -> std::ops::Range<usize> {
    at * size..n.min((at + 1) * size)
}

/// Names as they are written.
fn show(names: &[usize]) -> String {
    let name = |n: &usize| format!("{}{}", ["b", "m", "t"][n % 3], n / 3);
    names.iter().map(name).collect::<Vec<_>>().join(",")
}

/// Checks a certificate against the contents of its input files.
pub fn check(cert: &[u8], inputs: &[Vec<u8>]) -> Outcome {
    outcome(either(Text::Memory(cert), &Files::Memory(inputs)))
}

/// Checks a certificate file against its input files. A long certificate is not kept in memory ([`RESIDENT`]).
pub fn check_files<P: AsRef<Path>>(cert: &Path, inputs: &[P]) -> Outcome {
    check_files_keeping(RESIDENT, cert, inputs)
}

/// The bytes that a certificate may have to be kept in memory by [`check_files`].
pub const RESIDENT: u64 = 1 << 26;

/// The same, but a certificate of more than `resident` bytes is not kept in memory: its lines are read whenever they are needed,
/// and refused (`malformed usage`) if they have changed. The answer is the same.
pub fn check_files_keeping<P: AsRef<Path>>(resident: u64, cert: &Path, inputs: &[P]) -> Outcome {
    let files = Files::Paths(inputs.iter().map(AsRef::as_ref).collect());
    outcome(with_file(resident, cert, |text| either(text, &files)))
}

/// Checks that two certificates together prove a homeomorphism from mesh A to mesh B (FORMAT section 7): both are valid on
/// the same shell file, with one vertex order, and certify `bijection`.
pub fn compose(certs: [&[u8]; 2], shell: &[u8], meshes: [&[u8]; 2]) -> Outcome {
    let one = |i: usize| {
        let files = [shell.to_vec(), meshes[i].to_vec()];
        compose::named(["A", "B"][i], run(Text::Memory(certs[i]), &Files::Memory(&files)))
    };
    let both = || compose::fits(&one(0)?, &one(1)?);
    outcome(both())
}

/// The same for five files: the certificates of A and of B, the shell, A and B.
pub fn compose_files<P: AsRef<Path>>(files: &[P]) -> Outcome {
    let one = |name, cert: &P, inputs: [&P; 2]| {
        let files = Files::Paths(inputs.map(AsRef::as_ref).to_vec());
        compose::named(name, with_file(RESIDENT, cert.as_ref(), |text| run(text, &files)))
    };
    let both = || match files {
        // In this order: nothing of B is read before A is checked.
        [a_cert, b_cert, shell, a, b] => {
            compose::fits(&one("A", a_cert, [shell, a])?, &one("B", b_cert, [shell, b])?)
        }
        _ => malformed("usage", "compose wants five files: A.cert B.cert SHELL A B"),
    };
    outcome(both())
}

/// Opens a certificate.
fn with_file<T>(resident: u64, path: &Path, then: impl FnOnce(Text<'_>) -> Res<T>) -> Res<T> {
    let cannot = |error: std::io::Error| bad_file("usage", path, &error);
    let file = File::open(path).map_err(cannot)?;
    let found = file.metadata().map_err(cannot)?;
    // What is no regular file (a pipe) can be read just once, and opened just once.
    if found.is_file() && found.len() > resident {
        return then(Text::File(&Mutex::new(file), usize::try_from(found.len()).unwrap_or(usize::MAX)));
    }
    then(Text::Memory(&contents(file).map_err(cannot)?))
}

fn bad_file(code: &'static str, path: &Path, error: &std::io::Error) -> Fail {
    Fail { exit: 2, code, message: format!("{}: {error}", path.display()) }
}

/// A file's bytes, one more than are allowed at the most: what is longer is then told from what is cut.
fn contents(file: File) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    file.take(LIMIT as u64 + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}

fn load(path: &Path, code: &'static str) -> Res<Vec<u8>> {
    File::open(path).and_then(contents).map_err(|error| bad_file(code, path, &error))
}

fn outcome(result: Res<Vec<(&'static str, bool)>>) -> Outcome {
    match result {
        Ok(claims) => {
            let claims = claims.into_iter().map(|(name, verdict)| (name.to_owned(), verdict)).collect();
            Outcome { exit: 0, status: "valid", code: "", message: String::new(), claims }
        }
        Err(Fail { exit, code, message }) => {
            let status = ["valid", "invalid", "malformed", "limit"][usize::from(exit.min(3))];
            Outcome { exit, status, code, message, claims: Vec::new() }
        }
    }
}

/// What a valid certificate is about.
struct Checked {
    claims: Vec<(&'static str, bool)>,
    shell: String,
    order: Option<Vec<usize>>,
}

/// A certificate of either kind; its claims.
fn either(text: Text<'_>, files: &Files<'_>) -> Res<Vec<(&'static str, bool)>> {
    if *text.read(0..text.len().min(meshes::MAGIC.len()))? == *meshes::MAGIC {
        return meshes::run(&text.read(0..text.len().min(LIMIT + 1))?, files);
    }
    run(text, files).map(|checked| checked.claims)
}

fn run(text: Text<'_>, files: &Files<'_>) -> Res<Checked> {
    let cert = parse::parse(text)?;
    let (shell, mesh) = input::read(files, cert.mesh.is_some())?;
    let mesh = mesh.filter(|_| cert.mesh.is_some()).unwrap_or_default();
    claims(&cert, &bind(&cert, shell, mesh)?)?;
    Ok(Checked { claims: cert.claims, shell: cert.shell.sha, order: cert.order })
}

/// The certificate is about these files, and they meet the input conditions.
fn bind(cert: &Cert<'_>, mut shell: Shell, mut mesh: Mesh) -> Res<World> {
    let layers = shell.layers.each_ref().map(Vec::as_slice);
    let same = |stated: &parse::Stated, layers: &[&[input::Bits]], triangles: &[[u32; 3]]| {
        let counts = (stated.vertices, stated.faces) == (layers[0].len(), triangles.len());
        counts && stated.sha == input::hash(layers, triangles)
    };
    ensure!(same(&cert.shell, &layers, &shell.prisms), "hash", "of the shell");
    if let Some(stated) = &cert.mesh {
        ensure!(same(stated, &[&mesh.points], &mesh.triangles), "hash", "of the mesh");
    }
    let prisms = std::mem::take(&mut shell.prisms);
    let triangles = std::mem::take(&mut mesh.triangles);
    ensure!(!prisms.is_empty(), "shell-conditions", "no prism");
    let middle = Complex::new(prisms, shell.layers[0].len(), "shell-conditions")?;
    let pinched = world::pinched(&shell);
    let flat = (0..middle.len()).any(|prism| middle.of(prism).iter().all(|&v| pinched[v]));
    ensure!(!flat, "shell-conditions", "a prism has three pinched corners");
    ensure!(cert.mesh.is_none() || !triangles.is_empty(), "mesh-conditions", "no triangle");
    let surface = Complex::new(triangles, mesh.points.len(), "mesh-conditions")?;
    Ok(World::new(shell, mesh, (middle, surface)))
}

/// The conditions that need numbers or both complexes, then the claims one by one; their blocks come in their order.
fn claims(cert: &Cert<'_>, world: &World) -> Res {
    let area = |f: usize| {
        let [a, b, c] = world.corners(f);
        number::cross(&world.offset([a, b]), &world.offset([a, c])).iter().any(|x| number::sgn(x) != 0)
    };
    each(world.mesh.len(), |f| {
        ensure!(area(f), "mesh-conditions", "triangle {f} has zero area");
        Ok(())
    })?;
    let corners = (0..world.shell.len()).flat_map(|prism| world.shell.of(prism));
    let pinches = corners.filter(|&v| world.pinched[v]).count();
    let pinched = (0..world.pinched.len()).filter(|&v| world.pinched[v]).collect();
    ensure!(cert.pinched == (8 * pinches, pinched), "pinched", "the line differs from what the shell gives");
    let order: Vec<usize> = cert.order.clone().unwrap_or_else(|| (0..world.pinched.len()).collect());
    let selected = Selected::new(world, &[], &order);
    let all_orders = cert.claims.contains(&("section-all-orders", true));
    let mut overlay = None;
    let mut blocks = cert.blocks.iter();
    for &(name, certified) in &cert.claims {
        // Which claims have a block is what `parse::plan` says.
        let block = if cert.owners.contains(&name) { blocks.next() } else { None };
        match (name, block) {
            ("positivity", None) => {
                each(world.shell.len(), |prism| {
                    let bad = tets::all(world, prism).into_iter().find(|tet| !tet.positive(world));
                    bad.map_or(Ok(()), |tet| {
                        fail(1, "not-positive", format!("prism {prism}: {}", show(&tet.names)))
                    })
                })?;
            }
            ("section-all-orders", None) if certified => {
                let overlay = overlay.take().ok_or_else(|| bad!("all-orders", "there is no overlay"))?;
                orders::check(world, overlay)?;
            }
            (_, None) => {}
            (_, Some(Block::Positivity(facts))) => {
                let tets = |fact: &TetFact| tets::all(world, fact.prism).into_iter();
                facts.iter().try_for_each(|fact| lift::not_positive(world, fact, tets(fact)))?;
            }
            (_, Some(Block::Overlay(facts))) => {
                overlay =
                    Some(overlay::Overlay::check(Source { world, selected: &selected, facts }, all_orders)?);
            }
            (_, Some(Block::NoLift(first, witness))) => {
                lift::check(world, &Selected::new(world, first, &order), witness)?;
            }
            ("disjoint-prisms", Some(Block::Separated(lines))) => {
                separate::injective(world, &selected, lines)?;
            }
            (_, Some(Block::Separated(lines))) => separate::disjoint(world, &compared(name), lines)?,
            (_, Some(Block::Crossing(facts))) => separate::crossing(world, &compared(name), facts)?,
            (_, Some(Block::Overlap(facts))) => {
                separate::overlap(world, &selected, facts)?;
            }
        }
    }
    Ok(())
}

/// What a claim of sections 3.5 and 3.6 compares.
fn compared(claim: &str) -> Sets<'static> {
    match claim {
        "disjoint-mesh" => Sets::Mesh,
        "disjoint-bottom" => Sets::Layer(0),
        "disjoint-top" => Sets::Layer(2),
        _ => Sets::Prisms,
    }
}
