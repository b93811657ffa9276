//! Enclosures of known distances, and suggested grids.

use std::sync::Arc;

use tautline_bounds::{
    BoundError, Computed, Constants, DiscreteMinimum, FromBelow, PaperRule, Setting,
    convex_excess_outward, enclose, suggest_n,
};
use tautline_discretizations::PointSequence;
use tautline_formula::Prepared;
use tautline_metrics::gallery::{Constant, Separable, Shear, Valleys};
use tautline_metrics::{Bounded, KnownDistance, Metric};
use tautline_sets::{Ball, ClosedSet, Ends, Point};

use super::{Extent, gap};
use crate::{
    Interval, Level, Options, Problem, ProofError, Rule, SMatrix, SVector, Scalar, Starts,
    TautLine, certify::Accuracy,
};

#[test]
fn the_line_between_near_points_is_proven_to_be_the_shortest() {
    fn widths<M: Bounded<2>>(line: &TautLine<M, 2>, d2: f64) -> [f64; 2] {
        let enclosure = line.enclosure().expect("finite");
        let (lower, upper) = (enclosure.lower, enclosure.upper);
        assert!(lower <= d2 && d2 <= upper * (1.0 + 1e-14), "{enclosure:?}");
        assert!(!enclosure.assumes_global_minimum, "{enclosure:?}");
        assert_eq!(enclosure.from_below, FromBelow::Convexity);
        let computed = Computed {
            rule: line.rule().paper_rule().expect("a rule of the paper"),
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
            let tra = widths(&problem.solve(Rule::TRAPEZOIDAL, n).expect("solved"), d2);
            [tra, widths(&problem.solve(Rule::LEFT_ENDPOINT, n).expect("solved"), d2)]
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
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
    let enclosure = line.enclosure().expect("finite");
    let d2 = (8.0 * std::f64::consts::PI).powi(2);
    assert!(enclosure.lower <= d2 && d2 <= enclosure.upper * (1.0 + 1e-13), "{enclosure:?}");
    assert!(enclosure.assumes_global_minimum);
    let ball = |x| Ball::new([x, 0.0], 0.01).expect("finite");
    let ends = Ends::new(ball(0.0), ball(0.1)).expect("bounded");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
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
    let coarse = problem.solve(Rule::TRAPEZOIDAL, 512).expect("solved");
    let suggested = coarse.suggest_n(tolerance).expect("finite");
    let estimate = coarse.distance_squared_estimate();
    let expected = suggested.expected.unwrap_or_else(|| panic!("{estimate:?} of {d2}")).get();
    let (proven, _) = suggested.proven.expect("of second order");
    assert!(expected < proven.get() && proven.get() < 100_000, "{suggested:?}");
    for n in [expected, proven.get()] {
        let line = problem.solve(Rule::TRAPEZOIDAL, n).expect("solved");
        let excess = line.length().value.powi(2) - d2;
        // The expectation is correct up to the next order, which is a few percent here.
        assert!(excess <= 1.1 * tolerance, "N = {n}: {excess}");
    }
    // For the excess that 512 chords reach, the expected number of chords is 512.
    let excess = coarse.length().value.powi(2) - d2;
    let again = coarse.suggest_n(excess).expect("finite").expected.expect("known").get();
    assert!((508..=516).contains(&again), "{again}");
    // Neither are grids suggested that nobody can solve on.
    for tolerance in [0.0, 1e-40, -1.0] {
        assert_eq!(coarse.suggest_n(tolerance).expect("finite").expected, None);
    }
    assert_eq!(coarse.suggest_n(f64::NAN).expect("finite").proven, None);
}

/// Returns a line under `f = 1 + a sin kx` on `[0, 1]`, with waves that no quadrature resolves,
/// so that the quadrature error matters. Its levels are those of two grids that were
/// extrapolated to `excess` below the squared length, with this `error`.
fn extrapolated(excess: f64, error: f64) -> TautLine<Separable<1>, 1> {
    let metric = Separable::new([1e-3], [1e5]).expect("valid");
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(metric, ends.clone()).solve(Rule::TRAPEZOIDAL, 1).expect("one chord");
    let mut minimum = line.minimum().clone();
    // From N = 1 to N = 2, extrapolation adds a third of the change.
    let fine = line.length().value.powi(2) - excess + error;
    minimum.levels =
        [(1, fine + 3.0 * error), (2, fine)].map(|(n, energy)| Level { n, energy }).to_vec();
    TautLine::new(Arc::new(Prepared::new(metric)), Rule::TRAPEZOIDAL, ends, minimum)
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

/// The proven `N` is that for a proved bound on the length, which the estimate need not be.
#[test]
fn the_proven_grid_is_that_for_a_proved_length() {
    let metric = Separable::new([0.5], [1e5]).expect("valid");
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 1).expect("one chord");
    let (length, proved) = (line.length(), line.admissible_curve().expect("a curve").length().hi());
    let proven = |d: f64, tolerance: f64| {
        let setting = Setting::new(line.metric().constants(), d, 1).expect("a distance");
        suggest_n(setting, PaperRule::Trapezoidal, tolerance)
    };
    for tolerance in [1.0, 1e-3] {
        let longest = proven(proved, tolerance);
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
    let line = problem.solve(Rule::TRAPEZOIDAL, 512).expect("solved");
    let suggested = line.suggest_n(1e-20).expect("finite");
    assert_eq!(suggested.expected, None);
    assert_eq!(suggested.proven.map(|(n, _)| n.get()), Some(1));
}

/// A formula with a branch cannot be recorded, so that no length under it is proved.
#[test]
fn without_a_proved_length_no_grid_is_proved() {
    #[derive(Debug)]
    struct Branch;
    impl Metric<1> for Branch {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let two = S::constant(2.0);
            SMatrix::from_diagonal_element(if x[0] == two { two } else { S::constant(1.0) })
        }
    }
    impl Bounded<1> for Branch {
        fn constants(&self) -> Constants {
            Constants::new(1.0, 2.0, 1.0).expect("constants")
        }
    }
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(Branch, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
    assert!(line.admissible_curve().is_err());
    assert_eq!(line.suggest_n(1e-3).expect("constants").proven, None);
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
    let line = Problem::new(OnARegion, ends).solve(Rule::TRAPEZOIDAL, 16).expect("solved");
    assert_eq!(line.enclosure(), Err(BoundError::LocalConstants));
    assert_eq!(line.suggest_n(1.0), Err(BoundError::LocalConstants));
    // Nor does a claim make them hold elsewhere.
    let claim = Bounded::<2>::constants(&Valleys);
    assert_eq!(line.enclosure_given(claim.on_a_region(), None), Err(BoundError::LocalConstants));
    assert!(line.enclosure_given(claim, None).is_ok());
}

/// Without a theorem there is no bound, neither by constants of the metric nor by proved ones.
#[test]
fn other_rules_have_no_bounds() {
    for rule in Rule::ALL.iter().copied().filter(|rule| rule.paper_rule().is_err()) {
        let ends = Ends::points([0.3, 0.1], [0.45, 0.2]).expect("finite");
        let line = Problem::new(Valleys, ends).solve(rule, 8).expect("solved");
        let other = BoundError::OtherRule { rule: rule.name() };
        assert_eq!(line.enclosure(), Err(other));
        assert_eq!(line.suggest_n(1e-3), Err(other));
        assert_eq!(line.enclosure_given(Bounded::<2>::constants(&Valleys), None), Err(other));
        let proof = line.prove(Accuracy::default());
        assert_eq!(proof.expect_err("no theorem"), ProofError::Bound(other));
    }
}

#[test]
fn the_valleys_are_isotropic() {
    assert!(Bounded::<2>::constants(&Valleys).is_isotropic());
}

/// Constants that are claimed give the bounds that they give when they are proved: the formula
/// shows in both cases that `H` is a multiple of the identity.
#[test]
fn claimed_constants_count_as_much_as_proved_ones() {
    let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
    let proof = line.prove(tautline_certify::Accuracy::default()).expect("proved");
    let claim = Constants::new(proof.constants.c1(), proof.constants.c2(), proof.constants.l_h());
    let claim = claim.and_then(|claim| claim.with_m_h(proof.constants.m_h().expect("proved")));
    let claim = claim.expect("constants");
    assert!(!claim.is_isotropic() && proof.constants.is_isotropic());
    let claimed = line.enclosure_given(claim, None).expect("bounds");
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
    let line = Problem::new(shear, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    assert!(!shear.constants().is_isotropic());
    let [claimed, isotropic] = [shear.constants(), shear.constants().isotropic()]
        .map(|constants| line.enclosure_given(constants, None).expect("bounds"));
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
        let line =
            Problem::new(metric, ends).solve_with(Rule::TRAPEZOIDAL, 4, &options).expect("a line");
        let curve = line.admissible_curve().expect("a curve");
        let extent = line.proved_extent(&curve);
        let between = line.between_points(PaperRule::Trapezoidal, extent).expect("two points");
        let greatest = between.greatest_difference;
        assert!((6.0..6.0 * (1.0 + 1e-15)).contains(&greatest), "{greatest}");
        assert_eq!(between.length, extent.length);
        let residuals = (1..4).map(|n| 64.0 * (2.0 * points[n] - points[n - 1] - points[n + 1]));
        let square = residuals.map(|residual| residual * residual).sum::<f64>() / 4.0;
        assert!((between.residual / square.sqrt() - 1.0).abs() < 1e-15, "{}", between.residual);
    }
}

/// Returns the sign of `x² − k/4^q` for a positive `x`, exactly. Needs: `k` has few bits.
fn against_root(x: f64, k: u64, q: i32) -> std::cmp::Ordering {
    // x is a whole number of units 2^−e.
    let e = 52 - x.log2().floor() as i32;
    let whole = (x * 2.0_f64.powi(e)) as u128;
    (whole * whole).cmp(&(u128::from(k) << (2 * e - 2 * q)))
}

/// A sequence of pseudorandom numbers (Knuth's MMIX).
struct Draws(u64);

impl Draws {
    /// Returns a whole number from `-most` to `most`.
    fn whole(&mut self, most: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 33) as i64 % (2 * most + 1) - most
    }
}

/// The quadratures of the length and of the energy have errors, which are taken to the side that each
/// bound needs.
#[test]
fn the_errors_of_the_quadratures_are_in_the_numbers_of_a_curve() {
    let metric = Separable::new([1e-3], [1e5]).expect("valid");
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 1).expect("one chord");
    let (length, energy, extent) = (line.length(), line.energy(), line.extent());
    assert!(length.error > 1e-7 && energy.error > 1e-7, "{length:?} {energy:?}");
    assert!(extent.length >= length.value + length.error);
    assert!(extent.length_squared >= (length.value + length.error).powi(2));
    assert!(extent.energy >= energy.value + energy.error);
    assert!(extent.energy_at_least <= energy.value - energy.error);
    // And not more.
    assert!(extent.length <= length.value + 2.0 * length.error);
    assert!(extent.energy_at_least >= energy.value - 2.0 * energy.error);
}

/// Points of whole quarters under `H = 4 I`: the squares of the longest difference, of the residual and
/// of the gap are whole numbers, and the numbers are on the right side of their roots, to the last digit.
#[test]
fn the_numbers_of_a_polygon_are_on_their_side_of_the_roots() {
    let metric = Constant::<2>::new([[4.0, 0.0], [0.0, 4.0]].into()).expect("positive definite");
    let mut draws = Draws(3);
    let mut sharp = 0;
    for _ in 0..60 {
        let mut quarters: Vec<[i64; 2]> =
            (0..5).map(|_| [(); 2].map(|()| draws.whole(20))).collect();
        // The ends are apart.
        quarters[4][0] = quarters[0][0] + 1 + draws.whole(20).abs();
        let points = quarters.iter().map(|x| SVector::from(x.map(|k| k as f64 / 4.0))).collect();
        let sequence = PointSequence::new(points).expect("finite");
        let ends = Ends::points(*sequence.first(), *sequence.last()).expect("finite");
        let options =
            Options { starts: Starts::Only(vec![sequence]), iterations: 0, ..Options::default() };
        let line =
            Problem::new(metric, ends).solve_with(Rule::TRAPEZOIDAL, 4, &options).expect("a line");
        let square = |x: [i64; 2]| (x[0] * x[0] + x[1] * x[1]) as u64;
        let minus = |a: [i64; 2], b: [i64; 2]| [a[0] - b[0], a[1] - b[1]];
        // β = 4 Δ: in quarters of Δ, whole numbers.
        let greatest = quarters.windows(2).map(|pair| square(minus(pair[1], pair[0]))).max();
        let greatest = greatest.expect("four chords");
        // ρₙ = 4 N² (2xₙ − xₙ₋₁ − xₙ₊₁) is 16 times a whole number, and 1/N times 16² is 64.
        let bend = |x: &[[i64; 2]]| square(minus(minus(x[1], x[0]), minus(x[2], x[1])));
        let residual = 64 * quarters.windows(3).map(bend).sum::<u64>();
        let apart = square(minus(quarters[4], quarters[0]));
        let curve = line.admissible_curve().expect("a curve");
        let close = |x: f64, k: u64| (x * x / k as f64 - 1.0).abs() < 1e-13;
        for extent in [line.extent(), line.proved_extent(&curve)] {
            let between = line.between_points(PaperRule::Trapezoidal, extent).expect("two points");
            assert!(close(between.greatest_difference, greatest), "{quarters:?} {between:?}");
            assert!(residual == 0 || close(between.residual, residual), "{quarters:?} {between:?}");
            assert!(close(4.0 * extent.gap_at_least, apart), "{quarters:?} {extent:?}");
            assert!(against_root(extent.gap_at_least, apart, 2).is_le(), "{quarters:?} {extent:?}");
        }
        let between = line
            .between_points(PaperRule::Trapezoidal, line.proved_extent(&curve))
            .expect("two points");
        assert!(against_root(between.greatest_difference, greatest, 0).is_ge(), "{quarters:?}");
        assert!(residual == 0 || against_root(between.residual, residual, 0).is_ge());
        let nearest = (greatest as f64).sqrt();
        sharp += usize::from(against_root(nearest, greatest, 0).is_lt());
    }
    // Rounding to nearest would be on the wrong side for many of them.
    assert!(sharp > 10, "{sharp}");
}

/// The gap is rounded down, and 0 or less than the distance if it overflows.
#[test]
fn a_gap_is_no_more_than_the_distance_of_the_points() {
    let point = |x: [f64; 2]| SVector::from(x).map(Interval::point);
    for (x, y, most) in [
        ([-1e200, 0.0], [1e200, 0.0], 2e200),
        ([0.0, 0.0], [3e-200, 0.0], 3e-200),
        ([1.0, 1.0], [1.0, 1.0], 0.0),
    ] {
        let found = gap(&point(x), &point(y));
        assert!((0.0..=most).contains(&found), "{found} of {most}");
    }
    // Boxes may be as near as their nearest sides.
    let wide = SVector::from([Interval::new(-1.0, 1.0).expect("in order"), Interval::point(0.0)]);
    let found = gap(&wide, &point([4.0, 0.0]));
    assert!(found <= 3.0 && found > 2.999, "{found}");
    assert_eq!(gap(&wide, &wide), 0.0);
}

/// A point at 0 whose proved member lies beside it.
#[derive(Debug)]
struct Beside(f64);

impl ClosedSet<1> for Beside {
    fn project(&self, _: &SVector<f64, 1>) -> SVector<f64, 1> {
        SVector::from([0.0])
    }
    fn projection_derivative(&self, _: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
        SMatrix::zeros()
    }
    fn radius(&self) -> Option<f64> {
        Some(self.0.abs())
    }
    fn member_near(&self, _: &SVector<f64, 1>) -> Option<SVector<Interval, 1>> {
        Some(SVector::from([Interval::point(self.0)]))
    }
}

/// The minimum is that of the points that were found, and the curve is that of the points that were moved:
/// the discrete energies of both are in the bounds. With two chords from 0 to 1 it is `2 (1/4 + 1/4)`, and
/// with the first point at `∓ 1/4` it is `2 (9/16 + 1/4)` and `2 (1/16 + 1/4)`.
#[test]
fn the_points_before_they_were_moved_count_as_well_as_those_after() {
    let metric = Constant::<1>::new([[1.0]].into()).expect("positive definite");
    for (by, least, most) in [(-0.25, 1.0, 1.625), (0.25, 0.625, 1.0)] {
        let ends = Ends::new(Beside(by), Point::new([1.0]).expect("finite")).expect("bounded");
        let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 2).expect("solved");
        let curve = line.admissible_curve().expect("a curve");
        let extent = line.proved_extent(&curve);
        // The middle is known up to rounding.
        let close = |x: f64, exact: f64| (x - exact).abs() < 1e-12;
        assert!(close(extent.discrete_energy_at_least, least), "{extent:?}");
        assert!(close(extent.discrete_energy, most), "{extent:?}");
        // The length is that of the curve.
        assert!(close(extent.length, 1.0 - by) && extent.energy >= extent.energy_at_least);
        // Ends that are sets say nothing of a gap, and may move.
        assert!(extent.gap_at_least == 0.0 && extent.stationarity.is_none());
    }
}

