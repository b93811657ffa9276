//! Enclosures of known distances, and suggested grids.

use std::sync::Arc;

use tautline_bounds::{
    BoundError, Computed, Constants, DiscreteMinimum, FromBelow, PaperRule, Setting, enclose,
    suggest_n,
};
use tautline_discretizations::PointSequence;
use tautline_formula::Prepared;
use tautline_metrics::gallery::{Constant, Separable, Shear, Valleys};
use tautline_metrics::{Bounded, KnownDistance, Metric};
use tautline_sets::{Ball, Ends};

use super::RuleOfThePaper;
use crate::{
    LeftEndpoint, Level, Options, Problem, SMatrix, SVector, Scalar, Starts, TautLine, Trapezoidal,
};

#[test]
fn the_line_between_near_points_is_proven_to_be_the_shortest() {
    fn widths<M: Bounded<2>, R: RuleOfThePaper>(line: &TautLine<M, R, 2>, d2: f64) -> [f64; 2] {
        let enclosure = line.enclosure().expect("finite");
        let (lower, upper) = (enclosure.lower, enclosure.upper);
        assert!(lower <= d2 && d2 <= upper * (1.0 + 1e-14), "{enclosure:?}");
        assert!(!enclosure.assumes_global_minimum, "{enclosure:?}");
        assert_eq!(enclosure.from_below, FromBelow::Convexity);
        let computed = Computed {
            rule: R::OF_THE_PAPER,
            n: line.sequence().n(),
            discrete_energy: line.discrete_energy(),
            energy: line.energy().value,
            length_squared: upper,
            minimum: DiscreteMinimum::Assumed,
            gap: 0.0,
        };
        let by_the_minimum = enclose(line.metric().constants(), 2, &computed).expect("finite");
        [enclosure.width() / d2, by_the_minimum.width() / d2]
    }
    fn check<M: Bounded<2> + KnownDistance<2>>(metric: M, b: [f64; 2], better: [f64; 2]) {
        let d2 = metric.distance(&[0.0; 2].into(), &b.into()).expect("known").powi(2);
        let problem = Problem::new(metric, Ends::points([0.0, 0.0], b).expect("finite"));
        let at = |n| {
            let tra = widths(&problem.solve(Trapezoidal, n).expect("solved"), d2);
            [tra, widths(&problem.solve(LeftEndpoint, n).expect("solved"), d2)]
        };
        // Both rules are of second order. By the discrete minimum alone the left one is of
        // first order.
        for ((coarse, fine), better) in at(64).into_iter().zip(at(128)).zip(better) {
            let order = coarse[0] / fine[0];
            assert!((3.9..4.1).contains(&order), "{order} is not four");
            let gain = coarse[1] / coarse[0];
            assert!(gain > better, "{gain}");
        }
    }
    check(Shear::new(0.5, 1.0).expect("valid"), [0.2, 0.1], [1.3, 100.0]);
    check(Valleys, [0.1, 0.1], [8.0, 50.0]);
}

#[test]
fn far_points_and_sets_need_an_assumption() {
    let ends = Ends::points([0.0, 0.0], [4.0 * std::f64::consts::PI, 0.0]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Trapezoidal, 256).expect("solved");
    let enclosure = line.enclosure().expect("finite");
    let d2 = (8.0 * std::f64::consts::PI).powi(2);
    assert!(enclosure.lower <= d2 && d2 <= enclosure.upper * (1.0 + 1e-13), "{enclosure:?}");
    assert!(enclosure.assumes_global_minimum);
    let ball = |x| Ball::new([x, 0.0], 0.01).expect("finite");
    let ends = Ends::new(ball(0.0), ball(0.1)).expect("bounded");
    let line = Problem::new(Valleys, ends).solve(Trapezoidal, 64).expect("solved");
    assert!(line.enclosure().expect("finite").assumes_global_minimum);
}

/// Both the proven and the expected `N` suffice. The proven one is far larger.
#[test]
fn suggested_grids_reach_the_tolerance() {
    let metric = Shear::new(0.5, 1.0).expect("valid");
    let (a, b) = ([0.0, 0.0], [1.0, 2.0]);
    let d2 = metric.distance(&a.into(), &b.into()).expect("known").powi(2);
    let problem = Problem::new(metric, Ends::points(a, b).expect("finite"));
    let tolerance = 1e-6;
    let coarse = problem.solve(Trapezoidal, 512).expect("solved");
    let suggested = coarse.suggest_n(tolerance).expect("finite");
    let estimate = coarse.distance_squared_estimate();
    let expected = suggested.expected.unwrap_or_else(|| panic!("{estimate:?} of {d2}")).get();
    let (proven, _) = suggested.proven.expect("of second order");
    assert!(expected < proven.get() && proven.get() < 100_000, "{suggested:?}");
    for n in [expected, proven.get()] {
        let line = problem.solve(Trapezoidal, n).expect("solved");
        let excess = line.length().value.powi(2) - d2;
        // The expectation is correct up to the next order, which is a few percent here.
        assert!(excess <= 1.1 * tolerance, "N = {n}: {excess}");
    }
    // For the excess that 512 chords reach, the expected number of chords is 512.
    let excess = coarse.length().value.powi(2) - d2;
    let again = coarse.suggest_n(excess).expect("finite").expected.expect("known").get();
    assert!((508..=516).contains(&again), "{again}");
    assert_eq!(coarse.suggest_n(0.0).expect("finite").expected, None);
    assert_eq!(coarse.suggest_n(f64::NAN).expect("finite").proven, None);
}

