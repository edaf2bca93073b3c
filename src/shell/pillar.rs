//! Straight, bent and pinched pillars, by exact integer arithmetic.

use super::Shell;
use dashu_int::IBig;

/// How many vertices have a pillar of each kind; the three add up to the number of vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct PillarCounts {
    /// `m` lies exactly on the segment `b t`, which is not a single point with it.
    pub straight: usize,
    /// `m` lies off the segment `b t`.
    pub bent: usize,
    /// `b = m = t`.
    pub pinched: usize,
}

impl Shell {
    /// Whether `m` lies exactly on the segment `b t` (so that a pinched pillar is straight);
    /// `false` where the shell has no such vertex or a coordinate is not finite.
    #[must_use]
    pub fn is_straight(&self, vertex: u32) -> bool {
        let v = vertex as usize;
        match (self.bottom.get(v), self.middle.get(v), self.top.get(v)) {
            (Some(b), Some(m), Some(t)) => on_segment(m, b, t),
            _ => false,
        }
    }

    /// Counts the kinds of pillars. Exact; linear, one small determinant a vertex.
    #[must_use]
    pub fn pillar_counts(&self) -> PillarCounts {
        let mut counts = PillarCounts::default();
        for v in 0..u32::try_from(self.vertex_count()).unwrap_or(u32::MAX) {
            if self.is_pinched(v) {
                counts.pinched += 1;
            } else if self.is_straight(v) {
                counts.straight += 1;
            } else {
                counts.bent += 1;
            }
        }
        counts
    }
}

/// Whether `p` lies on the closed segment `a b`: on its line, and between the ends on every axis.
fn on_segment(p: &[f64; 3], a: &[f64; 3], b: &[f64; 3]) -> bool {
    // Comparing doubles is exact; the bounds also exclude NaN.
    let between = (0..3).all(|k| a[k].min(b[k]) <= p[k] && p[k] <= a[k].max(b[k]));
    if !between || !a.iter().chain(b).all(|x| x.is_finite()) {
        return false;
    }
    let [p, a, b] = scaled([p, a, b]);
    let u: [IBig; 3] = std::array::from_fn(|k| &p[k] - &a[k]);
    let v: [IBig; 3] = std::array::from_fn(|k| &b[k] - &a[k]);
    [(1, 2), (2, 0), (0, 1)].iter().all(|&(i, j)| &u[i] * &v[j] == &u[j] * &v[i])
}

/// The points' coordinates times one common power of two that makes all of them integers.
fn scaled<const N: usize>(points: [&[f64; 3]; N]) -> [[IBig; 3]; N] {
    let parts = points.map(|p| p.map(decode));
    let lowest = parts.iter().flatten().map(|&(_, exponent)| exponent).min().unwrap_or(0);
    parts.map(|p| p.map(|(mantissa, exponent)| IBig::from(mantissa) << (exponent.abs_diff(lowest) as usize)))
}

/// A finite double as `mantissa * 2^exponent`.
fn decode(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let fraction = (bits & ((1 << 52) - 1)).cast_signed();
    let biased = i32::try_from((bits >> 52) & 0x7ff).unwrap_or(0);
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | (1 << 52), biased - 1075) };
    (if x.is_sign_negative() { -mantissa } else { mantissa }, exponent)
}
