//! The answer to Remark 9.2, each time without one of its hypotheses.

use nalgebra::SVector;
use tautline::{Constants, PointSequence};
use tautline_statements::{
    LIBRARY, PaperRule, Reconstruction,
    Statement::{self, Remark9_2},
    critical_point, remark_9_2, remark_9_2_for_any_sequence,
};

use crate::battery::{
    cases::{
        claiming,
        clauses::{ABOVE, BELOW, ENDS, LIPSCHITZ},
        routes::{
            beyond_the_end, cheap_second_route, claimed, downwards, level, longer_way, ridge, steep,
        },
        sheared,
    },
    harness::{Check, Dropped, Failure, Outcome, Trial, fails_without, for_rules, holds_without},
    paper::section_9::washboard,
};

const R92: &[Statement] = &[Remark9_2];

pub(crate) const CHECKS: &[Check] = &[
    Dropped.check("remark_9_2_fails_for_a_slope_that_is_not_admitted", R92, understated_l_h),
    Dropped.check("remark_9_2_fails_with_false_bounds_of_h", R92, false_bounds),
    Dropped.check("remark_9_2_fails_for_other_ends", R92, other_ends),
    Dropped.check("remark_9_2_fails_for_a_minimiser_that_is_not_global", R92, not_global),
    Dropped.check("remark_9_2_holds_for_points_that_are_not_stationary", R92, not_stationary),
];

/// The washboard has slope ½, but `L_H = 10⁻³` is claimed. `E(γᵖˡ) − d²` is `1/32π` to within a
/// thousandth, far above the bound for the claimed `L_H`.
fn understated_l_h(_: &Trial<'_>) -> Outcome {
    let (_, known) = washboard(8, 0.5)?;
    let known = claiming(known, Constants::new(1.0, 2.0, 1e-3)?);
    let seen = Reconstruction::observe(&LIBRARY, &known, PaperRule::Trapezoidal, 8)?;
    fails_without(&[LIPSCHITZ], remark_9_2(&LIBRARY, &seen))
}

/// With `c₁ = 100`, a route that seems cheap could exceed `d²` by at most `10⁻⁴`, but it exceeds
/// `d²` by 0.02. With `c₂ = c₁`, no discrete minimum could be above `d²`, but on a ridge it is.
fn false_bounds(_: &Trial<'_>) -> Outcome {
    for (rule, first) in PaperRule::BOTH.into_iter().zip([ridge(1.0), downwards(1.0)]) {
        let cheap = cheap_second_route(rule, [100.0, 100.0, 0.1])?;
        fails_without(&[BELOW], remark_9_2(&LIBRARY, &cheap))?;
        let dear = claimed(rule, [steep(first), level(2.0)], [1.0, 1.0, 0.1])?;
        fails_without(&[ABOVE], remark_9_2(&LIBRARY, &dear))?;
    }
    Ok(Default::default())
}

/// `E − d² = 0.226`, while `d² (e − 1)` is at most `0.1 d³/2N`.
fn other_ends(_: &Trial<'_>) -> Outcome {
    for_rules([16], |rule, n| {
        fails_without(&[ENDS], remark_9_2(&LIBRARY, &beyond_the_end(rule, n)?))
    })
}

/// The sequence is another local minimiser from set to set. It has `E_N = E = 4`, while `d² e = 1`.
fn not_global(_: &Trial<'_>) -> Outcome {
    for_rules([8], |rule, n| {
        let (_, seen) = longer_way(rule, n)?;
        fails_without(&["E_N ≤ d² e"], remark_9_2_for_any_sequence(&LIBRARY, &seen))
    })
}

/// The inner points of the minimiser between two points under a shear are moved as far as
/// `E_N ≤ d² e` allows, up to a factor of two. Then `ρ` is far from 0, and the conclusions still
/// hold.
fn not_stationary(_: &Trial<'_>) -> Outcome {
    let (known, _) = sheared();
    for_rules([2, 3, 5, 16], |rule, n| {
        let mut minimum = LIBRARY.minimise(rule.into(), &known.metric, &known.ends, n)?;
        let still = minimum.sequence.points().to_vec();
        for size in (0..40).map(|k| 4.0 * 0.5_f64.powi(k)) {
            let mut points = still.clone();
            for (k, point) in points[1..n].iter_mut().enumerate() {
                let (sin, cos) = (7.0 * k as f64 + 1.0).sin_cos();
                *point += SVector::from([sin, cos]) * size;
            }
            minimum.sequence = PointSequence::new(points)?;
            let seen = Reconstruction::read(&LIBRARY, &known, rule, minimum.clone())?;
            let evidence = remark_9_2_for_any_sequence(&LIBRARY, &seen);
            if evidence.hypotheses.iter().all(|clause| clause.holds()) {
                let critical = critical_point(&LIBRARY, &known, &seen);
                let rho = critical.conclusion("((1/N) Σ |ρₙ|²)^{1/2} = 0");
                let numbers = [rho.observed, rho.bound];
                let evidence = evidence.given(rho.claim, rho.unit, numbers, rho.granted);
                return holds_without(&["|ρₙ|²"], evidence);
            }
        }
        Err(Failure::new(format!("N = {n}: nothing admitted")))
    })
}
