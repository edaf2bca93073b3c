//! Rational points in homogeneous integers, signs of determinants of their differences, and order keys for boxes.

use crate::number::{Vec3, cross, det, dot, sgn, sign_near};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use rayon::prelude::*;

/// The point `x / w`, `w > 0`. In the plane the third coordinate is zero.
#[derive(Clone)]
pub(super) struct Hom {
    pub(super) x: Vec3,
    pub(super) w: BigInt,
}

/// A common denominator is used up to this size (doubles always have one); beyond it, every point keeps its own.
const COMMON_BITS: u64 = 2200;

/// A row of a determinant: a difference of points, or an exact vector with entries of at most `2^40`.
#[derive(Clone, Copy)]
pub(super) enum Row {
    Offset(usize, usize),
    Vector(Vec3<i64>),
}

/// The third row of a determinant in the plane; about as long as the other ones, so that the filter can decide.
const UP: Row = Row::Vector([0, 0, 1 << 40]);

/// The points of all inputs. Groups of inputs that are compared with each other have one scale.
pub(super) struct Points {
    pub(super) hom: Vec<Hom>,
    /// `x / w`, scaled and rounded down: at most `2^80` in absolute value.
    near: Vec<Vec3<i128>>,
    /// Ranks of the coordinates in the group: equal just for equal ones.
    pub(super) keys: Vec<[i64; 3]>,
}

/// `y - x` times a positive number.
fn difference(x: &Hom, y: &Hom) -> Vec3 {
    if x.w == y.w {
        return std::array::from_fn(|i| &y.x[i] - &x.x[i]);
    }
    std::array::from_fn(|i| &y.x[i] * &x.w - &x.x[i] * &y.w)
}

/// `floor(x 2^shift / w)`.
fn scaled(x: &BigInt, w: &BigInt, shift: i64) -> i128 {
    let exponent = size(x, w).saturating_add(shift);
    if x.is_zero() || exponent <= 0 {
        return i128::from(sgn(x).min(0));
    }
    let quotient = if shift >= 0 { (x << shift).div_floor(w) } else { x.div_floor(&(w << -shift)) };
    i128::try_from(quotient).unwrap_or(i128::MAX)
}

/// `|x / w| < 2^size`.
fn size(x: &BigInt, w: &BigInt) -> i64 {
    x.bits().cast_signed() - w.bits().cast_signed() + 1
}

/// Writes the points with one denominator if it is short.
fn common_denominator(group: &mut [Hom]) {
    let mut common = BigInt::one();
    for point in group.iter() {
        if !(&common % &point.w).is_zero() {
            common = common.lcm(&point.w);
        }
        if common.bits() > COMMON_BITS {
            return;
        }
    }
    group.par_iter_mut().for_each(|point| {
        let factor = &common / &point.w;
        point.x.iter_mut().for_each(|x| *x *= &factor);
        point.w.clone_from(&common);
    });
}

fn ranks(group: &[Hom], near: &[Vec3<i128>], axis: usize) -> Vec<i64> {
    // What is rounded down differently is ordered as it is.
    let order = |i: usize, j: usize| {
        let (p, q) = (&group[i], &group[j]);
        near[i][axis].cmp(&near[j][axis]).then_with(|| match p.w == q.w {
            true => p.x[axis].cmp(&q.x[axis]),
            false => (&p.x[axis] * &q.w).cmp(&(&q.x[axis] * &p.w)),
        })
    };
    let mut sorted: Vec<usize> = (0..group.len()).collect();
    sorted.par_sort_unstable_by(|&i, &j| order(i, j));
    let (mut ranks, mut rank) = (vec![0; group.len()], 0);
    for (at, &i) in sorted.iter().enumerate() {
        rank += i64::from(at > 0 && order(sorted[at - 1], i).is_ne());
        ranks[i] = rank;
    }
    ranks
}

