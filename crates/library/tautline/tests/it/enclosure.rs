//! Quadrature errors and the residual of a line enter its bounds on `d²`.

use std::f64::consts::PI;

use tautline::{
    Ball, Bounded, Ends, HalfSpace, KnownDistance, Options, PointSequence, Problem, Rule, Starts,
    TautLine,
    bounds::{Enclosure, FromAbove, FromBelow},
    gallery::{Constant, Separable, Shear, Valleys},
};

/// `f = 1 + a sin kx` on `[0, 1]`, with far more waves than a quadrature resolves.
fn unresolved(a: f64) -> (TautLine<Separable<1>, 1>, f64) {
    let metric = Separable::new([a], [1e5]).expect("valid");
    let d = metric.distance(&[0.0].into(), &[1.0].into()).expect("known");
    let ends = Ends::points([0.0], [1.0]).expect("finite");
    (Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 1).expect("nothing to solve"), d * d)
}

/// `upper` is `min(E + its error, (L + its error)²)`: without either error it would be smaller by
/// far more than rounding.
#[test]
fn the_errors_of_both_quadratures_are_in_the_upper_bound() {
    for a in [1e-3, 0.5] {
        let (line, d2) = unresolved(a);
        let (length, energy) = (line.length(), line.energy());
        let enclosure = line.enclosure().expect("finite");
        let of_length = (length.value + length.error).powi(2);
        let of_energy = energy.value + energy.error;
        assert_eq!(enclosure.upper, of_length.min(of_energy));
        let by = if of_energy < of_length { FromAbove::Energy } else { FromAbove::Length };
        assert_eq!(enclosure.from_above, by);
        // Rounding is about 10⁻¹⁵.
        let seen = enclosure.upper * (1.0 - 1e-6);
        assert!(length.value.powi(2) < seen, "a = {a}: {length:?}, {enclosure:?}");
        assert!(enclosure.lower <= d2 && d2 <= enclosure.upper, "a = {a}: {enclosure:?} of {d2}");
        if a < 0.1 {
            assert!(energy.value < seen, "{energy:?}, {enclosure:?}");
        }
    }
}

/// A line through the given points, without a search.
fn given<M: Bounded<D>, const D: usize>(
    metric: M,
    rule: Rule,
    ends: Ends<D>,
    points: Vec<[f64; D]>,
) -> TautLine<M, D> {
    let n = points.len() - 1;
    let start = PointSequence::new(points.into_iter().map(Into::into).collect()).expect("finite");
    let options =
        Options { starts: Starts::Only(vec![start]), iterations: 0, ..Options::default() };
    Problem::new(metric, ends).solve_with(rule, n, &options).expect("a metric")
}

/// A straight line between `a` and `b` plus half a sine wave, without a search.
fn waved<M: Bounded<D>, const D: usize>(
    metric: M,
    rule: Rule,
    n: usize,
    [a, b, by]: [[f64; D]; 3],
) -> TautLine<M, D> {
    let at = |k: usize| {
        let t = k as f64 / n as f64;
        let sine = if k == 0 || k == n { 0.0 } else { (PI * t).sin() };
        std::array::from_fn(|i| a[i] * (1.0 - t) + b[i] * t + by[i] * sine)
    };
    given(metric, rule, Ends::points(a, b).expect("finite"), (0..=n).map(at).collect())
}

/// Under `H = 4 I` the energy is quadratic, and a wave exceeds the minimum `d²` by exactly
/// `R²/(4σ N² sin²(π/2N))` with the residual `R² = (1/N) Σ |½N ∂E/∂xₙ|²`.
#[test]
fn the_residual_is_the_excess_of_a_wave_under_a_constant_metric() {
    fn lower(rule: Rule, n: usize) -> (Enclosure, f64) {
        let metric = Constant::<2>::new([[4.0, 0.0], [0.0, 4.0]].into()).expect("definite");
        let line = waved(metric, rule, n, [[0.0, 0.0], [3.0, 4.0], [0.0, 0.5]]);
        (line.enclosure().expect("finite"), line.discrete_energy())
    }
    for n in [2, 5, 32] {
        for (enclosure, energy) in [lower(Rule::TRAPEZOIDAL, n), lower(Rule::LEFT_ENDPOINT, n)] {
            // d² = 4·25, and the wave adds 4 (π/2)²/2 or a little less.
            assert!(energy > 103.0, "N = {n}: {energy}");
            assert!((enclosure.lower - 100.0).abs() < 1e-11, "N = {n}: {enclosure:?}");
            assert_eq!(enclosure.from_below, FromBelow::Minimum);
            assert!(!enclosure.assumes_global_minimum, "N = {n}: {enclosure:?}");
        }
    }
}

