//! Distances from points near a set, along one chord.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, check_gram};
use tautline_sets::ClosedSet;

/// The most steps to the nearest point. With momentum, each divides the error by about `1 + 1/√κ` for the
/// condition number `κ` of `H`.
const STEPS: usize = 1000;

/// Returns a point `q` of a set, in `ℓ`, and the length of the chord from `q` to `x`, in `m`, under `H` at
/// its middle; `None` if there is no metric, also at the nearest point.
///
/// The point minimises this length by steps along its gradient, each followed by the nearest-point map:
/// a local minimum, from the point that is nearest in the Euclidean norm. They have momentum, which
/// begins again where the length would grow (B. O'Donoghue and E. Candès, *Adaptive restart for
/// accelerated gradient schemes*, Found. Comput. Math. 15, 2015). For a smooth metric the length is the
/// distance up to the third power of the chord.
pub(super) fn chord<M: Metric<D>, const D: usize>(
    metric: &M,
    set: &dyn ClosedSet<D>,
    x: &SVector<f64, D>,
) -> Option<(SVector<f64, D>, f64)> {
    let mut q = set.project(x);
    check_gram(metric, &q).ok()?;
    let mut length = length(metric, &q, x)?;
    let (mut before, mut moves) = (q, 0.0);
    for _ in 0..STEPS {
        let ahead = q + (q - before) * (moves / (moves + 3.0));
        let Ok(h) = check_gram(metric, &((ahead + x) * 0.5)) else { break };
        let next = set.project(&(ahead - h * (ahead - x) / largest_row(&h)));
        let shorter = self::length(metric, &next, x).unwrap_or(f64::INFINITY);
        // Also where a set that is not convex or the change of H makes a step longer.
        if shorter < length * (1.0 - 1e-15) {
            (before, q, length, moves) = (q, next, shorter, moves + 1.0);
        } else if moves > 0.0 {
            (before, moves) = (q, 0.0);
        } else {
            break;
        }
    }
    Some((q, length))
}

/// Returns the length of a chord under `H` at its middle, in `m`; `None` if there is no metric or the
/// length is not finite.
pub(super) fn length<M: Metric<D>, const D: usize>(
    metric: &M,
    from: &SVector<f64, D>,
    to: &SVector<f64, D>,
) -> Option<f64> {
    let h = check_gram(metric, &((from + to) * 0.5)).ok()?;
    let d = to - from;
    Some(d.dot(&(h * d)).max(0.0).sqrt()).filter(|length| length.is_finite())
}

/// Returns the largest sum of absolute values in a row: no eigenvalue is larger (Gershgorin).
fn largest_row<const D: usize>(h: &SMatrix<f64, D, D>) -> f64 {
    (0..D).map(|i| (0..D).map(|j| h[(i, j)].abs()).sum()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;
    use tautline_metrics::gallery::Constant;
    use tautline_sets::{HalfSpace, Point};

    use super::chord;

    /// For a constant metric the chord to a point is the geodesic, and the distance from the half-space
    /// `n·x ≤ c` is `(n·x − c)/√(nᵀH⁻¹n)`: with `n = e₁` and `H = [[a, b], [b, c]]` it is
    /// `t √(a − b²/c)`. The steps end where a step shortens the chord by less than 10⁻¹⁵ of itself, and each
    /// divides the excess by at least `1 + 1/√κ`, with `κ < 500`, so that it is below `25 · 10⁻¹⁵` then; ten
    /// times that are allowed for a restart at the wrong moment.
    #[test]
    fn a_chord_is_the_distance_under_a_constant_metric() {
        for [a, b, c] in [[4.0, 1.5, 1.0], [1.0, 9.5, 100.0], [100.0, 9.5, 1.0]] {
            let h = SMatrix::<f64, 2, 2>::new(a, b, b, c);
            let metric = Constant::new(h).expect("positive definite");
            let x = [0.7, -0.2].into();
            let wall = HalfSpace::new([1.0, 0.0], 0.4).expect("a wall");
            let (_, length) = chord(&metric, &wall, &x).expect("a metric");
            let exact = 0.3 * (a - b * b / c).sqrt();
            assert!((length / exact - 1.0).abs() < 2.5e-13, "{a} {} {exact}", length / exact - 1.0);
            let point = Point::new([0.0, 0.0]).expect("finite");
            let (_, length) = chord(&metric, &point, &x).expect("a metric");
            assert!((length / x.dot(&(h * x)).sqrt() - 1.0).abs() < 1e-15, "{length}");
        }
    }
}
