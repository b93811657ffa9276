//! Two short routes on the line, far apart; a discrete minimiser takes the wrong one.

use tautline::{Bounded, Ends, FiniteSet, KnownDistance};

use super::Polygonal;
use crate::Known;

/// The point where the second route begins.
const SECOND: f64 = 10.0;

/// Returns the problem from `{0, 10}` to `{a, 10 + b}`. The metric has the knots `first` on the
/// route `[0, a]`, and the knots `second`, relative to 10, on the route `[10, 10 + b]`.
///
/// A discrete minimiser takes the route on which the rule finds small values. If this is the longer
/// route, both gaps of Theorem 1.1 or 1.3 add up, and the bounds of order `1/N` are attained in the
/// limit `L_H d / c₁^{3/2} → 0`.
///
/// `None` unless the knots of each route start at 0, are in order and have positive heights, and
/// the way between the routes is longer than the shorter route.
#[must_use]
pub fn two_routes(first: &[[f64; 2]], second: &[[f64; 2]]) -> Option<Known<Polygonal, 1>> {
    let knots: Vec<[f64; 2]> =
        first.iter().copied().chain(second.iter().map(|&[s, h]| [SECOND + s, h])).collect();
    let (start, a) = (first.first()?[0], first.last()?[0]);
    let (second_start, b) = (second.first()?[0], second.last()?[0]);
    let metric = Polygonal::new(&knots)?;
    let length = |from: f64, to: f64| metric.distance(&[from].into(), &[to].into());
    let distance = length(0.0, a)?.min(length(SECOND, SECOND + b)?);
    let apart = length(a, SECOND)? > distance;
    let ends = Ends::new(
        FiniteSet::new([[0.0], [SECOND]]).ok()?,
        FiniteSet::new([[a], [SECOND + b]]).ok()?,
    )
    .ok()?;
    // As in `Known::between`, this is a difference of integrals from 0 on. The rounded corners
    // change it by less than 10⁻²².
    let size = metric.constants().c2().sqrt() * (SECOND + b);
    let distance_error = 16.0 * f64::EPSILON * size;
    (start == 0.0 && second_start == 0.0 && apart).then_some(Known {
        metric,
        ends,
        distance,
        distance_error,
    })
}

#[cfg(test)]
mod tests {
    use super::two_routes;

    /// The first route has the length `∫₀¹ √(1 + 3x) dx = 14/9`, and the second has the length 2.
    #[test]
    fn the_distance_is_the_length_of_the_shorter_route() {
        let [up, level] = [[[0.0, 1.0], [1.0, 4.0]], [[0.0, 4.0], [1.0, 4.0]]];
        for (first, second) in [(up, level), (level, up)] {
            let known = two_routes(&first, &second).expect("apart");
            let error = (known.distance - 14.0 / 9.0).abs();
            assert!(error <= known.distance_error, "{error:e}");
        }
    }

    #[test]
    fn routes_that_are_not_apart_or_do_not_begin_at_zero_are_refused() {
        let level = |h: f64| [[0.0, h], [1.0, h]];
        assert!(two_routes(&level(1.0), &level(1.0)).is_some());
        // The way from 9.9 to 10 is shorter than either route.
        assert!(two_routes(&[[0.0, 1.0], [9.9, 1.0]], &[[0.0, 1.0], [9.9, 1.0]]).is_none());
        assert!(two_routes(&[[0.1, 1.0], [1.0, 1.0]], &level(1.0)).is_none());
        assert!(two_routes(&level(1.0), &[[0.1, 1.0], [1.0, 1.0]]).is_none());
        assert!(two_routes(&level(0.0), &level(1.0)).is_none());
        assert!(two_routes(&[], &level(1.0)).is_none());
    }
}
