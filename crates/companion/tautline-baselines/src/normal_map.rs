//! `NormalMap`: the ends of geodesics that are normal to a closed set, by a point of `R^D`.

use nalgebra::{DMatrix, SMatrix, SVD, SVector};
use tautline::{ClosedSet, Jet1, Metric};

/// The curves that leave a set, or arrive in it, normally to it.
///
/// A point `z`, in `ℓ`, stands for the end `p = P(z)` of a curve, with the nearest-point map `P` of
/// the set, and for the momentum `H(p)v = ±σ(z − p)`, with `+` for curves that leave. The momentum
/// is then normal to the set, and every momentum if the set is a point. This is the normal map of
/// S. M. Robinson, Normal maps induced by linear transformations, Math. Oper. Res. 17 (1992).
pub(crate) struct NormalMap<'a, const D: usize> {
    pub(crate) set: &'a dyn ClosedSet<D>,
    /// `±σ`, in `m²/ℓ²`.
    pub(crate) scale: f64,
}

/// An end of a curve, with its derivatives by `z`, which are pure numbers.
pub(crate) struct End<const D: usize> {
    /// `p`, in `ℓ`.
    pub(crate) position: SVector<f64, D>,
    /// `v`, in `ℓ`.
    pub(crate) velocity: SVector<f64, D>,
    pub(crate) position_by: SMatrix<f64, D, D>,
    pub(crate) velocity_by: SMatrix<f64, D, D>,
}

impl<const D: usize> NormalMap<'_, D> {
    /// Evaluates the map. The velocity is NaN if `H(p)` has no inverse.
    pub(crate) fn at(&self, metric: &impl Metric<D>, z: &SVector<f64, D>) -> End<D> {
        let position = self.set.project(z);
        let position_by = self.set.projection_derivative(z);
        let inverse = metric.gram(&position).try_inverse();
        let inverse = inverse.unwrap_or_else(|| SMatrix::from_element(f64::NAN));
        let velocity = inverse * (z - position) * self.scale;
        // H v = σ (z − p) gives H dv = σ (dz − dp) − dH v.
        let momentum_by = (SMatrix::identity() - position_by) * self.scale;
        let velocity_by =
            inverse * (momentum_by - turned(metric, &position, &velocity) * position_by);
        End { position, velocity, position_by, velocity_by }
    }

    /// Returns the `z` of the point `p` and the velocity `v`, if that is normal to the set.
    pub(crate) fn unknown(
        &self,
        metric: &impl Metric<D>,
        p: &SVector<f64, D>,
        v: &SVector<f64, D>,
    ) -> SVector<f64, D> {
        p + metric.gram(p) * v / self.scale
    }
}

/// Returns nearby points of two sets: alternating projections approach a nearest pair of convex
/// sets.
pub(crate) fn nearby<const D: usize>(
    first: &dyn ClosedSet<D>,
    second: &dyn ClosedSet<D>,
) -> [SVector<f64, D>; 2] {
    let mut near = [first.project(&SVector::zeros()); 2];
    for _ in 0..64 {
        near[1] = second.project(&near[0]);
        near[0] = first.project(&near[1]);
    }
    near
}

/// Returns the derivative of `H(x)v` by `x`, for a `v` that does not depend on `x`.
pub(crate) fn turned<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let jets = metric.gram(&SVector::from(Jet1::variables(&(*x).into())));
    SMatrix::from_fn(|i, m| (0..D).map(|j| jets[(i.min(j), i.max(j))].first(m) * v[j]).sum())
}

/// Returns the matrix that takes `b` to the shortest `x` for which `|Ax − b|` is least, with
/// singular values below `10⁻⁹` of the largest taken as zero; `None` if `A` is not finite.
///
/// Between two circles about the centre of a symmetric metric there is a geodesic in every
/// direction. The equations are singular along such a family, and a step does not move along it.
pub(crate) fn pseudo_inverse<const D: usize>(a: &SMatrix<f64, D, D>) -> Option<SMatrix<f64, D, D>> {
    if !a.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let matrix = DMatrix::from_fn(D, D, |i, j| a[(i, j)]);
    let svd = SVD::try_new(matrix, true, true, f64::EPSILON, 1000)?;
    let cut = 1e-9 * svd.singular_values.max();
    let inverse = svd.pseudo_inverse(cut).ok()?;
    Some(SMatrix::from_fn(|i, j| inverse[(i, j)]))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, matrix, vector};
    use tautline::gallery::Swirl;
    use tautline::{Ball, HalfSpace};

    use super::{NormalMap, nearby, pseudo_inverse};

    /// A central difference of step `h = 10⁻⁴` has the error `h²/6` times a derivative below `10³`.
    #[test]
    fn the_derivatives_are_those_of_differences() {
        let swirl = Swirl::new(1.5, 0.8).expect("a width");
        let ball = Ball::new([0.2, 0.1], 0.5).expect("a radius");
        let map = NormalMap { set: &ball, scale: -1.5 };
        let z = vector![1.0, 0.7];
        let exact = map.at(&swirl, &z);
        for m in 0..2 {
            let step = SVector::<f64, 2>::from_fn(|i, _| if i == m { 1e-4 } else { 0.0 });
            let (a, b) = (map.at(&swirl, &(z - step)), map.at(&swirl, &(z + step)));
            let position_by = (b.position - a.position) / 2e-4;
            let velocity_by = (b.velocity - a.velocity) / 2e-4;
            assert!((exact.position_by.column(m) - position_by).norm() < 2e-6);
            assert!((exact.velocity_by.column(m) - velocity_by).norm() < 2e-6);
            assert!(position_by.norm() > 0.1 && velocity_by.norm() > 0.1);
        }
        // Two roundings of each of a few products.
        let again = map.unknown(&swirl, &exact.position, &exact.velocity);
        assert!((again - z).norm() < 1e-14, "{again}");
    }

    #[test]
    fn nearby_points_of_a_ball_and_a_wall_are_nearest() {
        let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
        let wall = HalfSpace::new([-1.0, 0.0], -3.0).expect("a normal");
        let [p, q] = nearby(&ball, &wall);
        assert!((p - vector![0.5, 0.0]).norm() < 1e-14 && (q - vector![3.0, 0.0]).norm() < 1e-14);
    }

    #[test]
    fn a_singular_matrix_has_a_pseudo_inverse() {
        let inverse = pseudo_inverse(&matrix![2.0, 0.0; 0.0, 1e-12]).expect("finite");
        assert!((inverse - matrix![0.5, 0.0; 0.0, 0.0]).norm() < 1e-14, "{inverse}");
        assert_eq!(pseudo_inverse(&matrix![2.0, f64::NAN; 0.0, 1.0]), None);
    }

    /// What counts as zero is relative to the largest singular value, in any unit.
    #[test]
    fn a_singular_value_is_zero_below_a_billionth_of_the_largest() {
        for unit in [1.0, 2_f64.powi(60), 2_f64.powi(-60)] {
            let inverse = |small: f64| {
                let a = matrix![2.0, 0.0; 0.0, small] * unit;
                pseudo_inverse(&a).expect("finite") * unit
            };
            // The singular values of a diagonal matrix have a few roundings.
            let found = inverse(4e-9);
            assert!((found[(1, 1)] * 4e-9 - 1.0).abs() < 1e-14, "{unit}: {found}");
            let found = inverse(1e-9);
            assert!((found - matrix![0.5, 0.0; 0.0, 0.0]).norm() < 1e-14, "{unit}: {found}");
        }
    }
}
