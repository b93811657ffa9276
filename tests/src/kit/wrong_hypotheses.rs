//! A statement refuses constants that are not those of the metric: the hypothesis or the conclusion
//! that needs the wrong constant fails.

use tautline::gallery::{Constant, Valleys};
use tautline_kit::{Fault, MetricCase, metric, prelude::*};
use tautline_statements::{Inequality, Statement};

use super::{
    claiming, fault,
    gallery::{cube, period},
};

type Law<M> = fn(&MetricCase<WithConstants<M>, 2>) -> Outcome;

/// Runs a law on a metric with these constants. Returns the statement, whether one of its
/// hypotheses fails, and the violated inequality.
#[track_caller]
fn violated<M: Bounded<2>>(
    law: Law<M>,
    metric: M,
    region: Region<2>,
    constants: [f64; 3],
) -> (Statement, bool, Inequality) {
    let effort = Effort { problems: 6, ..Effort::default() };
    match fault(law(&MetricCase::new(claiming(metric, constants), region, effort))) {
        Fault::Statement { statement, hypothesis, inequality } => {
            (statement, hypothesis, inequality)
        }
        fault => panic!("{fault}"),
    }
}

/// All constants of the valleys are attained. Here one of them is wrong by five or ten percent.
#[test]
fn statements_refuse_a_wrong_constant_of_the_valleys() {
    use Statement::{Proposition7_1, Proposition7_5, Proposition7_6, Proposition7_7};
    let claimed = Bounded::<2>::constants(&Valleys);
    let [c1, c2, l_h] = [claimed.c1(), claimed.c2(), claimed.l_h()];
    let [large_c1, small_c2, small_l_h] =
        [[1.05 * c1, c2, l_h], [c1, 0.95 * c2, l_h], [c1, c2, 0.9 * l_h]];
    let [least, greatest, slope] =
        ["c₁ ≤ λ_min(H)", "λ_max(H) ≤ c₂", "‖H(x) − H(y)‖/|x − y| ≤ L_H"];
    let cases: [(Law<Valleys>, _, _, _); 9] = [
        (metric::prop_7_1, Proposition7_1, large_c1, least),
        (metric::prop_7_5, Proposition7_5, small_c2, "λ_max(H(x₂)) ≤ c₂"),
        (metric::prop_7_5, Proposition7_5, small_l_h, "‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|"),
        (metric::prop_7_6, Proposition7_6, large_c1, least),
        (metric::prop_7_6, Proposition7_6, small_c2, greatest),
        (metric::prop_7_6, Proposition7_6, small_l_h, slope),
        (metric::prop_7_7, Proposition7_7, large_c1, least),
        (metric::prop_7_7, Proposition7_7, small_c2, greatest),
        (metric::prop_7_7, Proposition7_7, small_l_h, slope),
    ];
    for (law, expected, constants, clause) in cases {
        let (statement, hypothesis, found) = violated(law, Valleys, period(), constants);
        assert_eq!((statement, hypothesis), (expected, true), "{clause}");
        assert_eq!(found.claim, clause, "{expected}");
    }
}

/// With a hundredth of `L_H` claimed, the speeds change by more than the statement allows.
#[test]
fn minimisers_refuse_a_hundredth_of_l_h() {
    let claimed = Bounded::<2>::constants(&Valleys);
    let constants = [claimed.c1(), claimed.c2(), 0.01 * claimed.l_h()];
    let (_, hypothesis, found) =
        violated(metric::minimisers_are_critical_points, Valleys, period(), constants);
    assert!(!hypothesis && found.claim.contains("qₙ − qₙ₋₁"), "{found}");
}

/// The metric is `H = I`, but `c₁ = c₂ = 100` is claimed. At both points of the nearest pair the
/// smallest eigenvalue is 1.
#[test]
fn prop_6_2_refuses_a_c1_of_a_hundred() {
    let metric = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
    let (statement, hypothesis, found) =
        violated(metric::prop_6_2, metric, cube(2.0), [100.0, 100.0, 0.0]);
    assert_eq!((statement, hypothesis), (Statement::Proposition6_2, true));
    assert_eq!(found.claim, "c₁ ≤ λ_min(H) at x and y");
}