/// Each number of a curve enters the bounds on its own side: the least discrete energy bounds `d²` from
/// below, and a larger one changes nothing.
#[test]
fn each_number_of_a_curve_bounds_its_own_side() {
    let ends = Ends::points([0.0, 0.0], [0.1, 0.1]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let constants = Bounded::<2>::constants(&Valleys);
    let of = |extent: Extent| line.enclosure_by(constants, extent).expect("bounds");
    let extent = line.extent();
    // As between sets: by the discrete minimum, which is assumed.
    let sets = Extent { stationarity: None, gap_at_least: 0.0, ..extent };
    let assumed = of(sets);
    assert_eq!(assumed.from_below, FromBelow::Minimum);
    let least = 0.5 * extent.discrete_energy_at_least;
    let lower = of(Extent { discrete_energy_at_least: least, ..sets }).lower;
    assert!(lower <= least && lower > 0.9 * least, "{lower} {least}");
    let larger = Extent { discrete_energy: 2.0 * extent.discrete_energy, ..sets };
    assert_eq!(of(larger), assumed);
    // By the gap alone.
    let apart = of(Extent { discrete_energy_at_least: 0.0, gap_at_least: 0.125, ..sets });
    let exact = constants.c1() / 64.0;
    assert!(apart.lower <= exact && apart.lower > exact - 1e-15, "{apart:?}");
    // By convexity: the energy that the curve has at least, less the excess.
    let convex = of(extent);
    assert_eq!(convex.from_below, FromBelow::Convexity);
    let less = extent.energy_at_least - convex.width();
    let shifted = of(Extent { energy_at_least: less, ..extent });
    let fallen = convex.lower - shifted.lower;
    assert!((fallen / convex.width() - 1.0).abs() < 1e-6, "{convex:?} {shifted:?}");
    let higher = of(Extent { energy: 2.0 * extent.energy, ..extent });
    assert_eq!((higher.lower, higher.upper), (convex.lower, extent.length_squared));
    // From above: the smaller of both.
    let longer = of(Extent { length_squared: 2.0 * extent.length_squared, ..extent });
    assert_eq!(longer.upper, extent.energy);
}

/// The difference of the energy and of the excess is rounded down.
#[test]
fn a_bound_by_convexity_is_rounded_down() {
    let ends = Ends::points([0.0, 0.0], [0.1, 0.1]).expect("finite");
    let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let constants = Bounded::<2>::constants(&Valleys);
    let extent = line.extent();
    let between = line.between_points(PaperRule::Trapezoidal, extent).expect("two points");
    let excess = convex_excess_outward(constants, 2, &between).expect("convex");
    let mut inexact = 0;
    for k in 0..40 {
        let energy_at_least = extent.energy_at_least * (1.0 - f64::from(k) * 1e-9);
        let found = line.enclosure_by(constants, Extent { energy_at_least, ..extent });
        let lower = found.expect("bounds").lower;
        let nearest = energy_at_least - excess;
        // Exact, since the excess is the smaller one.
        let rest = (energy_at_least - nearest) - excess;
        assert!(lower <= nearest && (lower < nearest || rest >= 0.0), "{lower} {nearest} {rest:e}");
        assert!(lower >= nearest * (1.0 - 1e-15), "{lower} {nearest}");
        inexact += usize::from(rest < 0.0);
    }
    // To nearest, these would be too large.
    assert!(inexact > 5, "{inexact}");
}
