//! How far a polygon is from a stationary point of its discrete energy, with rigorous bounds.

use tautline_discretizations::Rule;
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Enclosure, Jet1, Kernel, Scalar};

use super::{Polygon, chord::Chord, pairwise_sum::PairwiseSum, polygon::recorded};

/// How many derivatives one evaluation of the formula gives.
const TOGETHER: usize = 4;

impl<const D: usize, K: Kernel> Polygon<'_, D, K> {
    /// Encloses the residual `((1/N) Σ |ρₙ|²)^{1/2}` of a rule over the inner points, in `m²/ℓ`, with
    /// `∂E_N/∂xₙ = −2hρₙ` and `h = 1/N`.
    ///
    /// The result is undefined if [`discrete_energy`](Polygon::discrete_energy) is: where the metric is
    /// undefined, or if it is not known to be symmetric. Otherwise it is 0 for a single chord.
    /// Overestimation: rounding, of the size of `ε N` times the length.
    #[must_use]
    pub fn residual(&self, rule: Rule, metric: &impl Metric<D>) -> Enclosure<K> {
        recorded(metric)
            .map_or(Enclosure::UNDEFINED, |formula| self.residual_by_formula(rule, &formula))
    }

    /// Encloses the [`residual`](Polygon::residual), in `m²/ℓ`, in a dimension that is a value.
    ///
    /// # Panics
    ///
    /// If the formula is one in another dimension.
    #[must_use]
    pub fn residual_by_formula(&self, rule: Rule, formula: &Formula<ANY>) -> Enclosure<K> {
        let is_single = self.n() == 1.0;
        if self.check(formula).is_err()
            || is_single && self.discrete_energy_by_formula(rule, formula).is_undefined()
        {
            return Enclosure::UNDEFINED;
        }
        let mut squares = PairwiseSum::new();
        let mut before: Option<Vec<Enclosure<K>>> = None;
        for chord in self.chords() {
            let [first, last] = slopes(rule, &chord, formula);
            if let Some(before) = before {
                for (before, first) in before.iter().zip(first) {
                    squares.add((*before + first).sqr());
                }
            }
            before = Some(last);
        }
        // ∂E_N/∂xₙ is N times the sum of two slopes, and |ρₙ| is N/2 times that.
        (squares.value() * self.n()).sqrt() * (0.5 * self.n())
    }

    /// Encloses `max |βₙ|`, the greatest difference `N |xₙ₊₁ − xₙ|`, in `ℓ`.
    #[must_use]
    pub fn greatest_difference(&self) -> Enclosure<K> {
        let zero = Enclosure::point(0.0);
        let lengths = self.chords().map(|chord| {
            let square = chord.step().iter().fold(zero, |sum, step| sum + step.sqr());
            square.sqrt()
        });
        let greatest = lengths.fold(zero, |greatest, length| {
            let (lo, hi) = (greatest.lo().max(length.lo()), greatest.hi().max(length.hi()));
            // The larger of two ends would ignore a NaN.
            let is_undefined = greatest.is_undefined() || length.is_undefined();
            let largest = Enclosure::new(lo, hi).unwrap_or(Enclosure::UNDEFINED);
            if is_undefined { Enclosure::UNDEFINED } else { largest }
        });
        greatest * self.n()
    }
}

