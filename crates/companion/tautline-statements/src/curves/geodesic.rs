//! `Geodesic`: a geodesic of a metric whose geodesics are known.

use nalgebra::SVector;
use tautline::{
    Bounded, Jet2, KnownDistance, SetError,
    gallery::{Constant, Separable, Shear},
    norm_squared,
};

use super::{BoundedCurve, Curve, Motion};
use crate::{InUnits, Known};

/// A metric whose geodesics have a closed form or follow from one equation in one unknown.
pub trait KnownGeodesics<const D: usize>: KnownDistance<D> {
    /// Returns the motion at the time `t` on the geodesic `Exp_x(t v)`, which leaves `x` with
    /// velocity `v`; all are in `ℓ`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D>;

    /// Returns the initial velocity of a minimal geodesic over `[0, 1]` from `x` to `y`, in `ℓ`.
    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D>;

    /// Returns a radius in `m`. Shorter geodesics from `x` exist, are minimal and do not meet.
    fn normal_radius(&self, x: &SVector<f64, D>) -> f64;
}

/// A geodesic over `[0, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geodesic<M, const D: usize> {
    metric: M,
    start: SVector<f64, D>,
    velocity: SVector<f64, D>,
}

impl<M: KnownGeodesics<D>, const D: usize> Geodesic<M, D> {
    /// Returns the geodesic from a point with an initial velocity, both in `ℓ`.
    pub fn leaving(metric: M, start: SVector<f64, D>, velocity: SVector<f64, D>) -> Self {
        Self { metric, start, velocity }
    }

    /// Returns a minimal geodesic between two points.
    pub fn between(metric: M, [a, b]: [SVector<f64, D>; 2]) -> Self {
        let velocity = metric.logarithm(&a, &b);
        Self::leaving(metric, a, velocity)
    }

    /// Returns the constant speed of the geodesic, which equals its length, in `m`.
    pub fn speed(&self) -> f64 {
        norm_squared(&self.metric, &self.start, &self.velocity).sqrt()
    }
}

impl<M: KnownGeodesics<D>, const D: usize> Curve<D> for Geodesic<M, D> {
    fn motion(&self, t: f64) -> Motion<D> {
        self.metric.exponential(&self.start, &self.velocity, t)
    }
}

impl<M: KnownGeodesics<D> + Bounded<D>, const D: usize> BoundedCurve<D> for Geodesic<M, D> {
    /// The bounds are `|γ̇| ≤ s/√c₁`, where `s` is the speed, and `|γ̈| ≤ 3 L_H |γ̇|²/2c₁`, by the
    /// geodesic equation.
    fn suprema(&self) -> [f64; 3] {
        let constants = self.metric.constants();
        let speed = (self.speed() / constants.c1().sqrt()).max(self.velocity.norm());
        let bend = 1.5 * constants.l_h() / constants.c1() * speed * speed;
        [self.start.norm() + speed, speed, bend]
    }
}

impl<M: KnownGeodesics<D>, const D: usize> Known<M, D> {
    /// Returns the problem between two points of a metric with known geodesics; `None` if the
    /// metric does not know their distance.
    ///
    /// A closed form of the distance has about four roundings of numbers of the size of the points.
    /// This size is measured in the metric at either point, up to a factor of about 10. Hence
    /// `distance_error` is `64 ε` times the sum of the two sizes and the distance.
    ///
    /// # Errors
    ///
    /// [`SetError`] if a coordinate is not finite.
    pub fn joined(metric: M, [a, b]: [SVector<f64, D>; 2]) -> Result<Option<Self>, SetError> {
        let ends = tautline::Ends::points(a, b)?;
        let Some(distance) = metric.distance(&a, &b) else { return Ok(None) };
        let size = [a, b].map(|x| norm_squared(&metric, &x, &x).sqrt()).iter().sum::<f64>();
        let distance_error = 64.0 * f64::EPSILON * (size + distance);
        Ok(Some(Self { metric, ends, distance, distance_error }))
    }
}

impl<const D: usize> KnownGeodesics<D> for Constant<D> {
    /// The straight line `x + t v`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        Motion { position: x + v * t, velocity: *v, acceleration: SVector::zeros() }
    }

    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        y - x
    }

    /// `∞`: the space is complete, and two points are joined by one geodesic only.
    fn normal_radius(&self, _: &SVector<f64, D>) -> f64 {
        f64::INFINITY
    }
}

impl KnownGeodesics<2> for Shear {
    /// The curve `Φ⁻¹(Φ(x) + t DΦ v)`, which is a straight line in flat coordinates.
    fn exponential(&self, x: &SVector<f64, 2>, v: &SVector<f64, 2>, t: f64) -> Motion<2> {
        let flat = self.flatten(&line(x, v, 0.0));
        let line = line(&flat.map(|y| y.value()), &flat.map(|y| y.first(0)), t);
        Motion::of_jet(&self.unflatten(&line))
    }

