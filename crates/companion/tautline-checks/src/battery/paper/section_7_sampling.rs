//! Propositions 7.6 and 7.7, `C_tra(N)` and `C_tra♯`: curves and their samples.

use std::num::NonZeroUsize;

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use tautline::{
    Bounded, Constants, Ends, PointSequence, Rule,
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

use crate::battery::{
    cases::clauses::{ABOVE, LIPSCHITZ},
    harness::{
        Check, Dropped, Homogeneous, Outcome, Random, Refuted, Trial, Witness, all, fails_without,
        for_all, refuted,
    },
};
use crate::{
    arbitrary::AnySetting,
    strategies::{constant, ramp, separable, shear, smooth_curve, subintervals, two_points},
};

const CURVES: &[Statement] = &[Proposition7_6, Proposition7_7];
const P76: &[Statement] = &[Proposition7_6];
const P77: &[Statement] = &[Proposition7_7];
const CONSTANTS: &[Statement] = &[ConstantCTra, ConstantCTraSharp];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("props_7_6_and_7_7_hold_for_smooth_curves", CURVES, smooth),
    Random.check("prop_7_6_holds_for_minimal_geodesics", P76, geodesics),
    Homogeneous.check("props_7_6_and_7_7_are_homogeneous", CURVES, homogeneous),
    Witness.check(
        "prop_7_6_has_a_quarter_over_valleys_at_the_midpoints",
        CURVES,
        valleys_at_midpoints,
    ),
    Witness.check("the_sharp_form_of_prop_7_6_is_attained_by_half_a_cosine", P76, half_a_cosine),
    Refuted.check("prop_7_6_refuted_by_a_kink", P76, refuted_by_a_kink),
    Refuted.check("prop_7_7_refuted_by_a_fast_start", P77, refuted_by_a_fast_start),
    Dropped.check("props_7_6_and_7_7_fail_with_false_constants", CURVES, false_constants),
    Random.check("the_discrete_minimum_is_not_above_sampled_curves", P77, discrete_minimum),
    Random.check("c_tra_is_its_formula_and_c_tra_sharp_bounds_it", CONSTANTS, c_tra),
    Homogeneous.check("c_tra_is_homogeneous", CONSTANTS, homogeneous_c_tra),
    Witness.check("c_tra_sharp_is_approached_as_k2_tends_to_0", CONSTANTS, approached_c_tra_sharp),
];

fn positive(n: usize) -> NonZeroUsize {
    NonZeroUsize::new(n).expect("positive")
}

/// Draws three smooth curves between the same two points: two with waves of size up to 0.5 and up
/// to 0.1, and the straight line.
fn curves<const D: usize>() -> impl Strategy<Value = [SmoothCurve<D>; 3]> {
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
    for_all!(
        trial,
        [
            (7601, 352, (shear(), curves(), subintervals())),
            (7602, 192, (separable::<1>(), curves(), subintervals())),
            (7603, 192, (separable::<3>(), curves(), subintervals())),
            (7604, 192, (ramp(), curves(), subintervals())),
            // The straight line has the least energy, and so do its samples.
            (7605, 64, (constant::<2>(), curves(), subintervals())),
            (7606, 192, (Just(Valleys), curves::<2>(), subintervals())),
        ],
        |subject, (metric, curves, n)| evidence(subject, &metric, &curves, positive(n))
    )
}

/// For these curves `E = d²`. The pointwise companions are `d² (1 + δ/4N + δ²/8N²)` for the
/// trapezoidal rule and `d² (1 + δ/2N)` for the left-endpoint rule, with `δ = L_H d/c₁^{3/2}`.
fn geodesics(trial: &Trial<'_>) -> Outcome {
    for_all!(
        trial,
        [
            (7611, 512, (shear(), two_points(2.5), subintervals())),
            (7612, 192, (separable::<2>(), two_points(2.5), subintervals())),
        ],
        |subject, (metric, ends, n)| {
            Ok([prop_7_6(subject, &metric, &Geodesic::between(metric, ends), positive(n))?])
        }
    )
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), curves::<2>(), subintervals());
    trial.homogeneous(7620, 96, cases, |subject, (metric, curves, n), units| {
        let curves = curves.map(|curve| units.curve(curve));
        evidence(subject, &units.metric(metric), &curves, positive(n))
    })
}

