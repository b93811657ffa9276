//! `Interpolation`: the curve `γᵖˡ` that joins a point sequence by straight lines.

use nalgebra::SVector;
use tautline_formula::{AnyBatches, AnyMetric, Batch, Kind};
use tautline_metrics::{
    Metric, norm_squared,
    quadrature::{FEW_ROUNDINGS, FIRST_NODES, Integral, integral_by_values, integrate_by_sevens},
};

use crate::{PointSequence, compensated_sum::CompensatedSum};

/// The relative tolerance of the quadrature on each chord. It is a few roundings, so that
/// `E(γᵖˡ) − d²` is as accurate as `d²` itself.
pub(crate) const TOLERANCE: f64 = FEW_ROUNDINGS;

/// The number of nodes that a quadrature evaluates first.
pub(crate) const FIRST: usize = FIRST_NODES.len();

/// The curve `γᵖˡ` that interpolates a point sequence linearly.
#[derive(Clone, Copy, Debug)]
#[doc(alias = "reconstruction")]
pub struct Interpolation<'a, const D: usize> {
    pub(crate) sequence: &'a PointSequence<D>,
}

impl<'a, const D: usize> Interpolation<'a, D> {
    /// Makes the curve that joins the points of `sequence`.
    #[must_use]
    pub fn new(sequence: &'a PointSequence<D>) -> Self {
        Self { sequence }
    }

    /// Returns `γᵖˡ(t)`, in `ℓ`; `t` is clamped to `[0, 1]`.
    #[must_use]
    pub fn at(&self, t: f64) -> SVector<f64, D> {
        SVector::from_iterator(self.coordinates_at(t))
    }

    /// Returns the coordinates of `γᵖˡ(t)`, in `ℓ`; `t` is clamped to `[0, 1]`.
    pub fn coordinates_at(&self, t: f64) -> impl Iterator<Item = f64> + use<'a, D> {
        let n = self.chords();
        let position = t.clamp(0.0, 1.0) * n as f64;
        // The last chord includes t = 1.
        let k = (position as usize).min(n - 1);
        let s = position - k as f64;
        let ends = self.sequence.row(k).iter().zip(self.sequence.row(k + 1));
        ends.map(move |(x, y)| x * (1.0 - s) + y * s)
    }

    /// Returns the continuous energy `E(γᵖˡ) = ∫₀¹ γ̇ᵀ H(γ) γ̇ dt`, in `m²`.
    ///
    /// The energy is computed by adaptive Gauss–Kronrod quadrature on each chord, to a few
    /// roundings. The error is an estimate: it misses what the first seven nodes on a chord miss,
    /// such as a step of the metric in the last hundredth of a chord. The result is NaN if the
    /// metric is NaN.
    #[must_use]
    pub fn energy(&self, metric: &impl Metric<D>) -> Integral {
        let mut squares = self.squares(metric);
        self.per_time(quadrature(self.chords(), 1, &mut squares, |square| square, TOLERANCE))
    }

    /// Returns the energy like [`energy`](Interpolation::energy), for a metric that is evaluated in
    /// batches.
    #[must_use]
    pub fn energy_by_batches(&self, metric: &dyn AnyBatches) -> Integral {
        self.per_time(self.quadrature_by_batches(metric, |square| square))
    }

    /// Returns the length `L(γᵖˡ) = ∫₀¹ (γ̇ᵀ H(γ) γ̇)^{1/2} dt`, in `m`, with an error estimate as
    /// for the energy.
    #[must_use]
    pub fn length(&self, metric: &impl Metric<D>) -> Integral {
        quadrature(self.chords(), 1, &mut self.squares(metric), f64::sqrt, TOLERANCE)
    }

    /// Returns the length like [`length`](Interpolation::length), for a metric that is evaluated in
    /// batches.
    #[must_use]
    pub fn length_by_batches(&self, metric: &dyn AnyBatches) -> Integral {
        self.quadrature_by_batches(metric, f64::sqrt)
    }

    pub(crate) fn chords(&self) -> usize {
        self.sequence.n().get()
    }

    /// Evaluates a batch at seven fractions of each of some chords. Returns whether `H` is a Gram matrix
    /// at each of them, if the batch computes that.
    pub(crate) fn evaluate(&self, batch: &mut Batch<'_>, places: &[Sevens]) -> bool {
        let (dimension, points) = (self.sequence.dimension(), self.sequence.coordinates());
        for i in 0..dimension {
            let [x, d] = batch.input(i).map(|row| row.as_chunks_mut::<FIRST>().0.iter_mut());
            for ((x, d), (chord, fractions)) in x.zip(d).zip(places) {
                let near = points[chord * dimension + i];
                let step = points[(chord + 1) * dimension + i] - near;
                for k in 0..FIRST {
                    x[k] = near + step * fractions[k];
                    d[k] = step;
                }
            }
        }
        batch.evaluate(FIRST * places.len())
    }

    /// Turns `Σ ∫₀¹ dᵀHd ds` into the energy: a chord takes the time `1/N`.
    fn per_time(&self, Integral { value, error }: Integral) -> Integral {
        let n = self.chords() as f64;
        Integral { value: n * value, error: n * error }
    }

    /// Evaluates `dᵀHd` at seven fractions of each of some chords, point by point.
    fn squares<'s>(
        &'s self,
        metric: &'s impl Metric<D>,
    ) -> impl FnMut(&[Sevens], &mut Vec<[f64; FIRST]>) + 's {
        let metric = AnyMetric::new(metric);
        move |places, squares| {
            squares.clear();
            squares.extend(places.iter().map(|&(chord, fractions)| {
                let (x, d) = self.sequence.chord(chord);
                fractions.map(|s| norm_squared(&metric, &(x + d * s), &d))
            }));
        }
    }

    /// Integrates `of(dᵀHd)` over all chords, in batches.
    fn quadrature_by_batches(&self, metric: &dyn AnyBatches, of: fn(f64) -> f64) -> Integral {
        let mut batch = Batch::new(metric, Kind::Square, FIRST, self.chords());
        let room = batch.lanes() / FIRST;
        let mut squares = |places: &[Sevens], squares: &mut Vec<[f64; FIRST]>| {
            self.evaluate(&mut batch, places);
            let row = batch.row(batch.layout().square[0]).as_chunks().0;
            squares.clear();
            squares.extend(&row[..places.len()]);
        };
        quadrature(self.chords(), room, &mut squares, of, metric.quadrature_tolerance())
    }
}

