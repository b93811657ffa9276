//! Helpers for metrics with a centre: the squared norm, a Gaussian profile, and lengths along a
//! ray.

use nalgebra::SVector;
use tautline_scalar::Scalar;

use crate::quadrature::integrate;

/// Returns `|x|²`.
#[inline]
pub(super) fn squared_norm<S: Scalar, const D: usize>(x: &SVector<S, D>) -> S {
    x.iter().fold(S::zero(), |sum, xi| sum + xi.sqr())
}

/// Returns `e^{−|x|²/2s²}`.
#[inline]
pub(super) fn gaussian<S: Scalar, const D: usize>(x: &SVector<S, D>, width: f64) -> S {
    (squared_norm(x) * (-0.5 / (width * width))).exp()
}

/// Returns `|∫ speed|` between two points on one ray from the origin, and `None` if they are not on
/// one ray. In dimension 1 the whole line counts as one ray.
///
/// The function `speed(r)` must be even, must differ from 1 by at most a multiple of the Gaussian
/// of the given width, and must be the largest function with `√(uᵀ H(x) u) ≥ speed(|x|) |uᵣ|`,
/// where `uᵣ` is the radial part of `u`. Then `U(x) = ∫₀^|x| speed` grows along a curve by at most
/// its length, so that `|U(x) − U(y)| ≤ d(x, y)`, with equality for the segment of the ray. This
/// argument does not cover two points on opposite sides of the centre: a curve around the centre
/// may be shorter.
pub(super) fn along_ray<const D: usize>(
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    width: f64,
    speed: impl Fn(f64) -> f64,
) -> Option<f64> {
    let (a, b) = radii(x, y)?;
    let (a, b) = (a.min(b), a.max(b));
    // Beyond 12 widths the Gaussian is below e^{−72} < 1e-31, so speed = 1 in f64. We cut off there
    // and split at the centre, which keeps every interval short enough for the nodes of the
    // quadrature to see the profile. If they missed it, the error would go unnoticed.
    let reach = 12.0 * width;
    let inner = |a: f64, b: f64| integrate(&speed, a, b, 1e-15).value;
    let clamp = |r: f64, low: f64, high: f64| r.max(low).min(high);
    let outside = (b - clamp(b, -reach, reach)) - (a - clamp(a, -reach, reach));
    let left = inner(clamp(a, -reach, 0.0), clamp(b, -reach, 0.0));
    let right = inner(clamp(a, 0.0, reach), clamp(b, 0.0, reach));
    Some(outside + left + right)
}

/// Returns the radii of two points on one ray (up to rounding), with signs in dimension 1.
fn radii<const D: usize>(x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<(f64, f64)> {
    if D == 1 {
        // In more dimensions the comparisons below reject points that are not finite.
        return (x[0] - y[0]).is_finite().then_some((x[0], y[0]));
    }
    let (a, b) = (x.norm(), y.norm());
    let (short, long) = if a < b { (x, y) } else { (y, x) };
    let (inner, square) = (short.dot(long), long.norm_squared());
    if square == 0.0 {
        return Some((0.0, 0.0));
    }
    // The fraction inner / square has D + 2 roundings, and the difference two more. For a point so
    // close to the ray the distance is right to rounding, since d is √c₂-Lipschitz.
    let off = (short - long * (inner / square)).norm();
    let same = inner >= 0.0 && off <= (D as f64 + 4.0) * f64::EPSILON * a.min(b);
    same.then_some((a, b))
}
