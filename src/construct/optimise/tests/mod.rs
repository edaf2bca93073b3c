//! Operations against their definitions: the certifier judges what they make, brute force what they are made of.

mod joint;
mod overlap;
mod resume;
mod same;

use std::borrow::Cow;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use super::energy::{gradient, mips};
use super::invariants::{Judge, Suspect};
use super::limits::Limits;
use super::operation::{Operation, Rules};
use super::prism::{Pillar, Prism};
use super::smooth::Vertex;
use super::state::{Change, GONE, State};
use super::tree::{Box3, Tree};
use super::{OptimiseOptions, Optimiser, optimise, split};
use crate::certify::{self, Observer, Silent, Verdict};
use crate::construct::{InitialOptions, initial};
use crate::mesh::{Connectivity, TriMesh};
use crate::predicate::orient3d_exact;
use crate::shell::Shell;
use crate::testing::{Random, data};

fn cube() -> TriMesh {
    let corner = |i: u8| [f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)];
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let faces = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    TriMesh { vertices: (0..8).map(corner).collect(), faces }
}

/// A subdivided octahedron, its vertices moved in or out at random.
fn bumpy(levels: usize, random: &mut Random) -> TriMesh {
    let mut vertices: Vec<[f64; 3]> =
        vec![[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]];
    let mut faces: Vec<[u32; 3]> =
        vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for _ in 0..levels {
        let mut middles = rustc_hash::FxHashMap::default();
        let mut between = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let [p, q] = [a, b].map(|v| vertices[v as usize]);
                vertices.push(std::array::from_fn(|i| p[i] + q[i]));
                u32::try_from(vertices.len() - 1).unwrap()
            })
        };
        faces = faces
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] = [between(a, b), between(b, c), between(c, a)];
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    for v in &mut vertices {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt() / (1.0 + 0.08 * random.real());
        *v = v.map(|x| x / length);
    }
    TriMesh { vertices, faces }
}

