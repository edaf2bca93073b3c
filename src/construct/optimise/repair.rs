//! Moves that make room for the partner mesh.

use super::invariants::Judge;
use super::limits::{Limits, distance};
use super::prism::{Pillar, Prism};
use super::smooth::{direction, with_lengths};
use super::state::{Change, State};
use crate::construct::direction::{most_normal, unit};

/// Tries pillars for `v` that lower the partner's violation.
pub(crate) fn repair(state: &mut State, judge: &Judge<'_>, limits: &Limits, v: u32) -> bool {
    let Some(partner) = judge.partner.as_deref() else { return false };
    let star: Vec<Prism> =
        state.star[v as usize].iter().map(|&f| state.prism(state.faces[f as usize], None)).collect();
    let before = partner.violation(&star);
    if before <= 0.0 {
        return false;
    }
    let old = state.pillars[v as usize];
    let d0 = direction(&old);
    let mut directions = vec![d0];
    let (a, b) = (judge.normals_near(&star), partner.normals_near(&star));
    let both: Vec<[f64; 3]> = a.iter().chain(&b).copied().collect();
    for set in [&both, &b] {
        if let Some(d) = most_normal(set) {
            directions.push(d);
            directions.push(unit(std::array::from_fn(|i| d[i] + d0[i])));
        }
    }
    let around: Vec<[f64; 3]> = state.neighbours(v).iter().map(|&w| direction(&state.pillars[w as usize])).collect();
    directions.push(unit(around.iter().fold(d0, |s, d| std::array::from_fn(|i| s[i] + d[i]))));
    let (down, up) = (distance(&old.bottom, &old.middle), distance(&old.top, &old.middle));
    let shares = [1.0, 1.3, 2.0, 3.0, 0.7, 0.4];
    let mut options: Vec<(f64, Pillar)> = Vec::new();
    let mut shifts = vec![[0.0; 3]];
    let near = state.neighbours(v);
    for &w in &near {
        let q = state.pillars[w as usize].middle;
        for s in [0.1, 0.3] {
            shifts.push(std::array::from_fn(|i| s * (q[i] - old.middle[i])));
        }
    }
    for (k, shift) in shifts.iter().enumerate() {
        for d in &directions {
            for &s in &shares {
                for &r in &shares {
                    if k > 0 && (s != 1.0 || r != 1.0) {
                        continue;
                    }
                    let m: [f64; 3] = std::array::from_fn(|i| old.middle[i] + shift[i]);
                    let (lo, hi) = ((down * s).min(limits.thickness), (up * r).min(limits.thickness));
                    let middle = if k == 0 {
                        m
                    } else {
                        let p = with_lengths(&m, d, lo, hi);
                        super::cast::middle(judge, &p.bottom, &p.top, lo / (lo + hi))
                    };
                    let pillar = with_lengths(&middle, d, lo, hi);
                    if !pillar.is_finite() {
                        continue;
                    }
                    let change = Change { moved: Some((v, pillar)), ..Change::default() };
                    let after = state.prisms(&change);
                    if !after.iter().all(Prism::is_positive) {
                        continue;
                    }
                    let there = partner.violation(&after);
                    if there < before {
                        options.push((there, pillar));
                    }
                }
            }
        }
    }
    options.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, pillar) in options {
        let change = Change { moved: Some((v, pillar)), ..Change::default() };
        if judge.admits(state, &change) {
            state.apply(&change);
            return true;
        }
    }
    false
}
