//! The overlay rules, each with its code.
mod common;
use common::{Case, lines, one_prism, tetrahedron};

fn section(mut case: Case) -> Case {
    case.claims = vec![("section", true), ("bijection", true)];
    case.blocks.retain(|b| b.0 == "overlay");
    case
}

#[test]
fn carriers() {
    let case = section(tetrahedron());
    case.accept();
    let bad = |from, to, code| case.mutant("overlay", from, to, code);
    bad("v 0 m0", "v 0 t0,t1", "cap");
    bad("v 0 m0", "v 0 b0", "cap");
    bad("v 0 m0", "v 0 m1", "no-point");
    bad("v 0 m0", "v 0,1 m0,m1", "no-point");
    bad("v 0 m0", "v 0 b0,t1", "shell-carrier");
    bad("v 0 m0", "v 0 b0,m0", "outside-carrier");
    bad("v 0 m0", "v 0 b0,m0,m1,m2", "outside-carrier");
    bad("v 0 m0", "v 0,1,2 b0,m0", "outside-carrier");
    let mut more = case.clone();
    more.points.push([9.0; 3]);
    more.accept();
    more.mutant("overlay", "v 0 m0", "v 4 m0", "mesh-carrier");
    more.mutant("overlay", "v 0 m0", "v 0,4 m0", "mesh-carrier");
    let mut negative = case.clone();
    negative.layers.swap(0, 2);
    negative.reject("not-positive");
}

#[test]
fn the_first_failure_is_told() {
    let mut case = section(one_prism());
    let more = ["v 0 m1", "v 1 b1,t1", "v 2 t2", "v 0,1 b0,t0", "v 1 m2"];
    let codes = ["no-point", "shell-carrier", "cap", "shell-carrier", "no-point"];
    for first in 0..more.len() {
        let corners: String =
            (0..more.len()).map(|i| format!("{}\n", more[(first + i) % more.len()])).collect();
        case.set("overlay", &format!("v 0 m0\nv 1 m1\nv 2 m2\n{corners}c 0 1 2\nd mesh 0 0\nd middle 0 0"));
        case.reject(codes[first]);
    }
}

#[test]
fn carriers_of_all_ranks() {
    // Mesh edges across walls (2 + 2), a face pierced by a pillar (3 + 1), a mesh vertex inside a tet (1 + 4).
    let mut case = section(one_prism());
    case.points.push([0.25, 0.25, 0.125]);
    case.triangles = vec![[0, 1, 3], [1, 2, 3], [2, 0, 3]];
    case.set(
        "overlay",
        "v 0 m0\nv 1 m1\nv 2 m2\nv 3 m0,m1,m2,t2\nc 0 1 3\nc 1 2 3\nc 2 0 3\nd mesh 0 0\nd middle 2 0",
    );
    case.accept();
    case.mutant("overlay", "v 3 m0,m1,m2,t2", "v 3 m0,m1,m2", "no-point");
    case.mutant("overlay", "v 3 m0,m1,m2,t2", "v 3 m0,m1,t1,t2", "outside-carrier");
    case.mutant("overlay", "v 1 m1", "v 1,2 m1,t2", "outside-carrier");
}

