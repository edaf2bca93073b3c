//! All points, as integers with one exponent, and the complexes: what every claim is checked against.

use crate::complex::Complex;
use crate::input::{Mesh, Shell};
use crate::line::Value;
use crate::number::{Vec3, decode, det, key, leading_bits, sgn, sign_near, sign_short};
use num_bigint::BigInt;

/// Points are numbered: shell name `(id, layer)` is `3 id + layer`, mesh vertex `g` is `3 nS + g`.
pub(crate) struct World {
    /// Integers in the order of the coordinates, for boxes and equality, which hold all bits.
    pub(crate) keys: Vec<[i64; 3]>,
    /// The 40 leading bits of the coordinates: divided by two to the power `exp + bits - 40` and rounded down.
    short: Vec<Vec3<i64>>,
    /// The bits of all coordinates together: from the largest one's first to the last one of any.
    bits: i64,
    /// A coordinate is an integer times two to this power.
    exp: i64,
    /// The number of the mesh vertex 0.
    pub(crate) base: usize,
    pub(crate) pinched: Vec<bool>,
    pub(crate) shell: Complex,
    pub(crate) mesh: Complex,
}

/// Which vertices have three equal points.
pub(crate) fn pinched(shell: &Shell) -> Vec<bool> {
    let [b, m, t] = shell.layers.each_ref().map(|layer| layer.iter().map(|p| p.map(key)));
    b.zip(m).zip(t).map(|((b, m), t)| b == m && m == t).collect()
}

impl World {
    pub(crate) fn new(shell: Shell, mesh: Mesh, (middle, surface): (Complex, Complex)) -> Self {
        let pinched = pinched(&shell);
        let vertices = pinched.len();
        let mut keys = Vec::with_capacity(3 * vertices + mesh.points.len());
        keys.extend((0..vertices).flat_map(|v| shell.layers.each_ref().map(|l| l[v].map(key))));
        drop(shell);
        keys.extend(mesh.points.into_iter().map(|p| p.map(key)));
        let parts = || keys.iter().flatten().map(|&x| decode(x)).filter(|x| x.0 != 0);
        let exp = parts().map(|x| x.1).min().unwrap_or(0);
        let top =
            parts().map(|(m, e)| e + 64 - i64::from(m.unsigned_abs().leading_zeros())).max().unwrap_or(0);
        let short = keys.iter().map(|p| p.map(|x| leading_bits(x, top, 40) as i64)).collect();
        Self { keys, short, bits: top - exp, exp, base: 3 * vertices, pinched, shell: middle, mesh: surface }
    }

    /// The name of a vertex in a layer.
    pub(crate) fn name(&self, v: usize, layer: usize) -> usize {
        3 * v + if self.pinched[v] { 1 } else { layer }
    }

    /// The points of a prism's pillars, from bottom to top; of a pinched one all three, which are equal.
    pub(crate) fn pillars(&self, prism: usize) -> [[usize; 3]; 3] {
        self.shell.of(prism).map(|v| [3 * v, 3 * v + 1, 3 * v + 2])
    }

    /// Whether a point number is not the `b` or `t` of a pinched vertex, which are no names.
    pub(crate) fn exists(&self, point: usize) -> bool {
        point >= self.base || point % 3 == 1 || !self.pinched[point / 3]
    }

    /// The point numbers of mesh triangle `f`.
    pub(crate) fn corners(&self, f: usize) -> [usize; 3] {
        self.mesh.of(f).map(|v| self.base + v)
    }

    /// A coordinate, divided by two to the power `exp`.
    pub(crate) fn integer(&self, point: usize, axis: usize) -> BigInt {
        let (mantissa, e) = decode(self.keys[point][axis]);
        if mantissa == 0 { BigInt::ZERO } else { BigInt::from(mantissa) << (e - self.exp) }
    }

    /// `y - x`.
    pub(crate) fn offset(&self, [x, y]: [usize; 2]) -> Vec3 {
        if self.bits <= 126 {
            return self.narrow_offset([x, y]).map(BigInt::from);
        }
        std::array::from_fn(|i| self.integer(y, i) - self.integer(x, i))
    }

