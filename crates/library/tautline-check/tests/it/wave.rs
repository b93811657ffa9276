//! A metric with known distances that is not conformal.

use nalgebra::{SMatrix, SVector, vector};
use tautline_chance::Random;
use tautline_check::Region;
use tautline_formula::Formula;

/// The pull-back of the Euclidean metric by `F(x) = L (x₁ + A sin kx₂, x₂)`. Geodesics are the
/// preimages of straight lines, and all are minimal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wave {
    pub(crate) linear: SMatrix<f64, 2, 2>,
    pub(crate) amplitude: f64,
    pub(crate) wave_number: f64,
}

impl Wave {
    /// Returns the wave with `L = I`.
    pub(crate) fn new(amplitude: f64, wave_number: f64) -> Self {
        Self { linear: SMatrix::identity(), amplitude, wave_number }
    }

    /// Returns a wave whose `L` has singular values `1` and up to `1/ratio`, in random directions.
    pub(crate) fn random(random: &mut Random, ratio: f64) -> Self {
        let mut turn =
            || SMatrix::<f64, 2, 2>::from(nalgebra::Rotation2::new(random.between(0.0, 6.3)));
        let (left, right) = (turn(), turn());
        let least = ratio.powf(-random.unit());
        let stretch = SMatrix::from_diagonal(&vector![1.0, least]);
        // Where the least eigenvalue is small, cubes have to be small compared with the waves.
        let wave_number = random.between(0.5, 3.0);
        let amplitude = random.between(0.0, 0.5) * least;
        Self { linear: left * stretch * right, amplitude, wave_number }
    }

    pub(crate) fn formula(&self) -> Formula<2> {
        let l = &self.linear;
        let constants = [
            ("a", self.amplitude),
            ("k", self.wave_number),
            ("l11", l[(0, 0)]),
            ("l12", l[(0, 1)]),
            ("l21", l[(1, 0)]),
            ("l22", l[(1, 1)]),
        ];
        let text = "y = x1 + a*sin(k*x2); pullback(l11*y + l12*x2, l21*y + l22*x2)";
        Formula::parse(text, &constants).expect("a formula")
    }

    /// Returns `F(x)`.
    pub(crate) fn flat(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        self.linear * vector![x[0] + self.amplitude * (self.wave_number * x[1]).sin(), x[1]]
    }

    pub(crate) fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> f64 {
        (self.flat(y) - self.flat(x)).norm()
    }

    /// Returns points of the minimal geodesic, with its ends.
    pub(crate) fn geodesic(
        &self,
        [x, y]: [SVector<f64, 2>; 2],
        chords: usize,
    ) -> Vec<SVector<f64, 2>> {
        let inverse = self.linear.try_inverse().expect("regular");
        let at = |n: usize| {
            let t = n as f64 / chords as f64;
            let z = inverse * (self.flat(&x) * (1.0 - t) + self.flat(&y) * t);
            vector![z[0] - self.amplitude * (self.wave_number * z[1]).sin(), z[1]]
        };
        let mut points: Vec<_> = (0..=chords).map(at).collect();
        (points[0], points[chords]) = (x, y);
        points
    }

    /// Returns a declared region, with a constant below the least eigenvalue of `H`.
    pub(crate) fn declared(&self) -> Region {
        Region::Declared { c1: self.c1() }
    }

    /// Returns a constant a little below the least eigenvalue of `H`.
    pub(crate) fn c1(&self) -> f64 {
        let slope = 0.5 * self.amplitude * self.wave_number;
        let least = self.linear.singular_values().min() * ((1.0 + slope * slope).sqrt() - slope);
        0.9 * least * least
    }

    /// Returns the distance from a point by `behind` behind `x`, seen from `y`, less `behind`. It is
    /// 0 at `x`, and its gradient has norm 1.
    pub(crate) fn calibration(
        &self,
        [x, y]: [SVector<f64, 2>; 2],
        behind: f64,
    ) -> impl Fn(&SVector<f64, 2>) -> f64 {
        let wave = *self;
        let source = self.flat(&x) - (self.flat(&y) - self.flat(&x)).normalize() * behind;
        move |z| (wave.flat(z) - source).norm() - behind
    }
}
