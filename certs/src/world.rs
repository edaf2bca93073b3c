//! All points, scaled to integers with one exponent, and the complexes: what every claim is checked against.

use crate::complex::Complex;
use crate::input::{Bits, Mesh, Shell};
use crate::line::{Point, Value};
use crate::number::{Num, Vec3, cross, decode, det, dot, key, sub};
use crate::tets::Tet;
use num_bigint::BigInt;

/// Points are numbered: shell name `(id, layer)` is `3 id + layer`, mesh vertex `g` is `3 nS + g`.
pub(crate) struct World<N> {
    points: Vec<Vec3<N>>,
    /// Integers in the order of the coordinates, for boxes and equality.
    pub(crate) keys: Vec<[i64; 3]>,
    /// A coordinate is its integer times two to this power.
    exp: i64,
    /// The number of the mesh vertex 0.
    pub(crate) base: usize,
    pub(crate) pinched: Vec<bool>,
    pub(crate) shell: Complex,
    pub(crate) mesh: Complex,
    normals: Vec<Vec3<N>>,
}

/// Which vertices have three equal points.
pub(crate) fn pinched(shell: &Shell) -> Vec<bool> {
    let [b, m, t] = &shell.layers;
    let same = |x: &Bits, y: &Bits| x.map(key) == y.map(key);
    b.iter().zip(m).zip(t).map(|((b, m), t)| same(b, m) && same(m, t)).collect()
}

fn in_order<'a>(shell: &'a Shell, mesh: &'a Mesh) -> impl Iterator<Item = &'a Bits> {
    let vertices = 0..shell.layers[0].len();
    vertices.flat_map(|v| shell.layers.iter().filter_map(move |l| l.get(v))).chain(&mesh.points)
}

/// The common exponent, and `L` such that all scaled coordinates are below `2^L`.
pub(crate) fn scale(shell: &Shell, mesh: &Mesh) -> (i64, usize) {
    let numbers = || in_order(shell, mesh).flatten().map(|&bits| decode(bits)).filter(|x| x.0 != 0);
    let exp = numbers().map(|x| x.1).min().unwrap_or(0);
    let bits = |x: (i64, i64)| i64::from(64 - x.0.unsigned_abs().leading_zeros()) + x.1 - exp;
    (exp, usize::try_from(numbers().map(bits).max().unwrap_or(0)).unwrap_or(0))
}

impl<N: Num> World<N> {
    pub(crate) fn new(shell: &Shell, mesh: &Mesh, exp: i64, complexes: (Complex, Complex)) -> Self {
        let number = |bits: u64| {
            let (mantissa, e) = decode(bits);
            N::scaled(mantissa, if mantissa == 0 { 0 } else { usize::try_from(e - exp).unwrap_or(0) })
        };
        let mut world = Self {
            points: in_order(shell, mesh).map(|p| p.map(number)).collect(),
            keys: in_order(shell, mesh).map(|p| p.map(key)).collect(),
            exp,
            base: 3 * shell.layers[0].len(),
            pinched: pinched(shell),
            shell: complexes.0,
            mesh: complexes.1,
            normals: Vec::new(),
        };
        world.normals = (0..world.mesh.triangles.len()).map(|f| world.normal_of(world.corners(f))).collect();
        world
    }

    pub(crate) fn points_in_mesh(&self) -> usize {
        self.points.len() - self.base
    }

    pub(crate) fn point(&self, point: Point) -> usize {
        match point {
            Point::Shell(name) => name,
            Point::Mesh(id) => self.base + id,
        }
    }

    /// `y - x` of two point numbers.
    pub(crate) fn offset(&self, x: usize, y: usize) -> Vec3<N> {
        sub(&self.points[y], &self.points[x])
    }

    /// `(b - a) x (c - a)`.
    pub(crate) fn normal_of(&self, [a, b, c]: [usize; 3]) -> Vec3<N> {
        cross(&self.offset(a, b), &self.offset(a, c))
    }

    /// The normal of mesh triangle `f`.
    pub(crate) fn normal(&self, f: usize) -> &Vec3<N> {
        &self.normals[f]
    }

