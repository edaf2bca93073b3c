//! Planes, `disjoint-*`, `i2`, `disjoint-prisms`.
mod common;
use common::{Case, P, one_prism, tetrahedron};

fn mesh(points: &[P], verdict: bool, facts: &str) -> Case {
    let mut case = one_prism().only(&[("disjoint-mesh", verdict)], &[("disjoint-mesh", facts)]);
    case.points = points.to_vec();
    case.triangles = vec![[0, 1, 2], [3, 4, 5]];
    case
}

const FLOOR: [P; 3] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];

#[test]
fn mesh_certified() {
    // Neither triangle's plane separates, the boxes meet.
    let points =
        [&FLOOR[..], &[[3.0, 3.0, -1.0], [3.0, 3.0, 1.0], [5.0, 5.0, 0.0], [5.0, 5.0, -1.0]]].concat();
    mesh(&points, true, "").reject("missing-separation");
    mesh(&points, true, "sep 0 1 n:g3,g6").accept();
    mesh(&points, true, "sep 0 1 n:g6,g3").reject("not-separated");
    mesh(&points, true, "sep 0 1 p:g0,g1,g2").reject("not-separated");
    mesh(&points, true, "sep 0 1 l:g1,g2").accept();
    mesh(&points, true, "sep 0 1 p:g1,g1,g2 l:g1,g2").accept();
    let mut apart = points.clone();
    apart[4][2] = -3.0;
    apart[5][2] = -2.0;
    mesh(&apart, true, "").accept();
    mesh(&apart, true, "sep 0 1 n:g3,g6").reject("superfluous");
    apart[3][2] = 0.0; // one corner touches the plane outside the triangle
    mesh(&apart, true, "").reject("missing-separation");
    mesh(&apart, true, "sep 0 1 p:g0,g1,g2 l:g1,g2").accept();
    mesh(&apart, true, "sep 0 1 p:g0,g1,g2").reject("not-separated");
    mesh(&apart, true, "sep 0 1 l:b0,m9").check();
}

#[test]
fn mesh_refuted() {
    let points = [&FLOOR[..], &[[1.0, 1.0, -1.0], [1.0, 1.0, 1.0], [5.0, 5.0, 0.0]]].concat();
    mesh(&points, false, "cross 0 1 2 1 1 1 1 0").accept();
    mesh(&points, false, "cross 0 1 4 2 2 3 3 0").accept();
    mesh(&points, false, "cross 0 1 2 1 1 1 2 0").reject("wrong-point");
    let mut shared = mesh(&points, false, "cross 0 1 1 0 0 0 1 0");
    shared.triangles[1] = [1, 0, 5];
    shared.reject("not-refuted");
}

/// What certifies and what refutes exclude each other: a point with the coordinates of a pinched vertex is allowed whatever name
/// it is given. (Both checkers took this one for a crossing.)
#[test]
fn another_name_at_a_pinched_vertex() {
    let mut case = one_prism();
    case.pinched = "pinched 8 0".into();
    case.layers[1] = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    case.layers[0] = vec![[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 4.0, -1.0]];
    case.layers[2] = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 1.0], [0.0, 4.0, 1.0]];
    case.points = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 4.0], [0.0, 4.0, 4.0]];
    let bottom =
        |verdict, facts| case.clone().only(&[("disjoint-bottom", verdict)], &[("disjoint-bottom", facts)]);
    bottom(true, "").accept();
    bottom(false, "cross 0 0 1 0 0 0 1 0").reject("not-refuted");
    bottom(false, "cross 0 0 1 0 0 1 0 0").reject("not-refuted");
    // The mesh has no vertex there; two corners of the bottom remain, both at the pinched vertex.
    case.points = vec![[8.0, -4.0, 0.0], [-4.0, 8.0, 0.0], [-4.0, -4.0, 0.0]];
    let bottom = |c: &Case, verdict, facts| {
        c.clone().only(&[("disjoint-bottom", verdict)], &[("disjoint-bottom", facts)])
    };
    bottom(&case, true, "").accept();
    bottom(&case, false, "cross 0 0 1 1 1 1 0 0").reject("not-refuted");
    // Two remain, one of them elsewhere.
    case.layers[0][1] = [0.0, 1.0, 0.0];
    bottom(&case, true, "").reject("missing-separation");
    bottom(&case, true, "sep 0 0 p:g0,g1,g2").reject("not-separated");
    bottom(&case, false, "cross 0 0 8 9 7 1 1 0").accept();
}

