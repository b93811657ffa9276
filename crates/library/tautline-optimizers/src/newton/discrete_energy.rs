//! `DiscreteEnergy`: the discrete energy of a rule under a metric.

use tautline_discretizations::{
    ANY, ChordBatch, Interpolation, LinearModel, Node, PointSequence, QuadraticModel, Rule,
    admissible_energy,
};
use tautline_formula::{AnyBatches, InstructionSet, Kind};
use tautline_metrics::{MetricError, check_numbers};

use crate::newton::arithmetic::small::Matrix;

/// A function of point sequences, `E_N(x) = N Σₖ Σⱼ wⱼ g(xₖ + tⱼ dₖ)(dₖ, dₖ)` with
/// `dₖ = xₖ₊₁ − xₖ`, and its derivatives.
///
/// The metric is behind a pointer, which is followed once for many chords, so that nothing is
/// compiled again for another formula, rule or dimension.
#[derive(Clone, Copy)]
pub(crate) struct DiscreteEnergy<'m> {
    nodes: &'static [Node],
    /// The exponent `q` of the error `N⁻ᑫ` of the rule.
    pub(crate) error_exponent: i32,
    metric: &'m dyn AnyBatches,
}

impl<'m> DiscreteEnergy<'m> {
    pub(crate) fn new(rule: Rule, metric: &'m dyn AnyBatches) -> Self {
        Self { nodes: rule.nodes(), error_exponent: rule.error_exponent(), metric }
    }

    /// Returns the dimension of the space.
    pub(crate) fn dimension(&self) -> usize {
        self.metric.dimension()
    }

    /// Returns the processor instructions that the metric uses.
    pub(crate) fn instruction_set(&self) -> InstructionSet {
        self.metric.instruction_set()
    }

    /// Returns the energies of chords between some points, each without the factor `N`:
    /// `Σⱼ wⱼ g(x + tⱼ d)(d, d)`. A chord is given by the numbers of its two points.
    pub(crate) fn of_chords(&self, points: &[f64], chords: &[[usize; 2]]) -> Vec<f64> {
        let mut batch = self.batch(Kind::Square, 1.0, chords.len());
        let mut energies = Vec::with_capacity(chords.len());
        for some in chords.chunks(batch.capacity()) {
            batch.evaluate_between(points, some);
            let mut terms = Vec::with_capacity(some.len() * self.nodes.len());
            batch.energies().for_first(some.len(), |term| terms.push(term));
            energies.extend(terms.chunks(self.nodes.len()).map(|terms| terms.iter().sum::<f64>()));
        }
        energies
    }

    /// Returns the energy of a trial. The result is `None` if the energy is not finite, or if a
    /// chord has negative energy at a node: the step has then left the region where the metric is
    /// positive.
    pub(crate) fn admissible(&self, points: &[f64]) -> Option<f64> {
        admissible_energy(self.nodes, self.metric, points)
    }

    /// Returns the value and the gradient.
    pub(crate) fn linear_model(&self, sequence: &PointSequence<ANY>) -> LinearModel {
        LinearModel::by_batches(self.nodes, self.metric, sequence)
    }

    /// Computes the value, the gradient and the Hessian.
    pub(crate) fn expand(&self, sequence: &PointSequence<ANY>, model: &mut QuadraticModel) {
        model.expand_by_batches(self.nodes, self.metric, sequence);
    }

