//! Bad input to the `tautline` crate: each error names the argument and the number, and nothing
//! panics.

use std::fmt::{Debug, Display};

use tautline::{
    AffineSubspace, AxisBox, Ball, Constants, Ends, FiniteSet, HalfSpace, HypothesisError, Metric,
    MetricError, Options, Point, PointSequence, Problem, Rule, SMatrix, SVector, Scalar, Segment,
    SequenceError, SetError, SolveError, Sphere, Starts, Union,
    bounds::{BoundError, Setting},
    gallery::{Constant, GalleryError, Hyperbolic, Valleys},
};

/// Asserts that the message of an error contains all these words.
#[track_caller]
fn assert_names(error: impl Display, words: &[&str]) {
    let message = error.to_string();
    for word in words {
        assert!(message.contains(word), "{message:?} does not name {word:?}");
    }
}

fn ends() -> Ends<2> {
    Ends::points([0.0, 0.0], [3.0, 0.0]).expect("finite")
}

#[test]
fn coordinates_that_are_not_finite_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let number = bad.to_string();
        let words = ["coordinate", number.as_str(), "1"];
        assert_names(Ends::points([0.0, bad], [1.0, 1.0]).expect_err("bad"), &words);
        assert_names(Ends::points([0.0, 0.0], [1.0, bad]).expect_err("bad"), &words);
        assert_names(Point::new([0.0, bad]).expect_err("bad"), &words);
        assert_names(Ball::new([0.0, bad], 1.0).expect_err("bad"), &words);
        assert_names(Sphere::new([0.0, bad], 1.0).expect_err("bad"), &words);
        assert_names(AxisBox::new([0.0, bad], [1.0, 1.0]).expect_err("bad"), &words);
        assert_names(Segment::new([0.0, 0.0], [0.0, bad]).expect_err("bad"), &words);
        assert_names(HalfSpace::new([0.0, bad], 1.0).expect_err("bad"), &words);
        assert_names(FiniteSet::new([[0.0, 0.0], [0.0, bad]]).expect_err("bad"), &words);
        assert_names(AffineSubspace::new([0.0, bad], [[1.0, 0.0]]).expect_err("bad"), &words);
        let points = vec![SVector::from([0.0, 0.0]), SVector::from([0.0, bad])];
        assert_names(PointSequence::new(points).expect_err("bad"), &words);
        assert_names(HalfSpace::new([1.0, 0.0], bad).expect_err("bad"), &["offset", &number]);
        assert_names(Ball::new([0.0, 0.0], bad).expect_err("bad"), &["radius", &number]);
    }
}

/// The metric is `H = [[1, above], [below, 1]]` to the right of the line `x₁ = from` and the unit
/// matrix to the left of it, with a smooth transition.
#[derive(Clone, Copy, Debug)]
struct Defect {
    above: f64,
    below: f64,
    from: f64,
}

impl Metric<2> for Defect {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        // The factor rises from 0 to 1 within 0.1; it is one half at x₁ = from.
        let on = ((x[0] - self.from) * 40.0).tanh() * 0.5 + 0.5;
        SMatrix::<S, 2, 2>::new(S::one(), on * self.above, on * self.below, S::one())
    }
}

fn refusal(metric: impl Metric<2> + Debug, n: usize) -> MetricError {
    let problem = Problem::new(metric, ends());
    let trapezoidal = problem.solve(Rule::TRAPEZOIDAL, n).expect_err("no metric");
    let left = problem.solve(Rule::LEFT_ENDPOINT, n).expect_err("no metric");
    assert_eq!(std::mem::discriminant(&trapezoidal), std::mem::discriminant(&left));
    match trapezoidal {
        SolveError::Metric(error) => error,
        other => panic!("{other:?} is another error"),
    }
}

#[test]
fn an_asymmetric_metric_is_refused() {
    for from in [-9.0, 1.5] {
        let error = refusal(Defect { above: 0.5, below: 0.25, from }, 16);
        let MetricError::NotSymmetric { point, row: 0, column: 1, above, below } = &error else {
            panic!("{error:?}");
        };
        assert!(point[0] >= from - 0.5 && above > below);
        assert_names(&error, &["not symmetric", &above.to_string(), &below.to_string()]);
    }
}

#[test]
fn an_indefinite_metric_is_refused() {
    // The defect is everywhere, and the least eigenvalue is 1 − 2.
    let error = refusal(Defect { above: 2.0, below: 2.0, from: -9.0 }, 16);
    let MetricError::NotPositiveDefinite { eigenvalue, .. } = &error else { panic!("{error:?}") };
    approx::assert_relative_eq!(*eigenvalue, -1.0, max_relative = 1e-14);
    assert_names(&error, &["not positive definite", &eigenvalue.to_string()]);
    // Every curve to the second end passes through the defect.
    let error = refusal(Defect { above: 2.0, below: 2.0, from: 1.5 }, 16);
    let MetricError::NotPositiveDefinite { point, eigenvalue } = &error else {
        panic!("{error:?}");
    };
    assert!(point[0] > 1.0 && *eigenvalue <= 0.0);
}

/// `H = √(1 − x₁) I` is NaN for `x₁ > 1`, and every curve enters that half-plane.
#[derive(Clone, Copy, Debug)]
struct Cliff;

impl Metric<2> for Cliff {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element((-x[0] + 1.0).sqrt())
    }
}

