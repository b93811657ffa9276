//! Bounds as they are printed, and claims that are refuted.

use std::{ops::ControlFlow, sync::Arc};

use tautline::{
    BlackBox, Constants, Formula, Known, Point, PointSequence, Stop, Values,
    bounds::{Enclosure, FromAbove, FromBelow},
    certify,
};

use super::{Bounds, GlobalMinimum, NOTHING, UsedConstants, in_words};
use crate::{Given, Grid, Proofs, Request, Shape};

const ENCLOSURE: Enclosure = Enclosure {
    lower: 4.0,
    upper: 9.0,
    from_below: FromBelow::Minimum,
    from_above: FromAbove::Length,
    assumes_global_minimum: true,
    is_not_global: false,
    has_known_minimum: false,
    is_local: false,
};

/// Tests claims about a metric in the plane.
fn check_claims(
    claimed: Constants,
    metric: impl Into<Known>,
    sequence: &PointSequence<2>,
) -> Result<(), String> {
    super::check_claims(claimed, &metric.into(), &sequence.clone().into_any())
}

fn bounds(enclosure: Enclosure) -> Bounds {
    let constants = Constants::new(1.0, 2.0, 3.0).expect("constants");
    in_words(enclosure, Some(UsedConstants::new(constants, true, None)), true)
}

/// A root is rounded to nearest, so that it may be on the wrong side.
#[test]
fn roots_are_rounded_outwards() {
    let found = bounds(ENCLOSURE);
    assert!(found.lower.value < 2.0 && found.lower.value > 2.0 - 1e-15);
    assert!(found.upper.value > 3.0 && found.upper.value < 3.0 + 1e-15);
    let touching = bounds(Enclosure { lower: 0.0, upper: 0.0, ..ENCLOSURE });
    assert_eq!([touching.lower.value, touching.upper.value], [0.0, 0.0]);
}

#[test]
fn what_is_known_of_the_minimum_is_said() {
    let known = |assumes_global_minimum, is_not_global| {
        let with = Enclosure { assumes_global_minimum, is_not_global, ..ENCLOSURE };
        bounds(with).global_minimum
    };
    assert_eq!(known(true, false), GlobalMinimum::Assumed);
    assert_eq!(known(false, true), GlobalMinimum::Refuted);
    assert_eq!(known(false, false), GlobalMinimum::NotNeeded);
    for (from_below, found) in [
        (FromBelow::Certificate, GlobalMinimum::NotNeeded),
        (FromBelow::Euclidean, GlobalMinimum::NotNeeded),
        (FromBelow::Nothing, GlobalMinimum::NotNeeded),
        (FromBelow::Minimum, GlobalMinimum::Proved),
        (FromBelow::Convexity, GlobalMinimum::Proved),
    ] {
        let with = Enclosure { assumes_global_minimum: false, from_below, ..ENCLOSURE };
        // Convexity about the shortest curves says nothing of sequences elsewhere.
        assert_eq!(bounds(with).global_minimum, GlobalMinimum::NotNeeded);
        let with = Enclosure { has_known_minimum: true, ..with };
        assert_eq!(bounds(with).global_minimum, found);
        // What did not converge is no minimum.
        let constants = bounds(with).constants;
        assert_eq!(in_words(with, constants, false).global_minimum, GlobalMinimum::NotNeeded);
        let refuted = Enclosure { is_not_global: true, ..with };
        assert_eq!(bounds(refuted).global_minimum, GlobalMinimum::Refuted);
    }
}

/// What no step has led to is no minimum. What stalled may be one, up to rounding.
#[test]
fn a_search_that_ran_out_of_steps_assumes_nothing() {
    let ended = |with: Enclosure, stop| {
        let found = bounds(with).after(stop);
        (found.global_minimum, found.lower.value > 0.0, found.lower_by == NOTHING)
    };
    let assumed = ENCLOSURE;
    assert_eq!(ended(assumed, Stop::IterationLimit), (GlobalMinimum::NotNeeded, false, true));
    for stop in [Stop::Converged, Stop::Stalled] {
        assert_eq!(ended(assumed, stop), (GlobalMinimum::Assumed, true, false));
    }
    // Nothing is assumed of a sequence by a bound for all curves.
    let known = Enclosure { assumes_global_minimum: false, ..ENCLOSURE };
    assert_eq!(ended(known, Stop::IterationLimit), (GlobalMinimum::NotNeeded, true, false));
}

