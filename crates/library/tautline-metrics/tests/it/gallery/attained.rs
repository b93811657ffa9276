//! Constants are tight: an exact constant is attained at a point in a direction, and for a constant
//! that is only a bound, a scan measures its overestimation.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, SQRT_2};

use approx::assert_relative_eq;
use nalgebra::{matrix, vector};
use tautline_metrics::{
    Bounded,
    gallery::{
        Bump, Checkerboard, Constant, Corrugated, EggCrate, Hill, Lens, Obstacle, Ramp, Separable,
        Shear, SoftObstacles, Swirl, TwoChannels, Valleys,
    },
};

use crate::measure::{curvature, directions, high, low, scan, slope};

const WAVES: [(f64, f64); 4] = [(0.5, 1.0), (-0.3, 2.5), (0.95, 0.4), (1e-9, 3.0)];
const PROFILES: [(f64, f64); 3] = [(4.0, 0.5), (0.3, 2.0), (1.0, 1.0)];

#[test]
fn constant_has_eigenvalues_1_and_3() {
    let g = Constant::new(matrix![2.0, 1.0; 1.0, 2.0]).expect("positive definite");
    // The eigenvalues are moved apart by 32 ulps of the norm, 3, which is about 2e-14.
    assert_relative_eq!(g.constants().c1(), 1.0, max_relative = 1e-13);
    assert_relative_eq!(g.constants().c2(), 3.0, max_relative = 1e-13);
    assert!(g.constants().c1() < 1.0 && g.constants().c2() > 3.0);
    assert_eq!((g.constants().l_h(), g.constants().m_h()), (0.0, Some(0.0)));
}

#[test]
fn valleys_are_exact() {
    low(&Valleys, vector![0.0]);
    high(&Valleys, vector![PI]);
    let steepest = (0.5 * (1.0 - 3_f64.sqrt())).acos();
    slope(&Valleys, vector![steepest, 2.0], vector![-1.0, 0.0]);
    curvature(&Valleys, vector![PI, 2.0], vector![1.0, 0.0]);
}

#[test]
fn ramp_is_exact_but_for_m_h() {
    for (a, k) in WAVES {
        let g = Ramp::new(a, k).expect("|a| < 1");
        // Here tanh 20 = 1 in f64.
        low(&g, vector![-20_f64.copysign(a) / k]);
        high(&g, vector![20_f64.copysign(a) / k]);
        // This is the root of 3aτ² + 2τ − a = 0, derived from f · f″ + f′² = 0; for a = 1e-9 it is
        // a/2.
        let tau = if a == 1e-9 { 0.5 * a } else { ((1.0 + 3.0 * a * a).sqrt() - 1.0) / (3.0 * a) };
        slope(&g, vector![tau.atanh() / k], vector![1.0]);
    }
    // M_H for a = 1/2, k = 1: a scan with steps of 0.01 finds 1/1.422 of the bound.
    let g = Ramp::new(0.5, 1.0).expect("|a| < 1");
    let [_, ratio] = scan(&g, (-500..500).map(|i| (vector![f64::from(i) * 0.01], vector![1.0])));
    assert!((0.70..0.71).contains(&ratio), "{ratio}");
}

#[test]
fn shear_is_exact() {
    // S² ranges from 1e-4 to 36, including values below 1/8.
    for (a, k) in [(0.5, 1.0), (-0.01, 1.0), (0.1, 2.5), (2.0, 3.0), (1.0, 0.3)] {
        let g = Shear::new(a, k).expect("k > 0");
        let s = a.abs() * k;
        low(&g, vector![7.0, 0.0]);
        high(&g, vector![7.0, 0.0]);
        // The shear is steepest where sinh u = S cos kx₂ with e^{2u} = 1 + 2S².
        let u = 0.5 * (2.0 * s * s).ln_1p();
        slope(&g, vector![1.0, (u.sinh() / s).acos() / k], vector![0.0, 1.0]);
        curvature(&g, vector![1.0, PI / k], vector![0.0, 1.0]);
    }
}

