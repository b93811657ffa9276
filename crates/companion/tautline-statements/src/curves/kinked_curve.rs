//! `KinkedCurve`: a curve of straight pieces, each with constant velocity.

use nalgebra::SVector;

use super::{BoundedCurve, Curve, Motion};
use crate::VerifyError;

/// A piecewise linear curve through given points at given times.
///
/// It is piecewise `C¹`, as in the paper. Since `γ̈ = 0` almost everywhere, the paper's `‖γ̈‖` does
/// not see its kinks.
#[derive(Clone, Debug, PartialEq)]
pub struct KinkedCurve<const D: usize> {
    /// `0 = t₀ < t₁ < … < t_m = 1`.
    times: Vec<f64>,
    points: Vec<SVector<f64, D>>,
}

impl<const D: usize> KinkedCurve<D> {
    /// Returns the curve from `first` at the time 0 through `stops` to `last` at the time 1.
    ///
    /// # Errors
    ///
    /// [`VerifyError::OutOfRange`] unless the times of the stops increase within `(0, 1)`.
    pub fn new(
        first: impl Into<SVector<f64, D>>,
        stops: impl IntoIterator<Item = (f64, SVector<f64, D>)>,
        last: impl Into<SVector<f64, D>>,
    ) -> Result<Self, VerifyError> {
        let (mut times, mut points) = (vec![0.0], vec![first.into()]);
        for (time, point) in stops {
            let before = *times.last().expect("not empty");
            if !(before < time && time < 1.0) {
                let (name, value) = ("time of a stop", time);
                return Err(VerifyError::OutOfRange { name, value, low: before, high: 1.0 });
            }
            times.push(time);
            points.push(point);
        }
        times.push(1.0);
        points.push(last.into());
        Ok(Self { times, points })
    }

    fn kinks(&self) -> &[f64] {
        &self.times[1..self.times.len() - 1]
    }

    fn velocity(&self, piece: usize) -> SVector<f64, D> {
        (self.points[piece + 1] - self.points[piece]) / (self.times[piece + 1] - self.times[piece])
    }

    fn velocities(&self) -> impl Iterator<Item = SVector<f64, D>> {
        (0..self.points.len() - 1).map(|piece| self.velocity(piece))
    }
}

impl<const D: usize> Curve<D> for KinkedCurve<D> {
    fn motion(&self, t: f64) -> Motion<D> {
        let piece = self.kinks().iter().filter(|kink| **kink <= t).count();
        let velocity = self.velocity(piece);
        let position = self.points[piece] + velocity * (t - self.times[piece]);
        Motion { position, velocity, acceleration: SVector::zeros() }
    }

    fn corners(&self) -> Vec<f64> {
        self.kinks().to_vec()
    }
}

impl<const D: usize> BoundedCurve<D> for KinkedCurve<D> {
    /// The bounds are `max |points|`, `max |velocities|`, and 0, which bounds `γ̈` away from the
    /// kinks.
    fn suprema(&self) -> [f64; 3] {
        let largest = |norms: &mut dyn Iterator<Item = f64>| norms.fold(0.0, f64::max);
        let position = largest(&mut self.points.iter().map(|point| point.norm()));
        let velocity = largest(&mut self.velocities().map(|velocity| velocity.norm()));
        [position, velocity, 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::{BoundedCurve, Curve, KinkedCurve};

    #[test]
    fn the_modulus_has_one_kink() {
        let modulus = KinkedCurve::new([0.5], [(0.5, [0.0].into())], [0.5]).expect("in order");
        assert_eq!(modulus.motion(0.25).derivatives().map(|x| x[0]), [0.25, -1.0, 0.0]);
        assert_eq!(modulus.motion(0.5).derivatives().map(|x| x[0]), [0.0, 1.0, 0.0]);
        assert_eq!(modulus.motion(1.0).derivatives().map(|x| x[0]), [0.5, 1.0, 0.0]);
        assert_eq!(modulus.kinks(), [0.5]);
        assert_eq!(modulus.suprema(), [0.5, 1.0, 0.0]);
        assert!(KinkedCurve::new([0.0], [(1.0, [0.0].into())], [0.0]).is_err());
    }
}
