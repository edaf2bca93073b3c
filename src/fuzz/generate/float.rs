//! Cases in floating point: whatever is rounded, the judge decides what came out.

use super::UNIT_PRISM;
use super::lattice::degenerate;
use crate::fuzz::Predicate;
use crate::fuzz::bits::{magnitude, neighbour, scaled};
use crate::fuzz::random::Random;

/// Coordinates in `[-1, 1)`; for the two predicates about prisms mostly such that the answer is not -1 at once.
pub(super) fn uniform(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    let mut case: Vec<f64> = (0..predicate.arity()).map(|_| random.real()).collect();
    match predicate {
        Predicate::PrismPositivity => {
            let noise = 0.3 * random.real();
            for (x, unit) in case.iter_mut().zip(UNIT_PRISM.as_flattened()) {
                *x = unit + noise * *x;
            }
        }
        Predicate::SectionDot => {
            let side = |i: usize| [0, 1, 2].map(|k| case[3 * i + k] - case[k]);
            let (u, v) = (side(1), side(2));
            let normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            let noise = random.real();
            for i in 0..9 {
                case[18 + i] = case[9 + i] + normal[i % 3] + noise * case[18 + i];
            }
        }
        _ => {}
    }
    case
}

/// Integers from -4 to 4.
pub(super) fn grid(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    (0..predicate.arity()).map(|_| random.below(9) as f64 - 4.0).collect()
}

/// A degenerate case, perhaps rounded to a random multiple, with some coordinates moved by up to two ulps.
pub(super) fn near(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    let mut case = degenerate(predicate, random);
    if random.below(2) == 0 {
        let factor = random.real();
        case.iter_mut().for_each(|x| *x *= factor);
    }
    let share = 1 + random.below(4);
    for x in &mut case {
        if random.below(share) == 0 {
            *x = neighbour(*x, random.integer(-2, 2));
        }
    }
    case
}

/// Small multiples of the least double, exactly degenerate or of any bits, some cases with points near one.
pub(super) fn subnormal(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    let mut case = if random.below(2) == 0 {
        let case = degenerate(predicate, random);
        // Lattice points have at most 51 bits: they fit among the subnormal numbers.
        case.into_iter().map(|x| scaled(x, -1074)).collect()
    } else {
        let bits = random.below(52) as u32;
        let any = |random: &mut Random| f64::from_bits(random.next() & ((1 << bits) | ((1 << bits) - 1)));
        let mut case: Vec<f64> = (0..predicate.arity()).map(|_| any(random)).collect();
        case.iter_mut().for_each(|x| *x *= if random.below(2) == 0 { 1.0 } else { -1.0 });
        case
    };
    if random.below(3) == 0 {
        for x in &mut case {
            if random.below(3) == 0 {
                *x = random.real();
            }
        }
    }
    case
}

/// Coordinates up to the largest double.
pub(super) fn overflow(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    let mut case = match random.below(3) {
        0 => uniform(predicate, random),
        1 => degenerate(predicate, random),
        _ => near(predicate, random),
    };
    let top = 1023 - random.integer(0, 29);
    let k = top - magnitude(&case).unwrap_or(0);
    case.iter_mut().for_each(|x| *x = scaled(*x, k));
    if random.below(4) == 0 {
        for x in &mut case {
            if random.below(3) == 0 {
                *x = f64::MAX.copysign(*x);
            }
        }
    }
    case
}

/// Points that coincide, coordinates that do, and zeros of both signs.
pub(super) fn shared(predicate: Predicate, random: &mut Random) -> Vec<f64> {
    let mut case =
        if random.below(2) == 0 { uniform(predicate, random) } else { degenerate(predicate, random) };
    let (dimension, points) = (predicate.dimension(), predicate.points());
    for _ in 0..=random.below(3) {
        let (from, to) = (random.below(points), random.below(points));
        if random.below(2) == 0 {
            case.copy_within(from * dimension..(from + 1) * dimension, to * dimension);
        } else {
            let axis = random.below(dimension);
            case[to * dimension + axis] = case[from * dimension + axis];
        }
    }
    if random.below(4) == 0 {
        let i = random.below(case.len());
        case[i] = if random.below(2) == 0 { 0.0 } else { -0.0 };
    }
    case
}
