//! Section 9: squared lengths are bounded by energies. The module also checks our answer to the
//! question of rates that the paper leaves open.

use std::f64::consts::{PI, TAU};

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{Bounded, Ends, FiniteSet, PointSequence, gallery::Constant};
use tautline_statements::{
    Evidence, Known, LIBRARY, PaperRule, Reconstruction,
    Statement::{self, Proposition9_1, Remark9_2},
    Subject, VerifyError,
    curves::{Clock, Geodesic, KnownGeodesics, Measured, Pace, Reparametrised},
    prop_9_1, prop_9_1_as_printed, remark_9_2,
    witnesses::{Polygonal, Washboard, two_routes},
};

use crate::battery::{
    cases::admissible,
    harness::{
        Check, Homogeneous, Outcome, Random, Refuted, Trial, Witness, all, close, for_all, refuted,
    },
};
use crate::strategies::{
    constant, constant_ball_half_space, constant_finite_sets, in_hyperbolic_space, joined,
    on_sphere, points, ramp, separable, separable_boxes, sequence, shear, shear_ball_half_plane,
    subintervals, valleys_across, valleys_ball_half_space, vector,
};

const P91: &[Statement] = &[Proposition9_1];
const R92: &[Statement] = &[Remark9_2];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_9_1_repaired_holds_between_points", P91, between),
    Random.check("prop_9_1_repaired_holds_from_set_to_set", P91, sets),
    Homogeneous.check("prop_9_1_is_homogeneous", P91, |trial| {
        let cases = (joined(shear()), sequence(3.0));
        trial.homogeneous(9120, 96, cases, |subject, ((metric, ends), sequence), units| {
            let sequence = units.sequence(&sequence)?;
            let (metric, ends) = (units.metric(metric), ends.map(|x| units.vector(x)));
            Ok([against_geodesic(subject, &metric, ends, sequence)?])
        })
    }),
    Witness.check("prop_9_1_is_attained_by_curves_of_constant_speed", P91, equal_legs),
    Refuted.check("prop_9_1_refuted_by_a_late_minimiser", P91, refuted_by_a_late_minimiser),
    Random.check("remark_9_2_holds_between_points", R92, rates_between),
    Random.check("remark_9_2_holds_from_set_to_set", R92, rates_of_sets),
    Homogeneous.check("remark_9_2_is_homogeneous", R92, |trial| {
        let cases = (points(shear()), 1..9_usize);
        trial.homogeneous(9220, 64, cases, |subject, (known, n), units| {
            let known = units.known(known)?;
            both_rules(subject, &known, n)
        })
    }),
    Witness.check("remark_9_2_is_attained_by_two_routes", R92, attained_by_two_routes),
    Witness.check(
        "remark_9_2_has_the_best_rate_for_every_number_of_subintervals",
        R92,
        the_rate_is_the_best,
    ),
];

/// Evaluates Proposition 9.1 for a polygon whose ends are moved to the two points, and for the
/// known minimal geodesic between them.
fn against_geodesic<M: KnownGeodesics<D>, const D: usize>(
    subject: &Subject,
    metric: &M,
    ends: [SVector<f64, D>; 2],
    sequence: PointSequence<D>,
) -> Result<Evidence, VerifyError> {
    let known = Known::joined(metric, ends)?.expect("known");
    let sequence = admissible(&LIBRARY, &known.ends, sequence)?;
    let curve = Measured::of_sequence(subject, metric, &sequence);
    let minimiser = Measured::of(metric, &Geodesic::between(metric, ends));
    Ok(prop_9_1(subject, &known, &curve, &minimiser))
}

fn between(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        160,
        [
            (9101, (joined(constant::<3>()), sequence(3.0))),
            (9102, (joined(shear()), sequence(3.0))),
            (9103, (joined(separable::<1>()), sequence(3.0))),
            (9104, (joined(separable::<3>()), sequence(3.0))),
            (9105, (on_sphere::<2>(), sequence(1.0))),
            // The polygon has to stay in the ball.
            (9106, (in_hyperbolic_space::<3>(), sequence(0.5))),
        ],
        |subject, ((metric, ends), sequence)| {
            Ok([against_geodesic(subject, &metric, ends, sequence)?])
        }
    )
}

