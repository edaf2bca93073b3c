//! Small shells and meshes with known verdicts: the controls of `certs/corpus`.
// Each test binary uses its part.
#![allow(dead_code)]
// Helpers of tests may panic; clippy knows that only inside `#[test]` functions.
#![allow(clippy::unwrap_used)]

mod prisms;

use homeo::certify::{Claim, Options, Silent, VertexOrder};
use homeo::construct::{InitialOptions, Thickness};
use homeo::mesh::TriMesh;
use homeo::shell::Shell;

pub(crate) type Point = [f64; 3];

/// A shell and a mesh with the verdicts that they must get.
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) shell: Shell,
    pub(crate) mesh: TriMesh,
    pub(crate) options: Options,
    /// The claims that are refuted; all others are certified.
    pub(crate) refuted: &'static [Claim],
    /// A line that the certificate must hold (a prefix of one of its lines).
    pub(crate) shows: &'static [&'static str],
}

/// A shell over points with the same offset down and up at each vertex.
pub(crate) fn extruded(middle: &[Point], faces: &[[u32; 3]], down: Point, up: Point) -> Shell {
    let moved = |d: Point| middle.iter().map(|p| [p[0] + d[0], p[1] + d[1], p[2] + d[2]]).collect();
    Shell { bottom: moved(down), middle: middle.to_vec(), top: moved(up), faces: faces.to_vec() }
}

/// A shell whose pillars point away from the origin.
pub(crate) fn radial(middle: &[Point], faces: &[[u32; 3]], inner: f64, outer: f64) -> Shell {
    let scaled = |s: f64| middle.iter().map(|p| p.map(|x| x * s)).collect();
    Shell { bottom: scaled(inner), middle: middle.to_vec(), top: scaled(outer), faces: faces.to_vec() }
}

pub(crate) fn mesh(vertices: &[Point], faces: &[[u32; 3]]) -> TriMesh {
    TriMesh { vertices: vertices.to_vec(), faces: faces.to_vec() }
}

fn lifted(points: &[Point], z: f64) -> Vec<Point> {
    points.iter().map(|p| [p[0], p[1], p[2] + z]).collect()
}

const UP: Point = [0.0, 0.0, 1.0];
const DOWN: Point = [0.0, 0.0, -1.0];

/// The unit octahedron.
fn octahedron() -> (Vec<Point>, Vec<[u32; 3]>) {
    let v = vec![[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], UP, DOWN];
    let f = vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    (v, f)
}

/// Each triangle in four, new vertices pushed out to about the unit sphere on a grid of 1/256.
pub(crate) fn subdivided(vertices: &[Point], faces: &[[u32; 3]]) -> (Vec<Point>, Vec<[u32; 3]>) {
    let mut v = vertices.to_vec();
    let mut mids: std::collections::BTreeMap<[u32; 2], u32> = std::collections::BTreeMap::new();
    let mut out = Vec::new();
    for &[a, b, c] in faces {
        let mut mid = |p: u32, q: u32| {
            *mids.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                let (p, q) = (v[p as usize], v[q as usize]);
                let m = [p[0] + q[0], p[1] + q[1], p[2] + q[2]];
                let length = (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]).sqrt();
                v.push(m.map(|x| (256.0 * x / length).round() / 256.0));
                u32::try_from(v.len() - 1).unwrap()
            })
        };
        let (x, y, z) = (mid(a, b), mid(b, c), mid(c, a));
        out.extend([[a, x, z], [x, b, y], [z, y, c], [x, y, z]]);
    }
    (v, out)
}

