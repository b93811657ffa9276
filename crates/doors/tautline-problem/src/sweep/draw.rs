//! Random numbers that are computed from their place, so that each block draws its own.

/// Returns a number in `[0, 1)` that depends on the seed, the axis and the id alone: the output of
/// SplitMix64 (Steele, Lea and Flood, 2014), applied to each of them in turn.
pub(crate) fn unit(seed: u64, axis: u64, id: u64) -> f64 {
    let bits = mixed(mixed(mixed(seed) ^ axis) ^ id);
    (bits >> 11) as f64 / (1_u64 << 53) as f64
}

fn mixed(z: u64) -> u64 {
    let z = z.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::{mixed, unit};

    /// The first number of Vigna's reference implementation for the seed 1234567.
    #[test]
    fn the_bits_are_those_of_the_reference_implementation() {
        assert_eq!(mixed(1_234_567), 6_457_827_717_110_365_317);
    }

    /// The mean of 40,000 uniform numbers has the standard deviation 1/√(12·40,000) < 0.0015, and so
    /// has a correlation of two such lists about 1/√40,000 = 0.005: five deviations are allowed.
    #[test]
    fn draws_are_uniform_and_those_of_axes_and_seeds_are_unrelated() {
        let lists = [(7, 0), (7, 1), (8, 0)]
            .map(|(seed, axis)| (0..40_000).map(|id| unit(seed, axis, id)).collect::<Vec<f64>>());
        for list in &lists {
            let mean = list.iter().sum::<f64>() / 40_000.0;
            assert!((mean - 0.5).abs() < 5.0 * 0.0015, "{mean}");
            assert!(list.iter().all(|u| (0.0..1.0).contains(u)));
        }
        for (a, b) in [(0, 1), (0, 2), (1, 2)] {
            let products = lists[a].iter().zip(&lists[b]).map(|(u, v)| (u - 0.5) * (v - 0.5));
            let correlation = 12.0 * products.sum::<f64>() / 40_000.0;
            assert!(correlation.abs() < 5.0 * 0.005, "{correlation}");
        }
    }
}
