//! `Interpolation`: the curve `γᵖˡ` that joins a point sequence by straight lines.

use nalgebra::SVector;
use tautline_formula::{AnyMetric, Batch, Batches, Kind, Plain};
use tautline_metrics::{
    Metric, MetricError, check_matrix, norm_squared,
    quadrature::{FIRST_NODES, Integral, integral_by_values, integrate_by_sevens},
};

use crate::{PointSequence, compensated_sum::CompensatedSum};

/// The relative tolerance of the quadrature on each chord. It is a few roundings, so that
/// `E(γᵖˡ) − d²` is as accurate as `d²` itself.
const TOLERANCE: f64 = 4.0 * f64::EPSILON;

/// The largest numbers of chords, apart from the last one, and of points that are
/// [checked](Interpolation::check). The check starts with the `FIRST` seven points of a quadrature
/// and proceeds, level by level, where a quadrature would refine.
const CHECKED: usize = 512;
const LOOKS: usize = 1 << 17;
const FIRST: usize = FIRST_NODES.len();

/// A piece of a chord, from one fraction of it to another.
#[derive(Clone, Copy, Debug)]
struct Piece {
    chord: usize,
    from: f64,
    to: f64,
}

impl Piece {
    fn of_chord(chord: usize) -> Self {
        Self { chord, from: 0.0, to: 1.0 }
    }

    /// Returns the places of the first seven nodes of a quadrature, each as the chord and the
    /// fraction.
    fn places(&self) -> impl Iterator<Item = (usize, f64)> {
        let Self { chord, from, to } = *self;
        FIRST_NODES.iter().map(move |node| (chord, from + (to - from) * node))
    }

    /// Returns the two halves, if the ends of the piece differ by more than a rounding.
    fn halves(&self) -> Option<[Self; 2]> {
        let middle = 0.5 * (self.from + self.to);
        let is_between = self.from < middle && middle < self.to;
        is_between.then_some([Self { to: middle, ..*self }, Self { from: middle, ..*self }])
    }
}

