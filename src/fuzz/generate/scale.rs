//! Cases multiplied by powers of two.

use crate::fuzz::Predicate;
use crate::fuzz::bits::{magnitude, scaled};
use crate::fuzz::random::Random;

/// Powers of two from the least subnormal number to the largest double.
const POWERS: u64 = 1074 + 1024;

/// The case brought to coordinates whose largest is in `[1, 2)`, and multiplied by the power of two of this turn.
///
/// Consecutive turns go through all powers, far jumps first, so that a short run has seen the whole range.
pub(super) fn swept(mut case: Vec<f64>, turn: usize) -> Vec<f64> {
    // 811 has no divisor in common with 2098: each power once in 2098 turns.
    let power = (turn as u64 % POWERS * 811 % POWERS) as i32 - 1074;
    let k = power - magnitude(&case).unwrap_or(0);
    for x in &mut case {
        *x = scaled(*x, k);
    }
    case
}

/// An exponent: -400, 0 or 400, or anything up to 1000.
fn exponent(random: &mut Random) -> i32 {
    match random.below(6) {
        0 => -400,
        1 => 400,
        2 | 3 => 0,
        _ => random.integer(-1000, 1000),
    }
}

/// The case with axes, points or single coordinates multiplied by different powers of two. Along axes,
/// orientations and all that follows from them stay as they are.
pub(super) fn spread(predicate: Predicate, mut case: Vec<f64>, random: &mut Random) -> Vec<f64> {
    let dimension = predicate.dimension();
    let by_axis = [(); 3].map(|()| exponent(random));
    let mode = random.below(4);
    let mut by_point = 0;
    for (i, x) in case.iter_mut().enumerate() {
        let axis = i % dimension;
        if axis == 0 {
            by_point = exponent(random);
        }
        let k = match mode {
            0 | 1 => by_axis[axis],
            2 => by_point,
            _ => exponent(random),
        };
        *x = scaled(*x, k);
    }
    case
}
