//! Proposition 6.2: two closed sets, one of them bounded, have a nearest pair.

use nalgebra::SVector;
use tautline::{Bounded, ClosedSet, Metric, MetricError};

use super::way_out::WayOut;
use crate::{
    Evidence, GramRange, Known, Reconstruction, Statement, Subject, Unit, curves::largest,
};

/// A pair of points of two sets that claims to be nearest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPair<const D: usize> {
    points: [SVector<f64, D>; 2],
    /// The distance between the two points and the distance between the two sets, in `m`.
    lengths: [f64; 2],
    /// The amount by which the squared distance between the points may exceed the least, in `m²`.
    excess: f64,
    /// The distance of the points from their sets, in `ℓ`.
    off_sets: f64,
    /// The distance between the limits of points of a set and the set, in `ℓ`.
    off_limits: f64,
    /// `sup |x|` over one of the sets that is bounded, in `ℓ`; `None` if neither is bounded.
    radius: Option<f64>,
    /// The least eigenvalue of `H` at the two points, in `m²/ℓ²`.
    lowest: f64,
    way_out: WayOut,
    /// The least distance between the points of other pairs that were tried, in `m`, if any were.
    other: Option<f64>,
    granted: f64,
}

impl<const D: usize> NearestPair<D> {
    /// Returns a pair of points of two sets, given the distance between the points and the distance
    /// between the sets, in `m`. `granted` is in `m²`.
    ///
    /// # Errors
    ///
    /// [`MetricError`] where `H` is not finite, symmetric and positive definite.
    pub fn between(
        subject: &Subject,
        metric: &impl Metric<D>,
        sets: [&dyn ClosedSet<D>; 2],
        points: [SVector<f64, D>; 2],
        lengths: [f64; 2],
        (way_out, granted): (WayOut, f64),
    ) -> Result<Self, MetricError> {
        let [x, y] = points;
        let off = sets.into_iter().zip(&points).map(|(set, x)| (set.project(x) - x).norm());
        let limits = [(sets[0], &y), (sets[1], &x)];
        let limits = limits.map(|(set, outside)| off_limits(subject, set, outside));
        let radii = sets.iter().filter_map(|set| set.radius()).filter(|radius| radius.is_finite());
        Ok(Self {
            points,
            lengths,
            excess: 0.0,
            off_sets: largest(off),
            off_limits: largest(limits),
            radius: radii.reduce(f64::min),
            lowest: GramRange::along(metric, points)?.low,
            way_out,
            other: None,
            granted,
        })
    }

    /// Returns the ends of a computed minimiser of the trapezoidal rule. The distance `apart`
    /// between them is at most the length of the curve that joins them, so that the excess is of
    /// order `1/N`. The bound `c₁` is assumed to hold everywhere, so that the space is complete
    /// (Proposition 3.3).
    ///
    /// # Errors
    ///
    /// The errors of [`between`](Self::between).
    pub fn of<M: Bounded<D>>(
        subject: &Subject,
        known: &Known<M, D>,
        seen: &Reconstruction<D>,
        apart: f64,
    ) -> Result<Self, MetricError> {
        let sequence = &seen.minimum.sequence;
        let pair = Self::between(
            subject,
            &known.metric,
            [&**known.ends.first(), &**known.ends.second()],
            [*sequence.first(), *sequence.last()],
            [apart, known.distance],
            (WayOut::by_c1(subject.constants(&known.metric)), seen.granted),
        )?;
        Ok(Self { excess: subject.theorem_a_excess(seen.setting, seen.rule, seen.n), ..pair })
    }

    /// Adds the least distance between the points of other pairs, in `m`.
    #[must_use]
    pub fn beside(self, other: f64) -> Self {
        Self { other: Some(other), ..self }
    }
}

/// Returns the distance between a limit of points of a set and the set, in `ℓ`. For a closed set it
/// is 0 up to rounding.
///
/// On the segment from a point outside to its projection, bisection finds two neighbours: a member
/// of the set, and a point that is projected elsewhere. This second point is a limit of members, so
/// that a closed set has a point that is at most as far from it as the member is.
fn off_limits<const D: usize>(
    subject: &Subject,
    set: &dyn ClosedSet<D>,
    outside: &SVector<f64, D>,
) -> f64 {
    let (mut beyond, mut member) = (*outside, subject.project(set, outside));
    // Each step fixes one bit of every coordinate.
    for _ in 0..128 {
        let middle = (beyond + member) * 0.5;
        if middle == beyond || middle == member {
            break;
        }
        let inside = subject.project(set, &middle) == middle;
        *(if inside { &mut member } else { &mut beyond }) = middle;
    }
    let gap = (subject.project(set, &beyond) - beyond).norm();
    // The comparison below keeps NaN.
    let off = gap - (member - beyond).norm();
    if off <= 0.0 { 0.0 } else { off }
}

