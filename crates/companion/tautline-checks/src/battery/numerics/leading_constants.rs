//! The leading constants of the errors: predictions for the smooth case, and measurements with
//! another program.
//!
//! For a minimal geodesic `γ` that is unique and nondegenerate,
//!
//! ```text
//! N² (E_tra,N − d²)  →  (1/12) ∫ γ̈ᵀHγ̈ dt − (1/24) ∫ D²H[γ̇, γ̇](γ̇, γ̇) dt
//! N (E_l,N − d²)     →  −½ ∫ DH[γ̇](γ̇, γ̇) dt
//! N² (E(γᵖˡ) − d²)   →  (1/12) ∫ γ̈ᵀHγ̈ dt                                  (trapezoidal)
//! N² (L(γᵖˡ)² − d²)  →  (1/12) ∫ (γ̈ᵀHγ̈ − (γ̇ᵀHγ̈)²/d²) dt                   (trapezoidal)
//! ```
//!
//! An unoptimised sequence, another rule, or a missing factor changes these limits far beyond any
//! tolerance.

use tautline::{
    Ends, Metric, Rule,
    gallery::{Shear, Valleys},
};
use tautline_statements::{
    Statement::{self, Theorem1_1, Theorem1_2, Theorem1_3, Theorem1_4},
    Subject, VerifyError,
};

use crate::battery::{
    harness::{Check, Order, Outcome, Trial, close},
    numerics::golden::corrugated_beside_line,
};

const ALL: &[Statement] = &[Theorem1_1, Theorem1_2, Theorem1_3, Theorem1_4];

pub(crate) const CHECKS: &[Check] = &[
    Order.check("leading_constants_on_a_shear", ALL, on_a_shear),
    Order.check("leading_constants_over_the_valleys", ALL, over_the_valleys),
    Order.check("leading_constants_on_a_corrugated_metric", ALL, corrugated),
];

/// A problem, its `d²`, and the six constants that this file compares.
struct Case<M, const D: usize> {
    metric: M,
    ends: [[f64; D]; 2],
    d2: f64,
    /// The values of [`scaled_errors`] at `N = 256` for both rules, computed by another program.
    measured: [[f64; 3]; 2],
    /// The limits for the trapezoidal rule, and the limit of `N (E_l,N − d²)`.
    trapezoidal: [f64; 3],
    left: f64,
}

/// Returns `N^q (E_N − d²)`, `N² (E(γᵖˡ) − d²)` and `N² (L(γᵖˡ)² − d²)`, where `q` is the order of
/// the rule. Also returns how much incomplete convergence may change the last two.
fn scaled_errors<M: Metric<D>, const D: usize>(
    subject: &Subject,
    case: &Case<M, D>,
    rule: Rule,
    n: usize,
) -> Result<([f64; 3], f64), VerifyError> {
    let ends = Ends::points(case.ends[0], case.ends[1])?;
    let minimum = subject.minimise(rule, &case.metric, &ends, n)?;
    let line = &minimum.sequence;
    let discrete_energy = subject.discrete_energy(rule, &case.metric, line);
    let count = n as f64;
    let excess = subject.curve_energy(&case.metric, line).value - case.d2;
    let length = subject.curve_length(&case.metric, line).value;
    let errors = [
        count.powi(rule.error_exponent()) * (discrete_energy - case.d2),
        count * count * excess,
        count * count * (length.powi(2) - case.d2),
    ];
    // E_N is stationary at the minimiser, but E(γᵖˡ) is not. If E_N can still decrease by ε =
    // decrement · E, the points are off by √ε in the norm of the Hessian, and E(γᵖˡ) has the slope
    // 2 (excess)^{1/2}. A converged search leaves at most 10⁻¹⁸ or rounding, whatever it reports.
    let left_over = minimum.decrement.min(1e-15) * discrete_energy;
    Ok((errors, count * count * 2.0 * (left_over * excess.max(0.0)).sqrt()))
}

