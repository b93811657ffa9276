//! `Rule`: where on each chord the metric is evaluated.

use std::fmt;

use nalgebra::SVector;
use tautline_bounds::{BoundError, PaperRule};
use tautline_formula::{AnyBatches, AnyMetric, Plain};
use tautline_metrics::{Metric, norm_squared};

use crate::{PointSequence, compensated_sum::CompensatedSum, gram_square::gram_square};

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
/// All rules share the code of the discrete energy. The rules of this library are the constants
/// below; [`Rule::ALL`] lists them. A rule of your own may look like this:
///
/// ```
/// use tautline_discretizations::{Node, PeanoConstants, Rule};
///
/// /// Three eighths: Simpson's second rule.
/// const THREE_EIGHTHS: Rule = Rule::new(
///     "three_eighths",
///     &[
///         Node { fraction: 0.0, weight: 1.0 / 8.0 },
///         Node { fraction: 1.0 / 3.0, weight: 3.0 / 8.0 },
///         Node { fraction: 2.0 / 3.0, weight: 3.0 / 8.0 },
///         Node { fraction: 1.0, weight: 1.0 / 8.0 },
///     ],
///     2,
/// );
/// assert!(PeanoConstants::of(THREE_EIGHTHS).second < 1.0 / 100.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    name: &'static str,
    // Invariant: never empty.
    nodes: &'static [Node],
    error_exponent: i32,
    paper_rule: Option<PaperRule>,
}

impl Rule {
    /// Returns the rule with this name, these nodes on each chord, and this
    /// [exponent of the error](Rule::error_exponent). No statement of the paper concerns it.
    ///
    /// Make it a `const`: a rule without nodes then does not compile.
    ///
    /// ```compile_fail
    /// # use tautline_discretizations::Rule;
    /// const NOWHERE: Rule = Rule::new("nowhere", &[], 2);
    /// # assert_eq!(NOWHERE.nodes(), []);
    /// ```
    ///
    /// # Panics
    ///
    /// If there are no nodes and the rule is not a `const`.
    #[must_use]
    pub const fn new(name: &'static str, nodes: &'static [Node], error_exponent: i32) -> Self {
        assert!(!nodes.is_empty(), "a rule needs a node");
        Self { name, nodes, error_exponent, paper_rule: None }
    }

    /// Returns the same rule as the one that the paper speaks of.
    pub(crate) const fn of_the_paper(self, rule: PaperRule) -> Self {
        Self { paper_rule: Some(rule), ..self }
    }

    /// Returns the rule of this library with this name, if there is one.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|rule| rule.name == name)
    }

    /// Returns the name that files, Python and answers use, such as `left_endpoint`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.name
    }

    /// Returns the nodes of the rule on each chord. There is at least one.
    #[must_use]
    pub const fn nodes(self) -> &'static [Node] {
        self.nodes
    }

    /// Returns the exponent `q` of `E_N,min − d² = c₁ N⁻ᑫ + c₂ N⁻²ᑫ + …` on smooth data, for
    /// extrapolation to `N = ∞`.
    ///
    /// It is 2 for a rule that is symmetric about the midpoint of a chord, and otherwise 1.
    #[must_use]
    pub const fn error_exponent(self) -> i32 {
        self.error_exponent
    }

    /// Returns which rule of the paper it is.
    ///
    /// # Errors
    ///
    /// [`BoundError::OtherRule`] for a rule that the theorems do not speak of.
    pub fn paper_rule(self) -> Result<PaperRule, BoundError> {
        self.paper_rule.ok_or(BoundError::OtherRule { rule: self.name })
    }

    /// Returns the discrete energy `E_N = (1/N) Σₙ Σᵢ wᵢ βₙᵀ H βₙ`, in `m²`.
    ///
    /// The result is NaN if the metric is NaN.
    #[must_use]
    pub fn energy<const D: usize>(
        self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        // βᵀHβ / N = N dᵀHd, where d is the chord.
        sequence.n().get() as f64
            * sum(self.nodes, &AnyMetric::new(metric), sequence, |square| square)
    }

    /// Returns the discrete length `L_N = (1/N) Σₙ Σᵢ wᵢ (βₙᵀ H βₙ)^{1/2}`, in `m`.
    ///
    /// The minimum of the discrete length does not converge to the distance (Section 5), so
    /// minimise the energy.
    #[must_use]
    pub fn length<const D: usize>(
        self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        sum(self.nodes, &AnyMetric::new(metric), sequence, f64::sqrt)
    }

    /// Returns the discrete speeds `(Σᵢ wᵢ βₙᵀ H βₙ)^{1/2}`, in `m`, for `n = 0, …, N − 1`.
    ///
    /// The speeds are nearly equal for a minimiser of the energy, since a geodesic has constant
    /// speed (Proposition 3.1). They are arbitrary for a minimiser of the length.
    #[must_use]
    pub fn speeds<const D: usize>(
        self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<f64> {
        self.speeds_by_batches(&Plain::new(metric), sequence)
    }

    /// Returns the speeds like [`speeds`](Rule::speeds), for a metric that is evaluated in batches.
    #[must_use]
    pub fn speeds_by_batches<const D: usize>(
        self,
        metric: &dyn AnyBatches,
        sequence: &PointSequence<D>,
    ) -> Vec<f64> {
        let n = sequence.n().get();
        let speed = |k: usize| {
            let ends = || sequence.row(k).iter().zip(sequence.row(k + 1));
            let d: Vec<f64> = ends().map(|(x, y)| y - x).collect();
            let squares = self.nodes.iter().map(|node| {
                let x: Vec<f64> = ends().map(|(x, y)| x + (y - x) * node.fraction).collect();
                node.weight * gram_square(metric, &x, &d)
            });
            n as f64 * squares.sum::<f64>().sqrt()
        };
        (0..n).map(speed).collect()
    }
}

/// The paper's trapezoidal rule.
impl Default for Rule {
    fn default() -> Self {
        Self::TRAPEZOIDAL
    }
}

/// Writes the name of the rule.
impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

impl From<PaperRule> for Rule {
    fn from(rule: PaperRule) -> Self {
        match rule {
            PaperRule::Trapezoidal => Rule::TRAPEZOIDAL,
            PaperRule::LeftEndpoint => Rule::LEFT_ENDPOINT,
        }
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

#[cfg(test)]
mod tests {
    use super::{BoundError, PaperRule, Rule};

    #[test]
    fn every_rule_has_a_name_of_its_own() {
        for rule in Rule::ALL {
            assert_eq!(Rule::named(rule.name()), Some(*rule));
        }
        assert_eq!(Rule::named("midpoint"), None);
    }

    #[test]
    fn two_rules_are_those_of_the_paper() {
        for rule in PaperRule::BOTH {
            assert_eq!(Rule::from(rule).paper_rule(), Ok(rule));
            assert_eq!(Rule::from(rule).name(), rule.name());
        }
        let of_the_paper = Rule::ALL.iter().filter(|rule| rule.paper_rule().is_ok());
        assert_eq!(of_the_paper.count(), PaperRule::BOTH.len());
        let error = Rule::SIMPSON.paper_rule();
        assert_eq!(error, Err(BoundError::OtherRule { rule: "simpson" }));
    }
}
