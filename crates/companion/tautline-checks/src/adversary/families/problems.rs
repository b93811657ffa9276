//! Families of problems whose distance is known, for statements about discrete minimisers.

use std::f64::consts::{FRAC_PI_2, PI};

use tautline::{
    Bounded, Ends, FiniteSet, KnownDistance,
    gallery::{Ramp, Separable, Shear, Valleys},
};
use tautline_statements::{
    Known, PaperRule, Reconstruction, Subject,
    witnesses::{self, Incline, Polygonal, tent},
};

use super::{
    super::{Beyond, Family, Parameter},
    about_problems::AboutProblem,
    ranges::{
        along, amplitude, anchor, anchored, any_step, beside, direction, n, on_the_ramp, part,
        phase, ratio_of_waves, share, shared, step, step_of_waves, wave_numbers, way,
    },
};

/// Returns a family for each statement, all on the same box. `problem` depends on the rule, because
/// a rule is misled at the points where it evaluates `H`. A statement about both rules has a second
/// family, for the left-endpoint rule, which has the second name.
fn on<'a, M: Bounded<D> + 'a, const D: usize, const P: usize>(
    subject: &'a Subject,
    [name, left]: [&'static str; 2],
    statements: impl IntoIterator<Item = Vec<AboutProblem<M, D>>>,
    parameters: [Parameter; P],
    problem: impl Fn(PaperRule, [f64; P]) -> Option<(Known<M, D>, f64)> + Copy + 'a,
) -> Vec<Family<'a>> {
    let family = |about: AboutProblem<M, D>| {
        let AboutProblem { statement, rule, is_second, evidence } = about;
        Family::new(if is_second { left } else { name }, statement, parameters, move |values| {
            let Some((known, n)) = problem(rule, values) else { return Ok(None) };
            let seen = Reconstruction::observe(subject, &known, rule, n as usize)?;
            evidence(subject, &known, &seen)
        })
    };
    statements.into_iter().flatten().map(family).collect()
}

/// Pairs the problem between two points, whose distance the metric knows, with `N`.
fn between<M, const D: usize>(
    metric: M,
    a: [f64; D],
    b: [f64; D],
    n: f64,
) -> Option<(Known<M, D>, f64)>
where
    M: Bounded<D> + KnownDistance<D>,
{
    Some((Known::between(metric, a, b).ok()??, n))
}

