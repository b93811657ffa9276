//! Constants and distances that are not those of the metric, put to the statements that rest on
//! them: each is refused, by the hypothesis or by the conclusion in which it stands.

use tautline::gallery::{Constant, Valleys};
use tautline_kit::{Fault, MetricCase, metric, prelude::*};
use tautline_statements::{Inequality, Statement, WithConstants};

use super::gallery::{cube, period};

/// What a law says against a metric with these constants: the statement, whether a hypothesis of it
/// fails, and the inequality.
#[track_caller]
fn said<M: Bounded<2>>(
    law: fn(&MetricCase<WithConstants<M>, 2>) -> Outcome,
    metric: M,
    region: Region<2>,
    [c1, c2, l_h]: [f64; 3],
) -> (Statement, bool, Inequality) {
    let constants = Constants::new(c1, c2, l_h).expect("c1 ≤ c2");
    let outcome = law(&MetricCase::new(
        WithConstants { metric, constants },
        region,
        Effort { problems: 6, ..Effort::default() },
    ));
    let failure = outcome.failure.unwrap_or_else(|| panic!("{} passes", outcome.id));
    match failure.fault {
        Fault::Statement { statement, hypothesis, inequality } => {
            (statement, hypothesis, inequality)
        }
        fault => panic!("{fault}"),
    }
}

/// The constants of the valleys, all three of which are attained, with one of them off by five or
/// ten percent.
fn lies() -> [[f64; 3]; 3] {
    let claimed = Bounded::<2>::constants(&Valleys);
    let [c1, c2, l_h] = [claimed.c1(), claimed.c2(), claimed.l_h()];
    [[1.05 * c1, c2, l_h], [c1, 0.95 * c2, l_h], [c1, c2, 0.9 * l_h]]
}

#[test]
fn prop_7_5_refuses_a_smaller_c2_and_a_smaller_l_h() {
    let [_, c2, l_h] = lies();
    for (lie, clause) in [(c2, "λ_max(H(x₂)) ≤ c₂"), (l_h, "‖H(x₁) − H(x₂)‖ ≤ L_H |x₁ − x₂|")]
    {
        let (statement, hypothesis, found) = said(metric::prop_7_5, Valleys, period(), lie);
        assert_eq!((statement, hypothesis), (Statement::Proposition7_5, true));
        assert_eq!(found.claim, clause);
    }
}

#[test]
fn props_7_6_and_7_7_refuse_constants_that_a_curve_breaks() {
    let clauses = ["c₁ ≤ λ_min(H)", "λ_max(H) ≤ c₂", "‖H(x) − H(y)‖/|x − y| ≤ L_H"];
    for (lie, clause) in lies().into_iter().zip(clauses) {
        let (statement, hypothesis, found) = said(metric::prop_7_6, Valleys, period(), lie);
        assert_eq!((statement, hypothesis), (Statement::Proposition7_6, true));
        assert_eq!(found.claim, clause);
        let (statement, hypothesis, found) = said(metric::prop_7_7, Valleys, period(), lie);
        assert_eq!((statement, hypothesis), (Statement::Proposition7_7, true));
        assert_eq!(found.claim, clause);
    }
}

#[test]
fn prop_7_1_refuses_a_larger_c1() {
    let [lie, ..] = lies();
    let (statement, hypothesis, found) = said(metric::prop_7_1, Valleys, period(), lie);
    assert_eq!((statement, hypothesis), (Statement::Proposition7_1, true));
    assert_eq!(found.claim, "c₁ ≤ λ_min(H)");
}

/// Speeds that change by more than a metric that hardly changes allows.
#[test]
fn minimisers_refuse_a_hundredth_of_l_h() {
    let claimed = Bounded::<2>::constants(&Valleys);
    let lie = [claimed.c1(), claimed.c2(), 0.01 * claimed.l_h()];
    let (_, hypothesis, found) =
        said(metric::minimisers_are_critical_points, Valleys, period(), lie);
    assert!(!hypothesis && found.claim.contains("qₙ − qₙ₋₁"), "{found}");
}

/// `H = I` with `c₁ = c₂ = 100`: at both points of the nearest pair the least eigenvalue is 1.
#[test]
fn prop_6_2_refuses_a_c1_of_a_hundred() {
    let metric = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
    let lie = [100.0, 100.0, 0.0];
    let (statement, hypothesis, found) = said(metric::prop_6_2, metric, cube(2.0), lie);
    assert_eq!((statement, hypothesis), (Statement::Proposition6_2, true));
    assert_eq!(found.claim, "c₁ ≤ λ_min(H) at x and y");
}