/// A square of `n` by `n` cells from the origin, each of side 4, diagonals alternating when `alternate`.
pub(crate) fn grid(n: u32, z: f64, alternate: bool) -> (Vec<Point>, Vec<[u32; 3]>) {
    let at = |i: u32, j: u32| i * (n + 1) + j;
    let mut v = Vec::new();
    for i in 0..=n {
        for j in 0..=n {
            v.push([4.0 * f64::from(i), 4.0 * f64::from(j), z]);
        }
    }
    let mut f = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if alternate && (i + j) % 2 == 1 {
                f.extend([[a, b, d], [b, c, d]]);
            } else {
                f.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    (v, f)
}

/// A ring around the z axis that goes `turns` times around before it closes; eight steps a turn.
pub(crate) fn ring(turns: u32, z: f64) -> (Vec<Point>, Vec<[u32; 3]>) {
    let around = [
        [1.0, 0.0],
        [1.0, 1.0],
        [0.0, 1.0],
        [-1.0, 1.0],
        [-1.0, 0.0],
        [-1.0, -1.0],
        [0.0, -1.0],
        [1.0, -1.0],
    ];
    let n = 8 * turns;
    let mut v = Vec::new();
    for i in 0..n {
        let [x, y] = around[i as usize % 8];
        v.extend([[2.0 * x, 2.0 * y, z], [4.0 * x, 4.0 * y, z]]);
    }
    let f = (0..n).flat_map(|i| {
        let j = (i + 1) % n;
        let [inner, outer, outer_next, inner_next] = [2 * i, 2 * i + 1, 2 * j + 1, 2 * j];
        [[inner, outer, outer_next], [inner, outer_next, inner_next]]
    });
    (v, f.collect())
}

fn case(
    name: &'static str,
    shell: Shell,
    mesh: TriMesh,
    refuted: &'static [Claim],
    shows: &'static [&'static str],
) -> Case {
    Case { name, shell, mesh, options: Options::default(), refuted, shows }
}

/// Claims that fall with C2.
const NO_SECTION: &[Claim] = &[Claim::Section, Claim::Bijection, Claim::SectionAllOrders, Claim::I2];
const NO_SECTION_CROSSING: &[Claim] =
    &[Claim::Section, Claim::Bijection, Claim::SectionAllOrders, Claim::Disjoint, Claim::I2];

/// Two joined triangles, points `z` above the ground.
fn pair(z: f64) -> (Vec<Point>, Vec<[u32; 3]>) {
    (vec![[0.0, 0.0, z], [4.0, 0.0, z], [4.0, 4.0, z], [0.0, 4.0, z]], vec![[0, 1, 2], [0, 2, 3]])
}

/// All cases.
pub(crate) fn cases() -> Vec<Case> {
    let mut out = certified();
    out.extend(refuted_lifts());
    out.extend(refuted_shells());
    out.extend(prisms::cases());
    out
}

fn certified() -> Vec<Case> {
    let (v0, f0) = octahedron();
    let (v1, f1) = subdivided(&v0, &f0);
    let (v2, f2) = subdivided(&v1, &f1);
    let ball = radial(&v2, &f2, 0.875, 1.125);
    let (p, q) = grid(2, 0.0, false);
    let (tp, tq) = grid(2, 0.25, true);
    let flat = extruded(&p, &q, DOWN, UP);
    let listed =
        Options { order: VertexOrder::from_list((0..9).rev().collect(), 9).unwrap(), ..Options::default() };
    let only_c1 = Options { claims: vec![Claim::Positivity], ..Options::default() };
    let only_c2 = Options { claims: vec![Claim::Section], ..Options::default() };
    let (rv, rf) = ring(1, 0.0);
    vec![
        case("ball", ball.clone(), mesh(&v2, &f2), &[], &["d middle 0 0"]),
        Case {
            name: "ball-positivity",
            options: only_c1,
            ..case("", ball, mesh(&v2, &f2), &[], &["counts"])
        },
        case("patch", flat.clone(), mesh(&tp, &tq), &[], &["v 0 m0,t0", "sep "]),
        Case {
            name: "patch-order",
            options: listed,
            ..case("", flat.clone(), mesh(&tp, &tq), &[], &["order list 8 7"])
        },
        Case {
            name: "patch-section",
            options: only_c2,
            ..case("", flat, mesh(&tp, &tq), &[], &["claim bijection"])
        },
        case("ring", extruded(&rv, &rf, DOWN, UP), mesh(&lifted(&rv, 0.25), &rf), &[], &["d mesh"]),
        pinched(),
        beveled_box(),
        case("coarse-ball", radial(&v1, &f1, 0.625, 1.25), mesh(&v2, &f2), &[], &["d middle 0 0"]),
    ]
}