/// Returns a line under `f = 1 + a sin kx` on `[0, 1]`, with waves that no quadrature resolves,
/// so that the quadrature error matters. Its levels are those of two grids that were
/// extrapolated to `excess` below the squared length, with this `error`.
fn extrapolated(excess: f64, error: f64) -> TautLine<Separable<1>, Trapezoidal, 1> {
    let metric = Separable::new([1e-3], [1e5]).expect("valid");
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(metric, ends.clone()).solve(Trapezoidal, 1).expect("one chord");
    let mut minimum = line.minimum().clone();
    // From N = 1 to N = 2, extrapolation adds a third of the change.
    let fine = line.length().value.powi(2) - excess + error;
    minimum.levels =
        [(1, fine + 3.0 * error), (2, fine)].map(|(n, energy)| Level { n, energy }).to_vec();
    TautLine::new(Arc::new(Prepared::new(metric)), Trapezoidal, ends, minimum)
}

/// An excess counts only if it is larger than the sum of both errors.
#[test]
fn both_errors_are_in_the_noise_of_an_expectation() {
    let is_known = |excess: f64, error: f64| {
        let line = extrapolated(excess, error);
        let estimate = line.distance_squared_estimate().expect("two grids");
        let length = line.length().value;
        // These are differences of numbers near 1, and as small as 1e-7.
        assert!((estimate.error / error - 1.0).abs() < 1e-6, "{estimate:?}");
        assert!(((length * length - estimate.value) / excess - 1.0).abs() < 1e-6);
        line.suggest_n(1e-9).expect("finite").expected.is_some()
    };
    let length = extrapolated(1.0, 1.0).length();
    let of_length = 2.0 * length.value * length.error;
    assert!(of_length > 1e-6, "{of_length:e}");
    for ratio in [0.1, 1.0, 10.0] {
        let error = ratio * of_length;
        assert!(!is_known(0.98 * (error + of_length), error), "{ratio}");
        assert!(is_known(1.02 * (error + of_length), error), "{ratio}");
    }
}

/// The expected `N` is the smallest for which an excess that falls like `1/N²` is within the
/// tolerance.
#[test]
fn an_expected_grid_is_enough_and_one_less_is_not() {
    let excess = 0.1;
    for parts in [1.5, 2.25, 6.4, 6.6, 1e3 + 0.3, 1e5 + 0.7] {
        let tolerance = excess / (parts * parts);
        let suggested = extrapolated(excess, 1e-6).suggest_n(tolerance).expect("finite");
        let n = suggested.expected.expect("known").get() as f64;
        assert_eq!(n, f64::ceil(parts));
        assert!(excess / (n * n) <= tolerance && tolerance < excess / (n - 1.0).powi(2));
    }
}

/// The proven `N` is computed for the length plus its quadrature error.
#[test]
fn the_error_of_the_length_is_in_the_proven_grid() {
    let metric = Separable::new([0.5], [1e5]).expect("valid");
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(metric, ends).solve(Trapezoidal, 1).expect("one chord");
    let length = line.length();
    let proven = |d: f64, tolerance: f64| {
        let setting = Setting::new(line.metric().constants(), d, 1).expect("a distance");
        suggest_n(setting, PaperRule::Trapezoidal, tolerance)
    };
    for tolerance in [1.0, 1e-3] {
        let longest = proven(length.value + length.error, tolerance);
        assert_eq!(line.suggest_n(tolerance).expect("finite").proven, longest);
        let [longest, shorter] =
            [longest, proven(length.value, tolerance)].map(|n| n.expect("some").0);
        assert!(longest > shorter, "{length:?}");
    }
}

/// The excess is below the noise of the extrapolation.
#[test]
fn a_line_without_an_excess_suggests_nothing() {
    let metric = Constant::<2>::new([[2.0, 1.0], [1.0, 2.0]].into());
    let ends = Ends::points([0.0, 0.0], [3.0, 4.0]).expect("finite");
    let problem = Problem::new(metric.expect("positive definite"), ends);
    let line = problem.solve(Trapezoidal, 512).expect("solved");
    let suggested = line.suggest_n(1e-20).expect("finite");
    assert_eq!(suggested.expected, None);
    assert_eq!(suggested.proven.map(|(n, _)| n.get()), Some(1));
}

