//! From the user's coordinates to those of the view: a box of half-size one around the origin.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

/// Where the box is, and how large.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Frame {
    pub(super) centre: [f64; 3],
    pub(super) half: f64,
}

impl Frame {
    /// The box of all points. No sum of two coordinates is formed: they may be as large as doubles are.
    pub(super) fn new<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in points.filter(|p| p.iter().all(|x| x.is_finite())) {
            for i in 0..3 {
                low[i] = low[i].min(p[i]);
                high[i] = high[i].max(p[i]);
            }
        }
        if low[0] > high[0] {
            return Self { centre: [0.0; 3], half: 1.0 };
        }
        let half = (0..3).map(|i| high[i] / 2.0 - low[i] / 2.0).fold(0.0, f64::max);
        let centre = std::array::from_fn(|i| low[i] / 2.0 + high[i] / 2.0);
        Self { centre, half: if half > 0.0 { half } else { 1.0 } }
    }

    /// A point in the view. The quotient is near one, also where its inverse would overflow.
    #[expect(clippy::cast_possible_truncation, reason = "rounding for the view")]
    pub(super) fn view(&self, p: &[f64; 3]) -> [f32; 3] {
        std::array::from_fn(|i| {
            let x = (p[i] - self.centre[i]) / self.half;
            if x.is_finite() { x as f32 } else { 0.0 }
        })
    }

    /// Points as an array of floats in base64.
    pub(super) fn pack<'a>(&self, points: impl Iterator<Item = &'a [f64; 3]>) -> String {
        floats(points.map(|p| self.view(p)))
    }
}

/// Little-endian floats in base64.
pub(super) fn floats(points: impl Iterator<Item = [f32; 3]>) -> String {
    bytes(&points.flatten().flat_map(f32::to_le_bytes).collect::<Vec<u8>>())
}

/// Little-endian integers in base64.
pub(super) fn integers(values: impl Iterator<Item = u32>) -> String {
    bytes(&values.flat_map(u32::to_le_bytes).collect::<Vec<u8>>())
}

/// Bytes in base64.
pub(super) fn bytes(values: &[u8]) -> String {
    STANDARD.encode(values)
}
