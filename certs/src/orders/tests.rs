//! Clipping against points found on a lattice of the triangle.

use super::{clip, has_area};
use crate::complex::Complex;
use crate::input::{Mesh, Shell};
use crate::number::{Vec3, sgn};
use crate::world::World;
use num_bigint::BigInt;

/// The tet `b0 m0 t0 b1` and the mesh triangle `0 1 2` of these seven points.
fn world(points: &[[i32; 3]]) -> World {
    let bits = |p: &[i32; 3]| p.map(|x| f64::from(x).to_bits());
    let at = |i: usize| bits(&points[i]);
    let layers = [vec![at(0), at(3), at(0)], vec![at(1); 3], vec![at(2); 3]];
    let shell = Shell { layers, prisms: vec![[0, 1, 2]] };
    let mesh = Mesh { points: points[4..].iter().map(bits).collect(), triangles: vec![[0, 1, 2]] };
    let complex = || Complex::new(vec![[0, 1, 2]], 3, "").unwrap_or_else(|_| panic!("a triangle"));
    World::new(shell, mesh, (complex(), complex()))
}

/// The signs of a point's coordinates in the tet, positive inside.
fn inside(world: &World, row: &Vec3) -> [i32; 4] {
    let tet = [0, 1, 2, 3];
    let sign = world.side([0, 1, 2], 3);
    let at = world.corners(0).map(|x| [0, 1, 2, 3].map(|i| world.det(world.replaced(tet, i, x))));
    std::array::from_fn(|i| sgn(&(0..3).map(|j| &at[j][i] * &row[j]).sum::<BigInt>()) * sign)
}

#[test]
fn clips_as_the_lattice_says() {
    let mut state = 1u64;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        i32::try_from(state >> 61).expect("three bits") - 3
    };
    let corner = |i: i32, j: i32, k: i32| [i, j, k].map(BigInt::from);
    let whole = [corner(1, 0, 0), corner(0, 1, 0), corner(0, 0, 1)];
    let mut found = [0, 0];
    for _ in 0..800 {
        let points: Vec<[i32; 3]> = (0..7).map(|_| [next(), next(), next()]).collect();
        let world = world(&points);
        let piece = clip(&world, 0, [0, 1, 2, 3], &whole);
        let area = has_area(&piece);
        found[usize::from(area)] += 1;
        if world.side([0, 1, 2], 3) == 0 {
            assert!(!area);
            continue;
        }
        assert!(piece.iter().all(|row| inside(&world, row).iter().all(|s| *s >= 0)));
        assert!(piece.iter().flatten().all(|x| sgn(x) >= 0));
        let lattice = (1..16).flat_map(|i| (1..16 - i).map(move |j| (i, j, 16 - i - j)));
        let hit = lattice.map(|(i, j, k)| corner(i, j, k)).any(|row| inside(&world, &row) == [1; 4]);
        assert!(area || !hit, "{points:?}");
    }
    assert!(found[0] > 100 && found[1] > 100, "{found:?}");
}

#[test]
fn a_face_in_the_plane_counts_and_an_edge_does_not() {
    let tet = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]];
    let area = |f: [[i32; 3]; 3]| {
        let world = world(&[&tet[..], &f].concat());
        let whole = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|row| row.map(BigInt::from));
        has_area(&clip(&world, 0, [0, 1, 2, 3], &whole))
    };
    assert!(area([[0, 0, 0], [1, 0, 0], [0, 1, 0]]));
    assert!(!area([[0, 0, 0], [1, 0, 0], [0, -1, 0]]));
    assert!(!area([[0, 0, 0], [1, 0, 0], [0, 0, -1]]));
    assert!(!area([[-1, 0, 0], [1, -2, 0], [0, -1, 3]]));
}
