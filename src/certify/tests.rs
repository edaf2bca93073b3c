//! Clipping by signs against clipping by exact coordinates.

use dashu_ratio::RBig;

use super::clip::clip;
use super::exact::{ExactPiece, has_area, normalised, whole};
use crate::predicate::orient3d;

/// Points on a small grid, where degenerate positions are the rule.
struct Grid(u64);

impl Grid {
    fn point(&mut self, size: u64) -> [f64; 3] {
        [0; 3].map(|_| {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            // At most 2^31, so that the conversion is exact.
            f64::from(u32::try_from((self.0 >> 33) % size).unwrap())
        })
    }
}

/// The corners of `f` cut with the tet, by exact Sutherland-Hodgman, as points with weights of sum one.
fn exact_corners(exact: &ExactPiece) -> Vec<[RBig; 3]> {
    let mut corners: Vec<[RBig; 3]> = exact.cut_with_tet(&whole()).iter().filter_map(normalised).collect();
    corners.sort();
    corners.dedup();
    corners
}

#[test]
fn clipping_by_signs_is_clipping() {
    let mut grid = Grid(7);
    let (mut areas, mut coplanar) = (0, 0);
    for round in 0..40_000 {
        let size = [2, 3, 4, 1000][round % 4];
        let p: [[f64; 3]; 7] = std::array::from_fn(|_| grid.point(size));
        let f = [&p[0], &p[1], &p[2]];
        let mut tet = [&p[3], &p[4], &p[5], &p[6]];
        let flat_triangle = crate::predicate::zero_area(f[0], f[1], f[2]);
        match orient3d(tet[0], tet[1], tet[2], tet[3]).as_i8() {
            0 => continue,
            -1 => tet.swap(0, 1),
            _ => {}
        }
        if flat_triangle {
            continue;
        }
        let exact = ExactPiece::new(f, tet);
        let polygon = clip(f, tet);
        assert_eq!(polygon.is_some(), has_area(&exact.cut_with_tet(&whole())), "{p:?}");
        let Some(polygon) = polygon else { continue };
        areas += 1;
        coplanar += usize::from(polygon.coplanar.is_some());
        let mut corners = Vec::new();
        for corner in polygon.corners() {
            let weights = exact.weights(corner.mask).unwrap();
            // The mask says exactly which coordinates vanish.
            let in_tet = exact.in_tet(&weights).unwrap();
            for (bit, x) in weights.iter().chain(&in_tet).enumerate() {
                assert_eq!(corner.mask & (1 << bit) != 0, *x == RBig::ZERO, "{p:?}");
            }
            corners.push(weights);
        }
        corners.sort();
        assert_eq!(corners, exact_corners(&exact), "{p:?}");
    }
    assert!(areas > 1_000 && coplanar > 50, "{areas} {coplanar}");
}
