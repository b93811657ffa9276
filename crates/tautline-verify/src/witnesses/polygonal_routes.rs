//! `PolygonalRoutes`: a metric on the line that lets a rule take the longer one of two ways.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Ends, FiniteSet, Metric, Scalar};

use crate::Known;

/// Where `H` bends: the ends and the middles of the two routes.
const BENDS: [f64; 6] = [0.0, 0.5, 1.0, 10.0, 10.5, 11.0];

/// The square of the distance of the routes, `10 − 1`.
const APART_SQUARED: f64 = 81.0;

/// Corners are `√(x² + ε²)`: a smooth metric with the same `L_H`, whose values differ by less than
/// `ε L_H` from those of the polygon.
const ROUNDED: f64 = 1e-12;

/// `H` on the line with the routes `[0, 1]` and `[10, 11]` from `X⁽⁰⁾ = {0, 10}` to
/// `X⁽¹⁾ = {1, 11}`: linear on each half of a route and between the routes, constant outside.
///
/// A discrete minimiser takes the route on which the rule reads little. Where that is the longer
/// one, both gaps of Theorem 1.1 or 1.3 add up: the bounds of order `1/N` are attained in the
/// limit `L_H d / c₁^{3/2} → 0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonalRoutes {
    heights: [f64; 6],
    /// Half of how much the slope changes at each bend.
    turns: [f64; 6],
    constants: Constants,
}

impl PolygonalRoutes {
    /// Returns the metric with the given values of `H` at the beginning, in the middle and at the
    /// end of each route, in `m²/ℓ²`.
    ///
    /// `None` unless they are positive and so close, `c₂ < 81 c₁`, that no way from one route to
    /// the other is minimal.
    #[must_use]
    pub fn new(first: [f64; 3], second: [f64; 3]) -> Option<Self> {
        let [a, b] = [first, second];
        let heights = [a[0], a[1], a[2], b[0], b[1], b[2]];
        let mut slopes = [0.0; 7];
        for k in 1..6 {
            slopes[k] = (heights[k] - heights[k - 1]) / (BENDS[k] - BENDS[k - 1]);
        }
        let turns: [f64; 6] = std::array::from_fn(|k| 0.5 * (slopes[k + 1] - slopes[k]));
        let l_h = slopes.iter().fold(0.0_f64, |most, slope| most.max(slope.abs()));
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let high = heights.iter().copied().fold(0.0, f64::max);
        // Rounding of a sum of twelve terms up to 11 L_H, and the rounded corners.
        let margin = 1e-13 * (high + 11.0 * l_h) + 6.0 * ROUNDED * l_h;
        let constants = Constants::new(low - margin, high + margin, l_h).ok()?;
        (constants.c2() < APART_SQUARED * constants.c1()).then_some(Self {
            heights,
            turns,
            constants,
        })
    }

    /// Returns the problem from `{0, 10}` to `{1, 11}`.
    ///
    /// The length of a piece with the roots `a` and `b` of `H` at its ends, `ℓ/2` long, is
    /// `(a² + ab + b²) / 3(a + b)`.
    #[must_use]
    pub fn problem(self) -> Known<Self, 1> {
        let root = self.heights.map(f64::sqrt);
        let piece = |a: f64, b: f64| (a * a + a * b + b * b) / (3.0 * (a + b));
        let route = |k: usize| piece(root[k], root[k + 1]) + piece(root[k + 1], root[k + 2]);
        let set = |points: [f64; 2]| {
            FiniteSet::new(points.map(|x| SVector::from([x])).to_vec()).expect("two points")
        };
        let (from, to) = (set([0.0, 10.0]), set([1.0, 11.0]));
        Known {
            metric: self,
            ends: Ends::new(from, to).expect("finite sets are bounded"),
            distance: route(0).min(route(3)),
            // The margin of `new`, as far as ∂√H = ∂H / 2√H passes it on.
            distance_error: (1e-13 * (self.constants.c2() + 11.0 * self.constants.l_h())
                + 6.0 * ROUNDED * self.constants.l_h())
                / self.constants.c1().sqrt(),
        }
    }
}

impl Metric<1> for PolygonalRoutes {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        // Straight to both sides of all bends, since the turns add up to zero.
        let corner = |k: usize| {
            let from = (x[0] - BENDS[k]).sqr() + ROUNDED * ROUNDED;
            (from.sqrt() - (BENDS[k] - BENDS[0])) * self.turns[k]
        };
        let height = (1..6).fold(corner(0), |sum, k| sum + corner(k)) + self.heights[0];
        SMatrix::from_diagonal_element(height)
    }
}

impl Bounded<1> for PolygonalRoutes {
    /// Those of the polygon, with a margin for its rounded corners.
    fn constants(&self) -> Constants {
        self.constants
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline::Metric;

    use super::PolygonalRoutes;

    #[test]
    fn the_metric_has_its_heights_and_nothing_between_crosses() {
        let metric = PolygonalRoutes::new([1.0, 1.5, 1.25], [2.0, 1.0, 3.0]).expect("positive");
        for (x, height) in [
            (-3.0, 1.0),
            (0.0, 1.0),
            (0.25, 1.25),
            (0.5, 1.5),
            (1.0, 1.25),
            (5.5, 1.625),
            (10.0, 2.0),
            (10.5, 1.0),
            (10.75, 2.0),
            (11.0, 3.0),
            (20.0, 3.0),
        ] {
            let found = metric.gram(&SVector::from([x]))[0];
            // The corners, and the rounding of twelve terms up to 40.
            assert!((found - height).abs() <= 1e-11, "H({x}) = {found}");
        }
        assert!(PolygonalRoutes::new([1.0; 3], [81.0; 3]).is_none());
        assert!(PolygonalRoutes::new([1.0; 3], [1.0, 0.0, 1.0]).is_none());
    }

    /// `∫₀¹ √(1 + 3x) dx = 14/9` on the first route, and 2 on the second.
    #[test]
    fn the_distance_is_that_of_the_shorter_route() {
        let metric = PolygonalRoutes::new([1.0, 2.5, 4.0], [4.0; 3]).expect("positive");
        assert!((metric.problem().distance - 14.0 / 9.0).abs() <= 1e-15);
    }
}
