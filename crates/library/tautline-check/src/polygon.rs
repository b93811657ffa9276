//! The length of a polygon, from above.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};
use tautline_sets::Shape;

use crate::{
    CheckError,
    rounding::{add_up, mul_up, sqrt_up},
    steps,
    vertex_test::{Decomposed, symmetric},
    work::{UNLIMITED, Work},
};

/// How often a chord may be halved.
const HALVINGS: u32 = 12;

/// A part of a chord is halved if its length is not known better than this, relative to itself.
const LOOSE: f64 = 1e-3;

/// Returns an upper bound on the length of a polygon that is proved to run from set to set, where the
/// metric is defined and positive definite, in `m`.
///
/// # Errors
///
/// [`CheckError::CurveEnd`] if an end does not lie in its set, [`CheckError::CurveDomain`] if a chord is
/// not proved to stay where the metric is one, [`CheckError::Halves`] if two entries that mirror each other
/// are not known to be equal. The result may be infinite.
pub fn length_above<const D: usize>(
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    points: &[SVector<f64, D>],
) -> Result<f64, CheckError> {
    if let Some((row, column)) = formula.unequal_halves() {
        return Err(CheckError::Halves { row, column });
    }
    steps::length(formula, sets, points, &UNLIMITED)
}

/// Does the same, for no more than this work.
pub(crate) fn length_within<const D: usize>(
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    points: &[SVector<f64, D>],
    work: &Work<'_>,
) -> Result<f64, CheckError> {
    if !points.first().is_some_and(|x| sets[0].contains(x)) {
        return Err(CheckError::CurveEnd { end: "first" });
    }
    if !points.last().is_some_and(|x| sets[1].contains(x)) {
        return Err(CheckError::CurveEnd { end: "last" });
    }
    let mut length = None;
    for (chord, pair) in points.windows(2).enumerate().filter(|(_, pair)| pair[0] != pair[1]) {
        let part = Chord::new(formula, [&pair[0], &pair[1]]).above([0.0, 1.0], HALVINGS, work)?;
        let part = part.ok_or(CheckError::CurveDomain { chord })?;
        length = Some(add_up(length.unwrap_or(0.0), part));
    }
    // Equal points make no chord, but the metric has to be one there.
    if length.is_none() && !is_metric(&formula.gram(&points[0].map(Interval::point))) {
        return Err(CheckError::CurveDomain { chord: 0 });
    }
    // A sum with an infinite term is NaN.
    Ok(length.map_or(0.0, |length| if length.is_nan() { f64::INFINITY } else { length }))
}

/// Returns whether a matrix of intervals is defined, also below the diagonal, and positive definite.
fn is_metric<const D: usize>(h: &SMatrix<Interval, D, D>) -> bool {
    h.iter().all(|entry| entry.is_finite())
        && Decomposed::new(symmetric(h), Interval::point(0.0)).is_some()
}

/// The points `x + s d` with `s` from 0 to 1, under a metric.
struct Chord<'f, const D: usize> {
    formula: &'f Formula<D>,
    from: SVector<Interval, D>,
    step: SVector<Interval, D>,
    /// The box between the ends.
    hull: SVector<Interval, D>,
}

impl<'f, const D: usize> Chord<'f, D> {
    fn new(formula: &'f Formula<D>, ends: [&SVector<f64, D>; 2]) -> Self {
        let [from, to] = ends.map(|x| x.map(Interval::point));
        Self { formula, from, step: to - from, hull: from.zip_map(&to, Interval::hull) }
    }

    /// Returns an upper bound on the length between two parameters; `None` if that part is not proved
    /// to stay where the metric is one.
    ///
    /// With the speed `g(s) = (dᵀ H(x + s d) d)^{1/2}`, the integral over `[a, b]` with the middle `m`
    /// is `(b − a)(g(m) + (b − a)² g''(ξ)/24)` for some `ξ`.
    fn above(
        &self,
        [a, b]: [f64; 2],
        halvings: u32,
        work: &Work<'_>,
    ) -> Result<Option<f64>, CheckError> {
        work.spend(6 * work.formula)?;
        // The parameters are multiples of a power of two.
        let (middle, width) = (0.5 * (a + b), b - a);
        let whole = self.gram(Interval::point(a).hull(Interval::point(b)));
        let values = whole.map(|entry| entry.value());
        if is_metric(&values) {
            let square = self.square(&whole);
            let curvature = square.sqrt().second(0, 0);
            let speed = self.square(&self.gram(Interval::point(middle))).sqrt().value();
            let length = (speed + curvature * (width * width) / 24.0) * width;
            let is_sharp = length.radius() <= LOOSE * length.midpoint();
            if length.is_finite() && (is_sharp || halvings == 0) {
                return Ok(Some(length.hi()));
            }
            if halvings == 0 {
                return Ok(Some(mul_up(sqrt_up(square.value().hi()), width)));
            }
        } else if halvings == 0 {
            return Ok(None);
        }
        let Some(first) = self.above([a, middle], halvings - 1, work)? else { return Ok(None) };
        let second = self.above([middle, b], halvings - 1, work)?;
        Ok(second.map(|second| add_up(first, second)))
    }

