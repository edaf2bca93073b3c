//! Shells that must not overlap themselves: the index against brute force, the judge against the certifier, and whole
//! builds around close sheets.

use super::*;
use crate::certify::Claim;
use crate::construct::optimise::grid::Grid;
use crate::construct::optimise::skin::Skin;
use crate::construct::{BuildError, icosphere};
use crate::testing::joined;

/// The refuted ones of all claims, `disjoint-prisms` included.
fn refuted(shell: &Shell, mesh: &TriMesh) -> Vec<Claim> {
    let options = certify::Options { claims: Claim::ALL.to_vec(), ..certify::Options::default() };
    let outcome = certify::certify(shell, Some(mesh), &options, &Silent).unwrap();
    outcome.claims.iter().filter(|c| c.verdict != Verdict::Certified).map(|c| c.claim).collect()
}

fn state(shell: &Shell) -> State {
    State::new(shell, &connectivity(shell))
}

/// Two spheres, one in the other, both with normals that point away from the centre.
fn close_spheres() -> TriMesh {
    let sphere = icosphere(2);
    let mut inner = sphere.clone();
    inner.vertices.iter_mut().flatten().for_each(|x| *x *= 0.9);
    joined(&sphere, &inner)
}

/// A square, and a small one just above the middle of it: no skin is crossed by a prism that grows past it at once.
fn square_below_a_disc() -> TriMesh {
    let square = |n: u32, side: f64, [x, y, z]: [f64; 3]| {
        let at = |i: u32, j: u32| i + j * (n + 1);
        let point = |k: u32| {
            let [i, j] = [k % (n + 1), k / (n + 1)].map(|i| side * f64::from(i) / f64::from(n));
            [x + i, y + j, z]
        };
        let cells = (0..n * n).map(|k| (k % n, k / n));
        TriMesh {
            vertices: (0..(n + 1) * (n + 1)).map(point).collect(),
            faces: cells
                .flat_map(|(i, j)| {
                    let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    [[a, b, c], [a, c, d]]
                })
                .collect(),
        }
    };
    joined(&square(16, 1.0, [0.0; 3]), &square(2, 0.004, [0.518, 0.508, 0.01]))
}