    /// The same, where all coordinates together have at most 126 bits.
    pub(crate) fn narrow_offset(&self, [x, y]: [usize; 2]) -> Vec3<i128> {
        let short = |point: usize, axis: usize| match decode(self.keys[point][axis]) {
            (0, _) => 0,
            (mantissa, e) => i128::from(mantissa) << (e - self.exp),
        };
        std::array::from_fn(|i| short(y, i) - short(x, i))
    }

    /// Whether they have at most 80 bits.
    pub(crate) fn is_narrow(&self) -> bool {
        self.bits <= 80
    }

    /// The determinant of three differences of points.
    pub(crate) fn det(&self, rows: [[usize; 2]; 3]) -> BigInt {
        det(&rows.map(|row| self.offset(row)))
    }

    /// Its sign.
    pub(crate) fn sign(&self, rows: [[usize; 2]; 3]) -> i32 {
        let short = |[x, y]: [usize; 2]| std::array::from_fn(|i| self.short[y][i] - self.short[x][i]);
        let bits = |point: usize, i: usize| leading_bits(self.keys[point][i], self.exp + self.bits, 80);
        let near = |[x, y]: [usize; 2]| std::array::from_fn(|i| bits(y, i) - bits(x, i));
        let long = || sign_near(&rows.map(near), self.is_narrow());
        sign_short(&rows.map(short)).or_else(long).unwrap_or_else(|| sgn(&self.det(rows)))
    }

    /// The sign of `det[b - a, c - a, x - a]`: the side of the plane `a b c` on which `x` lies.
    pub(crate) fn side(&self, [a, b, c]: [usize; 3], x: usize) -> i32 {
        if [a, b, c].contains(&x) { 0 } else { self.sign([[a, b], [a, c], [a, x]]) }
    }

    /// Differences whose determinant is that of the points with the `i`-th one replaced by `x`: the barycentric
    /// coordinate of `x` at the `i`-th point, times the determinant of the points.
    pub(crate) fn replaced(&self, mut points: [usize; 4], i: usize, x: usize) -> [[usize; 2]; 3] {
        points[i] = x;
        let [a, b, c, d] = points;
        [[a, b], [a, c], [a, d]]
    }

    /// Differences of points whose determinant is the dot of triangle `f` with a pillar half.
    pub(crate) fn dot(&self, f: usize, pillar: [usize; 2]) -> [[usize; 2]; 3] {
        let [a, b, c] = self.corners(f);
        [[a, b], [a, c], pillar]
    }

    /// Whether `f` has a positive dot with both halves of all unpinched pillars of the prism.
    pub(crate) fn rises(&self, f: usize, prism: usize) -> bool {
        let halves = |v: usize| [[3 * v, 3 * v + 1], [3 * v + 1, 3 * v + 2]];
        let up = |half| self.sign(self.dot(f, half)) > 0;
        self.shell.of(prism).iter().all(|&v| self.pinched[v] || halves(v).into_iter().all(up))
    }

    /// The exact value of a determinant or dot.
    pub(crate) fn value(&self, number: &BigInt) -> Value {
        Value::new(number, 3 * self.exp)
    }

    /// The weighted sum of points, and the sum of the weights.
    pub(crate) fn mean(&self, points: &[usize], weights: &[BigInt]) -> (Vec3, BigInt) {
        let sum = |i: usize| points.iter().zip(weights).map(|(&p, w)| self.integer(p, i) * w).sum();
        (std::array::from_fn(sum), weights.iter().sum())
    }

    /// Whether all names are `t` or pinched, or all `b` or pinched, except a single pinched name.
    pub(crate) fn in_cap(&self, names: &[&[usize]]) -> bool {
        let names = || names.iter().copied().flatten();
        let pinched = |&n: &usize| n % 3 == 1 && self.pinched[n / 3];
        let cap = |layer: usize| names().all(|n| n % 3 == layer || pinched(n));
        (cap(0) || cap(2)) && !(names().count() == 1 && names().all(pinched))
    }
}

#[cfg(test)]
mod tests;
