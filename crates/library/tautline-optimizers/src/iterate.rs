//! `Iterate`: what a search tells of each of its iterates.

use std::ops::ControlFlow;

use tautline_discretizations::{LinearModel, PointSequence, Rule};
use tautline_formula::Batches;
use tautline_sets::{ClosedSet, InAny};

use crate::newton::{magnitude::Magnitude, residual::Residual};

/// An iterate of a search for a discrete minimiser, whatever the method.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Iterate<'i, const D: usize> {
    /// The number of steps of the local search before this iterate. It begins at 0 from each start
    /// and on each grid.
    pub iteration: usize,
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// The [residual](crate::Minimum::residual) of the discrete geodesic equation, by which
    /// methods without second derivatives stop. It is infinite where the energy is negative or NaN,
    /// as where there is no metric.
    pub residual: f64,
    /// The [residual that rounding causes](crate::Minimum::residual_floor).
    pub residual_floor: f64,
    /// The point sequence.
    pub sequence: &'i PointSequence<D>,
}

/// Sees each iterate, and says whether the search goes on.
pub type Watcher<'w, const D: usize> = dyn FnMut(&Iterate<'_, D>) -> ControlFlow<()> + 'w;

/// The residual of an iterate uses the metric at the nodes of at most this number of chords, since
/// only its mean matters. More would cost a method without second derivatives as much as a step.
const SAMPLED: usize = 64;

impl<'i, const D: usize> Iterate<'i, D> {
    /// Returns the iterate at a sequence with the energy and the gradient of `model`.
    ///
    /// The mean of `tr H / D`, to which the residual is relative, is that over the nodes of at most
    /// 64 chords, evenly spaced.
    #[must_use]
    pub fn new(
        rule: Rule,
        metric: &dyn Batches<D>,
        ends: [&dyn ClosedSet<D>; 2],
        sequence: &'i PointSequence<D>,
        model: &LinearModel,
        iteration: usize,
    ) -> Self {
        let n = sequence.n().get();
        let chords = (0..n).step_by(n.div_ceil(SAMPLED)).map(|k| sequence.chord(k));
        let (mut sum, mut count) = (0.0, 0.0);
        for (x, d) in chords {
            count += D as f64;
            for node in rule.nodes() {
                sum += node.weight * metric.gram(&(x + d * node.fraction)).trace();
            }
        }
        let magnitude = Magnitude { energy: model.energy, mean_gram: sum / count };
        let mut residual = Residual::new(D, n, magnitude);
        residual.push_all(&model.slopes);
        let [first, second] = ends.map(InAny);
        let place = sequence.clone().into_any();
        let (residual, residual_floor) = residual.value([&first, &second], &place, magnitude);
        Self { iteration, energy: model.energy, residual, residual_floor, sequence }
    }

    /// Returns whether the residual is at most `tolerance`, or cannot be lowered in `f64`.
    #[must_use]
    pub fn is_stationary(&self, tolerance: f64) -> bool {
        self.residual <= tolerance.max(self.residual_floor)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_discretizations::{LinearModel, PointSequence, QuadraticModel, Rule};
    use tautline_formula::Prepared;
    use tautline_metrics::gallery::{Swirl, Valleys};
    use tautline_sets::{Ball, ClosedSet, InAny};

    use super::Iterate;
    use crate::newton::{magnitude::Magnitude, residual::Residual};

    /// Up to 64 chords the mean over the sample is the mean over all nodes, with their weights, so that the
    /// residual is that of the solver up to rounding.
    #[test]
    fn every_method_has_the_residual_of_the_solver() {
        check(Rule::TRAPEZOIDAL);
        check(Rule::LEFT_ENDPOINT);
        check(Rule::SIMPSON);
    }

    fn check(rule: Rule) {
        let swirl = Swirl::new(0.5, 1.0).expect("a width");
        let ball = Ball::new([-1.0, 0.0], 0.25).expect("a radius");
        let far = Ball::new([1.5, 0.5], 0.5).expect("a radius");
        let ends: [&dyn ClosedSet<2>; 2] = [&ball, &far];
        for n in [1, 7, 64] {
            let at = |k: usize| {
                let t = k as f64 / n as f64;
                vector![2.0 * t - 0.75, 0.5 * t + 0.3 * (3.0 * t).sin()]
            };
            let sequence = PointSequence::new((0..=n).map(at).collect()).expect("finite");
            let model = QuadraticModel::new(rule, &swirl, &sequence);
            let magnitude = Magnitude::of(&model);
            let mut residual = Residual::new(2, n, magnitude);
            residual.push_all(&model.slopes);
            let (expected, floor) = residual.value(
                [&InAny(ends[0]), &InAny(ends[1])],
                &sequence.clone().into_any(),
                magnitude,
            );
            let metric = Prepared::new(swirl);
            let linear = LinearModel::by_batches(rule.nodes(), &metric, &sequence);
            let found = Iterate::new(rule, &metric, ends, &sequence, &linear, 3);
            // Sums of n rounded terms of the same size.
            let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b;
            assert!(close(found.residual, expected) && expected > 0.01, "{found:?} {expected}");
            assert!(close(found.residual_floor, floor) && close(found.energy, model.energy));
            assert!(found.is_stationary(expected * 1.01) && !found.is_stationary(expected * 0.99));
            assert_eq!(found.iteration, 3);
        }
    }

    /// The residual is relative to the root of the mean of the metric, which is over every sixteenth
    /// chord here. The metric of the valleys varies by a factor of 9 over the whole line, and by 3 %
    /// over 16 chords.
    #[test]
    fn a_sample_of_the_chords_gives_the_scale_of_a_long_sequence() {
        let n = 1000;
        let at = |k: usize| {
            let t = k as f64 / n as f64;
            vector![6.0 * t, (3.0 * t).sin()]
        };
        let sequence = PointSequence::new((0..=n).map(at).collect()).expect("finite");
        let ends = [*sequence.first(), *sequence.last()];
        let ends = ends.map(|x| tautline_sets::Point::new(x).expect("finite"));
        let ends: [&dyn ClosedSet<2>; 2] = [&ends[0], &ends[1]];
        let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &Valleys, &sequence);
        let magnitude = Magnitude::of(&model);
        let mut residual = Residual::new(2, n, magnitude);
        residual.push_all(&model.slopes);
        let (expected, _) = residual.value(
            [&InAny(ends[0]), &InAny(ends[1])],
            &sequence.clone().into_any(),
            magnitude,
        );
        let linear = LinearModel::new(Rule::TRAPEZOIDAL, &Valleys, &sequence);
        let metric = Prepared::new(Valleys);
        let found = Iterate::new(Rule::TRAPEZOIDAL, &metric, ends, &sequence, &linear, 0);
        assert!((found.residual / expected - 1.0).abs() < 0.02, "{found:?} {expected}");
    }
}
