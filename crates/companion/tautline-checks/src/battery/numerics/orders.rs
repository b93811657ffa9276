//! The observed orders of convergence: on smooth data both rules do better than the theorems
//! guarantee.
//!
//! `E(γᵖˡ) − d²` decreases like `N⁻²` for both rules. `E_tra,N − d²` decreases like `N⁻²`, and
//! `E_l,N − d²` like `N⁻¹`, unless `∫ DH[γ̇](γ̇, γ̇) dt` is zero by symmetry.

use nalgebra::SVector;
use tautline::{
    Bounded, Ends, KnownDistance, Rule,
    gallery::{Ramp, Separable, Shear, Valleys},
};
use tautline_statements::{
    Statement::{self, Theorem1_1, Theorem1_3},
    Subject,
};

use crate::battery::harness::{Check, Order, Outcome, Trial, has_slope};

const BOTH: &[Statement] = &[Theorem1_1, Theorem1_3];

pub(crate) const CHECKS: &[Check] = &[
    Order.check("orders_on_a_shear", BOTH, |trial| {
        let metric = Shear::new(0.5, 1.0).expect("valid");
        orders(trial, "shear", &metric, [[0.0, 0.0], [2.0, 3.0]])
    }),
    Order.check("orders_over_the_valleys", BOTH, |trial| {
        orders(trial, "valleys", &Valleys, [[0.0, 0.0], [2.0, 1.5]])
    }),
    Order.check("orders_on_a_separable_metric", BOTH, |trial| {
        let metric = Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).expect("valid");
        orders(trial, "separable", &metric, [[0.0, 0.0, 0.0], [2.0, 1.0, -1.5]])
    }),
    Order.check("orders_on_a_ramp", BOTH, |trial| {
        let metric = Ramp::new(0.5, 1.0).expect("valid");
        orders(trial, "ramp", &metric, [[-1.0], [2.0]])
    }),
    Order.check(
        "the_left_rule_has_order_2_where_the_metric_is_even_about_the_middle",
        &[Theorem1_3],
        even,
    ),
];

/// The grids of the fits. They are so fine that the first terms of the expansion in `1/N` dominate,
/// while the errors are above `10⁻⁷ d²`, far above rounding.
const WINDOW: [usize; 4] = [128, 256, 512, 1024];

/// The tolerance for the difference between a slope and the order. The next term of an expansion is
/// smaller by a factor of some `10/N`, which changes the slope over the window by less than 0.04.
const TILT: f64 = 0.05;

/// Checks the orders of `|E_N − d²|` and of `E(γᵖˡ) − d²` over the window.
fn have_orders<M, const D: usize>(
    subject: &Subject,
    name: &str,
    metric: &M,
    [a, b]: [[f64; D]; 2],
    rule: Rule,
    orders: [f64; 2],
) -> Outcome
where
    M: Bounded<D> + KnownDistance<D>,
{
    let d2 = metric.distance(&SVector::from(a), &SVector::from(b)).expect("known").powi(2);
    let ends = Ends::points(a, b)?;
    let (mut discrete, mut curve) = (Vec::new(), Vec::new());
    for n in WINDOW {
        let line = subject.minimise(rule, metric, &ends, n)?.sequence;
        discrete.push((n as f64, (subject.discrete_energy(rule, metric, &line) - d2).abs()));
        curve.push((n as f64, subject.curve_energy(metric, &line).value - d2));
    }
    has_slope(&format!("{name}, {rule}: |E_N − d²|"), &discrete, -orders[0], TILT)?;
    has_slope(&format!("{name}, {rule}: E(γᵖˡ) − d²"), &curve, -orders[1], TILT)
}

fn orders<M, const D: usize>(
    trial: &Trial<'_>,
    name: &str,
    metric: &M,
    ends: [[f64; D]; 2],
) -> Outcome
where
    M: Bounded<D> + KnownDistance<D>,
{
    have_orders(trial.subject, name, metric, ends, Rule::TRAPEZOIDAL, [2.0, 2.0])?;
    have_orders(trial.subject, name, metric, ends, Rule::LEFT_ENDPOINT, [1.0, 2.0])
}

/// Along the axis of Section 5 the first-order term of the left rule is zero by symmetry.
fn even(trial: &Trial<'_>) -> Outcome {
    let ends = [[0.0, 0.0], [4.0 * std::f64::consts::PI, 0.0]];
    have_orders(trial.subject, "valleys, even", &Valleys, ends, Rule::LEFT_ENDPOINT, [2.0, 2.0])
}
