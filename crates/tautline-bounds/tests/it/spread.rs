//! Lemma S.5: moments of speeds, given their mean and mean square.

use std::num::NonZeroUsize;

use tautline_bounds::{Constants, PaperRule, Setting, Spread};

/// Speeds with known moments obey the bounds that are drawn from their mean and mean square alone:
/// equal ones but for one, which attain them, and others.
#[test]
fn no_speeds_have_larger_moments_than_their_spread_allows() {
    // Steele, Lea and Flood's SplitMix64.
    let mut state = 5_u64;
    let mut draw = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    };
    for case in 0..4000 {
        let count = 1 + (draw() * 60.0) as usize;
        // The last alone, or with others that are slower the higher the power.
        let power = if case % 4 == 0 { 60.0 } else { 8.0 * draw() };
        let mut u: Vec<f64> = (0..count).map(|_| draw().powf(power)).collect();
        u[0] = if case % 2 == 0 { 1.0 } else { u[0] };
        let mean = |power: i32| u.iter().map(|u| u.powi(power)).sum::<f64>() / count as f64;
        let surplus = draw() * draw();
        // Scaled to the mean square 1 + surplus.
        let scale = ((1.0 + surplus) / mean(2)).sqrt();
        let [m1, m2, m3, m4] = [1, 2, 3, 4].map(|p| scale.powi(p) * mean(p));
        // A setting whose x is no less than 1 − m₁: δ = L_H for c₁ = d = 1.
        let missing = (1.0 - m1).max(0.0) * (1.0 + 1e-12);
        for (rule, k) in PaperRule::BOTH.into_iter().zip([0.25, 0.5]) {
            for wider in [1.0, 1.5, 40.0] {
                let delta = wider * missing * 2.0 * count as f64 / (k * (1.0 + surplus));
                let constants = Constants::new(1.0, 1e9, delta).expect("in order");
                let setting = Setting::new(constants, 1.0, 2).expect("a distance");
                let n = NonZeroUsize::new(count).expect("positive");
                let spread = Spread::of_first_order(setting, rule, n, surplus);
                // Sums of 60 numbers, of which the variance is a difference.
                let grant = 1.0 + 1e-12;
                let greatest = u.iter().map(|u| (scale * u - m1).abs()).fold(0.0, f64::max);
                assert!(m2 - m1 * m1 <= spread.variance + 1e-13 * m2, "{case}: {spread:?}");
                let square = spread.deviation.powi(2) + 1e-11 * m2;
                assert!(greatest.powi(2) <= square, "{case}: {greatest} {spread:?}");
                assert!(m3 <= spread.cube * grant, "{case}: {m3} {spread:?}");
                assert!(m4 <= spread.fourth * grant, "{case}: {m4} {spread:?}");
                // One alone of N has the moments √N ε^{3/2} and N ε², beyond which none goes.
                let (e, n) = (1.0 + surplus, count as f64);
                assert!(spread.cube <= n.sqrt() * e.powf(1.5) * grant, "{case}: {spread:?}");
                assert!(spread.fourth <= n * e * e * grant, "{case}: {spread:?}");
            }
        }
    }
}
