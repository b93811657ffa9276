//! Propositions 7.10 to 7.12, `K_{1,g}` and `K_{2,g}`: derivatives of the metric, and of geodesics.

use std::fmt::Debug;

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{
    Bounded, KnownDistance,
    gallery::{Constant, Separable, Valleys},
};
use tautline_statements::{
    Evidence,
    Statement::{self, ConstantK1, ConstantK2, Proposition7_10, Proposition7_11, Proposition7_12},
    Subject, VerifyError, constant_k1, constant_k2,
    curves::{BoundedCurve, Geodesic, SmoothCurve},
    prop_7_10, prop_7_11, prop_7_12,
    witnesses::{Incline, InclineGeodesic, Ripple, Twist},
};

use super::{Check, Kind, Outcome, Trial, check::all};
use crate::strategies::{constant, ramp, separable, shear, two_points, vector};

const POINTWISE: &[Statement] = &[Proposition7_10, Proposition7_11];
const APRIORI: &[Statement] = &[ConstantK1, ConstantK2, Proposition7_12];

pub(super) fn checks() -> Vec<Check> {
    let p710 = &POINTWISE[..1];
    let p711 = &POINTWISE[1..];
    let bend: &[Statement] = &APRIORI[1..];
    vec![
        Check::new("props_7_10_and_7_11_hold_for_random_metrics", Kind::Random, POINTWISE, metrics),
        Check::new(
            "props_7_10_and_7_11_are_homogeneous",
            Kind::Homogeneous,
            POINTWISE,
            homogeneous_metrics,
        ),
        Check::new("prop_7_10_is_attained_by_a_ripple", Kind::Witness, p710, ripples),
        Check::new("prop_7_11_has_the_factor_root_d_over_a_twist", Kind::Witness, p711, twists),
        Check::new("prop_7_11_has_the_factor_three_on_the_line", Kind::Witness, p711, inclines),
        Check::new("prop_7_12_holds_for_minimal_geodesics", Kind::Random, APRIORI, geodesics),
        Check::new("prop_7_12_is_homogeneous", Kind::Homogeneous, APRIORI, homogeneous_geodesics),
        Check::new(
            "k1_is_attained_under_the_least_metric",
            Kind::Witness,
            &[ConstantK1, Proposition7_12],
            attained_k1,
        ),
        Check::new(
            "k2_has_the_factor_d_squared_over_a_twist",
            Kind::Witness,
            bend,
            bent_by_a_twist,
        ),
        Check::new("k2_has_the_factor_three_on_the_line", Kind::Witness, bend, bent_by_an_incline),
    ]
}

/// What an overestimation may be above the best one that is known, for the limits that are taken
/// below.
const NEAR: f64 = 1.01;

fn metrics(trial: &Trial<'_>) -> Outcome {
    fn family<M: Bounded<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        metrics: impl Strategy<Value = M>,
    ) -> Outcome {
        trial.for_all(seed, 256, (metrics, vector(4.0)), |subject, (metric, x)| {
            Ok([prop_7_10(subject, &metric, &x)?, prop_7_11(subject, &metric, &x)?])
        })
    }
    all([
        family(trial, 7101, shear()),
        family(trial, 7102, separable::<1>()),
        family(trial, 7103, separable::<3>()),
        family(trial, 7104, ramp()),
        family(trial, 7105, constant::<2>()),
        family::<_, 2>(trial, 7106, Just(Valleys)),
    ])
}

fn homogeneous_metrics(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(7120, 128, (shear(), vector(4.0)), |subject, (metric, x), units| {
        let (metric, x) = (units.metric(metric), units.vector(x));
        Ok([prop_7_10(subject, &metric, &x)?, prop_7_11(subject, &metric, &x)?])
    })
}

/// `∂ₗ Hᵢⱼ = L` at 0, for every entry and every axis.
fn ripples(trial: &Trial<'_>) -> Outcome {
    fn one<const D: usize>(
        subject: &Subject,
        ([i, j, l], base, slope): ([usize; 3], f64, f64),
    ) -> Result<Evidence, VerifyError> {
        let ripple = Ripple::<D>::new(base, slope, [i, j], l)?;
        prop_7_10(subject, &ripple, &SVector::zeros())?.attained()
    }
    let cases = ([0..3_usize, 0..3_usize, 0..3_usize], 0.3..3.0, 0.1..10.0);
    trial.for_all(7130, 128, cases, |subject, case| {
        Ok([one::<1>(subject, case)?, one::<2>(subject, case)?, one::<3>(subject, case)?])
    })
}

/// `Γ²₁₁ = 3L/2c` at 0, where `c₁ = c − LR` for an `R` as small as one likes: the companion is
/// attained, and what the paper gives away is `√D`.
fn twists(trial: &Trial<'_>) -> Outcome {
    fn one<const D: usize>(
        subject: &Subject,
        (base, slope): (f64, f64),
    ) -> Result<Evidence, VerifyError> {
        let twist = Twist::<D>::new(base, slope, 2e-3 * base / slope)?;
        prop_7_11(subject, &twist, &SVector::zeros())?
            .claim_is_attained("|Γᵏᵢⱼ| ≤ 3 L_H/2c₁", NEAR)?
            .overestimates_at_most((D as f64).sqrt() * NEAR)
    }
    trial.for_all(7131, 128, (0.3..3.0, 0.1..10.0), |subject, case| {
        Ok([one::<2>(subject, case)?, one::<3>(subject, case)?, one::<5>(subject, case)?])
    })
}

