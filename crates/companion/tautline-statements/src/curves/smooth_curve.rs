//! `SmoothCurve`: a polynomial in time plus a sum of waves.

use std::f64::consts::PI;

use nalgebra::SVector;
use tautline::{Jet2, Scalar};

use super::{BoundedCurve, Curve, Motion};

/// ```text
/// γ(t)  =  Σ pₖ tᵏ  +  Σ (aₖ cos kπt + bₖ sin kπt)      k = 0, 1, … and k = 1, 2, …
/// ```
///
/// with coefficients in `ℓ`. Its derivatives come from jets in `t`.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothCurve<const D: usize> {
    powers: Vec<SVector<f64, D>>,
    waves: Vec<[SVector<f64, D>; 2]>,
}

impl<const D: usize> SmoothCurve<D> {
    /// Returns the curve with the coefficients `pₖ` and `[aₖ, bₖ]`. Without coefficients, it rests
    /// at 0.
    #[must_use]
    pub fn new(powers: Vec<SVector<f64, D>>, waves: Vec<[SVector<f64, D>; 2]>) -> Self {
        Self { powers, waves }
    }

    /// Returns the polynomial with the coefficients `pₖ`.
    pub fn polynomial(powers: impl IntoIterator<Item = SVector<f64, D>>) -> Self {
        Self::new(powers.into_iter().collect(), Vec::new())
    }

    /// Returns `a + (b − a) t`.
    pub fn straight(a: impl Into<SVector<f64, D>>, b: impl Into<SVector<f64, D>>) -> Self {
        let (a, b) = (a.into(), b.into());
        Self::polynomial([a, b - a])
    }

    /// Adds the linear function of `t` that moves the ends to `a` and `b`.
    #[must_use]
    pub fn between(mut self, a: SVector<f64, D>, b: SVector<f64, D>) -> Self {
        let [from, to] = [a - self.at(0.0), b - self.at(1.0)];
        self.powers.resize(self.powers.len().max(2), SVector::zeros());
        self.powers[0] += from;
        self.powers[1] += to - from;
        self
    }

    /// Evaluates the formula in any number type.
    fn at<S: Scalar>(&self, t: S) -> SVector<S, D> {
        let mut sum = SVector::from_element(S::zero());
        for power in self.powers.iter().rev() {
            sum = SVector::from_fn(|i, _| sum[i] * t + power[i]);
        }
        for (k, [a, b]) in self.waves.iter().enumerate() {
            let (sin, cos) = (t * (PI * (k + 1) as f64)).sin_cos();
            sum = SVector::from_fn(|i, _| sum[i] + cos * a[i] + sin * b[i]);
        }
        sum
    }
}

impl<const D: usize> Curve<D> for SmoothCurve<D> {
    fn motion(&self, t: f64) -> Motion<D> {
        let [t] = Jet2::variables(&[t]);
        Motion::of_jet(&self.at(t))
    }
}

impl<const D: usize> BoundedCurve<D> for SmoothCurve<D> {
    /// The bounds are `Σ |pₖ| + Σ (|aₖ|² + |bₖ|²)^{1/2}`, and for the derivatives the same sums
    /// with their terms multiplied by `k` and `k(k − 1)`, and by `kπ` and `(kπ)²`.
    fn suprema(&self) -> [f64; 3] {
        let mut bounds = [0.0; 3];
        for (k, power) in self.powers.iter().enumerate() {
            let k = k as f64;
            // For k = 0, k(k − 1) is −0.
            for (bound, factor) in bounds.iter_mut().zip([1.0, k, k * (k - 1.0)]) {
                *bound += factor.abs() * power.norm();
            }
        }
        for (k, [a, b]) in self.waves.iter().enumerate() {
            let frequency = PI * (k + 1) as f64;
            for (order, bound) in (0..).zip(&mut bounds) {
                *bound += frequency.powi(order) * (a.norm_squared() + b.norm_squared()).sqrt();
            }
        }
        bounds
    }
}

#[cfg(test)]
mod tests {
    use super::{BoundedCurve, Curve, SmoothCurve};
    use nalgebra::vector;
    use std::f64::consts::PI;

    #[test]
    fn derivatives_are_those_of_the_formula() {
        let curve = SmoothCurve::new(
            vec![vector![1.0], vector![0.0], vector![3.0]],
            vec![[vector![0.0], vector![0.0]], [vector![0.0], vector![2.0]]],
        );
        // 1 + 3t² + 2 sin 2πt at t = 1/4.
        let [x, v, a] = curve.motion(0.25).derivatives().map(|x| x[0]);
        assert!((x - 3.1875).abs() <= 1e-15 && (v - 1.5).abs() <= 1e-14);
        assert!((a - (6.0 - 8.0 * PI * PI)).abs() <= 1e-13);
        let bounds = curve.suprema();
        for (bound, expected) in bounds.iter().zip([6.0, 6.0 + 4.0 * PI, 6.0 + 8.0 * PI * PI]) {
            assert!((bound - expected).abs() <= 1e-13);
        }
        let moved = curve.between(vector![5.0], vector![-1.0]);
        assert!((moved.motion(0.0).position[0] - 5.0).abs() <= 1e-15);
        assert!((moved.motion(1.0).position[0] + 1.0).abs() <= 1e-14);
    }
}
