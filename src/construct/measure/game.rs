//! The best mixture against the worst case: what a small matrix game is worth. Floats: a proposal.

/// The choosers and the opponents of a mixture that is balanced between them.
type Few = ([usize; 3], usize);

/// All sets of one, two or three of `n`.
fn sets(n: usize) -> Vec<Few> {
    let mut out = Vec::new();
    for a in 0..n {
        out.push(([a; 3], 1));
        for b in a + 1..n {
            out.push(([a, b, b], 2));
            out.extend((b + 1..n).map(|c| ([a, b, c], 3)));
        }
    }
    out
}

/// Weights on the choosers, not negative and of sum 1, that make the largest of all opponents' mixed payoffs small, and
/// that payoff. `payoff(opponent, chooser)`. Mixtures of up to three choosers are compared, balanced between as many
/// opponents: where three of either are enough (there are three choosers or three opponents) the best one is among them.
pub(super) fn mix(
    choosers: usize,
    opponents: usize,
    payoff: impl Fn(usize, usize) -> f64,
) -> (Vec<f64>, f64) {
    let worst = |w: &[f64]| {
        let mixed = |o: usize| w.iter().enumerate().map(|(c, w)| w * payoff(o, c)).sum::<f64>();
        (0..opponents).map(mixed).fold(f64::NEG_INFINITY, f64::max)
    };
    let mut best = (Vec::new(), f64::INFINITY);
    for (c, size) in sets(choosers) {
        for (o, _) in sets(if size == 1 { 1 } else { opponents }).into_iter().filter(|o| o.1 == size) {
            let Some(weights) = balanced(c, o, size, &payoff) else { continue };
            let mut all = vec![0.0; choosers];
            for (k, w) in c.into_iter().zip(weights).take(size) {
                all[k] = w;
            }
            let value = worst(&all);
            if value < best.1 {
                best = (all, value);
            }
        }
    }
    best
}

/// Weights with which the opponents' payoffs are equal.
fn balanced(
    c: [usize; 3],
    o: [usize; 3],
    size: usize,
    payoff: &impl Fn(usize, usize) -> f64,
) -> Option<[f64; 3]> {
    let difference = |k: usize| c.map(|c| payoff(o[0], c) - payoff(o[k], c));
    let raw = match size {
        1 => [1.0, 0.0, 0.0],
        2 => {
            let d = difference(1);
            [d[1], -d[0], 0.0]
        }
        _ => crate::construct::direction::float_cross(&difference(1), &difference(2)),
    };
    let sum: f64 = raw.iter().sum();
    let weights = raw.map(|w| w / sum);
    weights.iter().all(|w| (0.0..=1.0).contains(w)).then_some(weights)
}
