//! `KktStep`: a step of sequential quadratic programming.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline::ChordModel;

/// The solution of the linearised conditions of Karush, Kuhn and Tucker.
///
/// With the energies `wₙ` of the chords, `E_N = Σ wₙ`, the problem is to minimise `σ` subject to
/// `wₙ = σ`. The step `δ`, the multipliers `λ` and `σ` solve
///
/// ```text
/// Σₙ λ̄ₙ ∇²wₙ δ + Σₙ λₙ ∇wₙ = 0,     wₙ + ∇wₙ·δ = σ,     Σₙ λₙ = 1
/// ```
///
/// with the multipliers `λ̄` before the step in the Hessian.
pub(super) struct KktStep<const D: usize> {
    /// The displacements of the inner points, in `ℓ`.
    pub(super) step: Vec<SVector<f64, D>>,
    /// The multipliers of the chords.
    pub(super) multipliers: Vec<f64>,
    /// The energy of a chord after the step, in `m²`.
    pub(super) level: f64,
}

/// Right hand sides or solutions: what is constant, and the factors of `σ` and of `λ_{N−1}`.
type Affine<T> = [T; 3];

/// An eliminated block `[P, a; aᵀ, −c]` for the point `xₙ` and the multiplier `λₙ₋₁` of the chord
/// that ends there, by its inverse, and its right hand sides.
struct Pivot<const D: usize> {
    inverse: DMatrix<f64>,
    negative: usize,
    right: Affine<SVector<f64, D>>,
    right_level: Affine<f64>,
}

impl<const D: usize> Pivot<D> {
    /// Inverts a block by its eigenvalues; `None` if one is 0 or not finite.
    fn new(
        block: &SMatrix<f64, D, D>,
        a: &SVector<f64, D>,
        c: f64,
        right: Affine<SVector<f64, D>>,
        right_level: Affine<f64>,
    ) -> Option<Self> {
        let entry = |i: usize, j: usize| match (i < D, j < D) {
            (true, true) => 0.5 * (block[(i, j)] + block[(j, i)]),
            (true, false) => a[i],
            (false, true) => a[j],
            (false, false) => -c,
        };
        let matrix = DMatrix::from_fn(D + 1, D + 1, entry);
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let eigen = matrix.symmetric_eigen();
        let inverses = eigen.eigenvalues.map(|value| 1.0 / value);
        let vectors = &eigen.eigenvectors;
        let inverse = vectors * DMatrix::from_diagonal(&inverses) * vectors.transpose();
        let negative = eigen.eigenvalues.iter().filter(|value| **value < 0.0).count();
        let is_regular = inverse.iter().all(|entry| entry.is_finite());
        is_regular.then_some(Self { inverse, negative, right, right_level })
    }

    /// Returns the solution for one right hand side.
    fn solve(&self, right: &SVector<f64, D>, level: f64) -> (SVector<f64, D>, f64) {
        let row = |i: usize| {
            let points = (0..D).map(|j| self.inverse[(i, j)] * right[j]).sum::<f64>();
            points + self.inverse[(i, D)] * level
        };
        (SVector::from_fn(|i, _| row(i)), row(D))
    }

    /// Returns `Q v` with the block `Q` of the inverse that belongs to the point.
    fn inverse_at_point(&self, v: &SVector<f64, D>) -> SVector<f64, D> {
        self.solve(v, 0.0).0
    }
}

