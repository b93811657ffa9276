//! `newton_step`: a single Newton step.

use nalgebra::SVector;
use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::Batches;
use tautline_sets::{ClosedSet, InAny};

use crate::{
    Workspace,
    newton::{discrete_energy::DiscreteEnergy, magnitude::Magnitude, newton_pass::NewtonPass},
};

/// A Newton step from a point sequence.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct NewtonStep<const D: usize> {
    /// The displacements of the `N + 1` points, in `ℓ`. An end that has moved has to be projected
    /// back to its set.
    pub step: Vec<SVector<f64, D>>,
    /// The discrete energy before the step, in `m²`.
    pub energy: f64,
    /// The decrease of the energy in the quadratic model, in `m²`. It is half the square of the
    /// Newton decrement.
    pub decrement: f64,
}

/// Returns one undamped Newton step from `sequence`, with its ends in the sets `ends`. The result
/// is `None` if the Hessian, confined to the active faces of the sets, is not positive definite
/// beyond rounding, or if the system has no memory for a step, `16D² + 16D` bytes per point.
///
/// [`minimise`](crate::minimise) repeats this step on fine grids, where it needs no damping.
/// Assembly and factorisation take one pass over the chords, `O(N D³)`, on one thread and in the
/// memory of `workspace`.
pub fn newton_step<const D: usize>(
    workspace: &mut Workspace,
    metric: &dyn Batches<D>,
    ends: [&dyn ClosedSet<D>; 2],
    rule: Rule,
    sequence: &PointSequence<D>,
) -> Option<NewtonStep<D>> {
    workspace.check_undamped(D, sequence.n().get()).ok()?;
    // Three points give a scale for the rounding and for the step that finds the active faces of
    // the sets.
    let points = sequence.points();
    let places = [0, points.len() / 2, points.len() - 1];
    let traces = places.map(|k| metric.gram(&points[k]).trace() / D as f64);
    let mean_gram = traces.iter().sum::<f64>() / 3.0;
    let energy = mean_gram * (sequence.last() - sequence.first()).norm_squared();
    let about = Magnitude { energy, mean_gram };
    let energy = &DiscreteEnergy::new(rule, metric);
    let [first, second] = ends.map(InAny);
    let sequence = sequence.clone().into_any();
    let mut pass = NewtonPass::new(energy, [&first, &second], &sequence, about, false, workspace)?;
    let at = pass.stationarity();
    Some(NewtonStep {
        step: bytemuck::try_cast_vec(pass.take_step())
            .unwrap_or_else(|(_, step)| bytemuck::cast_slice(&step).to_vec()),
        energy: at.magnitude.energy,
        decrement: at.decrement,
    })
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_discretizations::{PointSequence, Rule};
    use tautline_formula::Prepared;
    use tautline_metrics::gallery::{Bump, Constant};
    use tautline_sets::Point;

    use super::newton_step;
    use crate::Workspace;

    /// Also where the ends are one point, whose distance is no scale.
    #[test]
    fn one_step_contracts_a_closed_chain() {
        let metric = Constant::new(nalgebra::SMatrix::identity()).expect("positive definite");
        let metric = Prepared::new(metric);
        let begin = Point::new([0.5, -1.0]).expect("finite");
        let chain = [vector![0.5, -1.0], vector![3.0, -1.0], vector![0.5, 0.5], vector![0.5, -1.0]];
        let chain = PointSequence::new(chain.to_vec()).expect("finite");
        let mut workspace = Workspace::default();
        let found =
            newton_step(&mut workspace, &metric, [&begin, &begin], Rule::TRAPEZOIDAL, &chain);
        let found = found.expect("definite");
        for (x, step) in chain.points().iter().zip(&found.step) {
            // The result is accurate up to the margin of 1e-8, with entries of the Hessian below 4.
            assert!((x + step - vector![0.5, -1.0]).amax() < 1e-7, "{x} {step}");
        }
        assert!((found.decrement / found.energy - 1.0).abs() < 1e-7);
    }

    /// If the energy is quadratic, one step leads from any sequence to the straight line, and
    /// lowers the energy by the decrement.
    #[test]
    fn one_step_straightens_a_chain() {
        let metric = Constant::new(nalgebra::SMatrix::identity()).expect("positive definite");
        let metric = Prepared::new(metric);
        let ends = [[0.0, 0.0], [1.0, 2.0]].map(|x| Point::new(x).expect("finite"));
        let bent = [vector![0.0, 0.0], vector![3.0, -1.0], vector![0.5, 0.5], vector![1.0, 2.0]];
        let bent = PointSequence::new(bent.to_vec()).expect("finite");
        let found = newton_step(
            &mut Workspace::default(),
            &metric,
            [&ends[0], &ends[1]],
            Rule::TRAPEZOIDAL,
            &bent,
        )
        .expect("definite");
        for (k, (x, step)) in bent.points().iter().zip(&found.step).enumerate() {
            // The result is accurate up to the margin of 1e-8, with entries of the Hessian below 4.
            assert!((x + step - vector![1.0, 2.0] * (k as f64 / 3.0)).amax() < 1e-7);
        }
        // The energy is 3 (9 + 1 + 6.25 + 2.25 + 0.25 + 2.25) before the step, and 5 for the line.
        assert!((found.energy - 63.0).abs() < 1e-13);
        assert!((found.energy - found.decrement - 5.0).abs() < 1e-5);
    }

    #[test]
    fn over_a_bump_there_is_none() {
        let bump = Prepared::new(Bump::new(4.0, 0.5).expect("a width"));
        let ends = [[-1.5, 0.0], [1.5, 0.0]].map(|x| Point::new(x).expect("finite"));
        let line = PointSequence::straight([-1.5, 0.0], [1.5, 0.0], 32).expect("finite");
        let ends: [&dyn tautline_sets::ClosedSet<2>; 2] = [&ends[0], &ends[1]];
        assert!(
            newton_step(&mut Workspace::default(), &bump, ends, Rule::TRAPEZOIDAL, &line).is_none()
        );
    }
}
