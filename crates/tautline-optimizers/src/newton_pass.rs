//! `NewtonPass`: a Newton step in one pass over the chords, there and back.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{ChordModel, PointSequence, Rule};
use tautline_metrics::Metric;
use tautline_sets::ClosedSet;

use crate::{
    end_frame::{EndFrame, EndRow},
    factorization::{Elimination, Factorization, Regulariser},
    rounding::margin,
};

/// A Newton step from a point sequence where the Hessian is positive definite.
///
/// The same step as that of a [`ReducedSystem`](crate::reduced_system::ReducedSystem) without
/// shift. Each block is eliminated as soon as the chords on both sides of its point are known,
/// so that neither gradient nor Hessian is ever stored: only what the way back needs.
pub(crate) struct NewtonPass<'a, const D: usize> {
    /// The discrete energy, in `m²`.
    pub(crate) energy: f64,
    /// The mean of `tr H / D` over the nodes, in `m²/ℓ²`.
    pub(crate) mean_gram: f64,
    /// How far each point moves.
    pub(crate) step: Vec<SVector<f64, D>>,
    /// The energy that the quadratic model sheds, half the square of the Newton decrement.
    pub(crate) decrement: f64,
    factorization: &'a Factorization<D>,
    frames: [EndFrame<D>; 2],
    tau: f64,
}

impl<'a, const D: usize> NewtonPass<'a, D> {
    /// Makes the step; `None` if the Hessian, less the [`margin`], is not positive definite or
    /// not finite. `mean_gram` is the mean of `tr H / D`, as far as it is known beforehand: it
    /// scales the margin and what is taken for a chord at the ends. What is in `factorization` is
    /// overwritten.
    pub(crate) fn new<R: Rule>(
        rule: R,
        metric: &impl Metric<D>,
        ends: [&dyn ClosedSet<D>; 2],
        sequence: &PointSequence<D>,
        mean_gram: f64,
        factorization: &'a mut Factorization<D>,
    ) -> Option<Self> {
        let count = sequence.n().get();
        let n = count as f64;
        let points = sequence.points();
        let regulariser = Regulariser { n, weight: -margin(count) * mean_gram };
        let identity = SMatrix::<f64, D, D>::identity();
        let beside = identity * regulariser.upper();
        let tau = 1.0 / (2.0 * n * mean_gram);
        let (mut energy, mut trace) = (0.0, 0.0);
        factorization.clear(count);
        let mut elimination = Elimination::default();
        let mut step = Vec::with_capacity(count + 1);
        let mut first = None;
        // What the chord before leaves for the point between, and what is eliminated of it.
        let mut block = identity * regulariser.diagonal(1.0);
        let mut right = SVector::<f64, D>::zeros();
        for (k, (x, d)) in sequence.chords().enumerate() {
            let chord = ChordModel::new(rule, metric, x, &d, n);
            energy += chord.energy;
            trace += chord.trace;
            let mut upper = chord.coupling + beside;
            let last = k + 1 == count;
            let shift = regulariser.diagonal(if last { 1.0 } else { 2.0 });
            let mut next = chord.hessian[1] + identity * shift;
            let mut next_right = -chord.gradient[1];
            block += chord.hessian[0];
            right -= chord.gradient[0];
            if k == 0 {
                let frame = EndFrame::new(ends[0], x, &chord.gradient[0], tau);
                // It has the force on the end.
                let right_of_end = SVector::zeros();
                let row =
                    EndRow { block, coupling: upper, right: right_of_end, beside: next_right };
                EndRow { block, coupling: upper, right, beside: next_right } =
                    frame.enter(row, tau);
                first = Some(frame);
            }
            let mut end = None;
            if last {
                let frame = EndFrame::new(ends[1], &points[count], &chord.gradient[1], tau);
                let row = EndRow {
                    block: next,
                    coupling: upper.transpose(),
                    right: next_right + chord.gradient[1],
                    beside: right,
                };
                let row = frame.enter(row, tau);
                (next, next_right, right) = (row.block, row.right, row.beside);
                upper = row.coupling.transpose();
                end = Some(frame);
            }
            block = next - factorization.push(&block, &upper)?;
            step.push(elimination.push(factorization, right));
            right = next_right;
            if let (Some(first), Some(end)) = (&first, end) {
                factorization.push_last(&block)?;
                step.push(elimination.push(factorization, right));
                factorization.substitute_back(&mut step);
                step[0] = first.basis * step[0];
                step[count] = end.basis * step[count];
                return Some(Self {
                    energy,
                    mean_gram: trace / (n * n * D as f64),
                    step,
                    decrement: elimination.half_square(),
                    factorization,
                    frames: [first.clone(), end],
                    tau,
                });
            }
        }
        None
    }

