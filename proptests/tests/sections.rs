//! Sections that are sections by construction, remeshed, and broken: what holds by an argument is certified, what fails by
//! an argument is refuted, up to the last bit of a coordinate.
#![allow(clippy::unwrap_used, clippy::needless_pass_by_value)]

use homeo::certify::{Claim, Options, Silent, VertexOrder, certify};
use homeo::predicate::{Sign, orient3d};
use homeo_proptests::Case;
use homeo_proptests::campaign::{holds, run};
use homeo_proptests::graphs::{Graph, all_face_up, graphs, interior_vertex, to_the_last_ulp};
use homeo_proptests::judged::inputs;
use homeo_proptests::oracle::exact::{on_grid, orient, positive};
use proptest::prelude::*;

/// All claims certified, or the section refuted; in both cases the checker agrees.
fn decide(case: &Case, section: bool) -> Result<(), String> {
    let options = Options { claims: Claim::STANDARD.to_vec(), order: case.vertex_order() };
    let outcome =
        certify(&case.shell, Some(&case.mesh), &options, &Silent).map_err(|e| format!("{e}\n{case:#?}"))?;
    let answer = homeo_certs::check(outcome.certificate.as_bytes(), &inputs(case));
    if answer.exit != 0 {
        return Err(format!("rejected: {answer:?}\n{}", outcome.certificate));
    }
    let wrong = if section {
        Claim::STANDARD.into_iter().find(|&c| !holds(&outcome, c))
    } else {
        [Claim::Section, Claim::Bijection, Claim::SectionAllOrders].into_iter().find(|&c| holds(&outcome, c))
    };
    wrong.map_or(Ok(()), |c| Err(format!("{c}: a section is {section}\n{case:#?}\n{}", outcome.certificate)))
}

