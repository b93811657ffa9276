//! The minimal geodesics of shears, for the propositions of Section 7 on geodesics.

use tautline::{Jet2, SVector, gallery::Shear};

/// Returns the minimal geodesic of a shear at the time `t`, its velocity and acceleration.
///
/// It is straight in flat coordinates; the way back from these is a formula over [`Scalar`], so
/// that a jet in `t` gives the derivatives.
///
/// [`Scalar`]: tautline::Scalar
pub(crate) fn geodesic(
    metric: &Shear,
    [a, b]: [SVector<f64, 2>; 2],
    t: f64,
) -> [SVector<f64, 2>; 3] {
    let (p, q) = (metric.flatten(&a), metric.flatten(&b));
    let [t] = Jet2::variables(&[t]);
    let flat = SVector::<Jet2<f64, 1>, 2>::from_fn(|i, _| t * (q[i] - p[i]) + p[i]);
    let curve = metric.unflatten(&flat);
    [curve.map(|x| x.value()), curve.map(|x| x.first(0)), curve.map(|x| x.second(0, 0))]
}
