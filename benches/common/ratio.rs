//! Measurements side by side: all take their turn in every round, and ratios are taken within a round, so that other load on
//! the machine falls on both sides.

use serde::Serialize;

use crate::table::median;

/// The middle of a few numbers, and how far they spread.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// The median.
    pub median: f64,
    /// The lower and the upper quartile.
    pub quartiles: [f64; 2],
    /// The smallest and the largest.
    pub range: [f64; 2],
    /// How many there are.
    pub rounds: usize,
}

impl Spread {
    /// That of these numbers; NaN for none.
    #[must_use]
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let last = sorted.len().saturating_sub(1);
        let at = |k: usize| sorted.get(k).copied().unwrap_or(f64::NAN);
        // Outward: with three numbers the quartiles are the ends.
        Self {
            median: median(values),
            quartiles: [at(last / 4), at(last - last / 4)],
            range: [at(0), at(last)],
            rounds: values.len(),
        }
    }

    /// That of `other / ours`, round by round.
    #[must_use]
    pub fn of_ratios(other: &[f64], ours: &[f64]) -> Self {
        Self::of(&other.iter().zip(ours).map(|(a, b)| a / b).collect::<Vec<_>>())
    }
}

/// One of the things that take turns; answers with its seconds.
pub type Side<'a, E> = Box<dyn FnMut() -> Result<f64, E> + 'a>;

/// The seconds of every side in every round. Each round begins with another side; before the first all run once
/// unmeasured, if `warm`.
///
/// # Errors
/// The first of a side.
pub fn take_turns<E>(rounds: usize, warm: bool, sides: &mut [Side<'_, E>]) -> Result<Vec<Vec<f64>>, E> {
    let mut out = vec![Vec::with_capacity(rounds); sides.len()];
    if warm {
        for side in sides.iter_mut() {
            side()?;
        }
    }
    for round in 0..rounds {
        for k in 0..sides.len() {
            let at = (round + k) % sides.len();
            let seconds = sides[at]()?;
            out[at].push(seconds);
        }
    }
    Ok(out)
}

// The numbers are whole.
#[cfg(test)]
#[allow(clippy::float_cmp)]
mod tests {
    use super::{Side, Spread, take_turns};

    #[test]
    fn quartiles_and_range() {
        let spread = Spread::of(&[5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!((spread.median, spread.quartiles, spread.range), (3.0, [2.0, 4.0], [1.0, 5.0]));
        let three = Spread::of(&[3.0, 1.0, 2.0]);
        assert_eq!((three.median, three.quartiles), (2.0, [1.0, 3.0]));
        assert!(Spread::of(&[]).median.is_nan());
    }

    #[test]
    fn ratios_are_taken_within_a_round() {
        assert_eq!(Spread::of_ratios(&[2.0, 40.0, 6.0], &[1.0, 10.0, 2.0]).range, [2.0, 4.0]);
    }

    #[test]
    fn every_round_begins_with_another_side() {
        let order = std::cell::RefCell::new(String::new());
        let side = |name: char| -> Side<'_, ()> {
            let order = &order;
            Box::new(move || {
                order.borrow_mut().push(name);
                Ok(1.0)
            })
        };
        let times = take_turns(3, true, &mut [side('a'), side('b')]);
        assert_eq!(times, Ok(vec![vec![1.0; 3]; 2]));
        assert_eq!(order.into_inner(), "ababbaab");
    }
}
