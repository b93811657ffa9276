//! `Competitors`: a ball that contains everything shorter than a computed line, and the constants
//! of the metric on that ball.

use tautline_bounds::{
    BoundError, Constants, LocalityError, PaperRule, Region, Setting, competitors_within,
    reach_outward, shrink,
};
use tautline_metrics::{LocalError, LocallyBounded, Metric};
use tautline_scalar::{Interval, Scalar};
use tautline_sets::{Ball, Ends};

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
    pub(crate) fn hold_those_of<M: Metric<D>>(
        &self,
        line: &TautLine<M, D>,
        extent: Extent,
    ) -> Result<(), BoundError> {
        let rule = line.rule().paper_rule()?;
        let (bounded, upper) = (BoundedEnds::of(line.ends()), upper(extent));
        let length = |constants| {
            let setting = Setting::new(constants, upper, D)?;
            Ok(reach_outward(setting, rule, line.sequence().n()))
        };
        let refused =
            |reach, ball: &Ball<D>| Err(BoundError::LeavesTheBall { reach, radius: ball.r() });
        let own = (self.within.clone(), self.constants);
        let (first, constants) = self.outer.first().unwrap_or(&own);
        let reach = bounded.left_by(length(*constants)?, first.centre());
        if !(reach < first.r() || (upper == 0.0 && reach <= first.r())) {
            return refused(reach, first);
        }
        let mut longest = length(*constants)?;
        for (ball, constants) in self.outer.iter().chain([&own]).skip(1) {
            let reach = bounded.filled_by(longest, ball.centre());
            if !(reach <= ball.r()) {
                return refused(reach, ball);
            }
            longest = length(*constants)?;
        }
        // The minimisers must not touch the boundary.
        let reach = bounded.filled_by(longest, self.within.centre());
        if self.outer.is_empty() || reach < self.within.r() {
            Ok(())
        } else {
            refused(reach, &self.within)
        }
    }
}

/// The balls around the bounded ends of a problem.
struct BoundedEnds<const D: usize>(Vec<(SVector<f64, D>, f64)>);

impl<const D: usize> BoundedEnds<D> {
    fn of(ends: &Ends<D>) -> Self {
        let sets = [ends.first(), ends.second()];
        Self(sets.into_iter().filter_map(|set| set.enclosing_ball()).collect())
    }

    /// Returns the middle of the two centres and the sum of the two radii if both ends are bounded.
    fn middle(&self) -> Option<(SVector<Interval, D>, Interval)> {
        let [(first, r), (second, s)] = self.0[..] else { return None };
        let middle = first.zip_map(&second, |x, y| (Interval::point(x) + y) * 0.5);
        Some((middle, Interval::point(r) + s))
    }

    /// Returns the least radius of a ball about `centre` that no curve of a Euclidean length from
    /// set to set leaves, if only the length of its parts in the ball is known. It is rounded up, and
    /// infinite if a number overflows.
    ///
    /// A curve that leaves the ball has a part from an end to the boundary, and another one to the
    /// other end.
    fn left_by(&self, length: f64, centre: &SVector<f64, D>) -> f64 {
        let length = interval(length);
        let away: Vec<Interval> =
            self.0.iter().map(|(at, r)| distance(&at.map(Interval::point), centre) + *r).collect();
        let one = away.iter().map(|&away| above(away + length)).fold(f64::INFINITY, f64::min);
        let [first, second] = away[..] else { return one };
        one.min(above((first + second + length) * 0.5))
    }

    /// Returns the least radius of a ball about `centre` that contains every curve of a Euclidean
    /// length from set to set, rounded up.
    ///
    /// For each point `z` of a curve from `x` to `y`,
    /// `2 |z − ½(x + y)| ≤ |z − x| + |z − y| ≤ length`.
    fn filled_by(&self, length: f64, centre: &SVector<f64, D>) -> f64 {
        let left = self.left_by(length, centre);
        let about_the_middle = |(middle, radii): (SVector<Interval, D>, Interval)| {
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
fn distance<const D: usize>(x: &SVector<Interval, D>, y: &SVector<f64, D>) -> Interval {
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
        let rule = self.rule().paper_rule().map_err(LocalityError::Bound)?;
        let bounded = BoundedEnds::of(self.ends());
        let mut least: Option<Competitors<D>> = None;
        // The error if neither end has an enclosing ball: no radius bounds the competitors.
        let mut refused = LocalityError::Escapes { radius: f64::INFINITY, reach: f64::INFINITY };
        if let Some((middle, _)) = bounded.middle() {
            let middle = middle.map(Interval::midpoint);
            least = self.about(rule, &bounded, &middle, 0.0, extent).ok();
        }
        // A ball about an end is smaller if the other end is much larger, and it may exist if there
        // is none about the middle.
        let sizes: Vec<f64> = bounded.0.iter().map(|(_, r)| *r).collect();
        if least.is_none() || sizes[0] != sizes[1] {
            for (centre, r) in &bounded.0 {
                match self.about(rule, &bounded, centre, *r, extent) {
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
        rule: PaperRule,
        bounded: &BoundedEnds<D>,
        centre: &SVector<f64, D>,
        r: f64,
        extent: Extent,
    ) -> Result<Competitors<D>, LocalityError<LocalError>> {
        let (n, upper) = (self.sequence().n(), upper(extent));
        let within = |centre: &SVector<f64, D>, radius: f64| {
            LocalError::check_ball(centre, radius)?;
            self.metric().constants_within(centre, radius)
        };
        let beyond = |length| bounded.left_by(length, centre) - r;
        let at = |radius: f64| within(centre, r + radius);
        let Region { radius, constants } = competitors_within(D, rule, n, upper, beyond, at)?;
        // Rounding must not put an end outside of its own ball.
        let total = (r + radius).max(bounded.left_by(0.0, centre));
        let outside = LocalityError::Escapes { radius, reach: f64::INFINITY };
        let first = Ball::new(*centre, total).map_err(|_| outside)?;
        let mut found = Competitors { constants, within: first, outer: Vec::new() };
        let Some((middle, _)) = bounded.middle().filter(|_| upper > 0.0) else { return Ok(found) };
        let middle = middle.map(Interval::midpoint);
        let filled = |length| bounded.filled_by(length, &middle);
        let outer = Region { radius: total, constants };
        for Region { radius, constants } in
            shrink(D, rule, n, upper, outer, filled, |radius| within(&middle, radius))
        {
            let Ok(ball) = Ball::new(middle, radius) else { break };
            found.outer.push((found.within, found.constants));
            (found.within, found.constants) = (ball, constants);
        }
        Ok(found)
    }
}

#[cfg(test)]
mod tests;
