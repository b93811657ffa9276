//! Lemma S.5: the moments of given speeds against the bounds from their mean and mean square.

use std::num::NonZeroUsize;

use tautline_bounds::{Constants, PaperRule, Setting, Spread};
use tautline_chance::{Random, cases, seed};

/// The cases include speeds of which all but one are equal; they attain the bounds.
#[test]
fn moments_of_speeds_are_within_their_spread() {
    let mut random = Random(seed(5));
    let mut draw = || random.unit();
    for case in 0..cases(4000) {
        let count = 1 + (draw() * 60.0) as usize;
        // The higher the power, the slower all speeds but the first become.
        let power = if case % 4 == 0 { 60.0 } else { 8.0 * draw() };
        let mut u: Vec<f64> = (0..count).map(|_| draw().powf(power)).collect();
        u[0] = if case % 2 == 0 { 1.0 } else { u[0] };
        let mean = |power: i32| u.iter().map(|u| u.powi(power)).sum::<f64>() / count as f64;
        let surplus = draw() * draw();
        // The speeds are scaled to the mean square 1 + surplus.
        let scale = ((1.0 + surplus) / mean(2)).sqrt();
        let [m1, m2, m3, m4] = [1, 2, 3, 4].map(|p| scale.powi(p) * mean(p));
        // The setting is chosen with x ≥ 1 − m₁; δ = L_H for c₁ = d = 1.
        let missing = (1.0 - m1).max(0.0) * (1.0 + 1e-12);
        for (rule, k) in PaperRule::BOTH.into_iter().zip([0.25, 0.5]) {
            for wider in [1.0, 1.5, 40.0] {
                let delta = wider * missing * 2.0 * count as f64 / (k * (1.0 + surplus));
                let constants = Constants::new(1.0, 1e9, delta).expect("in order");
                let setting = Setting::new(constants, 1.0, 2).expect("a distance");
                let n = NonZeroUsize::new(count).expect("positive");
                let spread = Spread::of_first_order(setting, rule, n, surplus);
                // This allows for the rounding of sums of 60 numbers and of a variance computed as
                // a difference.
                let grant = 1.0 + 1e-12;
                let greatest = u.iter().map(|u| (scale * u - m1).abs()).fold(0.0, f64::max);
                assert!(m2 - m1 * m1 <= spread.variance + 1e-13 * m2, "{case}: {spread:?}");
                let square = spread.deviation.powi(2) + 1e-11 * m2;
                assert!(greatest.powi(2) <= square, "{case}: {greatest} {spread:?}");
                assert!(m3 <= spread.cube * grant, "{case}: {m3} {spread:?}");
                assert!(m4 <= spread.fourth * grant, "{case}: {m4} {spread:?}");
                // A single nonzero speed has the greatest moments, √N ε^{3/2} and N ε².
                let (e, n) = (1.0 + surplus, count as f64);
                assert!(spread.cube <= n.sqrt() * e.powf(1.5) * grant, "{case}: {spread:?}");
                assert!(spread.fourth <= n * e * e * grant, "{case}: {spread:?}");
            }
        }
    }
}