/// The values for `a = 1/2`, `k = 1` were computed with 40 digits.
#[test]
fn shear_has_the_golden_constants() {
    let constants = Shear::new(0.5, 1.0).expect("k > 0").constants();
    assert_relative_eq!(constants.c1(), 0.609_611_796_797_792_431_272, max_relative = 1e-15);
    assert_relative_eq!(constants.c2(), 1.640_388_203_202_207_568_73, max_relative = 1e-15);
    assert_relative_eq!(constants.l_h(), 0.559_016_994_374_947_424_102, max_relative = 1e-15);
    let m_h = constants.m_h().expect("known");
    assert_relative_eq!(m_h, 0.809_016_994_374_947_424_102, max_relative = 1e-15);
}

/// The difference `1 + S²/2 − S √(1 + S²/4)` would lose all digits.
#[test]
fn a_steep_shear_has_a_positive_c1() {
    let constants = Shear::new(1e6, 1e3).expect("k > 0").constants();
    // 1/c₂ with c₂ = S² + 2 − …, S = 1e9.
    assert_relative_eq!(constants.c1(), 1e-18, max_relative = 1e-15);
}

#[test]
fn separable_is_exact() {
    for (a, k) in WAVES {
        // The other axis has the smaller parameters a/2 and k/2.
        let g = Separable::new(vector![0.5 * a, a], vector![0.5 * k, k]).expect("|a| < 1");
        let crest = FRAC_PI_2.copysign(a) / k;
        low(&g, vector![1.0, -crest]);
        high(&g, vector![1.0, crest]);
        // This is the root of 2as² + s − a = 0; for a = 1e-9 it is a.
        let s = if a == 1e-9 { a } else { ((1.0 + 8.0 * a * a).sqrt() - 1.0) / (4.0 * a) };
        slope(&g, vector![1.0, s.asin() / k], vector![0.0, 1.0]);
        curvature(&g, vector![1.0, crest], vector![0.0, 1.0]);
    }
}

#[test]
fn hill_is_exact() {
    for (h, s) in PROFILES {
        let g = Hill::new(h, s).expect("s > 0");
        low(&g, vector![1.0, 2.0]);
        high(&g, vector![0.6, 0.8] * s);
        let rho = (0.25 * (5.0 - 17_f64.sqrt())).sqrt();
        slope(&g, vector![0.0, rho] * s, vector![0.0, 1.0]);
        curvature(&g, vector![0.0, 0.0], vector![0.6, 0.8]);
    }
}

#[test]
fn lens_is_exact() {
    for (a, s) in PROFILES {
        let g = Lens::new(a, s).expect("s > 0");
        low(&g, vector![12.0, 0.0] * s);
        high(&g, vector![0.0, 0.0]);
        slope(&g, vector![0.6, 0.8] * s, vector![0.6, 0.8]);
        curvature(&g, vector![0.0, 0.0], vector![1.0, 0.0]);
    }
}

#[test]
fn bump_is_exact_but_for_l_h() {
    for (a, s) in PROFILES {
        let g = Bump::new(a, s).expect("s > 0");
        low(&g, vector![12.0, 0.0] * s);
        high(&g, vector![0.0, 0.0]);
        curvature(&g, vector![0.0, 0.0], vector![1.0, 0.0]);
        // The sum of the two maxima is at most 1.0303 times too large, over all a.
        let steps = (1..300).map(|i| vector![f64::from(i) * 0.01 * s, 0.0]);
        let [ratio, _] = scan(&g, steps.map(|x| (x, vector![1.0, 0.0])));
        assert!((0.97..1.0).contains(&ratio), "{ratio}");
    }
}