#[test]
fn cells() {
    let case = section(tetrahedron());
    let bad = |from, to, code| case.mutant("overlay", from, to, code);
    bad("c 0 1 2", "c 2 1 0", "area-mesh");
    bad("c 0 1 2", "c 0 1 2\nc 0 1 2", "edge-twice");
    bad("c 1 3 2\n", "", "boundary");
    bad("c 0 1 2", "c 0 1 2 3", "cell-mesh");
    bad("d mesh 0 0", "d mesh 0 0\nd mesh 1 0", "degree-component");
    bad("d middle 0 0", "d middle 0 0\nd middle 0 0", "degree-component");
    bad("v 3 m3", "v 3 m3\nv 0 m0,m1,m2,t2", "outside-carrier");
    let mut swapped = case.clone();
    swapped.points.swap(0, 1);
    swapped.set(
        "overlay",
        "v 0 m1\nv 1 m0\nv 2 m2\nv 3 m3\nc 0 1 2\nc 0 3 1\nc 0 2 3\nc 1 3 2\nd mesh 0 0\nd middle 0 0",
    );
    swapped.reject("area-middle");
    // A second component of the mesh, whose corner is inside a tet but in no cell.
    let mut one = section(one_prism());
    one.points.extend([[0.25, 0.25, 0.125], [0.5, 0.25, 0.125], [0.25, 0.5, 0.125]]);
    one.triangles.push([3, 4, 5]);
    one.reject("degree-component");
    one.mutant("overlay", "v 2 m2", "v 2 m2\nv 3 m0,m1,m2,t2", "isolated");
    // The names of a cell from two tets.
    let mut two = section(one_prism());
    two.points = vec![[0.0, 0.0, 0.5], [1.0, 0.0, -0.5], [0.0, 1.0, 0.0]];
    two.set("overlay", "v 0 m0,t0\nv 1 b1,m1\nv 2 m2\nc 0 1 2\nd mesh 0 0\nd middle 0 0");
    two.reject("cell-shell");
}

#[test]
fn degree() {
    // Two disjoint copies of the tetrahedron's overlay cover the mesh and the middle twice.
    let mut case = section(tetrahedron());
    let base: Vec<_> = case.points.clone();
    case.points.extend(base);
    let copy: Vec<_> = case.triangles.iter().map(|t| t.map(|v| v + 4)).collect();
    case.triangles.extend(copy);
    let cells =
        ["c 0 1 2", "c 0 3 1", "c 0 2 3", "c 1 3 2", "c 4 5 6", "c 4 7 5", "c 4 6 7", "c 5 7 6"].join("\n");
    let corners: String = (0..8).map(|i| format!("v {i} m{}\n", i % 4)).collect();
    let overlay = format!("{corners}{cells}\nd mesh 0 0\nd mesh 4 0\nd middle 0 0");
    case.set("overlay", &overlay);
    case.reject("degree");
    assert_eq!(lines(&overlay).len(), 19);
}

#[test]
fn a_degree_line_for_each_component() {
    // Three prisms apart, each with a mesh of three triangles whose cells stand here and there.
    let mut case = section(one_prism());
    case.points.push([0.25, 0.25, 0.125]);
    let apart = |points: &[common::P]| -> Vec<common::P> {
        [8.0, 0.0, 4.0].iter().flat_map(|x| points.iter().map(move |p| [p[0] + x, p[1], p[2]])).collect()
    };
    case.layers = case.layers.each_ref().map(|layer| apart(layer));
    case.points = apart(&case.points);
    case.prisms = vec![[0, 1, 2], [3, 4, 5], [6, 7, 8]];
    let part = |i: u32| [[0, 1, 3], [1, 2, 3], [2, 0, 3]].map(|t| t.map(|v| v + 4 * i));
    case.triangles = [part(1), part(0), part(2)].concat();
    let corners = |i: usize| {
        let (g, m) = (4 * i, 3 * i);
        let [a, b, c] = [0, 1, 2].map(|k| format!("v {} m{}", g + k, m + k));
        format!("{a}\n{b}\n{c}\nv {} m{m},m{},m{},t{}\n", g + 3, m + 1, m + 2, m + 2)
    };
    let cells = [
        [4, 5, 7],
        [0, 1, 3],
        [8, 9, 11],
        [2, 0, 3],
        [10, 8, 11],
        [5, 6, 7],
        [1, 2, 3],
        [9, 10, 11],
        [6, 4, 7],
    ];
    let cells: String = cells.iter().map(|[a, b, c]| format!("c {a} {b} {c}\n")).collect();
    let corners: String = (0..3).map(corners).collect();
    let degrees = "d mesh 5 0\nd mesh 6 0\nd mesh 4 0\nd middle 3 0\nd middle 8 0\nd middle 7 0";
    case.set("overlay", &format!("{corners}{cells}{degrees}"));
    case.accept();
    case.mutant("overlay", "d mesh 6 0", "d mesh 5 0", "degree-component");
    case.mutant("overlay", "d middle 7 0", "d middle 0 0", "degree-component");
}
