//! What signs say of a draft, and what is known of prisms that stay, against proofs and witnesses about all of them.

use super::conditions::{Known, Wrong, touches_wrongly, wrong};
use super::{Against, Patience, overlap, reduce};
use crate::certify::complex::{Boundary, MeshView};
use crate::certify::disjoint::{self, About};
use crate::certify::{Silent, i2, positivity};
use crate::construct::bevel::{Input, bevel};
use crate::construct::boundary::Pillars;
use crate::construct::direction::{Direction, directions};
use crate::construct::draft::Draft;
use crate::construct::icosphere;
use crate::construct::optimise::prism::{Pillar, Prism};
use crate::construct::optimise::tree::Tree;
use crate::mesh::{Connectivity, TriMesh};
use crate::predicate::dot_sign;
use crate::shell::{Layer, Name, Shell, Slab};
use crate::testing::{Random, joined, torus};

/// The slabs that break the first condition that some break, by the certifier's planes, common points and determinants.
fn certified(draft: &Draft, against: &Against<'_>, view: &MeshView<'_>) -> Wrong {
    let shell = draft.shell();
    let slab =
        |names: &[Name]| if names.iter().any(|n| n.layer == Layer::Top) { Slab::Top } else { Slab::Bottom };
    let counts = |f: u32, p: u32| {
        let [f, origin] = [f, draft.origin[p as usize]].map(|f| against.mesh.faces[f as usize]);
        against.all || f.iter().any(|v| origin.contains(v))
    };
    let bad = positivity::decide(&shell, &Silent).unwrap().bad;
    if !bad.is_empty() {
        return (bad.iter().map(|b| (b.prism, slab(&b.names))).collect(), "the prism is not positive");
    }
    let mut wrong = Vec::new();
    for (about, slab) in [(About::Bottom, Slab::Bottom), (About::Top, Slab::Top)] {
        let crossings = disjoint::decide(view, &shell, about, &Silent).unwrap().crossings;
        wrong.extend(crossings.iter().filter(|c| counts(c.first, c.second)).map(|c| (c.second, slab)));
    }
    if !wrong.is_empty() {
        return (wrong, "the mesh meets bottom or top");
    }
    let contacts = i2::decide(view, &shell, &Silent).unwrap().contacts;
    let counting = contacts.iter().filter(|c| counts(c.face, c.prism));
    (
        counting.map(|c| (c.prism, slab(&c.names))).collect(),
        "a triangle touches the prism in the wrong direction",
    )
}

/// Shrinks pillars that are all too long to begin with. How often each condition was the one that failed.
fn shrink(mesh: &TriMesh, most: f64, all: bool, pinch: usize, no_overlap: bool) -> [usize; 4] {
    let connectivity = Connectivity::new(mesh.vertices.len(), &mesh.faces).unwrap();
    let boundary = Boundary::new(&connectivity);
    let view = MeshView {
        vertices: &mesh.vertices,
        faces: &mesh.faces,
        connectivity: &connectivity,
        boundary: &boundary,
    };
    let found = directions(mesh, &connectivity);
    let proved = |d: &Direction| if let Direction::Proved(d) = d { Some(*d) } else { None };
    let mut direction: Vec<[f64; 3]> = found.iter().map(|d| proved(d).unwrap_or_default()).collect();
    let mut pinched: Vec<bool> = found.iter().map(|d| proved(d).is_none()).collect();
    pinched.iter_mut().step_by(97).take(pinch).for_each(|p| *p = true);
    let pillars =
        Pillars { mesh, connectivity: &connectivity, direction: &mut direction, pinched: &mut pinched };
    { pillars }.settle();
    let input = Input { mesh, connectivity: &connectivity, direction: &direction, pinched: &pinched };
    let mut draft = bevel(&input, &input.to_bevel());
    draft.up.fill(most);
    draft.down.fill(most);
    let tree = Tree::new(mesh);
    let against = Against { mesh, connectivity: &connectivity, tree: &tree, all };
    let (mut patience, mut known) = (Patience::new(&draft), Known::nothing(draft.faces.len()));
    let sorted = |(mut slabs, reason): Wrong| {
        slabs.sort_unstable();
        slabs.dedup();
        (slabs, reason)
    };
    let mut failures = [0; 4];
    loop {
        let wanted = sorted(certified(&draft, &against, &view));
        let mut found = sorted(wrong(&draft, &against, &view, &mut known, &Silent).unwrap());
        assert_eq!(found.0, wanted.0, "after {failures:?} rounds");
        assert!(found.0.is_empty() || found.1 == wanted.1, "{found:?}, not {wanted:?}");
        if no_overlap && found.0.is_empty() {
            let slabs = overlap::slabs(&draft.shell(), &Silent).unwrap();
            found = sorted((slabs, "overlap"));
        }
        if found.0.is_empty() {
            return failures;
        }
        let kinds = ["the prism is not", "the mesh meets", "a triangle touches", "overlap"];
        failures[kinds.iter().position(|k| found.1.starts_with(k)).unwrap()] += 1;
        let stuck = reduce(&mut draft, mesh, (&found.0, found.1), &mut patience, &mut known);
        assert!(stuck.is_empty(), "{stuck:?} after {failures:?} rounds");
    }
}

