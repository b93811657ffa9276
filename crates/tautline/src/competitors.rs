//! `Competitors`: a ball that contains everything shorter than a computed line, and the constants
//! of the metric on that ball.

use tautline_bounds::{BoundError, Constants, LocalityError, Region, Setting, competitors, reach};
use tautline_discretizations::Rule;
use tautline_metrics::{LocalError, LocallyBounded, Metric};
use tautline_sets::Ball;

use crate::{RuleOfThePaper, TautLine, certificate::Extent};

/// A ball that contains all competitors of a line, and the constants of the metric on that ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Competitors<const D: usize> {
    /// The constants of the metric on the ball.
    pub constants: Constants,
    /// The ball. No minimal geodesic leaves it. If the line has positive length, no sequence in the
    /// ball with as little discrete energy as the line reaches the boundary of the ball.
    pub within: Ball<D>,
}

impl<const D: usize> Competitors<D> {
    /// Checks that the ball contains all competitors of `line`, which may be another line than the
    /// one that the ball was computed for.
    pub(crate) fn hold_those_of<M: Metric<D>, R: RuleOfThePaper>(
        &self,
        line: &TautLine<M, R, D>,
        extent: Extent,
    ) -> Result<(), BoundError> {
        let (radius, upper) = (self.within.r(), upper(line, extent));
        let setting = Setting::new(self.constants, upper, D)?;
        let reach = reach(setting, R::OF_THE_PAPER, line.sequence().n());
        // For each set, the largest distance between the centre of the ball and a competitor that
        // begins in that set. The smaller of the two counts.
        let sets = [line.ends().first(), line.ends().second()];
        let balls = sets.into_iter().filter_map(|set| set.enclosing_ball());
        let away = balls.map(|(centre, r)| (centre - self.within.centre()).norm() + r + reach);
        let reach = away.fold(f64::INFINITY, f64::min);
        let holds = reach < radius || (upper == 0.0 && reach <= radius);
        if holds { Ok(()) } else { Err(BoundError::LeavesTheBall { reach, radius }) }
    }
}

/// Returns an upper bound on both the distance and the square root of the discrete energy, in `m`.
/// The energy counts because a sequence with the energy of the line has to stay inside the ball,
/// too. The result is NaN if either number is NaN.
fn upper<M: Metric<D>, R: Rule, const D: usize>(
    line: &TautLine<M, R, D>,
    Extent { length, .. }: Extent,
) -> f64 {
    let root = line.discrete_energy().sqrt();
    if root.is_nan() || root > length { root } else { length }
}

impl<M: LocallyBounded<D>, R: RuleOfThePaper, const D: usize> TautLine<M, R, D> {
    /// Returns a ball that contains all competitors of this line, with the constants on that ball
    /// (Proposition S.8), for use with [`enclosure_among`](TautLine::enclosure_among).
    ///
    /// The ball is centred at a bounded end; if both ends are bounded, at the one that gives the
    /// smaller ball. The ball also contains this line.
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
    /// Needs: the metric satisfies its constants. The length is known up to an estimated quadrature
    /// error.
    ///
    /// Overestimation: the radius exceeds the largest distance of a competitor from its end,
    /// `√(d̄² e/c₁)`, by at most one percent. Here `d̄` is the length of this line, `e` is that of
    /// Lemma S.4, and `c₁` is a constant of the ball.
    ///
    /// # Errors
    ///
    /// [`LocalityError`] if the metric has no constants there; if `√c₁` falls so fast that no ball
    /// contains the competitors, since the ends are too far apart; or if the length is not finite.
    pub fn competitors(&self) -> Result<Competitors<D>, LocalityError<LocalError>> {
        self.competitors_by(self.extent())
    }

