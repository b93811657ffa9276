//! Tests other units of `ℓ` and `m`, and a far origin: the results are the same, as far as `f64`
//! allows.

use nalgebra::{SMatrix, SVector, vector};
use tautline_discretizations::{PointSequence, Rule};
use tautline_metrics::{Metric, Scalar};
use tautline_optimizers::{Curvature, Minimum, Options, Stop, minimise};
use tautline_sets::Ends;

use crate::setup::{
    ball, between, bump, euclidean, from_to, half_space, lowest, only, point, sequence, straight,
};

/// A metric in other units: `m² H(x/ℓ)/ℓ²`, about another origin.
#[derive(Clone, Copy)]
struct Units<M> {
    metric: M,
    /// The old unit of length, measured in new units.
    ell: f64,
    /// The square of the old unit of Riemannian length, divided by the square of the old unit `ℓ`,
    /// measured in new units.
    gram: f64,
    /// Every coordinate of the old origin, in new units.
    origin: f64,
}

impl<const D: usize, M: Metric<D>> Metric<D> for Units<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let old = x.map(|x| (x - self.origin) / self.ell);
        self.metric.gram(&old).map(|entry| entry * self.gram)
    }
}

type Solve = fn(Units<()>, usize) -> Minimum<2>;

const PLAIN: Units<()> = Units { metric: (), ell: 1.0, gram: 1.0, origin: 0.0 };

impl Units<()> {
    fn of<M>(self, metric: M) -> Units<M> {
        Units { metric, ell: self.ell, gram: self.gram, origin: self.origin }
    }

    /// Solves from a ball on one side of the bump to a half-plane on the other.
    fn solve_sets(self, n: usize) -> Minimum<2> {
        let at = |x: f64, y: f64| vector![x, y] * self.ell + vector![self.origin, self.origin];
        let ball = ball(at(-2.0, 0.1), 0.5 * self.ell);
        // The set {x₁ ≥ 2}, given by a normal of another length.
        let wall = half_space([0.25, 0.0], 0.25 * at(2.0, 0.0)[0]);
        self.minimise(&between(ball, wall), n)
    }

    fn solve_points(self, n: usize) -> Minimum<2> {
        let at = |x: f64, y: f64| vector![x, y] * self.ell + vector![self.origin, self.origin];
        self.minimise(&from_to(at(-1.5, 0.125), at(1.5, -0.25)), n)
    }

    fn minimise(self, ends: &Ends<2>, n: usize) -> Minimum<2> {
        let bump = self.of(bump());
        lowest(&bump, ends, Rule::TRAPEZOIDAL, n)
    }
}

/// With a power of two as the unit, every number scales exactly and no rounding changes. A
/// tolerance with a hidden unit would change the result.
#[test]
fn powers_of_two_change_no_bit() {
    for n in [3, 40, 200] {
        for solve in [Units::solve_sets as Solve, Units::solve_points] {
            let reference = solve(PLAIN, n);
            assert!(reference.is_local_minimum());
            for (ell, gram) in [(300, 0), (-300, 0), (0, 40), (0, -40), (20, -600), (-20, 600)] {
                // H is in m²/ℓ²; its unit is a power of 4, so that roots are exact.
                let (ell, gram) = (2_f64.powi(ell), 4_f64.powi(gram / 2));
                let minimum = solve(Units { ell, gram, ..PLAIN }, n);
                let points: Vec<_> = reference.sequence.points().iter().map(|x| x * ell).collect();
                assert_eq!(minimum.sequence.points(), points, "ℓ {ell:e}, H {gram:e}");
                assert_eq!(minimum.energy, reference.energy * ell * ell * gram);
                assert_eq!(minimum.residual, reference.residual);
                assert_eq!(minimum.residual_floor, reference.residual_floor);
                assert_eq!(minimum.decrement, reference.decrement);
                assert_eq!(minimum.iterations, reference.iterations, "{n}, ℓ {ell:e}, H {gram:e}");
                assert_eq!(
                    (minimum.stop, minimum.curvature),
                    (reference.stop, reference.curvature)
                );
            }
        }
    }
}

/// The units are not powers of two, and range as far as squares fit into `f64`.
#[test]
fn any_units_give_the_same_energy() {
    let reference = PLAIN.solve_sets(64);
    for (ell, gram) in [
        (1e-150, 1.0),
        (1e-100, 1.0),
        (1e-6, 1.0),
        (1e6, 1.0),
        (1e100, 1.0),
        (1e150, 1.0),
        (1.0, 1e-12),
        (1.0, 1e12),
        (1.0, 1e-300),
        (1.0, 1e300),
        (1e6, 1e-12),
    ] {
        let minimum = Units { ell, gram, ..PLAIN }.solve_sets(64);
        assert_eq!((minimum.stop, minimum.curvature), (reference.stop, reference.curvature));
        // The allowance is twice the decrement, plus the rounding of coordinates.
        let energy = minimum.energy / (ell * gram) / ell;
        assert!((energy / reference.energy - 1.0).abs() <= 1e-14, "{ell:e} {gram:e}: {energy}");
        let range = 0.0..=8.0 * minimum.residual_floor + 1e-6;
        assert!(range.contains(&minimum.residual), "residual {:e}", minimum.residual);
        assert!(minimum.residual_floor > 0.0);
    }
}

