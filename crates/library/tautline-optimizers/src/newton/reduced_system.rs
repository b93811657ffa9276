//! `ReducedSystem`: the Newton system of a discrete energy, with the ends confined to their sets.

use tautline_discretizations::QuadraticModel;
use tautline_sets::AnySet;

use crate::newton::{
    arithmetic::blocks::{Blocks, with_blocks},
    arithmetic::small::{amax, transpose},
    end_frame::{Coordinate, EndFrame},
    factorization::{Factorization, Regulariser, Shifted},
    rounding::margin,
};

/// The quadratic model of an energy in the coordinates of both [`EndFrame`]s.
///
/// A fixed coordinate keeps its place in the system, as a separate equation that is already solved.
/// Hence the blocks stay `D × D` whatever face is active, and the system is positive definite if
/// and only if its part in the free coordinates is.
pub(crate) struct ReducedSystem<'a> {
    matrix: Shifted<'a>,
    right: Vec<f64>,
    frames: [EndFrame; 2],
    tau: f64,
}

/// A Newton step.
pub(crate) struct Step {
    /// The displacements of the coordinates, point by point.
    pub(crate) step: Vec<f64>,
    /// The decrease of the energy in the quadratic model, which is half the square of the Newton
    /// decrement.
    pub(crate) decrement: f64,
}

impl<'a> ReducedSystem<'a> {
    /// Sets up the system for the shift `mu` (see [`Shifted`]), less the [`margin`]. If this system
    /// is definite, the Hessian with the shift is definite beyond rounding.
    pub(crate) fn new(
        model: &'a QuadraticModel,
        ends: [&dyn AnySet; 2],
        points: &[f64],
        mu: f64,
    ) -> Self {
        let d = model.dimension;
        let n = points.len() / d - 1;
        let regulariser = Regulariser { n: n as f64, weight: (mu - margin(n)) * model.mean_gram };
        // τ is the inverse of a typical diagonal block, so that z is about a chord away from x.
        let tau = 1.0 / (2.0 * n as f64 * model.mean_gram * (1.0 + mu));
        let frame = |set, k: usize| {
            EndFrame::new(set, &points[k * d..][..d], &model.slopes[k * d..][..d], tau)
        };
        let mut right: Vec<f64> = model.slopes.iter().map(|g| -g).collect();
        // The frames supply the forces at the ends.
        right[..d].fill(0.0);
        right[n * d..].fill(0.0);
        let mut system = Self {
            matrix: Shifted::new(model, regulariser),
            right,
            frames: [frame(ends[0], 0), frame(ends[1], n)],
            tau,
        };
        system.enter_frame(0);
        system.enter_frame(1);
        system
    }

    fn dimension(&self) -> usize {
        self.matrix.dimension()
    }

    /// Transforms the row of an end to the coordinates of its frame.
    fn enter_frame(&mut self, end: usize) {
        let (n, d) = (self.matrix.n(), self.dimension());
        let upper = &mut self.matrix.end_upper[if n == 1 { 0 } else { end }];
        // The rows of the block are those of the first end.
        if end == 1 {
            transpose(d, upper);
        }
        let (first, last) = self.right.split_at_mut(if end == 0 { d } else { n * d });
        let [right, beside] = match end {
            0 => [first, &mut last[..d]],
            _ => [last, &mut first[(n - 1) * d..]],
        };
        let block = &mut self.matrix.end_diagonal[end];
        self.frames[end].enter(block, upper, [right, beside], self.tau);
        if end == 1 {
            transpose(d, upper);
        }
    }

    /// Factorises the system; `None` if it is not positive definite.
    pub(crate) fn factorize(&self) -> Option<Factorization> {
        Factorization::new(&self.matrix)
    }

    /// Factorises the system in the memory of another factorisation; returns whether it is positive
    /// definite.
    pub(crate) fn factorize_in(&self, factorization: &mut Factorization) -> bool {
        factorization.factorize(&self.matrix)
    }

    /// Returns the number of negative eigenvalues in the free coordinates.
    pub(crate) fn negative_eigenvalues(&self) -> usize {
        self.matrix.negative_eigenvalues()
    }

    /// Solves for the Newton step.
    pub(crate) fn newton_step(&self, factorization: &Factorization) -> Step {
        let mut step = self.right.clone();
        factorization.solve(&mut step);
        let decrement = self.half_dot(&step, &self.right);
        self.leave_frames(&mut step);
        Step { step, decrement }
    }

