//! Lengthens steps that a shift has made too short.

use tautline_discretizations::{ANY, PointSequence};

use crate::search::local_search::LocalSearch;

/// A step is short if it lowers the energy by at least this many decrements. Its slope predicts 2.
const SHORT: f64 = 1.5;

impl LocalSearch<'_> {
    /// Doubles a step from `sequence` as long as this lowers the energy further. The result is
    /// `None` if even the first doubling does not.
    ///
    /// `energy` and `reached` are the energies before and after the step; `decrement` is `δ`, half
    /// the slope of the energy along the step. Taking `t` times the step lowers the energy by
    /// `2δt − κt²`. A shift that is larger than necessary makes `κ` small and the step too short by
    /// the factor `δ/κ`, so that the search creeps along a curved valley. If `2δt − κt² ≥ 3/2 δt`,
    /// twice the step lowers the energy further, since `κt ≤ δ/2 < 2δ/3`. Each doubling costs one
    /// energy and no factorisation.
    pub(crate) fn lengthen(
        &self,
        sequence: &PointSequence<ANY>,
        step: &[f64],
        [energy, reached]: [f64; 2],
        decrement: f64,
    ) -> Option<Vec<f64>> {
        let (mut scale, mut lowest, mut best) = (1.0, reached, None);
        while energy - lowest >= SHORT * scale * decrement {
            scale *= 2.0;
            let trial = self.retract(sequence, step, scale);
            match self.energy.admissible(&trial) {
                Some(lower) if lower < lowest => (lowest, best) = (lower, Some(trial)),
                _ => break,
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, vector};
    use tautline_discretizations::{PointSequence, Rule};
    use tautline_formula::Prepared;
    use tautline_metrics::gallery::Constant;
    use tautline_sets::{InAny, Point};

    use crate::{
        newton::discrete_energy::DiscreteEnergy, search::local_search::LocalSearch,
        watch::Unwatched,
    };

    /// The energy of a constant metric is quadratic from `x` to the minimiser `x + p`. The step
    /// `p/12` has `κ = δ/12`. Taking 1, 2 or 4 steps lowers the energy by at least `(2 − 4/12) δt`,
    /// so they are short. Taking 8 steps lowers it by `(2 − 8/12) δt`, so they are not.
    #[test]
    fn a_twelfth_of_a_newton_step_is_taken_eight_times() {
        let metric = Constant::<2>::new(SMatrix::identity()).expect("definite");
        let [a, b] = [[0.0, 0.0], [2.0, 0.0]].map(|x| Point::new(x).expect("finite"));
        let batches = Prepared::new(&metric);
        let search = LocalSearch {
            energy: &DiscreteEnergy::new(Rule::TRAPEZOIDAL, &batches),
            ends: [&InAny(&a), &InAny(&b)],
            iterations: 1,
            threads: 1,
            watch: &Unwatched,
        };
        let bent = vec![vector![0.0, 0.0], vector![1.0, 1.0], vector![2.0, 0.0]];
        let bent = PointSequence::new(bent).expect("finite").into_any();
        // E = 2 (1 + y²) · 2 at (1, y), which falls from 8 to 4 at y = 0; δ = 4 for the whole step
        // p.
        let after = |share: f64| {
            let step = [0.0, 0.0, 0.0, -share, 0.0, 0.0];
            let trial = search.retract(&bent, &step, 1.0);
            let reached = search.energy.admissible(&trial).expect("finite");
            search.lengthen(&bent, &step, [8.0, reached], 4.0 * share)
        };
        let moved = after(1.0 / 12.0).expect("it is short");
        // One product and one difference are rounded.
        assert_eq!(moved[2], 1.0);
        assert!((moved[3] - (1.0 - 8.0 / 12.0)).abs() <= 2.0 * f64::EPSILON);
        assert_eq!(after(1.0), None, "the whole step is not short");
    }
}
