//! The leading constants of the errors: what a theory of the smooth case predicts, and what
//! another program measured.
//!
//! For a minimal geodesic `γ` that is unique and not degenerate,
//!
//! ```text
//! N² (E_tra,N − d²)  →  (1/12) ∫ γ̈ᵀHγ̈ dt − (1/24) ∫ D²H[γ̇, γ̇](γ̇, γ̇) dt
//! N (E_l,N − d²)     →  −½ ∫ DH[γ̇](γ̇, γ̇) dt
//! N² (E(γᵖˡ) − d²)   →  (1/12) ∫ γ̈ᵀHγ̈ dt                                  (trapezoidal)
//! N² (L(γᵖˡ)² − d²)  →  (1/12) ∫ (γ̈ᵀHγ̈ − (γ̇ᵀHγ̈)²/d²) dt                   (trapezoidal)
//! ```
//!
//! An unoptimised sequence, another rule or a lost factor changes them beyond recognition.

use tautline::{
    Ends, LeftEndpoint, Metric, Problem, Rule, Trapezoidal,
    gallery::{Shear, Valleys},
};

use crate::own::Corrugated;

/// A problem, its `d²`, and the six constants of this file.
struct Case<M, const D: usize> {
    metric: M,
    ends: [[f64; D]; 2],
    d2: f64,
    /// What [`scaled_errors`] was at `N = 256` for both rules, in another program.
    measured: [[f64; 3]; 2],
    /// The limits for the trapezoidal rule, and that of `N (E_l,N − d²)`.
    trapezoidal: [f64; 3],
    left: f64,
}

/// `N^q (E_N − d²)`, `N² (E(γᵖˡ) − d²)` and `N² (L(γᵖˡ)² − d²)`, with the order `q` of the rule;
/// and how far the last two are moved by what is left to minimise.
fn scaled_errors<M: Metric<D> + Copy, R: Rule, const D: usize>(
    case: &Case<M, D>,
    rule: R,
    n: usize,
) -> ([f64; 3], f64) {
    let ends = Ends::points(case.ends[0], case.ends[1]).expect("finite");
    let line = Problem::new(case.metric, ends).solve(rule, n).expect("a metric");
    let count = n as f64;
    let excess = line.energy().value - case.d2;
    let errors = [
        count.powi(R::ERROR_EXPONENT) * (line.discrete_energy() - case.d2),
        count * count * excess,
        count * count * (line.length().value.powi(2) - case.d2),
    ];
    // E_N is stationary, but E(γᵖˡ) is not: where E_N may still fall by ε = decrement · E, the
    // points are √ε off, in the norm of the Hessian, and E(γᵖˡ) has the slope 2 (excess)^{1/2}.
    let left_over = line.minimum().decrement * line.discrete_energy();
    (errors, count * count * 2.0 * (left_over * excess).sqrt())
}

#[track_caller]
fn assert_close(what: &str, value: f64, reference: f64, tolerance: f64) {
    assert!(
        (value - reference).abs() <= tolerance,
        "{what}: {value:.9} is not {reference:.9} up to {tolerance:.1e}"
    );
}

fn check<M: Metric<D> + Copy, const D: usize>(case: &Case<M, D>) {
    const NAMES: [&str; 3] = ["N^q (E_N − d²)", "N² (E(γᵖˡ) − d²)", "N² (L(γᵖˡ)² − d²)"];
    let trapezoidal = |n| scaled_errors(case, Trapezoidal, n);
    let left = |n| scaled_errors(case, LeftEndpoint, n);
    for ((values, left_over), measured) in
        [trapezoidal(256), left(256)].into_iter().zip(case.measured)
    {
        for i in 0..3 {
            // Six decimals were printed. Rounding: some 8 ulp of d², times N² = 2^16.
            let tolerance = 0.5e-6 + 65536.0 * 8.0 * f64::EPSILON * case.d2 + left_over;
            assert_close(&format!("{} at 256", NAMES[i]), values[i], measured[i], tolerance);
        }
    }
    // Expansions in 1/N²: one extrapolation from 256 and 512 leaves the relative error of some
    // (10/N)⁴ < 1e-6.
    let (coarse, fine) = (trapezoidal(256), trapezoidal(512));
    for i in 0..3 {
        let limit = (4.0 * fine.0[i] - coarse.0[i]) / 3.0;
        let rounding = 2.0 * 262_144.0 * 8.0 * f64::EPSILON * case.d2 + 2.0 * (fine.1 + coarse.1);
        let tolerance = 0.5e-6 + 1e-6 * limit.abs() + rounding;
        assert_close(NAMES[i], limit, case.trapezoidal[i], tolerance);
    }
    // An expansion in 1/N: two extrapolations from 256, 512 and 1024 leave (10/N)³, 1e-6 to 1e-5.
    let [a, b, c] = [256, 512, 1024].map(|n| left(n).0[0]);
    let (first, second) = (2.0 * b - a, 2.0 * c - b);
    let limit = (4.0 * second - first) / 3.0;
    let tolerance = 0.5e-6 + 1e-5 * limit.abs();
    assert_close("N (E_l,N − d²)", limit, case.left, tolerance);
}

/// `H = [[1, s], [s, 1 + s²]]`, `s = ½ cos x₂`, from `(0, 0)` to `(2, 3)`. For example
/// `γ̈ = (9/2 sin 3t, 0)`, so `(1/12) ∫ γ̈ᵀHγ̈ = (27/16) (½ − sin 6/12) = 0.883043…`.
#[test]
fn leading_constants_on_a_shear() {
    check(&Case {
        metric: Shear::new(0.5, 1.0).expect("valid"),
        ends: [[0.0, 0.0], [2.0, 3.0]],
        d2: 13.2872187302884386916,
        measured: [[0.109570, 0.883047, 0.598121], [6.187652, 1.503849, 0.675459]],
        trapezoidal: [0.109574, 27.0 / 16.0 * (0.5 - 6_f64.sin() / 12.0), 0.598123],
        left: 6.180601,
    });
}

/// The limit for the left rule is `−½ d² log (f(2)²/f(0)²)`, as for every conformal metric.
#[test]
fn leading_constants_over_the_valleys() {
    let d2 = 14.3017242380777319739;
    check(&Case {
        metric: Valleys,
        ends: [[0.0, 0.0], [2.0, 1.5]],
        d2,
        measured: [[-1.690164, 1.566571, 0.526260], [-12.590413, 2.942818, 0.526958]],
        trapezoidal: [-1.690158, 1.566563, 0.526260],
        left: -d2 * (2.0 - 2_f64.cos()).ln(),
    });
}

#[test]
fn leading_constants_on_a_metric_of_ones_own() {
    check(&Case {
        metric: Corrugated,
        ends: [[0.2, 0.0], [2.5, 1.0]],
        d2: 8.97778203566217551435,
        measured: [[0.292391, 0.070223, 0.015644], [-0.511175, 0.873992, 0.194751]],
        trapezoidal: [0.292386, 0.070220, 0.015643],
        left: -0.506573,
    });
}
