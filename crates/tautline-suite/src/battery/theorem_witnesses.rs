//! Theorems 1.1 to 1.4 and their constants: how near equality they come.
//!
//! # The least overestimation known
//!
//! With `δ = L_H d/c₁^{3/2}` and `κ = c₂/c₁`, on the line, `C_tra♯ = d² (δ + 3δ² + 6κδ + 9κδ²)`. As
//! `δ → 0` and `κ → 1` that is `7 d²δ`, so that `C = 7¼ d²δ` for the trapezoidal rule and `8 d²δ`
//! for the left one; larger `D`, `κ` or `δ` only add to it. No gap is larger at `N = 1` than in the
//! sharper companions, which are attained in the same limit:
//!
//! | gap | at most, of `d²δ` | witness | overestimation of the paper's bound |
//! | --- | --- | --- | --- |
//! | `E(γᵖˡ) − E_tra` | ¼ | one valley | 29 |
//! | `E_tra − d²` | ¼ | one ridge | 29 |
//! | `E(γᵖˡ) − d²`, `L(γᵖˡ)² − d²` | ½ | a ridge, and a valley that seems shorter | 14.5 |
//! | `c₁K₃² − d²` against `C_tra♯` | ¼ | a ridge, and a flat that seems shorter | 28 |
//! | `E(γᵖˡ) − E_l` | ½ | an incline upwards | 16 |
//! | `E_l − d²` | ½ | an incline downwards | 16 |
//! | `E(γᵖˡ) − d²`, `L(γᵖˡ)² − d²` | 1 | downwards, and upwards that seems shorter | 8 |
//! | `c₁K₃² − d²` against `c₁K̄²_{4,g} − d²` | ½ | downwards, and a flat | 15 |

use tautline::gallery;
use tautline_statements::{
    Known, PaperRule, Reconstruction,
    Statement::{
        ConstantC1_1, ConstantC1_3, ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_2,
        Theorem1_3, Theorem1_4,
    },
    Subject, VerifyError, constant_c_1_1, constant_c_1_3, constant_k3_bar, constant_k4_bar,
    theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4,
    witnesses::{Polygonal, two_routes},
};

use super::{Check, Kind, Outcome, Trial};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new(
            "theorems_1_1_and_1_2_on_tents_have_the_least_overestimation_known",
            Kind::Witness,
            &[Theorem1_1, Theorem1_2, ConstantK3Bar, ConstantC1_1],
            tents,
        ),
        Check::new(
            "theorems_1_3_and_1_4_on_inclines_have_the_least_overestimation_known",
            Kind::Witness,
            &[Theorem1_3, Theorem1_4, ConstantK4Bar, ConstantC1_3],
            inclines,
        ),
        Check::new(
            "k3_bar_and_k4_bar_are_attained_where_the_metric_is_constant",
            Kind::Witness,
            &[ConstantK3Bar, ConstantK4Bar],
            flat,
        ),
    ]
}

/// The slope of all profiles here: `δ` is as much, up to a percent of it.
pub(super) const SLOPE: f64 = 1e-3;

/// By how much the wrong route seems shorter: ten times what the solver takes for a tie.
pub(super) const MARGIN: f64 = 1e-8;

/// In `C` the next order adds up to `4.4 δ` of it (`3δ² + 9κδ²`, `6(κ − 1)δ` with `κ − 1 = 2δ`, and
/// `C_tra♯` in `K̄³`), and `d³` up to `δ`. The margin is `10⁻⁵` of the gaps.
pub(super) const LIMIT: f64 = 1.0 + 6.0 * SLOPE;

/// `H` at the knots of a route, and how long they are apart.
pub(super) type Knots = [[f64; 2]; 3];

/// Along a route of length 1: a slope up to the middle and another one down from it.
fn tent(foot: f64, tip: f64) -> Knots {
    [[0.0, foot], [0.5, tip], [1.0, foot]]
}

pub(super) fn ridge(foot: f64) -> Knots {
    tent(foot, foot + 0.5 * SLOPE)
}

pub(super) fn valley(tip: f64) -> Knots {
    tent(tip + 0.5 * SLOPE, tip)
}

fn straight(start: f64, end: f64) -> Knots {
    [[0.0, start], [0.5, 0.5 * (start + end)], [1.0, end]]
}

pub(super) fn upwards(start: f64) -> Knots {
    straight(start, start + SLOPE)
}

pub(super) fn downwards(end: f64) -> Knots {
    straight(end + SLOPE, end)
}

/// `H = 1` along a route of this length.
pub(super) fn level(length: f64) -> Knots {
    [[0.0, 1.0], [0.5 * length, 1.0], [length, 1.0]]
}

/// Observes the minimiser of the one chord from set to set.
pub(super) fn routes(
    subject: &Subject,
    rule: PaperRule,
    [first, second]: [Knots; 2],
) -> Result<Reconstruction<1>, VerifyError> {
    let known = two_routes(&first, &second).expect("apart");
    Reconstruction::observe(subject, &known, rule, 1)
}

/// The same between two points.
pub(super) fn route(
    subject: &Subject,
    rule: PaperRule,
    knots: Knots,
) -> Result<Reconstruction<1>, VerifyError> {
    let metric = Polygonal::new(&knots).expect("in order");
    let known = Known::between(metric, [0.0], [1.0]).map_err(VerifyError::from)?;
    Reconstruction::observe(subject, &known.expect("between the knots"), rule, 1)
}

