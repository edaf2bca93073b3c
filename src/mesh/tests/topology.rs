//! Connectivity and validation against definitions, searched by brute force.

use super::connectivity::Side;
use super::*;
use DefectKind::*;
use dashu_int::IBig;
use proptest::prelude::*;
use std::collections::BTreeSet;

const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];

/// A mesh over points in general position on the moment curve.
fn curve(n: u32, faces: &[[u32; 3]]) -> TriMesh {
    let vertices = (0..n).map(f64::from).map(|t| [t, t * t, t * t * t]).collect();
    TriMesh { vertices, faces: faces.to_vec() }
}

/// The kinds of defects with their counts.
fn defects(mesh: &TriMesh) -> Vec<(DefectKind, u64)> {
    validate(mesh).unwrap().info.defects
}

fn first_error(mesh: &TriMesh) -> String {
    check(mesh).unwrap_err().to_string()
}

#[test]
fn tetrahedron_is_valid() {
    let mesh = curve(4, &TETRAHEDRON);
    let valid = check(&mesh).unwrap();
    let info = valid.info();
    assert_eq!((info.edges, info.euler_characteristic, info.genus, info.boundary_loops), (6, 2, Some(0), 0));
    assert_eq!(info.bounding_box, Some([[0.0; 3], [3.0, 9.0, 27.0]]));
    // Side i is opposite to corner i: face 0 = (0 2 1) has side 0 = (2 1), shared with face 2.
    assert_eq!(valid.connectivity().neighbours(0), [Some(2), Some(1), Some(3)]);
    assert_eq!(valid.connectivity().ends(Side::new(0, 0)), [2, 1]);
    assert_eq!(valid.connectivity().star(3).iter().map(|c| c.face()).collect::<Vec<_>>(), [1, 2, 3]);
}

