//! The geodesics of hyperbolic space: circular arcs in the ball model.

use nalgebra::SVector;
use tautline::{Jet2, Scalar, gallery::Hyperbolic};

use super::{KnownGeodesics, Motion};

/// Returns the image of `u` under Möbius addition, the isometry of the ball that takes `0` to `x`:
/// `((1 + 2 x·u + |u|²) x + (1 − |x|²) u) / (1 + 2 x·u + |x|² |u|²)`.
fn moved<S: Scalar, const D: usize>(x: &SVector<f64, D>, u: &SVector<S, D>) -> SVector<S, D> {
    let x2 = x.norm_squared();
    let (mut xu, mut u2) = (S::zero(), S::zero());
    for i in 0..D {
        xu += u[i] * x[i];
        u2 += u[i].sqr();
    }
    let twice = xu * 2.0 + 1.0;
    let inverse = (twice + u2 * x2).recip();
    SVector::from_fn(|i, _| ((twice + u2) * x[i] + u[i] * (1.0 - x2)) * inverse)
}

impl<const D: usize> KnownGeodesics<D> for Hyperbolic {
    /// The image of a ray from `0` under the isometry that takes `0` to `x`. After the length `s`,
    /// the ray has the radius `tanh (s/2)`. To first order in `u`, the isometry is
    /// `x + (1 − |x|²) u`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        let speed = v.norm();
        if speed == 0.0 {
            return Motion { position: *x, velocity: *v, acceleration: SVector::zeros() };
        }
        let [t] = Jet2::variables(&[t]);
        let radius = (t * (speed / (1.0 - x.norm_squared()))).tanh();
        let ray = SVector::from_fn(|i, _| Jet2::constant(v[i] / speed) * radius);
        Motion::of_jet(&moved(x, &ray))
    }

    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        let ray = moved(&-x, y);
        let radius = ray.norm();
        if radius == 0.0 {
            return SVector::zeros();
        }
        ray * ((1.0 - x.norm_squared()) * radius.atanh() / radius)
    }

    /// The distance to the rim of the ball, `2 artanh 1 − 2 artanh |x| = ∞`.
    fn normal_radius(&self, x: &SVector<f64, D>) -> f64 {
        2.0 * (1_f64.atanh() - x.norm().atanh())
    }
}
