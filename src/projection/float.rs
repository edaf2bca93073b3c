//! The projection in floating point, located exactly and with a proved error bound for each answer.

use super::exact::{Rat, rational};
use super::rounded::Rounded;
use super::{PointError, Projection, ShellPoint};
use crate::predicate::Sign;

/// An image under `P`, rounded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloatPoint {
    /// The prism: always the one of the exact answer.
    pub prism: u32,
    /// The weights on its corners; 0 wherever the exact weight is 0. The sum is near 1.
    pub weights: [f64; 3],
    /// The height.
    pub height: f64,
    /// Each of the four numbers differs from the exact one by at most this; never above
    /// [`MAX_ERROR`].
    pub error: f64,
}

/// Answers whose bound is larger are computed exactly and rounded.
pub const MAX_ERROR: f64 = 1e-10;

impl Projection<'_> {
    /// [`project`](Self::project) in floating point, for a point with `f64` coordinates; `None`
    /// outside of the shell and where a coordinate is not finite.
    ///
    /// The tet is found by exact predicates, so whether there is an image, and its prism, are
    /// never wrong. The barycentric coordinates are then quotients of
    /// determinants of rounded differences: their error grows with the tet's distortion (about
    /// 1e-15 times the sum of the absolute products in the determinants, divided by the volume) and
    /// is bounded in [`FloatPoint::error`]. Where that bound exceeds [`MAX_ERROR`] (flat tets,
    /// overflow, underflow) the exact image is rounded instead.
    #[must_use]
    pub fn project_f64(&self, p: &[f64; 3]) -> Option<FloatPoint> {
        self.first_holder(p).map(|found| self.float_at(found, p))
    }

    /// The image of a point of a tet: its canonical prism, the tet, the signs of its coordinates.
    pub(super) fn float_at(&self, (prism, tet, signs): (u32, u32, [Sign; 4]), p: &[f64; 3]) -> FloatPoint {
        let names = self.tets()[tet as usize].names;
        let Some(Coordinates { mut values, error }) = coordinates(self.points(&self.tets()[tet as usize]), p)
        else {
            return rounded(&self.image_on(prism, tet, p).to_point());
        };
        for (value, sign) in values.iter_mut().zip(signs) {
            *value = if sign.is_zero() { 0.0 } else { value.clamp(0.0, 1.0) };
        }
        let corners = self.shell.faces[prism as usize];
        let (mut weights, mut height) = ([0.0; 3], 0.0);
        for (name, value) in names.iter().zip(values) {
            for (weight, corner) in weights.iter_mut().zip(corners) {
                *weight += if name.vertex == corner { value } else { 0.0 };
            }
            height += f64::from(name.layer.height()) * value;
        }
        FloatPoint { prism, weights, height, error }
    }

    /// [`unproject`](Self::unproject) for rounded coordinates: the weights are divided by their sum
    /// and a height slightly out of range is moved to the end of its fibre; the rest is exact, and
    /// the result rounded once to the nearest doubles.
    ///
    /// # Errors
    /// [`PointError`]: no such prism; a weight or the height is not finite, a weight is negative,
    /// their sum is zero.
    pub fn unproject_f64(&self, prism: u32, weights: [f64; 3], height: f64) -> Result<[f64; 3], PointError> {
        let exact = weights.map(|w| if w.is_finite() { rational(w) } else { -Rat::ONE });
        let sum = exact.iter().fold(Rat::ZERO, |s, w| s + w);
        if sum <= Rat::ZERO || !height.is_finite() {
            return Err(PointError::Weights { prism, weights: Box::new(exact) });
        }
        let weights = exact.map(|w| w / &sum);
        let limit = self.thickness(prism, &weights)?;
        let height = rational(height).clamp(-limit.clone(), limit);
        let p = self.unproject(&ShellPoint { prism, weights, height })?;
        Ok(p.map(|x| x.to_f64().value()))
    }
}

/// Rounded to nearest: the numbers are at most 1, so the error is at most `2^-53`.
fn rounded(q: &ShellPoint) -> FloatPoint {
    let round = |x: &Rat| x.to_f64().value();
    FloatPoint {
        prism: q.prism,
        weights: q.weights.each_ref().map(round),
        height: round(&q.height),
        error: 2e-16,
    }
}

/// Barycentric coordinates, and a bound for the error of each sum of some of them with signs.
struct Coordinates {
    values: [f64; 4],
    error: f64,
}

/// The coordinates of a point of a positive tet; `None` if the bound is not good enough.
///
/// # The bound
///
/// Let `u = 2^-53` and `n_k` the exact determinants, `N_k` the computed ones. By the proof at
/// `predicate::determinant::filter3` (see [`Rounded`])
/// `|n_k - N_k| <= E_k = 1e-15 permanent + 1e-300 L + 1e-300`. The volume is `v = sum n_k`; for the
/// computed sum `V` with `A = sum |N_k|`, three additions give `|v - V| <= F = sum E_k + 4e-16 A`
/// (`4e-16 > 3.001 u`). Provided that `F <= V / 2`:
///
/// `|n_k / v - N_k / V| = |(n_k - N_k) V + N_k (V - v)| / (v V) <= (E_k + |N_k| F / V) / (V - F)`,
///
/// summed over `k`: `(sum E_k + (A / V) F) / (V - F)`. The divisions add at most `u` each (a
/// coordinate is at most 1 after clamping, which brings it no farther from the exact one, and the
/// same holds for 0 put where the sign is known to be zero) and `2^-1074`; adding up four of them
/// with factors -1, 0, 1 rounds three times partial sums of at most 4: `4 u + 12 u < 2e-15`.
/// The bound itself is evaluated with fewer than 40 roundings of positive terms, and one difference
/// `V - F` that is at least `V / 2`: the factor 1.001 covers them. Not a number and infinity fail
/// the comparisons.
fn coordinates(tet: [&[f64; 3]; 4], p: &[f64; 3]) -> Option<Coordinates> {
    let Rounded { values: parts, errors } = Rounded::new(tet, p);
    let volume: f64 = parts.iter().sum();
    let size: f64 = parts.iter().map(|n| n.abs()).sum();
    let errors: f64 = errors.iter().sum();
    let volume_error = errors + 4e-16 * size;
    if !(volume.is_finite() && volume_error <= volume / 2.0) {
        return None;
    }
    let bound = (errors + size / volume * volume_error) / (volume - volume_error);
    let error = 1.001 * bound + 2e-15;
    (error <= MAX_ERROR).then(|| Coordinates { values: parts.map(|n| n / volume), error })
}