fn check<M: Metric<D>, const D: usize>(subject: &Subject, case: &Case<M, D>) -> Outcome {
    const NAMES: [&str; 3] = ["N^q (E_N − d²)", "N² (E(γᵖˡ) − d²)", "N² (L(γᵖˡ)² − d²)"];
    let trapezoidal = |n| scaled_errors(subject, case, Rule::TRAPEZOIDAL, n);
    let left = |n| scaled_errors(subject, case, Rule::LEFT_ENDPOINT, n);
    for ((values, left_over), measured) in
        [trapezoidal(256)?, left(256)?].into_iter().zip(case.measured)
    {
        for i in 0..3 {
            // Six decimals were printed. Rounding contributes some 8 ulps of d², times N² = 2^16.
            let tolerance = 0.5e-6 + 65536.0 * 8.0 * f64::EPSILON * case.d2 + left_over;
            close(&format!("{} at 256", NAMES[i]), values[i], measured[i], tolerance)?;
        }
    }
    // The expansions are in 1/N². One extrapolation from 256 and 512 leaves a relative error of
    // (10/N)⁴ < 1e-6.
    let (coarse, fine) = (trapezoidal(256)?, trapezoidal(512)?);
    for i in 0..3 {
        let limit = (4.0 * fine.0[i] - coarse.0[i]) / 3.0;
        let rounding = 2.0 * 262_144.0 * 8.0 * f64::EPSILON * case.d2 + 2.0 * (fine.1 + coarse.1);
        let tolerance = 0.5e-6 + 1e-6 * limit.abs() + rounding;
        close(NAMES[i], limit, case.trapezoidal[i], tolerance)?;
    }
    // The expansion is in 1/N. Two extrapolations from 256, 512 and 1024 leave (10/N)³, which is
    // 1e-6 to 1e-5.
    let [a, b, c] = [left(256)?, left(512)?, left(1024)?].map(|(errors, _)| errors[0]);
    let (first, second) = (2.0 * b - a, 2.0 * c - b);
    let limit = (4.0 * second - first) / 3.0;
    let tolerance = 0.5e-6 + 1e-5 * limit.abs();
    close("N (E_l,N − d²)", limit, case.left, tolerance)
}

/// `H = [[1, s], [s, 1 + s²]]` with `s = ½ cos x₂`, from `(0, 0)` to `(2, 3)`. For example,
/// `γ̈ = (9/2 sin 3t, 0)`, so that `(1/12) ∫ γ̈ᵀHγ̈ = (27/16) (½ − sin 6/12) = 0.883043…`.
fn on_a_shear(trial: &Trial<'_>) -> Outcome {
    let case = Case {
        metric: Shear::new(0.5, 1.0).expect("valid"),
        ends: [[0.0, 0.0], [2.0, 3.0]],
        d2: 13.2872187302884386916,
        measured: [[0.109570, 0.883047, 0.598121], [6.187652, 1.503849, 0.675459]],
        trapezoidal: [0.109574, 27.0 / 16.0 * (0.5 - 6_f64.sin() / 12.0), 0.598123],
        left: 6.180601,
    };
    check(trial.subject, &case)
}

/// The limit for the left rule is `−½ d² log (f(2)²/f(0)²)`, as for every conformal metric.
fn over_the_valleys(trial: &Trial<'_>) -> Outcome {
    let d2 = 14.3017242380777319739;
    let case = Case {
        metric: Valleys,
        ends: [[0.0, 0.0], [2.0, 1.5]],
        d2,
        measured: [[-1.690164, 1.566571, 0.526260], [-12.590413, 2.942818, 0.526958]],
        trapezoidal: [-1.690158, 1.566563, 0.526260],
        left: -d2 * (2.0 - 2_f64.cos()).ln(),
    };
    check(trial.subject, &case)
}

fn corrugated(trial: &Trial<'_>) -> Outcome {
    let (metric, ends) = corrugated_beside_line();
    let case = Case {
        metric,
        ends,
        d2: 8.97778203566217551435,
        measured: [[0.292391, 0.070223, 0.015644], [-0.511175, 0.873992, 0.194751]],
        trapezoidal: [0.292386, 0.070220, 0.015643],
        left: -0.506573,
    };
    check(trial.subject, &case)
}
