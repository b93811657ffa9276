//! Families of problems whose distance is known, for statements about discrete minimisers.

use std::f64::consts::FRAC_PI_2;

use tautline::{
    Bounded, Ends, FiniteSet, KnownDistance, SVector,
    gallery::{Ramp, Separable, Shear, Valleys},
};

use super::{
    super::{Family, Parameter},
    about_problems::AboutProblem,
};
use crate::{
    Known, PaperRule, Reconstruction, Subject,
    witnesses::{self, Incline, Polygonal, tent},
};

/// Statements on one box; `problem` takes the rule too, since what misleads a rule depends on where
/// it reads. What a statement about both rules says of the left-endpoint one has the second name.
fn on<'a, S: Subject, M: Bounded<D> + 'a, const D: usize, const P: usize>(
    subject: &'a S,
    [name, left]: [&'static str; 2],
    statements: impl IntoIterator<Item = Vec<AboutProblem<S, M, D>>>,
    parameters: [Parameter; P],
    problem: impl Fn(PaperRule, [f64; P]) -> Option<(Known<M, D>, f64)> + Copy + 'a,
) -> Vec<Family<'a>> {
    let family = |about: AboutProblem<S, M, D>| {
        let AboutProblem { statement, rule, is_second, evidence } = about;
        Family::new(if is_second { left } else { name }, statement, parameters, move |values| {
            let Some((known, n)) = problem(rule, values) else { return Ok(None) };
            let seen = Reconstruction::observe(subject, &known, rule, n as usize)?;
            evidence(subject, &known, &seen)
        })
    };
    statements.into_iter().flatten().map(family).collect()
}

/// Two points whose distance the metric knows, and `N`; at least a tenth of the unit of
/// coordinates apart, so that what is observed is more than the rounding of the ends.
fn between<M, const D: usize>(
    metric: M,
    a: [f64; D],
    b: [f64; D],
    n: f64,
) -> Option<(Known<M, D>, f64)>
where
    M: Bounded<D> + KnownDistance<D>,
{
    let apart = (SVector::from(a) - SVector::from(b)).norm();
    let known = (apart >= 0.1).then(|| Known::between(metric, a, b).ok()).flatten();
    Some((known??, n))
}

/// `N`: what is tight is so for few subintervals, since the bounds fall like `1/√N`.
fn n() -> Parameter {
    Parameter::whole("N", 1, 8)
}

pub(super) fn families<S: Subject>(subject: &S) -> Vec<Family<'_>> {
    let coordinate = |name| Parameter::linear(name, -3.0, 3.0);
    let slope = || Parameter::logarithmic("L", 1e-3, 10.0);
    let mut all = on(
        subject,
        ["shear", "shear, left"],
        [
            AboutProblem::of_the_paper(),
            AboutProblem::speeds(),
            AboutProblem::ceiling(),
            AboutProblem::first_order(),
            AboutProblem::second_order(),
            AboutProblem::enclosure(),
        ],
        [
            Parameter::logarithmic("a", 1e-3, 0.8),
            coordinate("x2"),
            coordinate("y1"),
            coordinate("y2"),
            n(),
        ],
        |_, [a, x2, y1, y2, n]| between(Shear::new(a, 1.0).ok()?, [0.0, x2], [y1, y2], n),
    );
    all.extend(on(
        subject,
        ["separable, D = 1", "separable, D = 1, left"],
        [AboutProblem::of_the_paper(), AboutProblem::ceiling(), AboutProblem::second_order()],
        [Parameter::logarithmic("a", 1e-3, 0.6), coordinate("x"), coordinate("y"), n()],
        |_, [a, x, y, n]| between(Separable::new([a], [1.0]).ok()?, [x], [y], n),
    ));
    all.extend(on(
        subject,
        ["separable, D = 2", "separable, D = 2, left"],
        [AboutProblem::of_the_paper()],
        [
            Parameter::logarithmic("a1", 1e-3, 0.6),
            Parameter::logarithmic("a2", 1e-3, 0.6),
            Parameter::logarithmic("k2", 0.5, 2.0),
            coordinate("x1"),
            coordinate("x2"),
            coordinate("y1"),
            coordinate("y2"),
            n(),
        ],
        |_, [a1, a2, k2, x1, x2, y1, y2, n]| {
            between(Separable::new([a1, a2], [1.0, k2]).ok()?, [x1, x2], [y1, y2], n)
        },
    ));
    all.extend(on(
        subject,
        ["ramp", "ramp, left"],
        [AboutProblem::of_the_paper(), AboutProblem::speeds()],
        [Parameter::logarithmic("a", 1e-3, 0.7), coordinate("x"), coordinate("y"), n()],
        |_, [a, x, y, n]| between(Ramp::new(a, 1.0).ok()?, [x], [y], n),
    ));
    // Kinked in the middle, where one chord reads it and two chords would search it.
    all.extend(on(
        subject,
        ["tent", "tent, left"],
        [AboutProblem::of_the_paper()],
        [slope(), Parameter::subintervals(1)],
        |_, [slope, n]| between(tent(1.0, slope)?, [0.0], [1.0], n),
    ));
    all.extend(on(
        subject,
        ["incline", "incline, left"],
        [AboutProblem::of_the_paper(), AboutProblem::first_order()],
        [slope(), n()],
        |_, [slope, n]| between(Incline::new(1.0, slope)?, [0.0], [1.0], n),
    ));
    all.extend(on(
        subject,
        ["valleys", "valleys, left"],
        [AboutProblem::of_the_paper(), AboutProblem::second_order()],
        [
            coordinate("x1"),
            Parameter::linear("y1", -10.0, 10.0),
            Parameter::linear("y2", 0.0, 3.0),
            n(),
        ],
        |_, [x1, y1, y2, n]| between(Valleys, [x1, 0.0], [y1, y2], n),
    ));
    let turn = |name| Parameter::linear(name, -1.0, 1.0);
    all.extend(on(
        subject,
        ["two routes", "two routes, left"],
        [
            AboutProblem::of_the_paper(),
            AboutProblem::ceiling(),
            AboutProblem::first_order(),
            AboutProblem::enclosure(),
        ],
        [
            slope(),
            turn("a1"),
            turn("a2"),
            turn("b1"),
            turn("b2"),
            Parameter::logarithmic("lead", 1e-9, 1e-1),
            Parameter::subintervals(1),
        ],
        two_routes,
    ));
    all.extend(on(
        subject,
        ["two arcs", "two arcs, left"],
        [AboutProblem::ceiling(), AboutProblem::second_order()],
        [
            Parameter::logarithmic("a", 1e-4, 0.5),
            Parameter::logarithmic("length", 0.1, 1.5),
            Parameter::logarithmic("lead", 1e-8, 1e-1),
            Parameter::subintervals(1),
        ],
        |_, values| two_arcs(values),
    ));
    all
}

