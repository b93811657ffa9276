//! Constraints that no curve between two points satisfies, and others that are no constraints.

use tautline::{PointSequence, Rule, SMatrix, SVector, Scalar, gallery::Constant};
use tautline_baselines::descent::{Constrained, ConstrainedError, Ended, Equality};

use crate::constrained::descend;

const FEASIBILITY: f64 = 1e-9;

fn solve<const D: usize>(
    start: PointSequence<D>,
    constraint: &impl Equality<D>,
    feasibility: f64,
) -> Result<Constrained<D>, ConstrainedError> {
    let metric = Constant::new(SMatrix::<f64, D, D>::identity()).expect("definite");
    descend(metric, Rule::TRAPEZOIDAL, start, constraint, feasibility)
}

pub(crate) struct TwoSpheres;

impl Equality<3> for TwoSpheres {
    fn value<S: Scalar>(&self, x: &SVector<S, 3>) -> S {
        let square = x[0].sqr() + x[1].sqr() + x[2].sqr();
        (square - 1.0) * (square - 4.0)
    }
}

/// From one sphere to another there is a sequence, but no curve: its points satisfy the constraint,
/// and one of its chords crosses the gap.
#[test]
fn between_two_spheres_a_chord_leaps() {
    for n in [2, 3, 10, 41, 200] {
        let start = PointSequence::straight([1.0, 0.0, 0.0], [0.0, 2.0, 0.0], n).expect("finite");
        let found = solve(start, &TwoSpheres, FEASIBILITY).expect("a metric");
        let Ended::Leaping { chord } = found.descended.ended else { panic!("{n}: {found:?}") };
        assert!(found.violation <= FEASIBILITY, "{n}: {:e}", found.violation);
        let (from, step) = found.descended.sequence.chord(chord);
        // The spheres have the distance 1, and the points are on them up to 1e-9.
        assert!((from.norm() - 1.0).abs() < 1e-8, "{n}: {from}");
        assert!(((from + step).norm() - 2.0).abs() < 1e-8, "{n}: {step}");
        assert!(found.descended.iterations < 250, "{n}: {}", found.descended.iterations);
    }
}

/// Two walls, `x₁ = ±1`. Between them the constraint has a local minimum, of 0.2.
struct Trough;

impl Equality<2> for Trough {
    fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
        (-x[0].sqr() + 1.0) * (x[0].sqr() + 0.2)
    }
}

/// Points in the trough cannot leave it without a larger violation.
#[test]
fn a_violation_that_no_small_move_lowers_is_called_infeasible() {
    for n in [2, 3, 10, 41, 200] {
        let start = PointSequence::straight([-1.0, 0.0], [1.0, 2.0], n).expect("finite");
        let found = solve(start, &Trough, FEASIBILITY).expect("a metric");
        let what = format!("{n}: {:?} after {}", found.descended.ended, found.descended.iterations);
        assert_eq!(found.descended.ended, Ended::Infeasible, "{what}");
        // A point in the trough has c ≥ 1/5 and |∇c| ≤ 10⁻⁴ |c|/ℓ, with the length ℓ > 2 of the
        // curve. As c = (1 − x²)(1/5 + x²) has the second derivative 8/5, c − 1/5 is at most
        // (10⁻⁵)²/3.
        assert!((found.violation - 0.2).abs() < 1e-10, "{what}: {:e}", found.violation);
        assert!(found.descended.iterations < 250, "{what}");
    }
}

/// On a half turn around the centre of a sphere the straight line has a point where the constraint
/// is stationary, and a maximum.
#[test]
fn a_line_through_the_centre_of_a_sphere_is_not_called_stationary() {
    struct UnitSphere;
    impl Equality<2> for UnitSphere {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            x[0].sqr() + x[1].sqr() - 1.0
        }
    }
    for n in [2, 3, 8, 9] {
        let start = PointSequence::straight([-1.0, 0.0], [1.0, 0.0], n).expect("finite");
        let ended = solve(start, &UnitSphere, FEASIBILITY).expect("a metric").descended.ended;
        assert!(matches!(ended, Ended::Infeasible | Ended::Leaping { .. }), "{n}: {ended:?}");
    }
}

/// `c(x) = x₁² + 1` has no zero, so that no end satisfies it.
#[test]
fn a_constraint_without_zeros_is_an_error_at_the_first_end() {
    struct NoZero;
    impl Equality<2> for NoZero {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            x[0].sqr() + 1.0
        }
    }
    let start = PointSequence::straight([0.5, 0.0], [1.0, 2.0], 8).expect("finite");
    let expected = ConstrainedError::End { end: "first", value: 1.25, feasibility: FEASIBILITY };
    assert_eq!(solve(start, &NoZero, FEASIBILITY), Err(expected));
}

