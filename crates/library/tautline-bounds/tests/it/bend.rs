//! Lemma S.1 on metrics with known geodesics.

use tautline_bounds::{Constants, Setting};

/// `φ = 1 + x` on `[0, ∞)` has `c₁ = L_H = 1` and `M_H = 0`. A geodesic at 0 has
/// `|φ′|/2φ^{3/2} = ½` per unit of length. On all of space `M_H = 0` would make the metric constant
/// and `G = 0`; on a region the bound must not conclude this.
#[test]
fn on_a_region_an_incline_without_curvature_still_bends_geodesics() {
    let incline = Constants::new(1.0, 2.0, 1.0).and_then(|c| c.with_m_h(0.0)).expect("in order");
    for dimension in [1, 2, 3, 7] {
        for constants in [incline, incline.isotropic()] {
            for m_h in [0.0, 1e-3, 1.0, 1e3] {
                let constants = constants.with_m_h(m_h).expect("nonnegative").on_a_region();
                let setting = Setting::new(constants, 0.25, dimension).expect("a distance");
                assert!(setting.bend() >= 0.5 * 0.25, "{setting:?}");
                assert!(!setting.bend_needs_m_h(), "{setting:?}");
            }
        }
    }
}

/// `φ = (2 − cos x)²` has `c₁ = 1`, `M_H = 6` and `|φ′|/2φ^{3/2} = sin x/(2 − cos x)²`. The bound
/// is `(2 · 6/27)^{1/2} = ⅔`; without `M_H` it would be `L_H/2 = 2.2`.
#[test]
fn the_bend_over_the_valleys_is_within_the_bound() {
    let constants = Constants::new(1.0, 9.0, 4.403_669_475_041_612).and_then(|c| c.with_m_h(6.0));
    let constants = constants.expect("in order").isotropic();
    let bend = |x: f64| x.sin() / (2.0 - x.cos()).powi(2);
    let most = (0..3142).map(|k| bend(f64::from(k) * 1e-3)).fold(0.0, f64::max);
    for dimension in [1, 2, 5] {
        let setting = Setting::new(constants, 1.0, dimension).expect("a distance");
        assert!(most <= setting.bend() && setting.bend() < 2.0 * most, "{most} {setting:?}");
    }
}
