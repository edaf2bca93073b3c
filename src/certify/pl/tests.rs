//! Small complexes with verdicts known from the definitions.

use super::*;
use crate::certify::{Silent, Verdict};
use crate::mesh::{Cells, Complex, Positions, Space, SurfacePoint, TriMesh};
use crate::number::{Rat, Rational};

fn flat(points: &[[f64; 2]], faces: &[[u32; 3]]) -> Complex {
    let points = points.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
    Complex {
        space: Space::Plane,
        positions: Positions::Float(points),
        cells: Cells::Triangles(faces.to_vec()),
    }
}

fn tets(points: &[[f64; 3]], cells: &[[u32; 4]]) -> Complex {
    Complex {
        space: Space::Space,
        positions: Positions::Float(points.to_vec()),
        cells: Cells::Tets(cells.to_vec()),
    }
}

/// The same positions as rational numbers, divided by three: no verdict depends on that.
fn thirds(complex: &Complex) -> Complex {
    let Positions::Float(points) = &complex.positions else { panic!("doubles") };
    let third = |x: f64| Rat::from_f64(x).unwrap().over(&Rat::from(3)).unwrap();
    let points = points.iter().map(|p| p.map(third)).collect();
    Complex { positions: Positions::Exact(points), ..complex.clone() }
}

/// The verdict, which must be the same in rational numbers, and the kinds of the witnesses of the second input.
fn verdict(a: &Complex, b: &Complex) -> (Verdict, Vec<&'static str>) {
    let outcome = pl_homeomorphism(a, b, &Silent).unwrap();
    let exact = pl_homeomorphism(a, &thirds(b), &Silent).unwrap();
    assert_eq!((outcome.verdict, &outcome.sides[1].witnesses), (exact.verdict, &exact.sides[1].witnesses));
    let kinds = outcome.sides.iter().flat_map(|s| &s.witnesses).map(Witness::kind).collect();
    (outcome.verdict, kinds)
}

const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
const HALVES: [[u32; 3]; 2] = [[0, 1, 2], [0, 2, 3]];

#[test]
fn a_square_and_its_maps() {
    let a = flat(&SQUARE, &HALVES);
    let map = |points: [[f64; 2]; 4]| verdict(&a, &flat(&points, &HALVES));
    let certified = (Verdict::Certified, vec![]);
    assert_eq!(map(SQUARE), certified);
    // Mirrored: a homeomorphism that turns the orientation.
    assert_eq!(map(SQUARE.map(|[x, y]| [y, x])), certified);
    assert_eq!(map([[0.0, 0.0], [3.0, 0.0], [1.0, 1.0], [0.0, 3.0]]), certified);
    // Triangle 0 flat; triangle 1 turned; triangle 0 turned.
    let refuted = (Verdict::Refuted, vec!["sign"]);
    assert_eq!(map([[0.0, 0.0], [1.0, 0.0], [0.5, 0.0], [0.0, 1.0]]), refuted);
    assert_eq!(map([[0.0, 0.0], [1.0, 0.0], [-1.0, 2.0], [0.0, 1.0]]), refuted);
    assert_eq!(map([[0.0, 0.0], [1.0, 0.0], [0.5, -1.0], [0.0, 1.0]]), refuted);
}

/// A strip of triangles around a point, of `n` eighth turns: positive everywhere; it overlaps itself beyond eight.
fn spiral(n: u32) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
    let around = [[2, 0], [2, 2], [0, 2], [-2, 2], [-2, 0], [-2, -2], [0, -2], [2, -2]];
    let at = |i: u32, factor: i32| around[i as usize % 8].map(|x| f64::from(x * factor));
    let points = (0..=n).flat_map(|i| [at(i, 1), at(i, 2)]).collect();
    let faces = (0..n).flat_map(|i| {
        let [a, b, c, d] = [2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2];
        [[a, b, c], [a, c, d]]
    });
    (points, faces.collect())
}

#[test]
fn a_spiral_that_overlaps_itself() {
    for (turns, wanted) in
        [(6, Verdict::Certified), (7, Verdict::Certified), (8, Verdict::Refuted), (11, Verdict::Refuted)]
    {
        let (points, faces) = spiral(turns);
        // The same strip laid out straight.
        let straight: Vec<[f64; 2]> =
            (0..=turns).flat_map(|i| [[f64::from(i), 1.0], [f64::from(i), 0.0]]).collect();
        let (found, kinds) = verdict(&flat(&straight, &faces), &flat(&points, &faces));
        assert_eq!(found, wanted, "{turns}");
        assert!(kinds.iter().all(|k| ["cross", "twice"].contains(k)), "{kinds:?}");
    }
}

