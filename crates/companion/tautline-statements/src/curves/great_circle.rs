//! The geodesics of the sphere: great circles, in stereographic coordinates.

use nalgebra::SVector;
use tautline::{Jet2, Scalar, gallery::Sphere};

use super::{KnownGeodesics, Motion, geodesic::line};

/// A point of `S^D ⊂ R^{D+1}`: its first `D` coordinates, and its last coordinate, which is 1 at
/// the missing point.
type Ambient<S, const D: usize> = (SVector<S, D>, S);

/// Returns the point `(2x, |x|² − 1) / (|x|² + 1)` of the sphere.
fn lift<S: Scalar, const D: usize>(x: &SVector<S, D>) -> Ambient<S, D> {
    let r2 = x.iter().fold(S::zero(), |sum, xi| sum + xi.sqr());
    let inverse = (r2 + 1.0).recip();
    (x.map(|xi| xi * inverse * 2.0), (r2 - 1.0) * inverse)
}

/// Returns the coordinates `p / (1 − q)` of a point `(p, q)` of the sphere.
fn project<S: Scalar, const D: usize>((p, q): &Ambient<S, D>) -> SVector<S, D> {
    let inverse = (-*q + 1.0).recip();
    p.map(|pi| pi * inverse)
}

impl<const D: usize> KnownGeodesics<D> for Sphere {
    /// The projection of `P cos θt + T sin θt`, where `P` projects to `x` and `θT` to `v`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        let (p, q) = lift(&line(x, v, 0.0));
        let (tangent, last) = (p.map(|p| p.first(0)), q.first(0));
        let angle = (tangent.norm_squared() + last * last).sqrt();
        if angle == 0.0 {
            return Motion { position: *x, velocity: *v, acceleration: SVector::zeros() };
        }
        let [t] = Jet2::variables(&[t]);
        let (sin, cos) = (t * angle).sin_cos();
        let turned = SVector::from_fn(|i, _| cos * p[i].value() + sin * (tangent[i] / angle));
        Motion::of_jet(&project(&(turned, cos * q.value() + sin * (last / angle))))
    }

    /// The initial velocity along the shorter arc. Between antipodes there are many, and it is one
    /// of them.
    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        let ((p, q), (to, last)) = (lift(x), lift(y));
        let cos = p.dot(&to) + q * last;
        let (side, up) = (to - p * cos, last - q * cos);
        let sin = (side.norm_squared() + up * up).sqrt();
        if sin == 0.0 {
            return SVector::zeros();
        }
        let scale = sin.atan2(cos) / sin;
        // This is the derivative of the projection at P, in a direction orthogonal to P.
        let [t] = Jet2::variables(&[0.0]);
        let moved = line(&p, &(side * scale), 0.0);
        project(&(moved, t * (up * scale) + q)).map(|x| x.first(0))
    }

    /// `π − 2 arctan |x|`, the angle to the missing point.
    fn normal_radius(&self, x: &SVector<f64, D>) -> f64 {
        2.0 * 1_f64.atan2(x.norm())
    }
}