    /// Returns half the square of the Newton decrement at other points nearby, computed with the
    /// factorisation from here. `slopes` are the derivatives of the energy there.
    pub(crate) fn decrement_at(
        &self,
        factorization: &Factorization,
        ends: [&dyn AnySet; 2],
        points: &[f64],
        slopes: &[f64],
    ) -> f64 {
        let (n, d) = (self.matrix.n(), self.dimension());
        let mut right: Vec<f64> = slopes.iter().map(|g| -g).collect();
        for (end, k) in [(0, 0), (1, n)] {
            let place = k * d..(k + 1) * d;
            let (x, slope) = (&points[place.clone()], &slopes[place.clone()]);
            let frame = EndFrame::new(ends[end], x, slope, self.tau);
            let mut force = frame.force(self.tau);
            self.frames[end].turn(&mut force);
            right[place].copy_from_slice(&force);
        }
        let mut step = right.clone();
        factorization.solve(&mut step);
        self.half_dot(&step, &right)
    }

    /// Returns `½ gᵀA⁻¹g` over the free coordinates: half the square of the Newton decrement of
    /// another functional with the derivatives `g`, in the Hessian `A` of the system.
    ///
    /// If the energy is stationary here and the functional is added as a small perturbation, the
    /// result is `½ δᵀAδ` for the shift `δ` of the minimiser. Fixed coordinates do not move under
    /// any force.
    pub(crate) fn decrement_of(&self, factorization: &Factorization, slopes: &[f64]) -> f64 {
        let (n, d) = (self.matrix.n(), self.dimension());
        let mut right: Vec<f64> = slopes.iter().map(|g| -g).collect();
        for (frame, k) in self.frames.iter().zip([0, n]) {
            frame.turn(&mut right[k * d..][..d]);
        }
        self.clear_fixed(&mut right);
        let mut step = right.clone();
        factorization.solve(&mut step);
        self.half_dot(&step, &right)
    }

    /// Returns the eigenvector of the smallest eigenvalue, by inverse iteration. It is the
    /// direction of most negative curvature if the shift is just large enough to make the system
    /// definite.
    pub(crate) fn flattest_direction(&self, factorization: &Factorization) -> Vec<f64> {
        // The start is smooth and lacks the symmetries of typical curves, so that no component
        // along a low eigenvector vanishes by accident.
        let (n, d) = (self.matrix.n(), self.dimension());
        let entry = |place: usize| {
            let (t, i) = ((place / d) as f64 / n as f64, (place % d) as f64);
            (0.7 + 1.3 * i + (2.0 + i) * t).sin() + 0.3 * (5.1 * t).cos()
        };
        let mut v: Vec<f64> = (0..(n + 1) * d).map(entry).collect();
        self.clear_fixed(&mut v);
        for _ in 0..20 {
            // The norm is not used, since the square of an inverse of a metric may overflow.
            let largest = amax(&v);
            v.iter_mut().for_each(|v| *v /= largest);
            factorization.solve(&mut v);
        }
        self.leave_frames(&mut v);
        v
    }

    /// Sets the fixed coordinates to 0.
    fn clear_fixed(&self, v: &mut [f64]) {
        let (n, d) = (self.matrix.n(), self.dimension());
        for (frame, k) in self.frames.iter().zip([0, n]) {
            for (i, coordinate) in frame.coordinates.iter().enumerate() {
                if matches!(coordinate, Coordinate::Fixed { .. }) {
                    v[k * d + i] = 0.0;
                }
            }
        }
    }

    fn leave_frames(&self, v: &mut [f64]) {
        let (n, d) = (self.matrix.n(), self.dimension());
        for (frame, k) in self.frames.iter().zip([0, n]) {
            frame.leave(&mut v[k * d..][..d]);
        }
    }

    /// Returns `½ a · b`, summed point by point.
    fn half_dot(&self, a: &[f64], b: &[f64]) -> f64 {
        with_blocks!(self.dimension(), blocks => {
            let d = blocks.dimension();
            let points = a.chunks_exact(d).zip(b.chunks_exact(d));
            0.5 * points.map(|(a, b)| blocks.dot(a, b)).sum::<f64>()
        })
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, matrix, vector};
    use tautline_discretizations::{PointSequence, QuadraticModel, Rule};
    use tautline_metrics::gallery::Constant;
    use tautline_sets::{AnySet, AxisBox, InAny, Point};

