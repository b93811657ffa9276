//! Families of points, for the statements about the derivatives of a metric.

use std::f64::consts::PI;

use tautline::{
    Bounded, MetricError, SVector,
    gallery::{CoupledCosines, RotatingAnisotropy, Shear, Valleys},
};
use tautline_statements::{Evidence, Statement, Subject, prop_7_10, prop_7_11};

use super::{
    super::{Beyond, Family, Parameter},
    ranges::{amplitude, beside, direction, phase},
};

/// A statement about a metric at a point.
type AtPoint<M, const D: usize> =
    fn(&Subject, &M, &SVector<f64, D>) -> Result<Evidence, MetricError>;

/// The statements about a point. To add one, add a line.
fn statements<M: Bounded<D>, const D: usize>() -> Vec<(Statement, AtPoint<M, D>)> {
    vec![(Statement::Proposition7_10, prop_7_10), (Statement::Proposition7_11, prop_7_11)]
}

/// Returns a family for each statement about a point, all on the same box.
fn on<'a, M: Bounded<D> + 'a, const D: usize, const P: usize>(
    subject: &'a Subject,
    name: &'static str,
    parameters: [Parameter; P],
    case: impl Fn([f64; P]) -> Option<(M, [f64; D])> + Copy + 'a,
) -> Vec<Family<'a>> {
    let family = |(statement, evidence): (_, AtPoint<M, D>)| {
        Family::new(name, statement, parameters, move |values| {
            let Some((metric, x)) = case(values) else { return Ok(None) };
            Ok(Some(evidence(subject, &metric, &x.into())?))
        })
    };
    statements().into_iter().map(family).collect()
}

pub(super) fn of_points(subject: &Subject) -> Vec<Family<'_>> {
    let mut all = on(subject, "shear", [amplitude("a", 1e4), phase("x2")], |[a, x2]| {
        Some((Shear::new(a, 1.0).ok()?, [0.0, x2]))
    });
    all.extend(on(subject, "valleys", [phase("x1")], |[x1]| Some((Valleys, [x1, 0.0]))));
    all.extend(on(subject, "cosines", [phase("x1"), phase("x2"), phase("x3")], |x| {
        Some((CoupledCosines, x))
    }));
    // The units of energies and coordinates are chosen so that one eigenvalue is 1 and `|k| = 1`.
    all.extend(on(
        subject,
        "anisotropy",
        [
            // `H` is constant if the ratio is 1.
            Parameter::logarithmic("ratio − 1", 1e-4, 1e6)
                .with_ends(Beyond::Limit("ratio → 1"), Beyond::Limit("ratio → ∞")),
            direction("k"),
            Parameter::periodic("theta", PI),
        ],
        |[excess, direction, theta]| {
            let k = beside([0.0, 0.0], 1.0, direction);
            Some((RotatingAnisotropy::new([1.0 + excess, 1.0], k).ok()?, k.map(|k| theta * k)))
        },
    ));
    all
}