impl<const D: usize> KktStep<D> {
    /// Solves for the step; `None` if the Hessian, with `shift` added to its diagonal, is not
    /// positive definite along the constraints, or if the energy of a chord has no slope.
    ///
    /// The unknowns are eliminated in the order `x₁, λ₀, x₂, λ₁, …`, in blocks of a point and a
    /// multiplier, with `σ` and `λ_{N−1}` last, in `O(N D³)`. Every leading part is the problem of
    /// the first chords with the point after them fixed, which is regular in general. The Hessian is
    /// positive definite along the constraints if and only if as many eigenvalues are negative as
    /// there are constraints (Gould), and the blocks have as many as the matrix (Sylvester).
    pub(super) fn new(chords: &[ChordModel<D>], multipliers: &[f64], shift: f64) -> Option<Self> {
        let inner = chords.len() - 1;
        let weighted = |k: usize| {
            let far = chords[k - 1].hessian[1] * multipliers[k - 1];
            let near = chords[k].hessian[0] * multipliers[k];
            far + near + SMatrix::identity() * shift
        };
        let mut pivots: Vec<Pivot<D>> = Vec::with_capacity(inner);
        let (mut block, mut a, mut c) = (weighted(1), chords[0].gradient[1], 0.0);
        let mut right = [SVector::zeros(); 3];
        let mut level = [-chords[0].energy, 1.0, 0.0];
        for k in 1..=inner {
            let pivot = Pivot::new(&block, &a, c, right, level)?;
            let slope = chords[k].gradient[0];
            let turned = pivot.inverse_at_point(&slope);
            c = slope.dot(&turned);
            if k == inner {
                // λ_{N−1} is a parameter: it moves to the right hand side.
                right[2] = -slope;
            }
            let pivot = Pivot { right, ..pivot };
            let found = [0, 1, 2].map(|i| pivot.solve(&right[i], level[i]).0);
            level = [
                -chords[k].energy - slope.dot(&found[0]),
                1.0 - slope.dot(&found[1]),
                -slope.dot(&found[2]),
            ];
            if k < inner {
                let coupling = chords[k].coupling * multipliers[k];
                let mut through = SMatrix::<f64, D, D>::zeros();
                for j in 0..D {
                    let column = coupling.column(j).into_owned();
                    through.set_column(j, &pivot.inverse_at_point(&column));
                }
                block = weighted(k + 1) - coupling.tr_mul(&through);
                a = chords[k].gradient[1] - coupling.tr_mul(&turned);
                right = found.map(|found| -coupling.tr_mul(&found));
            }
            pivots.push(pivot);
        }
        let (steps, found) = substitute_back(chords, multipliers, &pivots);
        // What is left are the last row, 0 = l₀ + l₁ σ + l₂ λ, and Σ λ = 1, with the last λ among
        // the λ.
        let sum = |i: usize| found.iter().map(|affine: &Affine<f64>| affine[i]).sum::<f64>();
        let rest = SMatrix::<f64, 2, 2>::new(level[1], level[2], sum(1), sum(2) + 1.0);
        let rest_right = SVector::<f64, 2>::new(-level[0], 1.0 - sum(0));
        // As a part of the symmetric matrix this is [−Σ₁, −l₁; −l₁, −l₂], with 1 + Σ₂ = l₁.
        let (determinant, trace) = (-rest.determinant(), -sum(1) - level[2]);
        let negative = match (determinant < 0.0, trace < 0.0) {
            (true, _) => 1,
            (false, true) => 2,
            (false, false) => 0,
        };
        let negative = negative + pivots.iter().map(|pivot| pivot.negative).sum::<usize>();
        if negative != chords.len() {
            return None;
        }
        let solved = rest.try_inverse()? * rest_right;
        let combine =
            |affine: &Affine<f64>| affine[0] + affine[1] * solved[0] + affine[2] * solved[1];
        let step: Vec<_> = steps
            .iter()
            .map(|affine| affine[0] + affine[1] * solved[0] + affine[2] * solved[1])
            .collect();
        let multipliers = found.iter().map(combine).chain([solved[1]]).collect();
        solved.iter().all(|x| x.is_finite()).then_some(Self { step, multipliers, level: solved[0] })
    }
}

