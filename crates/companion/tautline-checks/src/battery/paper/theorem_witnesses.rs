//! Theorems 1.1 to 1.4 and their constants: how close they come to equality.
//!
//! # The smallest overestimation known
//!
//! On the line, with `δ = L_H d/c₁^{3/2}` and `κ = c₂/c₁`, `C_tra♯ = d² (δ + 3δ² + 6κδ + 9κδ²)`. As
//! `δ → 0` and `κ → 1`, `C_tra♯` tends to `7 d²δ`, so that `C` tends to `7¼ d²δ` for the
//! trapezoidal rule and to `8 d²δ` for the left rule. Larger `D`, `κ` or `δ` only increase it. At
//! `N = 1` the gaps are bounded by the sharper companions, which are attained in the same limit:
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

use nalgebra::SMatrix;
use tautline::gallery::Constant;
use tautline_statements::{
    Known, PaperRule, Reconstruction,
    Statement::{
        ConstantC1_1, ConstantC1_3, ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_2,
        Theorem1_3, Theorem1_4,
    },
    VerifyError,
};

use crate::battery::{
    cases::routes::{
        Knots, SLOPE, downwards, level, misleading, ridge, route, routes, upwards, valley,
    },
    harness::{Check, Outcome, Trial, Witness, for_rules},
    paper::section_1::of_minimiser,
};

pub(crate) const CHECKS: &[Check] = &[
    Witness.check(
        "theorems_1_1_and_1_2_on_tents_have_the_least_overestimation_known",
        &[Theorem1_1, Theorem1_2, ConstantK3Bar, ConstantC1_1],
        tents,
    ),
    Witness.check(
        "theorems_1_3_and_1_4_on_inclines_have_the_least_overestimation_known",
        &[Theorem1_3, Theorem1_4, ConstantK4Bar, ConstantC1_3],
        inclines,
    ),
    Witness.check(
        "k3_bar_and_k4_bar_are_attained_where_the_metric_is_constant",
        &[ConstantK3Bar, ConstantK4Bar],
        flat,
    ),
];

/// The next order adds up to `4.4 δ` to `C`, relative to `C`: it comes from `3δ² + 9κδ²`, from
/// `6(κ − 1)δ` with `κ − 1 = 2δ`, and from `C_tra♯` in `K̄³`. It adds up to `δ` to `d³`. The margin
/// is `10⁻⁵` of the gaps.
pub(crate) const LIMIT: f64 = 1.0 + 6.0 * SLOPE;

fn tents(trial: &Trial<'_>) -> Outcome {
    let claims = [
        "E(γᵖˡ) − E_tra,N ≤ C/√N",
        "E(γᵖˡ) − E_tra,N ≤ L_H mean|β|³/4N",
        "E(γᵖˡ) − E_tra,N ≤ d² (δ/4N) e Q",
        "d² − E_tra,N ≤ d² (δ/4N) e Q",
        "E_tra,N − d² ≤ C/N",
        "E_tra,N − d² ≤ d² (e − 1)",
        "c₁K₃² − d² ≤ c₁K̄²_{3,g} − d²",
    ];
    let (rule, read) = (PaperRule::Trapezoidal, [valley(1.0), ridge(1.0)]);
    least_known(trial, rule, read, [29.0, 14.5, 28.0], claims)
}

fn inclines(trial: &Trial<'_>) -> Outcome {
    let claims = [
        "E(γᵖˡ) − E_l,N ≤ C/√N",
        "E(γᵖˡ) − E_l,N ≤ L_H mean|β|³/2N",
        "E(γᵖˡ) − E_l,N ≤ d² (δ/2N) e Q",
        "d² − E_l,N ≤ d² (δ/2N) e Q",
        "E_l,N − d² ≤ C/√N",
        "E_l,N − d² ≤ d² (e − 1)",
        "c₁K₃² − d² ≤ c₁K̄²_{4,g} − d²",
    ];
    let (rule, read) = (PaperRule::LeftEndpoint, [upwards(1.0), downwards(1.0)]);
    least_known(trial, rule, read, [16.0, 8.0, 15.0], claims)
}

/// Evaluates the theorems of a rule on a route where its value of `H` is too small, and on one
/// where it is too large. The table above has the overestimations for one gap, for both gaps, and
/// for `K̄`.
fn least_known(
    trial: &Trial<'_>,
    rule: PaperRule,
    [too_little, too_much]: [Knots; 2],
    [one, two, speed]: [f64; 3],
    claims: [&str; 7],
) -> Outcome {
    let subject = trial.subject;
    let both = misleading(rule);
    // The value that the rule gives on the second route is slightly less than on the first.
    let tie = both[1].map(|[_, h]| h).into_iter().fold(f64::INFINITY, f64::min);
    let flat = routes(subject, rule, [too_much, level(tie.sqrt())])?;
    let [below, ..] = of_minimiser(subject, &route(subject, rule, too_little)?);
    let [above, ..] = of_minimiser(subject, &route(subject, rule, too_much)?);
    let [_, length, _, constant] = of_minimiser(subject, &routes(subject, rule, both)?);
    let [_, _, speeds, _] = of_minimiser(subject, &flat);
    trial.one([
        below
            .claim_is_attained(claims[0], one * LIMIT)?
            .claim_is_attained(claims[1], LIMIT)?
            .claim_is_attained(claims[2], LIMIT)?
            .claim_is_attained(claims[3], LIMIT)?,
        above.claim_is_attained(claims[4], one * LIMIT)?.claim_is_attained(claims[5], LIMIT)?,
        length
            .overestimates_at_most(two * LIMIT)?
            .claim_is_attained("L(γᵖˡ)² − d² = O(1/N)", LIMIT)?,
        constant
            .claim_is_attained("E(γᵖˡ) − d² ≤ by parts", two * LIMIT)?
            .claim_is_attained("by parts ≤ C/√N", 1.01)?
            .claim_is_attained("E(γᵖˡ) − d² = O(1/N)", LIMIT)?,
        speeds.claim_is_attained(claims[6], speed * LIMIT)?,
    ])
}

/// Returns the problem `H = 4 I` between two points at Euclidean distance 5.
pub(crate) fn flat_problem() -> Result<Known<Constant<2>, 2>, VerifyError> {
    let metric = Constant::new(SMatrix::from_diagonal_element(4.0))?;
    Ok(Known::between(metric, [1.0, 0.0], [4.0, 4.0])?.expect("known"))
}

/// Under `H = 4 I`, `C_tra♯ = 0` and `K₃ = d/√c₁` for every `N`.
fn flat(trial: &Trial<'_>) -> Outcome {
    let known = flat_problem()?;
    for_rules([1, 2, 7, 100], |rule, n| {
        let seen = Reconstruction::observe(trial.subject, &known, rule, n)?;
        let [_, _, speeds, _] = of_minimiser(trial.subject, &seen);
        trial.one([speeds.attained()?])
    })
}
