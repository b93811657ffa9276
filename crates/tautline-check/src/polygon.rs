//! The length of a polygon, from above.

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};
use tautline_sets::Shape;

use crate::{CheckError, rounding::add_up, set::contains, vertex_test::gram};

/// How often a chord may be halved.
const HALVINGS: u32 = 12;

/// A part of a chord is halved if its length is not known better than this, relative to itself.
const LOOSE: f64 = 1e-3;

/// Returns an upper bound on the length of a polygon that is proved to run from set to set, in `m`.
///
/// # Errors
///
/// [`CheckError::CurveEnd`] if an end is not proved to lie in its set. If the length of a chord is
/// not bounded, or the metric is undefined at the only point, the result is infinite.
pub fn length_above<const D: usize>(
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    points: &[SVector<f64, D>],
) -> Result<f64, CheckError> {
    if !points.first().is_some_and(|x| contains(sets[0], x)) {
        return Err(CheckError::CurveEnd { end: "first" });
    }
    if !points.last().is_some_and(|x| contains(sets[1], x)) {
        return Err(CheckError::CurveEnd { end: "last" });
    }
    // Equal points make no chord, but the metric has to be defined there.
    let is_defined =
        gram(formula, &points[0].map(Interval::point)).iter().all(|entry| entry.is_finite());
    let mut length = if is_defined { 0.0 } else { f64::INFINITY };
    for pair in points.windows(2).filter(|pair| pair[0] != pair[1]) {
        let from = pair[0].map(Interval::point);
        let chord = pair[1].map(Interval::point) - from;
        length = add_up(length, part_above(formula, &from, &chord, [0.0, 1.0], HALVINGS));
    }
    // A sum with an infinite term is NaN.
    Ok(if length.is_nan() { f64::INFINITY } else { length })
}

/// Returns an upper bound on the length of the part of a chord between two parameters.
///
/// With `g(s) = (dᵀ H(x + s d) d)^{1/2}`, the integral over `[a, b]` with the middle `m` is
/// `(b − a)(g(m) + (b − a)² g''(ξ)/24)` for some `ξ`.
fn part_above<const D: usize>(
    formula: &Formula<D>,
    from: &SVector<Interval, D>,
    chord: &SVector<Interval, D>,
    [a, b]: [f64; 2],
    halvings: u32,
) -> f64 {
    // The parameters are multiples of a power of two.
    let (middle, width) = (0.5 * (a + b), b - a);
    let whole = Interval::point(a).hull(Interval::point(b));
    let curvature = speed(formula, from, chord, whole).second(0, 0);
    let speed = speed(formula, from, chord, Interval::point(middle)).value();
    let length = (speed + curvature * (width * width) / 24.0) * width;
    if length.radius() <= LOOSE * length.midpoint() || halvings == 0 {
        return length.hi();
    }
    let first = part_above(formula, from, chord, [a, middle], halvings - 1);
    // One part without a bound is enough. The others may be thousands.
    if !(first < f64::INFINITY) {
        return f64::INFINITY;
    }
    add_up(first, part_above(formula, from, chord, [middle, b], halvings - 1))
}

/// Returns `g` and its derivatives at the parameters in `s`.
fn speed<const D: usize>(
    formula: &Formula<D>,
    from: &SVector<Interval, D>,
    chord: &SVector<Interval, D>,
    s: Interval,
) -> Jet2<Interval, 1> {
    let variable = |at: Interval| Jet2::variables(&[at])[0];
    let (s, zero) = (variable(s), variable(Interval::point(0.0)));
    let constant = |c: Interval| variable(c) - zero;
    let d = chord.map(constant);
    let x = SVector::from_fn(|i, _| constant(from[i]) + s * d[i]);
    let h = formula.gram(&x);
    let mut square = constant(Interval::point(0.0));
    for i in 0..D {
        for j in i..D {
            let term = d[i] * d[j] * h[(i, j)];
            square += if i == j { term } else { term * 2.0 };
        }
    }
    square.sqrt()
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_formula::Formula;
    use tautline_sets::{Point, Shape};

    use super::length_above;

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
    fn a_curve_where_the_metric_is_undefined_has_no_bound() {
        let formula = Formula::<1>::parse("[1 + (1/x1)^0]", &[]).expect("a formula");
        let at = |x: f64| Shape::Point(Point::new([x]).expect("finite"));
        let length = |points: &[f64]| {
            let points: Vec<_> = points.iter().map(|&x| vector![x]).collect();
            let ends = [points[0][0], points[points.len() - 1][0]].map(at);
            length_above(&formula, ends.each_ref(), &points).expect("ends in their sets")
        };
        for points in [&[0.0][..], &[0.0, 0.0], &[-1.0, 2.0], &[0.0, 1.0]] {
            assert_eq!(length(points), f64::INFINITY, "{points:?}");
        }
        assert!((length(&[1.0, 2.0]) - 2.0_f64.sqrt()).abs() < 1e-12);
        assert_eq!(length(&[1.0]), 0.0);
    }
}
