//! The second derivatives of a metric, which `M_H` bounds.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline::{AnyMetric, Jet2, Metric, PointSequence};

use crate::reconstruction::nodes;

/// The number of times that each of the two directions is improved.
const ROUNDS: usize = 3;

/// Returns the greatest `|uᵀ D²H[w, w] u|` that is found at the ends and midpoints of the chords,
/// in `m²/ℓ⁴`, for unit vectors `u` and `w`. It is at most `M_H`.
///
/// The two directions are independent: the proofs also compare `H` beside a curve with `H` on it.
#[must_use]
pub fn curvature_along<const D: usize>(
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> f64 {
    let metric = &AnyMetric::new(metric);
    // This keeps NaN.
    let greater = |greatest: f64, found: f64| if found <= greatest { greatest } else { found };
    nodes(sequence).map(|x| curvature_at(metric, &x)).fold(0.0, greater)
}

/// Returns the greatest `|uᵀ D²H(x)[w, w] u|` that is found for unit vectors `u` and `w`, in
/// `m²/ℓ⁴`.
///
/// The search starts from each axis as `w` and alternates: for given `w` the best `u` is an
/// eigenvector of `D²H[w, w]`, and for given `u` the best `w` is one of the Hessian of `uᵀHu`. No
/// step decreases the value. On a line, and for `H = φ I` in the second step, the result is exact.
pub(crate) fn curvature_at<const D: usize>(metric: &impl Metric<D>, x: &SVector<f64, D>) -> f64 {
    let h = metric.gram(&Jet2::<f64, D>::variables(&(*x).into()).into());
    if D == 1 {
        return h[(0, 0)].second(0, 0).abs();
    }
    let of_entry = |i: usize, j: usize, w: &SVector<f64, D>| -> f64 {
        let pairs = (0..D).flat_map(|k| (0..D).map(move |l| (k, l)));
        pairs.map(|(k, l)| h[(i.min(j), i.max(j))].second(k, l) * w[k] * w[l]).sum()
    };
    let along = |w: &SVector<f64, D>| SMatrix::from_fn(|i, j| of_entry(i, j, w));
    let hessian = |u: &SVector<f64, D>| {
        SMatrix::from_fn(|k, l| {
            let pairs = (0..D).flat_map(|i| (0..D).map(move |j| (i, j)));
            pairs.map(|(i, j)| h[(i.min(j), i.max(j))].second(k, l) * u[i] * u[j]).sum()
        })
    };
    let mut greatest = 0.0_f64;
    for axis in 0..D {
        let mut w = SVector::from_fn(|i, _| if i == axis { 1.0 } else { 0.0 });
        for _ in 0..ROUNDS {
            let Some((_, u)) = largest(&along(&w)) else { return f64::NAN };
            let Some((found, better)) = largest(&hessian(&u)) else { return f64::NAN };
            let improves = found > greatest * (1.0 + 1e-6);
            greatest = greatest.max(found);
            if !improves {
                break;
            }
            w = better;
        }
    }
    greatest
}

/// Returns the absolute value of the eigenvalue that is largest in absolute value, with its
/// eigenvector, or `None` if an entry is not finite.
fn largest<const D: usize>(matrix: &SMatrix<f64, D, D>) -> Option<(f64, SVector<f64, D>)> {
    if !matrix.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let eigen = DMatrix::from_fn(D, D, |i, j| matrix[(i, j)]).symmetric_eigen();
    let at = eigen.eigenvalues.iamax();
    let vector = SVector::from_fn(|i, _| eigen.eigenvectors[(i, at)]);
    Some((eigen.eigenvalues[at].abs(), vector))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline::{
        Bounded, Metric, PointSequence, Scalar,
        gallery::{RotatingAnisotropy, Shear, Valleys},
    };

    use super::{curvature_along, curvature_at};

    /// On the ridge `x₁ = π` the second derivative is −6 across a chord along `x₂`, and 0 along it.
    #[test]
    fn what_bends_across_a_chord_is_seen() {
        let chord = PointSequence::straight([std::f64::consts::PI, 0.0], [3.2, 1.0], 1);
        let seen = curvature_along(&Valleys, &chord.expect("finite"));
        assert!((seen - 6.0).abs() < 1e-12, "{seen}");
    }

    /// `H = diag(x₂², 0)/2 + I`: from `w = e₁` nothing is seen, from `w = e₂` everything.
    #[test]
    fn the_two_directions_are_independent() {
        struct Across;
        impl Metric<2> for Across {
            fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                let one = x[0] * 0.0 + 1.0;
                SMatrix::from_diagonal(&[x[1].sqr() * 0.5 + 1.0, one].into())
            }
        }
        assert_eq!(curvature_at(&Across, &[0.3, 0.4].into()), 1.0);
    }

    /// The second derivative of the shear, and of a turning matrix, is as large as `M_H` somewhere.
    #[test]
    fn full_matrices_attain_their_constant() {
        fn greatest<M: Bounded<2>>(metric: &M) -> f64 {
            let points = (0..400).map(|k| [0.0, 6.3 * f64::from(k) / 400.0].into());
            let seen = points.map(|x| curvature_at(metric, &x)).fold(0.0, f64::max);
            seen / metric.constants().m_h().expect("known")
        }
        let shear = Shear::new(0.5, 1.0).expect("valid");
        let found = greatest(&shear);
        assert!((0.99..=1.0 + 1e-12).contains(&found), "{found}");
        let turning = RotatingAnisotropy::new([1.0, 2.0], [0.3, 1.0]).expect("valid");
        let found = greatest(&turning);
        assert!((0.99..=1.0 + 1e-12).contains(&found), "{found}");
    }
}
