//! Signs of 2x2 and 3x3 determinants whose rows are differences of input points.
//!
//! Stages: [`filter3`]/[`filter2`] in floating point, then integers of fixed width (of one word a coordinate in
//! [`word`](super::word), of two and five here), then big integers. All see the same matrix: row `k` is `points[j] - points[i]` for `(i, j) = rows[k]`.
//!
//! # Notation of the proofs
//!
//! `u = 2^-53`. A float operation in round-to-nearest that does not overflow returns
//! `fl(x*y) = x*y*(1+d) + n` with `|d| <= u`, `|n| <= 2^-1075`; sums and differences have `n = 0`,
//! because a sum that falls below `2^-1022` is exact. Also `x - y = fl(x-y) * (1+d)`, `|d| <= u`.

use dashu_int::IBig;

use super::{Sign, Stage};
use crate::number::dyadic::decompose;
use crate::number::fixed::{Fixed, Magnitude};

/// Pairs `(i, j)` of point indices; each stands for the row `points[j] - points[i]`.
pub(super) type Rows<const R: usize> = [(usize, usize); R];

/// The first stage for the determinant with the rows `p`, `q`, `r` of ROUNDED differences.
///
/// # The bound
///
/// Let `D` be the wanted determinant of exact differences, `d` the computed one, `S` the exact sum of
/// the absolute values of the six products of ROUNDED differences, `s` its computed value (`permanent`)
/// and `L = |p0|+|p1|+|p2|`. Suppose for now that nothing overflows.
///
/// 1. Each of the six products in `D` is the one of rounded differences times three factors `1+d`.
/// 2. In `d`, each product passes through at most five roundings (inner product, difference, outer
///    product, two sums). Underflow adds: for each of the six inner products at most
///    `2^-1075 |p_k| (1+u)^4`, and for each of the three outer ones at most `2^-1075 (1+u)^2`.
///    Together at most `V = (1+u)^4 (2^-1074 L + 3 * 2^-1075)`.
/// 3. By 1 and 2, `|D - d| <= ((1+u)^3 - 1 + (1+u)^5 - 1) S + V <= 8.001 u S + V`.
/// 4. `s` has the same shape as `d`: `s >= (1-u)^5 S - V`, so `S <= 1.001 (s + V)` (and more exactly
///    `S <= (1 + 6u)(s + V)`), so `|D - d| <= 8.002 u s + 1.001 V`.
/// 5. The computed `err` loses at most four roundings and two underflows: it is at least
///    `(1-u)^4 (1e-15 s + 1e-300 (1-u)^2 L + 1e-300) - 2^-1073`. As `1e-15 > 9 u`, the first term covers
///    `8.002 u s`; as `1e-300 > 2^-1000`, the second covers `1.001 * 2^-1074 L`, and the last
///    `1.001 * 3 * 2^-1075 + 2^-1073`. Hence `|D - d| <= err`, and `|d| > err` gives `d` the sign of `D`.
///
/// A constant in place of the term with `L` would be unsound: the lost inner product of two tiny
/// differences is multiplied by `p_k`, which may be huge.
///
/// Overflow: if a difference is infinite, or any operation of `permanent` overflows, then `permanent` or
/// `L` is infinite or NaN, because each of the nine differences is a factor in it, all summands are
/// non-negative, and infinity survives sums and becomes infinity or NaN in products. Then `err` is
/// infinite or NaN and both comparisons fail. Otherwise, rounding being monotone, every intermediate of
/// `d` is bounded in absolute value by the corresponding intermediate of `permanent`, hence finite.
#[inline]
pub(super) fn filter3(p: [f64; 3], q: [f64; 3], r: [f64; 3]) -> Option<Sign> {
    Minors::new(q, r).filter3(p)
}

/// The part of [`filter3`] that two of the rows have in common for every third one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Minors {
    minors: [f64; 3],
    /// The sums of the absolute values of the products in the minors.
    sums: [f64; 3],
}

