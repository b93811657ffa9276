//! The discrete geodesic, the discrete logarithm and the discrete exponential.

use nalgebra::SVector;
use tautline::{Ends, Metric, Options, PointSequence, Rule, minimise};

use super::{CalculusError, chord::Chord, step::extend_at};
use crate::not_finite::finite;

/// Returns a discrete geodesic of `n` chords from `x` to `y`: a sequence of least discrete energy
/// `N Σ W[xₖ, xₖ₊₁]`, as far as [`minimise`] finds it. Its points have errors `O(1/N²)`.
///
/// # Errors
///
/// [`CalculusError::NotFinite`] and [`CalculusError::Ends`] for the points, and [`CalculusError::Solve`] if there is no
/// minimiser, for instance for `n = 0`.
pub fn discrete_geodesic<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    n: usize,
) -> Result<PointSequence<D>, CalculusError> {
    finite("first point", x)?;
    finite("second point", y)?;
    let ends = Ends::points(*x, *y)?;
    Ok(minimise(metric, &ends, Rule::TRAPEZOIDAL, n, &Options::default())?.sequence)
}

/// Returns the discrete logarithm of `y` at `x`, in `ℓ`: `N (x₁ − x₀)`, the first difference of a
/// discrete geodesic of `n` chords. It differs from the logarithm by `O(1/N)`, since it is the mean
/// velocity over the time `1/N` (M. Rumpf, B. Wirth, Variational time discretization of geodesic
/// calculus, IMA J. Numer. Anal. 35 (2015)).
///
/// # Errors
///
/// As for [`discrete_geodesic`].
pub fn discrete_logarithm<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    n: usize,
) -> Result<SVector<f64, D>, CalculusError> {
    let geodesic = discrete_geodesic(metric, x, y, n)?;
    let (_, first) = geodesic.chord(0);
    Ok(first * n as f64)
}

/// Returns the discrete geodesic of `n` chords from `x` with the first chord `v/N`: each point
/// [`extends`](super::extend) the two before. Its last point is the discrete exponential of `v`, in
/// `ℓ`, which differs from `exp_x(v)` by `O(1/N)`. It inverts the discrete logarithm up to
/// rounding, where Newton's method takes the same branch.
///
/// # Errors
///
/// [`CalculusError::NotFinite`] for the point and the velocity, [`CalculusError::Sequence`] if `n`
/// is 0 or too large, and [`CalculusError::LeavesTheDomain`] and [`CalculusError::NoConvergence`]
/// with the number of the chord.
pub fn discrete_exponential<const D: usize>(
    metric: &impl Metric<D>,
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
    n: usize,
) -> Result<PointSequence<D>, CalculusError> {
    finite("point", x)?;
    finite("velocity", v)?;
    // This refuses numbers of chords that make no sequence, before memory is allocated.
    let mut points = PointSequence::straight(*x, *x, n)?.into_points();
    points[1] = x + v / n as f64;
    for step in 1..n {
        points[step + 1] = extend_at(metric, &points[step - 1], &points[step], step)?;
    }
    if n == 1 {
        // Nothing has looked at the only chord.
        Chord::new(metric, &points[0], &points[1])
            .map_err(|source| CalculusError::LeavesTheDomain { step: 0, source })?;
    }
    Ok(PointSequence::new(points)?)
}