    use super::ReducedSystem;

    /// Takes one Newton step from a crooked sequence under a constant oblique metric. The problem
    /// is quadratic, so the step leads to the minimum, up to the margin of `10⁻⁸`.
    fn step(
        h: SMatrix<f64, 2, 2>,
        ends: [&dyn AnySet; 2],
        points: Vec<SVector<f64, 2>>,
    ) -> (QuadraticModel, QuadraticModel, Vec<SVector<f64, 2>>, f64) {
        let metric = Constant::new(h).expect("definite");
        let expand = |points: &[SVector<f64, 2>]| {
            let sequence = PointSequence::new(points.to_vec()).expect("finite");
            QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &sequence)
        };
        let before = expand(&points);
        let system = ReducedSystem::new(&before, ends, bytemuck::cast_slice(&points), 0.0);
        let newton = system.newton_step(&system.factorize().expect("definite"));
        let points: Vec<_> = points
            .iter()
            .zip(bytemuck::cast_slice::<f64, SVector<f64, 2>>(&newton.step))
            .map(|(x, s)| x + s)
            .collect();
        let after = expand(&points);
        (before, after, points, newton.decrement)
    }

    fn oblique() -> SMatrix<f64, 2, 2> {
        matrix![1.0, 0.6; 0.6, 2.0]
    }

    #[test]
    fn the_decrement_is_the_energy_shed_by_the_step() {
        let (a, b) = (Point::new([0.0, 0.0]).expect("finite"), Point::new([2.0, 1.0]));
        let points =
            vec![vector![0.0, 0.0], vector![1.0, -1.0], vector![0.3, 0.9], vector![2.0, 1.0]];
        let (before, after, _, decrement) =
            step(oblique(), [&InAny(&a), &InAny(&b.expect("finite"))], points);
        let shed = before.energy - after.energy;
        assert!((decrement / shed - 1.0).abs() < 1e-7, "{decrement} {shed}");
    }

    #[test]
    fn the_flattest_direction_moves_no_point_at_either_end() {
        let metric = Constant::new(oblique()).expect("definite");
        let points = vec![vector![0.0, 0.0], vector![1.0, -1.0], vector![2.0, 1.0]];
        let ends = [&points[0], &points[2]].map(|x| Point::new(*x).expect("finite"));
        let sequence = PointSequence::new(points.clone()).expect("finite");
        let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &sequence);
        let system = ReducedSystem::new(
            &model,
            [&InAny(&ends[0]), &InAny(&ends[1])],
            sequence.coordinates(),
            0.0,
        );
        let v = system.flattest_direction(&system.factorize().expect("definite"));
        assert_eq!((&v[..2], &v[4..]), (&[0.0, 0.0][..], &[0.0, 0.0][..]));
        assert!(super::amax(&v[2..4]) > 0.0, "{v:?}");
    }

    /// Each end lies inside its box and is pulled across a face. One step moves it to the face and
    /// along it, and moves the other points as well.
    #[test]
    fn one_step_moves_to_the_face_and_along_it_with_the_whole_curve() {
        let origin = Point::new([0.0, 0.0]).expect("finite");
        let wide = AxisBox::from_corners([2.0, -9.0], [9.0, 9.0]).expect("in order");
        let (origin, wide) = (InAny(&origin), InAny(&wide));
        let (there, back) = ([2.05, 0.3], [0.0, 0.0]);
        for n in [1_usize, 2, 5] {
            let line: Vec<_> = (0..=n)
                .map(|k| SVector::from(back).lerp(&SVector::from(there), k as f64 / n as f64))
                .collect();
            let reversed = line.iter().rev().copied().collect();
            for (ends, points, end) in
                [([&origin as &dyn AnySet, &wide], line, n), ([&wide, &origin], reversed, 0)]
            {
                let (_, after, points, _) = step(oblique(), ends, points);
                assert!((points[end][0] - 2.0).abs() < 1e-15);
                // The sequence is stationary inside and along the face. There hᵀ(2, y) = 0.6 · 2 +
                // 2 y = 0.
                assert!((points[end][1] + 0.6).abs() < 1e-6, "{}", points[end]);
                assert!(after.gradient::<2>()[1..n].iter().all(|g| g.amax() < 1e-6));
            }
        }
    }
}