/// Returns the derivatives of `Σᵢ wᵢ dᵀ H(x + θᵢ d) d` with respect to both ends of a chord.
///
/// With `vₖ = dᵀ (∂ₖH) d` they are `Σ w (−2Hd + (1 − θ) v)` and `Σ w (2Hd + θ v)`.
fn slopes<K: Kernel>(
    rule: Rule,
    chord: &Chord<K>,
    formula: &Formula<ANY>,
) -> [Vec<Enclosure<K>>; 2] {
    let (x, d) = (chord.start(), chord.step());
    let (n, zero) = (d.len(), Enclosure::point(0.0));
    let mut slopes = [vec![zero; n], vec![zero; n]];
    for node in rule.nodes() {
        let theta = Enclosure::point(node.fraction);
        for begin in (0..n).step_by(TOGETHER) {
            let variable = |i: usize| {
                let first = |k: usize| Enclosure::point(if begin + k == i { 1.0 } else { 0.0 });
                Jet1::<_, TOGETHER>::new(x[i] + d[i] * theta, std::array::from_fn(first))
            };
            let at: Vec<_> = (0..n).map(variable).collect();
            let h = formula.gram_at(&at);
            // As everywhere, the upper triangle is H.
            let entry = |i: usize, j: usize| &h[i.max(j) * n + i.min(j)];
            for k in begin..n.min(begin + TOGETHER) {
                let (mut momentum, mut force) = (zero, zero);
                for i in 0..n {
                    momentum += entry(k, i).value() * d[i] * 2.0;
                    for j in i..n {
                        let product = if i == j { d[i].sqr() } else { d[i] * d[j] * 2.0 };
                        force += entry(i, j).first(k - begin) * product;
                    }
                }
                slopes[0][k] += (force * (1.0 - theta) - momentum) * node.weight;
                slopes[1][k] += (force * theta + momentum) * node.weight;
            }
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_chance::{Random, seed};
    use tautline_discretizations::{PointSequence, Rule, energy_gradient};
    use tautline_metrics::{
        Metric,
        gallery::{Constant, Separable, Shear, Sphere},
    };
    use tautline_scalar::{Interval, Scalar};

    use super::Polygon;

    /// The enclosures contain what doubles compute, and are no wider than rounding.
    fn check<const D: usize>(rule: Rule, metric: &impl Metric<D>) {
        let mut random = Random(seed(3));
        for n in [1, 2, 3, 17] {
            let mut points = vec![SVector::<f64, D>::from_fn(|i, _| 0.1 - 0.4 * (i % 2) as f64)];
            for _ in 0..n {
                let step = [0.1; D].map(|size| random.between(-size, size));
                points.push(points[points.len() - 1] + SVector::from(step));
            }
            let sequence = PointSequence::new(points).expect("finite");
            let (_, gradient) = energy_gradient(rule, metric, &sequence);
            let squares: f64 = gradient[1..n].iter().map(|g| g.norm_squared()).sum();
            let expected = 0.5 * (n as f64 * squares).sqrt();
            let polygon = Polygon::new(&sequence);
            let residual = polygon.residual(rule, metric);
            // About a hundred roundings, relative to the momentum N |H d|.
            let rounding = 1e-13 * (1.0 + expected);
            assert!(residual.lo() <= expected + rounding && expected - rounding <= residual.hi());
            assert!(residual.width() <= rounding, "{residual:?}");
            let greatest = sequence.differences().map(|beta| beta.norm()).fold(0.0, f64::max);
            let enclosed = polygon.greatest_difference();
            assert!(
                (enclosed.midpoint() / greatest - 1.0).abs() < 1e-15 && enclosed.width() < 1e-14
            );
        }
    }

    #[test]
    fn residuals_are_those_of_the_gradient() {
        let shear = Shear::new(0.5, 1.3).expect("a wave number");
        check(Rule::TRAPEZOIDAL, &shear);
        check(Rule::LEFT_ENDPOINT, &shear);
        check(Rule::TRUE_TRAPEZOID, &shear);
        check::<2>(Rule::LEFT_ENDPOINT, &Sphere);
    }

    /// Derivatives are taken in four directions at a time: all coordinates count, also those of the last few.
    #[test]
    fn residuals_in_more_than_four_dimensions_are_those_of_the_gradient() {
        fn in_dimension<const D: usize>() {
            for rule in [Rule::TRAPEZOIDAL, Rule::LEFT_ENDPOINT] {
                check::<D>(rule, &Sphere);
                let numbers = SVector::from_fn(|i, _| 0.3 + 0.05 * i as f64);
                check::<D>(rule, &Separable::new(numbers, numbers).expect("below one"));
            }
        }
        in_dimension::<4>();
        in_dimension::<5>();
        in_dimension::<6>();
        in_dimension::<9>();
    }

    /// Under `H = I` the residual of `(0, a, 1)` is `½ · 2 · √2 · 2 |a − (1 − a)|`.
    #[test]
    fn a_residual_by_hand() {
        let flat = Constant::new(SMatrix::<f64, 1, 1>::identity()).expect("definite");
        let points = [0.0, 0.75, 1.0].map(|x| vector![x]).to_vec();
        let sequence = PointSequence::new(points).expect("finite");
        let polygon = Polygon::new(&sequence);
        let residual = polygon.residual(Rule::TRAPEZOIDAL, &flat);
        // E₂ = 2 (x² + (1 − x)²), E₂′ = 4 (2x − 1) = 2, and ½ √(2 · 4) = √2.
        assert!(residual.lo() <= 2_f64.sqrt() && 2_f64.sqrt() <= residual.hi());
        assert!(residual.width() < 1e-15, "{residual:?}");
        assert_eq!(polygon.greatest_difference().lo(), 1.5);
        let straight = PointSequence::straight([0.0], [1.0], 2).expect("finite");
        assert_eq!(Polygon::new(&straight).residual(Rule::TRAPEZOIDAL, &flat).hi(), 0.0);
    }

    /// The other chord may be the longer one, and the undefined one the first or the last.
    #[test]
    fn nothing_is_enclosed_if_an_end_is_undefined() {
        let points = [0.0, 1.0, 4.0, 5.0].map(|x| vector![x, 0.5]).to_vec();
        let sequence = PointSequence::new(points).expect("finite");
        let polygon = Polygon::new(&sequence);
        let ends = [polygon.first(), polygon.last()].map(SVector::<_, 2>::from_column_slice);
        let [first, last] = ends;
        assert_eq!(polygon.with_ends(first, last).greatest_difference().lo(), 9.0);
        for i in 0..2 {
            let (mut from, mut to) = (first, last);
            (from[i], to[i]) = (Interval::UNDEFINED, Interval::UNDEFINED);
            for polygon in [polygon.with_ends(from, last), polygon.with_ends(first, to)] {
                assert!(polygon.greatest_difference().is_undefined(), "{polygon:?}");
                assert!(polygon.residual(Rule::TRAPEZOIDAL, &Sphere).is_undefined(), "{polygon:?}");
                assert!(
                    polygon.residual(Rule::LEFT_ENDPOINT, &Sphere).is_undefined(),
                    "{polygon:?}"
                );
                assert!(polygon.discrete_energy(Rule::TRAPEZOIDAL, &Sphere).is_undefined());
                let (energy, length) = polygon.energy_and_length(&Sphere);
                assert!(energy.is_undefined() && length.is_undefined(), "{polygon:?}");
            }
        }
    }

    /// A single chord has no inner points, but there must be an energy.
    #[test]
    fn the_residual_of_a_single_chord_is_zero_if_it_has_an_energy() {
        let hyperbolic = tautline_metrics::gallery::Hyperbolic;
        for (to, is_defined) in [(0.5, true), (4.0, false)] {
            let sequence = PointSequence::straight([0.0, 0.0], [to, 0.0], 1).expect("finite");
            let polygon = Polygon::new(&sequence);
            let residual = polygon.residual(Rule::TRAPEZOIDAL, &hyperbolic);
            assert_eq!(residual.is_undefined(), !is_defined, "{to}: {residual:?}");
            assert!(!is_defined || residual == Interval::point(0.0), "{residual:?}");
            let first = vector![Interval::point(0.0), Interval::UNDEFINED];
            let unknown = polygon.with_ends(first, polygon.last());
            assert!(unknown.residual(Rule::TRAPEZOIDAL, &hyperbolic).is_undefined());
        }
    }

    /// The energy reads both halves as one, and so does its gradient.
    #[test]
    fn nothing_is_enclosed_if_the_halves_differ() {
        struct Torn;
        impl Metric<2> for Torn {
            fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                SMatrix::<S, 2, 2>::new(S::one() * 2.0, x[0], S::zero(), S::one())
            }
        }
        for n in [1, 2, 5] {
            let sequence = PointSequence::straight([0.0, 0.0], [1.0, 0.5], n).expect("finite");
            let polygon = Polygon::new(&sequence);
            assert!(polygon.residual(Rule::TRAPEZOIDAL, &Torn).is_undefined(), "{n}");
            assert!(polygon.residual(Rule::LEFT_ENDPOINT, &Torn).is_undefined(), "{n}");
        }
    }

    #[test]
    fn nothing_is_enclosed_where_the_metric_is_undefined() {
        let sequence = PointSequence::straight([0.0, 0.0], [4.0, 0.0], 4).expect("finite");
        let hyperbolic = tautline_metrics::gallery::Hyperbolic;
        assert!(Polygon::new(&sequence).residual(Rule::LEFT_ENDPOINT, &hyperbolic).is_undefined());
    }
}
