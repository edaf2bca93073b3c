//! The no-lift witnesses.
mod common;
use common::{Case, P, one_prism};

fn refuted(points: &[P], triangles: &[[u32; 3]], witness: &str) -> Case {
    let mut case = one_prism().only(&[("section", false), ("bijection", false)], &[("no-section", witness)]);
    case.points = points.to_vec();
    case.triangles = triangles.to_vec();
    case
}

const INSIDE: [P; 3] = [[0.25, 0.25, 0.25], [0.5, 0.25, 0.25], [0.25, 0.5, 0.25]];

#[test]
fn topology() {
    let far = [[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 1.0, 0.0]];
    let case = refuted(&[INSIDE, far].concat(), &[[0, 1, 2], [3, 4, 5]], "topology components 2 1");
    case.accept();
    case.mutant("no-section", "2 1", "3 1", "wrong-value");
    case.mutant("no-section", "components 2 1", "euler 1 1", "wrong-value");
    case.mutant("no-section", "components 2 1", "euler 2 -1", "wrong-value");
    refuted(&[INSIDE, far].concat(), &[[0, 1, 2], [3, 4, 5]], "topology euler 2 1").accept();
    refuted(&INSIDE, &[[0, 1, 2]], "topology euler 1 1").reject("not-refuted");
}

#[test]
fn negative_tet() {
    let mut case = refuted(&INSIDE, &[[0, 1, 2]], "tet 0 b0,b1,b2,m2 -1");
    case.layers.swap(0, 2);
    case.accept();
    case.mutant("no-section", "-1", "-3", "wrong-value");
    // Not in the decomposition by vertex id.
    case.mutant("no-section", "b0,b1,b2,m2", "b0,m0,b1,b2", "unknown-tet");
    case.order = "order list 2 1 0".into();
    case.reject("unknown-tet");
    case.set("no-section", "tet 0 b0,m0,b1,b2 -1");
    case.accept();
}

#[test]
fn fold_and_boundary() {
    let witness = "root 0 1 1 1\nbranch m0,m1,m2,t2\nstart m0,m1,m2,t2\nfold";
    let case = refuted(&INSIDE, &[[0, 2, 1]], witness);
    case.accept();
    case.mutant("no-section", "fold", "cap", "not-refuted");
    case.mutant("no-section", "fold", "wall", "not-refuted");
    case.mutant("no-section", "fold", "boundary", "not-refuted");
    case.mutant("no-section", "fold", "lands", "not-refuted");
    case.mutant("no-section", "branch m0,m1,m2,t2\nstart m0,m1,m2,t2\nfold", "", "wrong-branches");
    case.mutant("no-section", "branch m0,m1,m2,t2", "branch m0,m1,m2", "wrong-branches");
    case.mutant("no-section", "start m0,m1,m2,t2", "start m0,m1,t1,t2", "wrong-step");
    case.mutant("no-section", "start m0,m1,m2,t2", "start m0,b1,m2,t2", "unknown-tet");
    refuted(&INSIDE, &[[0, 1, 2]], witness).reject("not-refuted");
    let edge = "root 0 1 1 0\nbranch m0,m1,m2,t2\nstart m0,m1,m2,t2\nboundary";
    // The point (3/8, 1/4, 1/4) lies in the face between the first two tets.
    let edge = edge.replace("branch m0,m1,m2,t2", "branch m0,m1,t2");
    refuted(&INSIDE, &[[0, 1, 2]], &edge).accept();
    refuted(&INSIDE, &[[0, 1, 2]], &edge.replace("1 1 0", "2 1 1")).reject("wrong-branches");
}

#[test]
fn wall() {
    let big = [[-1.0, -1.0, 0.25], [3.0, -1.0, 0.25], [-1.0, 3.0, 0.25]];
    let witness = "root 0 11 12 9\nbranch m0,m1,t1,t2\nstart m0,m1,t1,t2\nstep 0 3 3 2 m0,m1,t1,t2\nwall";
    let case = refuted(&big, &[[0, 1, 2]], witness);
    case.accept();
    case.mutant("no-section", "step 0 3 3 2 m0,m1,t1,t2\n", "", "not-refuted");
    case.mutant("no-section", "step 0 3 3 2 m0,m1,t1,t2", "step 0 3 3 1 m0,m1,t1,t2", "wrong-step");
    case.mutant("no-section", "step 0 3 3 2 m0,m1,t1,t2", "step 0 3 3 2 m0,m1,m2,t2", "wrong-step");
    case.mutant("no-section", "step 0 3 3 2 m0,m1,t1,t2", "step 0 3 3 2 m0,m1,b2,t2", "unknown-tet");
}

#[test]
fn cap_and_lands() {
    let top = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]];
    refuted(&top, &[[0, 1, 2]], "root 0 1 1 1\nbranch t0,t1,t2\nstart m0,t0,t1,t2\ncap").accept();
    let lands = |f: usize| format!("root {f} 1 1 1\nbranch m0,m1,m2,t2\nstart m0,m1,m2,t2\nlands\n");
    let two = [INSIDE, INSIDE].concat();
    let case = refuted(&two, &[[0, 1, 2], [3, 4, 5]], &(lands(0) + &lands(1)));
    case.accept();
    case.mutant("no-section", "root 1", "root 0", "wrong-branches");
    refuted(&two, &[[0, 1, 2], [3, 4, 5]], &lands(0)).reject("not-refuted");
}

#[test]
fn twice_and_monodromy_need_two_ends() {
    let legs = "branch m0,m1,m2,t2\nstart m0,m1,m2,t2\nstart m0,m1,m2,t2\n";
    let case = refuted(&INSIDE, &[[0, 1, 2]], &format!("root 0 1 1 1\n{legs}monodromy"));
    case.reject("not-refuted");
    case.mutant("no-section", "monodromy", "twice", "not-refuted");
    // A vertical mesh triangle over itself: two points of T with one projection.
    let steep = [[0.25, 0.25, 0.0625], [0.5, 0.25, 0.0625], [0.25, 0.25, 0.125]];
    let step = "root 0 4 1 4\nbranch m0,m1,m2,t2\nstart m0,m1,m2,t2\nstart m0,m1,m2,t2\nstep 0 6 1 2 m0,m1,m2,t2\ntwice";
    let case = refuted(&steep, &[[0, 1, 2]], step);
    case.accept();
    case.mutant("no-section", "step 0 6 1 2", "step 0 6 2 1", "not-refuted");
    case.mutant("no-section", "step 0 6 1 2", "step 0 8 2 8", "not-refuted");
}

#[test]
fn no_order() {
    // The tet is named for the order of the `first` line: the positivity of all tets makes it `not-refuted`.
    let mut case = one_prism();
    case.claims =
        vec![("positivity", true), ("section", true), ("bijection", true), ("section-all-orders", false)];
    case.blocks.truncate(1);
    case.blocks.push(("no-order", vec!["first 2".into(), "tet 0 b0,b1,m1,b2 1".into()]));
    case.reject("not-refuted");
    case.mutant("no-order", "first 2", "first 1", "unknown-tet");
    case.mutant("no-order", "first 2", "first 1 0 2", "unknown-tet");
}