/// The initial shell of a leaning box, beveled: rounded points, and stated planes in every block that can hold them.
fn beveled_box() -> Case {
    let v: Vec<Point> = (0..8u8).map(|i| [0, 1, 2].map(|k| f64::from(i >> k & 1))).collect();
    // Leaning, so that edges of prisms pass edges of triangles.
    let v: Vec<Point> = v.iter().map(|[x, y, z]| [x + 0.75 * y, y + 0.5 * z, z + 0.25 * x]).collect();
    let sides = [[0u32, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let f: Vec<[u32; 3]> = sides.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let cube = mesh(&v, &f);
    let built = homeo::construct::initial(
        &cube,
        &InitialOptions { thickness: Thickness::Share(0.25), ..InitialOptions::default() },
        &Silent,
    )
    .unwrap();
    case("box", built.shell, cube, &[], &["contact-sep ", "sep "])
}

/// A fan around a pinched vertex.
fn pinched() -> Case {
    let v = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [2.0, 4.0, 0.0],
        [-2.0, 4.0, 0.0],
        [-4.0, 0.0, 0.0],
        [-2.0, -4.0, 0.0],
        [2.0, -4.0, 0.0],
    ];
    let f: Vec<[u32; 3]> = (1..=6).map(|i| [0, i, i % 6 + 1]).collect();
    let mut shell = extruded(&v, &f, DOWN, UP);
    shell.bottom[0] = v[0];
    shell.top[0] = v[0];
    let mut points = v.to_vec();
    points.iter_mut().skip(1).for_each(|p| p[2] = 0.25);
    case("pinched", shell, mesh(&points, &f), &[], &["pinched 48 0"])
}

fn refuted_lifts() -> Vec<Case> {
    let (m, f) = pair(0.0);
    let flat = extruded(&m, &f, DOWN, UP);
    let bent = |z: f64| {
        let mut t = pair(0.25).0;
        t[1][2] = z;
        mesh(&t, &f)
    };
    // Over the square, with a vertex inside that is pulled over the opposite corner's edge.
    let folded = mesh(
        &[[0.0, 0.0, 0.25], [4.0, 0.0, 0.25], [4.0, 4.0, 0.25], [0.0, 4.0, 0.25], [5.0, 1.0, 0.5]],
        &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    );
    let mut inside = folded.clone();
    inside.vertices[4] = [2.0, 1.0, 0.5];
    inside.vertices.push([1.0, 2.0, 0.25]);
    inside.faces = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 5], [0, 4, 5], [4, 3, 5]];
    let mut overlap = inside.clone();
    overlap.vertices[5] = [3.5, 2.0, 0.25];
    let small = mesh(&[[1.0, 0.5, 0.25], [3.0, 1.0, 0.25], [3.0, 3.0, 0.25], [1.0, 3.0, 0.25]], &f);
    let shifted = mesh(&[[0.0, 0.0, 9.0], [4.0, 0.0, 9.0], [4.0, 4.0, 9.0], [0.0, 4.0, 9.0]], &f);
    let (r1, rf1) = ring(1, 0.0);
    let (r2, rf2) = ring(2, 0.0);
    let (t1, _) = ring(1, 0.25);
    let (t2, _) = ring(2, 0.25);
    let both = |a: &[Point], b: &[Point]| [a, b].concat();
    let twice_f: Vec<[u32; 3]> = f.iter().copied().chain(f.iter().map(|t| t.map(|v| v + 4))).collect();
    let far: Vec<Point> = m.iter().map(|p| [p[0] + 100.0, p[1], p[2]]).collect();
    let far_shell = extruded(&both(&m, &far), &twice_f, DOWN, UP);
    let two_in_one = mesh(&both(&pair(0.25).0, &pair(0.5).0), &twice_f);
    let two = mesh(&both(&pair(0.25).0, &lifted(&far, 0.25)), &twice_f);
    let (rv, rf) = ring(1, 0.25);
    vec![
        case("cap", flat.clone(), bent(2.0), NO_SECTION_CROSSING, &["cap"]),
        case("touches-cap", flat.clone(), bent(1.0), NO_SECTION_CROSSING, &["cap"]),
        case("outside", flat.clone(), shifted, NO_SECTION, &["root 0 1 1 1"]),
        case("fold", flat.clone(), overlap, NO_SECTION, &["fold"]),
        case("wall", flat.clone(), folded, NO_SECTION, &["root"]),
        case("boundary", flat.clone(), small, NO_SECTION, &["boundary"]),
        case("inside", flat.clone(), inside, &[], &["d mesh"]),
        case("components", flat.clone(), two.clone(), NO_SECTION, &["topology components 2 1"]),
        case("euler", flat, mesh(&rv, &rf), NO_SECTION, &["topology euler 0 1"]),
        case("two-components", far_shell.clone(), two, &[], &["d middle"]),
        case("lands", far_shell, two_in_one, NO_SECTION, &["lands"]),
        case("twice", extruded(&r1, &rf1, DOWN, UP), mesh(&t2, &rf2), NO_SECTION_CROSSING, &["twice"]),
        case("monodromy", extruded(&r2, &rf2, DOWN, UP), mesh(&t1, &rf1), NO_SECTION, &["monodromy"]),
        case("winds-twice", extruded(&r2, &rf2, DOWN, UP), mesh(&t2, &rf2), &[Claim::Disjoint], &["cross"]),
    ]
}