fn cases() -> ProptestConfig {
    let cases = std::env::var("HOMEO_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(150);
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

fn checked(result: Result<(), String>) -> Result<(), TestCaseError> {
    result.map_err(TestCaseError::fail)
}

proptest! {
    #![proptest_config(cases())]

    #[test]
    fn graphs_are_sections(graph in graphs()) {
        checked(decide(&graph.build(), true))?;
    }

    /// An interior vertex is moved sideways as far as no planar triangle turns over; one bit further there is no section.
    #[test]
    fn sections_end_at_the_last_bit(graph in graphs(), pick: u8, by in [-9i8..10, -9i8..10]) {
        let case = graph.build();
        let Some(v) = interior_vertex(&case.mesh, usize::from(pick)) else { return Ok(()) };
        let moved = |s: f64| {
            let mut out = case.clone();
            (0..2).for_each(|k| out.mesh.vertices[v][k] += s * f64::from(by[k]) / 8.0);
            out
        };
        if let Some((good, bad)) = to_the_last_ulp(0.0, 64.0, |s| all_face_up(&moved(s).mesh)) {
            checked(decide(&moved(good), true))?;
            // A face that turned over or has become a wall; a mesh that is refused has a face without area.
            let over = moved(bad);
            if homeo::mesh::check(&over.mesh).is_ok() {
                checked(decide(&over, false))?;
            }
        }
    }

    /// A vertex just below the top is inside, on it there is no section.
    #[test]
    fn sections_end_at_the_top(graph in graphs(), pick: u8) {
        let case = graph.build();
        let v = usize::from(pick) % case.mesh.vertices.len();
        let at = |z: f64| {
            let mut out = case.clone();
            out.mesh.vertices[v][2] = z;
            out
        };
        for cap in [4f64, -4.0] {
            let below = if cap > 0.0 { cap.next_down() } else { cap.next_up() };
            checked(decide(&at(below), true))?;
            checked(decide(&at(cap), false))?;
        }
    }

    /// Without one of several triangles, or turned round, a mesh is no section.
    #[test]
    fn torn_and_turned_meshes(graph in graphs(), pick: u8) {
        let case = graph.build();
        let mut turned = case.clone();
        turned.mesh.faces.iter_mut().for_each(|f| f.swap(0, 1));
        checked(decide(&turned, false))?;
        let mut torn = case;
        let n = torn.mesh.faces.len();
        torn.mesh.faces.remove(usize::from(pick) % n);
        if n > 1 && homeo::mesh::check(&torn.mesh).is_ok() {
            checked(decide(&torn, false))?;
        }
    }

    /// The sign of a tet changes where exact integers say so, to the last bit of a coordinate.
    #[test]
    fn tets_end_at_the_last_bit(
        points in [[-8i8..9, -8i8..9, -8i8..9], [-8i8..9, -8i8..9, -8i8..9], [-8i8..9, -8i8..9, -8i8..9],
            [-8i8..9, -8i8..9, -8i8..9]],
        by in [-9i8..10, -9i8..10, -9i8..10],
        scale in -300i32..300,
    ) {
        let unit = 2f64.powi(scale);
        let tet = |s: f64| {
            let mut p = points.map(|p| p.map(|x| f64::from(x) / 3.0 * unit));
            (0..3).for_each(|k| p[3][k] += s * f64::from(by[k]) * unit);
            p
        };
        let exact = |s: f64| {
            let [a, b, c, d] = <[_; 4]>::try_from(on_grid(&tet(s))).unwrap();
            orient(&a, &b, &c, &d)
        };
        let filtered = |s: f64| {
            let [a, b, c, d] = tet(s);
            orient3d(&a, &b, &c, &d)
        };
        let Some((good, bad)) = to_the_last_ulp(0.0, 64.0, |s| positive(&exact(s))) else { return Ok(()) };
        for s in [good, bad, good.next_down(), bad.next_up(), bad.next_up().next_up()] {
            let value = exact(s);
            let expected = if positive(&value) {
                Sign::Positive
            } else if positive(&-value) {
                Sign::Negative
            } else {
                Sign::Zero
            };
            prop_assert_eq!(filtered(s), expected, "at {}", s);
        }
    }
}

fn orders(n: u32) -> Vec<Vec<u32>> {
    (0..n).fold(vec![Vec::new()], |shorter, v| {
        let longer =
            |o: &Vec<u32>| (0..=o.len()).map(|i| [&o[..i], &[v], &o[i..]].concat()).collect::<Vec<_>>();
        shorter.iter().flat_map(longer).collect()
    })
}

/// C3, which one overlay proves for all orders, is C1 and C2 certified order by order.
#[test]
fn one_overlay_stands_for_all_orders() {
    run(8, |_, case| {
        let n = u32::try_from(case.shell.middle.len()).unwrap();
        if n > 4 {
            return Ok(vec!["too large".into()]);
        }
        let decided = |claims: &[Claim], order: VertexOrder| {
            let options = Options { claims: claims.to_vec(), order };
            certify(&case.shell, Some(&case.mesh), &options, &Silent).ok()
        };
        let Some(at_once) = decided(&[Claim::SectionAllOrders], case.vertex_order()) else {
            return Ok(vec!["refused".into()]);
        };
        let mut all = holds(&at_once, Claim::Positivity);
        for order in orders(n).into_iter().filter(|_| n > 0) {
            let order = VertexOrder::from_list(order, n as usize).unwrap();
            let Some(one) = decided(&[Claim::Section], order) else { return Ok(vec!["refused".into()]) };
            all &= holds(&one, Claim::Section);
        }
        let claimed = holds(&at_once, Claim::SectionAllOrders);
        if claimed == all {
            Ok(vec![format!("C3 {all}")])
        } else {
            Err(format!("C3 {claimed}, by orders {all}"))
        }
    });
}

#[test]
fn a_graph_is_what_it_says() {
    let graph = Graph { shape: 1, steps: vec![(0, 0), (2, 0)], heights: vec![31, -31], order: 0 };
    let case = graph.build();
    assert!(all_face_up(&case.mesh) && case.mesh.faces.len() == 4);
}
