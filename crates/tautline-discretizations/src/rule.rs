//! `Rule`: where on each chord the metric is evaluated.

use nalgebra::SVector;
use tautline_formula::AnyMetric;
use tautline_metrics::{Metric, norm_squared};

use crate::{PointSequence, compensated_sum::CompensatedSum};

/// A place on a chord and its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The fraction `θ ∈ [0, 1]` of the chord; `0` is its first point, `1` its last.
    pub fraction: f64,
    /// The weight `w ≥ 0`. The weights of a rule add up to 1.
    pub weight: f64,
}

/// A rule of numerical integration, given by its nodes on a chord.
///
/// A rule consists of its nodes alone; all rules share the code of the discrete energy. A rule of
/// your own may look like this:
///
/// ```
/// use tautline_discretizations::{Node, PeanoConstants, Rule};
///
/// /// Three eighths: Simpson's second rule.
/// #[derive(Clone, Copy, Debug)]
/// struct ThreeEighths;
/// impl Rule for ThreeEighths {
///     const NODES: &'static [Node] = &[
///         Node { fraction: 0.0, weight: 1.0 / 8.0 },
///         Node { fraction: 1.0 / 3.0, weight: 3.0 / 8.0 },
///         Node { fraction: 2.0 / 3.0, weight: 3.0 / 8.0 },
///         Node { fraction: 1.0, weight: 1.0 / 8.0 },
///     ];
///     const ERROR_EXPONENT: i32 = 2;
/// }
/// assert!(PeanoConstants::of(ThreeEighths).second < 1.0 / 100.0);
/// ```
pub trait Rule: Copy + std::fmt::Debug + Send + Sync {
    /// The nodes of the rule on each chord.
    const NODES: &'static [Node];

    /// The exponent `q` of `E_N,min − d² = c₁ N⁻ᑫ + c₂ N⁻²ᑫ + …` on smooth data, for extrapolation
    /// to `N = ∞`.
    ///
    /// It is 2 for a rule that is symmetric about the midpoint of a chord, and otherwise 1.
    const ERROR_EXPONENT: i32;

    /// Returns the discrete energy `E_N = (1/N) Σₙ Σᵢ wᵢ βₙᵀ H βₙ`, in `m²`.
    ///
    /// The result is NaN if the metric is NaN.
    fn energy<const D: usize>(&self, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> f64 {
        // βᵀHβ / N = N dᵀHd, where d is the chord.
        sequence.n().get() as f64
            * sum(Self::NODES, &AnyMetric::new(metric), sequence, |square| square)
    }

    /// Returns the discrete length `L_N = (1/N) Σₙ Σᵢ wᵢ (βₙᵀ H βₙ)^{1/2}`, in `m`.
    ///
    /// The minimum of the discrete length does not converge to the distance (Section 5), so
    /// minimise the energy.
    fn length<const D: usize>(&self, metric: &impl Metric<D>, sequence: &PointSequence<D>) -> f64 {
        sum(Self::NODES, &AnyMetric::new(metric), sequence, f64::sqrt)
    }

    /// Returns the discrete speeds `(Σᵢ wᵢ βₙᵀ H βₙ)^{1/2}`, in `m`, for `n = 0, …, N − 1`.
    ///
    /// The speeds are nearly equal for a minimiser of the energy, since a geodesic has constant
    /// speed (Proposition 3.1). They are arbitrary for a minimiser of the length.
    fn speeds<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<f64> {
        speeds(Self::NODES, &AnyMetric::new(metric), sequence)
    }
}

/// A function of `dᵀHd` alone.
type OfSquare = fn(f64) -> f64;

/// Returns `Σᵢ wᵢ f(dᵀ H(x + θᵢ d) d)` for one chord.
fn chord_sum<const D: usize>(
    nodes: &[Node],
    metric: &AnyMetric<'_, D>,
    x: &SVector<f64, D>,
    d: &SVector<f64, D>,
    f: OfSquare,
) -> f64 {
    nodes
        .iter()
        .map(|node| node.weight * f(norm_squared(metric, &(x + d * node.fraction), d)))
        .sum()
}

fn sum<const D: usize>(
    nodes: &[Node],
    metric: &AnyMetric<'_, D>,
    sequence: &PointSequence<D>,
    f: OfSquare,
) -> f64 {
    let terms = sequence.chords().map(|(x, d)| chord_sum(nodes, metric, x, &d, f));
    terms.collect::<CompensatedSum>().value()
}

fn speeds<const D: usize>(
    nodes: &[Node],
    metric: &AnyMetric<'_, D>,
    sequence: &PointSequence<D>,
) -> Vec<f64> {
    let n = sequence.n().get() as f64;
    let square = |(x, d)| chord_sum(nodes, metric, x, &d, |square| square);
    sequence.chords().map(|chord| n * square(chord).sqrt()).collect()
}
