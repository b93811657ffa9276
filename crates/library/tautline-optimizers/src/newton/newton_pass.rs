//! `NewtonPass`: a Newton step computed in one pass over the chords and back.

use tautline_discretizations::{ANY, LinearModel, PointSequence};
use tautline_sets::AnySet;

use crate::{
    Workspace,
    newton::{
        discrete_energy::DiscreteEnergy,
        end_frame::EndFrame,
        magnitude::Magnitude,
        residual::Residual,
        stationarity::Stationarity,
        sweep::{Sweep, sweep},
    },
};

/// A Newton step from a point sequence with a positive definite Hessian.
///
/// It is the step of a [`ReducedSystem`](crate::newton::reduced_system::ReducedSystem) without a
/// shift, computed by one [sweep] and back substitution.
pub(crate) struct NewtonPass<'a> {
    sweep: Sweep,
    /// The right hand side after elimination.
    eliminated: Vec<f64>,
    workspace: &'a mut Workspace,
}

impl<'a> NewtonPass<'a> {
    /// Sweeps over the chords; `None` if the Hessian is not positive definite. The factorisation in
    /// `workspace` is overwritten.
    pub(crate) fn new(
        energy: &DiscreteEnergy<'_>,
        ends: [&dyn AnySet; 2],
        sequence: &PointSequence<ANY>,
        about: Magnitude,
        at_once: bool,
        workspace: &'a mut Workspace,
    ) -> Option<Self> {
        let mut eliminated = workspace.spare.take(sequence.coordinates().len());
        let memory = Some((&mut workspace.factorization, &mut eliminated));
        match sweep(energy, ends, sequence, about, at_once, memory) {
            Some(sweep) => Some(Self { sweep, eliminated, workspace }),
            None => {
                workspace.spare.give(eliminated);
                None
            }
        }
    }

    /// Returns the stationarity before the step.
    pub(crate) fn stationarity(&self) -> Stationarity {
        self.sweep.stationarity
    }

    /// Returns the memory to the workspace without taking the step.
    pub(crate) fn leave(self) {
        self.workspace.spare.give(self.eliminated);
    }

    /// Returns the displacement of each coordinate by the Newton step, point by point.
    pub(crate) fn take_step(&mut self) -> Vec<f64> {
        let mut step = std::mem::take(&mut self.eliminated);
        self.workspace.factorization.substitute_back(&mut step);
        let d = self.sweep.frames[0].gradient.len();
        let last = step.len() - d;
        for (end, frame) in [0, last].into_iter().zip(&self.sweep.frames) {
            frame.leave(&mut step[end..][..d]);
        }
        step
    }

