//! Metrics with a centre: lengths along rays, and the geodesic around the bump.

use approx::assert_relative_eq;
use nalgebra::{SVector, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Bump, Hill, Lens},
    quadrature::integrate,
};

use super::distances::{chord, distance, is_bounded, is_distance, run};

/// Makes one test per line: at points `r e` on a ray the distance is the length of the chord and
/// hence additive; off the ray it is not known.
macro_rules! known_on_rays {
    ($($test:ident, $metric:ident, $D:literal, $seed:literal;)*) => {$(
        #[test]
        fn $test() {
            let parameters = (0.05..5.0_f64, 0.1..3.0_f64);
            let radii = uniform::<_, 3>(0.0..4.0_f64);
            let direction = uniform::<_, $D>(-1.0..1.0_f64).prop_map(SVector::from);
            run($seed, (parameters, radii, direction), |((height, width), mut radii, e)| {
                let g = $metric::new(height, width).expect("positive");
                radii.sort_by(f64::total_cmp);
                let [x, y, z] = radii.map(|r| e * r);
                is_distance(&g, [x, y, z])?;
                is_bounded(&g, &x, &z)?;
                let (whole, parts) = (distance(&g, &x, &z), distance(&g, &x, &y) + distance(&g, &y, &z));
                prop_assert!((whole - parts).abs() <= 1e-13 * (1.0 + whole), "{whole} {parts}");
                // Both are quadratures, accurate to rounding.
                prop_assert!((whole - chord(&g, &x, &z)).abs() <= 1e-12 * (1.0 + whole));
                let opposite = KnownDistance::<$D>::distance(&g, &x, &-z);
                prop_assert_eq!(opposite.is_some(), $D == 1 || radii[0] == 0.0);
                let mut aside = z;
                aside[0] += 1e-6;
                prop_assert_eq!(g.distance(&y, &aside).is_some(), $D == 1 || radii[1] == 0.0);
                Ok(())
            });
        }
    )*};
}

known_on_rays! {
    lens_is_known_on_rays, Lens, 2, 37;
    lens_is_known_on_the_line, Lens, 1, 38;
    bump_is_known_on_rays, Bump, 3, 39;
    bump_is_known_on_the_line, Bump, 1, 40;
    hill_is_known_on_rays, Hill, 5, 41;
    hill_is_known_on_the_line, Hill, 1, 42;
}

/// In one dimension the geodesic passes through the centre.
#[test]
fn on_the_line_the_centre_is_crossed() {
    let g = Bump::new(4.0, 0.5).expect("positive");
    let (x, o, y) = (vector![-0.3], vector![0.0], vector![1.0]);
    let halves = distance(&g, &x, &o) + distance(&g, &o, &y);
    assert_relative_eq!(distance(&g, &x, &y), halves, max_relative = 1e-14);
}

#[test]
fn a_point_that_is_not_finite_is_on_no_ray() {
    let g = Bump::new(4.0, 0.5).expect("positive");
    for bad in [f64::NAN, f64::INFINITY] {
        assert_eq!(g.distance(&vector![bad], &vector![1.0]), None);
        assert_eq!(g.distance(&vector![1.0], &vector![bad]), None);
        assert_eq!(g.distance(&vector![1.0, 0.0], &vector![bad, 0.0]), None);
    }
}

/// The geodesic `(−1.5, 0.05) → (1.5, −0.1)` around the bump of height 4 and width 1/2 has the
/// energy 21.858160535(3), according to an independent Richardson extrapolation of discrete
/// energies.
///
/// Here we use Clairaut's relation: on a geodesic `f r sin φ = p` is constant, where `φ` is the
/// angle from the ray. So the geodesic sweeps the angle `Σ ∫ p / (r √(f² r² − p²)) dr` from its
/// least radius, where `f r = p`, to either end, and its length is `p` times this angle
/// `+ Σ ∫ √(f² − p²/r²) dr`.
#[test]
fn the_geodesic_around_the_bump_has_the_known_energy() {
    let g = Bump::new(4.0, 0.5).expect("positive");
    let (x, y) = (vector![-1.5, 0.05_f64], vector![1.5, -0.1]);
    let f = |r: f64| Metric::<2>::gram(&g, &vector![r, 0.0])[(0, 0)].sqrt();
    // Both integrands are written in t with r = least + t²; the root is then smooth and vanishes
    // like t.
    let root = |least: f64, r: f64| ((f(r) * r).powi(2) - (f(least) * least).powi(2)).sqrt();
    let both = |least: f64, tolerance: f64, integrand: &dyn Fn(f64) -> f64| {
        let leg = |end: f64| {
            let in_t = |t: f64| 2.0 * t * integrand(least + t * t);
            integrate(in_t, 0.0, (end - least).sqrt(), tolerance).value
        };
        leg(x.norm()) + leg(y.norm())
    };
    // The length is stationary in p, so an error of 1e-7 in the angle is 1e-14 in the length. A
    // smaller tolerance would lead the quadrature to values of t so small that the root cancels.
    let swept = |least: f64| both(least, 1e-7, &|r| f(least) * least / (r * root(least, r)));
    let angle = x.angle(&y);
    // fr has its minimum, a closed geodesic, near 1.22; beyond it the angle decreases from ∞.
    let (mut low, mut high) = (1.23, 1.5);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        *(if swept(middle) > angle { &mut low } else { &mut high }) = middle;
    }
    let length = f(low) * low * angle + both(low, 1e-12, &|r| root(low, r) / r);
    // The reference is accurate to 3e-9.
    assert!((length * length - 21.858_160_535).abs() < 4e-9, "{}", length * length);
}
