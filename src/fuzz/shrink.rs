//! From a case that fails to a smaller one that fails in the same way.

use super::bits::{exponent, magnitude, power, scaled};
use super::finding::{Failure, band};
use super::{Class, Predicate, Subject, SubjectError, judge};
use crate::number::dyadic::decompose;

/// What a search for a smaller case has come to.
#[derive(Debug)]
pub(super) struct Shrunk {
    /// The case.
    pub(super) case: Vec<f64>,
    /// Has no single step made it smaller, with tries to spare?
    pub(super) minimal: bool,
}

/// Candidates that are asked about at once; one of those that may end the subject or take its time.
pub(super) const AT_ONCE: usize = 16;

/// Takes steps that make the case simpler ([`cost`]) while it fails in the same class, within the same band of
/// magnitudes (else all cases of a class would shrink to one).
pub(super) fn shrink(
    subject: &mut dyn Subject,
    predicate: Predicate,
    failure: &Failure,
    tries: usize,
    stop: &dyn Fn() -> bool,
) -> Result<Shrunk, SubjectError> {
    let mut best = failure.case.clone();
    let mut tries = tries;
    let at_once = if matches!(failure.class, Class::Hang | Class::Crash) { 1 } else { AT_ONCE };
    // What does not come back cannot be searched for.
    if stop() || fails(subject, predicate, failure, &[&best])? != [true] {
        return Ok(Shrunk { case: best, minimal: false });
    }
    loop {
        let before = cost(&best);
        let steps = steps(&best, predicate);
        let mut next = 0;
        while next < steps.len() {
            if tries == 0 || stop() {
                return Ok(Shrunk { case: best, minimal: false });
            }
            let last = steps.len().min(next + at_once);
            let worth = |step: &Step| {
                let case = step.apply(&best, predicate.dimension());
                let smaller = cost(&case) < cost(&best) && band(&case) == band(&failure.case);
                (smaller && predicate.accepts(&case)).then_some(case)
            };
            let candidates: Vec<(usize, Vec<f64>)> =
                (next..last).filter_map(|i| Some((i, worth(steps.get(i)?)?))).collect();
            tries = tries.saturating_sub(candidates.len());
            let cases: Vec<&[f64]> = candidates.iter().map(|(_, case)| case.as_slice()).collect();
            let failing = fails(subject, predicate, failure, &cases)?;
            next = last;
            if let Some((i, case)) =
                candidates.into_iter().zip(failing).find_map(|(c, fails)| fails.then_some(c))
            {
                best = case;
                next = i + 1;
            }
        }
        if cost(&best) >= before {
            return Ok(Shrunk { case: best, minimal: true });
        }
    }
}

/// Which of the cases fail in the same way as `failure`?
pub(super) fn fails(
    subject: &mut dyn Subject,
    predicate: Predicate,
    failure: &Failure,
    cases: &[&[f64]],
) -> Result<Vec<bool>, SubjectError> {
    if cases.is_empty() {
        return Ok(Vec::new());
    }
    let answers = subject.answer(predicate, &cases.concat())?;
    let Some(symmetry) = &failure.symmetry else {
        let class =
            |case: &[f64], answer| judge(predicate, case).and_then(|expected| Class::of(answer, expected));
        return Ok(cases
            .iter()
            .zip(&answers)
            .map(|(case, a)| class(case, a) == Some(failure.class))
            .collect());
    };
    let images: Vec<f64> = cases.iter().flat_map(|c| symmetry.image(c, predicate.dimension())).collect();
    let others = subject.answer(predicate, &images)?;
    Ok(answers.iter().zip(&others).map(|(one, other)| symmetry.contradicts(one, other)).collect())
}

/// How complicated a case is: bits of mantissas that are set, lengths of mantissas and exponents, signs.
pub(super) fn cost(case: &[f64]) -> u32 {
    case.iter().map(|x| cost_of(*x)).sum()
}

fn cost_of(x: f64) -> u32 {
    let (mantissa, _) = decompose(x);
    let mantissa = mantissa.unsigned_abs();
    let Some(e) = exponent(x) else { return u32::from(x.is_sign_negative()) };
    let e = e.unsigned_abs();
    4 + 8 * mantissa.count_ones()
        + 2 * (64 - mantissa.leading_zeros())
        + e.count_ones()
        + (32 - e.leading_zeros())
        + u32::from(x < 0.0)
}

