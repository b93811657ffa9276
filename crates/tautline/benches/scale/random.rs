//! `SplitMix`: random numbers that are the same on every machine.

/// The generator SplitMix64 (Steele, Lea, Flood 2014): a counter, mixed.
pub(crate) struct SplitMix(u64);

impl SplitMix {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number from `[−1, 1)`.
    pub(crate) fn symmetric(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        // The upper 53 bits, all of which fit.
        ((z ^ (z >> 31)) >> 11) as f64 * 0.5_f64.powi(52) - 1.0
    }
}
