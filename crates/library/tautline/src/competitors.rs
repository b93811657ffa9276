//! `Competitors`: a ball that contains everything shorter than a computed line, and the constants
//! of the metric on that ball.

use std::num::NonZeroUsize;

use tautline_bounds::{
    BoundError, Constants, LocalityError, PaperRule, Region, Setting, competitors_within,
    reach_outward, shrink,
};
use tautline_formula::Prepare;
use tautline_metrics::{LocalError, LocallyBounded};
use tautline_scalar::{ANY, Interval, Scalar};
use tautline_sets::{AnyEnds, Ball};

use crate::{SVector, TautLine, certificate::Extent};

/// A ball that contains all competitors of a line, and the constants of the metric on that ball.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Competitors<const D: usize> {
    /// The constants of the metric on the ball.
    pub constants: Constants,
    /// The ball. No minimal geodesic leaves it. If the line has positive length, no sequence in the
    /// ball with as little discrete energy as the line reaches the boundary of the ball.
    pub within: Ball<D>,
    /// The balls by which this one was found, each with its constants. No competitor leaves the
    /// first one, and by the constants of each all competitors are in the next. Empty if the ball
    /// was found at once.
    pub outer: Vec<(Ball<D>, Constants)>,
}

impl<const D: usize> Competitors<D> {
    /// Checks that the ball contains all competitors of `line`, which may be another line than the
    /// one that the ball was computed for.
    pub(crate) fn hold_those_of<M: Prepare<E>, const E: usize>(
        &self,
        line: &TautLine<M, E>,
        extent: Extent,
    ) -> Result<(), BoundError> {
        let rule = line.rule().paper_rule()?;
        let (bounded, upper) = (BoundedEnds::of(line.any_ends()), upper(extent));
        let length = |constants| {
            let setting = Setting::new(constants, upper, line.any_ends().dimension())?;
            Ok(reach_outward(setting, rule, line.sequence().n()))
        };
        let refused =
            |reach, ball: &Ball<D>| Err(BoundError::LeavesTheBall { reach, radius: ball.r() });
        let own = (self.within.clone(), self.constants);
        let (first, constants) = self.outer.first().unwrap_or(&own);
        let reach = bounded.left_by(length(*constants)?, first.centre_slice());
        if !(reach < first.r() || (upper == 0.0 && reach <= first.r())) {
            return refused(reach, first);
        }
        let mut longest = length(*constants)?;
        for (ball, constants) in self.outer.iter().chain([&own]).skip(1) {
            let reach = bounded.filled_by(longest, ball.centre_slice());
            if !(reach <= ball.r()) {
                return refused(reach, ball);
            }
            longest = length(*constants)?;
        }
        // The minimisers must not touch the boundary.
        let reach = bounded.filled_by(longest, self.within.centre_slice());
        if self.outer.is_empty() || reach < self.within.r() {
            Ok(())
        } else {
            refused(reach, &self.within)
        }
    }
}

impl Competitors<ANY> {
    /// Returns the same in `R^D`.
    pub(crate) fn into_dimension<const D: usize>(self) -> Competitors<D> {
        let ball = |ball: &Ball<ANY>| {
            Ball::from_slice(ball.centre_slice(), ball.r()).expect("the dimension of the ball")
        };
        Competitors {
            constants: self.constants,
            within: ball(&self.within),
            outer: self.outer.iter().map(|(outer, constants)| (ball(outer), *constants)).collect(),
        }
    }
}

/// The balls around the bounded ends of a problem: centres and radii, in `ℓ`.
struct BoundedEnds(Vec<(Vec<f64>, f64)>);

impl BoundedEnds {
    fn of(ends: &AnyEnds) -> Self {
        let sets = [ends.first(), ends.second()];
        Self(sets.into_iter().filter_map(|set| set.enclosing_ball()).collect())
    }

    /// Returns the middle of the two centres and the sum of the two radii if both ends are bounded.
    fn middle(&self) -> Option<(Vec<Interval>, Interval)> {
        let [(first, r), (second, s)] = &self.0[..] else { return None };
        let both = first.iter().zip(second);
        let middle = both.map(|(&x, &y)| (Interval::point(x) + y) * 0.5).collect();
        Some((middle, Interval::point(*r) + *s))
    }