/// Under a constant metric the energy of the computed minimiser is `d²`, up to rounding.
fn sets(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        192,
        [
            (9111, (constant_ball_half_space::<2>(), sequence(3.0))),
            (9112, (constant_ball_half_space::<3>(), sequence(3.0))),
            (9113, (constant_finite_sets(), sequence(3.0))),
        ],
        |subject, (known, sequence)| {
            let seen = Reconstruction::observe(subject, &known, PaperRule::Trapezoidal, 3)?;
            let minimiser = Measured::of_sequence(subject, &known.metric, &seen.minimum.sequence);
            let sequence = admissible(&LIBRARY, &known.ends, sequence)?;
            let curve = Measured::of_sequence(subject, &known.metric, &sequence);
            Ok([prop_9_1(subject, &known, &curve, &minimiser)])
        }
    )
}

/// The polygon consists of the two equal legs of a triangle, under a multiple of the Euclidean
/// metric.
fn equal_legs(trial: &Trial<'_>) -> Outcome {
    let cases = (0.1..10.0, vector::<2>(2.0), vector::<2>(1.0), 0.1..3.0)
        .prop_filter("a base", |(_, _, half, _)| half.norm() >= 0.1);
    trial.for_all(9130, 128, cases, |subject, (factor, top, half, height): (f64, _, _, f64)| {
        let metric = Constant::new(SMatrix::from_diagonal_element(factor)).expect("positive");
        let across = SVector::from([-half[1], half[0]]) * height;
        let ends: [SVector<f64, 2>; 2] = [top + across - half, top + across + half];
        let sequence = PointSequence::new(vec![ends[0], top, ends[1]])?;
        Ok([against_geodesic(subject, &metric, ends, sequence)?.attained()?])
    })
}

/// Returns two curves of the same length from 0 to 1 on the line with `H = 1`: `γ = t` and
/// `γ* = t²`.
pub(super) fn late() -> Result<(Known<Constant<1>, 1>, Measured<1>, Measured<1>), VerifyError> {
    let metric = Constant::new(SMatrix::identity()).expect("positive definite");
    let ends = [[0.0].into(), [1.0].into()];
    let known = Known::joined(metric, ends)?.expect("known");
    let line = Geodesic::between(metric, ends);
    let clock = Clock::plain(Pace::Accelerating);
    let late = Reparametrised { curve: &line, clock: &clock };
    Ok((known, Measured::of(&metric, &line), Measured::of(&metric, &late)))
}

/// The claim is `0 ≤ 1 − 4/3`, which is false.
fn refuted_by_a_late_minimiser(_: &Trial<'_>) -> Outcome {
    let (known, on_time, late) = late()?;
    let evidence = prop_9_1_as_printed(&LIBRARY, &known, &on_time, &late);
    refuted(&evidence, "L(γ)² − L(γ*)² ≤ E(γ) − E(γ*)", [0.0, -1.0 / 3.0])
}

/// Evaluates the answer to Remark 9.2 for the minimisers of both rules.
fn both_rules<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    n: usize,
) -> Result<[Evidence; 2], VerifyError> {
    let [trapezoidal, left] =
        PaperRule::BOTH.map(|rule| Reconstruction::observe(subject, known, rule, n));
    Ok([remark_9_2(subject, &trapezoidal?), remark_9_2(subject, &left?)])
}

fn rates_between(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        [
            (9201, 128, (points(shear()), subintervals())),
            (9202, 96, (points(separable::<1>()), subintervals())),
            (9203, 64, (points(separable::<3>()), subintervals())),
            (9204, 128, (points(ramp()), subintervals())),
            (9205, 96, (valleys_across::<2>(), subintervals())),
        ],
        |subject, (known, n)| both_rules(subject, &known, n)
    )
}

fn rates_of_sets(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        [
            (9211, 96, (shear_ball_half_plane(), subintervals())),
            (9212, 64, (separable_boxes::<2>(), subintervals())),
            (9213, 64, (valleys_ball_half_space(), subintervals())),
        ],
        |subject, (known, n)| both_rules(subject, &known, n)
    )
}