impl Minors {
    #[inline]
    pub(crate) fn new(q: [f64; 3], r: [f64; 3]) -> Self {
        let (q1r2, q2r1) = (q[1] * r[2], q[2] * r[1]);
        let (q2r0, q0r2) = (q[2] * r[0], q[0] * r[2]);
        let (q0r1, q1r0) = (q[0] * r[1], q[1] * r[0]);
        Self {
            minors: [q1r2 - q2r1, q2r0 - q0r2, q0r1 - q1r0],
            sums: [q1r2.abs() + q2r1.abs(), q2r0.abs() + q0r2.abs(), q0r1.abs() + q1r0.abs()],
        }
    }

    /// The determinant of the rows `p`, `q`, `r`, rounded, and the bound on its error; the same as of `q`, `r`, `p`, which have the
    /// same determinant.
    #[inline]
    pub(crate) fn determinant(&self, p: [f64; 3]) -> (f64, f64) {
        let ([m0, m1, m2], [s0, s1, s2]) = (self.minors, self.sums);
        let [x, y, z] = p.map(f64::abs);
        let permanent = x * s0 + y * s1 + z * s2;
        (p[0] * m0 + p[1] * m1 + p[2] * m2, 1e-15 * permanent + 1e-300 * (x + y + z) + 1e-300)
    }

    /// Its sign, where the bound decides.
    #[inline]
    pub(super) fn filter3(&self, p: [f64; 3]) -> Option<Sign> {
        let (determinant, err) = self.determinant(p);
        decided(determinant, err)
    }
}

/// The first stage for the determinant with the rows `p`, `q` of ROUNDED differences.
///
/// The bound, in the notation of [`filter3`]: two factors `1+d` from the differences, and a product and a
/// difference in `d`, so `|D - d| <= 4.001 u S + V` with `V = 2^-1074 (1+u)`; `S <= 1.001 (s + V)`; so
/// `|D - d| <= 4.002 u s + 1.001 V`. The computed `err` is at least
/// `(1-u)^2 (6e-16 s + 1e-300) - 2^-1074`, and `6e-16 > 5 u`, `1e-300 > 2^-1000`. The products here are not
/// multiplied again, so a constant underflow term is enough. Overflow: as in [`filter3`], each of the four
/// differences is a factor in `permanent`.
#[inline]
pub(super) fn filter2(p: [f64; 2], q: [f64; 2]) -> Option<Sign> {
    let (left, right) = (p[0] * q[1], p[1] * q[0]);
    let err = 6e-16 * (left.abs() + right.abs()) + 1e-300;
    decided(left - right, err)
}

/// False for every comparison with a NaN, and for every value against an infinite `err`.
#[inline]
fn decided(value: f64, err: f64) -> Option<Sign> {
    if value > err {
        Some(Sign::Positive)
    } else if value < -err {
        Some(Sign::Negative)
    } else {
        None
    }
}

/// Point coordinates as integers, each axis scaled by a power of two of its own.
///
/// Scaling a column of the matrix by a positive number changes no sign.
pub(super) struct Integers<const N: usize, const A: usize> {
    mantissa: [[i64; N]; A],
    shift: [[u32; N]; A],
    /// Every integer `mantissa * 2^shift` is below `2^bits` in absolute value.
    bits: u32,
}

impl<const N: usize, const A: usize> Integers<N, A> {
    /// Takes `coordinates[axis][point]`.
    #[inline]
    pub(super) fn new(coordinates: [[f64; N]; A]) -> Self {
        let mut out = Self { mantissa: [[0; N]; A], shift: [[0; N]; A], bits: 0 };
        // Plain loops: `map` on arrays is not inlined here and doubles the time of stage 2.
        for ((values, mantissa), shift) in coordinates.iter().zip(&mut out.mantissa).zip(&mut out.shift) {
            let mut exponents = [0; N];
            let mut lowest = i32::MAX;
            for ((x, m), e) in values.iter().zip(mantissa.iter_mut()).zip(&mut exponents) {
                (*m, *e) = decompose(*x);
                lowest = lowest.min(if *m == 0 { i32::MAX } else { *e });
            }
            for ((m, s), e) in mantissa.iter().zip(shift).zip(exponents) {
                *s = if *m == 0 { 0 } else { e.abs_diff(lowest) };
                out.bits = out.bits.max(*s + 64 - m.unsigned_abs().leading_zeros());
            }
        }
        out
    }

