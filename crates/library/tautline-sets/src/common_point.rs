//! A common point of two closed sets, by projections.

use nalgebra::SVector;
use tautline_scalar::Interval;

use crate::numerics::norm::norm;
use crate::numerics::place::{Place, minus, plus};
use crate::{AnySet, ClosedSet, InAny};

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
/// within `(D + 4) ε max |xᵢ|`, and exactly if both are points or boxes.
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
    common_point_of(&InAny(a), &InAny(b)).map(|x| SVector::from_column_slice(&x))
}

/// Looks for a point that lies in both sets like [`common_point`], in a dimension that is a value.
#[must_use]
pub fn common_point_of(a: &dyn AnySet, b: &dyn AnySet) -> Option<Vec<f64>> {
    let origin = vec![0.0; a.dimension()];
    let mut projected = origin.clone();
    b.project(&mut projected);
    let starts = [origin, projected].into_iter().chain(a.seeds()).chain(b.seeds());
    starts.into_iter().find_map(|start| search(a, b, &start)).map(|x| x.to_vec())
}

fn projected(set: &dyn AnySet, x: &[f64]) -> Place {
    let mut nearest = Place::from_slice(x);
    set.project(&mut nearest);
    nearest
}

/// A point of `a`, its projection to `b`, and their distance.
struct Sweep {
    in_a: Place,
    in_b: Place,
    gap: f64,
}

impl Sweep {
    fn from(a: &dyn AnySet, b: &dyn AnySet, x: &[f64]) -> Sweep {
        let in_a = projected(a, x);
        let in_b = projected(b, &in_a);
        let gap = norm(&minus(&in_b, &in_a));
        Sweep { in_a, in_b, gap }
    }
}

fn search(a: &dyn AnySet, b: &dyn AnySet, start: &[f64]) -> Option<Place> {
    let mut here = Sweep::from(a, b, start);
    for _ in 0..SWEEPS {
        if let Some(x) = [&here.in_b, &here.in_a].into_iter().find(|x| lies_in_both(a, b, x)) {
            return Some(x.clone());
        }
        let mut best = Sweep::from(a, b, &here.in_b);
        let step = minus(&best.in_a, &here.in_a);
        let mut factor = 2.0;
        for _ in 0..DOUBLINGS {
            let trial = Sweep::from(a, b, &plus(&here.in_a, &step, factor));
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
    let unit: Place = minus(&here.in_b, &here.in_a).iter().map(|x| x / here.gap).collect();
    [1.0, 0.125, 1.0 / 64.0]
        .iter()
        .find_map(|fraction| reflect(a, b, plus(&here.in_a, &unit, size * fraction)))
}

/// One step of the Douglas–Rachford iteration: `z ← z + P_b(2 P_a(z) − z) − P_a(z)`.
///
/// At a fixed point, `p = P_a(z)` lies in both sets: with `w = z − p`,
/// `p = P_a(p + w) = P_b(p − w)`.
fn reflect(a: &dyn AnySet, b: &dyn AnySet, mut z: Place) -> Option<Place> {
    for _ in 0..REFLECTIONS {
        let in_a = projected(a, &z);
        let reflected: Place = in_a.iter().zip(&z).map(|(x, z)| x * 2.0 - z).collect();
        let in_b = projected(b, &reflected);
        let step = minus(&in_b, &in_a);
        if let Some(x) = [in_b, in_a].into_iter().find(|x| lies_in_both(a, b, x)) {
            return Some(x);
        }
        z.iter_mut().zip(&step).for_each(|(z, step)| *z += step);
    }
    None
}

fn lies_in_both(a: &dyn AnySet, b: &dyn AnySet, x: &[f64]) -> bool {
    // Let M be the largest coordinate. A coordinate of a projection such as c + r u makes two
    // roundings of numbers up to 2M, 2 · 2M · ε/2, for each of the two sets: 4 ε M. A product n·x
    // adds D roundings of at most ε/2 · √D M · |nᵢ| ≤ ε M each.
    let largest = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let tolerance = (x.len() + 4) as f64 * f64::EPSILON * largest;
    // NaN fails this comparison, while the largest coordinate would ignore it.
    let agrees = |p: Place| p.iter().zip(x).all(|(p, x)| (p - x).abs() <= tolerance);
    agrees(projected(a, x)) && agrees(projected(b, x)) && !is_outside_exactly([a, b], x)
}

/// Returns whether both sets know their nearest points to `x` exactly, as points and boxes do, and one of
/// them is not `x`. Where coordinates have different units, a rounding of the largest may be a long way in
/// another one.
fn is_outside_exactly(sets: [&dyn AnySet; 2], x: &[f64]) -> bool {
    let members = sets.map(|set| set.member_near(x));
    let [Some(a), Some(b)] = &members else { return false };
    let is_exact = |x: &Interval| x.lo() == x.hi();
    let all = || a.iter().chain(b).zip(x.iter().chain(x));
    all().all(|(member, _)| is_exact(member)) && all().any(|(member, x)| member.lo() != *x)
}

#[cfg(test)]
mod tests;
