//! Section 6: the least energy is the square of the distance, between points and between sets.

use nalgebra::SVector;
use tautline::{Bounded, KnownDistance, PointSequence};
use tautline_statements::{
    Evidence, Known, LIBRARY, NearestPair, PaperRule, Reconstruction,
    Statement::{self, Proposition6_1, Proposition6_2, Proposition6_3},
    Subject, Unit, VerifyError, WayOut,
    curves::{Geodesic, Measured, Reparametrised},
    prop_6_1, prop_6_1_attained, prop_6_1_minimiser, prop_6_2, prop_6_3, prop_6_3_attained,
};

use crate::battery::{
    cases::admissible,
    harness::{Check, Homogeneous, Outcome, Random, Trial, Witness, for_all},
};
use crate::strategies::{
    clock, constant, constant_ball_half_space, constant_finite_sets, in_hyperbolic_space, joined,
    on_sphere, points, ramp, separable, separable_boxes, sequence, shear, shear_ball_half_plane,
    valleys_across, valleys_along, valleys_ball_half_space, vector,
};

const P61: &[Statement] = &[Proposition6_1];
const P62: &[Statement] = &[Proposition6_2];
const P63: &[Statement] = &[Proposition6_3];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("prop_6_1_holds_for_random_polygons", P61, polygons),
    Random.check("prop_6_1_holds_for_geodesics_run_through_by_any_clock", P61, clocks),
    Homogeneous.check("prop_6_1_is_homogeneous", P61, |trial| {
        let cases = (points(shear()), sequence(4.0));
        trial.homogeneous(6120, 96, cases, |subject, (known, sequence), units| {
            polygon(subject, &units.known(known)?, units.sequence(&sequence)?, prop_6_1)
        })
    }),
    Witness.check("prop_6_1_is_attained_by_minimal_geodesics", P61, attained),
    Witness.check(
        "prop_6_1_is_attained_by_straight_lines_of_constant_metrics",
        P61,
        straight_lines,
    ),
    Random.check("prop_6_2_holds_for_computed_pairs", P62, pairs),
    Homogeneous.check("prop_6_2_is_homogeneous", P62, |trial| {
        let cases = (constant_ball_half_space::<2>(), vector(4.0));
        trial.homogeneous(6220, 64, cases, |subject, (known, probe), units| {
            nearest(subject, &units.known(known)?, units.vector(probe))
        })
    }),
    Witness.check("prop_6_2_is_attained_by_finite_sets", P62, |trial| {
        let cases = (constant_finite_sets(), vector(4.0));
        trial.for_all(6230, 128, cases, |subject, (known, probe)| {
            let [evidence] = nearest(subject, &known, probe)?;
            Ok([evidence.attained()?])
        })
    }),
    Random.check("prop_6_3_holds_for_random_polygons", P63, set_polygons),
    Homogeneous.check("prop_6_3_is_homogeneous", P63, |trial| {
        let cases = (shear_ball_half_plane(), sequence(4.0));
        trial.homogeneous(6320, 96, cases, |subject, (known, sequence), units| {
            polygon(subject, &units.known(known)?, units.sequence(&sequence)?, prop_6_3)
        })
    }),
    Witness.check("prop_6_3_is_attained_between_a_ball_and_a_half_space", P63, nearest_lines),
];

/// Proposition 6.1 or 6.3, which have the same signature.
type OfCurve<M, const D: usize> = fn(&Subject, &Known<M, D>, &Measured<D>) -> Evidence;

/// Evaluates one of these propositions on a random polygon that minimises nothing.
fn polygon<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    sequence: PointSequence<D>,
    statement: OfCurve<M, D>,
) -> Result<[Evidence; 1], VerifyError> {
    let sequence = admissible(&LIBRARY, &known.ends, sequence)?;
    let seen = Measured::of_sequence(subject, &known.metric, &sequence);
    Ok([statement(subject, known, &seen)])
}

fn polygons(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        192,
        [
            (6101, (points(constant::<3>()), sequence(4.0))),
            (6102, (points(shear()), sequence(4.0))),
            (6103, (points(separable::<3>()), sequence(4.0))),
            (6104, (points(ramp()), sequence(4.0))),
            (6105, (valleys_along(), sequence(4.0))),
            (6106, (valleys_across::<2>(), sequence(4.0))),
        ],
        |subject, (known, sequence)| polygon(subject, &known, sequence, prop_6_1)
    )
}

fn set_polygons(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        192,
        [
            (6301, (constant_ball_half_space::<3>(), sequence(4.0))),
            (6302, (constant_finite_sets(), sequence(4.0))),
            (6303, (shear_ball_half_plane(), sequence(4.0))),
            (6304, (separable_boxes::<1>(), sequence(4.0))),
            (6305, (separable_boxes::<2>(), sequence(4.0))),
            (6306, (valleys_ball_half_space(), sequence(4.0))),
        ],
        |subject, (known, sequence)| polygon(subject, &known, sequence, prop_6_3)
    )
}

