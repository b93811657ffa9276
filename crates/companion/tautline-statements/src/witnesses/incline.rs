//! `Incline`: a metric on the line that grows linearly along `[0, 1]`.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, KnownDistance, Metric, Scalar};

/// The metric `H = c + s x` on `[0, 1]`, which is smooth. The left-endpoint rule evaluates it where
/// it differs most from its mean, so that it attains Propositions 8.1 and 8.2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Incline {
    foot: f64,
    slope: f64,
    constants: Constants,
}

impl Incline {
    /// Returns the incline with `H(0) = foot` and `H′ = slope`, in `m²/ℓ²` and `m²/ℓ³`; `None`
    /// unless it is positive on `[0, 1]`.
    #[must_use]
    pub fn new(foot: f64, slope: f64) -> Option<Self> {
        let top = foot + slope;
        let constants = Constants::new(foot.min(top), foot.max(top), slope.abs()).ok()?;
        Some(Self { foot, slope, constants })
    }
}

impl Metric<1> for Incline {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(x[0] * self.slope + self.foot)
    }
}

impl Bounded<1> for Incline {
    /// On `[0, 1]`, `H` lies between its end values, and `L_H = |slope|`.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<1> for Incline {
    /// The distance is `⅔ |x − y| (h² + hk + k²)/(h + k)` with `h = √H(x)` and `k = √H(y)`, on
    /// `[0, 1]`.
    fn distance(&self, x: &SVector<f64, 1>, y: &SVector<f64, 1>) -> Option<f64> {
        let known = [x[0], y[0]].iter().all(|s| (0.0..=1.0).contains(s));
        let [h, k] = [x[0], y[0]].map(|s| (self.foot + self.slope * s).sqrt());
        known.then(|| (x[0] - y[0]).abs() * (h * h + h * k + k * k) / (1.5 * (h + k)))
    }
}

#[cfg(test)]
mod tests {
    use tautline::KnownDistance;

    use super::Incline;

    /// `√(1 + 3x)` has the primitive `2/9 (1 + 3x)^{3/2} ≤ 2`, which has a few roundings.
    #[test]
    fn the_distance_is_the_integral_of_the_root() {
        let incline = Incline::new(1.0, 3.0).expect("positive");
        let distance = |x: f64, y: f64| incline.distance(&[x].into(), &[y].into());
        let primitive = |x: f64| 2.0 / 9.0 * (1.0 + 3.0 * x).powf(1.5);
        for (x, y) in [(0.0, 1.0), (1.0, 0.0), (0.25, 0.75)] {
            let expected = (primitive(y) - primitive(x)).abs();
            assert!(distance(x, y).is_some_and(|d| (d - expected).abs() <= 4e-15));
        }
        assert_eq!(distance(0.0, 1.5), None);
    }
}
