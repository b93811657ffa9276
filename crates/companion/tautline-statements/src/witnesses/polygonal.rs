//! `Polygonal`: a piecewise linear metric on the line.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, KnownDistance, Metric, Scalar};

/// The `ε` in the rounded corners `√(x² + ε²)`, which give a smooth metric with the same `L_H`. Its
/// values differ from the polygon by less than `ε L_H`, and its integrals by less than
/// `100 ε² L_H`.
const ROUNDED: f64 = 1e-12;

/// `H` is linear between the knots `(xₖ, hₖ)`, and constant before the first and after the last;
/// its corners are rounded off over `10⁻¹²`.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygonal {
    knots: Vec<[f64; 2]>,
    /// Half the change of the slope at each knot.
    kinks: Vec<f64>,
    constants: Constants,
}

impl Polygonal {
    /// Returns the metric with these knots, in `ℓ` and `m²/ℓ²`; `None` unless there are at least
    /// two, in increasing order and with positive heights.
    #[must_use]
    pub fn new(knots: &[[f64; 2]]) -> Option<Self> {
        let slopes: Vec<f64> = knots
            .windows(2)
            .map(|pair| (pair[1][1] - pair[0][1]) / (pair[1][0] - pair[0][0]))
            .collect();
        if slopes.is_empty() || !knots.windows(2).all(|pair| pair[0][0] < pair[1][0]) {
            return None;
        }
        let heights = || knots.iter().map(|knot| knot[1]);
        let (low, high) = (heights().fold(f64::INFINITY, f64::min), heights().fold(0.0, f64::max));
        let steepest = slopes.iter().map(|slope| slope.abs()).fold(0.0, f64::max);
        // The margin covers the rounding of a sum of terms up to (xₙ − x₀) L_H, and the rounded
        // corners.
        let span = knots[knots.len() - 1][0] - knots[0][0];
        let margin = 1e-14 * knots.len() as f64 * (high + span * steepest) + ROUNDED * steepest;
        let constants = Constants::new(low - margin, high + margin, steepest).ok()?;
        let outer = |k: usize| slopes.get(k).copied().unwrap_or(0.0);
        // Before the first knot the slope is 0, as it is after the last.
        let kink = |k: usize| 0.5 * (outer(k) - if k == 0 { 0.0 } else { outer(k - 1) });
        let kinks = (0..knots.len()).map(kink).collect();
        Some(Self { knots: knots.to_vec(), kinks, constants })
    }

    /// Returns `∫ √H` from the first knot to an `x` between the knots. A piece of length `l` from
    /// `h` to `k` contributes `⅔ l (h + √(hk) + k)/(√h + √k)`.
    fn primitive(&self, x: f64) -> f64 {
        let mut sum = 0.0;
        for pair in self.knots.windows(2) {
            let ([from, h], [to, top]) = (pair[0], pair[1]);
            let end = x.clamp(from, to);
            let k = h + (top - h) * ((end - from) / (to - from));
            let (h, k) = (h.sqrt(), k.sqrt());
            sum += (end - from) * (h * h + h * k + k * k) / (1.5 * (h + k));
        }
        sum
    }
}

impl Metric<1> for Polygonal {
    /// The value is the mean of the outer heights, plus half the change of slope times `|x − xₖ|`
    /// at each knot.
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let (first, last) = (self.knots[0][1], self.knots[self.knots.len() - 1][1]);
        let mut sum = S::constant(0.5 * (first + last));
        for (knot, kink) in self.knots.iter().zip(&self.kinks) {
            sum += ((x[0] - knot[0]).sqr() + ROUNDED * ROUNDED).sqrt() * *kink;
        }
        SMatrix::from_diagonal_element(sum)
    }
}

impl Bounded<1> for Polygonal {
    /// The constants are the least and the largest height, with a margin for rounding, and the
    /// steepest slope.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<1> for Polygonal {
    /// The distance is `|∫ √H|`, and is known if both points lie between the first and the last
    /// knot.
    fn distance(&self, x: &SVector<f64, 1>, y: &SVector<f64, 1>) -> Option<f64> {
        let (first, last) = (self.knots[0][0], self.knots[self.knots.len() - 1][0]);
        let between = |x: f64| (first..=last).contains(&x);
        let known = between(x[0]) && between(y[0]);
        known.then(|| (self.primitive(x[0]) - self.primitive(y[0])).abs())
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline::{Bounded, KnownDistance, Metric, quadrature::integrate};

    use super::Polygonal;

    #[test]
    fn heights_slopes_and_lengths_match_the_polygon() {
        let metric = Polygonal::new(&[[0.0, 1.0], [1.0, 3.0], [3.0, 2.0]]).expect("in order");
        let height = |x: f64| metric.gram(&vector![x])[(0, 0)];
        for (x, h) in [(-1.0, 1.0), (0.0, 1.0), (0.5, 2.0), (1.0, 3.0), (2.0, 2.5), (4.0, 2.0)] {
            // The tolerance covers the rounded corners and four terms up to 6.
            assert!((height(x) - h).abs() <= 4e-12, "H({x}) = {}", height(x));
        }
        assert_eq!(metric.constants().l_h(), 2.0);
        let [left, right] = [[0.25, 1.0], [1.0, 2.5]]
            .map(|[a, b]| integrate(|x| height(x).sqrt(), a, b, 1e-15).value);
        let distance = metric.distance(&vector![2.5], &vector![0.25]).expect("between the knots");
        assert!((distance - left - right).abs() <= 1e-14, "{distance}");
        assert_eq!(metric.distance(&vector![-0.5], &vector![1.0]), None);
    }

    #[test]
    fn knots_out_of_order_and_heights_of_zero_are_refused() {
        assert!(Polygonal::new(&[[0.0, 1.0]]).is_none());
        assert!(Polygonal::new(&[[0.0, 1.0], [0.0, 2.0]]).is_none());
        assert!(Polygonal::new(&[[0.0, 1.0], [1.0, 0.0]]).is_none());
        assert!(Polygonal::new(&[[0.0, 1.0], [f64::NAN, 2.0]]).is_none());
    }
}
