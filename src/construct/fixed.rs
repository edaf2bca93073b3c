//! The direction problem once more with more digits than doubles have, for stars that are nearly folded: the sum of two
//! nearly opposite normals has lost its digits in floats.

use dashu_base::{BitTest, SquareRoot};
use dashu_int::{IBig, UBig};

use super::direction::unit;
use crate::certify::exact::{Vec3, cross, dot, minus};
use crate::mesh::TriMesh;
use crate::number::dyadic::scale_points;

/// Unit vectors are stored as integers times `2^-BITS`.
const BITS: usize = 200;

/// The direction that [`super::direction`] looks for, rounded at the very end.
pub(crate) fn most_normal(mesh: &TriMesh, faces: &[u32]) -> Option<[f64; 3]> {
    let normals: Vec<Vec3> = faces.iter().map(|&f| unit_normal(mesh, f)).collect();
    // The slack only decides which candidate is tried; the proof is exact.
    let fits = |x: &Tight, n: &Vec3| {
        let short = &x.height - dot(&x.along, n);
        short <= (&x.height >> (BITS / 2))
    };
    let mut x = Tight::one(normals.first()?);
    for i in 1..normals.len() {
        if fits(&x, &normals[i]) {
            continue;
        }
        x = Tight::one(&normals[i]);
        for j in 0..i {
            if fits(&x, &normals[j]) {
                continue;
            }
            x = Tight::two(&normals[i], &normals[j])?;
            for k in 0..j {
                if !fits(&x, &normals[k]) {
                    x = Tight::three(&normals[i], &normals[j], &normals[k])?;
                }
            }
        }
    }
    Some(rounded(&x.along))
}

/// A vector and its dot product with the normals that are tight; positive.
struct Tight {
    along: Vec3,
    height: IBig,
}

impl Tight {
    fn one(a: &Vec3) -> Self {
        Self { along: a.clone(), height: dot(a, a) }
    }

    fn two(a: &Vec3, b: &Vec3) -> Option<Self> {
        let along: Vec3 = std::array::from_fn(|i| &a[i] + &b[i]);
        let height = dot(&along, a);
        (height > IBig::ZERO).then_some(Self { along, height })
    }

    fn three(a: &Vec3, b: &Vec3, c: &Vec3) -> Option<Self> {
        let parts = [cross(b, c), cross(c, a), cross(a, b)];
        let sum: Vec3 = std::array::from_fn(|i| &parts[0][i] + &parts[1][i] + &parts[2][i]);
        let height = dot(&sum, a);
        if height == IBig::ZERO {
            return None;
        }
        Some(if height < IBig::ZERO {
            Self { along: sum.map(|x| -x), height: -height }
        } else {
            Self { along: sum, height }
        })
    }
}

fn unit_normal(mesh: &TriMesh, face: u32) -> Vec3 {
    let (x, _) = scale_points(&mesh.faces[face as usize].map(|v| mesh.vertices[v as usize]));
    let n = cross(&minus(&x[1], &x[0]), &minus(&x[2], &x[0]));
    let square: UBig = UBig::try_from(dot(&n, &n)).unwrap_or(UBig::ONE);
    // The root with BITS more bits than it needs, so that the quotient has them.
    let root = IBig::from((square << (2 * BITS)).sqrt());
    if root == IBig::ZERO { n } else { n.map(|x| (x << (2 * BITS)) / &root) }
}

fn rounded(v: &Vec3) -> [f64; 3] {
    let bits = v.iter().map(BitTest::bit_len).max().unwrap_or(0);
    // Only the small components of a vector lose digits, and those below 2^-500 of the largest one.
    let shift = bits.saturating_sub(600);
    unit(v.clone().map(|x| (x >> shift).to_f64().value()))
}
