//! The test cases that THEORY names.
#![allow(clippy::unwrap_used)]

use homeo::certify::{Claim, Options, Outcome, Silent, VertexOrder, certify};
use homeo::mesh::TriMesh;
use homeo::shell::Shell;
use homeo_proptests::Case;
use homeo_proptests::campaign::{compare, holds};
use homeo_proptests::oracle::exact::{on_grid, orient};
use homeo_proptests::oracle::{World, lift};

fn ids(n: usize) -> Vec<u32> {
    (0..u32::try_from(n).unwrap()).collect()
}

fn case(shell: Shell, mesh: TriMesh) -> Case {
    let order = ids(shell.middle.len());
    Case { shell, mesh, order }
}

fn middle(shell: &Shell) -> TriMesh {
    TriMesh { vertices: shell.middle.clone(), faces: shell.faces.clone() }
}

fn decide(case: &Case) -> Outcome {
    let options = Options { claims: Claim::ALL.to_vec(), order: case.vertex_order() };
    certify(&case.shell, Some(&case.mesh), &options, &Silent).unwrap()
}

/// Positive under one order, yet the slab's first and third tet overlap: the lemma needs all orders.
#[test]
fn a_decomposition_that_folds_over_itself() {
    let lo = [[3., 3., 0.], [-2., 1., 1.], [3., 3., -1.]];
    let hi = [[1., 1., -1.], [0., -2., 0.], [0., -1., 0.]];
    // Nine times the points, so that (14, 10, -2)/9 is on the grid.
    let nine = |p: [f64; 3]| p.map(|x| 9. * x);
    let grid = on_grid(&[lo[0], lo[1], lo[2], hi[0], hi[1], hi[2]].map(nine));
    let tets = [[0, 1, 2, 5], [0, 1, 4, 5], [0, 3, 4, 5]];
    let value = |t: [usize; 4]| orient(&grid[t[0]], &grid[t[1]], &grid[t[2]], &grid[t[3]]);
    let unit = dashu_int::IBig::from(729);
    let sizes = tets.map(|t| value(t) / &unit);
    assert_eq!(
        sizes,
        [14, -3, 3].map(dashu_int::IBig::from),
        "the middle tet is listed in its negative order"
    );
    let point = on_grid(&[[14., 10., -2.], [9., 9., 9.]])[0].clone();
    let point = {
        // Undo the grid of the two points alone: they are integers.
        let factor = dashu_int::IBig::from(14) / &point[0];
        point.map(|x| x * &factor)
    };
    for (t, sign) in [(tets[0], 1), (tets[2], 1)] {
        let corner = t.map(|k| &grid[k]);
        for k in 0..4 {
            let mut with = corner;
            with[k] = &point;
            let w = orient(with[0], with[1], with[2], with[3]) * dashu_int::IBig::from(sign);
            assert!(w > dashu_int::IBig::ZERO, "the point is inside");
        }
    }
    // A top slab of such a shell: C1 must see it although the order u < v < w is positive.
    let below = lo.map(|p| [p[0], p[1], p[2] - 64.]);
    let shell =
        Shell { bottom: below.to_vec(), middle: lo.to_vec(), top: hi.to_vec(), faces: vec![[0, 1, 2]] };
    let case = case(shell.clone(), middle(&shell));
    assert!(!holds(&decide(&case), Claim::Positivity));
    compare(&case).unwrap();
}

