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
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(try_from = "Vec<SVector<f64, D>>", into = "Vec<SVector<f64, D>>")
)]
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

/// Reads a sequence with the feature `serde`.
#[cfg(feature = "serde")]
impl<const D: usize> TryFrom<Vec<SVector<f64, D>>> for PointSequence<D> {
    type Error = SequenceError;

    fn try_from(points: Vec<SVector<f64, D>>) -> Result<Self, SequenceError> {
        Self::new(points)
    }
}

/// Writes a sequence with the feature `serde`.
#[cfg(feature = "serde")]
impl<const D: usize> From<PointSequence<D>> for Vec<SVector<f64, D>> {
    fn from(sequence: PointSequence<D>) -> Self {
        sequence.into_points()
    }
}

/// Returns the chords between consecutive points.
#[inline]
pub(crate) fn chords<const D: usize>(
    points: &[SVector<f64, D>],
) -> impl DoubleEndedIterator<Item = (&SVector<f64, D>, SVector<f64, D>)> + ExactSizeIterator {
    let later = points.get(1..).unwrap_or_default();
    points[..later.len()].iter().zip(later).map(|(x, y)| (x, y - x))
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
mod tests;
