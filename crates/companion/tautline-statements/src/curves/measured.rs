//! `Measured`: length, energy and ends of a curve.

use nalgebra::SVector;
use tautline::{AnyMetric, Integral, Metric, PointSequence, norm_squared, quadrature::integrate};

use super::Curve;
use crate::Subject;

/// The measurements of a curve that Sections 3, 6 and 9 need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured<const D: usize> {
    /// The first and the last point, in `ℓ`.
    pub ends: [SVector<f64, D>; 2],
    /// `L(γ)`, in `m`.
    pub length: Integral,
    /// `E(γ)`, in `m²`.
    pub energy: Integral,
    /// The least and the largest speed at the times evaluated, in `m`.
    pub speeds: [f64; 2],
    /// The allowance for the rounding of a length, in `m`.
    pub rounding: f64,
}

impl<const D: usize> Measured<D> {
    /// Measures a curve, piece by piece.
    pub fn of(metric: &impl Metric<D>, curve: &impl Curve<D>) -> Self {
        Self::behind_pointers(&AnyMetric::new(metric), curve)
    }

    fn behind_pointers(metric: &AnyMetric<'_, D>, curve: &dyn Curve<D>) -> Self {
        let square = |t: f64| curve.motion(t).speed_squared(metric);
        let (mut length, mut energy) = (Integral::default(), Integral::default());
        for [from, to] in curve.pieces() {
            length += inside(|t| square(t).sqrt(), from, to);
            energy += inside(square, from, to);
        }
        let (mut speeds, mut size) = ([f64::INFINITY, 0.0_f64], 0.0_f64);
        for t in curve.times() {
            let (speed, at) = (square(t).sqrt(), curve.motion(t).position);
            speeds = [speeds[0].min(speed), speeds[1].max(speed)];
            size = size.max(norm_squared(metric, &at, &at).sqrt());
        }
        let ends = [curve.motion(0.0).position, curve.motion(1.0).position];
        let rounding = rounding(size, length.value);
        Self { ends, length, energy, speeds, rounding }
    }

    /// Measures the interpolation of a point sequence.
    pub fn of_sequence(
        subject: &Subject,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Self {
        let metric = &AnyMetric::new(metric);
        let (mut speeds, mut size) = ([f64::INFINITY, 0.0_f64], 0.0_f64);
        for ((x, _), beta) in sequence.chords().zip(sequence.differences()) {
            let speed = norm_squared(metric, x, &beta).sqrt();
            speeds = [speeds[0].min(speed), speeds[1].max(speed)];
            size = size.max(norm_squared(metric, x, x).sqrt());
        }
        let length = subject.curve_length(metric, sequence);
        Self {
            ends: [*sequence.first(), *sequence.last()],
            length,
            energy: subject.curve_energy(metric, sequence),
            speeds,
            rounding: rounding(size, length.value),
        }
    }

    /// Returns `L(γ)²`, in `m²`.
    #[must_use]
    pub fn length_squared(&self) -> f64 {
        self.length.value.powi(2)
    }

    /// Returns the allowance for `L(γ)`, in `m`.
    #[must_use]
    pub fn granted_length(&self) -> f64 {
        self.length.error + self.rounding
    }

    /// Returns the allowance for `L(γ)²` and `E(γ)`, in `m²`. An error `r` of a speed changes the
    /// energy by at most `2r` times the largest speed.
    #[must_use]
    pub fn granted_energy(&self) -> f64 {
        let slope = 2.0 * self.length.value.max(self.speeds[1]);
        self.energy.error + slope * self.granted_length()
    }
}

/// Returns the allowance for the rounding of a length. Points are rounded by `ε` times their size,
/// curves and metrics add some dozens of roundings, and the metric varies by a factor of up to ten.
/// Over the suite, the measured errors are less than a fifth of this.
fn rounding(size: f64, length: f64) -> f64 {
    64.0 * f64::EPSILON * (size + length)
}

/// Integrates to within twenty roundings. More accuracy is of no use, since positions, and with
/// them speeds, are rounded.
fn inside(f: impl Fn(f64) -> f64, from: f64, to: f64) -> Integral {
    integrate(f, from, to, 20.0 * f64::EPSILON)
}