#[test]
fn each_defect() {
    assert_eq!(first_error(&curve(3, &[])), "the mesh has no faces");
    assert_eq!(
        first_error(&curve(3, &[[0, 1, 2], [0, 1, 3]])),
        "face 1: vertex index 3 is out of range (the mesh has 3 vertices)"
    );
    let mut mesh = curve(3, &[[0, 1, 2]]);
    mesh.vertices[1][2] = f64::NAN;
    assert_eq!(first_error(&mesh), "vertex 1: coordinate z is NaN, not a finite number");
    assert_eq!(validate(&mesh).unwrap().info.bounding_box, None);
    mesh.vertices[1][2] = f64::NEG_INFINITY;
    assert_eq!(first_error(&mesh), "vertex 1: coordinate z is -inf, not a finite number");
    for face in [[1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 1, 1]] {
        assert_eq!(first_error(&curve(2, &[face])), "face 0: vertex 1 stands at two corners");
    }
    let mut flat = curve(3, &[[0, 1, 2]]);
    flat.vertices[2] = [0.5, 0.5, 0.5];
    assert_eq!(first_error(&flat), "face 0: the area is exactly zero (vertices 0 1 2)");
    let pillow = curve(3, &[[0, 1, 2], [2, 1, 0]]);
    assert_eq!(first_error(&pillow), "faces 0 and 1 have the same three vertices");
    let book = curve(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    assert_eq!(first_error(&book), "edge 0 1 lies in 3 faces, among them 0 1 2");
    let twisted = curve(4, &[[0, 1, 2], [0, 1, 3]]);
    assert_eq!(first_error(&twisted), "edge 0 1: faces 0 and 1 are oriented against each other");
    let bow = curve(5, &[[0, 1, 2], [2, 3, 4]]);
    assert_eq!(first_error(&bow), "vertex 2: its link has 2 parts");
    assert_eq!(validate(&bow).unwrap().info.genus, None);
}

#[test]
fn allowed_peculiarities() {
    let mut mesh = curve(6, &TETRAHEDRON);
    mesh.vertices[4] = [-0.0, 0.0, -0.0];
    mesh.vertices[5] = mesh.vertices[1];
    let report = validate(&mesh).unwrap();
    assert!(report.is_valid() && check(&mesh).is_ok());
    assert_eq!(report.info.defects, [(UnreferencedVertex, 2), (CoincidentVertices, 2)]);
    let text: Vec<String> = report.listed.iter().map(ToString::to_string).collect();
    assert_eq!(text[0], "vertex 4 is in no face");
    assert_eq!(
        text[2..],
        ["vertices 0 and 4 have equal coordinates", "vertices 1 and 5 have equal coordinates"]
    );
    assert_eq!((report.info.euler_characteristic, report.info.genus), (2, Some(0)));
}

#[test]
fn lists_are_capped_and_counts_are_not() {
    let mesh = curve(2, &[[0, 0, 1]; 100]);
    let report = validate(&mesh).unwrap();
    assert_eq!(
        (report.count(RepeatedCorner), report.listed.iter().filter(|d| d.kind() == RepeatedCorner).count()),
        (100, LISTED)
    );
    // Ids are those of the mesh also when faces before were left out.
    let mesh = curve(5, &[[0, 0, 1], [9, 0, 1], [0, 1, 2], [0, 1, 3]]);
    let report = validate(&mesh).unwrap();
    let expected =
        [(IndexOutOfRange, 1), (RepeatedCorner, 1), (InconsistentOrientation, 1), (UnreferencedVertex, 1)];
    assert_eq!(report.info.defects, expected);
    assert!(report.listed.contains(&Defect::InconsistentOrientation { vertices: [0, 1], faces: [2, 3] }));
}

/// A strip of quads closed to a ring, glued straight or with a twist.
fn ring(n: u32, twist: bool) -> Vec<[u32; 3]> {
    let at = |i: u32, side: u32| 2 * (i % n) + (side ^ u32::from(twist && i == n));
    (0..n)
        .flat_map(|i| [[at(i, 0), at(i + 1, 0), at(i, 1)], [at(i, 1), at(i + 1, 0), at(i + 1, 1)]])
        .collect()
}

#[test]
fn surfaces_of_known_type() {
    let facts = |vertices: usize, faces: &[[u32; 3]]| {
        let c = Connectivity::new(vertices, faces).unwrap();
        (c.euler_characteristic(), c.boundary_loop_count(), c.is_orientable(), c.genus())
    };
    assert_eq!(facts(12, &ring(6, false)), (0, 2, true, Some(0)));
    assert_eq!(facts(10, &ring(5, true)), (0, 1, false, None));
    // The seven-vertex torus, and the six-vertex projective plane.
    let torus: Vec<[u32; 3]> =
        (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect();
    assert_eq!(facts(7, &torus), (0, 0, true, Some(1)));
    let plane: Vec<[u32; 3]> =
        (0..5).flat_map(|i| [[5, i, (i + 1) % 5], [i, (i + 1) % 5, (i + 3) % 5]]).collect();
    assert_eq!(facts(6, &plane), (1, 0, false, None));
    assert_eq!(facts(0, &[]), (0, 0, true, Some(0)));
    // Two triangles that touch at a vertex: one loop around each.
    assert_eq!(facts(5, &[[0, 1, 2], [2, 3, 4]]), (1, 2, true, None));
}

/// Sides on the edge `{a, b}`, by the definition.
fn sides_on(faces: &[[u32; 3]], a: u32, b: u32) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    for (f, face) in faces.iter().enumerate() {
        for i in 0..3 {
            let (p, q) = (face[(i + 1) % 3], face[(i + 2) % 3]);
            if (p, q) == (a, b) || (p, q) == (b, a) {
                found.push((f, i));
            }
        }
    }
    found
}

/// Number of connected parts of a graph on `nodes` under `joined`.
fn parts<T: Copy + Ord>(nodes: &[T], joined: impl Fn(T, T) -> bool) -> usize {
    let mut left: BTreeSet<T> = nodes.iter().copied().collect();
    let mut count = 0;
    while let Some(start) = left.pop_first() {
        count += 1;
        let mut stack = vec![start];
        while let Some(node) = stack.pop() {
            let next: Vec<T> = left.iter().copied().filter(|&m| joined(node, m)).collect();
            for m in next {
                left.remove(&m);
                stack.push(m);
            }
        }
    }
    count
}

fn shared(a: [u32; 3], b: [u32; 3]) -> usize {
    a.iter().filter(|v| b.contains(v)).count()
}

fn distinct(faces: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
    faces.into_iter().filter(|&[a, b, c]| a != b && b != c && c != a).collect()
}

proptest! {
    #[test]
    fn agrees_with_brute_force(faces in prop::collection::vec(prop::array::uniform3(0u32..9), 0..14).prop_map(distinct)) {
        let c = Connectivity::new(9, &faces).unwrap();
        let mut edges = 0;
        let mut over = 0;
        let mut same = 0;
        for b in 0..9 {
            for a in 0..b {
                let on = sides_on(&faces, a, b);
                edges += usize::from(!on.is_empty());
                over += u64::from(on.len() > 2);
                let start = |(f, i): (usize, usize)| faces[f][(i + 1) % 3];
                same += u64::from(on.len() == 2 && start(on[0]) == start(on[1]));
                for &(f, i) in &on {
                    let others: Vec<_> = on.iter().filter(|&&s| s != (f, i)).collect();
                    let mate = c.mate(Side::new(u32::try_from(f).unwrap(), u32::try_from(i).unwrap()));
                    let expected = if others.len() == 1 { Some(*others[0]) } else { None };
                    prop_assert_eq!(mate.map(|m| (m.face() as usize, m.corner() as usize)), expected);
                }
            }
        }
        prop_assert_eq!(c.edge_count(), edges);
        let ids: Vec<usize> = (0..faces.len()).collect();
        prop_assert_eq!(c.component_count(), parts(&ids, |a, b| shared(faces[a], faces[b]) >= 2));
        let mut broken = 0;
        for v in 0..9u32 {
            let star: Vec<usize> = ids.iter().copied().filter(|&f| faces[f].contains(&v)).collect();
            prop_assert_eq!(c.star(v).iter().map(|s| s.face() as usize).collect::<Vec<_>>(), star.clone());
            // Two faces at v are joined where their opposite edges share an end, that is an edge at v.
            let expected = parts(&star, |a, b| shared(faces[a], faces[b]) >= 2);
            prop_assert_eq!(c.link_parts(v), expected);
            broken += u64::from(expected > 1);
        }
        let report = validate(&curve(9, &faces)).unwrap();
        prop_assert_eq!(report.count(NonManifoldEdge), over);
        prop_assert_eq!(report.count(InconsistentOrientation), same);
        prop_assert_eq!(report.count(NonManifoldVertex), broken);
        let sets: BTreeSet<[u32; 3]> = faces.iter().map(|f| { let mut s = *f; s.sort_unstable(); s }).collect();
        prop_assert_eq!(report.count(DuplicateFace), (faces.len() - sets.len()) as u64);
        // No three points of the moment curve lie on a line.
        prop_assert_eq!(report.count(ZeroArea), 0);
    }

    #[test]
    fn any_faces_do_not_panic(faces in prop::collection::vec(prop::array::uniform3(0u32..6), 0..12)) {
        let mesh = curve(4, &faces);
        let valid = validate(&mesh).unwrap().is_valid();
        prop_assert_eq!(check(&mesh).is_ok(), valid);
        let all = Connectivity::new(6, &faces).unwrap();
        prop_assert!(all.component_count() <= faces.len());
    }

    #[test]
    fn zero_area_of_any_bits(points in prop::array::uniform3(prop::array::uniform3(
        any::<u64>().prop_map(f64::from_bits).prop_filter("finite", |x| x.is_finite()))), on_line in 0..4) {
        let mut points = points;
        if on_line == 0 { points[2] = points[0]; }
        if on_line == 1 { points[1] = points[0].map(|x| x / 2.0); points[2] = [0.0; 3]; }
        prop_assert_eq!(is_zero_area([&points[0], &points[1], &points[2]]), zero_by_definition(&points));
    }

    /// Multiples of a full-width point by powers of two: on one line, while the float differences
    /// round in each axis by itself, so that a filter with too small a bound answers wrongly.
    #[test]
    fn zero_area_where_differences_round(p in prop::array::uniform3(-1.0f64..1.0), i in 2i32..60, j in 2i32..60,
                                         shift in -400i32..400, bump in 0u64..2) {
        let times = |k: f64| p.map(|x| x * 2f64.powi(shift) * k);
        let mut points = [times(1.0), times(2f64.powi(i)), times(-2f64.powi(j))];
        if bump == 0 {
            prop_assert!(is_zero_area([&points[0], &points[1], &points[2]]));
        }
        points[2][1] = f64::from_bits(points[2][1].to_bits() + bump);
        prop_assert_eq!(is_zero_area([&points[0], &points[1], &points[2]]), zero_by_definition(&points));
    }

    #[test]
    fn zero_area_near_lines(a in prop::array::uniform3(-99i32..99), d in prop::array::uniform3(-9i32..9),
                            m in -9i32..9, n in -9i32..9, scale in -1074i32..900, bump in 0u64..3) {
        let point = |k: i32| [0, 1, 2].map(|i| {
            let unit = if scale < -1022 { f64::from_bits(1u64 << (scale + 1074)) } else { 2f64.powi(scale) };
            f64::from(a[i] + k * d[i]) * unit
        });
        let mut points = [point(0), point(m), point(n)];
        // One bit off the line, sometimes.
        points[2][1] = f64::from_bits(points[2][1].to_bits() + bump / 2);
        prop_assert_eq!(is_zero_area([&points[0], &points[1], &points[2]]), zero_by_definition(&points));
    }
}

/// All coordinates as integers over one power of two, then the cross product.
fn zero_by_definition(points: &[[f64; 3]; 3]) -> bool {
    let exact = points.map(|p| {
        p.map(|x| {
            let bits = x.to_bits();
            let (e, f) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
            let m = if e == 0 {
                IBig::from(f) << 1
            } else {
                IBig::from(f | 1 << 52) << usize::try_from(e).unwrap()
            };
            if bits >> 63 == 1 { -m } else { m }
        })
    });
    let d = |i: usize, k: usize| &exact[i][k] - &exact[0][k];
    [(0, 1), (1, 2), (2, 0)].iter().all(|&(i, j)| d(1, i) * d(2, j) - d(1, j) * d(2, i) == IBig::ZERO)
}

#[test]
fn zero_area_cases() {
    let zero = |p: [[f64; 3]; 3]| is_zero_area([&p[0], &p[1], &p[2]]);
    let tiny = f64::from_bits(1);
    let big = f64::MAX;
    assert!(!zero([[0.0; 3], [tiny, 0.0, 0.0], [0.0, tiny, 0.0]]));
    assert!(zero([[0.0; 3], [tiny; 3], [2.0 * tiny; 3]]));
    assert!(zero([[-big; 3], [0.0; 3], [big; 3]]));
    assert!(!zero([[-big; 3], [0.0, 0.0, tiny], [big; 3]]));
    // In floats 0.1 + 0.2 is not 0.3: these points are not on a line, by one bit.
    assert!(!zero([[0.1, 1.0, 0.0], [0.2, 2.0, 0.0], [0.3, 3.0, 0.0]]));
    assert!(zero([[0.1, 1.0, 0.0], [0.2, 2.0, 0.0], [0.4, 4.0, 0.0]]));
    assert!(!zero([[1e308, -1e308, 0.0], [-1e308, 1e308, 0.0], [1e-308, 0.0, 0.0]]));
}

#[test]
fn too_far_an_index() {
    let error = Connectivity::new(2, &[[0, 1, u32::MAX]]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "face 0: vertex index 4294967295 is out of range (the mesh has 2 vertices)"
    );
    assert_eq!(defects(&curve(4, &TETRAHEDRON)), []);
}