fn refuted_shells() -> Vec<Case> {
    let (m, f) = pair(0.0);
    let mut damaged = extruded(&m, &f, DOWN, UP);
    damaged.top[1] = [4.0, 0.0, -0.5];
    let mut partly = extruded(&m, &f, DOWN, UP);
    partly.top[1] = [0.0, -4.0, 1.0];
    let mut flat_tet = extruded(&m, &f, DOWN, UP);
    flat_tet.top[1] = [4.0, 0.0, 0.0];
    let tetra = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let tetra_f = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    // THEORY section 3: every order with 0 < 1 passes, every order with 1 < 0 fails.
    let middle = [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [4.0, 8.0, 0.0], [4.0, -8.0, 0.0]];
    let mut closed_tet = extruded(&middle, &[[0, 1, 2], [1, 0, 3]], [0.0, 0.0, -4.0], [0.0, -2.0, 4.0]);
    closed_tet.top[0] = [0.0, 2.0, 4.0];
    let mut t = middle.to_vec();
    t.extend([[6.5, 0.125, 0.25], [7.5, 0.125, 0.25], [7.0, 0.25, 0.5]]);
    let tf = [[4, 5, 6], [0, 1, 4], [1, 5, 4], [1, 2, 5], [2, 6, 5], [2, 4, 6], [0, 4, 2], [1, 0, 3]];
    // A mesh vertex inside the wall tet of a boundary side: the order that flips the wall leaves it outside.
    let corner = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [2.0, 4.0, 0.0]];
    let mut leaning = extruded(&corner, &[[0, 1, 2]], DOWN, UP);
    leaning.top = vec![[0.0, 1.0, 1.0], [4.0, -1.0, 1.0], [2.0, 4.0, 1.0]];
    let low_points = [&corner[..], &[[2.0, 0.0, 0.125]]].concat();
    let low = mesh(&low_points, &[[0, 1, 3], [1, 2, 3], [2, 0, 3]]);
    let mut two_pinched = radial(&tetra, &tetra_f, 0.5, 1.5);
    for v in [0, 2] {
        two_pinched.bottom[v] = tetra[v];
        two_pinched.top[v] = tetra[v];
    }
    vec![
        case("boundary-wall", leaning, low, &[Claim::SectionAllOrders, Claim::I2], &["first 1 0"]),
        case("pinched-edge", two_pinched, mesh(&tetra, &tetra_f), NO_SECTION_CROSSING, &["cap"]),
        case("bad-tet", damaged, mesh(&m, &f), BAD_TET, &["tet "]),
        case("bad-tet-unused", partly, mesh(&m, &f), BAD_UNUSED, &["tet "]),
        case("flat-tet", flat_tet, mesh(&m, &f), BAD_TET, &["tet "]),
        case(
            "tetrahedron",
            radial(&tetra, &tetra_f, 0.5, 1.5),
            mesh(&tetra, &tetra_f),
            &[Claim::I2],
            &["contact "],
        ),
        case("closed-tet", closed_tet, mesh(&t, &tf), &[Claim::SectionAllOrders, Claim::I2], &["first "]),
    ]
}

const BAD_TET: &[Claim] = &Claim::STANDARD;
const BAD_UNUSED: &[Claim] = &[Claim::Positivity, Claim::SectionAllOrders, Claim::I2];