/// A strip rolled up by a turn and a half: a boundary, and sheets that lie on each other.
fn rolled() -> TriMesh {
    let (turns, rows) = (30u32, 3u32);
    let at = |i: u32, j: u32| i * (rows + 1) + j;
    let mut out = TriMesh::default();
    for i in 0..=turns {
        for j in 0..=rows {
            let angle = f64::from(i) * std::f64::consts::TAU / 20.0;
            let radius = 1.0 + 0.01 * f64::from(i);
            out.vertices.push([radius * angle.cos(), radius * angle.sin(), 0.4 * f64::from(j)]);
            if i < turns && j < rows {
                out.faces.push([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
                out.faces.push([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
            }
        }
    }
    out
}

fn build(mesh: &TriMesh, no_overlap: bool) -> Shell {
    let first = initial(mesh, &InitialOptions { no_overlap, ..InitialOptions::default() }, &Silent).unwrap();
    let options = OptimiseOptions { no_overlap, polish: 4, ..OptimiseOptions::default() };
    optimise(mesh, &first.shell, &options, &Silent).unwrap().shell
}

#[test]
fn close_sheets_overlap_only_where_they_may() {
    for (name, mesh) in [("spheres", close_spheres()), ("rolled", rolled())] {
        let free = build(&mesh, false);
        assert_eq!(refuted(&free, &mesh), [Claim::DisjointPrisms], "{name}");
        let apart = build(&mesh, true);
        assert_eq!(refuted(&apart, &mesh), [], "{name}");
        assert!(2 * apart.faces.len() < mesh.faces.len(), "{name}: {} prisms", apart.faces.len());
    }
}

#[test]
fn no_prism_swallows_another_component() {
    let mesh = square_below_a_disc();
    assert_eq!(refuted(&build(&mesh, false), &mesh), [Claim::DisjointPrisms]);
    assert_eq!(refuted(&build(&mesh, true), &mesh), []);
}

#[test]
fn a_shell_that_overlaps_itself_is_refused() {
    let mesh = close_spheres();
    let shell = build(&mesh, false);
    let options = OptimiseOptions { no_overlap: true, ..OptimiseOptions::default() };
    let answer = optimise(&mesh, &shell, &options, &Silent);
    assert!(matches!(answer, Err(BuildError::Overlap { count, .. }) if count > 0), "{answer:?}");
}

/// A change keeps the skin apart exactly when the certifier finds the shell with it so; the index follows.
#[test]
fn skin_agrees_with_the_certifier() {
    let mut random = Random(5);
    let mut seen = [0; 2];
    for mesh in [close_spheres(), rolled()] {
        let shell = build(&mesh, true);
        let mut now = state(&shell);
        now.skin = Some(Skin::new(&now));
        for _ in 0..250 {
            let v = random.below(now.pillars.len());
            if now.star[v].is_empty() || now.is_frozen(v as u32) {
                continue;
            }
            let size = [0.02, 0.05, 0.1][random.below(3)];
            let mut moved = |p: [f64; 3]| p.map(|x| x + size * random.real());
            let old = now.pillars[v];
            let pillar = Pillar { bottom: moved(old.bottom), middle: old.middle, top: moved(old.top) };
            let change = Change { moved: Some((v as u32, pillar)), ..Change::default() };
            let mut after = now.clone();
            after.apply(&change);
            if !now.prisms(&change).iter().all(Prism::is_positive) {
                continue;
            }
            let admitted = now.skin.as_ref().is_some_and(|skin| skin.admits(&now, &change));
            let found = certify::prisms::decide(&after.shell(), &crate::shell::VertexOrder::Id, &Silent);
            assert_eq!(admitted, found.unwrap().holds(), "vertex {v}, {pillar:?}");
            seen[usize::from(admitted)] += 1;
            if admitted {
                now = after;
            }
        }
        let fresh = Skin::new(&now);
        assert!(now.skin.as_ref().is_some_and(|skin| skin.same(&fresh)), "the index did not follow");
    }
    assert!(seen.iter().all(|n| *n > 20), "one-sided: {seen:?}");
}

#[test]
fn the_judge_asks_the_skin() {
    let mesh = close_spheres();
    let shell = build(&mesh, true);
    let mut now = state(&shell);
    let judge = Judge::new(Cow::Borrowed(&mesh), 0.0);
    let grown = |state: &State, v: u32| {
        let change = Change { moved: Some((v, state.pillars[v as usize].scaled(1.6))), ..Change::default() };
        judge.admits(state, &change)
    };
    let vertices = 0..u32::try_from(now.pillars.len()).unwrap();
    let free = vertices.clone().filter(|&v| grown(&now, v)).count();
    now.skin = Some(Skin::new(&now));
    let apart = vertices.filter(|&v| grown(&now, v)).count();
    assert!(apart < free, "{apart} of {free}");
}

#[test]
fn grid_finds_what_brute_force_finds() {
    let mut random = Random(6);
    let (mut grid, mut all): (Grid<usize>, Vec<Option<Box3>>) = (Grid::default(), Vec::new());
    let random_box = |random: &mut Random| {
        let size = [0.0, 1e-3, 0.1, 1.0, 1e30, 1e308][random.below(6)];
        let place = [1.0, 1.0, 1e30, 1e308][random.below(4)];
        let p: [f64; 3] = std::array::from_fn(|_| place * random.real());
        let q: [f64; 3] = std::array::from_fn(|i| (p[i] + size * random.real()).clamp(-1.7e308, 1.7e308));
        Box3::of([&p, &q])
    };
    for k in 0..600 {
        let bounds = random_box(&mut random);
        grid.insert(bounds, k);
        all.push(Some(bounds));
        let gone = random.below(all.len());
        if k % 3 == 0
            && let Some(old) = all[gone].take()
        {
            grid.remove(old, gone);
        }
        let wanted = random_box(&mut random);
        let near = |(i, b): (usize, &Option<Box3>)| b.filter(|b| b.meets(&wanted)).map(|_| i);
        let brute: Vec<usize> = all.iter().enumerate().filter_map(near).collect();
        let mut found = Vec::new();
        assert!(grid.all(&wanted, |&i| {
            found.push(i);
            true
        }));
        found.sort_unstable();
        assert_eq!(found, brute);
    }
}