    /// `DΦ⁻¹ (Φ(y) − Φ(x))`.
    fn logarithm(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> SVector<f64, 2> {
        let (from, to) = (self.flatten(x), self.flatten(y));
        self.unflatten(&line(&from, &(to - from), 0.0)).map(|x| x.first(0))
    }

    /// `∞`: the flat coordinates map `R²` onto itself.
    fn normal_radius(&self, _: &SVector<f64, 2>) -> f64 {
        f64::INFINITY
    }
}

impl<const D: usize> KnownGeodesics<D> for Separable<D> {
    /// The curve `F⁻¹(F(x) + t DF v)`, coordinate by coordinate. With `w = DF v`, the equation
    /// `F(γ) = F(x) + t w` gives `f γ̇ = w` and `f γ̈ = −f′ γ̇²`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        let start = self.flatten(&line(x, v, 0.0));
        let w = start.map(|y| y.first(0));
        let position = unflatten(self, &(start.map(|y| y.value()) + w * t), &(x + v * t));
        // Fᵢ depends only on xᵢ, so that one jet along (1, …, 1) contains all fᵢ and fᵢ′.
        let jet = self.flatten(&line(&position, &SVector::repeat(1.0), 0.0));
        let velocity = w.zip_map(&jet, |w, jet| w / jet.first(0));
        let acceleration = velocity
            .zip_map(&jet, |velocity, jet| -jet.second(0, 0) * velocity * velocity / jet.first(0));
        Motion { position, velocity, acceleration }
    }

    /// `DF⁻¹ (F(y) − F(x))`.
    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        let jet = self.flatten(&line(x, &SVector::repeat(1.0), 0.0));
        let to = self.flatten(y);
        SVector::from_fn(|i, _| (to[i] - jet[i].value()) / jet[i].first(0))
    }

    /// `∞`: the flat coordinates map `R^D` onto itself.
    fn normal_radius(&self, _: &SVector<f64, D>) -> f64 {
        f64::INFINITY
    }
}

impl<M: KnownGeodesics<D>, const D: usize> KnownGeodesics<D> for &M {
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        (**self).exponential(x, v, t)
    }

    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        (**self).logarithm(x, y)
    }

    fn normal_radius(&self, x: &SVector<f64, D>) -> f64 {
        (**self).normal_radius(x)
    }
}

impl<M: KnownGeodesics<D>, const D: usize> KnownGeodesics<D> for InUnits<M> {
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        let ell = self.units().ell;
        self.metric().exponential(&(x / ell), &(v / ell), t).scaled(ell)
    }

    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        let ell = self.units().ell;
        self.metric().logarithm(&(x / ell), &(y / ell)) * ell
    }

    fn normal_radius(&self, x: &SVector<f64, D>) -> f64 {
        self.metric().normal_radius(&(x / self.units().ell)) * self.units().m
    }
}

/// Returns the jet of `x + τ v` at `τ = t`.
pub(super) fn line<const D: usize>(
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
    t: f64,
) -> SVector<Jet2<f64, 1>, D> {
    let [t] = Jet2::variables(&[t]);
    SVector::from_fn(|i, _| t * v[i] + x[i])
}

/// Solves `F(x) = y` in each coordinate by Newton's method, starting at `near`.
///
/// `F` is increasing, so that the root lies between any two points at which `F − y` has different
/// signs. A step that leaves this interval is replaced by bisection.
fn unflatten<const D: usize>(
    metric: &Separable<D>,
    y: &SVector<f64, D>,
    near: &SVector<f64, D>,
) -> SVector<f64, D> {
    let mut x = *near;
    let mut low = SVector::<f64, D>::repeat(f64::NEG_INFINITY);
    let mut high = SVector::<f64, D>::repeat(f64::INFINITY);
    // Convergence is quadratic near the root; 100 bisections suffice in any case.
    for _ in 0..100 {
        let jet = metric.flatten(&line(&x, &SVector::repeat(1.0), 0.0));
        let before = x;
        for i in 0..D {
            let excess = jet[i].value() - y[i];
            *(if excess > 0.0 { &mut high[i] } else { &mut low[i] }) = x[i];
            let step = x[i] - excess / jet[i].first(0);
            let middle = 0.5 * (low[i] + high[i]);
            let inside = step >= low[i] && step <= high[i];
            x[i] = if inside || !middle.is_finite() { step } else { middle };
        }
        // The two agree to within the last bits; `F` itself has a few roundings.
        if (x - before).amax() <= 2.0 * f64::EPSILON * x.amax() {
            break;
        }
    }
    x
}
