//! Propositions 7.6 and 7.7, `C_tra(N)` and `C_tra♯`: curves, and their samples.

use std::{fmt::Debug, num::NonZeroUsize};

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{
    Bounded, Constants, Ends, LeftEndpoint, Trapezoidal,
    gallery::{Constant, Valleys},
};
use tautline_statements::{
    Evidence, LIBRARY,
    Statement::{self, ConstantCTra, ConstantCTraSharp, Proposition7_6, Proposition7_7},
    Subject, Unit, VerifyError, WithConstants, constant_c_tra, constant_c_tra_sharp,
    curves::{BoundedCurve, Curve, Geodesic, KinkedCurve, SmoothCurve},
    prop_7_6, prop_7_6_as_printed, prop_7_7,
    witnesses::{Zigzag, tent},
};

use super::{
    Check, Kind, Outcome, Trial,
    check::all,
    failing::{fails_without, refuted},
};
use crate::{
    arbitrary::AnySetting,
    strategies::{constant, ramp, separable, shear, smooth_curve, subintervals, two_points},
};

const CURVES: &[Statement] = &[Proposition7_6, Proposition7_7];
const P76: &[Statement] = &[Proposition7_6];
const P77: &[Statement] = &[Proposition7_7];
const CONSTANTS: &[Statement] = &[ConstantCTra, ConstantCTraSharp];

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("props_7_6_and_7_7_hold_for_smooth_curves", Kind::Random, CURVES, smooth),
        Check::new("prop_7_6_holds_for_minimal_geodesics", Kind::Random, P76, geodesics),
        Check::new("props_7_6_and_7_7_are_homogeneous", Kind::Homogeneous, CURVES, homogeneous),
        Check::new(
            "prop_7_6_has_a_quarter_over_valleys_at_the_midpoints",
            Kind::Witness,
            CURVES,
            valleys_at_midpoints,
        ),
        Check::new(
            "the_sharp_form_of_prop_7_6_is_attained_by_half_a_cosine",
            Kind::Witness,
            P76,
            half_a_cosine,
        ),
        Check::new("prop_7_6_refuted_by_a_kink", Kind::Refuted, P76, refuted_by_a_kink),
        Check::new("prop_7_7_refuted_by_a_fast_start", Kind::Refuted, P77, refuted_by_a_fast_start),
        Check::new("props_7_6_and_7_7_fail_with_false_constants", Kind::Dropped, CURVES, |_| {
            false_constants()
        }),
        Check::new(
            "the_discrete_minimum_is_not_above_sampled_curves",
            Kind::Random,
            P77,
            discrete_minimum,
        ),
        Check::new(
            "c_tra_is_its_formula_and_c_tra_sharp_bounds_it",
            Kind::Random,
            CONSTANTS,
            c_tra,
        ),
        Check::new("c_tra_is_homogeneous", Kind::Homogeneous, CONSTANTS, homogeneous_c_tra),
        Check::new(
            "c_tra_sharp_is_approached_as_k2_tends_to_0",
            Kind::Witness,
            CONSTANTS,
            approached_c_tra_sharp,
        ),
    ]
}

fn positive(n: usize) -> NonZeroUsize {
    NonZeroUsize::new(n).expect("positive")
}

/// Three smooth curves between the same two points: a wave of size up to ½, its half, and the
/// straight line.
fn family<const D: usize>() -> impl Strategy<Value = [SmoothCurve<D>; 3]> {
    (two_points::<D>(2.0), smooth_curve::<D>(0.5), smooth_curve::<D>(0.1)).prop_map(
        |([a, b], wide, narrow)| {
            [wide.between(a, b), narrow.between(a, b), SmoothCurve::straight(a, b)]
        },
    )
}

fn evidence<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curves: &[impl BoundedCurve<D>; 3],
    n: NonZeroUsize,
) -> Result<[Evidence; 2], VerifyError> {
    Ok([prop_7_6(subject, metric, &curves[0], n)?, prop_7_7(subject, metric, curves, n)?])
}