    /// Returns the least radius of a ball about `centre` that no curve of a Euclidean length from
    /// set to set leaves, if only the length of its parts in the ball is known. It is rounded up, and
    /// infinite if a number overflows.
    ///
    /// A curve that leaves the ball has a part from an end to the boundary, and another one to the
    /// other end.
    fn left_by(&self, length: f64, centre: &[f64]) -> f64 {
        let length = interval(length);
        let from = |at: &[f64]| {
            distance(&at.iter().map(|&x| Interval::point(x)).collect::<Vec<_>>(), centre)
        };
        let away: Vec<Interval> = self.0.iter().map(|(at, r)| from(at) + *r).collect();
        let one = away.iter().map(|&away| above(away + length)).fold(f64::INFINITY, f64::min);
        let [first, second] = away[..] else { return one };
        one.min(above((first + second + length) * 0.5))
    }

    /// Returns the least radius of a ball about `centre` that contains every curve of a Euclidean
    /// length from set to set, rounded up.
    ///
    /// For each point `z` of a curve from `x` to `y`,
    /// `2 |z − ½(x + y)| ≤ |z − x| + |z − y| ≤ length`.
    fn filled_by(&self, length: f64, centre: &[f64]) -> f64 {
        let left = self.left_by(length, centre);
        let about_the_middle = |(middle, radii): (Vec<Interval>, Interval)| {
            above(distance(&middle, centre) + (radii + interval(length)) * 0.5)
        };
        self.middle().map_or(left, |middle| left.min(about_the_middle(middle)))
    }
}

/// Returns the interval of a length, which may be infinite.
fn interval(length: f64) -> Interval {
    Interval::new(length, length).unwrap_or(Interval::REALS)
}

/// Returns the upper end, or `∞` without one.
fn above(radius: Interval) -> f64 {
    if radius.is_undefined() { f64::INFINITY } else { radius.hi() }
}

/// Encloses the Euclidean distance of two points.
fn distance(x: &[Interval], y: &[f64]) -> Interval {
    let squares = x.iter().zip(y).map(|(&x, &y)| (x - y).sqr());
    squares.fold(Interval::constant(0.0), |sum, square| sum + square).sqrt()
}

/// Returns an upper bound on both the distance and the square root of the discrete energy, in `m`.
/// The energy counts because a sequence with the energy of the line has to stay inside the ball,
/// too. The result is NaN if either number is NaN.
fn upper(Extent { length, discrete_energy, .. }: Extent) -> f64 {
    let root = if discrete_energy == 0.0 { 0.0 } else { discrete_energy.sqrt().next_up() };
    if root.is_nan() || root > length { root } else { length }
}

impl<M: LocallyBounded<D>, const D: usize> TautLine<M, D> {
    /// Returns a ball that contains all competitors of this line, with the constants on that ball
    /// (Proposition S.8), for use with [`enclosure_among`](TautLine::enclosure_among).
    ///
    /// If both ends are bounded, the ball is usually centred in the middle between them, and has
    /// half the radius of one that is centred at an end. The ball also contains this line.
    ///
    /// ```
    /// use tautline::{Ends, Problem, Rule, gallery::Sphere};
    ///
    /// let ends = Ends::points([0.3, 0.1], [0.45, 0.2])?;
    /// let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 128)?;
    /// let competitors = line.competitors()?;
    /// assert!(competitors.within.r() < 0.11);
    /// let enclosure = line.enclosure_among(&competitors)?;
    /// assert!(enclosure.width() < 1e-3 * enclosure.upper);
    /// assert!(!enclosure.assumes_global_minimum);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// Needs: the metric satisfies its constants. The length is known up to an estimated quadrature
    /// error.
    ///
    /// Overestimation: between points the radius exceeds `½ d̄ √e/√c₁` by at most a few percent,
    /// which is half the Euclidean length that a competitor may have. Here `d̄` is the length of
    /// this line, `e` is that of Lemma S.4, and `c₁` is a constant of the ball.
    ///
    /// # Errors
    ///
    /// [`LocalityError`] if the metric has no constants there; if `√c₁` falls so fast that no ball
    /// contains the competitors, since the ends are too far apart; if the length is not finite; or if
    /// the rule is not one of the paper.
    pub fn competitors(&self) -> Result<Competitors<D>, LocalityError<LocalError>> {
        self.competitors_by(self.extent())
    }

