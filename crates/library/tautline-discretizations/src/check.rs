//! The check of a metric along a curve, between the nodes of a rule too.

use tautline_formula::{AnyBatches, Batch, Kind, Plain};
use tautline_metrics::{
    Metric, MetricError, check_numbers,
    quadrature::{FIRST_NODES, integral_by_values},
};

use crate::{
    Interpolation,
    interpolation::{FIRST, Sevens},
};

/// The largest numbers of chords, apart from the last one, and of points that are
/// [checked](Interpolation::check). The check starts with the `FIRST` seven points of a quadrature
/// and proceeds, level by level, where a quadrature would refine.
const CHECKED: usize = 512;
const LOOKS: usize = 1 << 17;

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

    /// Returns the chord, and the fractions at the first seven nodes of a quadrature.
    fn places(&self) -> Sevens {
        let Self { chord, from, to } = *self;
        let mut fractions = FIRST_NODES;
        fractions.iter_mut().for_each(|node| *node = from + (to - from) * *node);
        (chord, fractions)
    }

    /// Returns the two halves, if the ends of the piece differ by more than a rounding.
    fn halves(&self) -> Option<[Self; 2]> {
        let middle = 0.5 * (self.from + self.to);
        let is_between = self.from < middle && middle < self.to;
        is_between.then_some([Self { to: middle, ..*self }, Self { from: middle, ..*self }])
    }
}

impl<const D: usize> Interpolation<'_, D> {
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
    pub fn check_by_batches(&self, metric: &dyn AnyBatches) -> Result<(), MetricError> {
        let n = self.chords();
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
        metric: &dyn AnyBatches,
        batch: &mut Batch<'_>,
        pieces: &'p [Piece],
    ) -> Result<impl Iterator<Item = &'p Piece>, MetricError> {
        let places: Vec<Sevens> = pieces.iter().map(Piece::places).collect();
        if !self.evaluate(batch, &places) {
            // The points are checked one by one to find the first defect.
            for (chord, fractions) in places {
                let [x, y] = [chord, chord + 1].map(|point| self.sequence.row(point));
                for s in fractions {
                    let at: Vec<f64> = x.iter().zip(y).map(|(x, y)| x + (y - x) * s).collect();
                    let mut h = vec![0.0; at.len() * at.len()];
                    metric.gram_into(&at, &mut h);
                    check_numbers(&h, &at)?;
                }
            }
        }
        let tolerance = metric.quadrature_tolerance();
        let squares = batch.row(batch.layout().square[0]).as_chunks().0;
        let speeds: Vec<_> = squares[..pieces.len()].iter().map(|s| s.map(f64::sqrt)).collect();
        let pieces = pieces.iter().zip(speeds);
        Ok(pieces
            .filter(move |(_, speeds)| integral_by_values(speeds, tolerance).is_none())
            .map(|(piece, _)| piece))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use nalgebra::{SMatrix, SVector};
    use tautline_metrics::{Metric, MetricError, Scalar};

    use crate::{Interpolation, PointSequence};

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
}
