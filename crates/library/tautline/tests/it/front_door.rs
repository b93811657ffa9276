//! What a new user meets first: a formula as on paper, and errors for bad input.

use tautline::{
    Ends, LARGEST_N, Metric, MetricError, Options, PointSequence, Problem, Rule, SMatrix, SVector,
    Scalar, SequenceError, SolveError, Starts, gallery::Valleys, solve_all,
};

/// `f² I` with `f = 2 − cos x₁`, like [`Valleys`] of the gallery, with numbers on the left.
struct OnPaper;

impl Metric<2> for OnPaper {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let f = 2.0 - x[0].cos();
        // Terms that cancel: all four operators, also by reference.
        let twice = 2.0 * f;
        let again = 1.0 / (1.0 / twice);
        SMatrix::from_diagonal_element((1.0 + (again - f) - 1.0 + 0.0 * &f).sqr())
    }
}

#[test]
fn a_formula_may_have_numbers_on_the_left() {
    let ends = || Ends::points([0.0, 0.0], [2.0, 1.5]).expect("finite");
    let energy = |n| {
        let own = Problem::new(OnPaper, ends()).solve(Rule::TRAPEZOIDAL, n).expect("a metric");
        let gallery = Problem::new(Valleys, ends()).solve(Rule::TRAPEZOIDAL, n).expect("a metric");
        (own.discrete_energy(), gallery.discrete_energy())
    };
    for n in [8, 512] {
        let (own, gallery) = energy(n);
        // About ten roundings of the formula, each at most 4 ε of f.
        assert!((own / gallery - 1.0).abs() < 1e-14, "{own} {gallery}");
    }
}

/// On eight chords the speeds of a minimiser of the left-endpoint rule differ by some per cent; at
/// constant speed they differ as little as fine chords resolve, `O(1/N²)`.
#[test]
fn a_line_is_resampled_at_constant_speed() {
    let ends = Ends::points([0.0, 0.0], [2.0, 1.5]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Rule::LEFT_ENDPOINT, 8).expect("a metric");
    let spread = |sequence: &PointSequence<2>| {
        let speeds = Rule::TRAPEZOIDAL.speeds(&Valleys, sequence);
        let slowest = speeds.iter().copied().fold(f64::INFINITY, f64::min);
        speeds.iter().copied().fold(0.0, f64::max) / slowest - 1.0
    };
    let fine = line.resampled(800).expect("a metric");
    // The chords that cut one of the seven corners are shorter, by the square of half the angle.
    assert!(spread(line.sequence()) > 0.03, "{}", spread(line.sequence()));
    assert!(spread(&fine) < 0.01, "{}", spread(&fine));
    assert_eq!((fine.first(), fine.last()), (line.sequence().first(), line.sequence().last()));
    assert_eq!(line.resampled(0), Err(SequenceError::NoSubinterval { points: 1 }));
}

#[test]
fn too_many_subintervals_are_an_error() {
    fn refused<const D: usize>(n: usize) {
        let flat = tautline::gallery::Constant::<D>::new(SMatrix::identity()).expect("definite");
        let problem = Problem::new(flat, Ends::points([0.0; D], [1.0; D]).expect("finite"));
        let too_many = SolveError::TooManySubintervals { n };
        assert_eq!(problem.solve(Rule::TRAPEZOIDAL, n).map(|_| ()), Err(too_many.clone()));
        let problems = vec![problem.clone(), problem];
        for line in solve_all(&problems, Rule::LEFT_ENDPOINT, n, &Options::default()) {
            assert_eq!(line.map(|_| ()), Err(too_many.clone()));
        }
        let line = PointSequence::straight([0.0; D], [1.0; D], n);
        assert_eq!(line.map(|_| ()), Err(SequenceError::TooManySubintervals { n }));
    }
    for n in [1_000_000_000, usize::MAX] {
        refused::<1>(n);
        refused::<64>(n);
    }
    const { assert!(LARGEST_N < 1_000_000_000) };
}

#[test]
fn sixty_four_chords_suffice_for_an_estimate_of_the_distance() {
    let ends = Ends::points([0.0, 0.0], [2.0, 1.5]).expect("finite");
    let problem = Problem::new(Valleys, ends);
    let estimate = |n| {
        let line = problem.solve(Rule::TRAPEZOIDAL, n).expect("a metric");
        line.distance_squared_estimate().expect("several grids")
    };
    let (small, fine) = (estimate(64), estimate(2048));
    // Within its error: the second order in 1/N is eliminated.
    assert!((small.value - fine.value).abs() <= small.error, "{small:?} {fine:?}");
    assert!((small.value - fine.value).abs() <= 1e-5 * fine.value, "{small:?} {fine:?}");
}

/// `1 − (3/2) e^{−((x₁ − c)/w)²}` times the identity: not positive within `0.6 w` of `c`.
struct Dip {
    centre: f64,
}

impl Metric<2> for Dip {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let distance = (x[0] - self.centre) / 0.02;
        SMatrix::from_diagonal_element(1.0 - 1.5 * (-distance.sqr()).exp())
    }
}

/// Four chords evaluate the metric at 1/8, 3/8, … and miss where it is negative; the length would
/// be NaN.
#[test]
fn a_metric_that_is_negative_between_nodes_is_an_error_with_the_point() {
    for centre in [0.22, 0.53, 0.97] {
        let line = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 4).expect("finite");
        // The nearest node is 0.095 away from the centre: (3/2) e^(−4.75²) = 2.4e-10.
        assert!((Rule::TRAPEZOIDAL.energy(&Dip { centre }, &line) - 1.0).abs() < 2.4e-10);
        let ends = Ends::points([0.0, 0.0], [1.0, 0.0]).expect("finite");
        let options = Options { starts: Starts::Only(vec![line]), ..Options::default() };
        let problem = Problem::new(Dip { centre }, ends);
        for result in [
            problem.solve_with(Rule::TRAPEZOIDAL, 4, &options),
            problem.solve(Rule::TRAPEZOIDAL, 4),
        ] {
            match result.map(|line| line.length()) {
                Err(SolveError::Metric(MetricError::NotPositiveDefinite { point, eigenvalue })) => {
                    assert!((point[0] - centre).abs() < 0.02 && eigenvalue <= 0.0, "{point:?}");
                }
                other => panic!("{other:?}"),
            }
        }
    }
}
