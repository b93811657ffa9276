//! `Flattened`: a metric whose heights are lowered.

use nalgebra::{SMatrix, SVector};
use tautline::{Metric, Scalar, TautLine, check_gram};

/// `H_s(x) = (1 − s) c I + s H(x)`: the Euclidean metric at `s = 0`, and `H` at `s = 1`. Where `H ≥ c I`,
/// it grows with `s`: bumps rise, and minimal geodesics split into those on either side of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flattened<'m, M> {
    /// The metric `H`.
    pub metric: &'m M,
    /// The level `c`, in `m²/ℓ²`.
    pub level: f64,
    /// The share `s` of `H`, from 0 to 1.
    pub share: f64,
}

impl<M: Metric<D>, const D: usize> Metric<D> for Flattened<'_, M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let flat = S::constant((1.0 - self.share) * self.level);
        self.metric.gram(x).map(|h| h * self.share) + SMatrix::from_diagonal_element(flat)
    }
}

/// Returns a level `c` with `H ≥ c I` at the points of a line, `1/‖H⁻¹‖`.
pub(crate) fn level<M: Metric<D>, const D: usize>(line: &TautLine<M, D>) -> Option<f64> {
    let points = line.sequence().points().iter();
    let inverse = |x| Some(check_gram(line.metric(), x).ok()?.cholesky()?.inverse().norm());
    points.map(inverse).try_fold(0.0, |most, norm| Some(f64::max(most, norm?))).map(f64::recip)
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, matrix, vector};
    use tautline::{
        Ends, Metric, Problem, Rule,
        gallery::{Constant, Valleys},
    };

    use super::{Flattened, level};

    /// `(1 − s) c I + s H`, with shares and entries that are exact in binary.
    #[test]
    fn a_flattened_metric_rises_from_the_flat_one() {
        let metric = Constant::new(matrix![9.0, 2.0; 2.0, 6.0]).expect("positive definite");
        for (share, expected) in [
            (0.0, matrix![4.0, 0.0; 0.0, 4.0]),
            (0.25, matrix![5.25, 0.5; 0.5, 4.5]),
            (1.0, matrix![9.0, 2.0; 2.0, 6.0]),
        ] {
            let flattened = Flattened { metric: &metric, level: 4.0, share };
            let found: SMatrix<f64, 2, 2> = flattened.gram(&vector![0.5, -1.0]);
            assert_eq!(found, expected, "{share}");
        }
    }

    /// The Frobenius norm of `H⁻¹` is between its largest eigenvalue and `√2` times that.
    #[test]
    fn a_level_is_below_all_eigenvalues() {
        let metric = Constant::new(matrix![9.0, 2.0; 2.0, 6.0]).expect("positive definite");
        let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
        let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 4).expect("solved");
        // The eigenvalues are 5 and 10.
        let level = level(&line).expect("a metric");
        assert!((5.0 / 2.0_f64.sqrt()..=5.0).contains(&level), "{level}");
    }

    /// The level is below the metric at all points of the line: from the ridge of the valleys, where `H = 9 I`,
    /// to their bottom, where it is `I`, and back.
    #[test]
    fn a_level_is_that_of_the_lowest_point() {
        let (ridge, bottom) = ([std::f64::consts::PI, 0.0], [0.0, 0.0]);
        for (a, b) in [(ridge, bottom), (bottom, ridge)] {
            let ends = Ends::points(a, b).expect("finite");
            let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 16).expect("solved");
            let level = level(&line).expect("a metric");
            assert!((0.5_f64.sqrt() * (1.0 - 1e-15)..=1.0).contains(&level), "{level}");
        }
    }
}
