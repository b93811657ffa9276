//! The rules of the project, one line each, and one of one's own.

use tautline::{LeftEndpoint, Trapezoidal, TrueTrapezoid};
use tautline_verify::{kit::Fault, prelude::*};

rule_suite!(trapezoidal: Trapezoidal);
rule_suite!(left_endpoint: LeftEndpoint);
rule_suite!(true_trapezoid: TrueTrapezoid);

/// Gauss's rule with two nodes, as a user would write it.
#[derive(Clone, Copy, Debug)]
struct Gauss;

impl Rule for Gauss {
    // ½ ∓ 1/√12
    const NODES: &'static [Node] = &[
        Node { fraction: 0.211_324_865_405_187_12, weight: 0.5 },
        Node { fraction: 0.788_675_134_594_812_9, weight: 0.5 },
    ];
    const ERROR_EXPONENT: i32 = 2;
}

rule_suite!(gauss: Gauss);

/// The right end of the chord with weights that are too light, and an exponent that is too large.
#[derive(Clone, Copy, Debug)]
struct Wrong;

impl Rule for Wrong {
    const NODES: &'static [Node] =
        &[Node { fraction: 1.0, weight: 0.7 }, Node { fraction: 0.0, weight: 0.2 }];
    const ERROR_EXPONENT: i32 = 2;
}

#[test]
fn a_wrong_rule_fails_by_the_laws_it_breaks() {
    let report = verify_rule(Wrong, &Effort::default());
    let failures: Vec<&str> = report.failures().map(|outcome| outcome.id).collect();
    let broken = [
        "weights_are_nonnegative_and_sum_to_1",
        "constant_metrics_are_integrated_exactly",
        "error_exponent_is_observed",
    ];
    assert_eq!(failures, broken, "{report}");
}

/// The right-endpoint rule is a rule; only its exponent is a boast, with both numbers.
#[test]
fn an_exponent_that_is_not_observed_is_named() {
    #[derive(Clone, Copy, Debug)]
    struct RightEndpoint;
    impl Rule for RightEndpoint {
        const NODES: &'static [Node] = &[Node { fraction: 1.0, weight: 1.0 }];
        const ERROR_EXPONENT: i32 = 2;
    }
    let report = verify_rule(RightEndpoint, &Effort::default());
    let failures: Vec<_> = report.failures().collect();
    let [outcome] = failures[..] else { panic!("{report}") };
    let fault = &outcome.failure.as_ref().expect("it fails").fault;
    let Fault::Order { found, least, .. } = *fault else { panic!("{report}") };
    assert!((found - 1.0).abs() <= 0.05 && least > 1.9, "{report}");
}
