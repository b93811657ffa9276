//! A point sequence on another grid: interpolation of the fifth degree in time.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;

/// So many points a polynomial goes through.
const POINTS: usize = 6;

/// Returns the sequence with `n ≥ 1` subintervals that follows `sequence`: on each of its
/// subintervals the polynomial through the six nearest points (all, if there are fewer).
///
/// Keeps both ends exactly. The error on a smooth curve is `O(N⁻⁶)` of the coarser grid: on fine
/// grids less than the points are rounded by, so that no Newton step is left.
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
    let count = points.len().min(POINTS);
    let fraction = 1.0 / n as f64;
    fine.clear();
    fine.reserve_exact(n + 1);
    let (mut place, mut basis) = (0, basis(count, 0));
    // Where the next point is on the coarse grid: whole + rest / n, without rounding.
    let mut rest = 0;
    for whole in 0..coarse {
        let first = whole.saturating_sub(POINTS / 2 - 1).min(points.len() - count);
        if place != whole - first {
            place = whole - first;
            basis = self::basis(count, place);
        }
        let near = &points[first..first + count];
        let start = points[whole];
        let mut coefficients = [SVector::<f64, D>::zeros(); POINTS];
        for (point, weights) in near.iter().zip(&basis) {
            let difference = point - start;
            for (coefficient, weight) in coefficients.iter_mut().zip(weights) {
                *coefficient += difference * *weight;
            }
        }
        let [_, a, b, c, d, e] = coefficients;
        let count = n.saturating_sub(rest).div_ceil(coarse);
        fine.extend((0..count).map(|k| {
            let s = (rest + k * coarse) as f64 * fraction;
            start + ((((e * s + d) * s + c) * s + b) * s + a) * s
        }));
        rest += count * coarse;
        rest -= n;
    }
    fine.push(points[coarse]);
    fine
}

/// The coefficients, of `1, s, s², …`, of the polynomials that are 1 at one of `count` places
/// and 0 at the others, which are at `s = −place, 1 − place, …`.
fn basis(count: usize, place: usize) -> [[f64; POINTS]; POINTS] {
    let mut basis = [[0.0; POINTS]; POINTS];
    for (own, polynomial) in basis.iter_mut().enumerate().take(count) {
        polynomial[0] = 1.0;
        for other in (0..count).filter(|&other| other != own) {
            // Times (s − o)/(p − o), with the place o of the other and p of its own.
            let [p, o] = [own, other].map(|k| k as f64 - place as f64);
            for k in (0..count).rev() {
                let lower = if k > 0 { polynomial[k - 1] } else { 0.0 };
                polynomial[k] = (lower - o * polynomial[k]) / (p - o);
            }
        }
    }
    basis
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_discretizations::PointSequence;

    use super::prolong;

    #[test]
    fn curves_of_the_fifth_degree_are_followed_exactly() {
        let curve = |t: f64| vector![t.powi(5) - t, 2.0 - t.powi(4)];
        for (coarse, fine) in [(5, 20), (6, 6), (7, 9), (32, 45), (45, 32), (9, 1)] {
            let points = (0..=coarse).map(|k| curve(k as f64 / coarse as f64)).collect();
            let sequence = PointSequence::new(points).expect("finite");
            let found = prolong(&sequence, fine);
            assert_eq!(found.len(), fine + 1);
            assert_eq!(
                (found.first(), found.last()),
                (Some(sequence.first()), Some(sequence.last()))
            );
            for (k, point) in found.iter().enumerate() {
                // Six weights up to 5, coordinates up to 2.
                assert!((point - curve(k as f64 / fine as f64)).amax() < 2e-14);
            }
        }
    }

    /// With fewer points, of a lower degree.
    #[test]
    fn three_points_are_joined_by_a_parabola() {
        let parabola = |t: f64| vector![1.0 - 3.0 * t * t];
        let points = [0.0, 0.5, 1.0].map(parabola).to_vec();
        let found = prolong(&PointSequence::new(points).expect("finite"), 7);
        for (k, point) in found.iter().enumerate() {
            // Three weights up to 1, coordinates up to 2.
            assert!((point - parabola(k as f64 / 7.0)).amax() < 4e-15);
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