/// Returns the points and the multipliers but the last, from the last to the first, in the order of
/// the chords.
fn substitute_back<const D: usize>(
    chords: &[ChordModel<D>],
    multipliers: &[f64],
    pivots: &[Pivot<D>],
) -> (Vec<Affine<SVector<f64, D>>>, Vec<Affine<f64>>) {
    let inner = pivots.len();
    let mut steps = vec![[SVector::zeros(); 3]; inner];
    let mut found = vec![[0.0; 3]; inner];
    for k in (1..=inner).rev() {
        let (pivot, chord) = (&pivots[k - 1], &chords[k]);
        for i in 0..3 {
            let mut right = pivot.right[i];
            if k < inner {
                right -= chord.coupling * steps[k][i] * multipliers[k];
                right -= chord.gradient[0] * found[k][i];
            }
            (steps[k - 1][i], found[k - 1][i]) = pivot.solve(&right, pivot.right_level[i]);
        }
    }
    (steps, found)
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector, SVector, vector};
    use tautline::{PointSequence, Prepared, Rule, gallery::Valleys};

    use super::KktStep;
    use crate::descent::chord_models::chord_models;

    #[test]
    fn the_elimination_agrees_with_dense_algebra() {
        for n in [2, 3, 4, 9] {
            let at = |k: usize| {
                let t = k as f64 / n as f64;
                vector![2.0 * t + 0.1 * (9.0 * t).sin(), t - 0.2 * t * t]
            };
            let sequence = PointSequence::new((0..=n).map(at).collect()).expect("finite");
            let metric = Prepared::new(Valleys);
            let chords = chord_models::<2>(&metric, Rule::TRAPEZOIDAL.nodes(), &sequence);
            let chords = chords.expect("a metric");
            let multipliers: Vec<_> = (0..n).map(|k| (1.0 + 0.1 * k as f64) / n as f64).collect();
            let found = KktStep::new(&chords, &multipliers, 0.3).expect("definite");
            // The unknowns: 2 (n − 1) coordinates, n multipliers, and the level.
            let (inner, size) = (2 * (n - 1), 2 * (n - 1) + n + 1);
            let (mut matrix, mut right) = (DMatrix::zeros(size, size), DVector::zeros(size));
            for (k, chord) in chords.iter().enumerate() {
                let places = [2 * (k as isize - 1), 2 * k as isize];
                let is_inner = |place: isize| (0..inner as isize).contains(&place);
                for (end, &place) in
                    places.iter().enumerate().filter(|(_, place)| is_inner(**place))
                {
                    for i in 0..2 {
                        let row = place as usize + i;
                        matrix[(row, inner + k)] += chord.gradient[end][i];
                        matrix[(inner + k, row)] += chord.gradient[end][i];
                        for j in 0..2 {
                            let own = chord.hessian[end][(i, j)] * multipliers[k];
                            matrix[(row, place as usize + j)] += own;
                        }
                        let other = places[1 - end];
                        for j in (0..2).filter(|_| is_inner(other)) {
                            let entry = if end == 0 { (i, j) } else { (j, i) };
                            matrix[(row, other as usize + j)] +=
                                chord.coupling[entry] * multipliers[k];
                        }
                    }
                }
                matrix[(inner + k, size - 1)] = -1.0;
                matrix[(size - 1, inner + k)] = 1.0;
                right[inner + k] = -chord.energy;
            }
            for i in 0..inner {
                matrix[(i, i)] += 0.3;
            }
            right[size - 1] = 1.0;
            let dense = matrix.lu().solve(&right).expect("regular");
            // The condition number is about a thousand.
            let close = |a: f64, b: f64| (a - b).abs() <= 1e-11 * (1.0 + b.abs());
            for (k, step) in found.step.iter().enumerate() {
                let step: &SVector<f64, 2> = step;
                assert!(close(step[0], dense[2 * k]) && close(step[1], dense[2 * k + 1]), "{n}");
            }
            for (k, multiplier) in found.multipliers.iter().enumerate() {
                assert!(close(*multiplier, dense[inner + k]), "{n}: {multiplier}");
            }
            assert!(close(found.level, dense[size - 1]), "{n}");
            // A Hessian that bends down along the constraints has no step, unless it is shifted. With
            // two chords the constraint leaves one direction, with nine there are eight.
            let down: Vec<_> = multipliers.iter().map(|multiplier| -multiplier).collect();
            assert!(KktStep::new(&chords, &down, 0.0).is_none(), "{n}");
            assert!(KktStep::new(&chords, &down, 1e3).is_some(), "{n}");
        }
    }
}
