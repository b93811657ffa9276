//! Proofs for metrics whose distances are known, and metrics without one.

use std::{ops::ControlFlow, sync::Mutex};

use tautline_bounds::LocalityError;
use tautline_certify::{Accuracy, CurveError, Progress, Quantity};
use tautline_formula::RecordError;
use tautline_metrics::gallery::{GaussianFisher, Hyperbolic, Shear, Sphere, Valleys};
use tautline_metrics::{Bounded, KnownDistance, LocalError, Metric};
use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace};

use super::ProofError;
use crate::{Interval, Problem, Rule, SMatrix, SVector, Scalar};

/// Every known distance lies between the bounds.
#[test]
fn distances_are_enclosed_by_the_formula_alone() {
    fn check<M: KnownDistance<2>>(metric: M, a: [f64; 2], b: [f64; 2], width: f64) {
        let d = metric.distance(&a.into(), &b.into()).expect("known");
        let ends = Ends::points(a, b).expect("finite");
        let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
        let proof = line.prove(Accuracy::default()).expect("proved");
        let (lower, upper) = (proof.enclosure.lower, proof.enclosure.upper);
        assert!(lower <= d * d && d * d <= upper, "{lower} {} {upper}", d * d);
        assert!(upper - lower <= width * d * d, "{lower} {upper}");
        assert!(!proof.enclosure.assumes_global_minimum);
        assert_eq!(proof.constants.is_local(), proof.within.is_some());
        assert_eq!(upper, proof.curve.distance_squared_at_most());
    }
    let shear = Shear::new(0.3, 1.0).expect("a wave number");
    check(shear, [0.0, 0.0], [0.3, 0.2], 1e-2);
    check(Sphere, [0.3, 0.1], [0.45, 0.2], 1e-2);
    check(Hyperbolic, [0.1, 0.0], [0.15, 0.1], 1e-2);
    check(GaussianFisher, [0.0, 0.0], [0.1, 0.1], 1e-2);
}

/// The upper bound agrees with a quadrature, which is not rigorous.
#[test]
fn the_upper_bound_is_that_of_the_curve() {
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a normal");
    let ends = Ends::new(ball, wall).expect("bounded");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let proof = line.prove(Accuracy::default()).expect("proved");
    let length = line.length().value;
    assert!((proof.enclosure.upper / (length * length) - 1.0).abs() < 1e-12);
    assert_eq!(proof.enclosure.upper, proof.curve.distance_squared_at_most());
    let stated = Bounded::<2>::constants(&Valleys);
    assert!(proof.constants.l_h() >= stated.l_h() && proof.within.is_none());
    assert!(line.admissible_curve().is_ok_and(|curve| curve.length().contains(length)));
}

/// The line runs from the pole of the sphere, where the derivative vanishes, to a wall. The
/// ball is centred at the pole.
#[test]
fn a_line_from_a_point_where_the_derivative_vanishes_is_proved() {
    let pole = Ball::new([0.0, 0.0], 0.0).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 0.1).expect("a normal");
    let ends = Ends::new(pole, wall).expect("bounded");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let proof = line.prove(Accuracy::default()).expect("proved");
    let (lower, upper) = (proof.enclosure.lower, proof.enclosure.upper);
    // H = 4 / (1 + |x|²)², so d = 2 arctan 0.1, attained by the straight line along x₁.
    let square = (2.0 * 0.1_f64.atan()).powi(2);
    assert!(lower <= square && square <= upper, "{lower} {square} {upper}");
    assert!(proof.within.is_some() && proof.enclosure.is_local);
}

/// The nodes of two chords lie in valleys, with ridges between them, so that the discrete
/// energy is a quarter of the squared length. A competitor may be as long as the curve.
#[test]
fn the_ball_reaches_as_far_as_the_curve_is_long() {
    struct Ridges;
    impl Metric<1> for Ridges {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let ridges = (x[0] * (4.0 * std::f64::consts::PI)).cos() + 2.0;
            // The metric is not periodic, and therefore has constants on balls only.
            SMatrix::from_element(ridges.sqr() + x[0].sqr() * 1e-3)
        }
    }
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(Ridges, ends).solve(Rule::TRAPEZOIDAL, 2).expect("solved");
    let proof = line.prove(Accuracy::default()).expect("proved");
    let ball = proof.within.expect("no constants on all of space");
    let length = proof.curve.length().hi();
    assert!(line.discrete_energy() < 0.3 * length * length);
    assert!(ball.r() >= length / proof.constants.c1().sqrt(), "{ball:?} for {length}");
    assert_eq!(proof.enclosure.upper, proof.curve.distance_squared_at_most());
}

