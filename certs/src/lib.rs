//! The independent checker of homeo certificates: reads a certificate and the files that it is about, and verifies
//! each claim exactly. The format, the rules and the error codes are in `FORMAT.md`; modules follow its sections.
//!
//! The *trusted core*, which decides whether a claim holds, is `number`, `complex`, `world`, `tets`, `boxes`, `overlay`,
//! `orders`, `lift` and `separate`: under 960 lines of code (`tests/size.rs` counts them). Around it are the readers: `line`
//! and `parse` (the grammar), `input` and `hdf5` (files); what they read is bound by hashes. This file joins the two;
//! `compose` puts two certificates together.
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
mod parse;
mod separate;
mod tets;
mod world;

use complex::Complex;
use foldhash::fast::RandomState;
use input::{Mesh, Shell};
use parse::{Block, Cert, TetFact};
use rayon::prelude::*;
use separate::Sets;
use std::borrow::Cow;
use std::io::Read;
use std::path::Path;
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

/// Names as they are written.
fn show(names: &[usize]) -> String {
    let name = |n: &usize| format!("{}{}", ["b", "m", "t"][n % 3], n / 3);
    names.iter().map(name).collect::<Vec<_>>().join(",")
}

/// Checks a certificate against the contents of its input files.
pub fn check(cert: &[u8], inputs: &[Vec<u8>]) -> Outcome {
    outcome(run(cert, || Ok(Cow::Borrowed(inputs))))
}

/// Checks a certificate file against its input files.
pub fn check_files<P: AsRef<Path>>(cert: &Path, inputs: &[P]) -> Outcome {
    let load =
        || inputs.iter().map(|path| load(path.as_ref(), "input")).collect::<Res<Vec<_>>>().map(Cow::Owned);
    outcome(load_cert(cert).and_then(|bytes| run(&bytes, load)))
}

/// Checks that two certificates together prove a homeomorphism from mesh A to mesh B (FORMAT section 7): both are valid on
/// the same shell file, with one vertex order, and certify `bijection`.
pub fn compose(certs: [&[u8]; 2], shell: &[u8], meshes: [&[u8]; 2]) -> Outcome {
    let one = |i: usize| {
        let inputs = || Ok(Cow::Owned(vec![shell.to_vec(), meshes[i].to_vec()]));
        compose::checked(["A", "B"][i], Ok(Cow::Borrowed(certs[i])), inputs)
    };
    let both = || compose::fits(&one(0)?, &one(1)?);
    outcome(both())
}

