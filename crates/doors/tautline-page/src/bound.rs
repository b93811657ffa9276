//! `Bound`: proved bounds on the distance between two points.

use core::ops::ControlFlow;

use serde::Serialize;
use tautline::certify::Accuracy;

use crate::{Complaint, Question};

/// Bounds on the distance, proved from the formula of the metric.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Bound {
    /// A lower bound on the distance, in `m`; `None` if there is no proof.
    pub lower: Option<f64>,
    /// An upper bound on the distance, in `m`: the length of the curve, rounded up.
    pub upper: f64,
    /// Whether the lower bound assumes that the minimum that was found is global.
    pub assumes_global_minimum: bool,
    /// The reason why there is no lower bound.
    pub reason: Option<String>,
}

/// How sharp the constants must be. A reader waits for the bounds after each drag: 20 ms to 3 s in a
/// browser. More chords narrow the bounds at less cost than sharper constants do.
const ACCURACY: Accuracy = Accuracy { tolerance: 0.1, budget: 20_000 };

impl Bound {
    /// Solves the problem, and proves bounds.
    ///
    /// # Errors
    ///
    /// [`Complaint`] if the solver finds no curve, or if the metric is undefined on the curve.
    pub fn new(question: &Question) -> Result<Self, Complaint> {
        let line = question.line()?;
        match line.prove(ACCURACY) {
            Ok(proof) => Ok(Self {
                // The root of a double is off by less than its neighbours are.
                lower: Some(proof.enclosure.lower.sqrt().next_down().max(0.0)),
                upper: proof.enclosure.upper.sqrt().next_up(),
                assumes_global_minimum: proof.enclosure.assumes_global_minimum,
                reason: None,
            }),
            Err(reason) => {
                let curve = line.admissible_curve().map_err(|error| Complaint::about(&error))?;
                let found = line.quick_certificate(0.0, &mut |_| ControlFlow::Continue(())).ok();
                let lower = found.map(|found| found.lower()).filter(|lower| *lower > 0.0);
                Ok(Self {
                    reason: lower.is_none().then(|| reason.to_string()),
                    lower,
                    upper: curve.distance_squared_at_most().sqrt().next_up(),
                    assumes_global_minimum: false,
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Bound;
    use crate::{Curve, Question};

    fn bound(formula: &str, from: [f64; 2], to: [f64; 2]) -> (Curve, Bound) {
        let question = Question::new(formula, from, to, 256).expect("readable");
        (Curve::new(&question).expect("solved"), Bound::new(&question).expect("defined"))
    }

    /// H = f² I with f = 2 − cos x₁, along x₁: the distance is ∫ f.
    #[test]
    fn a_known_distance_lies_between_the_bounds() {
        let (curve, bound) = bound("(2 - cos(x1))^2 I", [-0.5, 0.0], [0.5, 0.0]);
        let distance = 2.0 - 2.0 * 0.5_f64.sin();
        let lower = bound.lower.expect("proved");
        assert!(lower <= distance && distance <= bound.upper, "{bound:?}");
        assert!(bound.upper - lower < 1e-4 && bound.reason.is_none(), "{bound:?}");
        assert!((bound.upper - curve.length).abs() < 1e-12, "{bound:?}, {}", curve.length);
    }

    /// Across the sphere, a curve through infinity might be shorter. The curve that was found is an
    /// upper bound all the same.
    #[test]
    fn without_a_proof_the_length_remains() {
        let (curve, bound) = bound("4/(1 + x1^2 + x2^2)^2 I", [1.0, 0.0], [-1.5, 0.3]);
        assert!(bound.lower.is_none() && bound.reason.is_some(), "{bound:?}");
        assert!((bound.upper - curve.length).abs() < 1e-12, "{bound:?}, {}", curve.length);
    }
}
