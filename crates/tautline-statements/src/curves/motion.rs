//! `Motion`: where a curve is, how fast, and how its velocity changes.

use nalgebra::SVector;
use tautline::{AnyMetric, Jet2, Metric, MetricError};

use super::Curve;
use crate::Subject;

/// Position, velocity and acceleration at one time, all in `ℓ`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// `γ(t)`.
    pub position: SVector<f64, D>,
    /// `γ̇(t)`.
    pub velocity: SVector<f64, D>,
    /// `γ̈(t)`.
    pub acceleration: SVector<f64, D>,
}

impl<const D: usize> Motion<D> {
    /// Reads a motion off the jet of a curve in the time.
    #[must_use]
    pub fn of_jet(curve: &SVector<Jet2<f64, 1>, D>) -> Self {
        Self {
            position: curve.map(|x| x.value()),
            velocity: curve.map(|x| x.first(0)),
            acceleration: curve.map(|x| x.second(0, 0)),
        }
    }

    /// Returns the motion of a curve whose derivatives are given: `γ(t)`, `γ̇(t)` and `γ̈(t)`.
    #[must_use]
    pub fn new([position, velocity, acceleration]: [SVector<f64, D>; 3]) -> Self {
        Self { position, velocity, acceleration }
    }

    /// Returns `γ(t)`, `γ̇(t)` and `γ̈(t)`.
    #[must_use]
    pub fn derivatives(self) -> [SVector<f64, D>; 3] {
        [self.position, self.velocity, self.acceleration]
    }

    /// Returns the motion in coordinates whose unit is `ell` times smaller.
    #[must_use]
    pub fn scaled(self, ell: f64) -> Self {
        Self {
            position: self.position * ell,
            velocity: self.velocity * ell,
            acceleration: self.acceleration * ell,
        }
    }
}

/// Returns the largest of numbers that are not negative, 0 of none; NaN if one of them is.
pub(crate) fn largest(numbers: impl IntoIterator<Item = f64>) -> f64 {
    let keep = |most: f64, next: f64| if next <= most || most.is_nan() { most } else { next };
    numbers.into_iter().fold(0.0, keep)
}

/// By how much a curve misses the geodesic equation (3.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// The largest `|γ̈ + Γ(γ̇, γ̇)|` over the times that were looked at, in `ℓ`.
    pub value: f64,
    /// The largest `|γ̈|`, in `ℓ`.
    pub acceleration: f64,
    /// The largest `|Γ(γ̇, γ̇)|`, in `ℓ`.
    pub bending: f64,
    /// What rounding may do to it, in `ℓ`.
    pub granted: f64,
}

impl Residual {
    /// Looks at the curve at its [`times`](Curve::times).
    ///
    /// # Errors
    ///
    /// [`MetricError`] where `H` is not finite, symmetric and positive definite.
    pub fn of<const D: usize>(
        subject: &Subject,
        metric: &impl Metric<D>,
        curve: &impl Curve<D>,
    ) -> Result<Self, MetricError> {
        Self::behind_pointers(subject, &AnyMetric::new(metric), curve)
    }

    fn behind_pointers<const D: usize>(
        subject: &Subject,
        metric: &AnyMetric<'_, D>,
        curve: &dyn Curve<D>,
    ) -> Result<Self, MetricError> {
        let mut found = Self { value: 0.0, acceleration: 0.0, bending: 0.0, granted: 0.0 };
        for t in curve.times() {
            let Motion { position, velocity, acceleration } = curve.motion(t);
            let symbols = subject.christoffel(metric, &position)?;
            let bending = SVector::<f64, D>::from_fn(|k, _| velocity.dot(&(symbols[k] * velocity)));
            let gamma = largest(symbols.iter().map(|symbol| symbol.norm()));
            let scale = acceleration.norm() + gamma * velocity.norm_squared();
            found.value = largest([found.value, (acceleration + bending).norm()]);
            found.acceleration = found.acceleration.max(acceleration.norm());
            found.bending = found.bending.max(bending.norm());
            // The symbols are derivatives of H over its least eigenvalue, some dozens of roundings
            // of their largest terms; the position is rounded as well, and they move with it by
            // about Γ times that. Measured over the suite: less than a fifth of this.
            let moved = position.norm() * gamma * scale;
            found.granted = found.granted.max(512.0 * f64::EPSILON * (scale + moved));
        }
        Ok(found)
    }
}
