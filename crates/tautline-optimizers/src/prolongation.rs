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
    prolong_into(sequence, n, Vec::new())
}

/// The same in memory that is there.
pub(crate) fn prolong_into<const D: usize>(
    sequence: &PointSequence<D>,
    n: usize,
    mut fine: Vec<SVector<f64, D>>,
) -> Vec<SVector<f64, D>> {
    let points = sequence.points();
    let coarse = points.len() - 1;
    let fraction = 1.0 / n as f64;
    // The position on the coarse grid is k · coarse / n: whole + rest / n, without rounding.
    let (mut whole, mut rest) = (0_usize, 0_usize);
    fine.clear();
    fine.reserve_exact(n + 1);
    for _ in 0..=n {
        let s = rest as f64 * fraction;
        let first = whole.saturating_sub(1).min(points.len().saturating_sub(4));
        fine.push(match points[first..].first_chunk::<4>() {
            _ if rest == 0 => points[whole],
            Some(four) => cubic(four, (whole - first) as f64 + s),
            None => lagrange(points, whole as f64 + s),
        });
        rest += coarse;
        while rest >= n {
            rest -= n;
            whole += 1;
        }
    }
    fine
}

/// The value at `s` of the cubic polynomial through the points at 0, 1, 2, 3.
#[inline]
fn cubic<const D: usize>([a, b, c, d]: &[SVector<f64, D>; 4], s: f64) -> SVector<f64, D> {
    let (p, q, r) = (s - 1.0, s - 2.0, s - 3.0);
    let (sp, qr) = (s * p, q * r);
    d * (sp * q * (1.0 / 6.0)) - c * (sp * r * 0.5) + b * (s * qr * 0.5)
        - a * (p * qr * (1.0 / 6.0))
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