    /// Returns the stationarity at a sequence nearby, computed with the factorisation from here. In
    /// many dimensions this costs a fraction of a sweep.
    pub(crate) fn stationarity_at(
        &self,
        energy: &DiscreteEnergy<'_>,
        ends: [&dyn AnySet; 2],
        sequence: &PointSequence<ANY>,
    ) -> Stationarity {
        let Magnitude { mean_gram, .. } = self.stationarity().magnitude;
        let LinearModel { energy, slopes, is_metric } = energy.linear_model(sequence);
        let (count, d) = (sequence.n().get(), sequence.dimension());
        let mut residual = Residual::new(d, count, self.stationarity().magnitude);
        residual.push_all(&slopes);
        let mut right = slopes;
        right.iter_mut().for_each(|g| *g = -*g);
        for (end, k) in [(0, 0), (1, count)] {
            let right = &mut right[k * d..][..d];
            let gradient: Vec<f64> = right.iter().map(|g| -g).collect();
            let tau = self.sweep.tau;
            let force = EndFrame::new(ends[end], sequence.row(k), &gradient, tau).force(tau);
            right.copy_from_slice(&force);
            self.sweep.frames[end].turn(right);
        }
        let decrement = self.workspace.factorization.half_square(&right);
        let magnitude = Magnitude { energy, mean_gram };
        let (residual, residual_floor) = residual.value(ends, sequence, magnitude);
        Stationarity { magnitude, is_metric, decrement, residual, residual_floor }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline_discretizations::{LinearModel, PointSequence, QuadraticModel, Rule};
    use tautline_formula::Prepared;
    use tautline_metrics::{
        Metric,
        gallery::{SineProjection, SineProjections, Swirl},
    };
    use tautline_sets::{AnySet, Ball, ClosedSet, HalfSpace, InAny, Point, Sphere};

    use super::{Magnitude, NewtonPass, Residual, Stationarity};
    use crate::{
        Workspace,
        newton::{
            discrete_energy::DiscreteEnergy,
            reduced_system::{ReducedSystem, Step},
        },
    };

    /// Compares a pass, on one thread and on two, with the assembled system.
    #[track_caller]
    fn compare<const D: usize>(
        rule: Rule,
        metric: &impl Metric<D>,
        ends: [&dyn ClosedSet<D>; 2],
        n: usize,
        memory: &mut Workspace,
    ) {
        let once = |at_once| compare_once(rule, metric, ends, n, at_once, memory);
        let [one, other] = [false, true].map(once);
        assert_eq!(one, other, "bit by bit");
    }

    /// Compares a pass with the assembled system, and returns the results of the pass.
    #[track_caller]
    fn compare_once<const D: usize>(
        rule: Rule,
        metric: &impl Metric<D>,
        ends: [&dyn ClosedSet<D>; 2],
        n: usize,
        at_once: bool,
        memory: &mut Workspace,
    ) -> (Stationarity, Vec<f64>, Stationarity) {
        let at = |k: usize| {
            let t = k as f64 / n as f64;
            SVector::from_fn(|i, _| if i == 0 { 2.0 * t - 1.0 } else { 0.3 * (2.0 * t).sin() })
        };
        let mut points: Vec<_> = (0..=n).map(at).collect();
        points[0] = ends[0].project(&points[0]);
        points[n] = ends[1].project(&points[n]);
        let sequence = PointSequence::new(points).expect("finite");
        let model = QuadraticModel::new(rule, metric, &sequence);
        let pieces = ends.map(InAny);
        let sets: [&dyn AnySet; 2] = [&pieces[0], &pieces[1]];
        let any = sequence.clone().into_any();
        let system = ReducedSystem::new(&model, sets, any.coordinates(), 0.0);
        let factorization = system.factorize().expect("definite");
        let Step { step, decrement } = system.newton_step(&factorization);
        let magnitude = Magnitude { energy: model.energy, mean_gram: model.mean_gram };
        let batches = Prepared::new(metric);
        let functional = &DiscreteEnergy::new(rule, &batches);
        let pass = NewtonPass::new(functional, sets, &any, magnitude, at_once, memory);
        let mut pass = pass.expect("definite");
        // The condition number of the system is at most 100, its entries are about 10, and there
        // are about a thousand roundings.
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
        let at = pass.stationarity();
        assert!(at.is_metric && close(at.magnitude.energy, model.energy));
        assert!(close(at.magnitude.mean_gram, model.mean_gram));
        let mut residual = Residual::new(D, n, magnitude);
        residual.push_all(&model.slopes);
        let (residual, floor) = residual.value(sets, &any, magnitude);
        assert!(close(at.residual, residual) && close(at.residual_floor, floor));
        assert!(close(at.decrement, decrement), "{} {decrement}", at.decrement);
        let found = pass.take_step();
        for (one, other) in found.iter().zip(&step) {
            assert!((one - other).abs() <= 1e-12, "{one} {other}");
        }
        let moved = any.coordinates().iter().zip(&step).map(|(x, s)| x + s * 0.5).collect();
        let moved = PointSequence::from_coordinates(D, moved).expect("finite");
        let model = LinearModel::new(rule, metric, &moved.clone().into_dimension().expect("D"));
        let LinearModel { energy, slopes, .. } = model;
        let expected = system.decrement_at(&factorization, sets, moved.coordinates(), &slopes);
        let mut residual = Residual::new(D, n, magnitude);
        residual.push_all(&slopes);
        let there = pass.stationarity_at(functional, sets, &moved);
        let (residual, floor) = residual.value(sets, &moved, there.magnitude);
        assert!(close(there.decrement, expected) && expected > 0.0, "{there:?} {expected}");
        assert!(there.is_metric && close(there.magnitude.energy, energy));
        assert!(close(there.residual, residual) && close(there.residual_floor, floor));
        (at, found, there)
    }

    /// Up to three dimensions, two chords are eliminated at a time.
    #[test]
    fn one_pass_makes_the_step_of_the_whole_system() {
        let swirl = Swirl::new(0.5, 1.0).expect("a width");
        let a = Point::new([-1.0, 0.1]).expect("finite");
        let b = Point::new([1.2, -0.2]).expect("finite");
        let ball = Ball::new([-1.5, 0.0], 0.4).expect("a radius");
        let circle = Sphere::new([-1.5, 0.0], 0.4).expect("a radius");
        let ball_too = Ball::new([1.5, 0.3], 0.2).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.5], 1.0).expect("a normal");
        // One workspace serves odd and even N: nothing is left over from earlier passes.
        let mut memory = Workspace::default();
        // At least one end moves, since for n = 1 nothing else can.
        for ends in
            [[&ball as &dyn ClosedSet<2>, &b], [&a, &wall], [&circle, &wall], [&ball, &ball_too]]
        {
            for n in [1, 2, 3, 4, 5, 6, 7, 8] {
                compare(Rule::TRAPEZOIDAL, &swirl, ends, n, &mut memory);
                compare(Rule::LEFT_ENDPOINT, &swirl, ends, n, &mut memory);
                compare(Rule::TRUE_TRAPEZOID, &swirl, ends, n, &mut memory);
            }
        }
    }

    #[test]
    fn from_four_dimensions_on_too() {
        let term = |k: f64| SineProjection {
            wave_vector: [k.sin(), 0.5, k.cos(), 0.2 * k].into(),
            direction: [0.5, 0.3 * k.cos(), -0.4, 0.3 * k.sin()].into(),
        };
        let metric = SineProjections::new((1..4).map(|k| term(f64::from(k))).collect());
        let metric = metric.expect("finite");
        let b = Point::new([1.2, -0.2, 0.1, 0.3]).expect("finite");
        let ball = Ball::new([-1.5, 0.0, 0.0, 0.1], 0.4).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.5, 0.0, 0.2], 1.0).expect("a normal");
        let mut memory = Workspace::default();
        for ends in [[&ball as &dyn ClosedSet<4>, &b], [&ball, &wall]] {
            for n in [1, 2, 3, 7, 8] {
                compare(Rule::TRAPEZOIDAL, &metric, ends, n, &mut memory);
                compare(Rule::LEFT_ENDPOINT, &metric, ends, n, &mut memory);
            }
        }
    }
}
