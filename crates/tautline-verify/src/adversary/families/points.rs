//! Families of points, for the statements about the derivatives of a metric.

use tautline::{
    Bounded, MetricError, SVector,
    gallery::{CoupledCosines, RotatingAnisotropy, Shear, Valleys},
};

use super::super::{Family, Parameter};
use crate::{
    Evidence, Statement, Subject,
    statements::{prop_7_10, prop_7_11},
};

/// A statement about a metric at a point.
type AtPoint<S, M, const D: usize> = fn(&S, &M, &SVector<f64, D>) -> Result<Evidence, MetricError>;

/// The statements; another one is one line more.
fn statements<S: Subject, M: Bounded<D>, const D: usize>() -> Vec<(Statement, AtPoint<S, M, D>)> {
    vec![(Statement::Proposition7_10, prop_7_10), (Statement::Proposition7_11, prop_7_11)]
}

/// All statements on one box.
fn on<'a, S: Subject, M: Bounded<D> + 'a, const D: usize, const P: usize>(
    subject: &'a S,
    name: &'static str,
    parameters: [Parameter; P],
    case: impl Fn([f64; P]) -> Option<(M, [f64; D])> + Copy + 'a,
) -> Vec<Family<'a>> {
    let family = |(statement, evidence): (_, AtPoint<S, M, D>)| {
        Family::new(name, statement, parameters, move |values| {
            let Some((metric, x)) = case(values) else { return Ok(None) };
            Ok(Some(evidence(subject, &metric, &x.into())?))
        })
    };
    statements().into_iter().map(family).collect()
}

pub(super) fn families<S: Subject>(subject: &S) -> Vec<Family<'_>> {
    let coordinate = |name| Parameter::linear(name, -3.0, 3.0);
    let mut all = on(
        subject,
        "shear",
        [Parameter::logarithmic("a", 1e-3, 0.8), coordinate("x2")],
        |[a, x2]| Some((Shear::new(a, 1.0).ok()?, [0.0, x2])),
    );
    all.extend(on(subject, "valleys", [coordinate("x1")], |[x1]| Some((Valleys, [x1, 0.0]))));
    all.extend(on(
        subject,
        "cosines",
        [coordinate("x1"), coordinate("x2"), coordinate("x3")],
        |x| Some((CoupledCosines, x)),
    ));
    // The unit of energies makes one eigenvalue 1, and that of coordinates k₁.
    all.extend(on(
        subject,
        "anisotropy",
        [
            Parameter::logarithmic("ratio", 1.1, 100.0),
            Parameter::linear("k2", -3.0, 3.0),
            coordinate("x1"),
        ],
        |[ratio, k2, x1]| Some((RotatingAnisotropy::new([ratio, 1.0], [1.0, k2]).ok()?, [x1, 0.0])),
    ));
    all
}
