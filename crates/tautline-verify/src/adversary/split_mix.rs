//! `SplitMix`: random numbers that are the same on every machine.

/// The generator SplitMix64 (Steele, Lea, Flood 2014): a counter, mixed.
///
/// Integers only, so that a search samples the same cases everywhere and for ever.
#[derive(Clone, Copy, Debug)]
pub(super) struct SplitMix {
    state: u64,
}

impl SplitMix {
    pub(super) fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Returns a number of `[0, 1)` with 53 random bits.
    pub(super) fn unit(&mut self) -> f64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^= mixed >> 31;
        (mixed >> 11) as f64 * 2_f64.powi(-53)
    }
}

#[cfg(test)]
mod tests {
    use super::SplitMix;

    /// The first output of the reference implementation for the seed 1234567 is
    /// 6457827717110365317.
    #[test]
    fn numbers_are_those_of_the_reference_implementation() {
        let expected = (6_457_827_717_110_365_317_u64 >> 11) as f64 * 2_f64.powi(-53);
        assert_eq!(SplitMix::new(1_234_567).unit(), expected);
    }
}
