//! `Search`: what all descents share.

use std::ops::ControlFlow;

use nalgebra::SVector;
use tautline::{
    Batches, Iterate, LinearModel, Point, PointSequence, Rule, Watcher, admissible_energy,
    check_matrix, coordinates,
};

use crate::descent::{Descended, DescentError, Ended, Limits};

/// A descent by one rule under one metric, and what it has cost so far.
pub(crate) struct Search<'a, const D: usize> {
    pub(crate) metric: &'a dyn Batches<D>,
    pub(crate) rule: Rule,
    limits: Limits,
    watcher: &'a mut Watcher<'a, D>,
    ends: [Point<D>; 2],
    pub(crate) evaluations: usize,
    /// The residual of the last iterate, and its floor.
    residuals: [f64; 2],
}

/// A sequence with its energy and gradient.
pub(crate) struct Here<const D: usize> {
    pub(crate) sequence: PointSequence<D>,
    pub(crate) model: LinearModel,
}

/// An energy that has risen by this multiple of itself may have fallen: the sums of trials are
/// rounded a few times, with compensation.
pub(crate) const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// The fraction of the predicted decrease that a step has to achieve (Armijo).
pub(crate) const SUFFICIENT: f64 = 1e-4;

impl<'a, const D: usize> Search<'a, D> {
    /// Begins a descent at `start`, whose metric is checked at the nodes and ends.
    pub(crate) fn begin(
        metric: &'a dyn Batches<D>,
        rule: Rule,
        start: PointSequence<D>,
        limits: &Limits,
        watcher: &'a mut Watcher<'a, D>,
    ) -> Result<(Self, Here<D>), DescentError> {
        let &Limits { tolerance, .. } = limits;
        if !(tolerance >= 0.0) {
            return Err(DescentError::Tolerance { tolerance });
        }
        let nodes = start.chords().flat_map(|(x, d)| {
            let x = *x;
            rule.nodes().iter().map(move |node| x + d * node.fraction)
        });
        for x in nodes.chain([*start.first(), *start.last()]) {
            check_matrix(metric.gram(&x), &x)?;
        }
        let ends = [*start.first(), *start.last()];
        let ends = ends.map(|x| Point::new(x).expect("the points of a sequence are finite"));
        let mut search = Self {
            metric,
            rule,
            limits: *limits,
            watcher,
            ends,
            evaluations: 0,
            residuals: [f64::INFINITY; 2],
        };
        let here = search.at(start);
        let moves = here.sequence.points().iter().any(|x| x != here.sequence.first());
        if here.energy().is_finite() && (here.energy() >= f64::MIN_POSITIVE || !moves) {
            Ok((search, here))
        } else {
            Err(DescentError::Energy { energy: here.energy() })
        }
    }

    /// Returns the iterate at a sequence.
    pub(crate) fn at(&mut self, sequence: PointSequence<D>) -> Here<D> {
        self.evaluations += 1;
        let model = LinearModel::by_batches(self.rule.nodes(), self.metric, &sequence);
        Here { sequence, model }
    }

    /// Shows an iterate to the watcher, and returns why the descent ends there, if it does.
    pub(crate) fn end_at(&mut self, here: &Here<D>, iteration: usize) -> Option<Ended> {
        self.end_if(here, iteration, true)
    }

    /// Ends like [`end_at`](Search::end_at), but calls an iterate stationary only if it is feasible
    /// too.
    pub(crate) fn end_if(
        &mut self,
        here: &Here<D>,
        iteration: usize,
        is_feasible: bool,
    ) -> Option<Ended> {
        let ends = [&self.ends[0] as _, &self.ends[1] as _];
        let Here { sequence, model } = here;
        let iterate = Iterate::new(self.rule, self.metric, ends, sequence, model, iteration);
        self.residuals = [iterate.residual, iterate.residual_floor];
        let answer = (self.watcher)(&iterate);
        if is_feasible && iterate.is_stationary(self.limits.tolerance) {
            Some(Ended::Stationary)
        } else if answer == ControlFlow::Break(()) {
            Some(Ended::Interrupted)
        } else {
            (iteration == self.limits.iterations).then_some(Ended::IterationLimit)
        }
    }