/// The set knows its point only to within 1/20. Every claim holds for the longest possible
/// curve.
#[test]
fn the_longest_possible_curve_counts() {
    #[derive(Debug)]
    struct About(SVector<f64, 2>);
    impl ClosedSet<2> for About {
        fn project(&self, _: &SVector<f64, 2>) -> SVector<f64, 2> {
            self.0
        }
        fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::zeros()
        }
        fn radius(&self) -> Option<f64> {
            Some(self.0.norm())
        }
        fn enclosing_ball(&self) -> Option<(SVector<f64, 2>, f64)> {
            Some((self.0, 0.0))
        }
        fn member_near(&self, _: &SVector<f64, 2>) -> Option<SVector<Interval, 2>> {
            Some(self.0.map(|c| Interval::new(c - 0.05, c + 0.05).expect("in order")))
        }
    }
    let points = [[0.3, 0.1], [0.45, 0.1]].map(|x| About(x.into()));
    let [first, second] = points;
    let ends = Ends::new(first, second).expect("bounded");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 16).expect("solved");
    let proof = line.prove(Accuracy::default()).expect("proved");
    let length = proof.curve.length();
    assert!(length.hi() > 1.5 * length.lo() && length.contains(line.length().value));
    let upper = proof.enclosure.upper;
    assert!(upper >= length.hi() * length.hi() * (1.0 - 1e-15));
    // From below the energy of the shortest possible curve counts.
    let (extent, energy) = (line.proved_extent(&proof.curve), proof.curve.energy());
    assert!(extent.energy_at_least <= energy.lo() && energy.hi() <= extent.energy);
    assert!(energy.lo() < 0.5 * energy.hi() && length.hi() <= extent.length);
    let ball = proof.within.expect("no constants on all of space");
    let half = 0.5 * length.hi() / proof.constants.c1().sqrt();
    assert!(ball.r() >= half, "{ball:?} for {length:?}");
}

#[test]
fn an_impossible_proof_is_an_error() {
    let ends = Ends::points([0.1, 0.0], [0.2, 0.1]).expect("finite");
    let near = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    let error = near.prove(Accuracy { budget: 0, ..Accuracy::default() }).expect_err("no boxes");
    assert!(error.to_string().contains("after 0 boxes"), "{error}");
    let error = near.prove(Accuracy { tolerance: 0.0, ..Accuracy::default() }).expect_err("exact");
    assert!(error.to_string().contains("tolerance of 0"), "{error}");
    // Across the sphere, competitors may pass through infinity.
    let ends = Ends::points([1.0, 0.0], [-1.5, 0.3]).expect("finite");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let accuracy = Accuracy { budget: 2_000, ..Accuracy::default() };
    let error = line.prove(accuracy).expect_err("no ball");
    let expected = matches!(
        error,
        ProofError::Competitors(
            LocalityError::Escapes { .. }
                | LocalityError::NoConstants { reason: LocalError::NotProved { .. }, .. }
        )
    );
    assert!(expected, "{error}");
    // This line leaves the domain of the metric.
    struct Left;
    impl Metric<1> for Left {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            // Within 0.0006 of 0.1 this is the logarithm of a negative number. From 0.006 on it
            // is 1 up to rounding. Nodes and quadrature points stay 0.04 away.
            let dip = 1.5 * (-((x[0] - 0.1) * 1e3).sqr()).exp();
            SMatrix::from_element(1.0 + (1.0 - dip).ln())
        }
    }
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(Left, ends).solve(Rule::TRAPEZOIDAL, 2).expect("solved");
    let error = line.prove(accuracy).expect_err("undefined");
    assert!(matches!(error, ProofError::Curve(CurveError::Undefined { .. })), "{error}");
}

