//! Propositions 7.6, 7.7, 7.11 and 7.12 on the minimal geodesics of shears.

use tautline::{
    Bounded, Ends, KnownDistance, LeftEndpoint, PointSequence, Problem, Rule, SVector, Trapezoidal,
    bounds::{Setting, c_tra_g, k1_g, k2_g},
    christoffel,
    gallery::Shear,
};

use crate::{
    families::{separable, shear},
    random::{at_most, for_all, subintervals, two_points, vector},
    section_3::geodesic,
};

/// Samples the minimal geodesic at `tₙ = n/N`.
fn sampled(metric: &Shear, ends: [SVector<f64, 2>; 2], n: usize) -> PointSequence<2> {
    let mut points: Vec<_> =
        (0..=n).map(|k| geodesic(metric, ends, k as f64 / n as f64)[0]).collect();
    // Flattening and back is exact to rounding only.
    (points[0], points[n]) = (ends[0], ends[1]);
    PointSequence::new(points).expect("finite")
}

fn setting(metric: &Shear, [a, b]: [SVector<f64, 2>; 2]) -> Setting {
    let distance = metric.distance(&a, &b).expect("known");
    Setting::new(metric.constants(), distance, 2).expect("a distance")
}

/// Proposition 7.6 with `E(γ) = d²`; and upwards by the bound without `c₂` and without `D`:
/// `E_tra,N ≤ d² (1 + δ/4N + δ²/8N²)` with `δ = L_H d / c₁^{3/2}`. For the left rule
/// `E_l,N ≤ d² (1 + δ/2N)`, since a geodesic is at most `s d/√c₁` away from its last sample after
/// the time `s`.
#[test]
fn prop_7_6_bounds_what_sampling_does_to_the_energy() {
    for_all(7601, 512, (shear(), two_points(2.5), subintervals()), |(metric, ends, n)| {
        let setting = setting(&metric, ends);
        let sequence = sampled(&metric, ends, n);
        let trapezoidal = Trapezoidal.energy(&metric, &sequence);
        let left = LeftEndpoint.energy(&metric, &sequence);
        let d2 = setting.distance().powi(2);
        let constants = setting.constants();
        let delta = constants.l_h() * setting.distance() / constants.c1().powf(1.5);
        let count = n as f64;
        // Rounding of the samples, some ulp of 10, moves the energy by its slope: a momentum of
        // size d at the ends, a change of it by d/N between two points inside. In all a few
        // ulp of 10 times d, and d ≥ 0.05.
        let slack = 2e-12 * (d2 + trapezoidal);
        let gap = (trapezoidal - d2).abs();
        at_most("|E − E_tra,N| ≤ C_tra(N)", gap, c_tra_g(setting, sequence.n()), slack)?;
        let upper = d2 * (1.0 + delta / (4.0 * count) + delta * delta / (8.0 * count * count));
        at_most("E_tra,N ≤ d² (1 + δ/4N + δ²/8N²)", trapezoidal, upper, slack)?;
        at_most("E_l,N ≤ d² (1 + δ/2N)", left, d2 * (1.0 + delta / (2.0 * count)), slack)
    });
}

/// Proposition 7.7: the least discrete energy is not above that of a sampled geodesic, nor above
/// that of the straight line.
#[test]
fn prop_7_7_no_sampled_curve_has_less_discrete_energy() {
    for_all(7701, 192, (shear(), two_points(2.5), subintervals()), |(metric, ends, n)| {
        let problem = Problem::new(metric, Ends::points(ends[0], ends[1]).expect("finite"));
        let straight = PointSequence::straight(ends[0], ends[1], n).expect("finite");
        let curves = [sampled(&metric, ends, n), straight];
        let trapezoidal = problem.solve(Trapezoidal, n).expect("a metric").discrete_energy();
        let left = problem.solve(LeftEndpoint, n).expect("a metric").discrete_energy();
        for curve in &curves {
            let sample = Trapezoidal.energy(&metric, curve);
            at_most("E_tra,N(γᵖ) ≤ E_tra,N(sample)", trapezoidal, sample, 1e-13 * sample)?;
            let sample = LeftEndpoint.energy(&metric, curve);
            at_most("E_l,N(γᵖ) ≤ E_l,N(sample)", left, sample, 1e-13 * sample)?;
        }
        Ok(())
    });
}

/// Proposition 7.11, with the factor `√D` that its proof gives away left out: `|Γᵏᵢⱼ| ≤ 3L_H/2c₁`.
#[test]
fn prop_7_11_bounds_the_christoffel_symbols() {
    for_all(7111, 256, (shear(), separable::<2>(), vector(4.0)), |(shear, separable, x)| {
        for (symbols, constants) in [
            (christoffel(&shear, &x), shear.constants()),
            (christoffel(&separable, &x), separable.constants()),
        ] {
            let largest =
                symbols.expect("a metric").iter().map(|matrix| matrix.amax()).fold(0.0, f64::max);
            let bound = 1.5 * constants.l_h() / constants.c1();
            at_most("|Γ| ≤ 3 L_H / 2 c₁", largest, bound, 1e-13 * bound)?;
        }
        Ok(())
    });
}

/// Proposition 7.12, at every single time: `|γ̇| ≤ K_{1,g}` and `|γ̈| ≤ K_{2,g}`, the latter with
/// the factor `D²` that its proof gives away left out.
#[test]
fn prop_7_12_bounds_speed_and_acceleration() {
    for_all(7121, 512, (shear(), two_points(2.5), 0.0..1.0), |(metric, ends, t)| {
        let setting = setting(&metric, ends);
        let [_, velocity, acceleration] = geodesic(&metric, ends, t);
        let (k1, k2) = (k1_g(setting), k2_g(setting));
        at_most("|γ̇| ≤ K_{1,g}", velocity.norm(), k1, 1e-12 * k1)?;
        at_most("|γ̈| ≤ K_{2,g} / D²", acceleration.norm(), k2 / 4.0, 1e-12 * k2)
    });
}