impl Points {
    pub(super) fn new(groups: Vec<Vec<Hom>>) -> Self {
        let mut all = Self { hom: Vec::new(), near: Vec::new(), keys: Vec::new() };
        for mut group in groups {
            common_denominator(&mut group);
            let sizes = group.par_iter().flat_map_iter(|p| {
                p.x.iter().filter(|x| !x.is_zero()).map(|x| size(x, &p.w)).collect::<Vec<_>>()
            });
            let shift = 80 - sizes.max().unwrap_or(0);
            let round = |p: &Hom| p.x.each_ref().map(|x| scaled(x, &p.w, shift));
            let near: Vec<_> = group.par_iter().map(round).collect();
            let axes = [0, 1, 2].map(|axis| ranks(&group, &near, axis));
            all.keys.extend((0..group.len()).map(|i| axes.each_ref().map(|ranks| ranks[i])));
            all.near.extend(near);
            all.hom.extend(group);
        }
        all
    }

    fn near(&self, row: Row) -> Vec3<i128> {
        match row {
            Row::Offset(x, y) => std::array::from_fn(|i| self.near[y][i] - self.near[x][i]),
            Row::Vector(v) => v.map(|x| i128::from(x) << 40),
        }
    }

    /// The row times a positive number.
    pub(super) fn exact(&self, row: Row) -> Vec3 {
        match row {
            Row::Offset(x, y) => difference(&self.hom[x], &self.hom[y]),
            Row::Vector(v) => v.map(BigInt::from),
        }
    }

    /// The sign of a determinant; the filter is `sign_near`, whose bounds the roundings above keep.
    pub(super) fn sign(&self, rows: [Row; 3]) -> i32 {
        sign_near(&rows.map(|row| self.near(row)), false)
            .unwrap_or_else(|| sgn(&det(&rows.map(|row| self.exact(row)))))
    }

    /// The sign of `det[b - a, c - a (, d - a)]` of three points in the plane or four in space.
    pub(super) fn orient(&self, ids: &[usize]) -> i32 {
        match *ids {
            [a, b, c] => self.sign([Row::Offset(a, b), Row::Offset(a, c), UP]),
            [a, b, c, d] => self.sign([Row::Offset(a, b), Row::Offset(a, c), Row::Offset(a, d)]),
            _ => 0,
        }
    }

    /// The sign of the dot of `b - a` and `d - c`.
    pub(super) fn along(&self, [a, b]: [usize; 2], [c, d]: [usize; 2]) -> i32 {
        sgn(&dot(&self.exact(Row::Offset(a, b)), &self.exact(Row::Offset(c, d))))
    }

    /// The normal of a triangle times a positive number.
    pub(super) fn normal(&self, [a, b, c]: [usize; 3]) -> Vec3 {
        cross(&self.exact(Row::Offset(a, b)), &self.exact(Row::Offset(a, c)))
    }

    /// The weighted mean of points; the weights are not all zero.
    pub(super) fn mean(&self, ids: &[usize], weights: &[BigInt]) -> Hom {
        let common = ids.iter().fold(BigInt::one(), |all, &id| all.lcm(&self.hom[id].w));
        let mut mean = Hom { x: [BigInt::ZERO; 3], w: weights.iter().sum::<BigInt>() * &common };
        for (&id, weight) in ids.iter().zip(weights) {
            let factor = weight * (&common / &self.hom[id].w);
            mean.x.iter_mut().zip(&self.hom[id].x).for_each(|(sum, x)| *sum += x * &factor);
        }
        mean
    }

    /// Whether a point lies in the closed simplex of a full complex; never if that is flat.
    pub(super) fn holds(&self, cell: &[usize], point: &Hom) -> bool {
        let whole = self.orient(cell);
        let side = |skip: usize| {
            let corner = |i: usize| if i == skip { point } else { &self.hom[cell[i]] };
            let row = |i: usize| match cell.len() {
                n if i < n => difference(corner(0), corner(i)),
                _ => [BigInt::ZERO, BigInt::ZERO, BigInt::one()],
            };
            sgn(&det(&[row(1), row(2), row(3)]))
        };
        whole != 0 && (0..cell.len()).all(|k| side(k) * whole >= 0)
    }
}

impl PartialEq for Hom {
    fn eq(&self, other: &Self) -> bool {
        self.x.iter().zip(&other.x).all(|(x, y)| x * &other.w == y * &self.w)
    }
}

#[cfg(test)]
mod tests;