/// A change of a case.
#[derive(Clone, Copy, Debug)]
enum Step {
    /// A point to the origin.
    ZeroPoint(usize),
    /// An axis to zero.
    ZeroAxis(usize),
    /// A point to the origin, and all others with it.
    Move(usize),
    /// All coordinates times a power of two.
    Scale(i32),
    /// An axis times a power of two.
    ScaleAxis(usize, i32),
    /// All coordinates to multiples of a power of two.
    Grid(i32),
    /// A coordinate to another value.
    Set(usize, f64),
    /// A coordinate to its first bits, rounded towards zero or away from it.
    Keep(usize, u32, bool),
    /// A coordinate without its last bit.
    Drop(usize),
    /// A coordinate's exponent, divided.
    Shorten(usize, i32),
    /// A coordinate times two or a half: towards one.
    Closer(usize),
    /// A coordinate's sign.
    Abs(usize),
}

/// Steps worth trying, the boldest first.
fn steps(case: &[f64], predicate: Predicate) -> Vec<Step> {
    let dimension = predicate.dimension();
    let mut out: Vec<Step> = Vec::new();
    let points = 0..predicate.points();
    out.extend(points.clone().map(Step::ZeroPoint));
    out.extend((0..dimension).map(Step::ZeroAxis));
    out.extend(points.map(Step::Move));
    if let Some(e) = magnitude(case) {
        let powers = [-e, -e / 2, -e / 4, -e / 8, -e.signum()];
        out.extend(powers.map(Step::Scale));
        for axis in 0..dimension {
            out.extend(powers.map(|k| Step::ScaleAxis(axis, k)));
        }
        out.extend([0, 1, 2, 3, 4, 5, 6, 8, 10, 13, 17, 22, 28, 35, 43].map(|j| Step::Grid(e - j)));
    }
    for i in 0..case.len() {
        out.extend([0.0, 1.0, -1.0].map(|x| Step::Set(i, x)));
        for bits in [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 44] {
            out.extend([Step::Keep(i, bits, false), Step::Keep(i, bits, true)]);
        }
        out.extend([2, 4].map(|by| Step::Shorten(i, by)));
        out.extend([Step::Drop(i), Step::Closer(i), Step::Abs(i)]);
    }
    out
}

/// `x` rounded towards zero to a multiple of `2^k`.
fn truncated(x: f64, k: i32) -> f64 {
    let Some(e) = exponent(x) else { return x };
    if e < k {
        return 0.0;
    }
    let kept = (e - k).min(52);
    // The mantissa's place in the bits is that of the exponent, and for a subnormal number of 2^-1074.
    let surplus = if e < -1022 { (k + 1074).clamp(0, 52) } else { 52 - kept };
    f64::from_bits(x.to_bits() >> surplus << surplus)
}

fn changed(x: f64, step: Step) -> f64 {
    let e = exponent(x).unwrap_or(0);
    match step {
        Step::Set(_, value) => value,
        Step::Keep(_, bits, up) => {
            let k = e - (bits.cast_signed() - 1);
            let down = truncated(x, k);
            if up && exponent(x).is_some() { down + power(k).copysign(x) } else { down }
        }
        Step::Drop(_) => {
            let (mantissa, exponent) = decompose(x);
            if mantissa == 0 { x } else { truncated(x, exponent + 1) }
        }
        Step::Shorten(_, by) => scaled(x, e / by - e),
        Step::Closer(_) => scaled(x, -e.signum()),
        Step::Abs(_) => x.abs(),
        _ => x,
    }
}

impl Step {
    fn apply(self, case: &[f64], dimension: usize) -> Vec<f64> {
        let mut out = case.to_vec();
        let axis_of = |i: usize| i % dimension;
        match self {
            Self::ZeroPoint(p) => out.iter_mut().skip(p * dimension).take(dimension).for_each(|x| *x = 0.0),
            Self::ZeroAxis(axis) => out.iter_mut().skip(axis).step_by(dimension).for_each(|x| *x = 0.0),
            Self::Move(p) => {
                let from: Vec<f64> = case.iter().skip(p * dimension).take(dimension).copied().collect();
                for (i, x) in out.iter_mut().enumerate() {
                    *x -= from.get(axis_of(i)).copied().unwrap_or(0.0);
                }
            }
            Self::Scale(k) => out.iter_mut().for_each(|x| *x = scaled(*x, k)),
            Self::ScaleAxis(axis, k) => {
                out.iter_mut().skip(axis).step_by(dimension).for_each(|x| *x = scaled(*x, k));
            }
            Self::Grid(k) => out.iter_mut().for_each(|x| *x = truncated(*x, k)),
            Self::Set(i, _)
            | Self::Keep(i, ..)
            | Self::Drop(i)
            | Self::Shorten(i, _)
            | Self::Closer(i)
            | Self::Abs(i) => {
                if let Some(x) = out.get_mut(i) {
                    *x = changed(*x, self);
                }
            }
        }
        out
    }
}
