//! `SplitMix`: reproducible random numbers.

/// The generator SplitMix64 (Steele, Lea, Flood 2014), which mixes the bits of a counter.
///
/// It uses integers only, so that a search samples the same cases on every machine.
#[derive(Clone, Copy, Debug)]
pub struct SplitMix {
    state: u64,
}

impl SplitMix {
    /// Starts the sequence that belongs to a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// Returns 64 random bits, for example the seed of another sequence.
    pub fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.state;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Returns a number in `[0, 1)` with 53 random bits.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2_f64.powi(-53)
    }

    /// Returns a number between `low` and `high`: `low + (high − low) u`, rounded, where `u` is the
    /// next [`unit`](SplitMix::unit).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Returns an integer from `0, …, count − 1`, or 0 for `count = 0`. All are equally likely to
    /// within `count / 2⁵³`.
    pub fn below(&mut self, count: usize) -> usize {
        // The product is less than `count` unless it is rounded up to it.
        ((self.unit() * count as f64) as usize).min(count.saturating_sub(1))
    }
}

#[cfg(test)]
mod tests {
    use super::SplitMix;

    /// The first output of the reference implementation for the seed 1234567 is
    /// 6457827717110365317.
    #[test]
    fn numbers_agree_with_the_reference_implementation() {
        let expected = 6_457_827_717_110_365_317_u64;
        assert_eq!(SplitMix::new(1_234_567).bits(), expected);
        let unit = (expected >> 11) as f64 * 2_f64.powi(-53);
        assert_eq!(SplitMix::new(1_234_567).unit(), unit);
    }

    /// In 100 draws from 8 values, each value is missed with probability `(7/8)¹⁰⁰ = 2 · 10⁻⁶`.
    #[test]
    fn all_integers_below_a_count_are_drawn_and_no_others() {
        let mut random = SplitMix::new(6);
        let mut met = [false; 8];
        (0..100).for_each(|_| met[random.below(8)] = true);
        assert_eq!(met, [true; 8]);
        assert_eq!((random.below(1), random.below(0)), (0, 0));
    }

    #[test]
    fn numbers_stay_between_their_bounds() {
        let mut random = SplitMix::new(6);
        let numbers: Vec<f64> = (0..100).map(|_| random.between(-3.0, 5.0)).collect();
        assert!(numbers.iter().all(|x| (-3.0..=5.0).contains(x)));
        // Each half of the range is missed with probability 2⁻¹⁰⁰.
        assert!(numbers.iter().any(|&x| x < 1.0) && numbers.iter().any(|&x| x > 1.0));
    }
}