/// Far from the origin the coordinates, and the chords with them, are rounded to `ε |x|`. The
/// search ends, and the observed residual agrees with the predicted floor.
#[test]
fn far_from_the_origin_the_floor_predicts_the_residual() {
    for (solve, name) in
        [(Units::solve_points as Solve, "points"), (Units::solve_sets as Solve, "sets")]
    {
        for n in [10_usize, 100, 1000, 5000] {
            let near = solve(PLAIN, n);
            for origin in [1e5, 1e6, 1e7, 1e8] {
                let far = solve(Units { origin, ..PLAIN }, n);
                let which = format!("{name}, N = {n}, origin {origin:e}");
                assert_eq!(far.stop, Stop::Converged, "{which}");
                assert_eq!(far.curvature, Curvature::PositiveDefinite, "{which}");
                assert!(far.iterations < 100 + near.iterations, "{which}: {}", far.iterations);
                // Above rounding, residual² ≤ 2 N² decrement. The factor 4 covers the condition
                // number of the metric and the ends.
                let unfinished = 4.0 * n as f64 * 1e-18_f64.sqrt();
                let ratio = far.residual / far.residual_floor;
                assert!(far.residual <= 30.0 * far.residual_floor + unfinished, "{which}: {ratio}");
                if n >= 100 && far.residual_floor > unfinished {
                    assert!(ratio >= 1.0 / 30.0, "{which}: {ratio}");
                }
                // Ends and points move by u = ε |x|. If c₂ and the length are about 5, this changes
                // E by 2 · 5 · 5 · u, plus the noise (N u)² of the chords.
                let u = f64::EPSILON * origin;
                let bound = 100.0 * u + 100.0 * (n as f64 * u).powi(2) + 1e-13;
                let error = (far.energy - near.energy).abs();
                assert!(error <= bound, "{which}: {error:e} over {bound:e}");
            }
        }
    }
}

/// If rounding dominates for every `N`, results are noisy, but the search ends and reports it.
#[test]
fn hopelessly_far_from_the_origin_the_search_still_ends() {
    for n in [10, 300] {
        let far = Units { origin: 1e12, ..PLAIN }.solve_points(n);
        assert!(matches!(far.stop, Stop::Converged | Stop::Stalled), "{:?}", far.stop);
        assert!(far.residual.is_finite() && far.energy.is_finite());
        // The floor is ε N² |x|/L: the residual has no correct digit.
        assert!(far.residual_floor > 1e-3, "{:e}", far.residual_floor);
    }
}

/// Solves for the same curve run backwards, from the same start.
#[test]
fn exchanging_the_ends_reverses_the_sequence() {
    let bump = bump();
    let ball = ball([-2.0, 0.1], 0.5);
    let wall = half_space([1.0, 0.2], 2.0);
    let (forth, back) = (Ends::new(ball.clone(), wall.clone()), Ends::new(wall, ball));
    let start = straight([-1.5, 0.5], [2.0, 0.4], 32);
    let turned = sequence(start.points().iter().rev().copied().collect());
    let solve = |ends: &Ends<2>, start: &PointSequence<2>| {
        let options = only(start.clone());
        minimise(&bump, ends, Rule::TRAPEZOIDAL, 100, &options).expect("a metric")
    };
    let forth = solve(&forth.expect("one bounded"), &start);
    let back = solve(&back.expect("one bounded"), &turned);
    assert!(forth.is_local_minimum() && back.is_local_minimum());
    assert!((forth.energy / back.energy - 1.0).abs() <= 1e-14);
    // A relative decrement below 1e-18 leaves displacements of about 1e-9.
    let points = forth.sequence.points().iter().zip(back.sequence.points().iter().rev());
    assert!(points.into_iter().all(|(x, y)| (x - y).amax() < 1e-8));
}

/// For `H = I` and `(0, 0) → (1, 1) → (2, 0)`, with the end on a wall, `E = 8`, `ρ₁ = (0, 8)`, and
/// the momentum along the wall is 2.
#[test]
fn the_residual_of_a_sequence_that_is_not_stationary() {
    let start = sequence([[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]].map(SVector::from).to_vec());
    let options = Options { iterations: 0, ..only(start) };
    let flat = euclidean();
    let ends = between(point([0.0, 0.0]), half_space([1.0, 0.0], 2.0));
    let minimum = minimise(&flat, &ends, Rule::TRAPEZOIDAL, 2, &options).expect("a metric");
    assert_eq!(minimum.stop, Stop::IterationLimit);
    // No minimiser was found.
    assert_eq!(minimum.local_minima, []);
    let expected = (8.0 / 2_f64.sqrt() + 2.0) / 8_f64.sqrt();
    // The allowance is a dozen roundings of numbers of size 10.
    assert!((minimum.residual - expected).abs() < 1e-14, "{}", minimum.residual);
}
