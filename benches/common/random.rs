//! A small generator (splitmix64), so that a run is told by its seed.

/// The generator; its value is the seed.
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// What one step adds to the value.
    pub const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(Self::STEP);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In `0..1`; 53 bits, so exact.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// In `[-1, 1)`; 53 bits.
    pub fn real(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// Less than `n`, or 0 for `n = 0`.
    pub fn below(&mut self, n: usize) -> usize {
        // Fits, as it is below a usize.
        usize::try_from(self.bits() % n.max(1) as u64).unwrap_or(0)
    }
}