/// `E(γ** ∘ φ) = d² ∫φ′²`, which is at least `d²`.
fn clocks(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        128,
        [
            (6111, (joined(shear()), clock())),
            (6112, (joined(separable::<2>()), clock())),
            (6113, (on_sphere::<2>(), clock())),
            (6114, (in_hyperbolic_space::<3>(), clock())),
        ],
        |subject, ((metric, ends), clock)| {
            let known = Known::joined(&metric, ends)?.expect("known");
            let curve = Reparametrised { curve: &Geodesic::between(&metric, ends), clock: &clock };
            let seen = Measured::of(&metric, &curve);
            let exact = known.distance.powi(2) * clock.energy();
            let granted = seen.granted_energy()
                + 2.0 * known.distance * known.distance_error * clock.energy();
            let off = [(seen.energy.value - exact).abs(), 0.0];
            let claim = "|E(γ** ∘ φ) − d² ∫φ′²| = 0";
            Ok([prop_6_1(subject, &known, &seen).sharper(claim, Unit::ENERGY, off, granted)])
        }
    )
}

/// Requires that both inequalities are attained, not only the tighter one.
fn both_attained(evidence: Evidence) -> Result<Evidence, VerifyError> {
    let overestimation =
        evidence.conclusions.iter().map(|claim| claim.overestimation()).fold(0.0, f64::max);
    let statement = evidence.statement;
    if overestimation <= 1.01 {
        Ok(evidence)
    } else {
        Err(VerifyError::NotAttained { statement, overestimation, known: 1.01 })
    }
}

fn attained(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        96,
        [
            (6131, joined(shear())),
            (6132, joined(separable::<3>())),
            (6133, on_sphere::<3>()),
            (6134, in_hyperbolic_space::<2>()),
        ],
        |subject, (metric, ends)| {
            let known = Known::joined(&metric, ends)?.expect("known");
            let curve = Geodesic::between(&metric, ends);
            let seen = Measured::of(&metric, &curve);
            let of_all = [
                both_attained(prop_6_1(subject, &known, &seen))?,
                prop_6_1_minimiser(subject, &known, &curve)?.attained()?,
            ];
            // The sphere lacks a point, so only near points are certain to be joined by a shortest
            // curve.
            let way_out = WayOut::from(&metric, &ends[0]);
            let near = way_out.exceeds(known.distance);
            let shown = near.then(|| prop_6_1_attained(subject, &known, &seen, way_out));
            let shown = shown.map(Evidence::attained).transpose()?;
            Ok(of_all.into_iter().chain(shown))
        }
    )
}

/// The curves are straight lines divided into equal chords.
fn straight_lines(trial: &Trial<'_>) -> Outcome {
    let cases = (points(constant::<3>()), 1..40_usize);
    trial.for_all(6140, 96, cases, |subject, (known, n)| {
        let origin = SVector::zeros();
        let [a, b] = [known.ends.first(), known.ends.second()].map(|set| set.project(&origin));
        let line = PointSequence::straight(a, b, n)?;
        let seen = Measured::of_sequence(subject, &known.metric, &line);
        Ok([both_attained(prop_6_1(subject, &known, &seen))?])
    })
}

/// Evaluates Proposition 6.2 for the ends of the trapezoidal minimiser with `N = 8`. They are
/// compared with the projections of one more point to both sets.
fn nearest<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    probe: SVector<f64, D>,
) -> Result<[Evidence; 1], VerifyError>
where
    M: Bounded<D> + KnownDistance<D>,
{
    let seen = Reconstruction::observe(subject, known, PaperRule::Trapezoidal, 8)?;
    let metric = &known.metric;
    let ends = &seen.minimum.sequence;
    // If the metric does not know this distance, the length of a curve that joins the two points is
    // used.
    let apart = metric.distance(ends.first(), ends.last());
    let apart = apart.unwrap_or_else(|| seen.length_squared.value.sqrt());
    let other =
        [known.ends.first(), known.ends.second()].map(|set| subject.project(&**set, &probe));
    let mut pair = NearestPair::of(subject, known, &seen, apart)?;
    if let Some(other) = metric.distance(&other[0], &other[1]) {
        pair = pair.beside(other);
    }
    Ok([prop_6_2(&pair, subject.constants(metric).c1())])
}

fn pairs(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        160,
        [
            (6201, (constant_ball_half_space::<2>(), vector(4.0))),
            (6202, (constant_ball_half_space::<3>(), vector(4.0))),
            (6203, (constant_finite_sets(), vector(4.0))),
            (6204, (shear_ball_half_plane(), vector(4.0))),
            (6205, (separable_boxes::<2>(), vector(4.0))),
            (6206, (separable_boxes::<3>(), vector(4.0))),
            (6207, (valleys_ball_half_space(), vector(4.0))),
        ],
        |subject, (known, probe)| nearest(subject, &known, probe)
    )
}

/// Under a constant metric the trapezoidal minimiser is the straight line between a nearest pair.
fn nearest_lines(trial: &Trial<'_>) -> Outcome {
    trial.for_all(6330, 128, constant_ball_half_space::<3>(), |subject, known| {
        let seen = Reconstruction::observe(subject, &known, PaperRule::Trapezoidal, 2)?;
        let line = Measured::of_sequence(subject, &known.metric, &seen.minimum.sequence);
        let way_out = WayOut::from(&known.metric, seen.minimum.sequence.first());
        Ok([
            both_attained(prop_6_3(subject, &known, &line))?,
            prop_6_3_attained(subject, &known, &line, way_out).attained()?,
        ])
    })
}