#[test]
fn signs_say_what_the_certifier_proves_and_stay_true() {
    let moved = |mesh: &TriMesh, by: f64| {
        let mut out = mesh.clone();
        out.vertices.iter_mut().for_each(|p| p[0] += by);
        out
    };
    let ball = icosphere(2);
    let mut open = icosphere(3);
    open.faces.drain(..300);
    let mut rough = icosphere(3);
    let mut random = Random(41);
    rough.vertices.iter_mut().for_each(|p| *p = p.map(|x| x * (1.0 + 0.04 * random.real())));
    let close = joined(&ball, &moved(&ball, 2.05));
    let crossing = joined(&ball, &moved(&ball, 1.2));
    // A small ball that is wholly within prisms of the large one.
    let mut small = icosphere(0);
    small.vertices.iter_mut().for_each(|p| *p = p.map(|x| 0.02 * x));
    let near = joined(&icosphere(1), &moved(&small, 1.3));
    let mut failures = [0; 4];
    for (mesh, all, pinch, no_overlap) in [
        (&ball, true, 1, false),
        (&torus(16), true, 2, false),
        (&rough, true, 4, false),
        (&open, true, 0, false),
        (&close, true, 0, false),
        (&close, true, 1, true),
        (&crossing, false, 1, false),
        (&near, true, 0, false),
    ] {
        let rounds = shrink(mesh, 1.5, all, pinch, no_overlap);
        failures.iter_mut().zip(rounds).for_each(|(all, n)| *all += n);
    }
    assert!(failures.iter().all(|&n| n > 2), "{failures:?}");
}

/// A prism on a small grid with pillars that lean, and a triangle that faces some of them: the slabs with a contact by the certifier.
#[test]
fn a_triangle_touches_wrongly_where_the_certifier_finds_a_contact() {
    let mut random = Random(43);
    // By slab: contacts or none, where the triangle faces some of its pillars, not all.
    let (mut seen, mut partly) = ([0; 2], [0; 2]);
    for _ in 0..30_000 {
        let mut near = |[x, y, z]: [f64; 3], by: usize| {
            let mut c = |x: f64| x + f64::from(u32::try_from(random.below(by)).unwrap());
            [c(x), c(y), c(z)]
        };
        let middle = [[0.0; 3], [6.0, 0.0, 0.0], [0.0, 6.0, 0.0]];
        let top = middle.map(|[x, y, _]| near([x - 2.0, y - 2.0, 1.0], 5));
        let bottom = middle.map(|[x, y, _]| near([x - 2.0, y - 2.0, -5.0], 5));
        let triangle = [(); 3].map(|()| near([-1.0, -1.0, -3.0], 7));
        let [a, b, c] = &triangle;
        let faces = vec![[0, 1, 2]];
        let shell =
            Shell { bottom: bottom.into(), middle: middle.into(), top: top.into(), faces: faces.clone() };
        if crate::predicate::collinear(a, b, c) || !positivity::bad_slabs(&shell, &Silent).unwrap().is_empty()
        {
            continue;
        }
        let mesh = TriMesh { vertices: triangle.into(), faces };
        let connectivity = Connectivity::new(3, &mesh.faces).unwrap();
        let boundary = Boundary::new(&connectivity);
        let view = MeshView {
            vertices: &mesh.vertices,
            faces: &mesh.faces,
            connectivity: &connectivity,
            boundary: &boundary,
        };
        let contacts = i2::decide(&view, &shell, &Silent).unwrap().contacts;
        let pillar = |k: usize| Pillar { bottom: bottom[k], middle: middle[k], top: top[k] };
        let prism = Prism { pillars: [0, 1, 2].map(pillar), pinched: [false; 3] };
        for slab in Slab::BOTH {
            let is_top = |names: &[Name]| names.iter().any(|n| n.layer == Layer::Top);
            let wanted = contacts.iter().any(|c| is_top(&c.names) == (slab == Slab::Top));
            assert_eq!(touches_wrongly(&prism, slab, [a, b, c]), wanted, "{slab:?} {shell:?} {mesh:?}");
            let up = prism.pillars.iter().filter(|pillar| {
                let [lo, hi] = pillar.half(slab);
                dot_sign(a, b, c, lo, hi).is_positive()
            });
            seen[usize::from(wanted)] += 1;
            partly[usize::from(wanted)] += usize::from([1, 2].contains(&up.count()));
        }
    }
    assert!(seen.iter().chain(&partly).all(|&n| n > 500), "{seen:?} {partly:?}");
}