    /// The point numbers of mesh triangle `f`.
    pub(crate) fn corners(&self, f: usize) -> [usize; 3] {
        self.mesh.triangles[f].map(|v| self.base + v)
    }

    /// `det[b - a, c - a, d - a]`.
    pub(crate) fn orient(&self, a: usize, b: usize, c: usize, d: usize) -> N {
        det(&self.offset(a, b), &self.offset(a, c), &self.offset(a, d))
    }

    /// The four determinants `orient` of the points with one of them replaced by `x`: `x`'s barycentric coordinates
    /// times the determinant of the points.
    pub(crate) fn coordinates(&self, [a, b, c, d]: [usize; 4], x: usize) -> [N; 4] {
        [self.orient(x, b, c, d), self.orient(a, x, c, d), self.orient(a, b, x, d), self.orient(a, b, c, x)]
    }

    /// The dot of triangle `f` with a tet.
    pub(crate) fn dot(&self, f: usize, tet: &Tet) -> N {
        dot(self.normal(f), &self.offset(tet.pillar.0, tet.pillar.1))
    }

    /// Whether `f` has a positive dot with both halves of all unpinched pillars of the prism.
    pub(crate) fn rises(&self, f: usize, prism: usize) -> bool {
        let up = |lo: usize| dot(self.normal(f), &self.offset(lo, lo + 1)).sgn() > 0;
        self.shell.triangles[prism].iter().all(|&v| self.pinched[v] || (up(3 * v) && up(3 * v + 1)))
    }

    /// The exact value of a determinant or dot.
    pub(crate) fn value(&self, number: &N) -> Value {
        Value::new(&number.big(), 3 * self.exp)
    }

    /// The weighted sum of points, and the sum of the weights.
    pub(crate) fn mean(&self, points: &[usize], weights: &[BigInt]) -> (Vec3<BigInt>, BigInt) {
        let sum = |i: usize| points.iter().zip(weights).map(|(&p, w)| self.points[p][i].big() * w).sum();
        (std::array::from_fn(sum), weights.iter().sum())
    }

    /// Whether all names are `t` or pinched, or all `b` or pinched, except a single pinched name.
    pub(crate) fn in_cap(&self, names: &[usize]) -> bool {
        let pinched = |&n: &usize| n % 3 == 1 && self.pinched[n / 3];
        let cap = |layer: usize| names.iter().all(|n| n % 3 == layer || pinched(n));
        (cap(0) || cap(2)) && !(names.len() == 1 && names.iter().all(pinched))
    }

    /// The coefficients `c` with `sum c = 0` and `sum c x = 0`, when they are unique up to a factor: each is a minor of
    /// the differences to the first point.
    pub(crate) fn dependence(&self, points: &[usize]) -> Option<Vec<N>> {
        let (&origin, others) = points.split_first()?;
        let d: Vec<Vec3<N>> = others.iter().map(|&p| self.offset(origin, p)).collect();
        let zero = || N::scaled(0, 0);
        let tail = match d.as_slice() {
            [a] => a.iter().all(|x| x.sgn() == 0).then(|| vec![N::scaled(1, 0)])?,
            [a, b] => {
                let flat = cross(a, b).iter().all(|x| x.sgn() == 0);
                let i = (0..3).find(|&i| flat && (a[i].sgn() != 0 || b[i].sgn() != 0))?;
                vec![b[i].clone(), zero().minus(&a[i])]
            }
            [a, b, c] => {
                let minors = [cross(b, c), cross(c, a), cross(a, b)];
                let flat = dot(&minors[0], a).sgn() == 0;
                let i = (0..3).find(|&i| flat && minors.iter().any(|m| m[i].sgn() != 0))?;
                minors.map(|m| m[i].clone()).to_vec()
            }
            [a, b, c, e] => {
                let all = vec![det(b, c, e), det(a, e, c), det(a, b, e), det(a, c, b)];
                all.iter().any(|x| x.sgn() != 0).then_some(all)?
            }
            _ => return None,
        };
        let head = tail.iter().fold(zero(), |sum, x| sum.minus(x));
        Some(std::iter::once(head).chain(tail).collect())
    }
}
