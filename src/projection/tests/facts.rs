//! Shells whose projection is known by hand.

use super::generate::{in_tet, ratio, spiral};
use crate::projection::{Projection, Rat, ShellPoint};
use crate::shell::Shell;
use crate::shell::VertexOrder;
use crate::shell::decomposition::ORDERS;
use crate::testing::Random;

/// The reference prism itself, its corners at (0, 0), (1, 0), (0, 1), some of them pinched.
fn reference(pinched: [bool; 3]) -> Shell {
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let layer = |z: f64| {
        let at = |k: usize| [corners[k][0], corners[k][1], if pinched[k] { 0.0 } else { z }];
        [0, 1, 2].map(at).to_vec()
    };
    Shell { bottom: layer(-1.0), middle: layer(0.0), top: layer(1.0), faces: vec![[0, 1, 2]] }
}

#[test]
fn on_the_reference_prism_the_projection_is_the_identity() {
    let mut random = Random(1);
    let mut seen = 0;
    for mask in 0..7_u8 {
        let pinched = [0, 1, 2].map(|k| mask >> k & 1 == 1);
        let shell = reference(pinched);
        for order in ORDERS {
            let order = VertexOrder::List(order.map(u32::from).to_vec());
            let projection = Projection::new(&shell, &order).unwrap();
            for i in 0..300 {
                let p = in_tet(&projection, i % projection.tets().len(), &random.weights());
                let [x, y, z] = p.clone();
                let expected = ShellPoint { prism: 0, weights: [Rat::ONE - &x - &y, x, y], height: z };
                assert_eq!(projection.project_all(&p), std::slice::from_ref(&expected));
                assert_eq!(projection.unproject(&expected).unwrap(), p);
                seen += 1;
            }
        }
    }
    assert_eq!(seen, 7 * 6 * 300);
}

#[test]
fn outside_of_the_reference_prism_there_is_no_image() {
    let shell = reference([false, true, false]);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let half = || ratio(1, 2);
    let tiny = ratio(1, 1 << 60);
    // On the wall over (1/2, 1/2) the shell reaches up to 1/2, since corner 1 is pinched.
    for (z, inside) in [(half(), true), (half() + &tiny, false), (-half(), true), (-half() - &tiny, false)] {
        let p = [half(), half(), z];
        assert_eq!(projection.is_inside(&p), inside);
        assert_eq!(projection.project(&p).is_some(), inside);
    }
    assert!(!projection.is_inside(&[-tiny.clone(), half(), Rat::ZERO]));
    assert!(!projection.is_inside_f64(&[0.5, 0.5_f64.next_up(), 0.0]));
    assert!(projection.is_inside_f64(&[0.5, 0.5, 0.0]));
    let pinched = projection.locate_f64(&[1.0, 0.0, 0.0]);
    assert_eq!(pinched.len(), projection.tets().len(), "every tet has the pinched corner");
    assert!(pinched.iter().all(|l| l.carrier.len() == 1 && l.carrier[0].to_string() == "m1"));
}

#[test]
fn a_shell_that_overlaps_itself_gives_every_image() {
    // 12 quads around an octagon: quads 0..4 lie exactly on quads 8..12.
    let shell = spiral(12);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let mut random = Random(2);
    let mut counts = [0; 3];
    for i in 0..2000 {
        let prism = u32::try_from(i % 24).unwrap();
        let q = ShellPoint { prism, weights: random.weights(), height: ratio(1, 3) };
        let p = projection.unproject(&q).unwrap();
        let images = projection.project_all(&p);
        counts[images.len().min(2)] += 1;
        assert!(images.contains(&projection.canonical(&q).unwrap()));
        assert!(images.iter().all(|image| projection.unproject(image).unwrap() == p));
        if q.weights.iter().all(|w| *w != Rat::ZERO) {
            assert_eq!(images.len(), if (8..16).contains(&prism) { 1 } else { 2 }, "prism {prism}");
            assert_eq!(images[0].prism, prism % 16);
        }
    }
    assert!(counts[0] == 0 && counts[1] > 300 && counts[2] > 900, "{counts:?}");
}
