//! A common point of two closed sets, by projections.

use nalgebra::SVector;

use crate::ClosedSet;
use crate::norm::norm;

/// The number of sweeps of alternating projections for each start. The step of each sweep is
/// doubled as long as that helps. Sets that cross need about ten sweeps. Sets that touch smoothly
/// need about twenty to reach a gap of `ε^{2/3}`, at which the step is lost in rounding.
const SWEEPS: usize = 100;

/// The largest number of doublings of a step. If two sets touch smoothly, the step is a fraction
/// `t²` of the remaining distance `t`. It is lost in rounding at `t² = ε`: after 52 doublings, by
/// 2⁵². The rest is a reserve.
const DOUBLINGS: usize = 60;

/// The number of steps of the Douglas–Rachford iteration. Each multiplies the error by `r/(r + t)`,
/// where `r` is the radius of curvature and `t` is the distance that the iteration keeps from the
/// contact. For `t ≥ r/10`, 200 steps reduce the error to `1e-8`, and hence the gap to `1e-16`.
const REFLECTIONS: usize = 200;

/// Looks for a point that lies in both sets up to rounding, in `ℓ`.
///
/// Alternating projections `x ← P_a(P_b(x))` start from the projections of the origin and from the
/// [`seeds`](ClosedSet::seeds) of the sets. Each step is doubled as long as the gap shrinks. If
/// they stall just short of a contact, the Douglas–Rachford iteration takes over: it keeps a
/// distance from the contact along the common normal, where normals are well determined. For
/// unions, call this function pair by pair ([`Ends::pairs`](crate::Ends::pairs)).
///
/// `Some(x)` is verified: in every coordinate, the nearest points of both sets agree with `x` to
/// within `(D + 4) ε max |xᵢ|`.
///
/// `None` does not prove that the sets are disjoint. It is also returned at a local minimum of the
/// distance to a nonconvex set; if sets touch in one point near the origin but are defined by much
/// larger numbers, whose rounding hides the contact; and if a contact is so flat that the bounded
/// number of steps does not suffice.
///
/// ```
/// # use tautline_sets::{Ball, HalfSpace, SetError, common_point};
/// let ball = Ball::new([0.0, 0.0], 1.0)?;
/// let touching = HalfSpace::at_least([1.0, 0.0], 1.0)?;
/// assert_eq!(common_point(&ball, &touching), Some([1.0, 0.0].into()));
/// assert_eq!(common_point(&ball, &HalfSpace::at_least([1.0, 0.0], 1.5)?), None);
/// # Ok::<(), SetError>(())
/// ```
#[must_use]
pub fn common_point<const D: usize>(
    a: &dyn ClosedSet<D>,
    b: &dyn ClosedSet<D>,
) -> Option<SVector<f64, D>> {
    let origin = SVector::zeros();
    let starts = [origin, b.project(&origin)].into_iter().chain(a.seeds()).chain(b.seeds());
    starts.into_iter().find_map(|start| search(a, b, &start))
}

/// A point of `a`, its projection to `b`, and their distance.
struct Sweep<const D: usize> {
    in_a: SVector<f64, D>,
    in_b: SVector<f64, D>,
    gap: f64,
}

impl<const D: usize> Sweep<D> {
    fn from(a: &dyn ClosedSet<D>, b: &dyn ClosedSet<D>, x: &SVector<f64, D>) -> Sweep<D> {
        let in_a = a.project(x);
        let in_b = b.project(&in_a);
        Sweep { in_a, in_b, gap: norm(&(in_b - in_a)) }
    }
}

fn search<const D: usize>(
    a: &dyn ClosedSet<D>,
    b: &dyn ClosedSet<D>,
    start: &SVector<f64, D>,
) -> Option<SVector<f64, D>> {
    let mut here = Sweep::from(a, b, start);
    for _ in 0..SWEEPS {
        if let Some(&x) = [&here.in_b, &here.in_a].into_iter().find(|x| lies_in_both(a, b, x)) {
            return Some(x);
        }
        let mut best = Sweep::from(a, b, &here.in_b);
        let step = best.in_a - here.in_a;
        let mut factor = 2.0;
        for _ in 0..DOUBLINGS {
            let trial = Sweep::from(a, b, &(here.in_a + step * factor));
            if !(trial.gap < best.gap) {
                break;
            }
            best = trial;
            factor *= 2.0;
        }
        // The sweeps stall, or the gap is NaN. For convex sets the gap of plain sweeps never grows.
        if !(best.gap < here.gap) {
            break;
        }
        here = best;
    }
    // A common point is no farther from the origin than the smaller radius, which bounds the
    // numbers that matter.
    let size = [a.radius(), b.radius()]
        .into_iter()
        .flatten()
        .reduce(f64::min)
        .unwrap_or_else(|| norm(&here.in_a));
    // At a contact the gap stalls at ε^{2/3} = 4e-11 of the size. A gap a thousand times as wide
    // separates the sets.
    if !(here.gap <= 1e-7 * size) {
        return None;
    }
    // A large distance makes the iteration slow if both sets are strongly curved. It makes the
    // iteration fail beyond the centre of a hollow sphere.
    let unit = (here.in_b - here.in_a) / here.gap;
    [1.0, 0.125, 1.0 / 64.0]
        .iter()
        .find_map(|fraction| reflect(a, b, here.in_a + unit * (size * fraction)))
}

/// One step of the Douglas–Rachford iteration: `z ← z + P_b(2 P_a(z) − z) − P_a(z)`.
///
/// At a fixed point, `p = P_a(z)` lies in both sets: with `w = z − p`,
/// `p = P_a(p + w) = P_b(p − w)`.
fn reflect<const D: usize>(
    a: &dyn ClosedSet<D>,
    b: &dyn ClosedSet<D>,
    mut z: SVector<f64, D>,
) -> Option<SVector<f64, D>> {
    for _ in 0..REFLECTIONS {
        let in_a = a.project(&z);
        let in_b = b.project(&(in_a * 2.0 - z));
        if let Some(x) = [in_b, in_a].into_iter().find(|x| lies_in_both(a, b, x)) {
            return Some(x);
        }
        z += in_b - in_a;
    }
    None
}

fn lies_in_both<const D: usize>(
    a: &dyn ClosedSet<D>,
    b: &dyn ClosedSet<D>,
    x: &SVector<f64, D>,
) -> bool {
    // Let M be the largest coordinate. A coordinate of a projection such as c + r u makes two
    // roundings of numbers up to 2M, 2 · 2M · ε/2, for each of the two sets: 4 ε M. A product n·x
    // adds D roundings of at most ε/2 · √D M · |nᵢ| ≤ ε M each.
    let tolerance = (D + 4) as f64 * f64::EPSILON * x.amax();
    // NaN fails this comparison, while amax would ignore it.
    let agrees = |p: SVector<f64, D>| (p - x).iter().all(|d| d.abs() <= tolerance);
    agrees(a.project(x)) && agrees(b.project(x))
}

#[cfg(test)]
mod tests;
