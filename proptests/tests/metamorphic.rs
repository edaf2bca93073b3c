//! Changes of the input that must not change a verdict.
#![allow(clippy::unwrap_used)]

use homeo::certify::{CertifyError, Claim, Options, Silent, certify};
use homeo::mesh::TriMesh;
use homeo_proptests::Case;
use homeo_proptests::campaign::{certified, holds, run};
use homeo_proptests::recipe::{Move, Recipe};
use homeo_proptests::sheets::{Edit, edit};

fn verdicts(case: &Case) -> Result<Option<Vec<bool>>, String> {
    let all = |o| Claim::ALL.iter().map(|&c| holds(&o, c)).collect();
    Ok(certified(case, false)?.map(all))
}

fn same(case: &Case, changed: &Case, what: &str) -> Result<Vec<String>, String> {
    let (a, b) = (verdicts(case)?, verdicts(changed)?);
    if a == b {
        return Ok(vec![if a.is_some() { "decided" } else { "refused" }.into()]);
    }
    if a.is_some() != b.is_some() && has_several_lifts(if a.is_none() { case } else { changed }) {
        return Ok(vec!["several lifts".into()]);
    }
    Err(format!("{what} changes the verdicts {a:?} to {b:?}\n{changed:#?}"))
}

/// In a shell that winds around itself, which lift is found first depends on the numbering: where that ends in the named "no
/// verdict", another numbering may get one.
fn has_several_lifts(case: &Case) -> bool {
    let options = Options { claims: Claim::STANDARD.to_vec(), order: case.vertex_order() };
    matches!(
        certify(&case.shell, Some(&case.mesh), &options, &Silent),
        Err(CertifyError::SeveralLifts { .. })
    )
}

/// Every coordinate of shell and mesh.
fn mapped(case: &Case, f: impl Fn([f64; 3]) -> [f64; 3]) -> Case {
    let mut out = case.clone();
    let shell = &mut out.shell;
    for layer in [&mut shell.bottom, &mut shell.middle, &mut shell.top, &mut out.mesh.vertices] {
        layer.iter_mut().for_each(|p| *p = f(*p));
    }
    out
}

/// The elements in another order: element `i` moves to place `to(i)`.
fn permutation(n: usize, seed: u16) -> Vec<u32> {
    let step = (1..).map(|k| usize::from(seed) % 97 + k).find(|s| gcd(*s, n) == 1).unwrap();
    (0..n).map(|i| u32::try_from((i * step + usize::from(seed)) % n).unwrap()).collect()
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn permuted<T: Clone>(list: &[T], to: &[u32]) -> Vec<T> {
    let mut out = list.to_vec();
    to.iter().zip(list).for_each(|(&place, x)| out[place as usize] = x.clone());
    out
}

fn renumbered(faces: &[[u32; 3]], vertex: &[u32], seed: u16) -> Vec<[u32; 3]> {
    let mut out: Vec<[u32; 3]> = faces.iter().map(|f| f.map(|v| vertex[v as usize])).collect();
    out.iter_mut().zip(0u16..).for_each(|(f, k)| f.rotate_left(usize::from(seed.wrapping_add(k) % 3)));
    permuted(&out, &permutation(faces.len(), seed))
}

#[test]
fn renumbering() {
    run(5, |recipe, case| same(case, &in_other_numbers(recipe, case), "renumbering"));
}

fn in_other_numbers(recipe: &Recipe, case: &Case) -> Case {
    let mut other = case.clone();
    let to = permutation(case.shell.middle.len(), recipe.order);
    other.shell.bottom = permuted(&case.shell.bottom, &to);
    other.shell.middle = permuted(&case.shell.middle, &to);
    other.shell.top = permuted(&case.shell.top, &to);
    other.shell.faces = renumbered(&case.shell.faces, &to, recipe.order);
    other.order = case.order.iter().map(|&v| to[v as usize]).collect();
    let to = permutation(case.mesh.vertices.len(), recipe.order / 3);
    other.mesh = TriMesh {
        vertices: permuted(&case.mesh.vertices, &to),
        faces: renumbered(&case.mesh.faces, &to, recipe.order / 7),
    };
    other
}

/// A pillar wound around twice: one numbering gets verdicts, the other the named "no verdict".
#[test]
fn renumbering_a_wound_pillar() {
    let recipe = Recipe {
        shape: 12,
        pinched: vec![],
        moves: vec![Move { at: 64, by: [0, -1, 0] }],
        edge: Some((Move { at: 222, by: [0, 1, 0] }, true)),
        edits: vec![
            Edit { kind: 2, at: 216, pick: [7, 87, 26] },
            Edit { kind: 5, at: 100, pick: [63, 166, 42] },
        ],
        order: 54032,
    };
    let case = recipe.build();
    let answer = same(&case, &in_other_numbers(&recipe, &case), "renumbering");
    assert_eq!(answer, Ok(vec!["several lifts".to_owned()]));
}

#[test]
fn scaling_and_moving() {
    run(5, |recipe, case| {
        let scale = [2f64.powi(-60), 2f64.powi(40), 0.5, 2f64.powi(200)][usize::from(recipe.order) % 4];
        let scaled = mapped(case, |p| p.map(|x| x * scale));
        if mapped(&scaled, |p| p.map(|x| x / scale)) != *case {
            // A coordinate of the smallest doubles is rounded to zero: another case.
            return Ok(vec!["not scaled exactly".into()]);
        }
        same(case, &scaled, "a power of two")?;
        if recipe.edge.is_some() {
            // These coordinates fill the mantissa: a shift would round them.
            return Ok(vec!["scaled only".into()]);
        }
        let shift = [512., -1024., 3.];
        same(case, &mapped(case, |p| [p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]]), "a shift")?;
        same(case, &mapped(case, |p| [p[1], p[2], p[0]]), "a turn")
    });
}

