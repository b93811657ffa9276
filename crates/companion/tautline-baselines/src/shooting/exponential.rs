//! `exponential`: integrates the geodesic equation.

use differential_equations::{
    error::Error, methods::ExplicitRungeKutta, ode::OrdinaryNumericalMethod, status::Status,
    traits::State,
};
use nalgebra::SVector;
use tautline::{Metric, norm_squared};

use super::{
    Integration, ShootingError,
    flow::{Equation, Flow},
    geodesic::{Derivatives, Geodesic, Step},
};
use crate::{
    EquationError,
    geodesic_equation::{Acceleration, in_range},
    not_finite::finite,
};

/// Returns the geodesic `γ(t) = exp_x(tv)` over `t ∈ [0, 1]`: the solution of
///
/// ```text
/// γ̈ = −H⁻¹ ( DH[γ̇]γ̇ − ½ ∇ₓ(vᵀHv)|_{v = γ̇} ),    γ(0) = x,    γ̇(0) = v
/// ```
///
/// for a point `x` and a velocity `v`, both in `ℓ`, with its derivatives by `x` and `v` from the
/// variational equation. The integrator is the method of order 8 of Dormand and Prince (E. Hairer,
/// S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd ed., II.5 and II.6).
/// The estimated error of a step is at most the tolerance times the largest `|vᵢ|`, as a root mean
/// square over position, velocity and their derivatives. Between the steps, where no error is
/// estimated, the geodesic is the polynomial of degree 7 that has the right derivatives up to third
/// order at both ends of the step.
///
/// # Errors
///
/// - [`ShootingError::NotFinite`] and [`ShootingError::Tolerance`] for such input;
/// - [`ShootingError::LeavesTheDomain`] if the metric makes no geodesic equation at `x` (time 0) or
///   further on;
/// - [`ShootingError::StepTooSmall`] if the geodesic runs to infinity within the time 1;
/// - [`ShootingError::TooManySteps`] beyond the limit of the options;
/// - [`ShootingError::Energy`] if the energy overflows or underflows.
pub fn exponential<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
    options: &Integration,
) -> Result<Geodesic<D>, ShootingError> {
    finite("point", x)?;
    finite("velocity", v)?;
    let Integration { tolerance, steps: limit } = *options;
    if !(1e-14..=1e-2).contains(&tolerance) {
        return Err(ShootingError::Tolerance { tolerance });
    }
    let leaves = |time| move |source| ShootingError::LeavesTheDomain { time, source };
    let mut first = derivatives(metric, x, v).map_err(leaves(0.0))?;
    let square = energy(metric, x, v)?;
    let equation = Equation::new(metric);
    let start = Flow::start(x, v);
    // Positions and velocities are measured by |v|, so that neither the units nor the place of the
    // origin matter. The derivatives are pure numbers, whose size is 1 at first.
    let speed = v.amax().max(f64::MIN_POSITIVE / tolerance);
    let sizes: Vec<f64> = (0..start.len()).map(|i| if i < 2 * D { speed } else { 1.0 }).collect();
    let relative = (0..start.len()).map(|i| if i < 2 * D { 0.0 } else { tolerance });
    let mut solver = ExplicitRungeKutta::dop853()
        .rtol(relative.collect::<Vec<f64>>())
        .atol(sizes.iter().map(|size| tolerance * size).collect::<Vec<f64>>())
        .h0(0.125)
        .h_max(1.0)
        .max_steps(limit);
    let mut steps = Vec::new();
    let stopped = |error, time, step| match (error, equation.take_failure()) {
        (Some(Error::MaxSteps { .. }), _) => ShootingError::TooManySteps { steps: limit, time },
        (_, Some(source)) => ShootingError::LeavesTheDomain { time, source },
        (_, None) => ShootingError::StepTooSmall { time, step },
    };
    let begun = solver.init(&equation, 0.0, 1.0, &start);
    begun.map_err(|error| stopped(Some(error), 0.0, 0.125))?;
    loop {
        let time = solver.t();
        let remaining = 1.0 - time;
        // A last step of less than a few roundings is not taken alone.
        if solver.h() > remaining * (1.0 - 1e-12) {
            solver.set_h(remaining);
        }
        if solver.h() <= 4.0 * f64::EPSILON && remaining > 8.0 * f64::EPSILON {
            return Err(stopped(None, time, solver.h()));
        }
        let step = solver.h();
        solver.step(&equation).map_err(|error| stopped(Some(error), time, step))?;
        if matches!(solver.status(), Status::RejectedStep) {
            continue;
        }
        equation.take_failure();
        let Flow { position, velocity, .. } = solver.y();
        let last = derivatives(metric, position, velocity).map_err(leaves(time))?;
        steps.push(Step { begin: time, end: solver.t(), first, last });
        first = last;
        if 1.0 - solver.t() <= 8.0 * f64::EPSILON {
            break;
        }
    }
    let last = solver.y().clone();
    let squares = [square, energy(metric, &last.position, &last.velocity)?];
    Ok(Geodesic { steps, last, squares })
}

/// Returns `vᵀHv`, in `m²`, if it has all its digits.
fn energy<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
) -> Result<f64, ShootingError> {
    let energy = norm_squared(metric, x, v);
    if in_range(energy, v.amax() == 0.0) {
        Ok(energy)
    } else {
        Err(ShootingError::Energy { energy })
    }
}

// The interpolation of the library is not used: in version 0.7.0 that of this method exchanges the
// fractions `s` and `1 − s` of a step in its highest terms. The third derivative is at hand anyway.

/// Returns `γ`, `γ̇`, `γ̈` and `γ⃛ = (∂a/∂x) γ̇ + (∂a/∂v) γ̈`, in `ℓ`.
fn derivatives<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
) -> Result<Derivatives<D>, EquationError> {
    let a = Acceleration::new(metric, x, v)?;
    Ok([*x, *v, a.value, a.by_position * v + a.by_velocity * a.value])
}