pub(super) fn of_problems(subject: &Subject) -> Vec<Family<'_>> {
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
        [amplitude("a", 100.0), phase("x2"), step("step"), direction("phi"), n()],
        |_, [a, x2, step, phi, n]| {
            let from = [0.0, x2];
            between(Shear::new(a, 1.0).ok()?, from, beside(from, n * step, phi), n)
        },
    );
    all.extend(on(
        subject,
        ["separable, D = 1", "separable, D = 1, left"],
        [AboutProblem::of_the_paper(), AboutProblem::ceiling(), AboutProblem::second_order()],
        [part("a", 0.9), phase("x"), step("step"), way("way"), n()],
        |_, [a, x, step, way, n]| {
            between(Separable::new([a], [1.0]).ok()?, [x], [x + along(n * step, way)], n)
        },
    ));
    all.extend(on(
        subject,
        ["separable, D = 2", "separable, D = 2, left"],
        [AboutProblem::of_the_paper()],
        [
            part("a", 0.9),
            share(),
            ratio_of_waves(),
            phase("k1x1"),
            phase("k2x2"),
            step_of_waves(),
            direction("phi"),
            n(),
        ],
        |_, [a, psi, ratio, phase1, phase2, step, phi, n]| {
            let k = wave_numbers(ratio);
            let from = [phase1 / k[0], phase2 / k[1]];
            between(Separable::new(shared(a, psi), k).ok()?, from, beside(from, n * step, phi), n)
        },
    ));
    all.extend(on(
        subject,
        ["ramp", "ramp, left"],
        [AboutProblem::of_the_paper(), AboutProblem::speeds()],
        [part("a", 0.99), on_the_ramp(), anchor(), any_step(1e3), way("way"), n()],
        |_, [a, x, anchor, step, way, n]| {
            // Near an end of a longer chord, a ramp falls between the nodes of a quadrature.
            let seen = n * step <= 300.0 || (n == 1.0 && anchor.floor() == 1.0);
            let [from, to] = anchored(x, anchor, n * step, way);
            let metric = seen.then(|| Ramp::new(a, 1.0).ok())?;
            between(metric?, [from], [to], n)
        },
    ));
    // With one chord, the rule evaluates `H` at the kink in the middle. With two chords, the search
    // would first have to find the kink.
    all.extend(on(
        subject,
        ["tent", "tent, left"],
        [AboutProblem::of_the_paper()],
        [amplitude("L", 1e4), Parameter::subintervals(1)],
        |_, [slope, n]| between(tent(1.0, slope)?, [0.0], [1.0], n),
    ));
    all.extend(on(
        subject,
        ["incline", "incline, left"],
        [AboutProblem::of_the_paper(), AboutProblem::first_order()],
        [amplitude("L", 1e4), n()],
        |_, [slope, n]| between(Incline::new(1.0, slope)?, [0.0], [1.0], n),
    ));
    all.extend(on(
        subject,
        ["valleys", "valleys, left"],
        [AboutProblem::of_the_paper(), AboutProblem::second_order()],
        [phase("x1"), any_step(1e2), direction("phi"), n()],
        |_, [x1, step, phi, n]| {
            // On a chord over more valleys, the quadrature gives up.
            if n * step > 130.0 {
                return None;
            }
            let from = [x1, 0.0];
            between(Valleys, from, beside(from, n * step, phi), n)
        },
    ));
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
            amplitude("L", 10.0),
            turn("a1"),
            turn("a2"),
            turn("b1"),
            turn("b2"),
            lead(1e-7),
            Parameter::subintervals(1),
        ],
        two_routes,
    ));
    all.extend(on(
        subject,
        ["two arcs", "two arcs, left"],
        [AboutProblem::ceiling(), AboutProblem::second_order()],
        [
            part("a", 0.9),
            // Two arcs of length π, about the crest and about the trough, would meet.
            Parameter::logarithmic("length", 1e-2, PI)
                .with_ends(Beyond::Limit("length → 0"), Beyond::Nothing("the arcs would meet")),
            lead(1e-8),
            Parameter::subintervals(1),
        ],
        |_, values| two_arcs(values),
    ));
    all
}

/// A slope as a fraction of the steepest slope.
fn turn(name: &'static str) -> Parameter {
    let beyond = Beyond::Nothing("|H′| ≤ L");
    Parameter::linear(name, -1.0, 1.0).with_ends(beyond, beyond)
}

/// The relative amount by which the rule prefers the wrong one of two ways.
fn lead(least: f64) -> Parameter {
    Parameter::fraction("lead", least, 0.99)
        .with_ends(Beyond::Limit("lead → 0"), Beyond::Limit("lead → 1"))
}

/// Returns a problem in which one chord may follow either of two arcs under `H = (1 + a sin x)²`.
/// One arc is centred at the crest and has the given length; the other is centred at the trough. To
/// the trapezoidal rule, the energy of the second seems smaller by the relative `lead`.
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
    // The estimate is the same as in `Known::between`.
    let size = (trough + other + crest) * (1.0 + a);
    let distance_error = 16.0 * f64::EPSILON * size;
    Some((Known { metric, ends, distance, distance_error }, n))
}

/// Returns a problem in which one chord may follow either of two routes. The halves of the first
/// route have the slopes `a₁L` and `a₂L`, the halves of the second `b₁L` and `b₂L`. The least value
/// of `H` on the first route is 1. Where the rule evaluates `H`, the second route is lower by
/// `lead L`.
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