fn smooth(trial: &Trial<'_>) -> Outcome {
    fn metrics<M: Bounded<D> + Debug + 'static, const D: usize>(
        trial: &Trial<'_>,
        seed: u64,
        cases: u32,
        metrics: impl Strategy<Value = M>,
    ) -> Outcome {
        let drawn = (metrics, family::<D>(), subintervals());
        trial.for_all(seed, cases, drawn, |subject, (metric, curves, n)| {
            evidence(subject, &metric, &curves, positive(n))
        })
    }
    all([
        metrics(trial, 7601, 352, shear()),
        metrics(trial, 7602, 192, separable::<1>()),
        metrics(trial, 7603, 192, separable::<3>()),
        metrics(trial, 7604, 192, ramp()),
        // The least energy is that of the straight line, and of its samples.
        metrics(trial, 7605, 64, constant::<2>()),
        metrics::<_, 2>(trial, 7606, 192, Just(Valleys)),
    ])
}

/// Where `E = d²`: the pointwise companions are `d² (1 + δ/4N + δ²/8N²)` for the trapezoidal rule
/// and `d² (1 + δ/2N)` for the left-endpoint rule, with `δ = L_H d/c₁^{3/2}`.
fn geodesics(trial: &Trial<'_>) -> Outcome {
    all([
        trial.for_all(
            7611,
            512,
            (shear(), two_points(2.5), subintervals()),
            |subject, (metric, ends, n)| {
                Ok([prop_7_6(subject, &metric, &Geodesic::between(metric, ends), positive(n))?])
            },
        ),
        trial.for_all(
            7612,
            192,
            (separable::<2>(), two_points(2.5), subintervals()),
            |subject, (metric, ends, n)| {
                let curve = Geodesic::between(metric, ends);
                Ok([prop_7_6(subject, &metric, &curve, positive(n))?])
            },
        ),
    ])
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), family::<2>(), subintervals());
    trial.homogeneous(7620, 96, cases, |subject, (metric, curves, n), units| {
        let curves = curves.map(|curve| units.curve(curve));
        evidence(subject, &units.metric(metric), &curves, positive(n))
    })
}

/// The straight line from 0 to 1 with a valley or a ridge at each midpoint:
/// `|E − E_tra,N| = L_H/4N`, against `L_H/N`. So the overestimation of the paper is 4, and the
/// pointwise form is attained.
fn valleys_at_midpoints(trial: &Trial<'_>) -> Outcome {
    let line = SmoothCurve::straight([0.0], [1.0]);
    trial.for_all(7630, 96, (1..60_usize, 0.2..1.5), |subject, (n, slope)| {
        let metric = |slope| Zigzag::new(2.0, slope, n).expect("positive");
        let [valley, ridge] = [metric(slope), metric(-slope)];
        let valley = prop_7_6(subject, &valley, &line, positive(n))?;
        let sampled = prop_7_7(subject, &ridge, &[&line], positive(n))?;
        let ridge = prop_7_6(subject, &ridge, &line, positive(n))?;
        let up = "E_tra,N − E ≤ L_H A₁²(A₁/4N + A₂/12N²)";
        let down = "E − E_tra,N ≤ L_H A₁²(A₁/4N + A₂/12N²) + c₂A₂²/12N²";
        let overestimation = 4.0 * (1.0 + 1e-6);
        Ok([
            valley.overestimates_at_most(overestimation)?.claim_is_attained(down, 1.0 + 1e-6)?,
            ridge.overestimates_at_most(overestimation)?.claim_is_attained(up, 1.0 + 1e-6)?,
            sampled.overestimates_at_most(overestimation)?,
        ])
    })
}

/// `γ̇ = 1 + a cos Nπt` under a constant metric: `β = 1`, and `E − E_tra,N = c a²/2` is all of
/// `c K₂²/π²N²`.
fn half_a_cosine(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7631, 96, (1..16_usize, 0.2..2.0, 0.3..3.0), |subject, (n, a, c)| {
        let metric = Constant::<1>::new(SMatrix::from_diagonal_element(c)).expect("positive");
        let mut waves = vec![[SVector::zeros(); 2]; n];
        waves[n - 1][1] = SVector::from([a / (std::f64::consts::PI * n as f64)]);
        let curve = SmoothCurve::new(vec![SVector::zeros(), SVector::from([1.0])], waves);
        let claim = "E − E_tra,N ≤ L_H K₁²(K₁ + K₂/√3)/2N + c₂K₂²/π²N²";
        let evidence = prop_7_6(subject, &metric, &curve, positive(n))?;
        Ok([evidence.claim_is_attained(claim, 1.0 + 1e-6)?])
    })
}

