//! Metrics that are undefined on a part of a domain, and have no value at the first point
//! evaluated. The search finds a point where they are undefined.

use nalgebra::vector;
use tautline_certify::{
    Accuracy, Cell, CertifiedConstants, CertifyError, Domain, LocallyCertified, Quantity, certify,
};
use tautline_metrics::{LocalError, LocallyBounded};

use crate::parsed;

/// `1 + √(1 + x)`, plus a term that has no value in doubles at 0: either `|x|`, whose derivatives
/// are `0/0` there, or `10³²⁰ e^{−200 x²}`, which overflows.
const PARTLY: [&str; 2] =
    ["sqrt(sqr(x1)) + sqrt(x1 + 1) + 1 I", "sqr(exp(-sqr(x1)*100)*1e160) + sqrt(x1 + 1) + 1 I"];

#[track_caller]
fn assert_undefined<T: std::fmt::Debug>(found: Result<T, CertifyError>) {
    match found {
        Err(CertifyError::Undefined { point }) => assert!(point[0] < -1.0, "{point:?}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn undefined_parts_are_found_though_the_first_point_has_no_value() {
    let cell = Domain::cell(Cell::new([-2.0], [2.0]).expect("in order"));
    let ball = Domain::ball([0.0], 2.0).expect("a radius");
    let accuracy = Accuracy { budget: 10_000, ..Accuracy::default() };
    for domain in [cell, ball] {
        assert!(domain.bounding_cell().midpoint()[0] == 0.0);
        for metric in PARTLY.map(parsed::<1>) {
            for quantity in Quantity::ALL {
                assert_undefined(certify(&metric, quantity, &domain, accuracy));
            }
            assert_undefined(CertifiedConstants::new(&metric, &domain, accuracy));
        }
    }
    let local = LocallyCertified::new(parsed::<1>(PARTLY[1]), accuracy);
    match local.constants_within(&vector![0.0], 2.0) {
        Err(LocalError::NotProved { radius: 2.0, reason, .. }) => {
            assert!(reason.contains("may be undefined at"), "{reason}");
        }
        other => panic!("{other:?}"),
    }
}

/// If the metric is defined on the domain, the other points count: `|x|` has a slope on both sides,
/// but no bounded second derivative.
#[test]
fn if_nothing_is_undefined_the_budget_ends_the_search() {
    let cell = Domain::cell(Cell::new([-0.5], [0.5]).expect("in order"));
    let accuracy = Accuracy { budget: 500, ..Accuracy::default() };
    for quantity in [Quantity::LH, Quantity::MH] {
        match certify(&parsed::<1>(PARTLY[0]), quantity, &cell, accuracy) {
            Err(CertifyError::BudgetSpent { lower, upper, boxes, .. }) => {
                assert!(boxes > 400 && upper == f64::INFINITY, "{boxes} boxes, {upper}");
                // The values are 1 + ½ (1 − ½)^{−1/2}, and about ¼ (½)^{−3/2}, near the ends.
                assert!(lower > 0.5, "{lower}");
            }
            other => panic!("{quantity}: {other:?}"),
        }
    }
}