/// Seven fractions of a chord, and the chord's number.
pub(crate) type Sevens = (usize, [f64; FIRST]);

/// A function that evaluates `dᵀHd` at seven fractions of each of some chords.
type Squares<'s> = dyn FnMut(&[Sevens], &mut Vec<[f64; FIRST]>) + 's;

/// Returns `Σ ∫₀¹ of(dᵀHd) ds`, summed over `n` chords. `squares` evaluates `dᵀHd` on up to `room`
/// chords at a time.
fn quadrature(
    n: usize,
    room: usize,
    squares: &mut Squares<'_>,
    of: fn(f64) -> f64,
    tolerance: f64,
) -> Integral {
    let (mut value, mut error) = (CompensatedSum::default(), 0.0);
    let (mut places, mut first, mut finer) = (Vec::new(), Vec::new(), Vec::new());
    for begin in (0..n).step_by(room) {
        places.clear();
        places.extend((begin..n.min(begin + room)).map(|chord| (chord, FIRST_NODES)));
        squares(&places, &mut first);
        for (&(chord, _), values) in places.iter().zip(&first) {
            let part = integral_by_values(&values.map(of), tolerance).unwrap_or_else(|| {
                let mut at = |nodes| {
                    squares(&[(chord, nodes)], &mut finer);
                    finer[0].map(of)
                };
                // A part of a chord may be as wrong as the whole.
                let mean = values.iter().map(|&value| of(value).abs()).sum::<f64>() / FIRST as f64;
                let least = if tolerance > TOLERANCE { tolerance * mean } else { 0.0 };
                integrate_by_sevens(&mut at, 0.0, 1.0, tolerance, least)
            });
            value.add(part.value);
            error += part.error;
        }
    }
    Integral { value: value.value(), error }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::vector;
    use tautline_metrics::gallery::Valleys;

    use super::Interpolation;
    use crate::PointSequence;

    /// Along `x₁` the integrals over the valleys are `∫ f² = (9/2) x − 4 sin x + ¼ sin 2x` and
    /// `∫ f = 2x − sin x`.
    #[test]
    fn energy_and_length_agree_with_the_primitives() {
        let sequence =
            PointSequence::new(vec![vector![0.0, 1.0], vector![1.5, 1.0], vector![7.0, 1.0]])
                .expect("finite");
        let f2 = |x: f64| 4.5 * x - 4.0 * x.sin() + 0.25 * (2.0 * x).sin();
        let f1 = |x: f64| 2.0 * x - x.sin();
        // For a chord of length d traversed in time 1/2, ∫ f² (2d)² dt = 2 d ∫ f² dx.
        let energy = 2.0 * (1.5 * f2(1.5) + 5.5 * (f2(7.0) - f2(1.5)));
        let curve = Interpolation::new(&sequence);
        let computed = curve.energy(&Valleys);
        assert_relative_eq!(computed.value, energy, max_relative = 1e-14);
        // The estimate is at least one rounding of the value, and not many.
        let relative = computed.error / energy;
        assert!((f64::EPSILON..=1e-13).contains(&relative), "estimate {relative:e}");
        assert_relative_eq!(curve.length(&Valleys).value, f1(7.0), max_relative = 1e-14);
    }

    #[test]
    fn the_curve_passes_through_its_points() {
        let sequence =
            PointSequence::new(vec![vector![0.0], vector![1.0], vector![5.0]]).expect("finite");
        let curve = Interpolation::new(&sequence);
        let values = [-1.0, 0.0, 0.25, 0.5, 0.75, 1.0, 2.0].map(|t| curve.at(t)[0]);
        assert_eq!(values, [0.0, 0.0, 0.5, 1.0, 3.0, 5.0, 5.0]);
        let squares = (0..6).map(|k| vector![f64::from(k * k)]).collect();
        let squares = PointSequence::new(squares).expect("finite");
        let curve = Interpolation::new(&squares);
        assert_eq!([0.1, 0.9, 1.0].map(|t| curve.at(t)[0]), [0.5, 20.5, 25.0]);
    }
}
