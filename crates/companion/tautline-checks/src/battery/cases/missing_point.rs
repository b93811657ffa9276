//! The sphere without a point: curves round the missing point, none of which is shortest.

use nalgebra::SVector;
use tautline::gallery::Sphere;
use tautline_statements::{
    Known, VerifyError, WayOut,
    curves::{Curve, Geodesic, Motion},
};

/// A curve of two arcs of great circles, with a corner between them.
pub(crate) struct TwoArcs([Geodesic<Sphere, 2>; 2]);

impl Curve<2> for TwoArcs {
    fn motion(&self, t: f64) -> Motion<2> {
        let [first, second] = &self.0;
        let (arc, t) = if t < 0.5 { (first, 2.0 * t) } else { (second, 2.0 * t - 1.0) };
        let Motion { position, velocity, acceleration } = arc.motion(t);
        Motion { position, velocity: velocity * 2.0, acceleration: acceleration * 4.0 }
    }

    fn corners(&self) -> Vec<f64> {
        vec![0.5]
    }
}

/// Returns the curve from `(2, 0)` through `(0, r)` to `(−2, 0)`, and the length of the shortest
/// way out.
///
/// The shortest curve on the whole sphere has length `4 arctan ½`, but passes through the missing
/// point. The lengths of the returned curves tend to `d = 4 arctan ½` like `d + c/r²` as `r → ∞`,
/// and no curve attains it.
pub(crate) fn round_the_missing_point(
    r: f64,
) -> Result<(Known<Sphere, 2>, TwoArcs, WayOut), VerifyError> {
    let ends: [SVector<f64, 2>; 2] = [[2.0, 0.0].into(), [-2.0, 0.0].into()];
    let known = Known::joined(Sphere, ends)?.expect("known");
    let top = SVector::from([0.0, r]);
    let arcs = [[ends[0], top], [top, ends[1]]].map(|pair| Geodesic::between(Sphere, pair));
    Ok((known, TwoArcs(arcs), WayOut::from(&Sphere, &ends[0])))
}