/// Two arcs for one chord under `H = (1 + a sin x)²`: one about the crest, of this length, and one
/// about the trough, whose energy the trapezoidal rule takes for less by the part `lead`.
fn two_arcs([a, length, lead, n]: [f64; 4]) -> Option<(Known<Separable<1>, 1>, f64)> {
    let metric = Separable::new([a], [1.0]).ok()?;
    let (crest, trough) = (FRAC_PI_2, 3.0 * FRAC_PI_2);
    let other = length * (1.0 - lead).sqrt() * (1.0 + a) / (1.0 - a);
    let from = [crest - 0.5 * length, trough - 0.5 * other];
    let to = [crest + 0.5 * length, trough + 0.5 * other];
    let set = |[x, y]: [f64; 2]| FiniteSet::new([[x], [y]]).ok();
    let ends = Ends::new(set(from)?, set(to)?).ok()?;
    let of = |x: f64, y: f64| Some(Known::between(metric, [x], [y]).ok()??.distance);
    let mut distance = f64::INFINITY;
    for x in from {
        for y in to {
            distance = distance.min(of(x, y)?);
        }
    }
    // As in `Known::between`.
    let size = (trough + other + crest) * (1.0 + a);
    let distance_error = 16.0 * f64::EPSILON * size;
    Some((Known { metric, ends, distance, distance_error }, n))
}

/// Two routes for one chord: on the halves of the first one the slopes `a₁L` and `a₂L`, on those of
/// the second one `b₁L` and `b₂L`; the least value on the first is 1, and where the rule reads it,
/// the second one is ahead by `lead L`.
fn two_routes(
    rule: PaperRule,
    [l, a1, a2, b1, b2, lead, n]: [f64; 7],
) -> Option<(Known<Polygonal, 1>, f64)> {
    let profile = |first: f64, second: f64| [0.0, 0.5 * first * l, 0.5 * (first + second) * l];
    let (first, second) = (profile(a1, a2), profile(b1, b2));
    let read = match rule {
        PaperRule::Trapezoidal => 1,
        PaperRule::LeftEndpoint => 0,
    };
    let least = first.iter().copied().fold(f64::INFINITY, f64::min);
    let first = first.map(|height| 1.0 + height - least);
    let ahead = first[read] - second[read] - lead * l;
    let knots = |[a, b, c]: [f64; 3]| [[0.0, a], [0.5, b], [1.0, c]];
    let second = second.map(|height| height + ahead);
    Some((witnesses::two_routes(&knots(first), &knots(second))?, n))
}