#[derive(Debug)]
struct OnARegion;

impl Metric<2> for OnARegion {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        Valleys.gram(x)
    }
}

impl Bounded<2> for OnARegion {
    fn constants(&self) -> Constants {
        Bounded::<2>::constants(&Valleys).on_a_region()
    }
}

#[test]
fn constants_on_a_region_are_refused() {
    let ends = Ends::points([0.0, 0.0], [0.1, 0.0]).expect("finite");
    let line = Problem::new(OnARegion, ends).solve(Trapezoidal, 16).expect("solved");
    assert_eq!(line.enclosure(), Err(BoundError::LocalConstants));
    assert_eq!(line.suggest_n(1.0), Err(BoundError::LocalConstants));
    // Nor does a claim make them hold elsewhere.
    let claim = Bounded::<2>::constants(&Valleys);
    assert_eq!(line.enclosure_given(claim.on_a_region()), Err(BoundError::LocalConstants));
    assert!(line.enclosure_given(claim).is_ok());
}

#[test]
fn both_rules_have_their_name_in_the_paper() {
    assert_eq!(Trapezoidal::OF_THE_PAPER, PaperRule::Trapezoidal);
    assert_eq!(LeftEndpoint::OF_THE_PAPER, PaperRule::LeftEndpoint);
    assert!(Bounded::<2>::constants(&Valleys).is_isotropic());
}

/// Constants that are claimed give the bounds that they give when they are proved: the formula
/// shows in both cases that `H` is a multiple of the identity.
#[test]
fn claimed_constants_count_as_much_as_proved_ones() {
    let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Trapezoidal, 256).expect("solved");
    let proof = line.prove(tautline_certify::Accuracy::default()).expect("proved");
    let claim = Constants::new(proof.constants.c1(), proof.constants.c2(), proof.constants.l_h());
    let claim = claim.and_then(|claim| claim.with_m_h(proof.constants.m_h().expect("proved")));
    let claim = claim.expect("constants");
    assert!(!claim.is_isotropic() && proof.constants.is_isotropic());
    let claimed = line.enclosure_given(claim).expect("bounds");
    // The curves' energies differ by a quadrature error of a few roundings.
    let proved = line.enclosure_by(proof.constants, line.extent()).expect("bounds");
    let difference = (claimed.lower - proved.lower).abs();
    assert!(difference <= 1e-12 * claimed.upper, "{claimed:?} {proved:?}");
}

/// The theorems count more for an anisotropic metric, and a claim does not change that.
#[test]
fn claimed_constants_of_an_anisotropic_metric_stay_anisotropic() {
    let shear = Shear::new(0.5, 1.0).expect("valid");
    let ends = Ends::points([0.0, 0.0], [1.0, 2.0]).expect("finite");
    let line = Problem::new(shear, ends).solve(Trapezoidal, 64).expect("solved");
    assert!(!shear.constants().is_isotropic());
    let [claimed, isotropic] = [shear.constants(), shear.constants().isotropic()]
        .map(|constants| line.enclosure_given(constants).expect("bounds"));
    assert_eq!(Ok(claimed), line.enclosure());
    assert!(isotropic.lower > claimed.lower, "a wrong claim of isotropy would show");
}

/// Convexity needs the longest of the differences `N (xₙ₊₁ − xₙ)`, wherever it is, and the residual at all
/// inner points: under `H = 4` it is `4 N² (2xₙ − xₙ₋₁ − xₙ₊₁)`.
#[test]
fn convexity_needs_the_longest_chord_and_every_residual() {
    let metric = Constant::<1>::new([[4.0]].into()).expect("positive definite");
    // Exact in binary.
    let all =
        [[0.0, 0.25, 0.5, 2.0, 2.25], [0.0, 1.5, 1.75, 2.0, 2.25], [0.0, 0.25, 0.5, 0.75, 2.25]];
    for points in all {
        let start =
            PointSequence::new(points.map(|x| SVector::from([x])).to_vec()).expect("finite");
        let options =
            Options { starts: Starts::Only(vec![start]), iterations: 0, ..Options::default() };
        let ends = Ends::points([0.0], [2.25]).expect("finite");
        let line = Problem::new(metric, ends).solve_with(Trapezoidal, 4, &options).expect("a line");
        let curve = line.admissible_curve().expect("a curve");
        let extent = line.proved_extent(&curve);
        let between = line.between_points(extent).expect("two points");
        let greatest = between.greatest_difference;
        assert!((6.0..6.0 * (1.0 + 1e-15)).contains(&greatest), "{greatest}");
        assert_eq!(between.length, extent.length);
        let residuals = (1..4).map(|n| 64.0 * (2.0 * points[n] - points[n - 1] - points[n + 1]));
        let square = residuals.map(|residual| residual * residual).sum::<f64>() / 4.0;
        assert!((between.residual / square.sqrt() - 1.0).abs() < 1e-15, "{}", between.residual);
    }
}
