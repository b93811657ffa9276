//! `Random`: reproducible numbers for a test that draws its own cases.

/// The generator SplitMix64 (Steele, Lea and Flood, 2014), which returns the same numbers on every
/// machine.
///
/// The seed is a public field, so that `Random(seed)` starts a sequence.
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// Returns 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns a number in `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a number in `[lo, hi]`.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    /// Returns a positive number whose binary exponent is uniform in `least..=most`.
    pub fn with_exponent(&mut self, least: i32, most: i32) -> f64 {
        let e = least + (self.bits() % u64::from((most - least).unsigned_abs() + 1)) as i32;
        let m = 1.0 + self.unit();
        // The scaling takes two steps, since 2^e alone may underflow where the product does not.
        m * 2.0_f64.powi(e / 2) * 2.0_f64.powi(e - e / 2)
    }

    /// Returns `1` or `−1`.
    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// The expected values are the first numbers of Vigna's reference implementation for the seed
    /// 1234567.
    #[test]
    fn the_numbers_are_those_of_the_reference_implementation() {
        let mut random = Random(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
        ];
        assert_eq!([(); 4].map(|()| random.bits()), expected);
    }
}
