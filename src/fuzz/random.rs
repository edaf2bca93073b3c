/// A small generator (splitmix64), so that a run is told by its seed.
#[derive(Clone, Debug)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Less than `n`, or 0 for `n = 0`.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        let n = n.max(1) as u64;
        // Fits: it is below a usize.
        (self.next() % n) as usize
    }

    /// Uniform in `low..=high`.
    pub(crate) fn integer(&mut self, low: i32, high: i32) -> i32 {
        // Fits: it is below the number of integers between.
        low.wrapping_add_unsigned((self.next() % (u64::from(high.abs_diff(low)) + 1)) as u32)
    }

    /// In `[-1, 1)`, 53 bits.
    pub(crate) fn real(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
