//! Points on a curve with equally much of its length between neighbours.

use tautline_formula::AnyBatches;
use tautline_metrics::quadrature::integrate;

use crate::{
    Interpolation, LARGEST_N, PointSequence, SequenceError, gram_square::gram_square,
    interpolation::TOLERANCE,
};

/// The largest number of steps towards a point on a chord. Newton's method takes a few; where it
/// leaves the bracket, a bisection halves it.
const STEPS: usize = 64;

impl<const D: usize> Interpolation<'_, D> {
    /// Returns `n + 1` points on this curve, in `ℓ`, so that the length under `metric` from each to
    /// the next along this curve is the same, up to a rounding of the whole for each old chord. Both ends are exact.
    ///
    /// This is the curve at constant speed. New chords cut the corners of the old ones, so that a
    /// minimiser on `n` chords is close to these points, but is not at them. A curve of length 0
    /// gives points that are equally spaced in time.
    ///
    /// # Errors
    ///
    /// [`SequenceError::NoSubinterval`] and [`SequenceError::TooManySubintervals`] for an `n` that
    /// is out of range, and [`SequenceError::NotFinite`], of no particular point, if the length is not
    /// finite: the metric is not finite, or not positive, along the curve.
    pub fn resampled(
        &self,
        metric: &dyn AnyBatches,
        n: usize,
    ) -> Result<PointSequence<D>, SequenceError> {
        if n == 0 {
            return Err(SequenceError::NoSubinterval { points: 1 });
        }
        if n > LARGEST_N {
            return Err(SequenceError::TooManySubintervals { n });
        }
        // The length up to each point of the sequence.
        let mut lengths = Vec::with_capacity(self.chords() + 1);
        let mut total = 0.0;
        for chord in 0..self.chords() {
            lengths.push(total);
            total += self.length_within(metric, chord, 1.0);
        }
        lengths.push(total);
        if !total.is_finite() {
            return Err(SequenceError::NotFinite { index: 0, coordinate: 0, value: total });
        }
        let d = self.sequence.dimension();
        let mut points = Vec::with_capacity((n + 1) * d);
        if total == 0.0 {
            (0..=n).for_each(|k| points.extend(self.coordinates_at(k as f64 / n as f64)));
            return PointSequence::of_coordinates(d, points);
        }
        points.extend_from_slice(self.sequence.row(0));
        let mut chord = 0;
        for k in 1..n {
            let length = total * (k as f64 / n as f64);
            while chord + 1 < self.chords() && lengths[chord + 1] <= length {
                chord += 1;
            }
            let [from, to] = [lengths[chord], lengths[chord + 1]];
            let s = self.fraction(metric, chord, length - from, to - from);
            let ends = self.sequence.row(chord).iter().zip(self.sequence.row(chord + 1));
            points.extend(ends.map(|(x, y)| x + (y - x) * s));
        }
        points.extend_from_slice(self.sequence.row(self.chords()));
        PointSequence::of_coordinates(d, points)
    }

    /// Returns the speed `(dᵀH d)^{1/2}` at a fraction of a chord `d`.
    fn speed(&self, metric: &dyn AnyBatches, chord: usize, s: f64) -> f64 {
        let ends = self.sequence.row(chord).iter().zip(self.sequence.row(chord + 1));
        let (x, d): (Vec<f64>, Vec<f64>) = ends.map(|(x, y)| (x + (y - x) * s, y - x)).unzip();
        gram_square(metric, &x, &d).sqrt()
    }

    /// Returns the length of a chord up to a fraction of it.
    fn length_within(&self, metric: &dyn AnyBatches, chord: usize, s: f64) -> f64 {
        integrate(|s| self.speed(metric, chord, s), 0.0, s, TOLERANCE).value
    }

    /// Returns the fraction of a chord, which has the length `whole`, up to which its length is
    /// `length`.
    fn fraction(&self, metric: &dyn AnyBatches, chord: usize, length: f64, whole: f64) -> f64 {
        let (mut low, mut high) = (0.0, 1.0);
        let mut s = (length / whole).clamp(0.0, 1.0);
        for _ in 0..STEPS {
            let off = self.length_within(metric, chord, s) - length;
            if !(off.abs() > TOLERANCE * whole) {
                break;
            }
            if off > 0.0 {
                high = s
            } else {
                low = s
            }
            let newton = s - off / self.speed(metric, chord, s);
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if next == s {
                break;
            }
            s = next;
        }
        s
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_formula::Prepared;
    use tautline_metrics::{Metric, Scalar, gallery::Valleys};

    use crate::{Interpolation, LARGEST_N, PointSequence, SequenceError};

    #[test]
    fn the_length_between_neighbours_is_the_same() {
        let points =
            vec![vector![0.0, 1.0], vector![1.5, 0.5], vector![7.0, 1.0], vector![7.1, 3.0]];
        let sequence = PointSequence::new(points).expect("finite");
        let curve = Interpolation::new(&sequence);
        let whole = curve.length(&Valleys).value;
        let metric = Prepared::<_, 2>::new(Valleys);
        for n in [1, 2, 3, 10, 64] {
            let found = curve.resampled(&metric, n).expect("a metric");
            assert_eq!(found.n().get(), n);
            assert_eq!((found.first(), found.last()), (sequence.first(), sequence.last()));
            // Along the old curve: through its corners between two new points.
            let mut corner = 1;
            for (k, pair) in found.points().windows(2).enumerate() {
                let mut path = vec![pair[0]];
                while corner < 3 && pair[1][0] > sequence.points()[corner][0] {
                    path.push(sequence.points()[corner]);
                    corner += 1;
                }
                path.push(pair[1]);
                let path = PointSequence::new(path).expect("finite");
                let length = Interpolation::new(&path).length(&Valleys).value;
                // A few quadratures, each exact to a few roundings of the length of a chord.
                let error = (length - whole / n as f64).abs();
                assert!(error <= 1e-13 * whole, "{n}, {k}: {error:e}");
            }
        }
    }

    /// A new chord may pass many old ones, of different lengths: a curve of a hundred chords is resampled as
    /// the same curve of one chord.
    #[test]
    fn a_new_chord_passes_many_old_ones() {
        let metric = Prepared::<_, 2>::new(Valleys);
        let at = |k: usize| vector![5.0 * (k as f64 / 100.0).powi(2), 0.0];
        let many = PointSequence::new((0..=100).map(at).collect()).expect("finite");
        let one = PointSequence::straight([0.0, 0.0], [5.0, 0.0], 1).expect("finite");
        for n in [2, 3, 7] {
            let [many, one] = [&many, &one]
                .map(|curve| Interpolation::new(curve).resampled(&metric, n).expect("a metric"));
            for (x, y) in many.points().iter().zip(one.points()) {
                // A hundred quadratures, each exact to a few roundings of its own length, over a
                // speed of at least 1.
                assert!((x - y).amax() < 1e-13, "{n}: {x} {y}");
            }
        }
    }

    #[test]
    fn what_cannot_be_resampled_is_an_error() {
        let metric = Prepared::<_, 2>::new(Valleys);
        let line = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 3).expect("finite");
        let curve = Interpolation::new(&line);
        assert_eq!(curve.resampled(&metric, 0), Err(SequenceError::NoSubinterval { points: 1 }));
        let n = LARGEST_N + 1;
        assert_eq!(curve.resampled(&metric, n), Err(SequenceError::TooManySubintervals { n }));
        struct Negative;
        impl Metric<1> for Negative {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                SMatrix::from_element(x[0])
            }
        }
        let line = PointSequence::straight([-1.0], [1.0], 3).expect("finite");
        let found = Interpolation::new(&line).resampled(&Prepared::new(Negative), 4);
        assert!(matches!(found, Err(SequenceError::NotFinite { .. })), "{found:?}");
    }

    #[test]
    fn a_curve_without_length_is_resampled_in_time() {
        let still = PointSequence::straight([2.0, 1.0], [2.0, 1.0], 2).expect("finite");
        let found = Interpolation::new(&still).resampled(&Prepared::<_, 2>::new(Valleys), 5);
        assert_eq!(found, PointSequence::straight([2.0, 1.0], [2.0, 1.0], 5));
    }
}
