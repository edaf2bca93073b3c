//! Points with rational coordinates, and what the certifier asks of points of either kind.

use dashu_int::IBig;

use super::super::exact::{Vec3, sign};
use super::super::separate::ExactPoint;
use crate::number::{Rat, Rational};
use crate::predicate::{Axis, Sign, Stage};

/// A point `x / w`, with integers `x` and `w > 0`.
#[derive(Clone, Debug)]
pub(super) struct Homogeneous {
    x: Vec3,
    w: IBig,
    /// A box around the point: the coordinates, rounded down and up.
    low: [f64; 3],
    high: [f64; 3],
}

impl Homogeneous {
    pub(super) fn new(point: &[Rat; 3]) -> Self {
        // A common denominator: the product of the parts that are new. `a / gcd(a, b) * b` is the least one.
        let w = point.iter().fold(IBig::ONE, |w, x| {
            let d = IBig::from(x.denominator().clone());
            let whole = Rat::from(w.clone()) / Rat::from(d);
            w * IBig::from(whole.denominator().clone())
        });
        let x = point.each_ref().map(|x| x.numerator() * (&w / IBig::from(x.denominator().clone())));
        let near = point.each_ref().map(Rational::to_f64);
        Self { x, w, low: near.map(f64::next_down), high: near.map(f64::next_up) }
    }

    /// `other - self`, times both denominators.
    fn to(&self, other: &Self) -> Vec3 {
        [0, 1, 2].map(|i| &other.x[i] * &self.w - &self.x[i] * &other.w)
    }

    fn is_above(&self, other: &Self, axis: usize) -> bool {
        &self.x[axis] * &other.w > &other.x[axis] * &self.w
    }
}

impl ExactPoint for Homogeneous {
    fn is_at(&self, other: &Self) -> bool {
        self.to(other).iter().all(|x| sign(x).is_zero())
    }

    fn orient3d_staged(a: &Self, b: &Self, c: &Self, d: &Self) -> (Sign, Stage) {
        let [p, q, r] = [b, c, d].map(|x| a.to(x));
        let term = |i: usize, j: usize, k: usize| &p[i] * (&q[j] * &r[k] - &q[k] * &r[j]);
        (sign(&(term(0, 1, 2) + term(1, 2, 0) + term(2, 0, 1))), Stage::Big)
    }

    fn orient2d_staged(a: &Self, b: &Self, c: &Self, drop: Axis) -> (Sign, Stage) {
        let (i, j) = match drop {
            Axis::X => (1, 2),
            Axis::Y => (2, 0),
            Axis::Z => (0, 1),
        };
        let [p, q] = [b, c].map(|x| a.to(x));
        (sign(&(&p[i] * &q[j] - &p[j] * &q[i])), Stage::Big)
    }

    fn integers(points: &[&Self]) -> Vec<Vec3> {
        // The product of the different denominators is a common one; which one does not matter for signs.
        let mut all: Vec<&IBig> = points.iter().map(|p| &p.w).collect();
        all.sort_unstable();
        all.dedup();
        let scale = all.into_iter().fold(IBig::ONE, |product, w| product * w);
        points
            .iter()
            .map(|p| {
                let factor = &scale / &p.w;
                p.x.each_ref().map(|x| x * &factor)
            })
            .collect()
    }
}

/// Points that can be put into boxes.
pub(super) trait Point: ExactPoint {
    /// A box of doubles that holds the points.
    fn corners(&self) -> [[f64; 3]; 2];
    /// Do the boxes of two sets of points meet, given that the boxes of doubles around them do?
    fn boxes_meet(first: &[&Self], second: &[&Self]) -> bool;
}

impl Point for [f64; 3] {
    fn corners(&self) -> [[f64; 3]; 2] {
        [*self; 2]
    }

    fn boxes_meet(_: &[&Self], _: &[&Self]) -> bool {
        true
    }
}

/// Doubles far out, where a tree of boxes still computes without infinity; clamping keeps boxes that meet meeting.
const FAR: f64 = 1e150;

impl Point for Homogeneous {
    fn corners(&self) -> [[f64; 3]; 2] {
        [self.low, self.high].map(|p| p.map(|x| x.clamp(-FAR, FAR)))
    }

    fn boxes_meet(first: &[&Self], second: &[&Self]) -> bool {
        let wholly_above = |upper: &[&Self], lower: &[&Self], axis: usize| {
            upper.iter().all(|u| lower.iter().all(|l| u.is_above(l, axis)))
        };
        (0..3).all(|axis| !wholly_above(first, second, axis) && !wholly_above(second, first, axis))
    }
}