/// With `N = 1` the rule prefers the second route by a hair, since it evaluates the metric at its
/// smallest value on the second route and at its largest value on the first. As `δ → 0`, the excess
/// is `d² δ/2` for the trapezoidal rule and `d² δ` for the left rule, which equals the bound.
///
/// Another program computed the ratios of the excess to these values for slopes of 1, 0.1, 0.01 and
/// 0.001.
fn attained_by_two_routes(trial: &Trial<'_>) -> Outcome {
    let tents = |l: f64, hair: f64| {
        let (top, low) = (1.0 + 0.5 * l, 1.0 + 0.5 * l - hair);
        let ridge = [[0.0, 1.0], [0.5, top], [1.0, 1.0]];
        let valley = [[0.0, low + 0.5 * l], [0.5, low], [1.0, low + 0.5 * l]];
        two_routes(&ridge, &valley).expect("apart")
    };
    let inclines = |l: f64, hair: f64| {
        let falling = [[0.0, 1.0 + l], [1.0, 1.0]];
        let rising = [[0.0, 1.0 + l - hair], [1.0, 1.0 + 2.0 * l - hair]];
        two_routes(&falling, &rising).expect("apart")
    };
    let slopes =
        [(1.0, 0.725, 0.560), (0.1, 0.965, 0.932), (0.01, 0.9964, 0.993), (0.001, 0.9996, 0.9993)];
    all(slopes.into_iter().flat_map(|(l, trapezoidal, left)| {
        let hair = 1e-6 * l;
        [
            excess_is(trial, tents(l, hair), PaperRule::Trapezoidal, l, 0.5, trapezoidal),
            excess_is(trial, inclines(l, hair), PaperRule::LeftEndpoint, l, 1.0, left),
        ]
    }))
}

/// Compares the ratio of the excess to `d² δ` times the leading constant with `ratio`, for one pair
/// of routes.
fn excess_is(
    trial: &Trial<'_>,
    known: Known<Polygonal, 1>,
    rule: PaperRule,
    slope: f64,
    constant: f64,
    ratio: f64,
) -> Outcome {
    let seen = Reconstruction::observe(trial.subject, &known, rule, 1)?;
    let excess = seen.energy.value - seen.distance_squared;
    // c₁ = 1, hence δ = L d.
    let leading = constant * slope * known.distance.powi(3);
    // The ratios are given to three digits, or to four if they are close to 1; the hair is 10⁻⁶.
    close(&format!("L = {slope}: the ratio"), excess / leading, ratio, 6e-4)?;
    let evidence = remark_9_2(trial.subject, &seen);
    trial.one([if slope <= 0.001 { evidence.attained()? } else { evidence }])
}

/// Returns the amount by which `H` on the even route exceeds 1, in `m²/ℓ²`: a thousandth of the
/// mean corrugation.
fn lift(n: u32, slope: f64) -> f64 {
    1e-3 * slope / (TAU * f64::from(n))
}

/// Returns the washboard with `n` valleys, and the problem from `{0, 100}` to `{1, 101}`, for which
/// `d² = 1 + η`.
pub(super) fn washboard(
    n: u32,
    slope: f64,
) -> Result<(Washboard, Known<Washboard, 1>), VerifyError> {
    let metric = Washboard::new(n, slope, lift(n, slope)).expect("positive");
    let ends = Ends::new(FiniteSet::new([[0.0], [100.0]])?, FiniteSet::new([[1.0], [101.0]])?)?;
    let distance = (1.0 + lift(n, slope)).sqrt();
    Ok((metric, Known { metric, ends, distance, distance_error: 4.0 * f64::EPSILON }))
}

/// With a different washboard for each `N`, `N (E(γᵖˡ) − d²) = L/2π − Nη` does not decrease,
/// although `c₁`, `L_H` and `d` hardly change. As `δ → 0` the bound is `π` times as large. Here it
/// is a percent larger still, and larger by the factor by which the switch increases `L_H`.
fn the_rate_is_the_best(trial: &Trial<'_>) -> Outcome {
    let slope = 0.01;
    all([1, 2, 3, 5, 8, 17, 64, 200].map(|n: u32| {
        let (metric, known) = washboard(n, slope)?;
        let seen =
            Reconstruction::observe(trial.subject, &known, PaperRule::Trapezoidal, n as usize)?;
        let excess = seen.energy.value - seen.distance_squared;
        let exact = metric.half_height() - lift(n, slope);
        close(&format!("N = {n}: E(γᵖˡ) − d²"), excess, exact, seen.granted)?;
        let overestimation = seen.setting.constants().l_h() / slope * PI;
        trial.one([remark_9_2(trial.subject, &seen).overestimates_at_most(1.01 * overestimation)?])
    }))
}
