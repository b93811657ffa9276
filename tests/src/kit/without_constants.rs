//! The metrics of the gallery that claim nothing: the laws that look inside of a region only, with
//! constants that hold there.
//!
//! `4 / (1 + r²)²` has no `c₁ > 0` on all of the plane, and `4 / (1 − r²)²` has no `c₂` in the disc,
//! so that none of the theorems applies. In a convex region that holds the curve, or the two points,
//! the constants of the region do; where a statement speaks of a distance, shortest curves may
//! leave it, and where it speaks of a minimiser, points far out may be better than any inside.
//! Those are the laws of [`EVERYWHERE`].

use tautline::gallery::{Hyperbolic, Sphere};
use tautline_verify::{
    kit::{MetricCase, metric},
    prelude::*,
};

use super::gallery::cube;

/// Laws that need the constants on all of `R^D`: distances between two points, and minimisers.
const EVERYWHERE: [&str; 21] = [
    "prop_3_3",
    "prop_6_2",
    "prop_6_3",
    "prop_7_1",
    "minimisers_are_critical_points",
    "theorem_1_1",
    "theorem_1_2",
    "theorem_1_3",
    "theorem_1_4",
    "constant_c_tra",
    "constant_c_tra_sharp",
    "constant_k3_bar",
    "constant_c_1_1",
    "constant_k4_bar",
    "constant_c_1_3",
    "lemmas_s_4_and_s_5",
    "theorems_a_to_d",
    "prop_s_6",
    "remark_9_2",
    "trapezoidal_rule_has_order_2",
    "left_rule_has_order_1",
];

type Law<M> = fn(&MetricCase<M, 2>) -> Outcome;

/// All other laws hold, and no law is in both lists or in none.
#[track_caller]
fn laws_hold_inside<M: Bounded<2> + KnownDistance<2>>(metric: M, region: Region<2>) {
    let case = MetricCase::new(metric, region, Effort::default()).with_known_distance();
    let laws: [Law<M>; 30] = [
        metric::is_finite_and_symmetric,
        metric::is_positive_definite,
        metric::is_isotropic_if_it_says_so,
        metric::norm_squared_agrees_with_gram,
        metric::jets_agree_with_differences,
        metric::c1_is_a_lower_bound,
        metric::c2_is_an_upper_bound,
        metric::l_h_bounds_the_derivative,
        metric::l_h_bounds_differences,
        metric::m_h_bounds_the_second_derivative,
        metric::known_distances_are_distances,
        metric::prop_6_1,
        metric::prop_7_5,
        metric::prop_7_6,
        metric::prop_7_7,
        metric::prop_7_9,
        metric::prop_7_10,
        metric::prop_7_11,
        metric::prop_8_1,
        metric::prop_8_2,
        metric::lemmas_s_2_and_s_3,
        metric::refuses_a_larger_c1,
        metric::refuses_a_smaller_c2,
        metric::refuses_a_smaller_l_h,
        metric::refuses_a_smaller_m_h,
        metric::refuses_a_metric_that_is_nan,
        metric::refuses_points_that_are_nan,
        metric::refuses_no_subinterval,
        metric::refuses_two_unbounded_sets,
        metric::refuses_an_empty_set,
    ];
    let outcomes = laws.map(|law| law(&case));
    for outcome in &outcomes {
        outcome.assert();
        // Each constant is attained in the region, so that the lie about it is one.
        let is_lie = ["c1", "c2", "l_h", "m_h"].iter().any(|name| outcome.id.ends_with(name));
        assert!(!is_lie || outcome.note.is_none(), "{outcome}");
    }
    let mut all: Vec<&str> = outcomes.iter().map(|outcome| outcome.id).chain(EVERYWHERE).collect();
    let mut laws = metric::LAWS.to_vec();
    all.sort_unstable();
    laws.sort_unstable();
    assert_eq!(all, laws);
}

/// `f = 4 / (1 + r²)²` with `|f′| = 16 r / (1 + r²)³`, largest at `r = 1/√5`, and `f″ = −16` at 0;
/// `c₁` is attained in the corners, where `r² = ½`. All but `c₁` hold on all of the plane.
#[test]
fn the_sphere_inside_of_a_square() {
    let l_h = 16.0 / 5_f64.sqrt() * (5.0_f64 / 6.0).powi(3);
    let constants = Constants::new(4.0 / 2.25, 4.0, l_h).and_then(|c| c.with_m_h(16.0));
    let constants = constants.expect("in order");
    laws_hold_inside(WithConstants { metric: Sphere, constants }, cube(0.5));
}

/// `f = 4 / (1 − r²)²` with `f′ = 16 r / (1 − r²)³` and `f″ = 16 (1 + 5r²) / (1 − r²)⁴`, all of which
/// grow with `r`, up to `r² = ⅛` in the corners.
#[test]
fn hyperbolic_space_inside_of_a_square() {
    let (r2, inner) = (0.125_f64, 0.875_f64);
    let l_h = 16.0 * r2.sqrt() / inner.powi(3);
    let m_h = 16.0 * (1.0 + 5.0 * r2) / inner.powi(4);
    let constants = Constants::new(4.0, 4.0 / inner.powi(2), l_h).and_then(|c| c.with_m_h(m_h));
    let constants = constants.expect("in order");
    laws_hold_inside(WithConstants { metric: Hyperbolic, constants }, cube(0.25));
}
