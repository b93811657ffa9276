//! `EvenSegment`: a straight segment at constant Riemannian speed.

use nalgebra::SVector;
use tautline::{Jet1, Metric, norm_squared, quadrature::integrate};

use super::{Curve, Motion};

/// The segment from `a` to `b`, at constant speed.
///
/// If it is a shortest curve, such as a ray from the centre of a radial metric, it is a geodesic by
/// Lemma 4.4. The code does not use the geodesic equation.
#[derive(Clone, Debug)]
pub struct EvenSegment<'a, M, const D: usize> {
    metric: &'a M,
    start: SVector<f64, D>,
    chord: SVector<f64, D>,
    length: f64,
}

impl<'a, M: Metric<D>, const D: usize> EvenSegment<'a, M, D> {
    /// Returns the segment between two points, in `ℓ`.
    pub fn new(metric: &'a M, [a, b]: [SVector<f64, D>; 2]) -> Self {
        let mut segment = Self { metric, start: a, chord: b - a, length: 0.0 };
        segment.length = segment.travelled(0.0, 1.0);
        segment
    }

    /// Returns the length between two fractions of the chord, in `m`.
    fn travelled(&self, from: f64, to: f64) -> f64 {
        let speed =
            |s: f64| norm_squared(&self.metric, &(self.start + self.chord * s), &self.chord);
        integrate(|s| speed(s).sqrt(), from, to, 1e-15).value
    }
}

impl<M: Metric<D>, const D: usize> Curve<D> for EvenSegment<'_, M, D> {
    /// Let `h(s)` be `|b − a|²` in the metric at the fraction `s` of the chord. Constant speed then
    /// means `ṡ = L/√h`, hence `s̈ = −½ h′/h ṡ²`.
    fn motion(&self, t: f64) -> Motion<D> {
        // Solve ∫₀ˢ √h = t L by Newton's method, with bisection where a step leaves the interval.
        // √h varies by less than a factor of ten.
        let (mut low, mut high, mut s) = (0.0, 1.0, t);
        let mut rates = self.rates(s);
        for _ in 0..60 {
            let excess = self.travelled(0.0, s) - t * self.length;
            *(if excess > 0.0 { &mut high } else { &mut low }) = s;
            let step = s - excess / rates[0].sqrt();
            let next = if step >= low && step <= high { step } else { 0.5 * (low + high) };
            let moved = (next - s).abs();
            s = next;
            rates = self.rates(s);
            if moved <= 4.0 * f64::EPSILON {
                break;
            }
        }
        let [square, slope] = rates;
        let rate = self.length / square.sqrt();
        Motion {
            position: self.start + self.chord * s,
            velocity: self.chord * rate,
            acceleration: self.chord * (-0.5 * slope / square * rate * rate),
        }
    }
}

impl<M: Metric<D>, const D: usize> EvenSegment<'_, M, D> {
    /// Returns `h` and `h′` at a fraction of the chord, in `m²`.
    fn rates(&self, s: f64) -> [f64; 2] {
        let [s] = Jet1::<f64, 1>::variables(&[s]);
        let x = SVector::<Jet1<f64, 1>, D>::from_fn(|i, _| s * self.chord[i] + self.start[i]);
        let square = norm_squared(&self.metric, &x, &self.chord);
        [square.value(), square.first(0)]
    }
}

impl<M, const D: usize> EvenSegment<'_, M, D> {
    /// Returns the length, in `m`.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.length
    }
}
