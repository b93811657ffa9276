//! A point sequence on another grid: cubic interpolation in time.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;

/// Returns the sequence with `n ≥ 1` subintervals that follows `sequence`, by cubic
/// interpolation through the four nearest points (all, if there are fewer).
///
/// Keeps both ends exactly. The error on a smooth curve is `O(N⁻⁴)` of the coarser grid, so
/// that one Newton step on the finer grid is left.
pub(crate) fn prolong<const D: usize>(
    sequence: &PointSequence<D>,
    n: usize,
) -> Vec<SVector<f64, D>> {
    let points = sequence.points();
    let coarse = points.len() - 1;
    let width = points.len().min(4);
    (0..=n)
        .map(|k| {
            // The position on the coarse grid is k · coarse / n: split without rounding.
            let (whole, rest) = (k * coarse / n, k * coarse % n);
            if rest == 0 {
                return points[whole];
            }
            let first = whole.saturating_sub(1).min(points.len() - width);
            let s = (whole - first) as f64 + rest as f64 / n as f64;
            lagrange(&points[first..first + width], s)
        })
        .collect()
}

/// The value at `s` of the polynomial through the points at `0, 1, …`.
fn lagrange<const D: usize>(points: &[SVector<f64, D>], s: f64) -> SVector<f64, D> {
    let mut value = SVector::zeros();
    for (i, point) in points.iter().enumerate() {
        let mut weight = 1.0;
        for j in (0..points.len()).filter(|&j| j != i) {
            weight *= (s - j as f64) / (i as f64 - j as f64);
        }
        value += point * weight;
    }
    value
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_discretizations::PointSequence;

    use super::prolong;

    #[test]
    fn cubic_curves_are_followed_exactly() {
        let cubic = |t: f64| vector![t * t * t - t, 2.0 - t * t];
        for (coarse, fine) in [(3, 12), (5, 20), (7, 9), (32, 45)] {
            let points = (0..=coarse).map(|k| cubic(k as f64 / coarse as f64)).collect();
            let sequence = PointSequence::new(points).expect("finite");
            for (k, point) in prolong(&sequence, fine).iter().enumerate() {
                // Weights up to 2, coordinates up to 2.
                assert!((point - cubic(k as f64 / fine as f64)).amax() < 1e-14);
            }
        }
    }

    #[test]
    fn two_points_are_joined_by_a_line() {
        let sequence = PointSequence::straight([0.0], [1.0], 1).expect("finite");
        assert_eq!(
            prolong(&sequence, 4).iter().map(|x| x[0]).collect::<Vec<_>>(),
            [0.0, 0.25, 0.5, 0.75, 1.0]
        );
    }
}