/// In interval arithmetic, only one of several branches would be followed.
#[test]
fn a_formula_with_branches_has_no_proof() {
    struct Branch;
    impl Metric<1> for Branch {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_element(if x[0].is_zero() { S::one() } else { x[0].cos() + 3.0 })
        }
    }
    let ends = Ends::points([0.1], [1.0]).expect("finite");
    let line = Problem::new(Branch, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    let refused = ProofError::Curve(CurveError::NotRecorded(RecordError::Compares));
    assert_eq!(line.prove(Accuracy::default()).map(|_| ()), Err(refused));
}

/// The left-endpoint rule does not need `M_H` between two sets: it is not searched for, and the
/// bounds are the same.
#[test]
fn m_h_is_proved_only_where_it_is_used() {
    fn check<M: Metric<2>>(metric: M, ends: Ends<2>, rule: Rule, needs_m_h: bool) {
        let line = Problem::new(metric, ends).solve(rule, 64).expect("solved");
        let seen = Mutex::new(Vec::new());
        let watch = |progress: Progress| {
            seen.lock().expect("no panic").push(progress.quantity);
            true
        };
        let accuracy = Accuracy { tolerance: 1e-4, ..Accuracy::default() };
        let proof = line
            .prove_watched(accuracy, &watch, &mut |_| ControlFlow::Continue(()))
            .expect("proved");
        assert_eq!(proof.constants.m_h().is_some(), needs_m_h);
        let seen = seen.into_inner().expect("no panic");
        assert!(seen.contains(&Quantity::LH));
        assert!(needs_m_h || !seen.contains(&Quantity::MH));
        // Any M_H leaves the bounds as they are.
        let extent = line.extent();
        let with = proof.constants.with_m_h(proof.constants.m_h().unwrap_or(0.0));
        let [with, without] = [with.expect("a constant"), proof.constants]
            .map(|constants| line.enclosure_by(constants, extent));
        assert_eq!(with, without);
    }
    let ball = |x: f64| Ball::new([x, 0.1], 0.01).expect("a radius");
    let sets = || Ends::new(ball(0.3), ball(0.45)).expect("bounded");
    let points = || Ends::points([0.3, 0.1], [0.4, 0.1]).expect("finite");
    let shear = || Shear::new(0.3, 1.0).expect("a wave number");
    check(Sphere, sets(), Rule::LEFT_ENDPOINT, false);
    check(Sphere, sets(), Rule::TRAPEZOIDAL, true);
    check(Sphere, points(), Rule::LEFT_ENDPOINT, true);
    check(shear(), sets(), Rule::LEFT_ENDPOINT, false);
    check(Valleys, sets(), Rule::LEFT_ENDPOINT, false);
}

/// A search that is ended counts with what it has found.
#[test]
fn a_proof_that_is_ended_has_wider_bounds() {
    let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let accuracy = Accuracy { tolerance: 1e-9, budget: 100_000 };
    let stop = &mut |_| ControlFlow::Break(());
    let ended = line.prove_watched(accuracy, &|_: Progress| false, stop).expect("proved");
    let close = line.prove(accuracy).expect("proved");
    assert!(ended.constants.l_h() > close.constants.l_h());
    assert!(ended.constants.c1() <= close.constants.c1());
    assert!(0.0 < ended.enclosure.lower && ended.enclosure.lower < close.enclosure.lower);
}

/// The budget is spent long before the tolerance is reached, on all of space and on a ball.
#[test]
fn a_small_budget_gives_wider_bounds() {
    let check = |wide: Result<_, ProofError>, close: Result<_, ProofError>| {
        let [wide, close]: [super::Proof<'_, 2>; 2] =
            [wide, close].map(|proof| proof.expect("proved"));
        assert_eq!(wide.within.is_some(), close.within.is_some());
        assert!(wide.constants.c1() <= close.constants.c1());
        assert!(wide.constants.l_h() > close.constants.l_h());
        // A certificate does not depend on the constants.
        assert!(wide.enclosure.lower < close.enclosure.lower || wide.found.is_some());
        assert_eq!(wide.enclosure.upper, close.enclosure.upper);
    };
    let few = Accuracy { tolerance: 1e-9, budget: 300 };
    let ends = Ends::points([0.3, 0.1], [0.45, 0.2]).expect("finite");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    check(line.prove(few), line.prove(Accuracy::default()));
    let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let few = Accuracy { tolerance: 1e-9, budget: 30 };
    check(line.prove(few), line.prove(Accuracy::default()));
}