/// `Γ = H′/2H` is `L/2c₁` at the foot of an incline.
fn inclines(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7132, 128, (0.3..3.0, 0.1..10.0), |subject, (foot, slope)| {
        let incline = Incline::new(foot, slope).expect("positive");
        let evidence = prop_7_11(subject, &incline, &[0.0].into())?;
        Ok([evidence
            .claim_is_attained("|Γ| ≤ L_H/2c₁", NEAR)?
            .overestimates_at_most(3.0 * NEAR)?])
    })
}

fn evidence<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    distance: f64,
    t: f64,
) -> Result<[Evidence; 3], VerifyError> {
    Ok([
        constant_k1(subject, metric, curve, distance, t)?,
        constant_k2(subject, metric, curve, distance, t)?,
        prop_7_12(subject, metric, curve, distance)?,
    ])
}

fn geodesics(trial: &Trial<'_>) -> Outcome {
    fn separables<const D: usize>(trial: &Trial<'_>, seed: u64) -> Outcome {
        let cases = (separable::<D>(), two_points(2.5), 0.0..1.0);
        trial.for_all(seed, 192, cases, |subject, (metric, ends, t): (Separable<D>, _, _)| {
            let curve = Geodesic::between(metric, ends);
            let distance = metric.distance(&ends[0], &ends[1]).expect("known");
            evidence(subject, &metric, &curve, distance, t)
        })
    }
    fn constants<const D: usize>(trial: &Trial<'_>, seed: u64) -> Outcome {
        let cases = (constant::<D>(), two_points(2.5), 0.0..1.0);
        trial.for_all(seed, 128, cases, |subject, (metric, [a, b], t): (Constant<D>, _, _)| {
            let distance = metric.distance(&a, &b).expect("known");
            evidence(subject, &metric, &SmoothCurve::straight(a, b), distance, t)
        })
    }
    all([
        trial.for_all(
            7140,
            512,
            (shear(), two_points(2.5), 0.0..1.0),
            |subject, (metric, ends, t)| {
                let curve = Geodesic::between(metric, ends);
                let distance = metric.distance(&ends[0], &ends[1]).expect("known");
                evidence(subject, &metric, &curve, distance, t)
            },
        ),
        separables::<1>(trial, 7141),
        separables::<2>(trial, 7142),
        separables::<3>(trial, 7143),
        constants::<2>(trial, 7144),
        constants::<4>(trial, 7145),
    ])
}

fn homogeneous_geodesics(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), two_points(2.5), 0.0..1.0);
    trial.homogeneous(7150, 128, cases, |subject, (metric, ends, t), units| {
        let curve = Geodesic::between(metric, ends);
        let distance = metric.distance(&ends[0], &ends[1]).expect("known") * units.m;
        evidence(subject, &units.metric(metric), &units.curve(curve), distance, t)
    })
}

/// `H = c I`: a straight line has the speed `|b − a| = d/√c₁` everywhere.
fn attained_k1(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7160, 128, (0.1..10.0, two_points::<3>(2.5)), |subject, (c, [a, b])| {
        let metric = Constant::new(SMatrix::<f64, 3, 3>::from_diagonal_element(c));
        let metric = metric.expect("positive");
        let line = SmoothCurve::straight(a, b);
        let distance = c.sqrt() * (b - a).norm();
        let [k1, _, apriori] = evidence(subject, &metric, &line, distance, 0.3)?;
        Ok([k1.attained()?, apriori.attained()?])
    })
}

/// A short geodesic through the centre of a twist: `|γ̈|` is nearly `3L_H K₁²/2c₁` all along it,
/// and the paper gives away `D² = 4`. It is minimal, being short, and `d` is its speed.
fn bent_by_a_twist(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7161, 64, (0.3..3.0, 0.1..10.0), |subject, (base, slope)| {
        let twist = Twist::<2>::new(base, slope, 2e-3 * base / slope)?;
        let speed = 1e-5 * base / slope;
        let curve = twist.short_geodesic(speed);
        let [k1, k2, apriori] = evidence(subject, &twist, &curve, base.sqrt() * speed, 0.0)?;
        let (sharp, known) = (NEAR, 4.0 * NEAR);
        Ok([
            k1,
            k2.claim_is_attained("|γ̈(t)| ≤ ω L_H K₁²/c₁", sharp)?.overestimates_at_most(known)?,
            apriori
                .claim_is_attained("‖γ̈‖ ≤ ω L_H K₁²/c₁", sharp)?
                .claim_is_attained("‖γ̈‖ ≤ K₂", known)?,
        ])
    })
}

/// A short geodesic at the foot of an incline: `|γ̈|` is nearly `L_H K₁²/2c₁`.
fn bent_by_an_incline(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7162, 64, (0.3..3.0, 0.1..2.0), |subject, (foot, slope)| {
        let incline = Incline::new(foot, slope).expect("positive");
        let curve = InclineGeodesic::new(foot, slope, 2e-3 * foot / slope)?;
        let [k1, k2, apriori] = evidence(subject, &incline, &curve, curve.distance(), 0.0)?;
        let (sharp, known) = (NEAR, 3.0 * NEAR);
        Ok([
            k1,
            k2.claim_is_attained("|γ̈(t)| ≤ ω L_H K₁²/c₁", sharp)?.overestimates_at_most(known)?,
            apriori
                .claim_is_attained("‖γ̈‖ ≤ ω L_H K₁²/c₁", sharp)?
                .claim_is_attained("‖γ̈‖ ≤ K₂", known)?,
        ])
    })
}
