//! The effect of rounding on a search: which decrements, chords and eigenvalues are negligible.

use tautline_discretizations::{ANY, PointSequence, QuadraticModel};

use crate::newton::magnitude::Magnitude;

/// The relative decrement at which a search has converged. Below `10⁻¹⁵` the energy cannot be
/// lowered in `f64`, but the points can still be improved, since their error is the root of the
/// decrement.
const CONVERGED: f64 = 1e-18;

/// Returns the effect of rounding the points on a difference `βₙ`, in `ℓ`: `N ε max |x|`.
pub(crate) fn rounding<const D: usize>(sequence: &PointSequence<D>) -> f64 {
    sequence.n().get() as f64 * f64::EPSILON * sequence.extent()
}

/// Returns the decrement, in `m²`, that cannot be lowered in `f64`.
///
/// Coordinates are rounded by at most `u/2`, where `u ≤ ε max |x|`, with variance `u²/12`. With the
/// diagonal blocks `4N H` of the Hessian, this alone leaves a decrement of
/// `½ Σₙ 4N tr H u²/12 = tr H (N u)²/6`. The result allows twelve times as much, for fluctuations
/// at small `N` and for the ends, which are rounded several times by projections.
pub(crate) fn negligible<const D: usize>(
    Magnitude { energy, mean_gram }: Magnitude,
    sequence: &PointSequence<D>,
) -> f64 {
    let trace = sequence.dimension() as f64 * mean_gram;
    (CONVERGED * energy).max(2.0 * trace * rounding(sequence).powi(2))
}

/// Returns whether no chord is longer than the rounding of its ends.
pub(crate) fn is_rounding(model: &QuadraticModel, sequence: &PointSequence<ANY>) -> bool {
    let n = sequence.n().get();
    let beta = 4.0 * rounding(sequence);
    let gaps = sequence.row(0).iter().zip(sequence.row(n)).map(|(x, y)| (y - x).abs());
    gaps.fold(0.0, f64::max) * n as f64 <= beta && model.energy <= model.mean_gram * beta.powi(2)
}

/// Returns the error of the computed eigenvalues of the Hessian, as a multiple of the regulariser
/// of [`Shifted`](crate::newton::factorization::Shifted). A Hessian that is definite by a smaller
/// margin cannot be distinguished from one with a zero eigenvalue, as in a continuum of minimisers.
///
/// The blocks, of size `4N`, are sums of rounded terms, and elimination rounds as often again: the
/// error is about `8 ε N`. The eigenvalues of the regulariser are at least `1/N`. Hence the
/// multiple is `8 ε N²`; it is doubled. On coarse grids the error of the iterate dominates: a
/// decrement of `10⁻¹⁸` leaves the iterate, and with it the Hessian, off by up to `10⁻⁹` of the
/// variation of the metric. The upper limit makes sure that the margin, which changes the Newton
/// matrix, is harmless on huge grids.
pub(crate) fn margin(n: usize) -> f64 {
    (16.0 * f64::EPSILON * (n as f64).powi(2)).clamp(1e-8, 1e-3)
}

#[cfg(test)]
mod tests {
    use tautline_discretizations::{PointSequence, QuadraticModel, Rule};
    use tautline_metrics::gallery::Valleys;

    use super::{Magnitude, is_rounding, margin, negligible, rounding};

    #[test]
    fn near_the_origin_the_energy_decides_and_far_away_the_points() {
        let shifted = |x: f64| {
            let line = PointSequence::straight([x, 0.0], [x, 1.0], 8).expect("finite");
            let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &Valleys, &line);
            assert!(!is_rounding(&model, &line.clone().into_any()));
            (negligible(Magnitude::of(&model), &line), model.energy)
        };
        // At x = 0 the metric is the identity and E = 1; 4 (8 ε)² = 1e-29 is negligible.
        assert_eq!(shifted(0.0), (1e-18, 1.0));
        // At x = 2π 10⁹, N ε x = 1.1e-5 and 4 (1.1e-5)² = 5e-10.
        let (far, energy) = shifted(std::f64::consts::TAU * 1e9);
        assert!((4e-10..6e-10).contains(&(far / energy)), "{far:e}");
    }

    #[test]
    fn a_chord_of_one_rounding_is_rounding() {
        let b = 1.0 + f64::EPSILON;
        let line = PointSequence::straight([1.0, 0.0], [b, 0.0], 4).expect("finite");
        assert!(is_rounding(
            &QuadraticModel::new(Rule::TRAPEZOIDAL, &Valleys, &line),
            &line.clone().into_any()
        ));
    }

    #[test]
    fn the_farthest_point_sets_the_rounding_wherever_it_is() {
        for far in 0..4 {
            let mut points = vec![nalgebra::vector![1.0, -1.0]; 4];
            points[far][far % 2] = -1e6;
            let bent = PointSequence::new(points).expect("finite");
            assert_eq!(rounding(&bent), 3.0 * f64::EPSILON * 1e6);
        }
    }

    /// The two ends agree, but the chords are long.
    #[test]
    fn a_loop_is_not_rounding() {
        let loop_of = |size: f64| {
            let points = [[1.0, 0.0], [1.0, size], [1.0, 0.0]].map(nalgebra::SVector::from);
            let line = PointSequence::new(points.to_vec()).expect("finite");
            is_rounding(
                &QuadraticModel::new(Rule::TRAPEZOIDAL, &Valleys, &line),
                &line.clone().into_any(),
            )
        };
        assert!(!loop_of(1.0) && !loop_of(1e-12) && loop_of(1e-16));
    }

    #[test]
    fn the_margin_grows_with_the_grid_and_stays_small() {
        assert_eq!((margin(1), margin(10_000_000)), (1e-8, 1e-3));
        assert!(margin(100_000) > 1e-5 && margin(100_000) < 1e-4);
    }
}