/// A square piece of a random landscape: one boundary loop.
fn landscape(n: u32, random: &mut Random) -> TriMesh {
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let mut vertices = Vec::new();
    let mut faces = Vec::new();
    for i in 0..=n {
        for j in 0..=n {
            vertices.push([f64::from(i), f64::from(j), 0.4 * random.real()]);
            if i < n && j < n {
                faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    TriMesh { vertices, faces }
}

fn refuted(shell: &Shell, mesh: &TriMesh) -> Vec<String> {
    let outcome = certify::certify(shell, Some(mesh), &certify::Options::default(), &Silent).unwrap();
    outcome.claims.iter().filter(|c| c.verdict != Verdict::Certified).map(|c| c.claim.to_string()).collect()
}

fn connectivity(shell: &Shell) -> Connectivity {
    Connectivity::new(shell.middle.len(), &shell.faces).unwrap()
}

/// The state's own rules, and those of the complex.
fn sanity_check(state: &State, start: &Connectivity) {
    // A change is noticed by all who look at it.
    assert!(state.changed.iter().all(|c| *c <= state.clock));
    assert_eq!(state.live, state.faces.iter().filter(|f| **f != GONE).count());
    let mut star = vec![Vec::new(); state.pillars.len()];
    for (f, face) in (0u32..).zip(&state.faces).filter(|(_, face)| **face != GONE) {
        assert!(face.iter().filter(|&&v| state.pinched[v as usize]).count() < 2);
        for &v in face {
            star[v as usize].push(f);
        }
    }
    for (mine, wanted) in state.star.iter().zip(&star) {
        let mut mine = mine.clone();
        mine.sort_unstable();
        assert_eq!(&mine, wanted);
    }
    let now = connectivity(&state.shell());
    assert!(now.is_manifold() && now.is_orientable());
    assert_eq!(now.euler_characteristic(), start.euler_characteristic());
    assert_eq!(now.component_count(), start.component_count());
    assert_eq!(now.boundary().count(), start.boundary().count());
    for (v, pillar) in state.pillars.iter().enumerate().filter(|(v, _)| !state.star[*v].is_empty()) {
        assert_eq!(pillar.is_pinched(), state.pinched[v]);
    }
}

/// One operation at a random place; whether it was made.
fn random_operation(state: &mut State, rules: &Rules<'_>, random: &mut Random) -> bool {
    let live: Vec<[u32; 3]> = state.faces.iter().copied().filter(|f| *f != GONE).collect();
    let [u, w, _] = live[random.below(live.len())];
    let edge = |operation: Operation| Some(operation.propose(state, rules, [u, w])?.0);
    let change = match random.below(8) {
        0 => edge(Operation::Collapse),
        1 => edge(Operation::HardCollapse),
        2 => edge(Operation::Flip),
        3 => edge(Operation::Split),
        // Also such that lowers no energy.
        4 if !state.is_frozen(u) && !state.is_frozen(w) => {
            let share = 0.5 + 0.5 * random.real().abs();
            split::at_middle(state, &rules.judge, &rules.limits, [u, w], share)
                .filter(|change| rules.judge.admits(state, change))
        }
        kind if !state.is_frozen(u) => {
            let mut vertex = Vertex::new(state, &rules.judge, u);
            let moved = match kind {
                5 => vertex.pan(),
                6 => vertex.zoom(&rules.limits),
                _ => vertex.rotate(),
            };
            moved.then(|| vertex.change())
        }
        _ => None,
    };
    change.inspect(|change| state.apply(change)).is_some()
}

fn random_sequence(mesh: &TriMesh, operations: usize, random: &mut Random) {
    let first = initial(mesh, &InitialOptions::default(), &Silent).unwrap();
    let start = connectivity(&first.shell);
    let mut state = State::new(&first.shell, &start);
    let rules = Rules {
        judge: Judge::new(Cow::Borrowed(mesh), 0.0),
        limits: Limits { thickness: 0.3, energy: 30.0 },
    };
    let frozen: Vec<(usize, Pillar)> = (0..state.pillars.len())
        .filter(|&v| state.is_frozen(v as u32))
        .map(|v| (v, state.pillars[v]))
        .collect();
    let mut made = 0;
    for k in 0..operations {
        let before = state.clone();
        if random_operation(&mut state, &rules, random) {
            made += 1;
            assert_ne!(state, before);
            sanity_check(&state, &start);
        } else {
            assert_eq!(state, before);
        }
        if k % 40 == 0 {
            assert_eq!(refuted(&state.shell(), mesh), Vec::<String>::new());
        }
    }
    assert!(10 * made > operations, "only {made} of {operations} operations were possible");
    assert_eq!(refuted(&state.shell(), mesh), Vec::<String>::new());
    assert!(frozen.iter().all(|(v, pillar)| state.pillars[*v] == *pillar && !state.star[*v].is_empty()));
}

#[test]
fn random_operations_keep_every_claim_on_closed_surfaces() {
    random_sequence(&cube(), 300, &mut Random(1));
    for seed in 0..4 {
        let mut random = Random(seed);
        random_sequence(&bumpy(2, &mut random), 300, &mut random);
    }
}

#[test]
fn random_operations_keep_every_claim_with_a_boundary() {
    for seed in 10..13 {
        let mut random = Random(seed);
        random_sequence(&landscape(6, &mut random), 250, &mut random);
    }
}

#[test]
fn random_operations_keep_every_claim_around_a_singular_vertex() {
    let Some(path) = data("surface/tennis.off") else { return };
    let mesh = crate::mesh::read(&path).unwrap().mesh;
    random_sequence(&mesh, 600, &mut Random(5));
}

/// A move is admitted exactly when the certifier certifies the shell with it, whatever was in the way of the last one.
#[test]
fn judge_agrees_with_the_certifier_on_random_moves() {
    let mut random = Random(77);
    let mut seen = [0; 2];
    for mesh in [cube(), bumpy(1, &mut Random(3)), landscape(4, &mut Random(4))] {
        let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap();
        let options = OptimiseOptions { polish: 2, ..OptimiseOptions::default() };
        let shell = optimise(&mesh, &first.shell, &options, &Silent).unwrap().shell;
        let state = State::new(&shell, &connectivity(&shell));
        let judge = Judge::new(Cow::Borrowed(&mesh), 0.0);
        let suspect = Suspect::default();
        for _ in 0..120 {
            let v = random.below(state.pillars.len());
            let size = [0.02, 0.1, 0.3][random.below(3)];
            let mut moved = |p: [f64; 3]| p.map(|x| x + size * random.real());
            let old = state.pillars[v];
            let pillar = Pillar { bottom: moved(old.bottom), middle: old.middle, top: moved(old.top) };
            let change = Change { moved: Some((v as u32, pillar)), ..Change::default() };
            let mut after = state.clone();
            after.apply(&change);
            if state.boundary[v] {
                // Walls at the boundary are no operation's business: the judge does not look at them.
                continue;
            }
            let admitted = judge.admits(&state, &change);
            let faults = refuted(&after.shell(), &mesh);
            assert_eq!(admitted, faults.is_empty(), "vertex {v}, {pillar:?}: {faults:?}");
            assert_eq!(
                judge.admits_one_of_many(&state, &change, &suspect),
                admitted,
                "vertex {v}, {pillar:?}"
            );
            seen[usize::from(admitted)] += 1;
        }
    }
    assert!(seen.iter().all(|n| *n > 20), "one-sided: {seen:?}");
}

#[test]
fn prisms_are_positive_as_their_24_tets_are() {
    let mut random = Random(8);
    let mut seen = [0; 2];
    for _ in 0..400 {
        let size = 1.6 * random.real().abs();
        let mut near = |x: f64, y: f64, z: f64| [x + size * random.real(), y + size * random.real(), z];
        let mut pillar =
            |x: f64, y: f64| Pillar { bottom: near(x, y, -1.), middle: near(x, y, 0.), top: near(x, y, 1.) };
        let pillars = [pillar(0., 0.), pillar(2., 0.), pillar(0., 2.)];
        let shell = Shell {
            bottom: pillars.map(|p| p.bottom).to_vec(),
            middle: pillars.map(|p| p.middle).to_vec(),
            top: pillars.map(|p| p.top).to_vec(),
            faces: vec![[0, 1, 2]],
        };
        let wanted = shell.prism_tets(0).all(|t| {
            let [a, b, c, d] = t.names.map(|n| shell.position(n));
            orient3d_exact(a, b, c, d).is_positive()
        });
        assert_eq!(Prism { pillars, pinched: [false; 3] }.is_positive(), wanted);
        seen[usize::from(wanted)] += 1;
    }
    assert!(seen.iter().all(|n| *n > 50), "one-sided: {seen:?}");
}

#[test]
fn tree_finds_what_brute_force_finds() {
    let mut random = Random(9);
    let mesh = bumpy(3, &mut random);
    let tree = Tree::new(&mesh);
    for _ in 0..200 {
        let p: [f64; 3] = std::array::from_fn(|_| random.real());
        let size = random.real().abs();
        let q: [f64; 3] = std::array::from_fn(|i| p[i] + size * random.real());
        let (low, high): ([f64; 3], [f64; 3]) =
            (std::array::from_fn(|i| p[i].min(q[i])), std::array::from_fn(|i| p[i].max(q[i])));
        let meets = |f: &[u32; 3]| {
            (0..3).all(|i| {
                let x = f.map(|v| mesh.vertices[v as usize][i]);
                x.iter().any(|&x| x <= high[i]) && x.iter().any(|&x| x >= low[i])
            })
        };
        let wanted: Vec<u32> = (0u32..).zip(&mesh.faces).filter(|(_, f)| meets(f)).map(|(i, _)| i).collect();
        let mut found = Vec::new();
        assert!(tree.all(&Box3::of([&p, &q]), |f| {
            found.push(f);
            true
        }));
        found.sort_unstable();
        assert_eq!(found, wanted);
    }
    assert!(Tree::new(&TriMesh::default()).all(&Box3::of([&[0.0; 3]]), |_| false));
}

#[test]
fn energy_is_two_for_equilateral_triangles_and_has_the_right_slope() {
    let far = mips([&[1., 0., 0.], &[0., 1., 0.], &[0., 0., 1.]]);
    assert!((far - 2.0).abs() < 1e-12, "{far}");
    assert!(mips([&[0., 0., 0.], &[1., 1., 1.], &[2., 2., 2.]]).is_infinite());
    let corners = [[1.0, 0.5, 0.0], [0.0, 1.0, 0.25], [0.0, 0.0, 1.0]];
    let [p, q, r] = corners.map(|p| p.map(|x: f64| x * 2f64.powi(-600)));
    let [x, y, z] = corners.map(|p| p.map(|x: f64| x * 2f64.powi(600)));
    // Scaling by powers of two changes no rounding.
    assert_eq!(mips([&p, &q, &r]).to_bits(), mips([&corners[0], &corners[1], &corners[2]]).to_bits());
    assert_eq!(mips([&p, &q, &r]).to_bits(), mips([&x, &y, &z]).to_bits());
    let mut random = Random(10);
    for _ in 0..50 {
        let mut point = || -> [f64; 3] { std::array::from_fn(|_| random.real()) };
        let [a, b, c] = [point(), point(), point()];
        let slope = gradient([&a, &b, &c]);
        for i in 0..3 {
            let h = 1e-6;
            let at = |x: f64| {
                let mut p = a;
                p[i] += x;
                mips([&p, &b, &c])
            };
            let wanted = (at(h) - at(-h)) / (2.0 * h);
            let size = 1.0 + slope.iter().fold(0.0f64, |m, x| m.max(x.abs()));
            assert!((slope[i] - wanted).abs() < 1e-4 * size * size, "{} {wanted}", slope[i]);
        }
    }
}

/// Stops after some calls.
struct Impatient(AtomicU64);

impl Observer for Impatient {
    fn cancelled(&self) -> bool {
        self.0.fetch_add(1, Ordering::Relaxed) >= 8
    }
}

#[test]
fn stopping_early_leaves_a_valid_shell() {
    let mesh = bumpy(3, &mut Random(12));
    let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap();
    let options = OptimiseOptions::default();
    let built = optimise(&mesh, &first.shell, &options, &Impatient(AtomicU64::new(0))).unwrap();
    assert!(built.stopped);
    assert_ne!(built.shell, first.shell);
    assert_eq!(refuted(&built.shell, &mesh), Vec::<String>::new());
    let none = OptimiseOptions { time_limit: Some(Duration::ZERO), ..options };
    let built = optimise(&mesh, &first.shell, &none, &Silent).unwrap();
    assert!(built.stopped);
    assert_eq!(built.shell, first.shell);
}

#[test]
fn optimising_is_deterministic_coarser_and_certified() {
    let mesh = bumpy(3, &mut Random(13));
    let first = initial(&mesh, &InitialOptions::default(), &Silent).unwrap();
    let [one, two] =
        [(), ()].map(|()| optimise(&mesh, &first.shell, &OptimiseOptions::default(), &Silent).unwrap());
    assert_eq!(one.shell, two.shell);
    assert_eq!(one.counts, two.counts);
    assert!(!one.stopped);
    assert!(4 * one.shell.faces.len() < first.shell.faces.len(), "{} prisms", one.shell.faces.len());
    assert_eq!(refuted(&one.shell, &mesh), Vec::<String>::new());
}
