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

/// From how many times the mean length on, in `ℓ`, a chord is looked at at its ends too, and up to how many
/// chords all of them are. Of more chords fewer than one in sixteen is so long.
const LONG: f64 = 16.0;
const FEW: usize = 64;

/// How many times as large as at the first nodes the integrand may be at an end of a long chord. Beyond that
/// most of the integral is next to the end.
const HIDDEN: f64 = 1e3;

/// How many roundings of its coordinates a point keeps away from an end, so that its distance from there is
/// known to a thousandth.
const ROUNDINGS: f64 = 1024.0;

/// Which part of an integral may be left next to an end where it is taken to converge.
const CONVERGED: f64 = 0.1;

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
    /// such as a step of the metric in the last hundredth of a chord. On a chord that is sixteen times as long
    /// as the mean it also sees what is next to the ends, so that a point far out is no short way round. At the
    /// ends of the curve the integrand may be infinite, like `1/√s`; the result is infinite if its integral is
    /// not seen to converge. The result is NaN if the metric is NaN elsewhere.
    #[must_use]
    pub fn energy(&self, metric: &impl Metric<D>) -> Integral {
        let mut squares = self.squares(metric);
        self.per_time(self.quadrature(1, &mut squares, |square| square, TOLERANCE))
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
        self.quadrature(1, &mut self.squares(metric), f64::sqrt, TOLERANCE)
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

    /// Evaluates a batch at seven [fractions](Sevens) of each of some chords. Returns whether `H` is a Gram matrix
    /// at each of them, if the batch computes that.
    pub(crate) fn evaluate(&self, batch: &mut Batch<'_>, places: &[Sevens]) -> bool {
        let (dimension, points) = (self.sequence.dimension(), self.sequence.coordinates());
        for i in 0..dimension {
            let [x, d] = batch.input(i).map(|row| row.as_chunks_mut::<FIRST>().0.iter_mut());
            for ((x, d), (chord, fractions)) in x.zip(d).zip(places) {
                let ends = [*chord, chord + 1].map(|point| points[point * dimension + i]);
                let step = ends[1] - ends[0];
                for k in 0..FIRST {
                    let is_from_the_second = fractions[k].is_sign_negative();
                    x[k] = ends[usize::from(is_from_the_second)] + step * fractions[k];
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
                let second = SVector::from_column_slice(self.sequence.row(chord + 1));
                let end = |s: f64| if s.is_sign_negative() { &second } else { x };
                fractions.map(|s| norm_squared(&metric, &(end(s) + d * s), &d))
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
        self.quadrature(room, &mut squares, of, metric.quadrature_tolerance())
    }

    /// Returns `Σ ∫₀¹ of(dᵀHd) ds`, summed over all chords. `squares` evaluates `dᵀHd` on up to `room`
    /// chords at a time.
    fn quadrature(
        &self,
        room: usize,
        squares: &mut Squares<'_>,
        of: fn(f64) -> f64,
        tolerance: f64,
    ) -> Integral {
        let (n, long) = (self.chords(), self.long());
        let (mut value, mut error) = (CompensatedSum::default(), 0.0);
        let (mut places, mut first, mut finer) = (Vec::new(), Vec::new(), Vec::new());
        for begin in (0..n).step_by(room) {
            places.clear();
            places.extend((begin..n.min(begin + room)).map(|chord| (chord, FIRST_NODES)));
            squares(&places, &mut first);
            for (&(chord, _), values) in places.iter().zip(&first) {
                let values = values.map(of);
                let mut at = |nodes| {
                    squares(&[(chord, nodes)], &mut finer);
                    finer[0].map(of)
                };
                let is_looked_at = long[chord] || chord == 0 || chord + 1 == n;
                let hidden = || {
                    let closest = self.closest(chord);
                    toward_ends(&mut at, &values, long[chord], closest, tolerance)
                };
                let hidden = is_looked_at.then(hidden).flatten();
                let seen = || integral_by_values(&values, tolerance);
                let part = hidden.or_else(seen).unwrap_or_else(|| {
                    // A part of a chord may be as wrong as the whole.
                    let mean = values.iter().map(|value| value.abs()).sum::<f64>() / FIRST as f64;
                    let least = if tolerance > TOLERANCE { tolerance * mean } else { 0.0 };
                    integrate_by_sevens(&mut at, 0.0, 1.0, tolerance, least)
                });
                value.add(part.value);
                error += part.error;
            }
        }
        Integral { value: value.value(), error }
    }

    /// Returns whether each chord is [long](LONG), or one of a [few](FEW).
    fn long(&self) -> Vec<bool> {
        let chords = self.sequence.coordinates().chunks_exact(self.sequence.dimension());
        let chords = chords.clone().zip(chords.skip(1));
        let lengths: Vec<f64> = chords.map(|(x, y)| largest_step(x, y)).collect();
        let mean = lengths.iter().map(|length| length / lengths.len() as f64).sum::<f64>();
        let is_long = |length: &f64| lengths.len() <= FEW || *length > LONG * mean;
        lengths.iter().map(is_long).collect()
    }

    /// Returns how close to each end of a chord, as a fraction of it, rounding leaves the distance of a point
    /// from that end right to a thousandth.
    fn closest(&self, chord: usize) -> [f64; 2] {
        let [x, y] = [chord, chord + 1].map(|point| self.sequence.row(point));
        let length = largest_step(x, y);
        [x, y].map(|end| {
            let largest = end.iter().fold(0.0_f64, |largest, x| largest.max(x.abs()));
            (ROUNDINGS * f64::EPSILON * largest / length).max(f64::MIN_POSITIVE)
        })
    }
}

/// Returns the largest difference of the coordinates of two points, in `ℓ`.
fn largest_step(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (y - x).abs()).fold(0.0, f64::max)
}

/// Seven fractions of a chord, and the chord's number. A negative fraction, such as −0, counts from the second
/// point: so it reaches points as close to the second point as to the first, however long the chord is.
pub(crate) type Sevens = (usize, [f64; FIRST]);

/// A function that evaluates `dᵀHd` at seven fractions of each of some chords.
type Squares<'s> = dyn FnMut(&[Sevens], &mut Vec<[f64; FIRST]>) + 's;

/// Returns the integral over a chord on intervals that are halved toward both ends, if the integrand is not
/// finite at one of them, such as `1/√s`, or most of the integral is [hidden](HIDDEN) next to one of them. `None`
/// for another chord. The intervals end at the fractions `closest`, where rounding moves points onto the ends. The
/// integral is infinite if the intervals do not show that it converges.
fn toward_ends(
    at: &mut dyn FnMut([f64; FIRST]) -> [f64; FIRST],
    values: &[f64; FIRST],
    is_long: bool,
    closest: [f64; 2],
    tolerance: f64,
) -> Option<Integral> {
    let largest = values.iter().fold(0.0, |largest: f64, value| largest.max(*value));
    let [first, second, ..] = at(std::array::from_fn(|k| if k == 1 { -0.0 } else { 0.0 }));
    let is_hidden = |end: f64| !end.is_finite() || is_long && end > HIDDEN * largest;
    if !is_hidden(first) && !is_hidden(second) {
        return None;
    }
    let mut total = Integral::default();
    for (sign, end, closest) in [(1.0, first, closest[0]), (-1.0, second, closest[1])] {
        let (mut far, mut last, mut rest, mut error) = (0.5, f64::NAN, f64::INFINITY, 0.0);
        while rest > tolerance * total.value && far > closest {
            let [near, beyond] = [0.5 * sign * far, sign * far];
            let [a, b] = if sign > 0.0 { [near, beyond] } else { [beyond, near] };
            let part = integrate_by_sevens(at, a, b, tolerance, 0.0);
            if !part.value.is_finite() {
                return Some(part);
            }
            total += part;
            far *= 0.5;
            // What is left next to the end is the rest of a geometric series, and no less than the integrand
            // at the end says.
            let ratio = if part.value == 0.0 { 0.0 } else { part.value / last };
            let series = part.value * ratio / (1.0 - ratio);
            let series = if series >= 0.0 { series } else { f64::INFINITY };
            rest = if end.is_finite() { series.max(end * far) } else { series };
            error = if end.is_finite() { rest - series.min(end * far) } else { rest };
            last = part.value;
        }
        let is_small = rest <= CONVERGED * total.value;
        let [value, error] = if is_small { [rest, error] } else { [f64::INFINITY; 2] };
        total += Integral { value, error };
    }
    Some(total)
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_metrics::{
        Metric, Scalar,
        gallery::{Sphere, Valleys},
    };

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

    /// The cost `1/√|x − a|`, or another power.
    struct Pole(f64, i32);

    impl Metric<1> for Pole {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_element((x[0] - self.0).sqr().powi(self.1).sqrt().recip())
        }
    }

    /// From a pole at either end, also where numbers next to it are rounded to it. `∫ dx/√x = 2 √x`.
    #[test]
    fn integrable_poles_at_the_ends_are_integrated() {
        for (a, n, accuracy) in [(0.0, 1, 1e-14), (0.0, 7, 1e-14), (5.0, 1, 3e-6), (-5.0, 64, 3e-6)]
        {
            for [from, to] in [[a, a + 3.0], [a - 3.0, a]] {
                let line = PointSequence::straight([from], [to], n).expect("finite");
                let length = Interpolation::new(&line).length(&Pole(a, 1));
                let exact = 2.0 * 3.0_f64.sqrt();
                assert!((length.value - exact).abs() <= length.error, "{length:?}");
                assert!(length.error < accuracy * exact, "{a} {n}: {length:?}");
            }
        }
        for n in [1, 64] {
            let line = PointSequence::straight([0.0], [1.0], n).expect("finite");
            let [length, energy] = [
                Interpolation::new(&line).length(&Pole(0.0, 2)),
                Interpolation::new(&line).energy(&Pole(0.0, 1)),
            ];
            // ∫ dx/x.
            assert_eq!([length.value, energy.value], [f64::INFINITY; 2]);
        }
    }

    /// The cost `x^p (1 − x)^q` from `a` on, for the coordinate `x` from there.
    struct Beta(f64, f64, f64);

    impl Metric<1> for Beta {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let x = x[0] - self.0;
            let power =
                |x: S, p: f64| if p == 0.0 { S::constant(1.0) } else { (x.ln() * (2.0 * p)).exp() };
            SMatrix::from_element(power(x, self.1) * power(1.0 - x, self.2))
        }
    }

    /// `∫₀¹ x^p dx = 1/(1 + p)`, whatever the origin, up to what numbers next to the pole are rounded; also if the
    /// cost vanishes at the other end.
    #[test]
    fn powers_are_integrated_from_their_pole_within_the_error() {
        for (a, p, relative) in [
            (0.0, -0.9, 1e-13),
            (1.0, -0.7, 1e-3),
            (5.0, -0.7, 1e-3),
            (1e4, -0.7, 1e-2),
            (1e6, -0.5, 1e-3),
            (5.0, -0.9, 0.2),
        ] {
            for ends in [[a, a + 1.0], [a + 1.0, a]] {
                let line = PointSequence::straight([ends[0]], [ends[1]], 8).expect("finite");
                let length = Interpolation::new(&line).length(&Beta(a, p, 0.0));
                let exact = 1.0 / (1.0 + p);
                assert!((length.value - exact).abs() <= length.error, "{a} {p}: {length:?}");
                assert!(length.error <= relative * exact, "{a} {p}: {length:?}");
            }
        }
        for (p, q, exact) in [
            (-0.5, 0.5, std::f64::consts::FRAC_PI_2),
            (-0.5, 1.0, 4.0 / 3.0),
            (-0.5, 2.0, 16.0 / 15.0),
            (1.0, -0.5, 4.0 / 3.0),
        ] {
            let line = PointSequence::straight([0.0], [1.0], 1).expect("finite");
            let length = Interpolation::new(&line).length(&Beta(0.0, p, q));
            let accuracy = if q < 0.0 { 1e-6 } else { 1e-12 };
            assert_relative_eq!(length.value, exact, max_relative = accuracy);
        }
        // The last diverges as far as numbers next to 5 show: of ∫ x^−0.99 = 100 they leave three quarters.
        for (a, p) in [(0.0, -1.0), (5.0, -1.0), (0.0, -1.5), (5.0, -0.99)] {
            let line = PointSequence::straight([a], [a + 1.0], 8).expect("finite");
            let length = Interpolation::new(&line).length(&Beta(a, p, 0.0));
            assert_eq!(length.value, f64::INFINITY, "{a} {p}");
        }
    }

    /// In stereographic coordinates far points are near to each other, and a chord to one of them is long next
    /// to its other end only: `∫ 2 dx/(1 + x²)` from 0 to a far point is π.
    #[test]
    fn a_chord_to_a_far_point_is_no_short_way() {
        for far in [1e3, 1e9, 1e54, 1e100] {
            for turned in [false, true] {
                // Many short chords beside the long ones, or two.
                let chords = if far == 1e9 { 2 } else { 100 };
                let near = |k: i32| vector![f64::from(k) / f64::from(chords) - 1.0];
                let mut points: Vec<_> = (0..=chords).map(near).collect();
                points.extend([vector![far], vector![far * 1.5]]);
                if turned {
                    points.reverse();
                }
                let sequence = PointSequence::new(points).expect("finite");
                let length = Interpolation::new(&sequence).length(&Sphere);
                let exact = 2.0 * ((1.5 * far).atan() + 1.0_f64.atan());
                assert_relative_eq!(length.value, exact, max_relative = 1e-12);
            }
        }
    }
}
