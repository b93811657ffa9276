//! `Curve`: a computed curve between two points, and the other local minima.

use serde::Serialize;
use tautline::PointSequence;

use crate::{Complaint, Question};

/// The shortest curve found between two points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// The points, in order. The curve joins them by straight lines.
    pub points: Vec<[f64; 2]>,
    /// The length of the curve, in `m`.
    pub length: f64,
    /// The estimated error of the length, in `m`.
    pub error: f64,
    /// Why the curve may not be a shortest one, in words; empty if no reason is known.
    pub doubts: Vec<String>,
    /// The other local minima that were found, shortest first, up to eight.
    pub others: Vec<Other>,
}

/// Another local minimum.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Other {
    /// Its points, in order: as many as those of the curve, or 513.
    pub points: Vec<[f64; 2]>,
    /// Its length, in `m`.
    pub length: f64,
}

impl Curve {
    /// Solves the problem.
    ///
    /// # Errors
    ///
    /// [`Complaint`] if the solver finds no curve.
    pub fn new(question: &Question) -> Result<Self, Complaint> {
        let line = question.line()?;
        let length = line.length();
        let others = line.other_minima();
        let others = others
            .iter()
            .map(|other| Other { points: points(other.sequence()), length: other.length().value });
        Ok(Self {
            points: points(line.sequence()),
            length: length.value,
            error: length.error,
            doubts: line.doubts().iter().map(ToString::to_string).collect(),
            others: others.collect(),
        })
    }
}

fn points(sequence: &PointSequence<2>) -> Vec<[f64; 2]> {
    sequence.points().iter().map(|&point| point.into()).collect()
}

#[cfg(test)]
mod tests {
    use super::Curve;
    use crate::Question;

    fn curve(formula: &str, from: [f64; 2], to: [f64; 2]) -> Curve {
        let question = Question::new(formula, from, to, 64).expect("readable");
        Curve::new(&question).expect("solved")
    }

    /// Under 4 I every length is doubled.
    #[test]
    fn the_curve_of_a_constant_metric_is_straight() {
        let curve = curve("4 I", [-1.0, 0.5], [2.0, 4.5]);
        assert!((curve.length - 10.0).abs() <= 1e-14 * 10.0, "{}", curve.length);
        assert_eq!(curve.points.len(), 65);
        assert_eq!((curve.points[0], curve.points[64]), ([-1.0, 0.5], [2.0, 4.5]));
        assert!(curve.doubts.is_empty() && curve.others.is_empty(), "{curve:?}");
    }

    /// A hill that is a little nearer to one of the two ways around it.
    #[test]
    fn the_longer_way_around_a_hill_is_another_minimum() {
        let curve = curve("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", [-1.5, 0.05], [1.5, 0.1]);
        assert!(curve.points[32][1] > 0.5, "{:?}", curve.points[32]);
        assert_eq!(curve.others.len(), 1);
        let other = &curve.others[0];
        assert!(other.length > curve.length && other.points[32][1] < -0.5, "{other:?}");
        assert_eq!((other.points[0], other.points[64]), (curve.points[0], curve.points[64]));
    }

    #[test]
    fn ends_that_touch_are_no_error() {
        let curve = curve("(2 - cos(x1))^2 I", [0.5, 0.5], [0.5, 0.5]);
        assert!(curve.length == 0.0 && curve.others.is_empty(), "{curve:?}");
    }
}
