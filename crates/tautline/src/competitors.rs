//! Where all that could be shorter than a computed line is, and the constants of the metric there.

use tautline_bounds::{BoundError, Constants, LocalityError, Region, competitors};
use tautline_metrics::{LocalError, LocallyBounded};
use tautline_sets::Ball;

use crate::{RuleOfThePaper, TautLine};

/// A ball that holds all competitors of a line, and the constants of the metric there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Competitors<const D: usize> {
    /// The constants of the metric in the ball.
    pub constants: Constants,
    /// The ball: no minimal geodesic leaves it, and no sequence of points of the ball that has as
    /// little discrete energy as the line comes near its boundary.
    pub within: Ball<D>,
}

impl<M: LocallyBounded<D>, R: RuleOfThePaper, const D: usize> TautLine<M, R, D> {
    /// Returns a ball that holds all competitors of this line, with the constants there
    /// (Proposition S.8), for [`enclosure_among`](TautLine::enclosure_among).
    ///
    /// The ball is about a bounded end, the one for which it is the smaller if both are bounded. It
    /// holds this line too.
    ///
    /// ```
    /// use tautline::{Ends, Problem, Trapezoidal, gallery::Sphere};
    ///
    /// let ends = Ends::points([0.3, 0.1], [0.45, 0.2])?;
    /// let line = Problem::new(Sphere, ends).solve(Trapezoidal, 128)?;
    /// let competitors = line.competitors()?;
    /// assert!(competitors.within.r() < 0.25);
    /// let enclosure = line.enclosure_among(&competitors)?;
    /// assert!(enclosure.width() < 1e-3 * enclosure.upper);
    /// assert!(!enclosure.assumes_global_minimum);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Needs: that the metric is what its constants say. Slack: a curve as long as this line comes
    /// no farther than its length over `√c₁` from its end; the constant `c₁` of the ball is taken, and
    /// its radius to one percent.
    ///
    /// # Errors
    ///
    /// [`LocalityError`] if the metric has no constants there, or `√c₁` falls so fast that no ball
    /// holds the competitors: the ends are too far apart.
    pub fn competitors(&self) -> Result<Competitors<D>, LocalityError<LocalError>> {
        let length = self.length();
        // A sequence with the discrete energy of this one has to stay inside, too.
        let upper = (length.value + length.error).max(self.discrete_energy().sqrt());
        let sets = [self.ends().first(), self.ends().second()];
        let mut least: Option<Competitors<D>> = None;
        let mut refused = LocalityError::Bound(BoundError::NotADistance { distance: upper });
        for (centre, r) in sets.into_iter().filter_map(|set| set.enclosing_ball()) {
            let within = |radius: f64| self.metric().constants_within(&centre, r + radius);
            match competitors(D, R::OF_THE_PAPER, self.sequence().n(), upper, within) {
                Ok(Region { radius, constants }) => {
                    let Ok(within) = Ball::new(centre, r + radius) else { continue };
                    if least.is_none_or(|least| within.r() < least.within.r()) {
                        least = Some(Competitors { constants, within });
                    }
                }
                Err(error) => refused = error,
            }
        }
        least.ok_or(refused)
    }
}

