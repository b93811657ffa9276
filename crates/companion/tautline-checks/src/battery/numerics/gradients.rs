//! Compares the gradient of a discrete energy with difference quotients of the energy.
//!
//! The error of central differences with step `h` is `h² ∂³E/6 + …`, so it is of order 2 if the
//! gradient is right and of order 0 otherwise. The slope on logarithmic axes distinguishes the two
//! cases, without a tolerance for the size of the error.

use nalgebra::SVector;
use tautline::{
    Metric, PointSequence, Rule,
    gallery::{CoupledCosines, Separable, Shear, Valleys},
};
use tautline_statements::{
    Statement::{self, Theorem1_1, Theorem1_3},
    Subject, VerifyError,
};

use crate::battery::harness::{Check, Order, Outcome, Trial, all, has_slope};

const BOTH: &[Statement] = &[Theorem1_1, Theorem1_3];

pub(crate) const CHECKS: &[Check] =
    &[Order.check("gradients_agree_with_differences_of_order_2", BOTH, |trial| {
        all([
            metric(trial, &Shear::new(0.5, 1.3).expect("valid")),
            metric::<_, 2>(trial, &Valleys),
            metric(trial, &Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).expect("valid")),
            metric(trial, &CoupledCosines),
        ])
    })];

/// The steps. The next term of the error is `h²/20` of the first, times the square of a wave number
/// up to 4. Rounding contributes `ε E/h`, some `10⁻¹³`, compared with `h²`.
const STEPS: [f64; 4] = [0.04, 0.02, 0.01, 0.005];

/// Returns a point sequence with `N = 7` and without any symmetry.
fn zigzag<const D: usize>() -> Result<PointSequence<D>, VerifyError> {
    let at = |k: usize| {
        SVector::from_fn(|i, _| 0.4 * k as f64 + (2.3 * (k + 1) as f64 * (i + 1) as f64).sin())
    };
    Ok(PointSequence::new((0..8).map(at).collect())?)
}

/// Returns a direction in which all points move, different for each `k`.
fn direction<const D: usize>(k: usize) -> Vec<SVector<f64, D>> {
    let entry = |n: usize, i: usize| (1.7 * k as f64 + 2.9 * n as f64 + 1.1 * i as f64 + 0.3).sin();
    (0..8).map(|n| SVector::from_fn(|i, _| entry(n, i))).collect()
}

fn metric<M: Metric<D>, const D: usize>(trial: &Trial<'_>, metric: &M) -> Outcome {
    slopes(trial.subject, metric, Rule::TRAPEZOIDAL)?;
    slopes(trial.subject, metric, Rule::LEFT_ENDPOINT)
}

fn slopes<M: Metric<D>, const D: usize>(subject: &Subject, metric: &M, rule: Rule) -> Outcome {
    let sequence = zigzag::<D>()?;
    let gradient = subject.energy_gradient(rule, metric, &sequence);
    let energy = |along: &[SVector<f64, D>], step: f64| -> Result<f64, VerifyError> {
        let moved = sequence.points().iter().zip(along).map(|(x, v)| x + v * step).collect();
        Ok(subject.discrete_energy(rule, metric, &PointSequence::new(moved)?))
    };
    let mut errors = Vec::new();
    for step in STEPS {
        // Several directions are used, since ∂³E may be close to 0 in a single one.
        let mut squares = 0.0;
        for k in 0..8 {
            let along = direction(k);
            let exact: f64 = gradient.iter().zip(&along).map(|(g, v)| g.dot(v)).sum();
            let difference = (energy(&along, step)? - energy(&along, -step)?) / (2.0 * step);
            squares += (difference - exact).powi(2);
        }
        errors.push((step, squares.sqrt()));
    }
    has_slope(&format!("{rule} in {D} dimensions"), &errors, 2.0, 0.1)
}