/// The curve `γᵖˡ` that interpolates a point sequence linearly.
#[derive(Clone, Copy, Debug)]
#[doc(alias = "reconstruction")]
pub struct Interpolation<'a, const D: usize> {
    sequence: &'a PointSequence<D>,
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
        let points = self.sequence.points();
        let position = t.clamp(0.0, 1.0) * (points.len() - 1) as f64;
        // The last chord includes t = 1.
        let k = (position as usize).min(points.len() - 2);
        let s = position - k as f64;
        points[k] * (1.0 - s) + points[k + 1] * s
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
        self.per_time(quadrature(self.chords(), 1, &mut squares, |square| square))
    }

    /// Returns the energy like [`energy`](Interpolation::energy), for a metric that is evaluated in
    /// batches.
    #[must_use]
    pub fn energy_by_batches(&self, metric: &dyn Batches<D>) -> Integral {
        self.per_time(self.quadrature_by_batches(metric, |square| square))
    }

    /// Returns the length `L(γᵖˡ) = ∫₀¹ (γ̇ᵀ H(γ) γ̇)^{1/2} dt`, in `m`, with an error estimate as
    /// for the energy.
    #[must_use]
    pub fn length(&self, metric: &impl Metric<D>) -> Integral {
        quadrature(self.chords(), 1, &mut self.squares(metric), f64::sqrt)
    }

    /// Returns the length like [`length`](Interpolation::length), for a metric that is evaluated in
    /// batches.
    #[must_use]
    pub fn length_by_batches(&self, metric: &dyn Batches<D>) -> Integral {
        self.quadrature_by_batches(metric, f64::sqrt)
    }

    /// Checks that the Gram matrix is finite, symmetric and positive definite along the curve.
    ///
    /// The check covers every `⌈N/512⌉`-th chord and the last one, at 131 072 points or fewer in
    /// all. It starts with the first nodes of the quadrature for [`length`](Interpolation::length)
    /// and then proceeds, level by level, where that quadrature would refine. This is not a proof;
    /// for one see `tautline-certify`.
    ///
    /// # Errors
    ///
    /// [`MetricError`], with the point of the defect.
    pub fn check(&self, metric: &impl Metric<D>) -> Result<(), MetricError> {
        self.check_by_batches(&Plain::new(metric))
    }

    /// Checks like [`check`](Interpolation::check), for a metric that is evaluated in batches.
    ///
    /// # Errors
    ///
    /// [`MetricError`], with the point of the defect.
    pub fn check_by_batches(&self, metric: &dyn Batches<D>) -> Result<(), MetricError> {
        let n = self.sequence.n().get();
        let chords = (0..n).step_by(n.div_ceil(CHECKED)).chain([n - 1]);
        let mut pieces: Vec<Piece> = chords.map(Piece::of_chord).collect();
        let mut batch = Batch::new(metric, Kind::Checked, FIRST, pieces.len());
        let room = batch.lanes() / FIRST;
        let mut left = LOOKS;
        // The halves are checked after all pieces of twice their length.
        while !pieces.is_empty() {
            let mut halves = Vec::new();
            for some in pieces.chunks(room) {
                let Some(fewer) = left.checked_sub(FIRST * some.len()) else { return Ok(()) };
                left = fewer;
                for piece in self.unsettled(metric, &mut batch, some)? {
                    halves.extend(piece.halves().into_iter().flatten());
                }
            }
            pieces = halves;
        }
        Ok(())
    }

    /// Checks the first nodes of a quadrature on these pieces, and returns the pieces that the
    /// quadrature would halve.
    fn unsettled<'p>(
        &self,
        metric: &dyn Batches<D>,
        batch: &mut Batch<'_, D>,
        pieces: &'p [Piece],
    ) -> Result<impl Iterator<Item = &'p Piece>, MetricError> {
        let places = || pieces.iter().flat_map(Piece::places);
        let mut inputs = batch.inputs(FIRST * pieces.len());
        for (lane, (chord, s)) in places().enumerate() {
            let (x, d) = self.sequence.chord(chord);
            inputs.set(lane, &(x + d * s), &d);
        }
        if !batch.evaluate(FIRST * pieces.len()) {
            // The points are checked one by one to find the first defect.
            for (chord, s) in places() {
                let (x, d) = self.sequence.chord(chord);
                let at = x + d * s;
                check_matrix(metric.gram(&at), &at)?;
            }
        }
        let squares = batch.row(batch.layout().square[0]).as_chunks().0;
        let speeds: Vec<_> = squares[..pieces.len()].iter().map(|s| s.map(f64::sqrt)).collect();
        let pieces = pieces.iter().zip(speeds);
        Ok(pieces
            .filter(|(_, speeds)| integral_by_values(speeds, TOLERANCE).is_none())
            .map(|(piece, _)| piece))
    }

    fn chords(&self) -> usize {
        self.sequence.n().get()
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
    fn quadrature_by_batches(&self, metric: &dyn Batches<D>, of: fn(f64) -> f64) -> Integral {
        let mut batch = Batch::new(metric, Kind::Square, FIRST, self.chords());
        let room = batch.lanes() / FIRST;
        let mut squares = |places: &[Sevens], squares: &mut Vec<[f64; FIRST]>| {
            let count = FIRST * places.len();
            let mut inputs = batch.inputs(count);
            for (&(chord, fractions), first) in places.iter().zip((0..).step_by(FIRST)) {
                let (x, d) = self.sequence.chord(chord);
                for (s, lane) in fractions.into_iter().zip(first..) {
                    inputs.set(lane, &(x + d * s), &d);
                }
            }
            batch.evaluate(count);
            let row = batch.row(batch.layout().square[0]).as_chunks().0;
            squares.clear();
            squares.extend(&row[..places.len()]);
        };
        quadrature(self.chords(), room, &mut squares, of)
    }
}