#[cfg(test)]
mod tests {
    use tautline_bounds::LocalityError;
    use tautline_metrics::gallery::{GaussianFisher, Hyperbolic, Sphere};
    use tautline_metrics::{KnownDistance, LocalError, LocallyBounded};
    use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace};

    use super::Competitors;
    use crate::{LeftEndpoint, Problem, SVector, TautLine, Trapezoidal};

    fn line<M: LocallyBounded<2>>(
        metric: M,
        a: [f64; 2],
        b: [f64; 2],
        n: usize,
    ) -> TautLine<M, Trapezoidal, 2> {
        let ends = Ends::points(a, b).expect("finite");
        Problem::new(metric, ends).solve(Trapezoidal, n).expect("solved")
    }

    /// The ball reaches from an end to a percent or two beyond `L/√c₁` with its own `c₁`, and the
    /// constants are those of the ball.
    #[test]
    fn the_ball_is_as_large_as_a_competitor_may_go() {
        let line = line(Sphere, [0.3, 0.1], [0.5, 0.2], 64);
        let Competitors { constants, within } = line.competitors().expect("near");
        let ball = within;
        assert_eq!(*ball.centre(), SVector::from([0.3, 0.1]));
        let reach = line.length().value / constants.c1().sqrt();
        assert!(reach < ball.r() && ball.r() < 1.03 * reach, "{ball:?} for {reach}");
        assert_eq!(Ok(constants), Sphere.constants_within(ball.centre(), ball.r()));
        assert!(line.sequence().points().iter().all(|x| ball.project(x) == *x));
    }

    /// Each metric between near points: the distance is enclosed, without an assumption but that
    /// sequences stay in the ball.
    #[test]
    fn distances_under_metrics_without_global_constants_are_enclosed() {
        fn check<M>(metric: M, a: [f64; 2], b: [f64; 2])
        where
            M: LocallyBounded<2> + KnownDistance<2> + Copy,
        {
            let d2 = metric.distance(&a.into(), &b.into()).expect("known").powi(2);
            let line = line(metric, a, b, 128);
            let competitors = line.competitors().expect("near");
            let enclosure = line.enclosure_among(&competitors).expect("finite");
            assert!(enclosure.lower <= d2 && d2 <= enclosure.upper * (1.0 + 1e-14));
            assert!(enclosure.is_local && !enclosure.assumes_global_minimum, "{enclosure:?}");
            assert!(enclosure.width() < 1e-3 * d2, "{enclosure:?}");
            let suggested = |tolerance| line.suggest_n_among(&competitors, tolerance);
            let [coarse, fine] =
                [1.0, 1e-6].map(|part| suggested(part * d2).expect("finite").proven);
            assert_eq!(coarse.map(|(n, _)| n.get()), Some(128));
            assert!(fine.is_some_and(|(n, _)| n.get() > 128), "{fine:?}");
        }
        check(Sphere, [0.3, 0.1], [0.45, 0.2]);
        check(Hyperbolic, [0.3, 0.1], [0.4, 0.15]);
        check(GaussianFisher, [0.0, 0.0], [0.1, 0.05]);
    }

    /// The ball is about the bounded end, and about the smaller one if both are.
    #[test]
    fn the_ball_is_about_a_bounded_end() {
        let disc = |x: f64, r: f64| Ball::new([x, 0.2], r).expect("finite");
        let wall = HalfSpace::at_least([1.0, 0.0], 0.5).expect("a normal");
        let ends = Ends::new(wall, disc(0.3, 0.05)).expect("bounded");
        let line = Problem::new(Sphere, ends).solve(LeftEndpoint, 16).expect("solved");
        let ball = line.competitors().expect("near").within;
        assert_eq!(*ball.centre(), SVector::from([0.3, 0.2]));
        assert!(ball.r() > 0.2);
        let competitors = line.competitors().expect("near");
        let enclosure = line.enclosure_among(&competitors).expect("finite");
        assert!(enclosure.is_local && enclosure.assumes_global_minimum);
        for (first, second) in [(0.01, 0.1), (0.1, 0.01)] {
            let ends = Ends::new(disc(0.3, first), disc(0.6, second)).expect("bounded");
            let line = Problem::new(Sphere, ends).solve(Trapezoidal, 16).expect("solved");
            let ball = line.competitors().expect("near").within;
            assert_eq!(ball.centre()[0], if first < second { 0.3 } else { 0.6 });
        }
    }

    #[test]
    fn ends_that_are_too_far_apart_are_refused() {
        let far = line(Sphere, [-0.5, 0.0], [0.5, 0.0], 64);
        let error = far.competitors().expect_err("√c₁ R ≤ 1");
        assert!(matches!(error, LocalityError::Escapes { .. }), "{error}");
        let far = line(Hyperbolic, [-0.6, 0.0], [0.6, 0.0], 64);
        let error = far.competitors().expect_err("the ball ends");
        let left = |reason| matches!(reason, LocalError::LeavesTheDomain { limit: 1.0, .. });
        let named =
            |error| matches!(error, LocalityError::NoConstants { reason, .. } if left(reason));
        assert!(named(error), "{error}");
    }
}