/// Evaluates Proposition 6.2 on a pair. The claim: it is a nearest pair and, like every nearest
/// pair, lies within `d/√c₁` of the bounded set.
///
/// Needs: closed sets, at least one of which is bounded, and a complete space. `c1` is a lower
/// bound on `H`; the space is complete if the bound holds everywhere (Proposition 3.3).
#[doc(alias = "prop:bounded_2sets_min")]
#[must_use]
pub fn prop_6_2<const D: usize>(pair: &NearestPair<D>, c1: f64) -> Evidence {
    let size = largest(pair.points.iter().map(|x| x.norm()));
    let [apart, distance] = pair.lengths;
    let d2 = distance.powi(2) + pair.excess;
    let reach = (d2 / c1).sqrt();
    let room = pair.radius.map_or(f64::INFINITY, |radius| radius + reach);
    // If the sets touch, the reach is 0 and has no rounding.
    let moved = if reach > 0.0 { 0.5 * pair.granted / (c1 * reach) } else { 0.0 };
    let granted = 1e-13 * size + moved;
    let long = if apart > 0.0 { pair.granted / apart } else { pair.granted.sqrt() };
    let evidence = Evidence::of(Statement::Proposition6_2);
    let least = distance.powi(2);
    let mut evidence = pair
        .way_out
        .given_longer(evidence, [apart, long])
        .given_that("one of the sets is bounded", pair.radius.is_some())
        .given("the sets are closed", Unit::COORDINATE, [pair.off_limits, 0.0], 1e-13 * size)
        .given("c₁ ≤ λ_min(H) at x and y", Unit::GRAM, [c1, pair.lowest], 1e-14 * pair.lowest)
        .given("x ∈ X⁽⁰⁾ and y ∈ X⁽¹⁾", Unit::COORDINATE, [pair.off_sets, 0.0], 1e-13 * size)
        .stated("d(x, y)² ≤ d(X⁽⁰⁾, X⁽¹⁾)²", Unit::ENERGY, [apart.powi(2), d2], pair.granted)
        .stated("|x|, |y| ≤ R + d/√c₁", Unit::COORDINATE, [size, room], granted)
        .sharper("d(X⁽⁰⁾, X⁽¹⁾)² ≤ d(x, y)²", Unit::ENERGY, [least, apart.powi(2)], pair.granted);
    if let Some(other) = pair.other {
        let claim = "d(X⁽⁰⁾, X⁽¹⁾)² ≤ d(x′, y′)² for another pair";
        let granted = pair.granted + 1e-13 * least;
        evidence = evidence.sharper(claim, Unit::ENERGY, [least, other.powi(2)], granted);
    }
    evidence
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline::{Ball, ClosedSet, FiniteSet, HalfSpace};

    use super::off_limits;
    use crate::LIBRARY;

    /// The set `{0 ≤ x₁ < 1}` on the line. Points without a nearest point are projected to the
    /// middle.
    #[derive(Debug)]
    struct HalfOpen;

    impl ClosedSet<1> for HalfOpen {
        fn project(&self, x: &SVector<f64, 1>) -> SVector<f64, 1> {
            SVector::from([if x[0] >= 1.0 { 0.5 } else { x[0].max(0.0) }])
        }

        fn projection_derivative(&self, _: &SVector<f64, 1>) -> SMatrix<f64, 1, 1> {
            SMatrix::identity()
        }

        fn radius(&self) -> Option<f64> {
            Some(1.0)
        }
    }

    #[test]
    fn a_limit_that_a_set_does_not_contain_is_found() {
        let seen = |x: f64| off_limits(&LIBRARY, &HalfOpen, &SVector::from([x]));
        // The members tend to 1, which is at the distance ½ from its projection.
        assert!((seen(3.0) - 0.5).abs() <= 1e-15, "{}", seen(3.0));
        // At 0 the set is closed.
        assert_eq!(seen(-2.0), 0.0);
    }

    #[test]
    fn closed_sets_contain_their_limits() {
        let ball = Ball::new([1.0, 0.5], 0.25).expect("a radius");
        let wall = HalfSpace::at_least([0.3, 1.0], 2.0).expect("a normal");
        let points = FiniteSet::new([[1.0, 2.0], [-1.0, 0.0]]).expect("not empty");
        let sets: [&dyn ClosedSet<2>; 3] = [&ball, &wall, &points];
        for set in sets {
            for outside in [[0.1, -3.0], [7.0, 0.2], [1.0, 0.6]] {
                let off = off_limits(&LIBRARY, set, &SVector::from(outside));
                // A projection has about ten roundings of coordinates up to 7.
                assert!(off <= 1e-14, "{set:?} from {outside:?}: {off:e}");
            }
        }
    }
}
