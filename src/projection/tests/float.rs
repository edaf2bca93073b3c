//! The floating-point answers against the exact ones: every stated bound is checked in rationals.

use super::generate::{in_tet, shell};
use crate::projection::{FloatPoint, MAX_ERROR, Projection, Rat, ShellPoint};
use crate::shell::VertexOrder;
use crate::shell::{Shell, hdf5};
use crate::testing::{Random, shell_directory};
use dashu_base::Abs;

/// The largest true error of an answer; panics where it is above the stated bound.
fn check(float: &FloatPoint, exact: &ShellPoint) -> f64 {
    assert_eq!(float.prism, exact.prism);
    assert!(float.error <= MAX_ERROR);
    let bound = Rat::try_from(float.error).unwrap();
    let pairs = float.weights.iter().zip(&exact.weights).chain([(&float.height, &exact.height)]);
    let mut worst = 0.0_f64;
    for (x, y) in pairs {
        let error = (Rat::try_from(*x).unwrap() - y).abs();
        assert!(error <= bound, "{float:?} is not {exact:?}");
        worst = worst.max(error.to_f64().value());
    }
    for (x, y) in float.weights.iter().zip(&exact.weights) {
        assert!(*x == 0.0 || *y != Rat::ZERO);
    }
    worst
}

/// Compares at a point near a rational one; is it inside, and with what error?
fn compare(projection: &Projection<'_>, p: &[f64; 3]) -> Option<(f64, f64)> {
    let exact = projection.project_exactly(p);
    let float = projection.project_f64(p);
    assert_eq!(exact.is_some(), float.is_some());
    let (exact, float) = (exact?, float?);
    Some((check(&float, &exact), float.error))
}

#[test]
fn generated_shells() {
    let mut random = Random(8);
    let (mut inside, mut worst, mut bound) = (0, 0.0_f64, 0.0_f64);
    for _ in 0..80 {
        let (shell, order) = shell(&mut random);
        let projection = Projection::new(&shell, &order).unwrap();
        for i in 0..60 {
            let tet = random.below(projection.tets().len());
            let p = in_tet(&projection, tet, &random.weights()).map(|x| x.to_f64().value());
            let p = if i % 4 == 0 { shell.middle[random.below(shell.vertex_count())] } else { p };
            if let Some((error, stated)) = compare(&projection, &p) {
                (inside, worst, bound) = (inside + 1, worst.max(error), bound.max(stated));
            }
        }
    }
    eprintln!("generated shells: {inside} points, largest error {worst:e}, largest bound {bound:e}");
    assert!(inside > 2000);
}

#[test]
fn real_shells() {
    let Some(directory) = shell_directory() else { return };
    let mut random = Random(9);
    for name in ["cube.obj.h5", "sphere.obj.h5.init", "bunny.off.h5", "c_homer.obj.h5", "tennis.off.h5.init"]
    {
        let file = hdf5::read(&directory.join(name)).unwrap();
        let projection = Projection::new(&file.shell, &VertexOrder::Id).unwrap();
        let (mut inside, mut worst, mut bound) = (0, 0.0_f64, 0.0_f64);
        for i in 0..400 {
            let tet = random.below(projection.tets().len());
            let p = in_tet(&projection, tet, &random.weights()).map(|x| x.to_f64().value());
            let p = if i % 4 == 0 { file.shell.middle[random.below(file.shell.vertex_count())] } else { p };
            if let Some((error, stated)) = compare(&projection, &p) {
                (inside, worst, bound) = (inside + 1, worst.max(error), bound.max(stated));
            }
        }
        eprintln!("{name}: {inside} points, largest error {worst:e}, largest bound {bound:e}");
        assert!(inside > 100);
    }
}

#[test]
fn flat_and_extreme_shells_fall_back_to_exact_arithmetic() {
    // A prism 2^-50 thick (and askew), and the reference prism near the ends of the range.
    let cases =
        [(1.0, 2_f64.powi(-50)), (2_f64.powi(-400), 2_f64.powi(-400)), (2_f64.powi(1000), 2_f64.powi(1000))];
    for (wide, thick) in cases {
        let layer = |z: f64| {
            vec![[0.0, wide * 0.1, z], [wide, 0.0, z + wide * 0.3], [wide * 0.2, wide, z - wide * 0.7]]
        };
        let shell =
            Shell { bottom: layer(-thick), middle: layer(0.0), top: layer(thick), faces: vec![[0, 1, 2]] };
        let projection = Projection::new(&shell, &VertexOrder::Id).unwrap();
        let mut random = Random(10);
        let mut inside = 0;
        for i in 0..400 {
            let weights = random.weights();
            let p = in_tet(&projection, i % projection.tets().len(), &weights).map(|x| x.to_f64().value());
            let p = if i % 4 == 0 { *shell.position(projection.tets()[i % 6].names[i / 4 % 4]) } else { p };
            inside += usize::from(compare(&projection, &p).is_some());
        }
        assert!(inside >= 100, "{inside}");
    }
}

#[test]
fn not_a_number_and_round_trip() {
    let mut random = Random(11);
    let (shell, order) = shell(&mut random);
    let projection = Projection::new(&shell, &order).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(projection.project_f64(&[bad, 0.0, 0.0]), None);
        assert!(projection.unproject_f64(0, [bad, 0.5, 0.0], 0.0).is_err());
        assert!(projection.unproject_f64(0, [0.5, 0.5, 0.0], bad).is_err());
    }
    assert!(projection.unproject_f64(0, [0.0; 3], 0.0).is_err());
    assert!(projection.unproject_f64(u32::MAX, [1.0, 0.0, 0.0], 0.0).is_err());
    assert!(projection.unproject_f64(0, [-1.0, 1.0, 1.0], 0.0).is_err());
    let m = shell.middle[shell.faces[0][1] as usize];
    assert_eq!(projection.unproject_f64(0, [0.0, 1.0, 0.0], 0.0).unwrap(), m);
    let t = shell.top[shell.faces[0][1] as usize];
    assert_eq!(projection.unproject_f64(0, [0.0, 0.7, 0.0], 5.0).unwrap(), t);
}
