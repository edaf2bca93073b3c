//! Signs, keys and coordinates against those of small integers, of which the points are huge affine images.

use super::*;

/// Numbers below a bound, the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % bound
    }

    /// An odd number of so many bits, about.
    fn odd(&mut self, bits: u32) -> BigInt {
        (0..bits / 16 + 1).fold(BigInt::one(), |n, _| (n << 16) + 2 * self.below(1 << 15) + 1)
    }
}

type Small = [i64; 3];

fn small_points(random: &mut Random, space: usize, many: usize) -> Vec<Small> {
    let mut coordinate = |axis| if axis < space { i64::try_from(random.below(5)).unwrap() - 2 } else { 0 };
    (0..many).map(|_| [0, 1, 2].map(&mut coordinate)).collect()
}

/// `(p + shift) / denominator`, each fraction extended by another number of so many bits.
fn images(points: &[Small], space: usize, shift: &BigInt, bits: u32, random: &mut Random) -> Points {
    let denominator = random.odd(bits);
    let image = |p: &Small| {
        let factor = random.odd(bits);
        let x = [0, 1, 2]
            .map(|axis| if axis < space { (BigInt::from(p[axis]) + shift) * &factor } else { BigInt::ZERO });
        Hom { x, w: &denominator * &factor }
    };
    Points::new(vec![points.iter().map(image).collect()])
}

fn small_det(rows: &[Small]) -> i64 {
    let [a, b, c] = [rows[0], rows[1], rows.get(2).copied().unwrap_or([0, 0, 1])];
    a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

fn small_orient(points: &[Small]) -> i64 {
    let rows: Vec<Small> = points[1..].iter().map(|p| [0, 1, 2].map(|i| p[i] - points[0][i])).collect();
    small_det(&rows)
}

#[test]
fn signs_keys_and_coordinates() {
    let mut random = Random(5);
    // Common denominators, ones that are too long for that, and differences far below the leading bits.
    for (shift, bits) in [(0, 8), (0, 900), (70, 8), (300, 200), (1200, 40)] {
        let shift = if shift == 0 { BigInt::ZERO } else { BigInt::one() << shift };
        for round in 0..300 {
            let space = 2 + round % 2;
            let small = small_points(&mut random, space, space + 2);
            let points = images(&small, space, &shift, bits, &mut random);
            let cell: Vec<usize> = (0..=space).collect();
            let whole = small_orient(&small[..=space]).signum();
            assert_eq!(i64::from(points.orient(&cell)), whole);
            for axis in 0..3 {
                for (i, j) in (0..small.len()).flat_map(|i| (0..small.len()).map(move |j| (i, j))) {
                    let keys = points.keys[i][axis].cmp(&points.keys[j][axis]);
                    assert_eq!(keys, small[i][axis].cmp(&small[j][axis]));
                }
            }
            let inside = whole != 0
                && (0..=space).all(|k| {
                    let mut moved = small[..=space].to_vec();
                    moved[k] = small[space + 1];
                    small_orient(&moved) * whole >= 0
                });
            assert_eq!(points.holds(&cell, &points.hom[space + 1]), inside);
        }
    }
}

#[test]
fn means() {
    let mut random = Random(7);
    for _ in 0..100 {
        let small = small_points(&mut random, 3, 3);
        let weights = [2, 0, 3].map(BigInt::from);
        let points = images(&small, 3, &BigInt::from(1_u64 << 50), 900, &mut random);
        // Five times the mean, as a point of the same image, is the weighted sum.
        let mean = points.mean(&[0, 1, 2], &weights);
        let sum = [0, 1, 2].map(|i| 2 * small[0][i] + 3 * small[2][i]);
        for i in 0..3 {
            let at = |p: &Hom, q: &Hom| &p.x[i] * &q.w - &q.x[i] * &p.w; // (p - q) p.w q.w
            let (left, right) = (at(&mean, &points.hom[1]), at(&points.hom[0], &points.hom[1]));
            // (mean - p1) : (p0 - p1) is (sum - 5 s1) : 5 (s0 - s1).
            let lhs = left * 5 * (small[0][i] - small[1][i]) * &points.hom[0].w;
            let rhs = right * (sum[i] - 5 * small[1][i]) * &mean.w;
            assert_eq!(lhs, rhs);
        }
    }
}