    /// Returns the residual at an iterate.
    pub(crate) fn residual(&self, here: &Here<D>) -> f64 {
        let ends = [&self.ends[0] as _, &self.ends[1] as _];
        Iterate::new(self.rule, self.metric, ends, &here.sequence, &here.model, 0).residual
    }

    /// Returns the energy at other inner points, or `None` if the metric is not positive there.
    pub(crate) fn energy(&mut self, points: &[SVector<f64, D>]) -> Option<f64> {
        self.evaluations += 1;
        admissible_energy(self.rule.nodes(), self.metric, coordinates(points))
    }

    /// Returns the result of a descent that ends here, at the iterate that was shown last.
    pub(crate) fn descended(&self, here: Here<D>, ended: Ended, iterations: usize) -> Descended<D> {
        let [residual, residual_floor] = self.residuals;
        let (energy, sequence) = (here.energy(), here.sequence);
        let evaluations = self.evaluations;
        Descended { sequence, energy, residual, residual_floor, ended, iterations, evaluations }
    }
}

impl<const D: usize> Here<D> {
    /// Returns the discrete energy, in `m²`.
    pub(crate) fn energy(&self) -> f64 {
        self.model.energy
    }

    /// Returns the gradient with respect to the inner points, in `m²/ℓ`.
    pub(crate) fn gradient(&self) -> &[SVector<f64, D>] {
        &self.model.gradient()[1..self.sequence.n().get()]
    }

    /// Returns `2 N E/K₃²` with the root mean square `K₃` of the differences, in `m²/ℓ²`: the
    /// Hessian of the energy is this number times the [second
    /// differences](crate::descent::laplacian::Laplacian) if the metric is constant and the same in
    /// all directions.
    pub(crate) fn stiffness(&self) -> f64 {
        2.0 * self.sequence.n().get() as f64 * (self.energy() / self.sequence.k3().powi(2))
    }

    /// Returns whether a step to the energy `there` achieves enough of the decrease that its slope
    /// promises.
    pub(crate) fn falls_enough(&self, there: f64, promised: f64) -> bool {
        there <= self.energy() * (1.0 + ROUNDING) - SUFFICIENT * promised
    }

    /// Returns all points, with the inner ones moved by `scale · step`.
    pub(crate) fn moved(&self, step: &[SVector<f64, D>], scale: f64) -> Vec<SVector<f64, D>> {
        let mut points = self.sequence.points().to_vec();
        points[1..].iter_mut().zip(step).for_each(|(x, step)| *x += step * scale);
        points
    }
}

/// Returns `Σ aₙᵀbₙ`.
pub(crate) fn dot<const D: usize>(a: &[SVector<f64, D>], b: &[SVector<f64, D>]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(b)).sum()
}

#[cfg(test)]
mod tests {
    use tautline::{LinearModel, PointSequence};

    use super::{Here, SUFFICIENT};

    /// Any decrease is not enough: a step has to achieve its fraction of what its slope promises (Armijo). An
    /// energy that rises by a rounding is as good as one that does not, where nothing is promised.
    #[test]
    fn a_step_has_to_achieve_a_fraction_of_what_it_promises() {
        let sequence = PointSequence::straight([0.0], [2.0], 1).expect("finite");
        let model = LinearModel { energy: 4.0, slopes: Vec::new(), is_metric: true };
        let here = Here { sequence, model };
        let promised = 1e-2;
        assert!(here.falls_enough(4.0 - promised, promised));
        assert!(here.falls_enough(4.0 - 1.1 * SUFFICIENT * promised, promised));
        assert!(!here.falls_enough(4.0 - 0.9 * SUFFICIENT * promised, promised));
        assert!(!here.falls_enough(4.0, promised));
        assert!(!here.falls_enough(f64::NAN, promised));
        let risen = 4.0 * (1.0 + f64::EPSILON);
        assert!(here.falls_enough(risen, 0.0) && !here.falls_enough(4.0 * (1.0 + 1e-14), 0.0));
    }
}