#[test]
fn one_component_inside_another() {
    let inner = [[0.25, 0.25], [0.5, 0.25], [0.25, 0.5]];
    let faces = [[0, 1, 2], [3, 4, 5]];
    let outer = [[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
    let apart: Vec<[f64; 2]> = outer.iter().chain(&inner.map(|[x, y]| [x + 5.0, y])).copied().collect();
    let nested: Vec<[f64; 2]> = outer.iter().chain(&inner).copied().collect();
    // No boundary edges cross, all triangles are positive: only the counted point tells.
    let (found, kinds) = verdict(&flat(&apart, &faces), &flat(&nested, &faces));
    assert_eq!((found, kinds), (Verdict::Refuted, vec!["twice"]));
}

const CORNERS: [[f64; 3]; 5] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
const TWO: [[u32; 4]; 2] = [[0, 1, 2, 3], [1, 4, 2, 3]];

#[test]
fn two_tets() {
    let a = tets(&CORNERS, &TWO);
    let moved = |v: usize, to: [f64; 3]| {
        let mut points = CORNERS;
        points[v] = to;
        verdict(&a, &tets(&points, &TWO))
    };
    assert_eq!(moved(4, [2.0, 2.0, 2.0]).0, Verdict::Certified);
    assert_eq!(moved(4, [0.25, 0.25, 0.5]), (Verdict::Refuted, vec!["sign"]));
    assert_eq!(moved(4, [0.25, 0.25, 0.25]), (Verdict::Refuted, vec!["sign"]));
    let outcome = pl_homeomorphism(&a, &a, &Silent).unwrap();
    assert_eq!(outcome.sides[0].facts.boundary_facets, 6);
    assert_eq!(boundary_euler(&a).unwrap(), 2);
    let least = least_determinant(&a).unwrap();
    assert_eq!((least.cell, least.exact.as_str()), (0, "1*2^0"));
}

#[test]
fn two_separate_tets_that_meet() {
    let points: Vec<[f64; 3]> = CORNERS[..4].iter().chain(&CORNERS[..4]).copied().collect();
    let cells = [[0, 1, 2, 3], [4, 5, 6, 7]];
    let shifted = |d: f64| {
        let mut points = points.clone();
        points[4..].iter_mut().for_each(|p| p[0] += d);
        tets(&points, &cells)
    };
    let far = shifted(9.0);
    assert_eq!(verdict(&far, &shifted(2.0)), (Verdict::Certified, vec![]));
    // They touch in one point, with different vertices.
    let (found, kinds) = verdict(&far, &shifted(1.0));
    assert_eq!(found, Verdict::Refuted);
    assert!(kinds.contains(&"cross"));
    assert!(verdict(&far, &shifted(0.5)).1.contains(&"cross"));
}

#[test]
fn complexes_that_are_no_manifolds() {
    let kind = |points: usize, faces: &[[u32; 3]]| {
        let points: Vec<[f64; 2]> = (0..points).map(|i| [i as f64, (i * i) as f64]).collect();
        let complex = flat(&points, faces);
        let outcome = pl_homeomorphism(&complex, &complex, &Silent).unwrap();
        assert_eq!(outcome.verdict, Verdict::Refuted);
        outcome.sides[0].witnesses[0].line(Input::A)
    };
    assert_eq!(kind(3, &[[0, 1, 1]]), "repeated a 0");
    assert_eq!(kind(3, &[[0, 1, 2], [1, 2, 0]]), "twin a 0 1");
    assert_eq!(kind(4, &[[0, 1, 2], [0, 1, 3]]), "direction a 0 1");
    assert_eq!(kind(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]), "facet a 0,1 0 1 2");
    assert_eq!(kind(5, &[[0, 1, 2], [0, 3, 4]]), "vertex a 0 0 1");
    // Two tets on one edge.
    let points: Vec<[f64; 3]> = (0..6).map(|i| [i, i * i, i * i * i].map(f64::from)).collect();
    let bowtie = tets(&points, &[[0, 1, 2, 3], [0, 1, 4, 5]]);
    let found = sound::defect(&facets::Facets::new(&bowtie.cells), 6).unwrap();
    // At either end of the edge the two tets do not hang together.
    assert_eq!(found.line(Input::B), "vertex b 0 0 1");
    // The cone over a ring of triangles: around its tip it is no ball.
    let ring = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];
    let cone = tets(&[[0.0; 3]; 7], &ring.map(|[a, b, c]| [6, a, b, c]));
    let found = sound::defect(&facets::Facets::new(&cone.cells), 7).unwrap();
    assert_eq!(found.line(Input::A), "link a 6");
}

#[test]
fn a_surface_that_crosses_itself() {
    let points = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [1.0, 1.0, -1.0],
        [1.0, 1.0, 1.0],
        [2.0, 2.0, 0.5],
    ];
    let faces = vec![[0, 1, 2], [3, 4, 5]];
    let mut mesh = TriMesh { vertices: points.to_vec(), faces };
    let crossed = embedded(&mesh.clone().into(), &Silent).unwrap();
    assert_eq!(crossed.verdict, Verdict::Refuted);
    assert!(crossed.certificate.contains("\ncross a 0 1 "));
    mesh.vertices[3][2] = 0.25;
    let apart = embedded(&mesh.into(), &Silent).unwrap();
    assert_eq!(apart.verdict, Verdict::Certified);
    assert!(apart.certificate.starts_with("homeo-meshes 1\nclaim embedded certified\ninput a "));
}

