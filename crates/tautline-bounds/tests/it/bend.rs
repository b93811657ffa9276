//! Lemma S.1: what its bound of the bend may use, on metrics whose geodesics are known.

use tautline_bounds::{Constants, Setting};

/// `φ = 1 + x` on `[0, ∞)`: with `c₁ = L_H = 1` and `M_H = 0` there, a geodesic at 0 bends by
/// `|φ′|/2φ^{3/2} = ½` for every unit of length, though no constant metric would. Constants on a
/// region know nothing of where `φ` would have to become negative beyond it.
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

/// Along `φ = (2 − cos x)²` with its constants `1`, `L_H` and `6` geodesics of the line bend by
/// `|φ′|/2φ^{3/2} = sin x/(2 − cos x)²`; the bound is `(2 · 6/27)^{1/2} = ⅔`, where `L_H/2` is 2.2.
#[test]
fn the_valleys_bend_geodesics_by_no_more_than_the_bound() {
    let constants = Constants::new(1.0, 9.0, 4.403_669_475_041_612).and_then(|c| c.with_m_h(6.0));
    let constants = constants.expect("in order").isotropic();
    let bend = |x: f64| x.sin() / (2.0 - x.cos()).powi(2);
    let most = (0..3142).map(|k| bend(f64::from(k) * 1e-3)).fold(0.0, f64::max);
    for dimension in [1, 2, 5] {
        let setting = Setting::new(constants, 1.0, dimension).expect("a distance");
        assert!(most <= setting.bend() && setting.bend() < 2.0 * most, "{most} {setting:?}");
    }
}
