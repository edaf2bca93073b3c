//! An overlay that crosses tets, and `section-all-orders`.
mod common;
use common::{ALL, Case, one_prism};

/// The mesh is the top slab's section at half height, with a fourth vertex where it crosses the diagonal `m0 t1`.
/// `lean` moves `t0` (and the mesh with it) out of the side wall 0 1, so that this wall is bent along the diagonal.
fn half_height(lean: f64) -> Case {
    let mut case = one_prism();
    case.layers[2][0] = [0.0, -lean, 1.0];
    case.points = vec![[0.0, -lean / 2.0, 0.5], [1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.5, 0.0, 0.5]];
    case.triangles = vec![[0, 3, 2], [3, 1, 2]];
    case.claims = ALL[..4].iter().map(|name| (*name, true)).collect();
    case.blocks.truncate(1);
    case.set(
        "overlay",
        "v 0 m0,t0\nv 1 m1,t1\nv 2 m2,t2\nv 3 m0,t1\nv 0,2 m0,t2\nv 1,2 m1,t2\nv 2,3 m0,m1,t2\n\
         c 0 3 4\nc 3 6 4\nc 4 6 2\nc 3 1 5 6\nc 6 5 2\nd mesh 0 0\nd middle 3 1",
    );
    case
}

#[test]
fn crossings_of_every_kind() {
    let case = half_height(0.0);
    case.accept();
    let bad = |from, to, code| case.mutant("overlay", from, to, code);
    bad("v 2,3 m0,m1,t2", "v 2,3 m0,t1,t2", "outside-carrier"); // both faces hold (1/2, 0), the mesh edge's end
    bad("v 2,3 m0,m1,t2", "v 2,3 m0,m1", "no-point");
    bad("v 2,3 m0,m1,t2", "v 0,3 m0,m1,t2", "no-point");
    bad("v 2,3 m0,m1,t2", "v 1,3 m0,m1,t2", "no-point");
    bad("v 0,2 m0,t2", "v 0,1 m0,t2", "mesh-carrier");
    bad("c 3 1 5 6", "c 3 1 5 6\nc 0 3 6", "cell-shell");
    bad("d middle 3 1", "d middle 2 0\nd middle 3 1", "degree-component");
    bad("c 3 6 4", "c 3 6 0", "cell-shell");
    bad("c 3 1 5 6", "c 3 1 6 5", "area-mesh");
    bad("c 0 3 4", "c 0 3 5", "cell-mesh");
}

#[test]
fn a_bent_wall_on_the_boundary() {
    let bent = half_height(0.25);
    bent.reject("all-orders-boundary");
    let mut without = bent.clone();
    without.claims.pop();
    without.accept();
}
