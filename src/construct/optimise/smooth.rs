//! Vertex smoothing: pan, zoom and rotate (*Shell* section 3.4). A full step first; halved only for the sake of C1.

use super::cast;
use super::energy::{gradient, mips};
use super::invariants::{Judge, Near, Suspect};
use super::limits::{Limits, distance, minus};
use super::prism::{Pillar, Prism, direction, with_lengths};
use super::state::{Change, State};
use crate::construct::direction::{float_dot, unit};

/// How often a step is halved.
const HALVINGS: usize = 5;

/// The pan, then the zoom, then the rotation of a vertex, as far as each is admitted: one change, and how many of the
/// three it holds.
pub(crate) fn propose(state: &State, judge: &Judge<'_>, limits: &Limits, v: u32) -> Option<(Change, u64)> {
    if state.star[v as usize].is_empty() || state.is_frozen(v) {
        return None;
    }
    let mut vertex = Vertex::new(state, judge, v);
    let moves = [vertex.pan(), vertex.zoom(limits), vertex.rotate()];
    let made = moves.iter().filter(|m| **m).count() as u64;
    (made > 0).then(|| (vertex.change(), made))
}

/// A vertex that is neither frozen nor without faces, and its pillar, which moves while the state stays.
pub(crate) struct Vertex<'a> {
    state: &'a State,
    judge: &'a Judge<'a>,
    v: u32,
    pillar: Pillar,
    tracked: Option<Vec<u32>>,
    suspect: Suspect,
}

impl<'a> Vertex<'a> {
    pub(crate) fn new(state: &'a State, judge: &'a Judge<'a>, v: u32) -> Self {
        let (pillar, tracked) = (state.pillars[v as usize], state.candidates_around(v));
        Self { state, judge, v, pillar, tracked, suspect: Suspect::default() }
    }

    /// What was done to the pillar.
    pub(crate) fn change(&self) -> Change {
        Change { moved: Some((self.v, self.pillar)), ..Change::default() }
    }

    /// The prisms around the vertex with a pillar.
    fn prisms(&self, pillar: Pillar) -> Vec<Prism> {
        let star = self.state.star[self.v as usize].iter();
        star.map(|&f| self.state.prism(self.state.faces[f as usize], Some(&(self.v, pillar)))).collect()
    }

    /// Does the skin, if one is kept, stay free of self-intersection with the pillar?
    fn fits_skin(&self, pillar: Pillar) -> bool {
        let change = Change { moved: Some((self.v, pillar)), ..Change::default() };
        self.state.skin.as_ref().is_none_or(|skin| skin.admits(self.state, &change))
    }

    /// Takes another pillar, if some share of the step, found by halving, keeps C1 and `better`, and the invariants
    /// about the mesh hold there.
    fn attempt(&mut self, step: impl Fn(f64) -> Pillar, better: impl Fn(&[Prism]) -> bool) -> bool {
        let mut share = 1.0;
        for _ in 0..=HALVINGS {
            let pillar = step(share);
            let prisms = self.prisms(pillar);
            let near = Near { tracked: self.tracked.as_deref(), suspect: &self.suspect };
            if pillar.is_finite()
                && better(&prisms)
                && self.judge.prefers(&prisms, near, || self.prisms(self.pillar))
                && self.fits_skin(pillar)
            {
                self.pillar = pillar;
                return true;
            }
            share *= 0.5;
        }
        false
    }

    /// Moves bottom and top together, across the pillar, to lower the energy of the middle triangles.
    pub(crate) fn pan(&mut self) -> bool {
        let (old, judge) = (self.pillar, self.judge);
        let Some(to) = self.lower(&direction(&old)) else { return false };
        let energy = total(&self.prisms(old));
        let shift = minus(&to, &old.middle);
        let (along, down, up) =
            (direction(&old), distance(&old.bottom, &old.middle), distance(&old.top, &old.middle));
        let step = |share: f64| {
            let moved = |p: &[f64; 3]| -> [f64; 3] { std::array::from_fn(|i| p[i] + share * shift[i]) };
            let (bottom, top) = (moved(&old.bottom), moved(&old.top));
            let guess = cast::share(&bottom, &top, &moved(&old.middle));
            let middle = cast::middle(judge, &bottom, &top, guess);
            with_lengths(&middle, &along, down, up)
        };
        self.attempt(step, |prisms| total(prisms) < energy * (1.0 - 1e-4))
    }

