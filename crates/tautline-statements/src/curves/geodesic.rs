//! `Geodesic`: the geodesics of the metrics that know theirs.

use nalgebra::SVector;
use tautline::{
    Bounded, Jet2, KnownDistance, Scalar, SetError,
    gallery::{Constant, Separable, Shear},
    norm_squared,
};

use super::{BoundedCurve, Curve, Motion};
use crate::{InUnits, Known};

/// A metric whose geodesics are known in closed form, or by solving one equation in one unknown.
pub trait KnownGeodesics<const D: usize>: KnownDistance<D> {
    /// Returns the geodesic that starts in `x` with the velocity `v`, at the time `t`:
    /// `Exp_x(t v)`, in `ℓ`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D>;

    /// Returns the velocity with which a minimal geodesic over `[0, 1]` leaves `x` for `y`, in `ℓ`.
    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D>;

    /// Returns a radius in `m` such that all geodesics from `x` that are shorter exist, are
    /// minimal, and end in different points.
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
    /// Returns the geodesic with a first point and a first velocity, both in `ℓ`.
    pub fn leaving(metric: M, start: SVector<f64, D>, velocity: SVector<f64, D>) -> Self {
        Self { metric, start, velocity }
    }

    /// Returns a minimal geodesic between two points.
    pub fn between(metric: M, [a, b]: [SVector<f64, D>; 2]) -> Self {
        let velocity = metric.logarithm(&a, &b);
        Self { metric, start: a, velocity }
    }

    /// Returns its constant speed, which is its length, in `m`.
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
    /// `|γ̇| ≤ s/√c₁` with the constant speed `s`; by the geodesic equation `|γ̈| ≤ 3 L_H |γ̇|²/2c₁`.
    fn suprema(&self) -> [f64; 3] {
        let constants = self.metric.constants();
        let speed = (self.speed() / constants.c1().sqrt()).max(self.velocity.norm());
        let bend = 1.5 * constants.l_h() / constants.c1() * speed * speed;
        [self.start.norm() + speed, speed, bend]
    }
}

impl<M: KnownGeodesics<D>, const D: usize> Known<M, D> {
    /// Two points of a metric that knows its geodesics.
    ///
    /// Closed forms of distances are some four roundings of numbers of the size of the points, in
    /// the metric at either of them up to a factor of 10 or so: `distance_error` is `64 ε` times
    /// the sum of the two, and of the distance.
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
    /// `x + t v`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        Motion { position: x + v * t, velocity: *v, acceleration: SVector::zeros() }
    }

    fn logarithm(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> SVector<f64, D> {
        y - x
    }

    /// It is `√c₁ r` at least to leave the ball of radius `r`: the limit of that.
    fn normal_radius(&self, _: &SVector<f64, D>) -> f64 {
        self.constants().c1().sqrt() * f64::INFINITY
    }
}

impl KnownGeodesics<2> for Shear {
    /// `Φ⁻¹(Φ(x) + t DΦ v)`: straight in flat coordinates.
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

    /// By the flat coordinates, which take `R²` to all of itself, it is `√c₁ r` at least to leave the
    /// ball of radius `r`: the limit of that.
    fn normal_radius(&self, _: &SVector<f64, 2>) -> f64 {
        self.constants().c1().sqrt() * f64::INFINITY
    }
}

impl<const D: usize> KnownGeodesics<D> for Separable<D> {
    /// `F⁻¹(F(x) + t DF v)`, coordinate by coordinate: with `w = DF v` the equation `F(γ) = F(x) +
    /// t w` gives `f γ̇ = w` and `f γ̈ = −f′ γ̇²`.
    fn exponential(&self, x: &SVector<f64, D>, v: &SVector<f64, D>, t: f64) -> Motion<D> {
        let start = self.flatten(&line(x, v, 0.0));
        let w = start.map(|y| y.first(0));
        let position = unflatten(self, &(start.map(|y| y.value()) + w * t), &(x + v * t));
        // Fᵢ depends on xᵢ alone, so that one jet along (1, …, 1) has all the fᵢ and fᵢ′.
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

    /// By the flat coordinates, which take `R^D` to all of itself, it is `√c₁ r` at least to leave the
    /// ball of radius `r`: the limit of that.
    fn normal_radius(&self, _: &SVector<f64, D>) -> f64 {
        self.constants().c1().sqrt() * f64::INFINITY
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

/// The jet of `x + τ v` at `τ = t`.
fn line<const D: usize>(
    x: &SVector<f64, D>,
    v: &SVector<f64, D>,
    t: f64,
) -> SVector<Jet2<f64, 1>, D> {
    let [t] = Jet2::variables(&[t]);
    SVector::from_fn(|i, _| t * v[i] + x[i])
}

/// Returns the `x` with `F(x) = y`, by Newton steps from `near`, in each coordinate.
///
/// `F` is increasing, so that a root lies between any two points where `F − y` has different signs;
/// a step that would leave what is left of the interval is replaced by halving it.
fn unflatten<const D: usize>(
    metric: &Separable<D>,
    y: &SVector<f64, D>,
    near: &SVector<f64, D>,
) -> SVector<f64, D> {
    let mut x = *near;
    let mut low = SVector::<f64, D>::repeat(f64::NEG_INFINITY);
    let mut high = SVector::<f64, D>::repeat(f64::INFINITY);
    // Quadratic convergence, once near; 100 halvings would do in any case.
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
        // Equal but for the last bits: F has a few roundings of its own.
        if (x - before).amax() <= 2.0 * f64::EPSILON * x.amax() {
            break;
        }
    }
    x
}

/// The jet of a constant in the time.
pub(super) fn constant(value: f64) -> Jet2<f64, 1> {
    Jet2::constant(value)
}