/// The energy of a line that is not optimised exceeds `d²` by more than the bound of second order:
/// only its residual keeps the lower bound below `d²`.
#[test]
fn the_residual_of_a_line_that_is_not_optimised_enters_the_lower_bound() {
    let metric = Shear::new(0.5, 1.0).expect("valid");
    let (a, b) = ([0.0, 0.0], [0.2, 0.1]);
    let d2 = metric.distance(&a.into(), &b.into()).expect("known").powi(2);
    let line = waved(metric, Rule::TRAPEZOIDAL, 64, [a, b, [0.0, 0.02]]);
    let enclosure = line.enclosure().expect("finite");
    assert!(!enclosure.assumes_global_minimum, "{enclosure:?}");
    assert!(enclosure.lower <= d2 && d2 <= enclosure.upper, "{enclosure:?} of {d2}");
    // If an optimised line had this energy, its lower bound would exceed d².
    let converged = Problem::new(metric, Ends::points(a, b).expect("finite"));
    let converged = converged.solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let left = converged.enclosure().expect("finite");
    let lost = converged.discrete_energy() - left.lower;
    assert!(line.discrete_energy() - lost > d2, "{enclosure:?}, {left:?}");
    assert!(enclosure.lower < left.lower, "{enclosure:?}, {left:?}");
}

/// The trapezoidal rule is symmetric, and so are its bounds: the longest chord counts wherever it
/// is, and the residual at each inner point.
#[test]
fn a_line_and_its_reverse_have_the_same_enclosure() {
    let wave = |k: usize| [0.1 * k as f64, 0.002 * (k * k % 7) as f64];
    let mut lines = vec![(0..=12).map(wave).collect::<Vec<_>>()];
    // One chord far longer than the others: the first, the last, or between.
    for long in [0, 3, 7] {
        let place = |k: usize| if k > long { 0.4 + 0.01 * k as f64 } else { 0.01 * k as f64 };
        lines.push((0..=8).map(|k| [place(k), 0.3 * place(k)]).collect());
    }
    // One inner point off the line: the first, the last, or between.
    for off in [1, 4, 7] {
        let beside = |k: usize| if k == off { 0.003 } else { 0.0 };
        lines.push((0..=8).map(|k| [0.01 * k as f64, beside(k)]).collect());
    }
    let shear = Shear::new(0.5, 1.0).expect("valid");
    let mut assumed = [0, 0];
    for points in lines {
        let enclosure = |points: Vec<[f64; 2]>| {
            let ends = Ends::points(points[0], points[points.len() - 1]).expect("finite");
            given(shear, Rule::TRAPEZOIDAL, ends, points).enclosure().expect("finite")
        };
        let there = enclosure(points.clone());
        let back = enclosure(points.into_iter().rev().collect());
        // Sums of a dozen terms in another order, with differences of a hundredth.
        let close = |x: f64, y: f64| (x - y).abs() <= 1e-12 * x.abs();
        assert!(close(there.lower, back.lower) && close(there.upper, back.upper), "{there:?}");
        let flags = |x: &Enclosure| (x.from_below, x.assumes_global_minimum, x.is_not_global);
        assert_eq!(flags(&there), flags(&back));
        assumed[usize::from(there.assumes_global_minimum)] += 1;
    }
    assert!(assumed.iter().all(|&count| count > 0), "{assumed:?}");
}

/// Between sets the ends of a line need not be the nearest points: their distance implies nothing
/// about `d²`, which is `4` here.
#[test]
fn the_gap_between_the_ends_of_a_line_is_not_the_gap_of_its_sets() {
    let flat = Constant::<2>::new([[1.0, 0.0], [0.0, 1.0]].into()).expect("definite");
    let ball = Ball::new([0.0, 0.0], 1.0).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a normal");
    let ends = Ends::new(ball, wall).expect("one bounded");
    let line = given(flat, Rule::TRAPEZOIDAL, ends, vec![[0.0, 1.0], [1.0, 2.0], [3.0, 5.0]]);
    let enclosure = line.enclosure().expect("finite");
    assert!(enclosure.upper > 24.0, "{enclosure:?}");
    assert_ne!(enclosure.from_below, FromBelow::Euclidean);
    assert!(enclosure.lower <= 4.0 || enclosure.assumes_global_minimum, "{enclosure:?}");
    // Between two points it bounds d².
    let ends = Ends::points([0.0, 1.0], [3.0, 5.0]).expect("finite");
    let line = given(flat, Rule::TRAPEZOIDAL, ends, vec![[0.0, 1.0], [1.0, 2.0], [3.0, 5.0]]);
    assert!(line.enclosure().expect("finite").lower >= 25.0 * (1.0 - 1e-14));
}

/// With the order of its rule, either extrapolation has far more correct digits of `d²` than the
/// energies.
#[test]
fn each_rule_is_extrapolated_by_its_own_order() {
    fn off(rule: Rule) -> (f64, f64) {
        let d2 = Valleys.distance(&[0.0].into(), &[2.5].into()).expect("known").powi(2);
        let ends = Ends::points([0.0], [2.5]).expect("finite");
        let line = Problem::new(Valleys, ends).solve(rule, 512).expect("solved");
        let estimate = line.distance_squared_estimate().expect("four grids");
        ((line.discrete_energy() / d2 - 1.0).abs(), (estimate.value / d2 - 1.0).abs())
    }
    for (energy, estimate) in [off(Rule::TRAPEZOIDAL), off(Rule::LEFT_ENDPOINT)] {
        // Three grids before this one: 1e-3 for each would be more.
        assert!(energy > 1e-7 && estimate < 1e-3 * energy, "{energy:e}, {estimate:e}");
    }
}
