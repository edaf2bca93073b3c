//! Input that must be refused by name, and extreme numbers.

use super::generate::{in_tet, ratio, scaled, spiral};
use super::properties::check_point;
use crate::projection::{PointError, Projection, ProjectionError, Rat, ShellPoint};
use crate::shell::VertexOrder;
use crate::shell::validate::ShellError;
use crate::testing::Random;
use dashu_int::IBig;

#[test]
fn bad_shells_and_orders() {
    let good = spiral(3);
    let error = |shell, order: &VertexOrder| Projection::new(&shell, order).map(|_| ()).unwrap_err();
    let mut flipped = good.clone();
    flipped.top[3][2] = -0.5;
    assert!(matches!(error(flipped, &VertexOrder::Id), ProjectionError::NotPositive { prism: 0, .. }));
    let mut nan = good.clone();
    nan.middle[3][1] = f64::NAN;
    assert!(matches!(error(nan, &VertexOrder::Id), ProjectionError::Shell(ShellError::NotFinite { .. })));
    let mut far = good.clone();
    far.faces[1][2] = u32::MAX;
    assert!(matches!(
        error(far, &VertexOrder::Id),
        ProjectionError::Shell(ShellError::IndexOutOfRange { .. })
    ));
    for list in [vec![], vec![0; 8], vec![0, 1, 2, 3, 4, 5, 6, u32::MAX]] {
        let entries = list.len();
        let expected = ProjectionError::Order { entries, vertices: 8 };
        assert_eq!(error(good.clone(), &VertexOrder::List(list)), expected);
    }
}

#[test]
fn bad_points() {
    let shell = spiral(3);
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    let point = |prism, weights: [i64; 3], height: Rat| ShellPoint {
        prism,
        weights: weights.map(|w| ratio(w, 2)),
        height,
    };
    let error = |q: ShellPoint| {
        let error = projection.unproject(&q).unwrap_err();
        assert_eq!(projection.canonical(&q).unwrap_err(), error);
        error
    };
    assert_eq!(error(point(6, [1, 1, 0], Rat::ZERO)), PointError::NoSuchPrism { prism: 6, prisms: 6 });
    assert_eq!(
        error(point(u32::MAX, [1, 1, 0], Rat::ZERO)),
        PointError::NoSuchPrism { prism: u32::MAX, prisms: 6 }
    );
    for weights in [[1, 1, 1], [-1, 2, 1], [0, 0, 0]] {
        assert!(matches!(error(point(0, weights, Rat::ZERO)), PointError::Weights { prism: 0, .. }));
    }
    for height in [ratio(9, 8), ratio(-9, 8)] {
        assert!(matches!(error(point(0, [1, 1, 0], height)), PointError::Height { prism: 0, .. }));
    }
    assert!(projection.tets_of(u32::MAX).is_empty());
    assert_eq!(projection.trace(&[Rat::ZERO, Rat::ZERO, Rat::ZERO], u32::MAX), None);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(!projection.is_inside_f64(&[3.0, bad, 0.0]));
        assert_eq!(projection.project_exactly(&[bad, 0.0, 0.0]), None);
    }
    let huge = Rat::from(IBig::ONE << 5000);
    let tiny = ratio(1, 3) / &huge;
    for x in [huge.clone(), -huge] {
        assert!(!projection.is_inside(&[x.clone(), Rat::ZERO, Rat::ZERO]));
        assert!(!projection.is_inside(&[ratio(3, 1), Rat::ONE, x]));
    }
    assert!(projection.is_inside(&[ratio(3, 1), Rat::ONE, tiny]));
}

#[test]
fn extreme_scales() {
    let mut random = Random(6);
    for exponent in [-1071, -600, 600, 1020] {
        let shell = scaled(&spiral(9), [exponent; 3]);
        let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
        for i in 0..200 {
            let p = in_tet(&projection, i % projection.tets().len(), &random.weights());
            check_point(&projection, &p);
        }
    }
    // A thin shell in the middle of nowhere, with exponents that differ by more than 2,000.
    let mut shell = spiral(2);
    shell.bottom.iter_mut().for_each(|p| p[2] = -1e-300);
    shell.top.iter_mut().for_each(|p| p[2] = 5e-324);
    shell.top[0][2] = 1e308;
    let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
    for i in 0..200 {
        let p = in_tet(&projection, i % projection.tets().len(), &random.weights());
        check_point(&projection, &p);
    }
}
