//! Rays in the plane of a triangle: what they meet is read off a drawing, and off every affine copy of it.

use super::*;
use crate::meshes::points::Hom;

/// The triangle, then the ray's origin.
const CORNERS: [[i64; 2]; 3] = [[2, 2], [6, 2], [2, 6]];

fn met(origin: [i64; 2], direction: [i64; 2], height: i64) -> Meeting {
    let corners = CORNERS.map(|[x, y]| [x, y, 0]);
    let all = [corners[0], corners[1], corners[2], [origin[0], origin[1], height]];
    let point = |p: &[i64; 3]| Hom { x: p.map(BigInt::from), w: BigInt::from(1) };
    let points = Points::new(vec![all.iter().map(point).collect()]);
    let turned = [[0, 1, 2], [1, 2, 0], [0, 2, 1]];
    let mut answers = turned.map(|t| meeting(&points, 3, [direction[0], direction[1], 0], t)).into_iter();
    let first = answers.next().expect("three answers");
    assert!(answers.all(|a| a == first), "the corners' order decides for {origin:?} {direction:?}");
    first
}

#[test]
fn in_the_plane() {
    let touches = [
        ([0, 0], [1, 1]),   // across a corner and the inside
        ([0, 3], [1, 0]),   // through two sides
        ([3, 3], [1, 0]),   // from inside
        ([2, 2], [-1, -1]), // from a corner, away
        ([4, 2], [0, -1]),  // from a side, away
        ([0, 2], [1, 0]),   // along a side
        ([4, 2], [1, 0]),   // from within a side, along it
        ([6, 2], [1, 0]),   // from its end, along it and away
        ([0, 4], [1, -1]),  // past a corner, which it touches
        ([0, 8], [1, -1]),  // along the long side
    ];
    for (origin, direction) in touches {
        assert!(met(origin, direction, 0) == Meeting::Other, "{origin:?} {direction:?} touches");
        // Beside the plane it is off.
        for height in [-1, 1] {
            assert!(met(origin, direction, height) == Meeting::None, "{origin:?} {direction:?} is beside");
        }
    }
    let misses = [
        ([0, 0], [1, 0]),   // beside
        ([0, 0], [-1, -1]), // the triangle is behind
        ([0, 3], [-1, 0]),  // behind, between two corners
        ([7, 2], [1, 0]),   // on a side's line, beyond it
        ([1, 2], [-1, 0]),  // on a side's line, before it
        ([0, 3], [1, -1]),  // before the corner
        ([0, 9], [1, -1]),  // beyond the long side
        ([5, 5], [1, 1]),   // off the long side, away
    ];
    for (origin, direction) in misses {
        assert!(met(origin, direction, 0) == Meeting::None, "{origin:?} {direction:?} misses");
    }
}
