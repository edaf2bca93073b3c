//! Random shells with positive tets, and random points in them. Deterministic.

use crate::projection::{Projection, Rat, ShellPoint};
use crate::shell::Shell;
use crate::shell::VertexOrder;
use crate::testing::Random;
use dashu_int::{IBig, UBig};

impl Random {
    /// In `[-1, 1)`: of few bits or of all bits of a double.
    pub(super) fn double(&mut self, coarse: bool) -> f64 {
        let bits = self.next();
        let scale = |n: u64, k: i32| n as f64 * 2_f64.powi(-k);
        if coarse { scale(bits % 16, 3) - 1.0 } else { scale(bits >> 11, 52) - 1.0 }
    }

    fn shuffled(&mut self, n: u32) -> Vec<u32> {
        let mut list: Vec<u32> = (0..n).collect();
        for i in (1..list.len()).rev() {
            let j = self.below(i + 1);
            list.swap(i, j);
        }
        list
    }

    /// Barycentric coordinates with sum one; any of them zero half of the time.
    pub(super) fn weights<const N: usize>(&mut self) -> [Rat; N] {
        loop {
            let parts: [u64; N] = std::array::from_fn(|_| self.next() % 11 * (self.next() % 2));
            let sum: u64 = parts.iter().sum();
            if sum > 0 {
                return parts.map(|p| Rat::from_parts(IBig::from(p), UBig::from(sum)));
            }
        }
    }
}

/// The point times powers of two, one for each axis. In two steps: 2^-1071 is no normal number.
pub(super) fn times(p: &[f64; 3], exponents: [i32; 3]) -> [f64; 3] {
    let by = |x: f64, e: i32| x * 2_f64.powi(e / 2) * 2_f64.powi(e - e / 2);
    [by(p[0], exponents[0]), by(p[1], exponents[1]), by(p[2], exponents[2])]
}

/// All points of the shell [`times`] powers of two.
pub(super) fn scaled(shell: &Shell, exponents: [i32; 3]) -> Shell {
    let layer = |points: &[[f64; 3]]| points.iter().map(|p| times(p, exponents)).collect();
    let (bottom, middle, top) = (layer(&shell.bottom), layer(&shell.middle), layer(&shell.top));
    Shell { bottom, middle, top, faces: shell.faces.clone() }
}

pub(super) fn ratio(n: i64, d: u64) -> Rat {
    Rat::from_parts(IBig::from(n), UBig::from(d))
}

type Points = Vec<[f64; 3]>;

/// A middle surface (a grid, an octahedron or one triangle) with outward directions.
fn surface(random: &mut Random) -> (Points, Points, Vec<[u32; 3]>) {
    match random.below(3) {
        0 => {
            let vertices = vec![[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
            (vertices, vec![[0.0, 0.0, 1.0]; 3], vec![[0, 1, 2]])
        }
        1 => {
            let n = 4_u32;
            let at = |i: u32, j: u32| i * n + j;
            let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
            let vertices =
                cells.clone().map(|(i, j)| [4.0 * f64::from(i), 4.0 * f64::from(j), 0.0]).collect();
            let faces = cells.filter(|&(i, j)| i + 1 < n && j + 1 < n);
            let faces = faces.flat_map(|(i, j)| {
                [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
            });
            (vertices, vec![[0.0, 0.0, 1.0]; 16], faces.collect())
        }
        _ => {
            let x = 6.0;
            let corners =
                [[x, 0.0, 0.0], [0.0, x, 0.0], [-x, 0.0, 0.0], [0.0, -x, 0.0], [0.0, 0.0, x], [0.0, 0.0, -x]];
            let faces = (0..4).flat_map(|i| [[i, (i + 1) % 4, 4], [(i + 1) % 4, i, 5]]);
            (corners.to_vec(), corners.map(|c| c.map(|x| x / 6.0)).to_vec(), faces.collect())
        }
    }
}

/// A random shell whose tets are positive under the returned order; bent pillars, some pinched.
pub(super) fn shell(random: &mut Random) -> (Shell, VertexOrder) {
    loop {
        let (middle, directions, faces) = surface(random);
        let coarse = random.below(2) == 0;
        let mut shell = Shell { faces, ..Shell::default() };
        for (m, d) in middle.iter().zip(&directions) {
            let mut moved =
                |offset: f64| [0, 1, 2].map(|i| m[i] + offset * d[i] + 0.4 * random.double(coarse));
            let points = [moved(-1.5), moved(0.0), moved(1.5)];
            let pinched = random.below(6) == 0;
            for (layer, point) in
                [&mut shell.bottom, &mut shell.middle, &mut shell.top].into_iter().zip(points)
            {
                layer.push(if pinched { points[1] } else { point });
            }
        }
        let count = u32::try_from(middle.len()).unwrap();
        let order =
            if random.below(2) == 0 { VertexOrder::Id } else { VertexOrder::List(random.shuffled(count)) };
        if Projection::new(&shell, &order).is_ok() {
            return (shell, order);
        }
    }
}

/// The point with these barycentric coordinates in a tet.
pub(super) fn in_tet(projection: &Projection<'_>, tet: usize, weights: &[Rat; 4]) -> [Rat; 3] {
    let names = projection.tets()[tet].names;
    [0, 1, 2].map(|i| {
        let x = |k: usize| Rat::try_from(projection.shell().position(names[k])[i]).unwrap();
        (0..4).fold(Rat::ZERO, |sum, k| sum + x(k) * &weights[k])
    })
}

/// A random point of the abstract shell: often on walls, on the middle surface, at top or bottom.
pub(super) fn shell_point(random: &mut Random, shell: &Shell) -> ShellPoint {
    let prism = random.below(shell.prism_count());
    let weights: [Rat; 3] = random.weights();
    let corners = shell.faces[prism];
    let thick = |k: usize| !shell.is_pinched(corners[k]);
    let limit = (0..3).filter(|&k| thick(k)).fold(Rat::ZERO, |sum, k| sum + &weights[k]);
    let height = limit * ratio(i64::try_from(random.below(9)).unwrap() - 4, 4);
    ShellPoint { prism: u32::try_from(prism).unwrap(), weights, height }
}

/// A flat strip around an octagon, `segments` quads long: it overlaps itself once longer than 8.
pub(super) fn spiral(segments: u32) -> Shell {
    let ring = [[2, 0], [2, 2], [0, 2], [-2, 2], [-2, 0], [-2, -2], [0, -2], [2, -2]];
    let mut shell = Shell::default();
    for i in 0..=segments {
        let [x, y] = ring[(i % 8) as usize].map(f64::from);
        for radius in [1.0, 2.0] {
            for (layer, z) in [(&mut shell.bottom, -1.0), (&mut shell.middle, 0.0), (&mut shell.top, 1.0)] {
                layer.push([radius * x, radius * y, z]);
            }
        }
    }
    for i in 0..segments {
        let [a, b, c, d] = [2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2];
        shell.faces.extend([[a, b, c], [a, c, d]]);
    }
    shell
}
