//! Christoffel symbols, computed from first-order jets of the metric's formula.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::Jet1;

use crate::{Metric, MetricError, check_gram, cholesky};

/// Returns the Christoffel symbols at `x`, in `1/ℓ`: entry `[k][(i, j)]` is `Γᵏᵢⱼ`,
///
/// ```text
/// Γᵏᵢⱼ = ½ Σₗ (H⁻¹)ₖₗ (∂ᵢ Hₗⱼ + ∂ⱼ Hₗᵢ − ∂ₗ Hᵢⱼ)
/// ```
///
/// (equation 3.1). A geodesic satisfies `γ̈ᵏ + Σ Γᵏᵢⱼ γ̇ⁱ γ̇ʲ = 0`.
///
/// # Errors
///
/// [`MetricError`] if `H(x)` is not finite, symmetric and positive definite.
pub fn christoffel<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
) -> Result<[SMatrix<f64, D, D>; D], MetricError> {
    let factor = cholesky(&check_gram(metric, x)?);
    let jets = metric.gram(&SVector::from(Jet1::variables(&(*x).into())));
    // ∂ₖ Hᵢⱼ, read from the half i ≤ j.
    let d = |k: usize, i: usize, j: usize| jets[(i.min(j), i.max(j))].first(k);
    let mut gamma = [SMatrix::zeros(); D];
    for i in 0..D {
        for j in 0..D {
            let mut column =
                SVector::<f64, D>::from_fn(|l, _| 0.5 * (d(i, l, j) + d(j, l, i) - d(l, i, j)));
            if let Some(l) = &factor {
                l.solve_lower_triangular_mut(&mut column);
                l.tr_solve_lower_triangular_mut(&mut column);
            }
            for k in 0..D {
                gamma[k][(i, j)] = column[k];
            }
        }
    }
    Ok(gamma)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_scalar::Jet2;

    use super::christoffel;
    use crate::Metric;
    use crate::gallery::{Shear, Sphere, Swirl, Valleys};

    /// For `H = φ I`, returns `Γᵏᵢⱼ = ½ (δₖᵢ ∂ⱼ + δₖⱼ ∂ᵢ − δᵢⱼ ∂ₖ) log φ`.
    fn conformal(gradient_of_log: [f64; 2], k: usize, i: usize, j: usize) -> f64 {
        let delta = |a: usize, b: usize| f64::from(u8::from(a == b));
        0.5 * (delta(k, i) * gradient_of_log[j] + delta(k, j) * gradient_of_log[i]
            - delta(i, j) * gradient_of_log[k])
    }

    /// For the pullback of the Euclidean metric by `Φ`, `Γᵏᵢⱼ = Σₘ (DΦ⁻¹)ₖₘ ∂ᵢ∂ⱼ Φₘ`. The matrices
    /// are full, so an exchange of two indices cannot go unnoticed.
    #[test]
    fn flat_metrics_have_the_second_derivatives_of_their_chart() {
        #[track_caller]
        fn compare(
            metric: &impl Metric<2>,
            chart: impl Fn(&SVector<Jet2<f64, 2>, 2>) -> SVector<Jet2<f64, 2>, 2>,
        ) {
            let x = vector![0.7, -0.3];
            let gamma = christoffel(metric, &x).expect("positive definite");
            let flat = chart(&SVector::from(Jet2::variables(&[x[0], x[1]])));
            let slope = SMatrix::<f64, 2, 2>::from_fn(|m, i| flat[m].first(i));
            let inverse = slope.try_inverse().expect("of determinant 1");
            for (k, i, j) in
                (0..8).map(|place: usize| (place & 1, (place >> 1) & 1, (place >> 2) & 1))
            {
                let bend = vector![flat[0].second(i, j), flat[1].second(i, j)];
                let exact = inverse.row(k).transpose().dot(&bend);
                // This allows for about thirty roundings of numbers below 10.
                assert_relative_eq!(gamma[k][(i, j)], exact, epsilon = 1e-14, max_relative = 1e-13);
            }
        }
        let shear = Shear::new(1.5, 2.0).expect("a wave number");
        compare(&shear, |x| shear.flatten(x));
        let swirl = Swirl::new(1.5, 0.8).expect("a width");
        compare(&swirl, |x| swirl.flatten(x));
    }

    #[test]
    fn conformal_metrics_have_the_closed_form() {
        let x = vector![0.7, -0.3];
        let r2 = x.norm_squared();
        let sphere = christoffel(&Sphere, &x).expect("positive definite");
        let valleys = christoffel(&Valleys, &x).expect("positive definite");
        // The gradients of log 4/(1+r²)² and of log (2 − cos x₁)².
        let grad_sphere = [-4.0 * x[0] / (1.0 + r2), -4.0 * x[1] / (1.0 + r2)];
        let grad_valleys = [2.0 * x[0].sin() / (2.0 - x[0].cos()), 0.0];
        for (k, i, j) in [(0, 0, 0), (0, 0, 1), (0, 1, 1), (1, 0, 0), (1, 1, 0), (1, 1, 1)] {
            let close =
                |a: f64, b: f64| assert_relative_eq!(a, b, epsilon = 1e-15, max_relative = 1e-14);
            close(sphere[k][(i, j)], conformal(grad_sphere, k, i, j));
            close(valleys[k][(i, j)], conformal(grad_valleys, k, i, j));
        }
    }
}
