//! `equal_speeds`: sequential quadratic programming.

use nalgebra::SVector;
use tautline::{Batches, ChordModel, LinearModel, PointSequence, Rule, Watcher};

use crate::{
    descent::{
        Descended, DescentError, Ended, Limits,
        chord_models::chord_models,
        search::{Here, Search},
    },
    equal_speeds::kkt_step::KktStep,
};

/// Where the search ended: a sequence that is called stationary or not, and not more.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct EqualSpeeds<const D: usize> {
    /// The sequence, its energy, and how the search ended. The residual is that of the Lagrangian
    /// `N Σ λₙ wₙ`, with the energies `wₙ = eₙ/N` of the chords and their multipliers `λₙ`, whose
    /// sum is 1.
    pub descended: Descended<D>,
    /// The largest relative difference of a discrete speed from their root mean square `√E_N`.
    pub speed_residual: f64,
}

/// The first shift of the Hessian relative to that of the energy, the factor from one to the next,
/// and the last.
const SHIFTS: [f64; 3] = [1e-3, 8.0, 1e9];

/// The shortest step along a solution of the quadratic problem.
const SHORTEST: f64 = 1e-6;

/// The fraction of the predicted decrease of the merit that a step has to achieve.
const SUFFICIENT: f64 = 1e-4;

/// Minimises a discrete energy between the ends of `start` among the sequences whose discrete
/// speeds are equal, by sequential quadratic programming.
///
/// Each step solves the linearised conditions of optimality, a banded system, in `O(N D³)`. It is
/// shortened until `σ + ν Σ |wₙ − σ|` falls, or taken whole if both residuals become half as large.
/// Take the minimiser without constraints as the start: its speeds are nearly equal, and the search
/// then takes a few steps. The search ends when the residual of the Lagrangian and the
/// [`speed_residual`](EqualSpeeds::speed_residual) are at most the tolerance of `limits`.
///
/// `watcher` sees each iterate, with the residual of the Lagrangian, and can end the search.
///
/// # Errors
///
/// [`DescentError`]: the start has no metric or no finite energy.
///
/// # Source
///
/// Equation (2.1) (`eq:liu2017`) of the paper, after Liu et al. (2017); N. I. M. Gould, On practical
/// conditions for the existence and uniqueness of solutions to the general equality quadratic
/// programming problem, Math. Program. 32 (1985).
pub fn equal_speeds<'a, const D: usize>(
    metric: &'a dyn Batches<D>,
    rule: Rule,
    start: PointSequence<D>,
    limits: &Limits,
    watcher: &'a mut Watcher<'a, D>,
) -> Result<EqualSpeeds<D>, DescentError> {
    let (mut search, here) = Search::begin(metric, rule, start, limits, watcher)?;
    let n = here.sequence.n().get();
    let [first, factor, last] = SHIFTS;
    let (mut shift, mut penalty) = (0.0, 0.0_f64);
    let multipliers = vec![1.0 / n as f64; n];
    // On the edge of positive definite, two programs may round to either side.
    let Some(mut at) = At::new(metric, rule.nodes(), here.sequence.clone(), multipliers) else {
        let descended = search.descended(here, Ended::Stalled, 0);
        return Ok(EqualSpeeds { descended, speed_residual: f64::INFINITY });
    };
    for iteration in 0.. {
        let speeds = at.speed_residual();
        if let Some(ended) = search.end_if(&at.here, iteration, speeds <= limits.tolerance) {
            let descended = search.descended(at.here, ended, iteration);
            return Ok(EqualSpeeds { descended, speed_residual: speeds });
        }
        let next = loop {
            let size = shift * at.here.stiffness() / n as f64;
            let step = KktStep::new(&at.chords, &at.multipliers, size);
            let found = step.and_then(|step| {
                let largest = step.multipliers.iter().map(|l| l.abs()).fold(0.0, f64::max);
                penalty = penalty.max(2.0 * largest);
                at.follow(&mut search, &step, penalty)
            });
            if found.is_some() || shift > last {
                break found;
            }
            shift = (factor * shift).max(first);
        };
        let Some(next) = next else {
            let descended = search.descended(at.here, Ended::Stalled, iteration);
            return Ok(EqualSpeeds { descended, speed_residual: speeds });
        };
        shift = if shift <= first { 0.0 } else { shift / factor };
        at = next;
    }
    unreachable!("a search ends at its limit of steps")
}

/// An iterate: the sequence with the energy and the gradient of the Lagrangian.
struct At<const D: usize> {
    here: Here<D>,
    chords: Vec<ChordModel<D>>,
    multipliers: Vec<f64>,
}

