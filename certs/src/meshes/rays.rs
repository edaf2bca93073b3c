//! Rays from vertices and the triangles that they cross (MESHES section 4.3, rule R4 of THEORY).

use super::pairs::Faces;
use super::parse::Ray;
use super::points::{Points, Row};
use crate::Res;
use crate::boxes::{Aabb, Tree};
use crate::number::{Vec3, cross, dot, sgn};
use num_bigint::BigInt;
use num_traits::Signed;

#[derive(PartialEq)]
enum Meeting {
    None,
    /// In one point inside; the sign of `normal . d`.
    Proper(i32),
    Other,
}

/// The number of a ray from the point `o` among triangles none of which is flat.
pub(super) fn number(points: &Points, o: usize, ray: &Ray, faces: &Faces, tree: &Tree<'_>) -> Res<i64> {
    let (mut crossed, mut sum) = (Vec::new(), 0);
    for at in tree.meeting(&bounds(points, o, ray.direction)) {
        match meeting(points, o, ray.direction, faces.corners[at]) {
            Meeting::None => {}
            Meeting::Proper(sign) => {
                crossed.push(faces.ids[at]);
                sum += i64::from(sign);
            }
            Meeting::Other => {
                return Err(bad!("ray", "line {}: triangle {} is touched", ray.line, faces.ids[at]));
            }
        }
    }
    crossed.sort_unstable();
    ensure!(crossed == ray.cells, "ray", "line {}: the ray crosses {crossed:?}", ray.line);
    Ok(sum)
}

/// The box of the ray, in order keys.
fn bounds(points: &Points, o: usize, d: Vec3<i64>) -> Aabb {
    let ends = [true, false].map(|low| {
        std::array::from_fn(|i| match d[i] {
            x if x < 0 && low => i64::MIN,
            x if x > 0 && !low => i64::MAX,
            _ => points.keys[o][i],
        })
    });
    Aabb::of(&ends, &[0, 1])
}

fn meeting(points: &Points, o: usize, d: Vec3<i64>, [p, q, r]: [usize; 3]) -> Meeting {
    let ray = Row::Vector(d);
    let (pq, pr) = (Row::Offset(p, q), Row::Offset(p, r));
    let slope = points.sign([pq, pr, ray]);
    let height = points.sign([pq, pr, Row::Offset(o, p)]);
    if slope == 0 {
        let misses = height != 0 || !meets_in_plane(points, o, d, [p, q, r]);
        return if misses { Meeting::None } else { Meeting::Other };
    }
    // Positive where the triangle winds around the line as around its normal.
    let sides = [(p, q), (q, r), (r, p)]
        .map(|(x, y)| slope * points.sign([ray, Row::Offset(o, x), Row::Offset(o, y)]));
    match (sides.iter().min(), slope * height) {
        (Some(..=-1), _) | (_, ..=-1) => Meeting::None,
        (Some(1..), 1..) => Meeting::Proper(slope),
        _ => Meeting::Other,
    }
}

/// Whether a ray in the plane of a triangle meets it: then it meets an edge, since it leaves it somewhere.
fn meets_in_plane(points: &Points, o: usize, d: Vec3<i64>, corners: [usize; 3]) -> bool {
    let normal = points.normal(corners);
    let d = points.exact(Row::Vector(d));
    let across = cross(&normal, &d);
    // For each corner, times one positive number: how far beside the line, how far along it.
    let at = corners.map(|x| {
        let x = points.exact(Row::Offset(o, x));
        (dot(&across, &x), dot(&d, &x))
    });
    let meets = |(beside, along): &(BigInt, BigInt), (beside2, along2): &(BigInt, BigInt)| match (
        sgn(beside),
        sgn(beside2),
    ) {
        (0, 0) => sgn(along) >= 0 || sgn(along2) >= 0,
        (x, y) if x * y > 0 => false,
        _ => sgn(&(along * beside2.abs() + along2 * beside.abs())) >= 0,
    };
    [(0, 1), (1, 2), (2, 0)].iter().any(|&(i, j)| meets(&at[i], &at[j]))
}

#[cfg(test)]
#[allow(clippy::expect_used)]
mod tests;
