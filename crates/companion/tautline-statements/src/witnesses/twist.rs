//! `Twist`: a metric with Christoffel symbols as large as its constants allow.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Metric, Scalar};

use crate::{
    VerifyError,
    curves::{Curve, SmoothCurve},
};

/// `H = c I + L S(y)` with `S(y) = [[−y₂, y₁], [y₁, y₂]]` in the first two coordinates, and
/// `y = (x₁, x₂)/(1 + (x₁² + x₂²)/R²)^{1/2}`.
///
/// `‖S(y)‖ = |y|`, and `x ↦ y` is a contraction into the ball of radius `R`. Hence `L_H = L`, and
/// `H` is within `LR` of `c I`. At 0, for `v = e₁`, both terms of the geodesic equation have the
/// same direction, since `DH[v]v = L e₂` and `½ ∇(vᵀHv) = −½ L e₂`. A geodesic therefore bends by
/// `3L/2c = Γ²₁₁`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist<const D: usize> {
    base: f64,
    slope: f64,
    radius: f64,
    constants: Constants,
}

impl<const D: usize> Twist<D> {
    /// Returns the twist with `c = base` in `m²/ℓ²`, `L = slope` in `m²/ℓ³` and `R = radius` in
    /// `ℓ`.
    ///
    /// # Errors
    ///
    /// [`VerifyError::Constants`] unless `LR < c`; [`VerifyError::OutOfRange`] unless `D ≥ 2`.
    pub fn new(base: f64, slope: f64, radius: f64) -> Result<Self, VerifyError> {
        if D < 2 {
            let (name, value, low) = ("D", D as f64, 2.0);
            return Err(VerifyError::OutOfRange { name, value, low, high: f64::INFINITY });
        }
        let swing = slope.abs() * radius;
        let constants = Constants::new(base - swing, base + swing, slope.abs())?;
        Ok(Self { base, slope, radius, constants })
    }
}

impl Twist<2> {
    /// Returns the geodesic from 0 with velocity `(speed, 0)` as a polynomial of degree 5, for
    /// small speeds. Its acceleration satisfies the geodesic equation at four times; between them,
    /// the relative error is of order `speed⁴`.
    #[must_use]
    pub fn short_geodesic(&self, speed: f64) -> SmoothCurve<2> {
        let times = [0.0, 0.25, 0.75, 1.0];
        let monomials: SMatrix<f64, 4, 4> =
            SMatrix::from_fn(|row, power| f64::powi(times[row], power as i32));
        let inverse = monomials.try_inverse().expect("the times differ");
        let start = [SVector::zeros(), SVector::from([speed, 0.0])];
        let mut curve = SmoothCurve::polynomial(start);
        // Each iteration reduces the error by a factor of order `speed`.
        for _ in 0..12 {
            let accelerations = times.map(|t| {
                let [x, v, _] = curve.motion(t).derivatives();
                let gamma = tautline::christoffel(self, &x).expect("positive definite");
                SVector::<f64, 2>::from_fn(|k, _| -v.dot(&(gamma[k] * v)))
            });
            let mut powers = start.to_vec();
            for k in 0..4 {
                let mut coefficient = SVector::zeros();
                for (row, acceleration) in accelerations.iter().enumerate() {
                    coefficient += acceleration * inverse[(k, row)];
                }
                // Integrated twice, tᵏ becomes tᵏ⁺²/((k + 1)(k + 2)).
                powers.push(coefficient / ((k + 1) * (k + 2)) as f64);
            }
            curve = SmoothCurve::polynomial(powers);
        }
        curve
    }
}

impl<const D: usize> Metric<D> for Twist<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let stretch =
            ((x[0].sqr() + x[1].sqr()) * self.radius.powi(-2) + 1.0).sqrt().recip() * self.slope;
        let [y1, y2] = [x[0] * stretch, x[1] * stretch];
        let mut h = SMatrix::from_diagonal_element(S::constant(self.base));
        h[(0, 0)] -= y2;
        h[(1, 1)] += y2;
        h[(0, 1)] = y1;
        h[(1, 0)] = y1;
        h
    }
}

impl<const D: usize> Bounded<D> for Twist<D> {
    /// The constants are `c₁ = c − LR`, `c₂ = c + LR` and `L_H = L`.
    fn constants(&self) -> Constants {
        self.constants
    }
}