    /// Returns a batch of up to `chords` chords.
    pub(crate) fn batch(&self, kind: Kind, n: f64, chords: usize) -> ChordBatch<'_> {
        ChordBatch::new(self.metric, kind, self.nodes, n, chords)
    }

    /// Checks that the Gram matrix is finite, symmetric and positive definite at a point.
    pub(crate) fn check_at(&self, x: &[f64]) -> Result<(), MetricError> {
        let mut h = Matrix::from_elem(0.0, x.len() * x.len());
        self.metric.gram_into(x, &mut h);
        check_numbers(&h, x)
    }

    /// Checks the Gram matrix at every node.
    pub(crate) fn check_nodes(&self, sequence: &PointSequence<ANY>) -> Result<(), MetricError> {
        let (n, d, points) = (sequence.n().get(), self.dimension(), sequence.coordinates());
        let mut batch = self.batch(Kind::Checked, 1.0, n);
        for begin in (0..n).step_by(batch.capacity()) {
            let end = n.min(begin + batch.capacity());
            batch.evaluate(&points[begin * d..(end + 1) * d]);
        }
        if batch.is_metric {
            return Ok(());
        }
        // The nodes are checked one by one to find the first defect.
        for k in 0..n {
            for node in self.nodes {
                let ends = sequence.row(k).iter().zip(sequence.row(k + 1));
                let x: Vec<f64> = ends.map(|(x, y)| x + (y - x) * node.fraction).collect();
                self.check_at(&x)?;
            }
        }
        Ok(())
    }

    /// Also checks the Gram matrix between the nodes, by [`Interpolation::check`], and at the ends: there it
    /// may be infinite, if the curve has a finite length, or singular, as at a pole of coordinates.
    pub(crate) fn check_between(&self, sequence: &PointSequence<ANY>) -> Result<(), MetricError> {
        let curve = Interpolation::new(sequence);
        curve.check_by_batches(self.metric)?;
        for k in [0, sequence.n().get()] {
            let Err(defect) = self.check_at(sequence.row(k)) else { continue };
            let is_allowed = match defect {
                MetricError::NotFinite { entry, .. } => {
                    entry.is_infinite() && curve.length_by_batches(self.metric).value.is_finite()
                }
                MetricError::NotPositiveDefinite { eigenvalue, .. } => eigenvalue >= 0.0,
                _ => false,
            };
            if !is_allowed {
                return Err(defect);
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_discretizations::{PointSequence, Rule, energy_gradient};
    use tautline_formula::{AnyBatches, Plain, Prepared};
    use tautline_metrics::{
        Metric, MetricError, Scalar,
        gallery::{Constant, Shear},
    };

    use super::DiscreteEnergy;

    #[track_caller]
    fn assert_sum_of_chords(rule: Rule, exponent: i32) {
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let points = vec![vector![0.0, 0.3], vector![1.0, -0.2], vector![1.5, 0.8]];
        let sequence = PointSequence::new(points).expect("finite");
        let metric = Plain::new(&shear);
        let energy = DiscreteEnergy::new(rule, &metric);
        let expected = energy_gradient(rule, &shear, &sequence).0;
        let sequence = sequence.into_any();
        let points = sequence.coordinates();
        let chords: f64 = energy.of_chords(points, &[[0, 1], [1, 2]]).iter().sum();
        // There are two chords with at most two nodes each, and about ten operations for each node,
        // so the error is below 1e-14.
        let close = |found: f64| (found - expected).abs() <= 1e-14 * expected;
        assert!(close(2.0 * chords), "{chords} {expected}");
        assert!(energy.admissible(points).is_some_and(close));
        assert!(close(energy.linear_model(&sequence).energy));
        assert_eq!(energy.error_exponent, exponent);
    }

    #[test]
    fn the_energy_is_the_sum_over_chords() {
        assert_sum_of_chords(Rule::TRAPEZOIDAL, 2);
        assert_sum_of_chords(Rule::LEFT_ENDPOINT, 1);
        assert_sum_of_chords(Rule::TRUE_TRAPEZOID, 2);
    }

    /// One chord is long, and each of the short ones would be rounded away when added to it.
    #[test]
    fn the_energy_of_a_trial_is_summed_with_compensation() {
        let flat = Constant::new(nalgebra::SMatrix::<f64, 1, 1>::identity()).expect("definite");
        let metric = Plain::<_, 1>::new(&flat);
        let energy = DiscreteEnergy::new(Rule::TRAPEZOIDAL, &metric);
        let n = (1 << 16) + 1;
        let short = 2.0_f64.powi(-27);
        let points: Vec<_> = (0..=n)
            .map(|k| vector![if k == 0 { 0.0 } else { 1.0 + f64::from(k - 1) * short }])
            .collect();
        // All terms are dyadic: 1 + 2¹⁶ 2⁻⁵⁴, times N.
        let expected = f64::from(n) * (1.0 + 2.0_f64.powi(-38));
        let sequence = PointSequence::new(points).expect("finite").into_any();
        assert_eq!(energy.admissible(sequence.coordinates()), Some(expected));
        assert_eq!(energy.linear_model(&sequence).energy, expected);
    }

    /// Every node of every chord is checked, including the last ones.
    #[test]
    fn a_defect_is_reported_at_whichever_node_it_is() {
        assert_sum_of_chords(Rule::SIMPSON, 2);
        for chord in 0..3 {
            for node in 0..3 {
                let place = f64::from(chord) + 0.5 * f64::from(node);
                // (x₁ − place)² is a metric everywhere except at one place.
                struct Hole(f64);
                impl Metric<1> for Hole {
                    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                        SMatrix::from_element((x[0] - self.0).sqr())
                    }
                }
                let hole = Hole(place);
                let (plain, prepared) = (Plain::new(&hole), Prepared::new(&hole));
                // There is one batch, or several with the hole in the first or in the last but one.
                for (n, from) in [(3, 0.0), (100, 0.0), (100, -96.0)] {
                    // The points are whole numbers, so that a node is exactly at the hole.
                    let points = (0..=n).map(|k| vector![from + f64::from(k)]).collect();
                    let sequence = PointSequence::new(points).expect("finite").into_any();
                    for metric in [&plain as &dyn AnyBatches, &prepared] {
                        let energy = DiscreteEnergy::new(Rule::SIMPSON, metric);
                        match energy.check_nodes(&sequence) {
                            Err(MetricError::NotPositiveDefinite { point, .. }) => {
                                assert_eq!(point, [place]);
                            }
                            other => panic!("{other:?}"),
                        }
                    }
                }
            }
        }
        let metric = Plain::new(&ToTheRight);
        let energy = DiscreteEnergy::new(Rule::SIMPSON, &metric);
        assert!(energy.check_at(&[1.0, 0.0]).is_ok());
        assert!(energy.check_at(&[-1.0, 0.0]).is_err());
    }

    /// The matrix `H = x₁ I`, which is a metric only to the right of 0.
    struct ToTheRight;

    impl Metric<2> for ToTheRight {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::from_diagonal_element(x[0])
        }
    }

    #[test]
    fn a_trial_with_one_negative_chord_has_no_energy() {
        let metric = Plain::new(&ToTheRight);
        let energy = DiscreteEnergy::new(Rule::TRAPEZOIDAL, &metric);
        let over = |lowest: f64| energy.admissible(&[8.0, 0.0, lowest, 0.0, lowest, 0.5]);
        // The energy is 2 (9/2 · 7² + 1 · 1/4).
        assert_eq!(over(1.0), Some(441.5));
        // The sum is positive, but the second chord is negative.
        assert_eq!(over(-1.0), None);
        assert_eq!(over(f64::NAN), None);
    }
}
