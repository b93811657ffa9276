//! Families of point sequences, for the statements that do not need a minimiser.

use tautline::{
    Bounded, MetricError, PointSequence, SVector,
    gallery::{Ramp, Separable, Shear, Valleys},
};
use tautline_statements::{
    Evidence, Statement, Subject, lemma_s_2, prop_7_9, prop_8_1, prop_8_2,
    witnesses::{Incline, tent},
};

use super::{
    super::{Family, Parameter},
    ranges::{
        along, amplitude, beside, direction, inside, on_the_ramp, part, phase, ratio_of_waves,
        share, shared, step, wave_numbers, way,
    },
};

/// A statement about a metric and a point sequence.
type OfSequence<M, const D: usize> =
    fn(&Subject, &M, &PointSequence<D>) -> Result<Evidence, MetricError>;

/// The statements about a point sequence. To add one, add a line.
fn statements<M: Bounded<D>, const D: usize>() -> Vec<(Statement, OfSequence<M, D>)> {
    vec![
        (Statement::Proposition7_9, prop_7_9),
        (Statement::Proposition8_1, prop_8_1),
        (Statement::Proposition8_2, prop_8_2),
        (Statement::LemmaS2, lemma_s_2),
    ]
}

/// Returns a family for each statement about a point sequence, all on the same box.
fn on<'a, M: Bounded<D> + 'a, const D: usize, const P: usize>(
    subject: &'a Subject,
    name: &'static str,
    parameters: [Parameter; P],
    case: impl Fn([f64; P]) -> Option<(M, Vec<[f64; D]>)> + Copy + 'a,
) -> Vec<Family<'a>> {
    let family = |(statement, evidence): (_, OfSequence<M, D>)| {
        Family::new(name, statement, parameters, move |values| {
            let Some((metric, points)) = case(values) else { return Ok(None) };
            let points = points.into_iter().map(SVector::from).collect();
            Ok(Some(evidence(subject, &metric, &PointSequence::new(points)?)?))
        })
    };
    statements().into_iter().map(family).collect()
}

pub(super) fn of_sequences(subject: &Subject) -> Vec<Family<'_>> {
    // Two subintervals suffice for a sequence with a step that rests.
    let two = || Parameter::subintervals(2);
    let mut all = on(
        subject,
        "shear",
        [
            amplitude("a", 1e4),
            phase("x2"),
            step("step1"),
            direction("phi1"),
            step("step2"),
            direction("phi2"),
            two(),
        ],
        |[a, x2, l1, phi1, l2, phi2, _]| {
            Some((Shear::new(a, 1.0).ok()?, two_steps([0.0, x2], [l1, phi1, l2, phi2])))
        },
    );
    all.extend(on(
        subject,
        "separable, D = 1",
        [
            part("a", MOST),
            phase("x"),
            step("step1"),
            way("way1"),
            step("step2"),
            way("way2"),
            two(),
        ],
        |[a, x, l1, way1, l2, way2, _]| {
            Some((Separable::new([a], [1.0]).ok()?, two_steps_on_the_line(x, [l1, way1, l2, way2])))
        },
    ));
    all.extend(on(
        subject,
        "separable, D = 2",
        [
            part("a", MOST),
            share(),
            ratio_of_waves(),
            phase("k1x1"),
            phase("k2x2"),
            step("step"),
            direction("phi"),
            Parameter::subintervals(1),
        ],
        |[a, psi, ratio, phase1, phase2, step, phi, _]| {
            let k = wave_numbers(ratio);
            let from = [phase1 / k[0], phase2 / k[1]];
            let metric = Separable::new(shared(a, psi), k).ok()?;
            Some((metric, vec![from, beside(from, step, phi)]))
        },
    ));
    all.extend(on(
        subject,
        "ramp",
        [
            part("a", MOST),
            on_the_ramp(),
            step("step1"),
            way("way1"),
            step("step2"),
            way("way2"),
            two(),
        ],
        |[a, x, l1, way1, l2, way2, _]| {
            Some((Ramp::new(a, 1.0).ok()?, two_steps_on_the_line(x, [l1, way1, l2, way2])))
        },
    ));
    all.extend(on(
        subject,
        "tent",
        [amplitude("L", 1e4), inside("x"), inside("y"), inside("z"), two()],
        |[slope, x, y, z, _]| Some((tent(1.0, slope)?, vec![[x], [y], [z]])),
    ));
    all.extend(on(
        subject,
        "incline",
        [amplitude("L", 1e4), inside("x"), inside("y"), inside("z"), two()],
        |[slope, x, y, z, _]| Some((Incline::new(1.0, slope)?, vec![[x], [y], [z]])),
    ));
    all.extend(on(
        subject,
        "valleys",
        [phase("x1"), step("step1"), direction("phi1"), step("step2"), direction("phi2"), two()],
        |[x1, l1, phi1, l2, phi2, _]| Some((Valleys, two_steps([x1, 0.0], [l1, phi1, l2, phi2]))),
    ));
    all
}

/// The largest relative amplitude. It may be close to 1, since the rules do not divide by anything
/// that vanishes there.
const MOST: f64 = 0.9999;

/// Returns three points: `from`, the point after the first step and the point after the second.
fn two_steps(from: [f64; 2], [l1, phi1, l2, phi2]: [f64; 4]) -> Vec<[f64; 2]> {
    let middle = beside(from, l1, phi1);
    vec![from, middle, beside(middle, l2, phi2)]
}

fn two_steps_on_the_line(from: f64, [l1, way1, l2, way2]: [f64; 4]) -> Vec<[f64; 1]> {
    let middle = from + along(l1, way1);
    vec![[from], [middle], [middle + along(l2, way2)]]
}
