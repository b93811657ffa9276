//! `InclineGeodesic`: the minimal geodesic up an incline.

use nalgebra::SVector;

use crate::{
    VerifyError,
    curves::{BoundedCurve, Curve, Motion},
};

/// The minimal geodesic of `H = c + s x` from 0 to `x = b`, in closed form.
///
/// Let `F = (2/3s)(H^{3/2} − c^{3/2})` and `d = F(b)`. Then
/// `H(γ(t))^{3/2} = c^{3/2} + (3/2) s d t`, so that `γ̇ = d/√H` and `γ̈ = −s d²/2H²`. As `b → 0`,
/// the geodesic attains Lemma S.1 in dimension 1: `|γ̈| → s d²/2c²`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InclineGeodesic {
    foot: f64,
    slope: f64,
    distance: f64,
    end: f64,
}

impl InclineGeodesic {
    /// Returns the geodesic from 0 to `end > 0` where `H(0) = foot > 0` and `H′ = slope > 0`.
    ///
    /// # Errors
    ///
    /// [`VerifyError::OutOfRange`] if one of them is not positive and finite.
    pub fn new(foot: f64, slope: f64, end: f64) -> Result<Self, VerifyError> {
        for (name, value) in [("foot", foot), ("slope", slope), ("end", end)] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(VerifyError::OutOfRange { name, value, low: 0.0, high: f64::MAX });
            }
        }
        // (p³ − q³)/(p² − q²) = (p² + pq + q²)/(p + q) avoids cancellation; p² − q² = s b.
        let [p, q] = [(foot + slope * end).sqrt(), foot.sqrt()];
        let distance = 2.0 / 3.0 * end * (p * p + p * q + q * q) / (p + q);
        Ok(Self { foot, slope, distance, end })
    }

    /// Returns the distance between the ends, in `m`.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }
}

impl Curve<1> for InclineGeodesic {
    fn motion(&self, t: f64) -> Motion<1> {
        let Self { foot, slope, distance, .. } = *self;
        // x = c ((1 + z)^{2/3} − 1)/s is evaluated by functions that are accurate near 0.
        let z = 1.5 * slope * distance * t / foot.powf(1.5);
        let growth = (2.0 / 3.0 * z.ln_1p()).exp_m1();
        let h = foot * (1.0 + growth);
        let numbers =
            [foot * growth / slope, distance / h.sqrt(), -0.5 * slope * (distance / h).powi(2)];
        Motion::new(numbers.map(|number| SVector::from([number])))
    }
}

impl BoundedCurve<1> for InclineGeodesic {
    /// The bounds are the end, and the derivatives at 0.
    fn suprema(&self) -> [f64; 3] {
        let Motion { velocity, acceleration, .. } = self.motion(0.0);
        [self.end, velocity.norm(), acceleration.norm()]
    }
}