/// Obstacles that coincide attain the sum of their constants.
#[test]
fn coinciding_soft_obstacles_are_exact() {
    let centre = vector![1.0, -2.0];
    let obstacles = [2.0, 0.5].map(|height| Obstacle { centre, height, width: 0.7 });
    let g = SoftObstacles::new(obstacles.to_vec()).expect("s > 0");
    low(&g, centre + vector![12.0, 0.0]);
    high(&g, centre);
    slope(&g, centre + vector![0.0, 0.7], vector![0.0, 1.0]);
    curvature(&g, centre, vector![1.0, 0.0]);
}

#[test]
fn swirl_is_exact_but_for_l_h_and_m_h() {
    for (angle, s) in
        [(0.1, 1.0), (-0.5, 2.0), (0.6, 1.0), (0.7, 1.5), (1.0, 0.5), (2.5, 1.0), (-10.0, 0.3)]
    {
        let g = Swirl::new(angle, s).expect("s > 0");
        low(&g, vector![0.6, 0.8] * (SQRT_2 * s));
        high(&g, vector![0.6, 0.8] * (SQRT_2 * s));
        // By symmetry, the points of one ray suffice.
        let ray = (0..200).map(|i| vector![f64::from(i) * 0.01 * s, 0.0]);
        let places = ray.flat_map(|x| directions(90).map(move |w| (x, w)));
        let [slope, curvature] = scan(&g, places);
        assert!((0.985..1.0).contains(&slope), "{slope} for {angle}");
        assert!((0.955..1.0).contains(&curvature), "{curvature} for {angle}");
    }
}

#[test]
fn egg_crate_is_exact() {
    for (a, k) in [(0.5, 1.0), (-2.0, 0.7), (0.01, 3.0)] {
        let g = EggCrate::new(a, k).expect("k > 0");
        low(&g, vector![0.3, 0.4]);
        high(&g, vector![0.0, PI / k]);
        slope(&g, vector![FRAC_PI_4, FRAC_PI_4] / k, vector![1.0, 1.0]);
        curvature(&g, vector![0.0, PI / k], vector![1.0, 0.0]);
    }
}

#[test]
fn corrugated_is_exact() {
    for (a, k) in [(0.5, 1.0), (-2.0, 0.7), (0.01, 3.0)] {
        let g = Corrugated::new(a, k).expect("k > 0");
        low(&g, vector![FRAC_PI_2 / k]);
        high(&g, vector![PI / k, 0.3, 0.4]);
        slope(&g, vector![FRAC_PI_4 / k, 0.3], vector![-1.0, 0.0]);
        curvature(&g, vector![PI / k], vector![1.0]);
    }
}

#[test]
fn checkerboard_is_exact() {
    for (a, e) in PROFILES {
        let g = Checkerboard::new(a, e).expect("e > 0");
        low(&g, vector![3.0 * e, 0.3]);
        high(&g, vector![0.5, -1.5] * e);
        slope(&g, vector![0.75, 0.5] * e, vector![1.0, 0.0]);
        curvature(&g, vector![0.5, 0.5] * e, vector![0.6, 0.8]);
    }
}

#[test]
fn two_channels_is_exact_but_for_l_h_and_m_h() {
    for (a, s) in PROFILES {
        // beta is half the gap, in widths. The values give one wide channel, ridges between, and
        // two separate channels.
        for beta in [0.01, 0.5, 1.0, 1.33, 1.5, 2.0, 5.0] {
            let g = TwoChannels::new(a, beta * s, s).expect("positive");
            low(&g, vector![1.0, -beta * s]);
            high(&g, vector![1.0, (beta + 12.0) * s]);
            let places = (0..900).map(|i| vector![0.0, f64::from(i) * 0.01 * s]);
            let [slope, curvature] = scan(&g, places.map(|x| (x, vector![0.0, 1.0])));
            assert!((0.91..1.0 + 1e-12).contains(&slope), "{slope} for {beta}");
            assert!((0.715..1.0).contains(&curvature), "{curvature} for {beta}");
        }
    }
}