fn tents(trial: &Trial<'_>) -> Outcome {
    let (subject, rule) = (trial.subject, PaperRule::Trapezoidal);
    let over_valley = route(subject, rule, valley(1.0))?;
    let over_ridge = route(subject, rule, ridge(1.0))?;
    // On the ridge H(½) = 1 + L/2, in the valley just less.
    let tie = 1.0 + 0.5 * SLOPE - MARGIN;
    let both = routes(subject, rule, [ridge(1.0), valley(tie)])?;
    let flat = routes(subject, rule, [ridge(1.0), level(tie.sqrt())])?;
    trial.one([
        theorem_1_1(subject, &over_valley)
            .claim_is_attained("E(γᵖˡ) − E_tra,N ≤ C/√N", 29.0 * LIMIT)?
            .claim_is_attained("E(γᵖˡ) − E_tra,N ≤ L_H mean|β|³/4N", LIMIT)?
            .claim_is_attained("E(γᵖˡ) − E_tra,N ≤ d² (δ/4N) e Q", LIMIT)?
            .claim_is_attained("d² − E_tra,N ≤ d² (δ/4N) e Q", LIMIT)?,
        theorem_1_1(subject, &over_ridge)
            .claim_is_attained("E_tra,N − d² ≤ C/N", 29.0 * LIMIT)?
            .claim_is_attained("E_tra,N − d² ≤ d² (e − 1)", LIMIT)?,
        theorem_1_2(subject, &both)
            .overestimates_at_most(14.5 * LIMIT)?
            .claim_is_attained("L(γᵖˡ)² − d² = O(1/N)", LIMIT)?,
        constant_c_1_1(subject, &both)
            .claim_is_attained("E(γᵖˡ) − d² ≤ by parts", 14.5 * LIMIT)?
            .claim_is_attained("by parts ≤ C/√N", 1.01)?
            .claim_is_attained("E(γᵖˡ) − d² = O(1/N)", LIMIT)?,
        constant_k3_bar(subject, &flat)
            .claim_is_attained("c₁K₃² − d² ≤ c₁K̄²_{3,g} − d²", 28.0 * LIMIT)?,
    ])
}

fn inclines(trial: &Trial<'_>) -> Outcome {
    let (subject, rule) = (trial.subject, PaperRule::LeftEndpoint);
    let up = route(subject, rule, upwards(1.0))?;
    let down = route(subject, rule, downwards(1.0))?;
    // Downwards H(0) = 1 + L, upwards just less.
    let tie = 1.0 + SLOPE - MARGIN;
    let both = routes(subject, rule, [downwards(1.0), upwards(tie)])?;
    let flat = routes(subject, rule, [downwards(1.0), level(tie.sqrt())])?;
    trial.one([
        theorem_1_3(subject, &up)
            .claim_is_attained("E(γᵖˡ) − E_l,N ≤ C/√N", 16.0 * LIMIT)?
            .claim_is_attained("E(γᵖˡ) − E_l,N ≤ L_H mean|β|³/2N", LIMIT)?
            .claim_is_attained("E(γᵖˡ) − E_l,N ≤ d² (δ/2N) e Q", LIMIT)?
            .claim_is_attained("d² − E_l,N ≤ d² (δ/2N) e Q", LIMIT)?,
        theorem_1_3(subject, &down)
            .claim_is_attained("E_l,N − d² ≤ C/√N", 16.0 * LIMIT)?
            .claim_is_attained("E_l,N − d² ≤ d² (e − 1)", LIMIT)?,
        theorem_1_4(subject, &both)
            .overestimates_at_most(8.0 * LIMIT)?
            .claim_is_attained("L(γᵖˡ)² − d² = O(1/N)", LIMIT)?,
        constant_c_1_3(subject, &both)
            .claim_is_attained("E(γᵖˡ) − d² ≤ by parts", 8.0 * LIMIT)?
            .claim_is_attained("by parts ≤ C/√N", 1.01)?
            .claim_is_attained("E(γᵖˡ) − d² = O(1/N)", LIMIT)?,
        constant_k4_bar(subject, &flat)
            .claim_is_attained("c₁K₃² − d² ≤ c₁K̄²_{4,g} − d²", 15.0 * LIMIT)?,
    ])
}

/// `H = 4 I`: `C_tra♯ = 0` and `K₃ = d/√c₁`, for every `N`.
fn flat(trial: &Trial<'_>) -> Outcome {
    let metric =
        gallery::Constant::<2>::new([[4.0, 0.0], [0.0, 4.0]].into()).expect("positive definite");
    let known =
        Known::between(metric, [1.0, 0.0], [4.0, 4.0]).map_err(VerifyError::from)?.expect("known");
    let mut evidence = Vec::new();
    for n in [1, 2, 7, 100] {
        for rule in PaperRule::BOTH {
            let seen = Reconstruction::observe(trial.subject, &known, rule, n)?;
            evidence.push(match rule {
                PaperRule::Trapezoidal => constant_k3_bar(trial.subject, &seen).attained()?,
                PaperRule::LeftEndpoint => constant_k4_bar(trial.subject, &seen).attained()?,
            });
        }
    }
    trial.one(evidence)
}