/// Where the constraint says nothing, the minimum is that without one.
#[test]
fn a_constraint_that_always_holds_is_none() {
    struct Nothing;
    impl Equality<2> for Nothing {
        fn value<S: Scalar>(&self, _: &SVector<S, 2>) -> S {
            S::constant(0.0)
        }
    }
    let bent = [[0.0, 0.0], [2.5, 0.5], [3.0, 1.9], [3.0, 4.0]].map(SVector::from);
    let start = PointSequence::new(bent.to_vec()).expect("finite");
    let found = solve(start, &Nothing, FEASIBILITY).expect("a metric");
    assert_eq!(found.descended.ended, Ended::Stationary, "{found:?}");
    // The square of the distance 5, from a residual of at most 1e-7.
    assert!((found.descended.energy - 25.0).abs() < 1e-12, "{found:?}");
}

/// Where values have steps of `10⁻⁸`, energies and forces hide in them, and no step is seen to
/// descend.
#[test]
fn a_constraint_of_few_digits_ends_a_descent_soon() {
    struct Coarse;
    impl Equality<2> for Coarse {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            (x[0].sqr() + x[1].sqr() * 0.9 + 3e7) - 3e7 - 0.97
        }
    }
    let end = |x: f64| [x, ((0.97 - x * x) / 0.9).sqrt()];
    let start = PointSequence::straight(end(-0.9), end(0.9), 50).expect("finite");
    let run = |feasibility| solve(start.clone(), &Coarse, feasibility).expect("a metric").descended;
    // A thousand steps of the value are enough to see.
    let found = run(1e-4);
    assert_eq!(found.ended, Ended::Stationary, "{found:?}");
    let found = run(1e-7);
    assert_eq!(found.ended, Ended::Stalled, "{found:?}");
    assert!(found.iterations < 50, "{}", found.iterations);
}

/// The root is no number to the left of the line `x₁ = 1`.
struct Root;

impl Equality<2> for Root {
    fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
        (x[0] - 1.0).sqrt() * (x[1] - x[0] * 0.5)
    }
}

#[test]
fn a_constraint_that_is_no_number_is_an_error_with_its_point() {
    let bent = [[2.0, 1.0], [0.5, 0.5], [3.0, 1.5], [4.0, 2.0]].map(SVector::from);
    let start = PointSequence::new(bent.to_vec()).expect("finite");
    let refused = solve(start, &Root, FEASIBILITY);
    let Err(ConstrainedError::NotFinite { point: 1, value, .. }) = refused else {
        panic!("{refused:?}")
    };
    assert!(value.is_nan());
    // At x₁ = 1 the value is 0, and the slope is not finite.
    let straight = PointSequence::straight([1.0, 0.5], [3.0, 1.5], 4).expect("finite");
    let refused = solve(straight, &Root, FEASIBILITY);
    let Err(ConstrainedError::NotFinite { point: 0, .. }) = refused else { panic!("{refused:?}") };
}

/// A step to where the constraint is no number is shortened.
#[test]
fn a_descent_stays_where_the_constraint_is_a_number() {
    struct Ring;
    // The circle |x| = 1, with a root that is no number inside |x| < 9/10.
    impl Equality<2> for Ring {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            (x[0].sqr() + x[1].sqr() - 0.81).sqrt() - 0.19_f64.sqrt()
        }
    }
    let n = 20;
    let at = |k: usize| {
        let angle = k as f64 * (2.0 / n as f64);
        let radius = 1.0 + angle * (2.0 - angle);
        SVector::from([radius * angle.cos(), radius * angle.sin()])
    };
    let start = PointSequence::new((0..=n).map(at).collect()).expect("finite");
    let found = solve(start, &Ring, FEASIBILITY).expect("a metric");
    assert_eq!(found.descended.ended, Ended::Stationary, "{found:?}");
    let expected = (2.0 * n as f64 * (1.0 / n as f64).sin()).powi(2);
    let error = found.descended.energy / expected - 1.0;
    // A violation v moves a point by √0.19 v, as |∇c| = 1/√0.19 there; relative to the radius chords
    // shorten by as much, and the energy by twice that.
    assert!(error.abs() < 2.0 * 0.19_f64.sqrt() * FEASIBILITY, "{error:e}");
}

#[test]
fn a_feasibility_below_zero_is_an_error_and_zero_is_not() {
    for wrong in [-1e-9, f64::NAN] {
        let start = PointSequence::straight([2.0, 1.0], [4.0, 2.0], 4).expect("finite");
        let refused = solve(start, &Root, wrong);
        let Err(ConstrainedError::Feasibility { feasibility }) = refused else {
            panic!("{refused:?}")
        };
        assert_eq!(feasibility.to_bits(), wrong.to_bits());
    }
    // What the rounding of a point causes is no violation.
    let bent = [[2.0, 1.0], [2.5, 0.5], [3.0, 1.9], [4.0, 2.0]].map(SVector::from);
    let start = PointSequence::new(bent.to_vec()).expect("finite");
    let found = solve(start, &Root, 0.0).expect("a metric");
    assert_eq!(found.descended.ended, Ended::Stationary, "{found:?}");
    // Values up to 4 and slopes up to 2, rounded a few times.
    assert!(found.violation <= 1e-14, "{:e}", found.violation);
}