/// A mirror image with all triangles turned round has its normals reversed: what was the top is the bottom. A slab's
/// diagonals run from `lo` to `hi`, so the order is reversed with them.
#[test]
fn mirror_images() {
    run(5, |_, case| {
        let mut mirrored = mapped(case, |p| [-p[0], p[1], p[2]]);
        mirrored.shell.faces.iter_mut().for_each(|f| f.swap(0, 1));
        mirrored.mesh.faces.iter_mut().for_each(|f| f.swap(0, 1));
        same(case, &mirrored, "a mirror and a turn of all triangles")?;
        let mut flipped = case.clone();
        std::mem::swap(&mut flipped.shell.bottom, &mut flipped.shell.top);
        flipped.shell.faces.iter_mut().for_each(|f| f.swap(0, 1));
        flipped.mesh.faces.iter_mut().for_each(|f| f.swap(0, 1));
        flipped.order.reverse();
        same(case, &flipped, "top and bottom exchanged")
    });
}

/// Another triangulation of the same surface. Only where the new points are exact, and not for C3+, which looks at
/// triangles one by one (a part of a triangle touches fewer tets).
#[test]
fn refined_meshes() {
    run(5, |recipe, case| {
        let mut refined = case.clone();
        if recipe.edge.is_some() {
            return Ok(vec!["not exact".into()]);
        }
        // Faces at a mean of their corners and edges at their middles, one to three times.
        for k in 0..=recipe.order % 3 {
            let (kind, at) =
                ([15, 5][usize::from(recipe.order >> k) % 2], (recipe.order >> (2 * k)).to_le_bytes()[0]);
            edit(&mut refined.mesh, &case.shell, &Edit { kind, at, pick: [0; 3] });
        }
        let (coarse, fine) = (verdicts(case)?, verdicts(&refined)?);
        match (coarse, fine) {
            (Some(mut a), Some(mut b)) => {
                let i2 = (a.pop(), b.pop());
                if a != b || i2 == (Some(true), Some(false)) {
                    return Err(format!("a split triangle changes the verdicts {a:?} to {b:?}, C3+ {i2:?}"));
                }
                Ok(vec!["decided".into()])
            }
            (None, None) => Ok(vec!["refused".into()]),
            (a, b) => Err(format!("{a:?} and {b:?}")),
        }
    });
}

#[test]
fn certificates_do_not_depend_on_threads() {
    let pool = |n| rayon::ThreadPoolBuilder::new().num_threads(n).build().unwrap();
    let (one, two) = (pool(1), pool(2));
    run(3, |_, case| {
        let options = Options { claims: Claim::ALL.to_vec(), order: case.vertex_order() };
        let write = || certify(&case.shell, Some(&case.mesh), &options, &Silent).map(|o| o.certificate);
        match (one.install(write), two.install(write)) {
            (Ok(a), Ok(b)) if a == b => Ok(vec!["equal".into()]),
            (Err(a), Err(b)) if a.to_string() == b.to_string() => Ok(vec!["refused".into()]),
            (a, b) => Err(format!("{a:?}\n{b:?}")),
        }
    });
}
