//! S.11 on computed minimisers: bounds by constants in the metric's own norms.

use tautline::{
    Bounded, Ends, Jet2, KnownDistance, Metric, Problem, Rule, SVector,
    bounds::{OwnNorms, Setting, least_length_excess},
    gallery::{Shear, Valleys},
    norm_squared,
};

/// Returns the greatest `|uᵀ DH[w] u|/|u|²|w|` and `|uᵀ D²H[w, w] u|/|u|²|w|²` at points of a grid
/// over one period, for directions on a grid of angles.
fn greatest(metric: &impl Metric<2>) -> [f64; 2] {
    let angles = || (0..48).map(|k| std::f64::consts::PI * f64::from(k) / 48.0);
    let mut found = [0.0_f64; 2];
    for k in 0..96 {
        let x = SVector::<f64, 2>::repeat(std::f64::consts::PI * f64::from(k) / 48.0);
        for angle in angles() {
            let u = SVector::from([angle.cos(), angle.sin()]);
            let jet = norm_squared(metric, &Jet2::variables(&x.into()).into(), &u);
            for angle in angles() {
                let w = [angle.cos(), angle.sin()];
                let length = norm_squared(metric, &x, &w.into()).sqrt();
                let first = w[0] * jet.first(0) + w[1] * jet.first(1);
                let second = w[0] * w[0] * jet.second(0, 0)
                    + 2.0 * w[0] * w[1] * jet.second(0, 1)
                    + w[1] * w[1] * jet.second(1, 1);
                let size = jet.value() * length;
                found[0] = found[0].max(first.abs() / size);
                found[1] = found[1].max(second.abs() / (size * length));
            }
        }
    }
    found
}

/// The shear by `½ sin x₂` has `λ = ν = ½`, where `L_H/c₁^{3/2} = 1.17` and `M_H/c₁² = 2.18`: with
/// `a = u₁ + k u₂` and `b = u₂` the derivatives are `2ab k′w₂` and `2ab k″w₂² + 2b²k′²w₂²`, and
/// `w₂² ≤ |w|²`. The valleys have `λ = max 2 sin x/(2 − cos x)² = 0.848`, where `L_H = 4.40`, and
/// `ν = 2`, at the bottom, where `M_H = 6`.
#[test]
fn the_constants_in_own_norms_are_those_of_the_metrics() {
    let shear = Shear::new(0.5, 1.0).expect("valid");
    for (found, [lambda, nu]) in
        [(greatest(&shear), [0.5, 0.5]), (greatest(&Valleys), [0.848, 2.0])]
    {
        assert!((0.99 * lambda..=lambda * (1.0 + 1e-12)).contains(&found[0]), "{found:?}");
        assert!((0.99 * nu..=nu * (1.0 + 1e-12)).contains(&found[1]), "{found:?}");
    }
}

/// Returns the excess of the squared length, the bound by own norms, and the least of all other
/// bounds.
fn compare<M>(metric: M, rule: Rule, b: [f64; 2], n: usize, own: [f64; 2]) -> [f64; 3]
where
    M: Bounded<2> + KnownDistance<2> + Copy,
{
    let d = metric.distance(&[0.0; 2].into(), &b.into()).expect("known");
    let ends = Ends::points([0.0, 0.0], b).expect("finite");
    let line = Problem::new(metric, ends).solve(rule, n).expect("solved");
    let norms = OwnNorms::new(own[0], Some(own[1]), d, 2).expect("valid");
    let is_isotropic = metric.constants().is_isotropic();
    let norms = if is_isotropic { norms.isotropic() } else { norms };
    let setting = Setting::new(metric.constants(), d, 2).expect("valid");
    let (rule, n) = (rule.paper_rule().expect("a rule of the paper"), line.sequence().n());
    [
        line.length().value.powi(2) - d * d,
        norms.length_excess(rule, n),
        least_length_excess(setting, rule, n).value,
    ]
}

/// Both bounds hold, and those by own norms are smaller by at least these factors.
#[test]
fn own_norms_give_smaller_bounds() {
    let shear = Shear::new(0.5, 1.0).expect("valid");
    for n in [16, 64, 256, 1024] {
        for (name, [excess, own, plain], factor) in [
            ("shear", compare(shear, Rule::TRAPEZOIDAL, [1.0, 2.0], n, [0.5, 0.5]), 4.8),
            ("shear, left", compare(shear, Rule::LEFT_ENDPOINT, [1.0, 2.0], n, [0.5, 0.5]), 2.1),
            ("valleys", compare(Valleys, Rule::TRAPEZOIDAL, [0.7, 0.7], n, [0.848, 2.0]), 2.5),
            (
                "valleys, left",
                compare(Valleys, Rule::LEFT_ENDPOINT, [0.7, 0.7], n, [0.848, 2.0]),
                5.1,
            ),
        ] {
            assert!(excess <= own, "{name}, N = {n}: {excess:e} above {own:e}");
            assert!(plain > factor * own, "{name}, N = {n}: {plain:e} and {own:e}");
        }
    }
}

/// With a `λ` that is a twentieth of the true one the bound is below the excess.
#[test]
fn an_understated_constant_in_own_norms_is_noticed() {
    let shear = Shear::new(0.5, 1.0).expect("valid");
    let [excess, own, _] = compare(shear, Rule::TRAPEZOIDAL, [1.0, 2.0], 64, [0.025, 0.025]);
    assert!(own < excess, "{own:e} {excess:e}");
}