#[test]
fn a_metric_that_becomes_nan_on_the_way_is_refused() {
    for n in [1, 2, 16, 200] {
        let problem = Problem::new(Cliff, ends());
        let error = problem.solve(Rule::TRAPEZOIDAL, n).expect_err("no metric");
        let SolveError::Metric(MetricError::NotFinite { point, entry, .. }) = &error else {
            panic!("{error:?}");
        };
        assert!(point[0] > 1.0 && entry.is_nan());
        assert_names(&error, &["NaN", &point[0].to_string(), "finite"]);
    }
    // The hyperbolic plane ends at the unit circle, where `H` changes sign or is infinite.
    let beyond = Ends::points([0.0, 0.0], [1.5, 0.0]).expect("finite");
    let error = Problem::new(Hyperbolic, beyond).solve(Rule::TRAPEZOIDAL, 32);
    assert!(matches!(error, Err(SolveError::Metric(_))), "{error:?}");
}

/// `H = (1 + 1/(r² − ¼)²) I` outside the disc of radius ½. On the rim `H` is infinite, and inside
/// the disc, where the straight line passes, it is NaN.
#[derive(Clone, Copy, Debug)]
struct Hole;

impl Metric<2> for Hole {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let height = x[0].sqr() + x[1].sqr() - 0.25;
        // h⁻² is computed from the square root, which is NaN for a negative number.
        SMatrix::from_diagonal_element(height.sqrt().powi(-4) + 1.0)
    }
}

#[test]
fn a_curve_goes_round_a_hole_in_the_metric() {
    let ends = Ends::points([-2.0, 0.0], [2.0, 0.0]).expect("finite");
    let line = Problem::new(Hole, ends).solve(Rule::TRAPEZOIDAL, 128).expect("a way round");
    assert!(line.minimum().is_local_minimum(), "{:?}", line.minimum().stop);
    assert!(line.sequence().points().iter().all(|x| x.norm() > 0.5));
    assert!(line.energy().value > 16.0 && line.energy().value.is_finite());
}

#[test]
fn no_subinterval_is_refused() {
    let error = Problem::new(Valleys, ends()).solve(Rule::TRAPEZOIDAL, 0).expect_err("N = 0");
    assert_eq!(error, SolveError::NoSubinterval);
    assert_names(error, &["N = 0"]);
    let refused = |points| SequenceError::NoSubinterval { points };
    assert_eq!(PointSequence::straight([0.0], [1.0], 0), Err(refused(1)));
    assert_eq!(PointSequence::<2>::new(Vec::new()), Err(refused(0)));
}

#[test]
fn nothing_to_start_from_is_an_error() {
    let options = Options { starts: Starts::Only(Vec::new()), ..Options::default() };
    let error = Problem::new(Valleys, ends()).solve_with(Rule::TRAPEZOIDAL, 8, &options);
    assert_eq!(error.expect_err("no start"), SolveError::NoStart);
}

#[test]
fn empty_sets_are_refused() {
    let none: [[f64; 2]; 0] = [];
    assert!(matches!(FiniteSet::new(none), Err(SetError::Empty)));
    let error = Union::<2>::new(Vec::new()).expect_err("empty");
    assert_names(error, &["empty"]);
    let crossed = AxisBox::from_corners([0.0, 2.0], [1.0, 1.5]).expect_err("empty");
    assert_eq!(crossed, SetError::CrossedCorners { index: 1, lower: 2.0, upper: 1.5 });
}

#[test]
fn two_unbounded_sets_are_refused() {
    let wall = |offset| HalfSpace::at_least([1.0, 0.0], offset).expect("a normal");
    let error = Ends::new(wall(0.0), wall(1.0)).expect_err("unbounded");
    assert_eq!(error, SetError::BothUnbounded);
    assert_names(error, &["both", "unbounded", "Proposition 7.1"]);
}

#[test]
fn negative_sizes_and_zero_normals_are_refused() {
    let ball = Ball::new([0.0, 0.0], -0.5).expect_err("negative");
    let sphere = Sphere::new([0.0, 0.0], -0.5).expect_err("negative");
    for error in [ball, sphere] {
        assert_eq!(error, SetError::NegativeRadius { radius: -0.5 });
        assert_names(error, &["radius", "-0.5"]);
    }
    let error = AxisBox::new([0.0, 0.0], [1.0, -0.25]).expect_err("negative");
    assert_eq!(error, SetError::NegativeHalfWidth { index: 1, half_width: -0.25 });
    assert_names(error, &["half-width", "-0.25"]);
    let error = HalfSpace::new([0.0, 0.0], 1.0).expect_err("zero");
    assert_eq!(error, SetError::ZeroNormal);
    assert_names(error, &["normal", "0"]);
}

#[test]
fn constants_that_bound_nothing_are_refused() {
    for c1 in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = Constants::new(c1, 2.0, 1.0).expect_err("c1");
        assert!(matches!(error, HypothesisError::NotCoercive { .. }));
        assert_names(error, &["c1", &c1.to_string(), "Theorem 1.1"]);
    }
    for c2 in [0.5, f64::NAN, f64::INFINITY] {
        let error = Constants::new(1.0, c2, 1.0).expect_err("c2");
        assert!(matches!(error, HypothesisError::CrossedBounds { c1: 1.0, .. }));
        assert_names(error, &["c2", &c2.to_string()]);
    }
    for l_h in [-1.0, f64::NAN, f64::INFINITY] {
        assert_names(Constants::new(1.0, 2.0, l_h).expect_err("L_H"), &["L_H", &l_h.to_string()]);
    }
    let constants = Constants::new(1.0, 2.0, 1.0).expect("in order");
    assert_eq!(Setting::new(constants, -1.0, 2), Err(BoundError::NotADistance { distance: -1.0 }));
    assert_eq!(Setting::new(constants, 1.0, 0), Err(BoundError::NoDimension));
    let indefinite = SMatrix::<f64, 2, 2>::new(1.0, 2.0, 2.0, 1.0);
    let error = Constant::new(indefinite).expect_err("indefinite");
    assert!(matches!(error, GalleryError::Matrix(MetricError::NotPositiveDefinite { .. })));
}
