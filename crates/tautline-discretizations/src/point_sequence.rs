//! `PointSequence`: the `N + 1` points `γᵖ(t₀), …, γᵖ(t_N)`.

use std::{num::NonZeroUsize, ops::Range};

use nalgebra::SVector;

use crate::compensated_sum::CompensatedSum;

/// The largest `N` of a point sequence: `2²⁶ = ε^(−1/2)`.
///
/// Coordinates have a relative rounding of `ε`, so chords have one of `εN`. With more chords this
/// exceeds `1/N`, the relative error of a first-order rule, and a finer grid does not improve the
/// result.
pub const LARGEST_N: usize = 1 << 26;

/// A sequence of `N + 1` points of `R^D`, at the times `tₙ = n/N`.
///
/// Invariant: there are at least two points and at most [`LARGEST_N`] chords, and all points are
/// finite.
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "polyline")]
pub struct PointSequence<const D: usize> {
    points: Vec<SVector<f64, D>>,
    extent: f64,
}

/// The reason why points do not form a point sequence.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SequenceError {
    /// `N = 0`, although a sequence needs a first and a last point.
    #[error("{points} points make no subinterval: N must be at least 1")]
    NoSubinterval {
        /// The number of points.
        points: usize,
    },
    /// There are more than [`LARGEST_N`] subintervals.
    #[error(
        "N = {n} is too many subintervals: beyond {}, rounding outweighs the gain in accuracy",
        LARGEST_N
    )]
    TooManySubintervals {
        /// The number of subintervals.
        n: usize,
    },
    /// The system has no memory for the points.
    #[error("N = {n}: no memory for {bytes} bytes of points")]
    OutOfMemory {
        /// The number of subintervals.
        n: usize,
        /// The size of the points, in bytes.
        bytes: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("coordinate {coordinate} of point {index} is {value}: it must be finite")]
    NotFinite {
        /// The index of the point, from 0.
        index: usize,
        /// The index of the coordinate, from 0.
        coordinate: usize,
        /// The coordinate.
        value: f64,
    },
}

impl<const D: usize> PointSequence<D> {
    /// Makes a sequence from points. There must be at least two points and at most [`LARGEST_N`]
    /// chords, and all points must be finite.
    ///
    /// # Errors
    ///
    /// The first defect, with its index.
    pub fn new(points: Vec<SVector<f64, D>>) -> Result<Self, SequenceError> {
        if points.len() < 2 {
            return Err(SequenceError::NoSubinterval { points: points.len() });
        }
        if points.len() - 1 > LARGEST_N {
            return Err(SequenceError::TooManySubintervals { n: points.len() - 1 });
        }
        let extent = extent(&points);
        if !extent.is_finite() {
            return Err(not_finite(&points));
        }
        Ok(Self { points, extent })
    }

    /// Returns `N + 1` equidistant points on the segment from `a` to `b`.
    ///
    /// # Errors
    ///
    /// As for [`PointSequence::new`]; also [`SequenceError::OutOfMemory`]. Too many points are
    /// refused before memory is allocated.
    pub fn straight(
        a: impl Into<SVector<f64, D>>,
        b: impl Into<SVector<f64, D>>,
        n: usize,
    ) -> Result<Self, SequenceError> {
        let (a, b) = (a.into(), b.into());
        if n == 0 {
            return Err(SequenceError::NoSubinterval { points: 1 });
        }
        if n > LARGEST_N {
            return Err(SequenceError::TooManySubintervals { n });
        }
        let mut points: Vec<SVector<f64, D>> = Vec::new();
        if points.try_reserve_exact(n + 1).is_err() {
            let bytes = (n + 1).saturating_mul(size_of::<SVector<f64, D>>());
            return Err(SequenceError::OutOfMemory { n, bytes });
        }
        let at = |k: usize| {
            let t = k as f64 / n as f64;
            // This formula is exact at both ends, while a + t (b − a) is not.
            a * (1.0 - t) + b * t
        };
        points.extend((0..=n).map(at));
        Self::new(points)
    }

    /// Returns `N`, the number of subintervals.
    #[must_use]
    pub fn n(&self) -> NonZeroUsize {
        NonZeroUsize::new(self.points.len() - 1).expect("at least two points")
    }

    /// Returns the `N + 1` points, in `ℓ`.
    #[must_use]
    pub fn points(&self) -> &[SVector<f64, D>] {
        &self.points
    }

    /// Returns the largest coordinate in absolute value, in `ℓ`. Coordinates are rounded by at most
    /// `ε` times this number.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Returns the first point.
    #[must_use]
    pub fn first(&self) -> &SVector<f64, D> {
        &self.points[0]
    }

    /// Returns the last point.
    #[must_use]
    pub fn last(&self) -> &SVector<f64, D> {
        &self.points[self.points.len() - 1]
    }