/// The straight line from 0 to 1 passes a valley or a ridge at each midpoint, so that
/// `|E − E_tra,N| = L_H/4N`, while the bound is `L_H/N`. The paper's overestimation is 4, and the
/// pointwise form of the bound is attained.
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

/// For `γ̇ = 1 + a cos Nπt` under a constant metric, `β = 1`, and `E − E_tra,N = c a²/2` equals the
/// term `c K₂²/π²N²`.
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

/// For `|t − ½|` with `H = 1` and `N = 1`, `E = 1` and `E_tra = 0`. With `K₁ = 1` and `K₂ = 0.1`,
/// however, `C_tra(1) = 0.44`.
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

/// For a false `L_H` the counterexample is a line over a ridge, and for a false `c₂` it is half a
/// cosine. `c₁` is not needed, and `c₂` is not needed for the upper bound, Proposition 7.7.
fn false_constants(_: &Trial<'_>) -> Outcome {
    let n = NonZeroUsize::MIN;
    let claimed = |c1, c2, l_h| Constants::new(c1, c2, l_h).expect("in order");
    let ridge = Zigzag::new(2.0, -1.5, 1).expect("positive");
    let ridge = WithConstants { metric: ridge, constants: claimed(1.0, 2.0, 0.1) };
    let line = SmoothCurve::straight([0.0], [1.0]);
    let flat = Constant::<1>::new(SMatrix::from_diagonal_element(1.0)).expect("positive");
    let flat = WithConstants { metric: flat, constants: claimed(0.005, 0.01, 0.0) };
    // For γ̇ = 1 + cos πt, E − E_tra = ½, and 4 c₂ K₂ (K₁ + K₂) < 31 c₂.
    let sine = [SVector::zeros(), SVector::from([std::f64::consts::FRAC_1_PI])];
    let curve = SmoothCurve::new(vec![SVector::zeros(), SVector::from([1.0])], vec![sine]);
    all([
        fails_without(&[LIPSCHITZ], prop_7_6(&LIBRARY, &ridge, &line, n)?),
        fails_without(&[LIPSCHITZ], prop_7_7(&LIBRARY, &ridge, &[&line], n)?),
        fails_without(&[ABOVE], prop_7_6(&LIBRARY, &flat, &curve, n)?),
    ])
}

/// The curve moves from 0 to 1 in the time `1/N`, over the ridge `H = c + L (½ − |x − ½|)`, and
/// then rests. So `E_tra,N − E = NL/4`, while `K₁ = √N` and `K₂ = 0` give `C_tra(N) = L √N`. For
/// `N ≥ 17` the difference is larger than `C_tra(N)`, and a small `K₂ > 0` does not change that.
/// For a curve without a kink the difference would be at most `L K₁³/2N = ½ L √N`.
fn refuted_by_a_fast_start(trial: &Trial<'_>) -> Outcome {
    all([17, 18, 32, 100, 1000_u16].map(|n| {
        let metric = tent(2.0, -1.5).expect("positive");
        let stop = (1.0 / f64::from(n), SVector::from([1.0]));
        let ramp = KinkedCurve::new([0.0], [stop], [1.0])?;
        let evidence = prop_7_7(trial.subject, &metric, &[ramp], positive(n.into()))?;
        let clause = "γ̇ does not jump";
        fails_without(&[clause], evidence.clone())?;
        let numbers = [1.5 * f64::from(n) / 4.0, 1.5 * f64::from(n).sqrt()];
        refuted(&evidence.without(clause), "min E_tra,N − min E ≤ C_tra(N)", numbers)
    }))
}