/// Both slabs are embedded by themselves and overlap: C1 fails, and every verdict is the oracle's.
#[test]
fn two_embedded_slabs_that_overlap() {
    let bottom = vec![[1., 0., 0.], [4., 1., 1.], [0., 3., -1.]];
    let mid = vec![[0., 1., 2.], [4., 0., 2.], [0., 2., 3.]];
    let top = vec![[0., 2., 1.], [2., 1., 0.], [0., 0., 2.]];
    for order in [[0u32, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        for faces in [[0u32, 1, 2], [0, 2, 1]] {
            let shell =
                Shell { bottom: bottom.clone(), middle: mid.clone(), top: top.clone(), faces: vec![faces] };
            let case = Case { order: order.to_vec(), ..case(shell.clone(), middle(&shell)) };
            compare(&case).unwrap();
        }
    }
}

fn closed_tet_case() -> Case {
    let mid = vec![[0., 0., 0.], [8., 0., 0.], [4., 8., 0.], [4., -8., 0.]];
    let by = |v: usize| if v == 0 { [0., 2., 4.] } else { [0., -2., 4.] };
    let add = |p: [f64; 3], q: [f64; 3]| [p[0] + q[0], p[1] + q[1], p[2] + q[2]];
    let top = mid.iter().enumerate().map(|(v, p)| add(*p, by(v))).collect();
    let bottom = mid.iter().map(|p| add(*p, [0., 0., -4.])).collect();
    let mut vertices = mid.clone();
    vertices.extend([[6.5, 0.125, 0.25], [7.5, 0.125, 0.25], [7., 0.25, 0.5]]);
    let faces = vec![[4, 5, 6], [0, 1, 4], [1, 5, 4], [1, 2, 5], [2, 6, 5], [2, 4, 6], [0, 4, 2], [1, 0, 3]];
    let shell = Shell { bottom, middle: mid, top, faces: vec![[0, 1, 2], [1, 0, 3]] };
    case(shell, TriMesh { vertices, faces })
}

/// A triangle in a wall that another order flips: it meets no tet's interior, yet breaks every order with 1 before 0.
#[test]
fn c3_counts_pieces_in_closed_tets() {
    let case = closed_tet_case();
    let outcome = decide(&case);
    assert!(holds(&outcome, Claim::Positivity));
    assert!(holds(&outcome, Claim::Section), "by id");
    assert!(holds(&outcome, Claim::Bijection), "by id");
    assert!(!holds(&outcome, Claim::SectionAllOrders));
    compare(&case).unwrap();
    let mut world = World::new(&case.shell, &case.mesh);
    let mut orders = vec![vec![]];
    for v in ids(4) {
        let longer =
            |o: &Vec<u32>| (0..=o.len()).map(|i| [&o[..i], &[v], &o[i..]].concat()).collect::<Vec<_>>();
        orders = orders.iter().flat_map(longer).collect();
    }
    assert_eq!(orders.len(), 24);
    for order in orders {
        let place = |v: u32| order.iter().position(|x| *x == v);
        let passes = place(0) < place(1);
        let here = Case { order: order.clone(), ..case.clone() };
        let rank = here.rank();
        assert_eq!(lift::section(&mut world, &rank) == lift::Section::Exists, passes, "oracle, {order:?}");
        let options = Options {
            claims: vec![Claim::Section],
            order: VertexOrder::from_list(order.clone(), 4).unwrap(),
        };
        let outcome = certify(&here.shell, Some(&here.mesh), &options, &Silent).unwrap();
        assert_eq!(holds(&outcome, Claim::Section), passes, "certifier, {order:?}");
    }
}

/// C3+ is stricter than C3: a tet touches the next triangle in a vertex, with a dot that is not positive.
#[test]
fn regular_tetrahedron_has_c3_but_not_i2() {
    let mid = vec![[4., 4., 4.], [4., -4., -4.], [-4., 4., -4.], [-4., -4., 4.]];
    let scale = |s: f64| mid.iter().map(|p: &[f64; 3]| p.map(|x| x * s)).collect();
    let faces = vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]];
    for (inner, outer) in [(0.5, 1.5), (0.875, 1.125)] {
        let shell =
            Shell { bottom: scale(inner), middle: mid.clone(), top: scale(outer), faces: faces.clone() };
        let case = case(shell.clone(), middle(&shell));
        let outcome = decide(&case);
        for claim in
            [Claim::Positivity, Claim::Section, Claim::Bijection, Claim::SectionAllOrders, Claim::Disjoint]
        {
            assert!(holds(&outcome, claim), "{claim}");
        }
        assert!(!holds(&outcome, Claim::I2));
        compare(&case).unwrap();
    }
}

/// A triangle that stands in the wall tet of a boundary edge, where its dots are positive: the order that flips the wall
/// leaves it outside. By vertex id there is a section.
#[test]
fn a_boundary_wall_that_cuts_the_mesh_off() {
    let shell = Shell {
        bottom: vec![[0., 0., -1.], [4., 0., -1.], [2., 4., -1.]],
        middle: vec![[0., 0., 0.], [4., 0., 0.], [2., 4., 0.]],
        top: vec![[0., 1., 1.], [4., -1., 1.], [2., 4., 1.]],
        faces: vec![[0, 1, 2]],
    };
    let mut mesh = middle(&shell);
    mesh.vertices.push([2., 0., 0.125]);
    mesh.faces = vec![[0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let case = case(shell, mesh);
    let outcome = decide(&case);
    assert!(holds(&outcome, Claim::Section));
    assert!(!holds(&outcome, Claim::SectionAllOrders));
    compare(&case).unwrap();
}
