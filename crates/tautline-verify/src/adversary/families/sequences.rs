//! Families of point sequences, minimisers or not, for the statements about all of them.

use tautline::{
    Bounded, MetricError, PointSequence, SVector,
    gallery::{Ramp, Separable, Shear, Valleys},
};

use super::super::{Family, Parameter};
use crate::{
    Evidence, Statement, Subject,
    statements::{lemma_s_2, prop_7_9, prop_8_1, prop_8_2},
    witnesses::{Incline, tent},
};

/// A statement about a metric and a point sequence.
type OfSequence<S, M, const D: usize> =
    fn(&S, &M, &PointSequence<D>) -> Result<Evidence, MetricError>;

/// The statements; another one is one line more.
fn statements<S: Subject, M: Bounded<D>, const D: usize>() -> Vec<(Statement, OfSequence<S, M, D>)>
{
    vec![
        (Statement::Proposition7_9, prop_7_9),
        (Statement::Proposition8_1, prop_8_1),
        (Statement::Proposition8_2, prop_8_2),
        (Statement::LemmaS2, lemma_s_2),
    ]
}

/// All statements on one box.
fn on<'a, S: Subject, M: Bounded<D> + 'a, const D: usize, const P: usize>(
    subject: &'a S,
    name: &'static str,
    parameters: [Parameter; P],
    case: impl Fn([f64; P]) -> Option<(M, Vec<[f64; D]>)> + Copy + 'a,
) -> Vec<Family<'a>> {
    let family = |(statement, evidence): (_, OfSequence<S, M, D>)| {
        Family::new(name, statement, parameters, move |values| {
            let Some((metric, points)) = case(values) else { return Ok(None) };
            let points = points.into_iter().map(SVector::from).collect();
            Ok(Some(evidence(subject, &metric, &PointSequence::new(points)?)?))
        })
    };
    statements().into_iter().map(family).collect()
}

pub(super) fn families<S: Subject>(subject: &S) -> Vec<Family<'_>> {
    let coordinate = |name| Parameter::linear(name, -3.0, 3.0);
    // The metrics of these two have their constants on [0, 1].
    let inside = |name| Parameter::linear(name, 0.0, 1.0);
    let slope = || Parameter::logarithmic("L", 1e-3, 10.0);
    // Enough for a step that rests.
    let two = || Parameter::subintervals(2);
    let mut all = on(
        subject,
        "shear",
        [
            Parameter::logarithmic("a", 1e-3, 0.8),
            coordinate("x2"),
            coordinate("y1"),
            coordinate("y2"),
            coordinate("z1"),
            coordinate("z2"),
            two(),
        ],
        |[a, x2, y1, y2, z1, z2, _]| {
            Some((Shear::new(a, 1.0).ok()?, vec![[0.0, x2], [y1, y2], [z1, z2]]))
        },
    );
    all.extend(on(
        subject,
        "separable, D = 1",
        [
            Parameter::logarithmic("a", 1e-3, 0.6),
            coordinate("x"),
            coordinate("y"),
            coordinate("z"),
            two(),
        ],
        |[a, x, y, z, _]| Some((Separable::new([a], [1.0]).ok()?, vec![[x], [y], [z]])),
    ));
    all.extend(on(
        subject,
        "separable, D = 2",
        [
            Parameter::logarithmic("a1", 1e-3, 0.6),
            Parameter::logarithmic("a2", 1e-3, 0.6),
            Parameter::logarithmic("k2", 0.5, 2.0),
            coordinate("x1"),
            coordinate("x2"),
            coordinate("y1"),
            coordinate("y2"),
            Parameter::subintervals(1),
        ],
        |[a1, a2, k2, x1, x2, y1, y2, _]| {
            Some((Separable::new([a1, a2], [1.0, k2]).ok()?, vec![[x1, x2], [y1, y2]]))
        },
    ));
    all.extend(on(
        subject,
        "ramp",
        [
            Parameter::logarithmic("a", 1e-3, 0.7),
            coordinate("x"),
            coordinate("y"),
            coordinate("z"),
            two(),
        ],
        |[a, x, y, z, _]| Some((Ramp::new(a, 1.0).ok()?, vec![[x], [y], [z]])),
    ));
    all.extend(on(
        subject,
        "tent",
        [slope(), inside("x"), inside("y"), inside("z"), two()],
        |[slope, x, y, z, _]| Some((tent(1.0, slope)?, vec![[x], [y], [z]])),
    ));
    all.extend(on(
        subject,
        "incline",
        [slope(), inside("x"), inside("y"), inside("z"), two()],
        |[slope, x, y, z, _]| Some((Incline::new(1.0, slope)?, vec![[x], [y], [z]])),
    ));
    all.extend(on(
        subject,
        "valleys",
        [
            coordinate("x1"),
            coordinate("y1"),
            coordinate("y2"),
            coordinate("z1"),
            coordinate("z2"),
            two(),
        ],
        |[x1, y1, y2, z1, z2, _]| Some((Valleys, vec![[x1, 0.0], [y1, y2], [z1, z2]])),
    ));
    all
}