#[test]
fn layers() {
    let mut case = one_prism().only(&[("disjoint-top", false)], &[("disjoint-top", "cross 0 0 1 0 0 1 0 0")]);
    case.reject("wrong-point");
    case.points[0][2] = 1.0;
    case.accept();
    let certified = |c: &Case| c.clone().only(&[("disjoint-top", true)], &[("disjoint-top", "")]);
    certified(&case).reject("missing-separation");
    // The common point is a pinched vertex.
    let mut pinched = one_prism();
    pinched.pinched = "pinched 8 0".into();
    pinched.layers[0][0] = pinched.layers[1][0];
    pinched.layers[2][0] = pinched.layers[1][0];
    certified(&pinched).accept();
    pinched
        .only(&[("disjoint-top", false)], &[("disjoint-top", "cross 0 0 1 0 0 1 0 0")])
        .reject("not-refuted");
}

#[test]
fn contacts() {
    let case = tetrahedron();
    case.accept();
    let bad = |from, to, code| case.mutant("i2", from, to, code);
    bad("-3*2^6", "-3*2^5", "wrong-value");
    bad("m0,m1,m3,t3", "m0,m1,m2,t3", "unknown-tet");
    bad("1 0 0 1 0 0 0", "1 0 0 0 1 0 0", "wrong-point");
    let mut certified = case.clone();
    certified.claims[7].1 = true;
    certified.set("i2", "");
    certified.reject("missing-separation");
    let mut one = one_prism();
    one.set("i2", "contact-sep 0 0 m0,m1,m2,t2 p:g0,g1,g2");
    one.reject("superfluous");
    let mut own = one_prism();
    own.claims[7].1 = false;
    own.set("i2", "contact 0 0 m0,m1,m2,t2 1 0 0 1 0 0 0 1");
    own.reject("not-refuted");
}

#[test]
fn any_number_of_planes() {
    // A recursion a plane would overflow the stack.
    let points =
        [&FLOOR[..], &[[3.0, 3.0, -1.0], [3.0, 3.0, 1.0], [5.0, 5.0, 0.0], [5.0, 5.0, -1.0]]].concat();
    let idle = "p:g0,g0,g0 ".repeat(20_000);
    mesh(&points, true, &format!("sep 0 1 {idle}n:g3,g6")).accept();
    mesh(&points, true, &format!("sep 0 1 {}", idle.trim_end())).reject("not-separated");
}

const PRISMS: &str = "disjoint-prisms";

#[test]
fn one_prism_is_disjoint() {
    // Each side wall is flat: its four triangles, by two and two, need planes. The order cuts each along its diagonals.
    let case = one_prism().only(&[(PRISMS, true)], &[(PRISMS, "")]);
    case.reject("missing-separation");
    let refuted = |facts: &str| one_prism().only(&[(PRISMS, false)], &[(PRISMS, facts)]);
    let (low, high) = ("b0,b1,b2,m2", "m0,m1,m2,t2");
    refuted(&format!("overlap {low} 0 0 0 1 {high} 0 0 1 0")).reject("not-refuted");
    refuted(&format!("overlap {low} 0 0 1 1 {high} 0 0 1 0")).reject("wrong-point");
    refuted(&format!("overlap b0,b1,m2,t2 0 0 0 1 {high} 0 0 1 0")).reject("unknown-tet");
    refuted("tet 0 b0,b1,b2,m2 1").reject("not-refuted");
    refuted("tet 0 b0,b1,b2,m2 -1").reject("wrong-value");
    refuted("tet 0 b0,b1,m2,t2 1").reject("unknown-tet");
}

#[test]
fn a_prism_on_another() {
    let mut case =
        one_prism().only(&[(PRISMS, false)], &[(PRISMS, "overlap m0,m1,m2,t2 0 0 0 1 b3,b4,b5,m5 0 0 1 0")]);
    for k in 0..3 {
        let above: Vec<P> = case.layers[k].iter().map(|p| [p[0], p[1], p[2] + 2.0]).collect();
        case.layers[k].extend(above);
    }
    case.prisms.push([3, 4, 5]);
    case.accept();
    let claimed = case.clone().only(&[(PRISMS, true)], &[(PRISMS, "")]);
    claimed.reject("missing-separation");
    case.layers[0][5][2] += 0.25;
    case.reject("wrong-point");
    case.layers[0][5][2] = -9.0;
    let claimed = case.clone().only(&[(PRISMS, true)], &[(PRISMS, "")]);
    claimed.reject("missing-separation");
    case.layers[0][5][2] = 9.0;
    case.only(&[(PRISMS, true)], &[(PRISMS, "")]).reject("not-positive");
}
