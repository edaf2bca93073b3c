//! Shells around random, degenerate and extreme meshes: what is built certifies for all claims and the independent
//! checker agrees; what is refused is refused for a reason that holds.
#![allow(clippy::unwrap_used)]

use std::collections::BTreeMap;
use std::env;
use std::time::{Duration, Instant};

use homeo::certify::{Claim, Options, Silent, certify};
use homeo::construct::{BuildError, InitialOptions, OptimiseOptions, initial, optimise, optimise_locally};
use homeo::mesh::{self, TriMesh};
use homeo::shell::Shell;
use homeo_proptests::judged::inputs;
use homeo_proptests::meshes::{FAMILIES, PLACES, Place, Random, crossing};
use homeo_proptests::{Case, MeshRecipe};

/// All claims are certified and the checker says valid.
fn proved(shell: &Shell, mesh: &TriMesh) -> Result<(), String> {
    proves(shell, mesh, &Options::default())
}

fn proves(shell: &Shell, mesh: &TriMesh, options: &Options) -> Result<(), String> {
    let outcome = certify(shell, Some(mesh), options, &Silent).map_err(|e| format!("no verdict: {e}"))?;
    for claim in &outcome.claims {
        if let Some(r) = claim.refutations.first() {
            return Err(format!("{} refuted: {}", claim.claim, r.text));
        }
    }
    let case = Case { shell: shell.clone(), mesh: mesh.clone(), order: Vec::new() };
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(&case));
    if answer.exit == 0 { Ok(()) } else { Err(format!("rejected: {} {}", answer.code, answer.message)) }
}

/// All claims that are about the abstract surface, and the checker agrees.
fn proved_locally(shell: &Shell, mesh: &TriMesh) -> Result<(), String> {
    proves(shell, mesh, &Options { claims: vec![Claim::SectionAllOrders], ..Options::default() })
}

/// Around meshes that cross themselves the abstract surface is mapped, all of it.
#[test]
fn what_is_built_around_crossing_sheets_certifies_locally() {
    for seed in 0..wanted().map_or(2, |n| n.min(20)) {
        for (name, mesh) in crossing(&mut Random(seed)) {
            let strict = initial(&mesh, &InitialOptions::default(), &Silent);
            assert!(
                matches!(strict, Err(BuildError::SelfIntersecting { .. })),
                "{name} does not cross itself"
            );
            let options = InitialOptions { allow_self_intersections: true, ..InitialOptions::default() };
            let first = initial(&mesh, &options, &Silent).unwrap_or_else(|e| panic!("{name} {seed}: {e}"));
            proved_locally(&first.shell, &mesh).unwrap_or_else(|e| panic!("{name} {seed}, initial: {e}"));
            let options = OptimiseOptions { polish: 3, ..OptimiseOptions::default() };
            let done = optimise_locally(&mesh, &first.shell, &first.origin, &options, &Silent).unwrap();
            proved_locally(&done.shell, &mesh).unwrap_or_else(|e| panic!("{name} {seed}: {e}"));
            let (before, after) = (first.shell.faces.len(), done.shell.faces.len());
            eprintln!("{name} {seed}: {} triangles, {before} prisms, {after} at last", mesh.faces.len());
            assert!(after < before, "{name} {seed}: nothing was coarsened");
        }
    }
}

/// What became of a mesh, in a word; an error is a failure.
fn built(mesh: &TriMesh, strip: bool) -> Result<&'static str, String> {
    let options = InitialOptions::default();
    let first = match initial(mesh, &options, &Silent) {
        Ok(first) => first,
        Err(BuildError::Mesh(_)) if mesh::check(mesh).is_err() => return Ok("no manifold"),
        Err(BuildError::SelfIntersecting { .. }) => return Ok("self-intersecting"),
        Err(BuildError::Coarse { .. }) if least_height(mesh) < longest(mesh) * 2f64.powi(-24) => {
            return Ok("too few digits");
        }
        // Boundary edges are never split: where the prisms on two neighbouring ones need different pillars there may be
        // no shell of this kind.
        Err(BuildError::NoThickness { .. } | BuildError::TwoPinched { .. }) if strip => {
            return Ok("boundary too sharp");
        }
        Err(BuildError::Range { .. }) if longest(mesh) < 2f64.powi(-950) => return Ok("out of range"),
        Err(e) => return Err(format!("initial: {e}")),
    };
    proved(&first.shell, mesh).map_err(|e| format!("initial: {e}"))?;
    let options = OptimiseOptions { polish: 3, ..OptimiseOptions::default() };
    let done = optimise(mesh, &first.shell, &options, &Silent).map_err(|e| format!("optimise: {e}"))?;
    proved(&done.shell, mesh).map_err(|e| format!("optimised: {e}"))?;
    Ok("built")
}

/// The largest coordinate.
fn longest(mesh: &TriMesh) -> f64 {
    mesh.vertices.iter().flatten().fold(0.0, |m, x| x.abs().max(m))
}

/// The smallest height of a triangle, about.
fn least_height(mesh: &TriMesh) -> f64 {
    let length = |v: [f64; 3]| v[0].hypot(v[1]).hypot(v[2]);
    let scale = 1.0 / longest(mesh);
    let heights = mesh.faces.iter().map(|f| {
        let [a, b, c] = f.map(|v| mesh.vertices[v as usize].map(|x| x * scale));
        let edge = |p: [f64; 3], q: [f64; 3]| [q[0] - p[0], q[1] - p[1], q[2] - p[2]];
        let (x, y, z) = (edge(a, b), edge(a, c), edge(b, c));
        let n = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
        length(n) / length(x).max(length(y)).max(length(z))
    });
    heights.fold(f64::INFINITY, f64::min) * longest(mesh)
}

fn wanted() -> Option<u64> {
    env::var("HOMEO_CASES").ok().map(|n| n.parse().unwrap())
}

/// Without `HOMEO_CASES` for 20 s, else so many cases; `HOMEO_SEED` is the first one.
#[test]
fn what_is_built_around_random_meshes_certifies() {
    let start = Instant::now();
    let first: u64 = env::var("HOMEO_SEED").map_or(0, |n| n.parse().unwrap());
    let mut tally: BTreeMap<(String, &str), u64> = BTreeMap::new();
    let mut failures = Vec::new();
    for seed in first..first + wanted().unwrap_or(2000) {
        if wanted().is_none() && start.elapsed() > Duration::from_secs(20) {
            break;
        }
        let mut random = Random(seed);
        let recipe = MeshRecipe {
            family: seed as usize % FAMILIES.len(),
            size: 0,
            seed,
            turned: random.below(2) == 0,
            place: random.below(PLACES.len()),
        };
        // Numbers far from one are slow to certify.
        let size =
            random.below(if matches!(PLACES[recipe.place], Place::Here | Place::Far(_)) { 4 } else { 2 });
        let recipe = MeshRecipe { size: size as u32, ..recipe };
        let began = Instant::now();
        let result = built(&recipe.build(), FAMILIES[recipe.family].0 == "strip");
        if began.elapsed() > Duration::from_secs(5) {
            eprintln!("SLOW {recipe:?} {:?}", began.elapsed());
        }
        let name = FAMILIES[recipe.family].0;
        match result {
            Ok(word) => *tally.entry((name.to_owned(), word)).or_default() += 1,
            Err(e) => {
                eprintln!("{name} {:?} {recipe:?}: {e}", PLACES[recipe.place]);
                failures.push(recipe);
            }
        }
    }
    eprintln!("{tally:#?}");
    assert!(failures.is_empty(), "{} failures", failures.len());
}