    /// Returns the `N` chords, each as its first point and the vector to the next point, in `ℓ`.
    pub fn chords(&self) -> impl ExactSizeIterator<Item = (&SVector<f64, D>, SVector<f64, D>)> {
        chords(&self.points)
    }

    /// Returns the chords with these indices, as an iterator that can be advanced from either end.
    ///
    /// # Panics
    ///
    /// If an index exceeds `N`.
    #[inline]
    pub fn chords_in(
        &self,
        numbers: Range<usize>,
    ) -> impl DoubleEndedIterator<Item = (&SVector<f64, D>, SVector<f64, D>)> + ExactSizeIterator
    {
        chords(&self.points[numbers.start..=numbers.end])
    }

    /// Returns chord `n < N` as its first point and the vector to the next point, in `ℓ`.
    #[must_use]
    #[inline]
    pub fn chord(&self, n: usize) -> (&SVector<f64, D>, SVector<f64, D>) {
        (&self.points[n], self.points[n + 1] - self.points[n])
    }

    /// Returns the finite differences `βₙ = N (xₙ₊₁ − xₙ)`, in `ℓ`, for `n = 0, …, N − 1`.
    #[doc(alias = "beta")]
    pub fn differences(&self) -> impl ExactSizeIterator<Item = SVector<f64, D>> {
        let n = self.n().get() as f64;
        self.chords().map(move |(_, chord)| chord * n)
    }

    /// Returns `K₃ = ((1/N) Σ |βₙ|²)^{1/2}`, the root mean square of the differences, in `ℓ`.
    #[must_use]
    pub fn k3(&self) -> f64 {
        let sum: CompensatedSum = self.differences().map(|beta| beta.norm_squared()).collect();
        (sum.value() / self.n().get() as f64).sqrt()
    }

    /// Returns the points.
    #[must_use]
    pub fn into_points(self) -> Vec<SVector<f64, D>> {
        self.points
    }
}

/// Returns the chords between consecutive points.
#[inline]
pub(crate) fn chords<const D: usize>(
    points: &[SVector<f64, D>],
) -> impl DoubleEndedIterator<Item = (&SVector<f64, D>, SVector<f64, D>)> + ExactSizeIterator {
    points.array_windows().map(|[x, y]| (x, y - x))
}

/// Returns the largest coordinate in absolute value; the result is infinite or NaN if a coordinate
/// is.
fn extent<const D: usize>(points: &[SVector<f64, D>]) -> f64 {
    // Two points are processed at a time, for two independent chains of operations.
    let (many, rest) = points.as_chunks::<2>();
    let mut largest = [SVector::<f64, D>::zeros(); 2];
    let mut undefined = largest;
    for points in many {
        for k in 0..2 {
            for i in 0..D {
                let size = points[k][i].abs();
                largest[k][i] = if size > largest[k][i] { size } else { largest[k][i] };
                // This product is NaN for infinity and NaN.
                undefined[k][i] += size * 0.0;
            }
        }
    }
    let all =
        largest.iter().chain(rest).flat_map(|x| x.iter()).fold(0.0, |a: f64, x| a.max(x.abs()));
    undefined.iter().chain(rest).flat_map(|x| x.iter()).fold(all, |sum, x| sum + x * 0.0)
}