    /// The entries `differences[row][axis]`.
    #[inline]
    fn fixed<const D: usize, const R: usize>(&self, rows: Rows<R>) -> [[Magnitude<D>; A]; R] {
        let mut points = [[Fixed::<D>::ZERO; N]; A];
        for ((out, mantissa), shift) in points.iter_mut().zip(&self.mantissa).zip(&self.shift) {
            for ((out, m), s) in out.iter_mut().zip(mantissa).zip(shift) {
                *out = Fixed::shifted(*m, *s);
            }
        }
        let zero = Magnitude { negative: false, limbs: [0; D] };
        let mut differences = [[zero; A]; R];
        for (row, (i, j)) in differences.iter_mut().zip(rows) {
            for (out, axis) in row.iter_mut().zip(&points) {
                *out = axis[j].minus(axis[i]).magnitude();
            }
        }
        differences
    }

    fn big(&self, axis: usize, (i, j): (usize, usize)) -> IBig {
        let [from, to] = [i, j].map(|k| IBig::from(self.mantissa[axis][k]) << self.shift[axis][k] as usize);
        to - from
    }
}

impl<const N: usize> Integers<N, 3> {
    /// Stage 2 where the integers are narrow enough, else stage 3.
    pub(super) fn sign(&self, rows: Rows<3>) -> (Sign, Stage) {
        match self.bits {
            0..=125 => (self.sign_fixed::<2, 4, 6>(rows), Stage::Fixed),
            126..=317 => (self.sign_fixed::<5, 10, 15>(rows), Stage::Fixed),
            _ => (self.sign_big(rows), Stage::Big),
        }
    }

    /// The sign with differences of `D` limbs, minors of `M = 2D` and products of `P = 3D`.
    ///
    /// Requires `bits <= 64 D - 3`. Then differences are below `2^(64D-2)`, the two products of a minor
    /// below `2^(128D-4)`, a minor below `2^(128D-3)`, its multiple below `2^(192D-5)`, and the sum of
    /// three of these below `2^(192D-3)`: all fit.
    #[inline]
    fn sign_fixed<const D: usize, const M: usize, const P: usize>(&self, rows: Rows<3>) -> Sign {
        let [p, q, r] = self.fixed::<D, 3>(rows);
        let term = |i: usize, j: usize, k: usize| -> Fixed<P> {
            let minor: Fixed<M> = q[j].times::<D, M>(&r[k]).minus(q[k].times(&r[j]));
            minor.magnitude().times(&p[i])
        };
        term(0, 1, 2).plus(term(1, 2, 0)).plus(term(2, 0, 1)).sign()
    }

    /// Stage 3.
    #[cold]
    #[inline(never)]
    pub(super) fn sign_big(&self, rows: Rows<3>) -> Sign {
        let [p, q, r] = rows.map(|row| [0, 1, 2].map(|axis| self.big(axis, row)));
        let term = |i: usize, j: usize, k: usize| &p[i] * (&q[j] * &r[k] - &q[k] * &r[j]);
        (term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1)).cmp(&IBig::ZERO).into()
    }
}

impl<const N: usize> Integers<N, 2> {
    /// Stage 2 where the integers are narrow enough, else stage 3.
    pub(super) fn sign(&self, rows: Rows<2>) -> (Sign, Stage) {
        match self.bits {
            0..=125 => (self.sign_fixed::<2, 4>(rows), Stage::Fixed),
            126..=317 => (self.sign_fixed::<5, 10>(rows), Stage::Fixed),
            _ => (self.sign_big(rows), Stage::Big),
        }
    }

    /// As for three rows: requires `bits <= 64 D - 3`, so that a minor is below `2^(128D-3)`.
    #[inline]
    fn sign_fixed<const D: usize, const M: usize>(&self, rows: Rows<2>) -> Sign {
        let [p, q] = self.fixed::<D, 2>(rows);
        p[0].times::<D, M>(&q[1]).minus(p[1].times(&q[0])).sign()
    }

    /// Stage 3.
    #[cold]
    #[inline(never)]
    pub(super) fn sign_big(&self, rows: Rows<2>) -> Sign {
        let [p, q] = rows.map(|row| [0, 1].map(|axis| self.big(axis, row)));
        (&p[0] * &q[1]).cmp(&(&p[1] * &q[0])).into()
    }
}
