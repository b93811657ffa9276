//! The two equations of the calculus for three points, solved by Newton's method.

use nalgebra::{SMatrix, SVector};
use tautline::Metric;

use super::{CalculusError, chord::Chord};
use crate::{EquationError, not_finite::finite};

/// The largest number of Newton steps for one point. From a neighbour it takes two to five.
const LIMIT: usize = 50;

/// Returns the point `z`, in `ℓ`, for which `x, y, z` is a discrete geodesic:
///
/// ```text
/// ∂₂W[x, y] + ∂₁W[y, z] = 0
/// ```
///
/// This is the discrete exponential `Exp²ₓ(y − x)` of two chords (M. Rumpf, B. Wirth, Variational
/// time discretization of geodesic calculus, IMA J. Numer. Anal. 35 (2015)). The solution is the
/// one next to `2y − x`.
///
/// # Errors
///
/// [`CalculusError::NotFinite`] for such points; [`CalculusError::LeavesTheDomain`] and
/// [`CalculusError::NoConvergence`], both with the step 1 for the chord from `y` to `z`, and 0 for
/// the chord before.
pub fn extend<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
) -> Result<SVector<f64, D>, CalculusError> {
    finite("first point", x)?;
    finite("second point", y)?;
    extend_at(metric, x, y, 1)
}

/// Returns the point after `x` and `y`; errors name the chord with the number `step`.
pub(crate) fn extend_at<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    step: usize,
) -> Result<SVector<f64, D>, CalculusError> {
    let leaves = |step| move |source| CalculusError::LeavesTheDomain { step, source };
    let before = Chord::new(metric, x, y).map_err(leaves(step - 1))?;
    solve(step, y + (y - x), &[*x, *y], |z| {
        let after = Chord::new(metric, y, z)?;
        Ok((before.gradients[1] + after.gradients[0], after.mixed))
    })
}

/// Returns the point `y`, in `ℓ`, for which `x, y, z` is a discrete geodesic: where
/// `W[x, y] + W[y, z]` is stationary, next to the middle of the chord from `x` to `z`.
///
/// # Errors
///
/// As for [`extend`], with the step 0.
pub fn midpoint<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    z: &SVector<f64, D>,
) -> Result<SVector<f64, D>, CalculusError> {
    finite("first point", x)?;
    finite("second point", z)?;
    midpoint_at(metric, x, z, 0)
}

/// Returns the middle of `x` and `z`; errors name the chord with the number `step`.
pub(crate) fn midpoint_at<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    z: &SVector<f64, D>,
    step: usize,
) -> Result<SVector<f64, D>, CalculusError> {
    solve(step, x * 0.5 + z * 0.5, &[*x, *z], |y| {
        let (before, after) = (Chord::new(metric, x, y)?, Chord::new(metric, y, z)?);
        Ok((before.gradients[1] + after.gradients[0], before.own[1] + after.own[0]))
    })
}

/// The value and the derivative of an equation.
type Linear<const D: usize> = Result<(SVector<f64, D>, SMatrix<f64, D, D>), EquationError>;

/// Solves `equation`, which returns its value and its derivative, from `at`.
fn solve<const D: usize>(
    step: usize,
    mut at: SVector<f64, D>,
    near: &[SVector<f64, D>; 2],
    equation: impl Fn(&SVector<f64, D>) -> Linear<D>,
) -> Result<SVector<f64, D>, CalculusError> {
    let mut length = f64::INFINITY;
    for _ in 0..LIMIT {
        let (value, derivative) =
            equation(&at).map_err(|source| CalculusError::LeavesTheDomain { step, source })?;
        let inverse = derivative.try_inverse();
        let Some(correction) = inverse.map(|inverse| inverse * value) else {
            return Err(CalculusError::NoConvergence { step, correction: f64::INFINITY });
        };
        let before = length;
        length = correction.norm();
        if !length.is_finite() {
            break;
        }
        // A step is no longer than the chord, so that it stays where the equation means something.
        let chord = (near[1] - near[0]).norm();
        at -= correction * if length > chord { chord / length } else { 1.0 };
        // Newton's method squares the relative size of a step, so that after one of 10⁻¹⁰ there is
        // nothing left but rounding. Points that are as near as roundings take steps of a few
        // roundings, which no longer decrease.
        let extent = near.iter().fold(at.amax(), |most, x| most.max(x.amax()));
        if length <= 1e-10 * chord || (length >= 0.5 * before && length <= 1e-13 * extent) {
            return Ok(at);
        }
    }
    Err(CalculusError::NoConvergence { step, correction: length })
}