/// `|t − ½|` with `H = 1` and `N = 1`: `E = 1` and `E_tra = 0`, and `C_tra(1) = 0.44` with `K₁ = 1`
/// and `K₂ = 0.1`.
fn refuted_by_a_kink(trial: &Trial<'_>) -> Outcome {
    let modulus = KinkedCurve::new([0.5], [(0.5, [0.0].into())], [0.5])?;
    let metric = Constant::<1>::new(SMatrix::from_diagonal_element(1.0)).expect("positive");
    let n = NonZeroUsize::MIN;
    let printed = prop_7_6_as_printed(trial.subject, &metric, &modulus, [1.0, 0.1], n)?;
    all([
        refuted(&printed, "|E − E_tra,N| ≤ C_tra(N)", [1.0, 0.44]),
        fails_without(&["γ̇ does not jump"], prop_7_6(trial.subject, &metric, &modulus, n)?),
    ])
}

/// With a false `L_H`, the valley of a line; with a false `c₂`, half a cosine. `c₁` is not needed,
/// and upwards, in Proposition 7.7, nor is `c₂`.
fn false_constants() -> Outcome {
    let n = NonZeroUsize::MIN;
    let claimed = |c1, c2, l_h| Constants::new(c1, c2, l_h).expect("in order");
    let ridge = Zigzag::new(2.0, -1.5, 1).expect("positive");
    let ridge = WithConstants { metric: ridge, constants: claimed(1.0, 2.0, 0.1) };
    let line = SmoothCurve::straight([0.0], [1.0]);
    let flat = Constant::<1>::new(SMatrix::from_diagonal_element(1.0)).expect("positive");
    let flat = WithConstants { metric: flat, constants: claimed(0.005, 0.01, 0.0) };
    // γ̇ = 1 + cos πt: E − E_tra = ½, and 4 c₂ K₂ (K₁ + K₂) < 31 c₂.
    let sine = [SVector::zeros(), SVector::from([std::f64::consts::FRAC_1_PI])];
    let curve = SmoothCurve::new(vec![SVector::zeros(), SVector::from([1.0])], vec![sine]);
    let lipschitz = "‖H(x) − H(y)‖/|x − y| ≤ L_H";
    all([
        fails_without(&[lipschitz], prop_7_6(&LIBRARY, &ridge, &line, n)?),
        fails_without(&[lipschitz], prop_7_7(&LIBRARY, &ridge, &[&line], n)?),
        fails_without(&["λ_max(H) ≤ c₂"], prop_7_6(&LIBRARY, &flat, &curve, n)?),
    ])
}

/// From 0 to 1 in the time `1/N`, over the ridge `H = c + L (½ − |x − ½|)`, then at rest: `E_tra,N
/// − E = NL/4`, while `K₁ = √N` and `K₂ = 0` make `C_tra(N) = L √N`. For `N ≥ 17` the first is
/// larger, and a small `K₂ > 0` changes nothing. Without a kink it is at most `L K₁³/2N = ½ L √N`.
fn refuted_by_a_fast_start(trial: &Trial<'_>) -> Outcome {
    let mut outcomes = Vec::new();
    for n in [17, 18, 32, 100, 1000_u16] {
        let metric = tent(2.0, -1.5).expect("positive");
        let stop = (1.0 / f64::from(n), SVector::from([1.0]));
        let ramp = KinkedCurve::new([0.0], [stop], [1.0])?;
        let evidence = prop_7_7(trial.subject, &metric, &[ramp], positive(n.into()))?;
        let clause = "γ̇ does not jump";
        outcomes.push(fails_without(&[clause], evidence.clone()));
        let numbers = [1.5 * f64::from(n) / 4.0, 1.5 * f64::from(n).sqrt()];
        let claim = "min E_tra,N − min E ≤ C_tra(N)";
        outcomes.push(refuted(&evidence.without(clause), claim, numbers));
    }
    all(outcomes)
}