/// Returns the error for the first coordinate that is NaN or infinite.
fn not_finite<const D: usize>(points: &[SVector<f64, D>]) -> SequenceError {
    let all = points.iter().flat_map(|point| point.iter());
    let place = all.clone().position(|x| !x.is_finite()).expect("a coordinate is not finite");
    let (index, coordinate) = (place / D, place % D);
    SequenceError::NotFinite { index, coordinate, value: points[index][coordinate] }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};

    use super::{LARGEST_N, PointSequence, SequenceError};

    #[test]
    fn a_straight_sequence_is_equidistant_and_ends_exactly() {
        let line = PointSequence::straight([0.1, 0.2], [0.7, -0.3], 7).expect("finite");
        assert_eq!(line.n().get(), 7);
        assert_eq!((line.first(), line.last()), (&vector![0.1, 0.2], &vector![0.7, -0.3]));
        // Differences of coordinates below 1 are multiplied by 7, so rounding is about 7 ε.
        assert!(line.differences().all(|beta| (beta - vector![0.6, -0.5]).amax() < 1e-14));
        approx::assert_relative_eq!(line.k3(), 0.61_f64.sqrt(), max_relative = 1e-14);
    }

    /// For one in five of these sequences, `a + t (b − a)` would miss `b` by a rounding.
    #[test]
    fn straight_sequences_always_end_exactly() {
        for k in 1..1000 {
            let wave = |j: i32| (f64::from(k) * f64::from(j).sqrt()).sin();
            let (a, b) = (vector![wave(2), 1e3 * wave(3)], vector![wave(5), 1e-3 * wave(7)]);
            let line = PointSequence::straight(a, b, 1 + k as usize % 9).expect("finite");
            assert_eq!((line.first(), line.last()), (&a, &b));
        }
        // The difference of these ends overflows.
        let wide = PointSequence::straight([-f64::MAX], [f64::MAX], 4).expect("finite");
        assert_eq!(wide.points()[2], vector![0.0]);
    }

    /// If there is one jump, `β = N (b − a)` occurs once, so `K₃ = √N |b − a|`.
    #[test]
    fn k3_of_one_jump_is_sqrt_n() {
        let mut points = vec![vector![0.0]; 4];
        points.push(vector![3.0]);
        let jump = PointSequence::new(points).expect("finite");
        assert_eq!(jump.k3(), 6.0);
        assert_eq!(jump.clone().into_points(), jump.points());
    }

    /// In dimension 0 any number of points takes no memory.
    #[test]
    fn more_chords_than_rounding_allows_are_refused() {
        let too_many = |n| Err(SequenceError::TooManySubintervals { n });
        let points = |n: usize| PointSequence::new(vec![SVector::<f64, 0>::zeros(); n + 1]);
        let exactly =
            PointSequence::straight([0.0], [1.0], 5).map(|line| line.into_points().capacity());
        assert_eq!(exactly, Ok(6));
        assert_eq!(points(LARGEST_N).map(|line| line.n().get()), Ok(LARGEST_N));
        assert_eq!(points(LARGEST_N + 1).map(|_| ()), too_many(LARGEST_N + 1));
        // The points would take 8 or 512 bytes each, but nothing is allocated.
        for n in [LARGEST_N + 1, 1_000_000_000, usize::MAX - 1, usize::MAX] {
            assert_eq!(PointSequence::straight([0.0], [1.0], n).map(|_| ()), too_many(n));
            let line = PointSequence::straight([0.0; 64], [1.0; 64], n);
            assert_eq!(line.map(|_| ()), too_many(n));
        }
        assert_eq!(LARGEST_N as f64, f64::EPSILON.powf(-0.5));
    }

    #[test]
    fn the_extent_is_the_largest_coordinate_wherever_it_is() {
        for count in 2..=5 {
            for (index, coordinate) in (0..count).flat_map(|i| (0..2).map(move |j| (i, j))) {
                let mut points = vec![vector![1.0, -2.0]; count];
                points[index][coordinate] = -3.0;
                let extent = PointSequence::new(points).map(|sequence| sequence.extent());
                assert_eq!(extent, Ok(3.0), "{index} of {count}");
            }
        }
    }

    #[test]
    fn bad_points_are_reported_by_index() {
        assert_eq!(
            PointSequence::straight([0.0], [1.0], 0),
            Err(SequenceError::NoSubinterval { points: 1 })
        );
        assert_eq!(
            PointSequence::<2>::new(vec![]),
            Err(SequenceError::NoSubinterval { points: 0 })
        );
        let error = PointSequence::new(vec![vector![0.0, 0.0], vector![0.0, f64::NAN]]);
        assert!(matches!(error, Err(SequenceError::NotFinite { index: 1, coordinate: 1, .. })));
        assert!(PointSequence::straight([0.0], [f64::INFINITY], 2).is_err());
        let one = PointSequence::new(vec![vector![1.0]]);
        assert_eq!(one, Err(SequenceError::NoSubinterval { points: 1 }));
        assert!(PointSequence::new(vec![vector![1.0]; 2]).is_ok());
        // The defect is at any place among an even or an odd number of points.
        for count in 2..=5 {
            for (index, coordinate) in (0..count).flat_map(|i| (0..3).map(move |j| (i, j))) {
                for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                    let mut points = vec![vector![1.0, -2.0, 3.0]; count];
                    points[index][coordinate] = bad;
                    let Err(SequenceError::NotFinite { index: i, coordinate: j, value }) =
                        PointSequence::new(points)
                    else {
                        panic!("{bad} at {index}")
                    };
                    assert_eq!((i, j, value.to_bits()), (index, coordinate, bad.to_bits()));
                }
            }
        }
        // The first of several defects is reported, wherever it is.
        let bad = f64::NEG_INFINITY;
        for (index, coordinate) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let mut points = vec![vector![0.0, 0.0, 0.0]; 3];
            points[index][coordinate] = bad;
            for later in coordinate + 1..3 {
                points[index][later] = f64::NAN;
            }
            for later in index + 1..3 {
                points[later] = vector![f64::NAN, f64::NAN, f64::NAN];
            }
            let error = SequenceError::NotFinite { index, coordinate, value: bad };
            assert_eq!(PointSequence::new(points), Err(error));
        }
    }
}
