//! Shells that overlap themselves, and such that nearly do: cases of `disjoint-prisms`.

use homeo::certify::{Claim, Options, VertexOrder};
use homeo::shell::Shell;

use super::{Case, DOWN, Point, UP, case, extruded, grid, lifted, mesh, octahedron, pair, ring};

const OVERLAP: &[Claim] = &[Claim::DisjointPrisms];

fn about(
    name: &'static str,
    shell: Shell,
    refuted: &'static [Claim],
    shows: &'static [&'static str],
) -> Case {
    // The claim needs no mesh; the middle surface is one, if it is asked for.
    let mesh = mesh(&shell.middle, &shell.faces);
    let options = Options { claims: vec![Claim::DisjointPrisms], ..Options::default() };
    Case { options, ..case(name, shell, mesh, refuted, shows) }
}

/// Two lenses that share a pinched rim: the upper half and the lower half of an octahedron, both above the rim. The
/// heights are those of the bottom, middle and top of the two apexes.
fn lenses(first: [f64; 3], second: [f64; 3]) -> Shell {
    let (_, faces) = octahedron();
    let rim = [[4.0, 0.0, 0.0], [-4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, -4.0, 0.0]];
    let layer = |k: usize| [&rim[..], &[[0.0, 0.0, first[k]], [0.0, 0.0, second[k]]]].concat();
    Shell { bottom: layer(0), middle: layer(1), top: layer(2), faces }
}

/// A patch and, within its upper slab if `low` is small, a second and smaller one.
fn two_patches(low: f64) -> Shell {
    let (p, f) = pair(0.0);
    let small: Vec<Point> =
        [[1.0, 0.5], [3.0, 1.0], [3.0, 3.0], [1.0, 3.0]].map(|[x, y]| [x, y, low + 0.25]).to_vec();
    let mut out = extruded(&p, &f, DOWN, UP);
    let inner = extruded(&small, &f, [0.0, 0.0, -0.125], [0.0, 0.0, 0.125]);
    out.bottom.extend(inner.bottom);
    out.middle.extend(inner.middle);
    out.top.extend(inner.top);
    out.faces.extend(f.iter().map(|t| t.map(|v| v + 4)));
    out
}

pub(super) fn cases() -> Vec<Case> {
    let (p, q) = grid(2, 0.0, false);
    let (r, rf) = ring(2, 0.0);
    let mut flat_tet = two_patches(2.0);
    flat_tet.top[1] = [4.0, 0.0, 0.0];
    let (s, sf) = pair(0.0);
    let stacked = |gap: f64| {
        let points = [s.clone(), lifted(&s, gap)].concat();
        let faces: Vec<[u32; 3]> = sf.iter().copied().chain(sf.iter().map(|t| t.map(|v| v + 4))).collect();
        extruded(&points, &faces, DOWN, UP)
    };
    let order = VertexOrder::from_list((0..9).rev().collect(), 9).unwrap();
    let listed = Options { claims: vec![Claim::DisjointPrisms], order };
    vec![
        about("prisms", extruded(&p, &q, DOWN, UP), &[], &["sep "]),
        Case {
            name: "prisms-order",
            options: listed,
            ..about("", extruded(&p, &q, DOWN, UP), &[], &["sep "])
        },
        about("lenses", lenses([1.0, 2.0, 3.0], [0.5, 0.0, -0.5]), &[], &["pinched 128 0 1 2 3"]),
        about("lenses-crossed", lenses([1.0, 2.0, 3.0], [4.0, 3.5, 2.0]), OVERLAP, &["overlap "]),
        about("patches", two_patches(1.0), &[], &["pinched 0"]),
        about("patch-in-patch", two_patches(0.25), OVERLAP, &["overlap "]),
        about("stacked-touching", stacked(2.0), OVERLAP, &["overlap "]),
        about("wound-ring", extruded(&r, &rf, DOWN, UP), OVERLAP, &["overlap "]),
        about("prisms-flat", flat_tet, OVERLAP, &["tet 0 m0,m1,t1,t2 0"]),
    ]
}