#[test]
fn canonical_text() {
    let mut complex = flat(&[[0.0, -0.0], [3.0, -4.0], [0.1, 1.0]], &[[0, 1, 2]]);
    let text = "homeo-complex 1\nspace 2\ncorners 3\nvertices 3\n0 0\n3 -1*2^2\n3602879701896397*2^-55 1\ncells 1\n0 1 2\nend\n";
    assert_eq!(complex_file(&complex), text);
    let half = Rat::from(1) / Rat::from(2);
    let third = Rat::from(-6) / Rat::from(9);
    complex.positions = Positions::Exact(vec![
        [half, third.clone(), Rat::ZERO],
        [Rat::ZERO, Rat::from(12), Rat::ZERO],
        [third.clone(), third, Rat::ZERO],
    ]);
    assert!(complex_file(&complex).contains("\n1*2^-1 -2/3\n0 3*2^2\n-2/3 -2/3\n"));
}

fn place(triangle: u32, weights: [i64; 3]) -> SurfacePoint {
    let sum = Rat::from(weights.iter().sum::<i64>());
    (triangle, weights.map(|w| Rat::from(w) / &sum))
}

#[test]
fn correspondences() {
    let point = |[x, y]: [f64; 2]| [x, y, 0.0];
    let a = TriMesh { vertices: SQUARE.map(point).to_vec(), faces: HALVES.to_vec() };
    // B: the four corners and the middle of the diagonal 0 2.
    let middle = [0.5, 0.5];
    let b = TriMesh {
        vertices: SQUARE.into_iter().chain([middle]).map(point).collect(),
        faces: vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    };
    let at_corners = vec![place(0, [1, 0, 0]), place(0, [0, 1, 0]), place(1, [0, 1, 0]), place(1, [0, 0, 1])];
    let with = |last: SurfacePoint| {
        let places: Vec<SurfacePoint> = at_corners.iter().cloned().chain([last]).collect();
        map_by_correspondence(&a, &b, &places).unwrap()
    };
    assert_eq!(with(place(0, [1, 0, 1])), Mapped::Homeomorphism);
    assert_eq!(with(place(1, [2, 1, 0])), Mapped::Homeomorphism);
    // Off the diagonal, the triangles at 3 would bend.
    assert_eq!(with(place(0, [1, 1, 1])), Mapped::NotAMap(vec![2, 3]));
    assert_eq!(with(place(0, [1, 0, 0])), Mapped::Flat(0));
    // Only half of A is reached, and the boundary is not kept.
    let half = TriMesh { vertices: b.vertices[..3].to_vec(), faces: vec![[0, 1, 2]] };
    assert_eq!(map_by_correspondence(&a, &half, &at_corners[..3]).unwrap(), Mapped::Boundary(0));
    // Corners 1 and 3 changed: turned, but a homeomorphism.
    let mut turned = at_corners.clone();
    turned.swap(1, 3);
    turned.push(place(0, [1, 0, 1]));
    assert_eq!(map_by_correspondence(&a, &b, &turned).unwrap(), Mapped::Homeomorphism);
    // Folded along the diagonal.
    let mut folded = at_corners;
    folded[3] = place(0, [0, 1, 0]);
    folded.push(place(0, [1, 0, 1]));
    assert_eq!(map_by_correspondence(&a, &b, &folded).unwrap(), Mapped::Fold([0, 2]));
}

#[test]
fn coordinates_that_are_no_numbers_have_no_verdict() {
    let mut points = CORNERS;
    points[3][1] = f64::NAN;
    let bad = tets(&points, &TWO);
    let wanted = "vertex 3: a coordinate is not finite";
    assert_eq!(side_facts(&bad, &Silent).unwrap_err().to_string(), wanted);
    assert_eq!(pl_homeomorphism(&tets(&CORNERS, &TWO), &bad, &Silent).unwrap_err().to_string(), wanted);
}

#[test]
fn numbers_that_no_certificate_may_have_are_found_in_either_input() {
    let a = tets(&CORNERS, &TWO);
    let mut long = thirds(&a);
    let Positions::Exact(points) = &mut long.positions else { panic!("rational numbers") };
    points[4][0] = Rat::from_scaled(1, -14_000);
    for (first, second) in [(&a, &long), (&long, &a)] {
        let refused = pl_homeomorphism(first, second, &Silent).unwrap_err().to_string();
        assert!(refused.starts_with("vertex 4: a coordinate has more than 4000 digits"), "{refused}");
    }
}