impl<const D: usize> At<D> {
    fn new(
        metric: &dyn Batches<D>,
        nodes: &'static [tautline::Node],
        sequence: PointSequence<D>,
        multipliers: Vec<f64>,
    ) -> Option<Self> {
        let chords = chord_models(metric, nodes, &sequence)?;
        let n = chords.len();
        let mut gradient = vec![SVector::zeros(); n + 1];
        for (k, (chord, multiplier)) in chords.iter().zip(&multipliers).enumerate() {
            gradient[k] += chord.gradient[0] * (n as f64 * multiplier);
            gradient[k + 1] += chord.gradient[1] * (n as f64 * multiplier);
        }
        let energy = chords.iter().map(|chord| chord.energy).sum();
        let model = LinearModel::with_gradient(energy, gradient);
        Some(Self { here: Here { sequence, model }, chords, multipliers })
    }

    /// Returns the mean energy of a chord, the level to which all should come.
    fn mean(&self) -> f64 {
        self.here.energy() / self.chords.len() as f64
    }

    fn speed_residual(&self) -> f64 {
        let off = |chord: &ChordModel<D>| ((chord.energy / self.mean()).sqrt() - 1.0).abs();
        self.chords.iter().map(off).fold(0.0, f64::max)
    }

    /// Returns `Σ |wₙ − σ|` for the mean `σ`.
    fn infeasibility(&self) -> f64 {
        self.chords.iter().map(|chord| (chord.energy - self.mean()).abs()).sum()
    }

    /// Takes a step, all of it or less; `None` if nothing is gained.
    fn follow(&self, search: &mut Search<'_, D>, step: &KktStep<D>, penalty: f64) -> Option<Self> {
        let merit = |at: &Self| at.mean() + penalty * at.infeasibility();
        let promised = self.mean() - step.level + penalty * self.infeasibility();
        let mut scale = 1.0;
        while scale >= SHORTEST {
            let points = self.here.moved(&step.step, scale);
            if search.energy(&points).is_some()
                && let Ok(sequence) = PointSequence::new(points)
            {
                search.evaluations += 1;
                let mix = |(new, old): (&f64, &f64)| old + (new - old) * scale;
                let multipliers = step.multipliers.iter().zip(&self.multipliers).map(mix).collect();
                let next = Self::new(search.metric, search.rule.nodes(), sequence, multipliers);
                if let Some(next) = next
                    && (merit(&next) <= merit(self) - SUFFICIENT * scale * promised
                        || self.halves(search, &next))
                {
                    return Some(next);
                }
            }
            scale *= 0.5;
        }
        None
    }

    /// Returns whether the larger of both residuals becomes half as large.
    fn halves(&self, search: &Search<'_, D>, next: &Self) -> bool {
        let larger = |at: &Self| search.residual(&at.here).max(at.speed_residual());
        larger(next) <= 0.5 * larger(self)
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use nalgebra::vector;
    use tautline::{Iterate, PointSequence, Prepared, Rule, gallery::Valleys};

    use super::{At, KktStep, Search};
    use crate::descent::Limits;

    /// A step has to achieve a fraction of the decrease of the merit that it promises. One that claims to end
    /// at a level far below 0 is not taken, although it lowers the merit.
    #[test]
    fn a_step_that_promises_too_much_is_not_taken() {
        let metric = Prepared::new(Valleys);
        let points =
            vec![vector![0.0, 0.0], vector![0.9, 0.4], vector![1.6, 0.2], vector![2.5, 0.0]];
        let start = PointSequence::new(points).expect("finite");
        let watch = &mut |_: &Iterate<'_, 2>| ControlFlow::Continue(());
        let limits = Limits::default();
        let begun = Search::begin(&metric, Rule::TRAPEZOIDAL, start, &limits, watch);
        let (mut search, here) = begun.expect("a metric");
        let multipliers = vec![1.0 / 3.0; 3];
        let at = At::new(&metric, Rule::TRAPEZOIDAL.nodes(), here.sequence, multipliers);
        let at = at.expect("a metric");
        let size = at.here.stiffness();
        let mut step = KktStep::new(&at.chords, &at.multipliers, size).expect("definite");
        // A tenth of the step makes no residual half as large.
        step.step.iter_mut().for_each(|step| *step *= 0.1);
        step.multipliers.clone_from(&at.multipliers);
        let penalty = 2.0;
        assert!(at.follow(&mut search, &step, penalty).is_some());
        step.level = -1e6;
        assert!(at.follow(&mut search, &step, penalty).is_none());
    }
}
