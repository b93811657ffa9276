//! The observed orders: on smooth data both rules do better than the theorems ask for.
//!
//! `E(γᵖˡ) − d²` falls like `N⁻²` for both rules, `E_tra,N − d²` like `N⁻²`, and `E_l,N − d²` like
//! `N⁻¹` unless `∫ DH[γ̇](γ̇, γ̇) dt` is zero by symmetry.

use tautline::{
    Bounded, Ends, KnownDistance, LeftEndpoint, Problem, Rule, SVector, Trapezoidal,
    gallery::{Ramp, Separable, Shear, Valleys},
};

use super::slope::slope;

/// The grids of the fits: beyond the first few terms of the expansion in `1/N`, and with
/// errors above `10⁻⁷ d²`, far above rounding.
const WINDOW: [usize; 4] = [128, 256, 512, 1024];

/// How far a slope may be from the order. The next term of an expansion is smaller by some
/// `10/N`; over the window that tilts the line by less than 0.04.
const TILT: f64 = 0.05;

fn errors<M, const D: usize>(
    metric: M,
    [a, b]: [[f64; D]; 2],
    rule: impl Rule,
) -> [Vec<(usize, f64)>; 2]
where
    M: Bounded<D> + KnownDistance<D>,
{
    let d2 = metric.distance(&SVector::from(a), &SVector::from(b)).expect("known").powi(2);
    let problem = Problem::new(metric, Ends::points(a, b).expect("finite"));
    let (mut discrete, mut curve) = (Vec::new(), Vec::new());
    for n in WINDOW {
        let line = problem.solve(rule, n).expect("a metric");
        discrete.push((n, (line.discrete_energy() - d2).abs()));
        curve.push((n, line.energy().value - d2));
    }
    [discrete, curve]
}

#[track_caller]
fn assert_order(what: &str, errors: &[(usize, f64)], order: f64) {
    let slope = slope(errors);
    println!("{what}: slope {slope:.4} for N = {WINDOW:?}");
    assert!((slope + order).abs() <= TILT, "{what}: slope {slope} over {errors:?}, not −{order}");
}

#[track_caller]
fn orders<M, const D: usize>(name: &str, metric: M, ends: [[f64; D]; 2])
where
    M: Bounded<D> + KnownDistance<D> + Clone,
{
    let [discrete, curve] = errors(metric.clone(), ends, Trapezoidal);
    assert_order(&format!("{name}: |E_tra,N − d²|"), &discrete, 2.0);
    assert_order(&format!("{name}: E(γᵖˡ) − d², trapezoidal"), &curve, 2.0);
    let [discrete, curve] = errors(metric, ends, LeftEndpoint);
    assert_order(&format!("{name}: |E_l,N − d²|"), &discrete, 1.0);
    assert_order(&format!("{name}: E(γᵖˡ) − d², left"), &curve, 2.0);
}

#[test]
fn orders_on_a_shear() {
    orders("shear", Shear::new(0.5, 1.0).expect("valid"), [[0.0, 0.0], [2.0, 3.0]]);
}

#[test]
fn orders_over_the_valleys() {
    orders("valleys", Valleys, [[0.0, 0.0], [2.0, 1.5]]);
}

#[test]
fn orders_on_a_separable_metric() {
    let metric = Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).expect("valid");
    orders("separable", metric, [[0.0, 0.0, 0.0], [2.0, 1.0, -1.5]]);
}

#[test]
fn orders_on_a_ramp() {
    orders("ramp", Ramp::new(0.5, 1.0).expect("valid"), [[-1.0], [2.0]]);
}

/// Along the axis of Section 5 the first order of the left rule is zero by symmetry.
#[test]
fn the_left_rule_has_order_2_where_the_metric_is_even_about_the_middle() {
    let far = 4.0 * std::f64::consts::PI;
    let [discrete, curve] = errors(Valleys, [[0.0, 0.0], [far, 0.0]], LeftEndpoint);
    assert_order("valleys, even: |E_l,N − d²|", &discrete, 2.0);
    assert_order("valleys, even: E(γᵖˡ) − d², left", &curve, 2.0);
}