/// The infimum over all curves between two points, sampled, is a minimum over all point sequences.
fn discrete_minimum(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), two_points(2.5), smooth_curve::<2>(0.5), subintervals());
    trial.for_all(7641, 192, cases, |subject, (metric, [a, b], curve, n)| {
        let ends = Ends::points(a, b)?;
        let geodesic = Geodesic::between(metric, [a, b]).sample(n)?;
        let curve = curve.between(a, b).sample(n)?;
        let trapezoidal = subject.minimise(Trapezoidal, &metric, &ends, n)?.sequence;
        let left = subject.minimise(LeftEndpoint, &metric, &ends, n)?.sequence;
        let [least, least_left] = [
            subject.discrete_energy(Trapezoidal, &metric, &trapezoidal),
            subject.discrete_energy(LeftEndpoint, &metric, &left),
        ];
        // The ends of a sample are off by a rounding of 10, which moves the energy by the momentum
        // 2√(c₂E): some 1e-14 relative to the size of both.
        Ok([geodesic, curve].map(|sample| {
            let sampled = subject.discrete_energy(Trapezoidal, &metric, &sample);
            let sampled_left = subject.discrete_energy(LeftEndpoint, &metric, &sample);
            let rounding = |energy: f64| 1e-13 * (1.0 + energy);
            Evidence::of(Proposition7_7)
                .sharper(
                    "min E_tra,N ≤ E_tra,N(γ)",
                    Unit::ENERGY,
                    [least, sampled],
                    rounding(sampled),
                )
                .sharper(
                    "min E_l,N ≤ E_l,N(γ)",
                    Unit::ENERGY,
                    [least_left, sampled_left],
                    rounding(sampled_left),
                )
        }))
    })
}

fn c_tra(trial: &Trial<'_>) -> Outcome {
    all([
        trial.quick(7651, 1024, |subject, any: &AnySetting| {
            let (setting, n) = (any.setting(), any.n());
            let norms = [subject.k1_g(setting), subject.k2_g(setting)];
            Ok([
                constant_c_tra(subject, setting.constants(), norms, n),
                constant_c_tra_sharp(subject, setting.constants(), norms, n),
            ])
        }),
        trial.for_all(7652, 512, cases_of_c_tra(), |subject, (constants, norms, n)| {
            Ok([
                constant_c_tra(subject, constants, norms, n),
                constant_c_tra_sharp(subject, constants, norms, n),
            ])
        }),
    ])
}

/// Constants, `[K₁, K₂]` and `N`.
fn cases_of_c_tra() -> impl Strategy<Value = (Constants, [f64; 2], NonZeroUsize)> {
    let constants = (0.1..2.0, 1.0..5.0, 0.0..4.0);
    (constants, [0.0..3.0, 0.0..3.0], 1..500_usize).prop_map(|((c1, ratio, l_h), norms, n)| {
        let constants = Constants::new(c1, c1 * ratio, l_h).expect("in order");
        (constants, norms, positive(n))
    })
}

fn homogeneous_c_tra(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(7660, 128, cases_of_c_tra(), |subject, (constants, norms, n), units| {
        let (constants, norms) = (units.constants(constants)?, norms.map(|k| k * units.ell));
        Ok([
            constant_c_tra(subject, constants, norms, n),
            constant_c_tra_sharp(subject, constants, norms, n),
        ])
    })
}

/// With `K₂ = 10⁻³ K₁` the term of second order is a thousandth of the others at most, and is all
/// that differs. `N = 1` is no witness: there the two sides are the same formula.
fn approached_c_tra_sharp(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7670, 256, cases_of_c_tra(), |subject, (constants, [k1, _], n)| {
        let norms = [k1 + 0.1, 1e-3 * (k1 + 0.1)];
        let one = constant_c_tra_sharp(subject, constants, norms, NonZeroUsize::MIN);
        let more = constant_c_tra_sharp(subject, constants, norms, n.saturating_add(1));
        let defined = constant_c_tra(subject, constants, norms, n);
        Ok([one, more.overestimates_at_most(1.0 + 1e-3)?, defined])
    })
}