#[test]
fn bounds_that_contradict_each_other_refute_the_claims() {
    let good = bounds(ENCLOSURE);
    assert_eq!(good.clone().without_contradiction(), Ok(good));
    let reason = |bounds: Bounds| bounds.without_contradiction().expect_err("a contradiction");
    let inverted = bounds(Enclosure { lower: 16.0, ..ENCLOSURE });
    let says = "at least 3.9999999999999996, but a curve has length 3.0000000000000004;";
    assert!(reason(inverted).contains(says));
    // Another curve may be what contradicts them, if nothing is assumed of the minimum.
    let proved = bounds(Enclosure { assumes_global_minimum: false, ..ENCLOSURE });
    assert!(reason(proved.and_no_longer_than([1.5].into_iter())).contains("length 1.5;"));
}

/// The least eigenvalue of `(2 1; 1 2)` is 1, and that of a rotation of
/// `diag(1, 10¹²)` is 1 however it rounds.
#[test]
fn claims_that_are_attained_hold() {
    let sequence = PointSequence::straight([0.0, 0.0], [1.0, 1.0], 4).expect("finite");
    let check = |text: &str, c1, c2| {
        let metric = Formula::<2>::parse(text, &[]).expect("a formula").into_any();
        check_claims(Constants::new(c1, c2, 9.0).expect("constants"), metric, &sequence)
    };
    let dense = "[2, 1; 1, 2]";
    assert_eq!(check(dense, 1.0, 3.0), Ok(()));
    assert!(check(dense, 1.0 + 1e-8, 3.0).is_err_and(|why| why.contains("the claim c1 = 1")));
    assert!(check(dense, 1.0, 3.0 - 3e-8).is_err_and(|why| why.contains("the claim c2 = 2")));
    // The entries beside the diagonal differ by a rounding of 10⁶.
    let rounded = "[1e6, x1*0 + (1e6 + 0.3) - 1e6; 0.3, 1e6]";
    assert_eq!(check(rounded, 1e6 - 0.3, 1e6 + 0.3), Ok(()));
    // The sum of the squares of the entries overflows.
    assert_eq!(check("[1e160, 0; 0, 1e160]", 1e160, 1e160), Ok(()));
    // A rotation of diag(1, 10¹²): its least eigenvalue rounds to 1 − 1.2e−4.
    let stretched = "s = 0.36 + 0.64e12; c = 0.48 - 0.48e12; [s, c; c, 0.64 + 0.36e12]";
    assert_eq!(check(stretched, 1.0, 1e12), Ok(()));
    assert!(check(stretched, 1.1, 1e12).is_err());
    assert!(check(stretched, 1.0, 1e12 * (1.0 - 1e-8)).is_err());
}

/// A black box has values in `f64` only, where intervals know nothing. Its claims are tested all the same.
#[test]
fn claims_about_a_black_box_are_tested_by_its_values() {
    struct Identity;
    impl Values for Identity {
        fn gram(&self, x: &[f64]) -> Vec<f64> {
            x.chunks(2).flat_map(|_| [1.0, 0.0, 0.0, 1.0]).collect()
        }
    }
    let metric = BlackBox::<2>::new(Arc::new(Identity), 1e-3).expect("a step");
    let sequence = PointSequence::straight([0.0, 0.0], [1.0, 1.0], 4).expect("finite");
    let check = |c1, c2| {
        let claimed = Constants::new(c1, c2, 0.0).expect("constants");
        check_claims(claimed, metric.clone().into_any(), &sequence)
    };
    assert_eq!(check(1.0, 1.0), Ok(()));
    assert!(check(1.1, 2.0).is_err_and(|why| why.contains("the claim c1 = 1.1")));
    assert!(check(0.5, 0.9).is_err_and(|why| why.contains("the claim c2 = 0.9")));
}