    /// A place for the middle, in the plane across a direction, with lower energy: some steps of descent.
    fn lower(&self, across: &[f64; 3]) -> Option<[f64; 3]> {
        let (state, at) = (self.state, self.pillar.middle);
        let mut sides: Vec<[[f64; 3]; 2]> = Vec::with_capacity(8);
        for &f in &state.star[self.v as usize] {
            let face = state.faces[f as usize];
            let i = face.iter().position(|&w| w == self.v)?;
            sides.push([1, 2].map(|k| state.pillars[face[(i + k) % 3] as usize].middle));
        }
        let energy = |p: &[f64; 3]| sides.iter().map(|[q, r]| mips([p, q, r])).sum::<f64>();
        let size = sides.iter().map(|[q, _]| distance(q, &at)).sum::<f64>() / sides.len() as f64;
        let (mut best, mut least, mut step) = (at, energy(&at), 0.25 * size);
        for _ in 0..6 {
            let mut slope = [0.0; 3];
            for [q, r] in &sides {
                let g = gradient([&best, q, r]);
                for i in 0..3 {
                    slope[i] += g[i];
                }
            }
            let along = float_dot(&slope, across);
            let down = unit(std::array::from_fn(|i| along * across[i] - slope[i]));
            for _ in 0..4 {
                let next: [f64; 3] = std::array::from_fn(|i| best[i] + step * down[i]);
                let there = energy(&next);
                if there < least {
                    (best, least) = (next, there);
                    break;
                }
                step *= 0.5;
            }
        }
        (distance(&best, &at) > 1e-3 * size).then_some(best)
    }

    /// The pillars of the neighbours that are not pinched.
    fn around(&self) -> Vec<Pillar> {
        let state = self.state;
        let near = state.neighbours(self.v).into_iter().filter(|&w| !state.pinched[w as usize]);
        near.map(|w| state.pillars[w as usize]).collect()
    }

    /// Turns the pillar about its middle, towards the mean direction of the neighbours.
    pub(crate) fn rotate(&mut self) -> bool {
        let old = self.pillar;
        let mut sum = [0.0; 3];
        for d in self.around().iter().map(direction) {
            for i in 0..3 {
                sum[i] += d[i];
            }
        }
        let (from, to) = (direction(&old), unit(sum));
        if float_dot(&from, &to) > 1.0 - 1e-6 {
            return false;
        }
        let (down, up) = (distance(&old.bottom, &old.middle), distance(&old.top, &old.middle));
        let step = |share: f64| {
            let d = unit(std::array::from_fn(|i| from[i] + share * (to[i] - from[i])));
            with_lengths(&old.middle, &d, down, up)
        };
        self.attempt(step, |_| true)
    }

    /// Lengthens the halves to one and a half times the mean of the neighbours', capped: both, or one alone.
    pub(crate) fn zoom(&mut self, limits: &Limits) -> bool {
        let old = self.pillar;
        let near = self.around();
        let lengths: [fn(&Pillar) -> f64; 2] =
            [|p| distance(&p.bottom, &p.middle), |p| distance(&p.top, &p.middle)];
        let from = lengths.map(|l| l(&old));
        let goal = lengths
            .map(|l| (1.5 * near.iter().map(l).sum::<f64>() / near.len() as f64).min(limits.thickness));
        let grows = [0, 1].map(|k| goal[k] > 1.001 * from[k]);
        let d = direction(&old);
        for which in [[true, true], [true, false], [false, true]] {
            if (0..2).any(|k| which[k] && !grows[k]) {
                continue;
            }
            // Halved in its logarithm: thin pillars grow little by little, too.
            let length = |k: usize, share: f64| from[k] * root(goal[k] / from[k], share);
            let step = |share: f64| {
                let [down, up] = [0, 1].map(|k| if which[k] { length(k, share) } else { from[k] });
                with_lengths(&old.middle, &d, down, up)
            };
            if self.attempt(step, |_| true) {
                return true;
            }
        }
        false
    }
}

/// `factor` to the power of `share`, 1 over a power of two: by roots, which are the same on every machine.
fn root(factor: f64, share: f64) -> f64 {
    let (mut out, mut power) = (factor, 1.0);
    while power > share {
        out = out.sqrt();
        power *= 0.5;
    }
    out
}

fn total(prisms: &[Prism]) -> f64 {
    prisms.iter().map(|p| mips(p.middle())).sum()
}