/// The energy of a sampled curve between two points is not below the minimum over all point
/// sequences.
fn discrete_minimum(trial: &Trial<'_>) -> Outcome {
    let cases = (shear(), two_points(2.5), smooth_curve::<2>(0.5), subintervals());
    trial.for_all(7641, 192, cases, |subject, (metric, [a, b], curve, n)| {
        let ends = Ends::points(a, b)?;
        let samples =
            [Geodesic::between(metric, [a, b]).sample(n)?, curve.between(a, b).sample(n)?];
        let energies = |sequence: &PointSequence<2>| {
            [
                subject.discrete_energy(Rule::TRAPEZOIDAL, &metric, sequence),
                subject.discrete_energy(Rule::LEFT_ENDPOINT, &metric, sequence),
            ]
        };
        let trapezoidal = subject.minimise(Rule::TRAPEZOIDAL, &metric, &ends, n)?.sequence;
        let left = subject.minimise(Rule::LEFT_ENDPOINT, &metric, &ends, n)?.sequence;
        let ([least, _], [_, least_left]) = (energies(&trapezoidal), energies(&left));
        // The ends of a sample are off by the rounding of a number of size 10, which changes the
        // energy by this error times the momentum 2√(c₂E). This is some 1e-14, relative to the size
        // of both.
        let rounding = |energy: f64| 1e-13 * (1.0 + energy);
        let (claim, claim_left) = ("min E_tra,N ≤ E_tra,N(γ)", "min E_l,N ≤ E_l,N(γ)");
        Ok(samples.map(|sample| {
            let [one, two] = energies(&sample);
            Evidence::of(Proposition7_7)
                .sharper(claim, Unit::ENERGY, [least, one], rounding(one))
                .sharper(claim_left, Unit::ENERGY, [least_left, two], rounding(two))
        }))
    })
}

/// Evaluates the statements about `C_tra(N)` and `C_tra♯`.
fn constants(
    subject: &Subject,
    constants: Constants,
    norms: [f64; 2],
    n: NonZeroUsize,
) -> [Evidence; 2] {
    [
        constant_c_tra(subject, constants, norms, n),
        constant_c_tra_sharp(subject, constants, norms, n),
    ]
}

fn c_tra(trial: &Trial<'_>) -> Outcome {
    all([
        trial.quick(7651, 1024, |subject, any: &AnySetting| {
            let setting = any.setting();
            let norms = [subject.k1_g(setting), subject.k2_g(setting)];
            Ok(constants(subject, setting.constants(), norms, any.n()))
        }),
        trial.for_all(7652, 512, cases_of_c_tra(), |subject, (metric, norms, n)| {
            Ok(constants(subject, metric, norms, n))
        }),
    ])
}

/// Draws constants, `[K₁, K₂]` and `N`.
fn cases_of_c_tra() -> impl Strategy<Value = (Constants, [f64; 2], NonZeroUsize)> {
    let constants = (0.1..2.0, 1.0..5.0, 0.0..4.0);
    (constants, [0.0..3.0, 0.0..3.0], 1..500_usize).prop_map(|((c1, ratio, l_h), norms, n)| {
        let constants = Constants::new(c1, c1 * ratio, l_h).expect("in order");
        (constants, norms, positive(n))
    })
}

fn homogeneous_c_tra(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(7660, 128, cases_of_c_tra(), |subject, (metric, norms, n), units| {
        Ok(constants(subject, units.constants(metric)?, norms.map(|k| k * units.ell), n))
    })
}

/// With `K₂ = 10⁻³ K₁` the two sides differ only by the term of second order, which is at most a
/// thousandth of the others. `N = 1` is not a witness, since both sides are then the same formula.
fn approached_c_tra_sharp(trial: &Trial<'_>) -> Outcome {
    trial.for_all(7670, 256, cases_of_c_tra(), |subject, (constants, [k1, _], n)| {
        let norms = [k1 + 0.1, 1e-3 * (k1 + 0.1)];
        let one = constant_c_tra_sharp(subject, constants, norms, NonZeroUsize::MIN);
        let more = constant_c_tra_sharp(subject, constants, norms, n.saturating_add(1));
        let defined = constant_c_tra(subject, constants, norms, n);
        Ok([one, more.overestimates_at_most(1.0 + 1e-3)?, defined])
    })
}
