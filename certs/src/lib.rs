//! The independent checker of homeo certificates: reads a certificate and the files that it is about, and verifies
//! each claim exactly. The format, the rules and the error codes are in `FORMAT.md`; modules follow its sections.

mod boxes;
mod complex;
mod hdf5;
mod input;
mod lift;
mod line;
mod number;
mod orders;
mod overlay;
mod parse;
mod separate;
mod tets;
mod world;

use complex::Complex;
use input::{Mesh, Shell};
use number::{Fixed, Num, fits};
use parse::{Block, Cert};
use std::borrow::Cow;
use std::io::Read;
use std::path::Path;
use tets::Selected;
use world::World;

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

fn invalid<T>(code: &'static str, message: impl Into<String>) -> Res<T> {
    fail(1, code, message)
}

fn ensure(ok: bool, code: &'static str, message: impl FnOnce() -> String) -> Res {
    if ok { Ok(()) } else { invalid(code, message()) }
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
    let load = || {
        inputs
            .iter()
            .map(|path| load(path.as_ref(), u64::MAX, "input"))
            .collect::<Res<Vec<_>>>()
            .map(Cow::Owned)
    };
    outcome(load_cert(cert).and_then(|bytes| run(&bytes, load)))
}

fn load_cert(path: &Path) -> Res<Vec<u8>> {
    load(path, (1 << 30) + 1, "usage")
}

fn load(path: &Path, limit: u64, code: &'static str) -> Res<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = std::fs::File::open(path).and_then(|file| file.take(limit).read_to_end(&mut bytes));
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
    let cert = parse::parse(bytes)?;
    let (shell, mesh) = input::read(&inputs()?, cert.mesh.is_some())?;
    let mesh = mesh.filter(|_| cert.mesh.is_some()).unwrap_or_default();
    let complexes = bind(&cert, &shell, &mesh)?;
    let (exp, bits) = world::scale(&shell, &mesh);
    match bits {
        _ if fits::<4>(bits) => claims(&cert, &World::<Fixed<4>>::new(&shell, &mesh, exp, complexes)),
        _ if fits::<8>(bits) => claims(&cert, &World::<Fixed<8>>::new(&shell, &mesh, exp, complexes)),
        _ => claims(&cert, &World::<num_bigint::BigInt>::new(&shell, &mesh, exp, complexes)),
    }?;
    Ok(cert.claims)
}

/// The certificate is about these files, and they meet the input conditions.
fn bind(cert: &Cert, shell: &Shell, mesh: &Mesh) -> Res<(Complex, Complex)> {
    let layers = shell.layers.each_ref().map(Vec::as_slice);
    let same = |stated: &parse::Stated, layers: &[&[input::Bits]], triangles: &[[usize; 3]]| {
        let counts = (stated.vertices, stated.faces) == (layers[0].len(), triangles.len());
        counts && stated.sha == input::hash(layers, triangles)
    };
    ensure(same(&cert.shell, &layers, &shell.prisms), "hash", || "of the shell".into())?;
    if let Some(stated) = &cert.mesh {
        ensure(same(stated, &[&mesh.points], &mesh.triangles), "hash", || "of the mesh".into())?;
    }
    let complex =
        |triangles: &[[usize; 3]], code| Complex::new(triangles.to_vec()).or_else(|why| invalid(code, why));
    let pinched = world::pinched(shell);
    let flat = |t: &[usize; 3]| t.iter().all(|&v| pinched[v]);
    let bad = shell.prisms.is_empty() || shell.prisms.iter().any(flat);
    let middle = complex(&shell.prisms, "shell-conditions")?;
    ensure(!bad, "shell-conditions", || "no prism, or one with three pinched corners".into())?;
    let surface = complex(&mesh.triangles, "mesh-conditions")?;
    ensure(cert.mesh.is_none() || !mesh.triangles.is_empty(), "mesh-conditions", || "no triangle".into())?;
    Ok((middle, surface))
}

/// The conditions that need numbers or both complexes, then the claims one by one; their blocks come in their order.
fn claims<N: Num>(cert: &Cert, world: &World<N>) -> Res {
    let area = |f: &usize| world.normal(*f).iter().any(|x| x.sgn() != 0);
    if let Some(f) = (0..world.mesh.triangles.len()).find(|f| !area(f)) {
        return invalid("mesh-conditions", format!("triangle {f} has zero area"));
    }
    let pinches = world.shell.triangles.iter().flatten().filter(|&&v| world.pinched[v]).count();
    let pinched = (0..world.pinched.len()).filter(|&v| world.pinched[v]).collect();
    ensure(cert.pinched == (8 * pinches, pinched), "pinched", || {
        "the line differs from what the shell gives".into()
    })?;
    let order: Vec<usize> = cert.order.clone().unwrap_or_else(|| (0..world.pinched.len()).collect());
    let selected = |first: &[usize]| {
        let mut rank = vec![usize::MAX; order.len()];
        let mut next = 0;
        for &v in first.iter().chain(&order) {
            if rank[v] == usize::MAX {
                rank[v] = next;
                next += 1;
            }
        }
        Selected::new(world, &rank)
    };
    let mut overlay = None;
    let mut blocks = cert.blocks.iter();
    for &(name, certified) in &cert.claims {
        // Which claims have a block is what `parse::plan` says.
        match (name, certified) {
            ("positivity", true) => positive(world)?,
            ("bijection", _) => {}
            ("section-all-orders", true) => overlay.iter().try_for_each(|o| orders::check(world, o))?,
            _ if cert.owners.contains(&name) => match blocks.next() {
                Some(Block::Positivity(facts)) => {
                    for fact in facts {
                        let tets = tets::all(&world.pinched, world.shell.triangles[fact.prism]);
                        lift::negative(world, fact, tets.into_iter().find(|t| t.names == fact.tet))?;
                    }
                }
                Some(Block::Overlay(facts)) => {
                    overlay = Some(overlay::Overlay::check(world, &selected(&[]), facts)?);
                }
                Some(Block::NoLift(first, witness)) => lift::check(world, &selected(first), witness)?,
                Some(Block::Separated(seps)) if name == "i2" => separate::no_contact(world, seps)?,
                Some(Block::Separated(seps)) => separate::disjoint(world, layer(name), seps)?,
                Some(Block::Crossing(facts)) if name == "i2" => separate::contact(world, facts)?,
                Some(Block::Crossing(facts)) => separate::crossing(world, layer(name), facts)?,
                None => {}
            },
            _ => {}
        }
    }
    Ok(())
}

/// The shell layer that a `disjoint` claim is about.
fn layer(name: &str) -> Option<usize> {
    match name {
        "disjoint-bottom" => Some(0),
        "disjoint-top" => Some(2),
        _ => None,
    }
}

/// `positivity` certified.
fn positive<N: Num>(world: &World<N>) -> Res {
    for (p, &prism) in world.shell.triangles.iter().enumerate() {
        for tet in tets::all(&world.pinched, prism) {
            let ok = tet.det(world).sgn() > 0;
            ensure(ok, "not-positive", || format!("prism {p}: tet {}", show(&tet.names)))?;
        }
    }
    Ok(())
}