    /// Does the same as [`competitors`](TautLine::competitors), given bounds on the curve.
    pub(crate) fn competitors_by(
        &self,
        extent: Extent,
    ) -> Result<Competitors<D>, LocalityError<LocalError>> {
        let upper = upper(self, extent);
        let sets = [self.ends().first(), self.ends().second()];
        let mut least: Option<Competitors<D>> = None;
        // The error if neither end has an enclosing ball: no radius bounds the competitors.
        let mut refused = LocalityError::Escapes { radius: f64::INFINITY, reach: f64::INFINITY };
        for (centre, r) in sets.into_iter().filter_map(|set| set.enclosing_ball()) {
            let within = |radius: f64| {
                LocalError::check_ball(&centre, r)?;
                self.metric().constants_within(&centre, r + radius)
            };
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
    use tautline_bounds::{BoundError, LocalityError};
    use tautline_discretizations::PointSequence;
    use tautline_metrics::gallery::{GaussianFisher, Hyperbolic, Sphere};
    use tautline_metrics::{KnownDistance, LocalError, LocallyBounded};
    use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace};

    use super::Competitors;
    use crate::{LeftEndpoint, Options, Problem, SVector, Starts, TautLine, Trapezoidal};

    fn line<M: LocallyBounded<2>>(
        metric: M,
        a: [f64; 2],
        b: [f64; 2],
        n: usize,
    ) -> TautLine<M, Trapezoidal, 2> {
        let ends = Ends::points(a, b).expect("finite");
        Problem::new(metric, ends).solve(Trapezoidal, n).expect("solved")
    }

    /// The radius exceeds `L/√c₁`, where `c₁` is that of the ball, by one or two percent.
    #[test]
    fn the_ball_is_as_large_as_a_competitor_may_reach() {
        let line = line(Sphere, [0.3, 0.1], [0.5, 0.2], 64);
        let Competitors { constants, within } = line.competitors().expect("near");
        let ball = within;
        assert_eq!(*ball.centre(), SVector::from([0.3, 0.1]));
        let reach = line.length().value / constants.c1().sqrt();
        assert!(reach < ball.r() && ball.r() < 1.03 * reach, "{ball:?} for {reach}");
        assert_eq!(Ok(constants), Sphere.constants_within(ball.centre(), ball.r()));
        assert!(line.sequence().points().iter().all(|x| ball.project(x) == *x));
    }

    /// The distance between nearby points is enclosed under the single assumption that sequences
    /// stay in the ball.
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

    /// If both ends are bounded, the ball is centred at the smaller one.
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

    /// If the ball is centred at a set, its radius includes the radius of the set.
    #[test]
    fn the_ball_contains_the_bounded_end() {
        let disc = |x: f64| Ball::new([x, 0.2], 0.02).expect("finite");
        let ends = Ends::new(disc(0.3), disc(0.36)).expect("bounded");
        let line = Problem::new(Sphere, ends).solve(Trapezoidal, 16).expect("solved");
        let Competitors { constants, within } = line.competitors().expect("near");
        assert_eq!(Ok(constants), Sphere.constants_within(within.centre(), within.r()));
        let reach = line.length().value / constants.c1().sqrt();
        assert!(0.02 + reach < within.r() && within.r() < 0.02 + 1.03 * reach, "{within:?}");
    }

    /// The discrete energy of one chord may be `1 + δ/2` times `d²` for the left rule; for the
    /// trapezoidal rule the excess is half as large. A line that is not minimal has more energy
    /// than its squared length.
    #[test]
    fn the_energy_allowed_to_a_sequence_counts() {
        let ends = || Ends::points([0.3, 0.0], [0.32, 0.0]).expect("finite");
        let left = Problem::new(Hyperbolic, ends()).solve(LeftEndpoint, 1).expect("solved");
        let Competitors { constants, within } = left.competitors().expect("near");
        let length = left.length().value;
        let delta = constants.l_h() * length / constants.c1().powf(1.5);
        let most = constants.c2() / constants.c1();
        let reach = length * (1.0 + 0.5 * delta).min(most).sqrt() / constants.c1().sqrt();
        assert!(reach < within.r() && within.r() < 1.02 * reach, "{within:?} for {reach}");
        let points = [0.3, 0.3005, 0.32].map(|x| [x, 0.0].into()).to_vec();
        let uneven = PointSequence::new(points).expect("finite");
        let options =
            Options { starts: Starts::Only(vec![uneven]), iterations: 0, ..Options::default() };
        let problem = Problem::new(Hyperbolic, ends());
        let uneven = problem.solve_with(Trapezoidal, 2, &options).expect("finite");
        let energy = uneven.discrete_energy();
        assert!(energy > 1.5 * uneven.length().value.powi(2), "{energy}");
        let Competitors { constants, within } = uneven.competitors().expect("near");
        assert!(within.r() > (energy / constants.c1()).sqrt(), "{within:?}");
    }

    /// The ball of another line is refused, and so is one that is too small.
    #[test]
    fn competitors_of_another_line_are_refused() {
        let near = line(Hyperbolic, [0.0, 0.0], [0.001, 0.0], 64).competitors().expect("near");
        let far = line(Hyperbolic, [0.5, 0.0], [0.4, 0.02], 4);
        let error = far.enclosure_among(&near).expect_err("another line");
        assert!(matches!(error, BoundError::LeavesTheBall { .. }), "{error}");
        assert_eq!(far.suggest_n_among(&near, 1e-3), Err(error));
        let own = far.competitors().expect("near");
        assert!(far.enclosure_among(&own).is_ok());
        let smaller = Ball::new(*own.within.centre(), 0.9 * own.within.r()).expect("finite");
        let smaller = Competitors { within: smaller, ..own };
        assert!(far.enclosure_among(&smaller).is_err());
        // A line without length has a ball of radius zero.
        let still = line(Hyperbolic, [0.5, 0.0], [0.5, 0.0], 4);
        let own = still.competitors().expect("one point");
        assert_eq!(still.enclosure_among(&own).expect("finite").width(), 0.0);
    }

    /// A small error in the centre, in the radius or in the size of the end is refused.
    #[test]
    fn a_ball_that_is_a_little_off_is_refused() {
        let ball = Ball::new([0.3, 0.2], 0.05).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.0], 0.45).expect("a normal");
        for ends in [Ends::new(ball, wall), Ends::new(wall, ball)] {
            let ends = ends.expect("one bounded");
            let line = Problem::new(Sphere, ends).solve(Trapezoidal, 32).expect("solved");
            let own = line.competitors().expect("near");
            assert!(line.enclosure_among(&own).is_ok());
            let with = |away: f64, larger: f64| {
                let centre = own.within.centre() + SVector::from([0.0, away]);
                let within = Ball::new(centre, own.within.r() + larger).expect("a radius");
                line.enclosure_among(&Competitors { within, ..own })
            };
            // Apart from the radius of the end, the radius of the ball is within one percent of the
            // smallest.
            let margin = 0.015 * (own.within.r() - 0.05);
            for refused in [with(0.0, -margin), with(0.0, -0.05), with(margin, 0.0), with(1.0, 0.0)]
            {
                let error = refused.expect_err("a competitor may be outside");
                assert!(matches!(error, BoundError::LeavesTheBall { .. }), "{error}");
            }
            assert!(with(0.5, 0.5 + margin).is_ok());
        }
    }

    #[test]
    fn ends_that_are_too_far_apart_are_refused() {
        let far = line(Sphere, [-0.5, 0.0], [0.5, 0.0], 64);
        let error = far.competitors().expect_err("√c₁ R ≤ 1");
        assert!(matches!(error, LocalityError::Escapes { .. }), "{error}");
        let far = line(Hyperbolic, [-0.6, 0.0], [0.6, 0.0], 64);
        let error = far.competitors().expect_err("the ball ends");
        let named = matches!(
            error,
            LocalityError::NoConstants {
                reason: LocalError::LeavesTheDomain { limit: 1.0, .. },
                ..
            }
        );
        assert!(named, "{error}");
    }
}