    /// Returns half the square of the Newton decrement at other points close by, with the
    /// factorisation from here, block by block: the gradient by each point is to be pushed.
    pub(crate) fn decrement_at<'b>(
        &'b self,
        ends: [&'b dyn ClosedSet<D>; 2],
        points: &'b [SVector<f64, D>],
    ) -> Decrement<'b, D> {
        Decrement { pass: self, ends, points, elimination: Elimination::default() }
    }
}

/// The Newton decrement at a point sequence, while the gradient is being computed.
pub(crate) struct Decrement<'a, const D: usize> {
    pass: &'a NewtonPass<'a, D>,
    ends: [&'a dyn ClosedSet<D>; 2],
    points: &'a [SVector<f64, D>],
    elimination: Elimination<D>,
}

impl<const D: usize> Decrement<'_, D> {
    /// Takes the gradient by point `k`.
    #[inline(always)]
    pub(crate) fn push(&mut self, k: usize, gradient: &SVector<f64, D>) {
        let last = self.points.len() - 1;
        let force = if k == 0 || k == last {
            let end = usize::from(k == last);
            let frame = EndFrame::new(self.ends[end], &self.points[k], gradient, self.pass.tau);
            self.pass.frames[end].basis.tr_mul(&frame.force(self.pass.tau))
        } else {
            -gradient
        };
        self.elimination.push(self.pass.factorization, force);
    }

    /// Returns half its square after the last point, in `m²`.
    pub(crate) fn value(&self) -> f64 {
        self.elimination.half_square()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline_discretizations::{
        LeftEndpoint, PointSequence, QuadraticModel, Rule, Trapezoidal, TrueTrapezoid,
        energy_gradient,
    };
    use tautline_metrics::gallery::Swirl;
    use tautline_sets::{Ball, ClosedSet, HalfSpace, Point, Sphere};

    use super::NewtonPass;
    use crate::{
        Workspace,
        reduced_system::{ReducedSystem, Step},
    };

    /// The numbers of the pass and those of the system that is set up, factorised and solved.
    #[track_caller]
    fn compare<R: Rule>(rule: R, ends: [&dyn ClosedSet<2>; 2], n: usize) {
        let metric = Swirl::new(0.5, 1.0).expect("a width");
        let at = |k: usize| {
            let t = k as f64 / n as f64;
            SVector::from([2.0 * t - 1.0, 0.3 * (2.0 * t).sin()])
        };
        let mut points: Vec<_> = (0..=n).map(at).collect();
        points[0] = ends[0].project(&points[0]);
        points[n] = ends[1].project(&points[n]);
        let sequence = PointSequence::new(points).expect("finite");
        let model = QuadraticModel::new(rule, &metric, &sequence);
        let system = ReducedSystem::new(&model, ends, sequence.points(), 0.0);
        let factorization = system.factorize().expect("definite");
        let Step { step, decrement } = system.newton_step(&factorization);
        let mut memory = Workspace::default().factorization;
        let pass = NewtonPass::new(rule, &metric, ends, &sequence, model.mean_gram, &mut memory);
        let pass = pass.expect("definite");
        // The same operations but for the order of three sums a block. The condition of the
        // system is 100 at most, its entries some 10.
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * b.abs();
        assert!(close(pass.energy, model.energy) && close(pass.mean_gram, model.mean_gram));
        assert!(close(pass.decrement, decrement), "{} {decrement}", pass.decrement);
        for (one, other) in pass.step.iter().zip(&step) {
            assert!((one - other).amax() <= 1e-12, "{one} {other}");
        }
        let moved: Vec<_> = sequence.points().iter().zip(&step).map(|(x, s)| x + s * 0.5).collect();
        let moved = PointSequence::new(moved).expect("finite");
        let (_, gradient) = energy_gradient(rule, &metric, &moved);
        let expected = system.decrement_at(&factorization, ends, moved.points(), &gradient);
        let mut found = pass.decrement_at(ends, moved.points());
        gradient.iter().enumerate().for_each(|(k, gradient)| found.push(k, gradient));
        let found = found.value();
        assert!(close(found, expected) && expected > 0.0, "{found} {expected}");
    }

    #[test]
    fn one_pass_makes_the_step_of_the_whole_system() {
        let a = Point::new([-1.0, 0.1]).expect("finite");
        let b = Point::new([1.2, -0.2]).expect("finite");
        let ball = Ball::new([-1.5, 0.0], 0.4).expect("a radius");
        let circle = Sphere::new([-1.5, 0.0], 0.4).expect("a radius");
        let ball_too = Ball::new([1.5, 0.3], 0.2).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.5], 1.0).expect("a normal");
        // A chord from point to point does not move: at least one end does.
        for ends in
            [[&ball as &dyn ClosedSet<2>, &b], [&a, &wall], [&circle, &wall], [&ball, &ball_too]]
        {
            for n in [1, 2, 3, 8] {
                compare(Trapezoidal, ends, n);
                compare(LeftEndpoint, ends, n);
                compare(TrueTrapezoid, ends, n);
            }
        }
    }
}