/// `H` is 1 up to rounding at both ends of the curve, and 4 or 1/4 between them.
#[test]
fn claims_that_fail_inside_the_curve_are_refused() {
    let sequence = PointSequence::straight([-8.0, 0.0], [8.0, 0.0], 64).expect("finite");
    let check = |text: &str, c1, c2| {
        let metric = Formula::<2>::parse(text, &[]).expect("a formula").into_any();
        check_claims(Constants::new(c1, c2, 9.0).expect("constants"), metric, &sequence)
    };
    let (hill, valley) = ("(1 + 3*exp(-x1^2)) I", "(1 - 0.75*exp(-x1^2)) I");
    assert_eq!([check(hill, 1.0, 4.0), check(valley, 0.25, 1.0)], [Ok(()), Ok(())]);
    // By steps of 1/4, the first point where H is above 3.
    let why = check(hill, 1.0, 3.0).expect_err("H is 4 in the middle");
    assert!(why.contains("the claim c2 = 3") && why.contains("H([-0.5, 0.0])"), "{why}");
    let why = check(valley, 0.5, 1.0).expect_err("H is 1/4 in the middle");
    assert!(why.contains("the claim c1 = 0.5") && why.contains("smaller"), "{why}");
}

#[test]
fn a_shorter_curve_lowers_the_upper_bound_and_may_refute_the_minimum() {
    let beside = |lengths: &[f64]| bounds(ENCLOSURE).and_no_longer_than(lengths.iter().copied());
    assert_eq!(beside(&[]), bounds(ENCLOSURE));
    assert_eq!(beside(&[3.5, 4.0]), bounds(ENCLOSURE));
    let shorter = beside(&[3.5, 2.5, 2.75]);
    assert_eq!((shorter.upper.value, shorter.global_minimum), (2.5, GlobalMinimum::Assumed));
    assert_eq!(shorter.lower, bounds(ENCLOSURE).lower);
    let refuted = beside(&[1.5]);
    assert_eq!((refuted.lower.value, refuted.upper.value), (0.0, 1.5));
    assert_eq!(refuted.global_minimum, GlobalMinimum::Refuted);
    assert_eq!(refuted.lower_by, NOTHING);
    // Nothing was assumed, so that there is no assumption to refute.
    let proved = bounds(Enclosure { assumes_global_minimum: false, ..ENCLOSURE });
    let beside = proved.clone().and_no_longer_than([1.5].into_iter());
    assert_eq!((beside.global_minimum, beside.lower), (GlobalMinimum::NotNeeded, proved.lower));
}

/// Returns the bounds by claims between the origin and a point at the Euclidean distance 5, in the plane of
/// the first and the last coordinate.
fn by_claims(cost: &str, dimension: usize, c1: f64, c2: f64) -> Result<Bounds, String> {
    let mut far = vec![0.0; dimension];
    (far[0], far[dimension - 1]) = (3.0, 4.0);
    let metric = Given::parse(cost, dimension, &[], &[]).expect("a formula");
    let [from, to] =
        [vec![0.0; dimension], far].map(|x| [Shape::Point(Point::from_slice(&x).expect("finite"))]);
    let request = Request { grid: Grid::Chords(4), ..Request::default() };
    let curve = metric.solve([&from, &to], &request).expect("a curve");
    let claimed = Constants::new(c1, c2, 0.0).and_then(|claimed| claimed.with_m_h(0.0));
    let proofs = Proofs { claimed: claimed.ok(), ..Proofs::default() };
    curve.bounds(&proofs, &|_: certify::Progress| true, &mut |_| ControlFlow::Continue(()))
}

/// Under `H = I` the distance is the Euclidean one. Claims that are attained lead to bounds that are equal up
/// to rounding.
#[test]
fn claims_that_are_attained_give_the_distance_in_many_dimensions() {
    for dimension in [7, 20, 64] {
        let found = by_claims("cost(1)", dimension, 1.0, 1.0).expect("bounds");
        let [lower, upper] = [found.lower.value, found.upper.value];
        // A few roundings of each chord.
        assert!(lower <= 5.0 && lower > 5.0 - 1e-13, "{dimension}: {lower}");
        assert!((5.0..5.0 + 1e-13).contains(&upper), "{dimension}: {upper}");
        assert_eq!(found.upper_by, "the length of the curve");
        assert!(found.rests_on_claims());
    }
}

#[test]
fn wrong_claims_are_refused_in_twenty_dimensions() {
    let why = by_claims("cost(1 + exp(-(x1 - 1.5)^2))", 20, 1.0, 2.0).expect_err("H is nearly 4");
    assert!(why.contains("the claim c2 = 2 is wrong: H([0."), "{why}");
    let why = by_claims("cost(1)", 20, 1.5, 2.0).expect_err("H is 1");
    assert!(why.contains("the claim c1 = 1.5 is wrong: H([0.0, 0.0, "), "{why}");
}