    /// Returns `H` and its derivatives at the parameters in `s`.
    fn gram(&self, s: Interval) -> SMatrix<Jet2<Interval, 1>, D, D> {
        let zero = Interval::point(0.0);
        let x = SVector::from_fn(|i, _| {
            // Rounding does not lead beyond the ends: a table may be known up to there only.
            let at = (self.from[i] + s * self.step[i]).intersection(self.hull[i]);
            Jet2::new(at.unwrap_or(self.hull[i]), [self.step[i]], |_, _| zero)
        });
        self.formula.gram(&x)
    }

    /// Returns `dᵀHd`.
    fn square(&self, h: &SMatrix<Jet2<Interval, 1>, D, D>) -> Jet2<Interval, 1> {
        let sum = |of: fn(&Jet2<Interval, 1>) -> Interval| {
            let pairs = (0..D).flat_map(|i| (i..D).map(move |j| (i, j)));
            pairs.fold(Interval::point(0.0), |sum, (i, j)| {
                let (d, e) = (self.step[i], self.step[j]);
                sum + of(&h[(i, j)]) * if i == j { d.sqr() } else { d * e * 2.0 }
            })
        };
        let [value, first, second] =
            [sum(|h| h.value()), sum(|h| h.first(0)), sum(|h| h.second(0, 0))];
        Jet2::new(value, [first], |_, _| second)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_formula::Formula;
    use tautline_sets::{Point, Shape};

    use super::length_above;
    use crate::CheckError;

    /// The second derivative of the speed is large at the bump, and the chord is long.
    #[test]
    fn a_long_chord_over_a_bump_has_a_good_bound() {
        let formula = Formula::<1>::parse("[1 + 4*exp(-x1^2)]", &[]).expect("a formula");
        let ends = [-100.0, 100.0].map(|x| Shape::Point(Point::new([x]).expect("finite")));
        let points = [vector![-100.0], vector![100.0]];
        let length = length_above(&formula, ends.each_ref(), &points).expect("ends in their sets");
        // The midpoint rule converges faster than any power of its step.
        let speed = |k: i32| (1.0 + 4.0 * (-(f64::from(k) * 0.01 + 0.005).powi(2)).exp()).sqrt();
        let exact = (-10_000..10_000).map(speed).sum::<f64>() * 0.01;
        assert!(exact <= length * (1.0 + 1e-12) && length <= 1.001 * exact, "{length} {exact}");
    }

    /// No curve runs through a place where the metric is undefined, not even one of length 0.
    #[test]
    fn a_curve_where_the_metric_is_undefined_is_refused() {
        let formula = Formula::<1>::parse("[1 + (1/x1)^0]", &[]).expect("a formula");
        for (points, chord) in
            [(&[0.0][..], 0), (&[0.0, 0.0], 0), (&[-1.0, 2.0], 0), (&[1.0, 1.0, 0.5, 0.0], 2)]
        {
            let refused = on_the_line(&formula, points);
            assert_eq!(refused, Err(CheckError::CurveDomain { chord }), "{points:?}");
        }
        let length = on_the_line(&formula, &[1.0, 2.0]).expect("defined");
        assert!((length - 2.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!(on_the_line(&formula, &[1.0]), Ok(0.0));
    }

    fn on_the_line(formula: &Formula<1>, points: &[f64]) -> Result<f64, CheckError> {
        let points: Vec<_> = points.iter().map(|&x| vector![x]).collect();
        let ends = [points[0], points[points.len() - 1]]
            .map(|x| Shape::Point(Point::new(x).expect("finite")));
        length_above(formula, ends.each_ref(), &points)
    }
}