/// The same for five files: the certificates of A and of B, the shell, A and B.
pub fn compose_files<P: AsRef<Path>>(files: &[P]) -> Outcome {
    let one = |name, cert: &P, inputs: [&P; 2]| {
        let load = || inputs.iter().map(|path| load(path.as_ref(), "input")).collect::<Res<Vec<_>>>();
        compose::checked(name, load_cert(cert.as_ref()).map(Cow::Owned), || load().map(Cow::Owned))
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

fn load_cert(path: &Path) -> Res<Vec<u8>> {
    load(path, "usage")
}

/// A file's bytes, one more than are allowed at the most: what is longer is then told from what is cut.
fn load(path: &Path, code: &'static str) -> Res<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = std::fs::File::open(path).and_then(|file| file.take(LIMIT as u64 + 1).read_to_end(&mut bytes));
    read.map_or_else(|error| malformed(code, format!("{}: {error}", path.display())), |_| Ok(bytes))
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

fn run<'a>(bytes: &[u8], inputs: impl FnOnce() -> Res<Cow<'a, [Vec<u8>]>>) -> Res<Vec<(&'static str, bool)>> {
    if bytes.starts_with(meshes::MAGIC) {
        return meshes::run(bytes, inputs);
    }
    let cert = parse::parse(bytes)?;
    let (shell, mesh) = input::read(&inputs()?, cert.mesh.is_some())?;
    let mesh = mesh.filter(|_| cert.mesh.is_some()).unwrap_or_default();
    let complexes = bind(&cert, &shell, &mesh)?;
    claims(&cert, &World::new(&shell, &mesh, complexes))?;
    Ok(cert.claims)
}

/// The certificate is about these files, and they meet the input conditions.
fn bind(cert: &Cert, shell: &Shell, mesh: &Mesh) -> Res<(Complex, Complex)> {
    let layers = shell.layers.each_ref().map(Vec::as_slice);
    let same = |stated: &parse::Stated, layers: &[&[input::Bits]], triangles: &[[usize; 3]]| {
        let counts = (stated.vertices, stated.faces) == (layers[0].len(), triangles.len());
        counts && stated.sha == input::hash(layers, triangles)
    };
    ensure!(same(&cert.shell, &layers, &shell.prisms), "hash", "of the shell");
    if let Some(stated) = &cert.mesh {
        ensure!(same(stated, &[&mesh.points], &mesh.triangles), "hash", "of the mesh");
    }
    let pinched = world::pinched(shell);
    let flat = |prism: &[usize; 3]| prism.iter().all(|&v| pinched[v]);
    let middle = Complex::new(shell.prisms.clone(), shell.layers[0].len(), "shell-conditions")?;
    ensure!(!shell.prisms.is_empty(), "shell-conditions", "no prism");
    ensure!(!shell.prisms.iter().any(flat), "shell-conditions", "a prism has three pinched corners");
    let surface = Complex::new(mesh.triangles.clone(), mesh.points.len(), "mesh-conditions")?;
    ensure!(cert.mesh.is_none() || !mesh.triangles.is_empty(), "mesh-conditions", "no triangle");
    Ok((middle, surface))
}

/// The conditions that need numbers or both complexes, then the claims one by one; their blocks come in their order.
fn claims(cert: &Cert, world: &World) -> Res {
    let area = |f: usize| {
        let [a, b, c] = world.corners(f);
        number::cross(&world.offset([a, b]), &world.offset([a, c])).iter().any(|x| number::sgn(x) != 0)
    };
    each(world.mesh.triangles.len(), |f| {
        ensure!(area(f), "mesh-conditions", "triangle {f} has zero area");
        Ok(())
    })?;
    let pinches = world.shell.triangles.iter().flatten().filter(|&&v| world.pinched[v]).count();
    let pinched = (0..world.pinched.len()).filter(|&v| world.pinched[v]).collect();
    ensure!(cert.pinched == (8 * pinches, pinched), "pinched", "the line differs from what the shell gives");
    let order: Vec<usize> = cert.order.clone().unwrap_or_else(|| (0..world.pinched.len()).collect());
    let selected = || Selected::new(world, &[], &order);
    let mut overlay = None;
    let mut blocks = cert.blocks.iter();
    for &(name, certified) in &cert.claims {
        // Which claims have a block is what `parse::plan` says.
        let block = if cert.owners.contains(&name) { blocks.next() } else { None };
        match (name, block) {
            ("positivity", None) => {
                each(world.shell.triangles.len(), |prism| {
                    let bad = tets::all(world, prism).into_iter().find(|tet| !tet.positive(world));
                    bad.map_or(Ok(()), |tet| {
                        fail(1, "not-positive", format!("prism {prism}: {}", show(&tet.names)))
                    })
                })?;
            }
            ("section-all-orders", None) if certified => {
                overlay.iter().try_for_each(|o| orders::check(world, o))?;
            }
            (_, None) => {}
            (_, Some(Block::Positivity(facts))) => {
                let tets = |fact: &TetFact| tets::all(world, fact.prism).into_iter();
                facts.iter().try_for_each(|fact| lift::not_positive(world, fact, tets(fact)))?;
            }
            (_, Some(Block::Overlay(facts))) => {
                overlay = Some(overlay::Overlay::check(world, &selected(), facts)?);
            }
            (_, Some(Block::NoLift(first, witness))) => {
                lift::check(world, &Selected::new(world, first, &order), witness)?;
            }
            ("disjoint-prisms", Some(Block::Separated(lines))) => {
                separate::injective(world, &selected(), lines)?;
            }
            (_, Some(Block::Separated(lines))) => separate::disjoint(world, &compared(world, name), lines)?,
            (_, Some(Block::Crossing(facts))) => separate::crossing(world, &compared(world, name), facts)?,
            (_, Some(Block::Overlap(facts))) => {
                separate::overlap(world, &selected(), facts)?;
            }
        }
    }
    Ok(())
}

/// The triangles of the mesh, and what a claim of sections 3.5 and 3.6 compares them with.
fn compared(world: &World, claim: &str) -> Sets {
    let first: Vec<[usize; 3]> = (0..world.mesh.triangles.len()).map(|f| world.corners(f)).collect();
    let prisms = world.shell.triangles.iter();
    let layer = |layer| prisms.clone().map(|t| t.map(|v| world.name(v, layer)).to_vec()).collect();
    let second = match claim {
        "disjoint-mesh" => first.iter().map(Vec::from).collect(),
        "disjoint-bottom" => layer(0),
        "disjoint-top" => layer(2),
        _ => prisms.clone().map(|t| t.map(|v| [3 * v, 3 * v + 1, 3 * v + 2]).concat()).collect(),
    };
    Sets { first, second, itself: claim == "disjoint-mesh" }
}