    /// Does the same as [`competitors`](TautLine::competitors), given bounds on the curve.
    pub(crate) fn competitors_by(
        &self,
        extent: Extent,
    ) -> Result<Competitors<D>, LocalityError<LocalError>> {
        let constants_within = &|centre: &[f64], radius: f64| {
            self.metric().constants_within(&SVector::from_column_slice(centre), radius)
        };
        let rule = self.rule().paper_rule().map_err(LocalityError::Bound)?;
        let (ends, n) = (self.any_ends(), self.sequence().n());
        Ok(Search { rule, n, extent, constants_within }.about_ends(ends)?.into_dimension())
    }
}

/// Returns the constants of the metric on the ball about a centre, both in `ℓ`.
type Within<'c> = &'c dyn Fn(&[f64], f64) -> Result<Constants, LocalError>;

/// A search for a ball that contains all competitors of a line.
pub(crate) struct Search<'c> {
    pub(crate) rule: PaperRule,
    pub(crate) n: NonZeroUsize,
    pub(crate) extent: Extent,
    pub(crate) constants_within: Within<'c>,
}

impl Search<'_> {
    /// Returns the smallest ball that was found about an end or the middle of the ends.
    pub(crate) fn about_ends(
        &self,
        ends: &AnyEnds,
    ) -> Result<Competitors<ANY>, LocalityError<LocalError>> {
        let bounded = BoundedEnds::of(ends);
        let mut least: Option<Competitors<ANY>> = None;
        // The error if neither end has an enclosing ball: no radius bounds the competitors.
        let mut refused = LocalityError::Escapes { radius: f64::INFINITY, reach: f64::INFINITY };
        if let Some((middle, _)) = bounded.middle() {
            least = self.about(&bounded, &midpoint(&middle), 0.0).ok();
        }
        // A ball about an end is smaller if the other end is much larger, and it may exist if there
        // is none about the middle.
        let sizes: Vec<f64> = bounded.0.iter().map(|(_, r)| *r).collect();
        if least.is_none() || sizes[0] != sizes[1] {
            for (centre, r) in &bounded.0 {
                match self.about(&bounded, centre, *r) {
                    Ok(found) if least.as_ref().is_none_or(|x| found.within.r() < x.within.r()) => {
                        least = Some(found);
                    }
                    Ok(_) => {}
                    Err(error) => refused = error,
                }
            }
        }
        least.ok_or(refused)
    }

    /// Finds a ball about `centre` that no competitor leaves, and smaller balls in it. The radius of
    /// the first is at least `r`; radii of errors are beyond it.
    fn about(
        &self,
        bounded: &BoundedEnds,
        centre: &[f64],
        r: f64,
    ) -> Result<Competitors<ANY>, LocalityError<LocalError>> {
        let (rule, n, upper, d) = (self.rule, self.n, upper(self.extent), centre.len());
        let within = |centre: &[f64], radius: f64| {
            LocalError::check_ball(centre, radius)?;
            (self.constants_within)(centre, radius)
        };
        let beyond = |length| bounded.left_by(length, centre) - r;
        let at = |radius: f64| within(centre, r + radius);
        let Region { radius, constants } = competitors_within(d, rule, n, upper, beyond, at)?;
        // Rounding must not put an end outside of its own ball.
        let total = (r + radius).max(bounded.left_by(0.0, centre));
        let outside = LocalityError::Escapes { radius, reach: f64::INFINITY };
        let first = Ball::from_slice(centre, total).map_err(|_| outside)?;
        let mut found = Competitors { constants, within: first, outer: Vec::new() };
        let Some((middle, _)) = bounded.middle().filter(|_| upper > 0.0) else { return Ok(found) };
        let middle = midpoint(&middle);
        let filled = |length| bounded.filled_by(length, &middle);
        let outer = Region { radius: total, constants };
        for Region { radius, constants } in
            shrink(d, rule, n, upper, outer, filled, |radius| within(&middle, radius))
        {
            let Ok(ball) = Ball::from_slice(&middle, radius) else { break };
            found.outer.push((found.within, found.constants));
            (found.within, found.constants) = (ball, constants);
        }
        Ok(found)
    }
}

fn midpoint(x: &[Interval]) -> Vec<f64> {
    x.iter().map(|x| x.midpoint()).collect()
}

#[cfg(test)]
mod tests;