/// Seven fractions of a chord, and the chord's number.
type Sevens = (usize, [f64; FIRST]);

/// Returns `Σ ∫₀¹ of(dᵀHd) ds`, summed over `n` chords. `squares` evaluates `dᵀHd` on up to `room`
/// chords at a time.
fn quadrature(
    n: usize,
    room: usize,
    squares: &mut dyn FnMut(&[Sevens], &mut Vec<[f64; FIRST]>),
    of: fn(f64) -> f64,
) -> Integral {
    let (mut value, mut error) = (CompensatedSum::default(), 0.0);
    let (mut places, mut first, mut finer) = (Vec::new(), Vec::new(), Vec::new());
    for begin in (0..n).step_by(room) {
        places.clear();
        places.extend((begin..n.min(begin + room)).map(|chord| (chord, FIRST_NODES)));
        squares(&places, &mut first);
        for (&(chord, _), values) in places.iter().zip(&first) {
            let part = integral_by_values(&values.map(of), TOLERANCE).unwrap_or_else(|| {
                let mut at = |nodes| {
                    squares(&[(chord, nodes)], &mut finer);
                    finer[0].map(of)
                };
                integrate_by_sevens(&mut at, 0.0, 1.0, TOLERANCE)
            });
            value.add(part.value);
            error += part.error;
        }
    }
    Integral { value: value.value(), error }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use approx::assert_relative_eq;
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_metrics::{Metric, MetricError, Scalar, gallery::Valleys};

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

    /// The identity, which counts its evaluations and is NaN to the right of `end`.
    struct Counted {
        asked: AtomicUsize,
        end: f64,
    }

    impl Metric<1> for Counted {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            self.asked.fetch_add(1, Ordering::Relaxed);
            SMatrix::from_element((self.end - x[0]).sqrt() * 0.0 + 1.0)
        }
    }

    /// Returns the number of evaluations that checking a straight line takes, and the result of the
    /// check.
    fn check(n: usize, end: f64) -> (usize, Result<(), MetricError>) {
        let line = PointSequence::straight([0.0], [1.0], n).expect("finite");
        let metric = Counted { asked: AtomicUsize::new(0), end };
        let result = Interpolation::new(&line).check(&metric);
        (metric.asked.into_inner(), result)
    }

    /// The check uses seven points on each of at most 512 chords and on the last one.
    #[test]
    fn the_check_costs_no_more_on_fine_grids() {
        for (n, chords) in [(1, 1), (3, 3), (512, 512), (513, 257), (1_000_000, 512)] {
            let (asked, result) = check(n, 2.0);
            assert_eq!(result, Ok(()));
            // The last chord may be checked twice.
            assert!((7 * chords..=7 * (chords + 1)).contains(&asked), "N = {n}: {asked}");
        }
        // A formula that no number of points resolves uses the whole budget, up to part of a batch.
        struct Noise(AtomicUsize);
        impl Metric<1> for Noise {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                self.0.fetch_add(1, Ordering::Relaxed);
                SMatrix::from_element(2.0 + (x[0] * 1e12).sin())
            }
        }
        let noise = Noise(AtomicUsize::new(0));
        let line = PointSequence::straight([0.0], [1.0], 10).expect("finite");
        assert_eq!(Interpolation::new(&line).check(&noise), Ok(()));
        let asked = noise.0.into_inner();
        assert!(((1 << 17) - 7 * 16..=1 << 17).contains(&asked), "{asked}");
    }

    #[test]
    fn the_last_chord_is_checked_on_every_grid() {
        for n in [1, 2, 511, 1000, 100_000] {
            let (_, result) = check(n, 1.0 - 1e-3 / n as f64);
            let Ok(()) = result else {
                panic!("the last node is 0.0197 of a chord before its end")
            };
            let (_, result) = check(n, 1.0 - 0.03 / n as f64);
            let Err(MetricError::NotFinite { point, .. }) = result else { panic!("N = {n}") };
            assert!(point[0] > 1.0 - 0.03 / n as f64);
        }
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
