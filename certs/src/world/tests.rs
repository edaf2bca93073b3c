//! Signs and values against integers in units of the least double.

use super::World;
use crate::complex::Complex;
use crate::input::{Mesh, Shell};
use crate::number::{Vec3, decode, det, key, sgn};
use num_bigint::BigInt;

/// The points of one pillar, and those of the mesh.
fn world(points: &[[f64; 3]]) -> World {
    let bits: Vec<_> = points.iter().map(|p| p.map(f64::to_bits)).collect();
    let shell = Shell { layers: [vec![bits[0]], vec![bits[1]], vec![bits[2]]], prisms: vec![] };
    let mesh = Mesh { points: bits[3..].to_vec(), triangles: vec![] };
    let complex = || Complex::new(vec![], 1, "").unwrap_or_else(|_| panic!("nothing"));
    World::new(shell, mesh, (complex(), complex()))
}

/// The coordinate times `2^1074`.
fn whole(x: f64) -> BigInt {
    match decode(key(x.to_bits())) {
        (0, _) => BigInt::ZERO,
        (mantissa, e) => BigInt::from(mantissa) << (e + 1074),
    }
}

#[test]
fn signs_and_values_of_near_and_far_coordinates() {
    let mut state = 11u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 11
    };
    // Exponents spread over so many bits: all stages have their share.
    let mut seen = std::collections::BTreeMap::new();
    for round in 0..6000u64 {
        let spread = [1, 8, 40, 70, 300, 1900][usize::try_from(round % 6).expect("small")];
        let mut number = || {
            let scale =
                i32::try_from(next() % spread).expect("small") - i32::try_from(spread / 2).expect("small");
            let mantissa = (next() >> (next() % 40)) as f64;
            let x = mantissa * 2f64.powi(scale.clamp(-1020, 900));
            if next() % 2 == 0 { x } else { -x }
        };
        let mut points: [[f64; 3]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| number()));
        if round % 4 == 0 {
            // Coplanar, since two coordinates are equal, or nearly so.
            points.iter_mut().for_each(|p| p[1] = p[2]);
            if round % 8 == 0 {
                points[2][1] = points[2][1].next_up();
            }
        }
        let world = world(&points);
        let row = |i: usize| -> Vec3 { std::array::from_fn(|k| whole(points[i][k]) - whole(points[0][k])) };
        let exact = det(&[row(1), row(2), row(3)]);
        let rows = [[0, 1], [0, 2], [0, 3]];
        assert_eq!(world.sign(rows), sgn(&exact), "{points:?}");
        let value = world.value(&world.det(rows));
        let expected = crate::line::Value::new(&exact, -3 * 1074);
        assert!(value == expected, "{points:?}");
        *seen.entry((world.bits <= 80, world.bits <= 126, sgn(&exact))).or_insert(0) += 1;
    }
    assert!(seen.len() == 9 && seen.values().all(|&n| n > 20), "{seen:?}");
}

#[test]
fn signs_beside_a_far_point() {
    let mut state = 17u64;
    let mut next = move |range: u64| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) % range
    };
    let mut seen = std::collections::BTreeMap::new();
    for round in 0..20000u64 {
        // Near points differ in their last bits; of these the far point, which no row uses, leaves 0 to 13.
        let size = 1 + next(13);
        let whole_part = if next(2) == 0 { 1.0 } else { -1.0 };
        let mut number = |unit: u64| f64::from_bits(f64::to_bits(whole_part) + next(1 << size) * unit);
        let unit = 1 << (round % 30);
        let mut points: [[f64; 3]; 4] = std::array::from_fn(|_| std::array::from_fn(|_| number(unit)));
        if round % 3 == 0 {
            // Flat, then disturbed where the far point takes the bits.
            points.iter_mut().for_each(|p| p[2] = p[1]);
            points[3][2] = f64::from_bits(points[3][2].to_bits() + next(3));
        }
        let lost = i32::try_from(next(45)).expect("small") - 5;
        let far = 2f64.powi(80 - 52 + i32::try_from(round % 30).expect("small") + lost);
        let points: Vec<[f64; 3]> = points.into_iter().chain([[far, 0.0, -far]]).collect();
        let world = world(&points);
        let row = |i: usize| -> Vec3 { std::array::from_fn(|k| whole(points[i][k]) - whole(points[0][k])) };
        let exact = sgn(&det(&[row(1), row(2), row(3)]));
        assert_eq!(world.sign([[0, 1], [0, 2], [0, 3]]), exact, "{points:?}");
        *seen.entry((world.bits <= 80, exact)).or_insert(0) += 1;
    }
    assert!(seen.len() == 6 && seen.values().all(|&n| n > 100), "{seen:?}");
}
