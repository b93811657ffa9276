//! What rounding does to a search: how small a decrement, a chord or an eigenvalue still counts.

use tautline_discretizations::{PointSequence, QuadraticModel};

use crate::newton::magnitude::Magnitude;

/// Relative decrement at which a search has converged: the energy cannot be lowered in `f64`
/// from `10⁻¹⁵` on, but the points, off by the root of it, can be improved.
const CONVERGED: f64 = 1e-18;

/// What rounding of the points does to a difference `βₙ`, in `ℓ`: `N ε max |x|`.
pub(crate) fn rounding<const D: usize>(sequence: &PointSequence<D>) -> f64 {
    sequence.n().get() as f64 * f64::EPSILON * sequence.extent()
}

/// The decrement, in `m²`, that cannot be lowered in `f64`.
///
/// Coordinates are rounded by `u/2` at most, `u ≤ ε max |x|`, with the variance `u²/12`. The
/// Hessian has the diagonal blocks `4N H`, so that this alone leaves a decrement of
/// `½ Σₙ 4N tr H u²/12 = tr H (N u)²/6`; twelve times that is granted, for the chance of small
/// `N` and for the end points, which projections round several times.
pub(crate) fn negligible<const D: usize>(
    Magnitude { energy, mean_gram }: Magnitude,
    sequence: &PointSequence<D>,
) -> f64 {
    let trace = D as f64 * mean_gram;
    (CONVERGED * energy).max(2.0 * trace * rounding(sequence).powi(2))
}

/// Whether all chords are nothing but the rounding of their ends.
pub(crate) fn is_rounding<const D: usize>(
    model: &QuadraticModel<D>,
    sequence: &PointSequence<D>,
) -> bool {
    let n = sequence.n().get() as f64;
    let beta = 4.0 * rounding(sequence);
    (sequence.last() - sequence.first()).amax() * n <= beta
        && model.energy <= model.mean_gram * beta.powi(2)
}

/// How far the computed eigenvalues of the Hessian may be off, as a multiple of the
/// regulariser of [`Shifted`](crate::newton::factorization::Shifted): a Hessian that is definite by
/// less is not told from one with an eigenvalue zero, as a continuum of minimisers has.
///
/// The blocks, of the size `4N`, are sums of rounded terms, and eliminated with as many
/// roundings again: some `8 ε N`. The regulariser has at least `1/N`. Hence `8 ε N²`, doubled.
/// On coarse grids the iterate counts more: a decrement of `10⁻¹⁸` may leave it, and with it
/// the Hessian, off by `10⁻⁹` times what a metric varies. As a change of the Newton matrix the margin is harmless,
/// and on huge grids it is kept so.
pub(crate) fn margin(n: usize) -> f64 {
    (16.0 * f64::EPSILON * (n as f64).powi(2)).clamp(1e-8, 1e-3)
}

#[cfg(test)]
mod tests {
    use tautline_discretizations::{PointSequence, QuadraticModel, Trapezoidal};
    use tautline_metrics::gallery::Valleys;

    use super::{Magnitude, is_rounding, margin, negligible, rounding};

    #[test]
    fn near_the_origin_the_energy_decides_and_far_away_the_points() {
        let shifted = |x: f64| {
            let line = PointSequence::straight([x, 0.0], [x, 1.0], 8).expect("finite");
            let model = QuadraticModel::new(Trapezoidal, &Valleys, &line);
            assert!(!is_rounding(&model, &line));
            (negligible(Magnitude::of(&model), &line), model.energy)
        };
        // At x = 0 the metric is the identity: E = 1, and 4 (8 ε)² = 1e-29 is nothing.
        assert_eq!(shifted(0.0), (1e-18, 1.0));
        // At x = 2π 10⁹: N ε x = 1.1e-5, and 4 (1.1e-5)² = 5e-10.
        let (far, energy) = shifted(std::f64::consts::TAU * 1e9);
        assert!((4e-10..6e-10).contains(&(far / energy)), "{far:e}");
    }

    #[test]
    fn a_chord_of_one_rounding_is_rounding() {
        let b = 1.0 + f64::EPSILON;
        let line = PointSequence::straight([1.0, 0.0], [b, 0.0], 4).expect("finite");
        assert!(is_rounding(&QuadraticModel::new(Trapezoidal, &Valleys, &line), &line));
    }

    /// Whichever point is far from the origin is rounded most.
    #[test]
    fn the_farthest_point_decides_wherever_it_is() {
        for far in 0..4 {
            let mut points = vec![nalgebra::vector![1.0, -1.0]; 4];
            points[far][far % 2] = -1e6;
            let bent = PointSequence::new(points).expect("finite");
            assert_eq!(rounding(&bent), 3.0 * f64::EPSILON * 1e6);
        }
    }

    /// From a point back to it, or nearly: a way there and back is no rounding.
    #[test]
    fn a_loop_is_not_rounding() {
        let loop_of = |size: f64| {
            let points = [[1.0, 0.0], [1.0, size], [1.0, 0.0]].map(nalgebra::SVector::from);
            let line = PointSequence::new(points.to_vec()).expect("finite");
            is_rounding(&QuadraticModel::new(Trapezoidal, &Valleys, &line), &line)
        };
        assert!(!loop_of(1.0) && !loop_of(1e-12) && loop_of(1e-16));
    }

    #[test]
    fn the_margin_grows_with_the_grid_and_stays_small() {
        assert_eq!((margin(1), margin(10_000_000)), (1e-8, 1e-3));
        assert!(margin(100_000) > 1e-5 && margin(100_000) < 1e-4);
    }
}
