//! `PointSequence`: the `N + 1` points `γᵖ(t₀), …, γᵖ(t_N)`.

use std::{num::NonZeroUsize, ops::Range};

use nalgebra::SVector;
use tautline_scalar::ANY;

use crate::compensated_sum::CompensatedSum;

/// The largest `N` of a point sequence: `2²⁶ = ε^(−1/2)`.
///
/// Coordinates have a relative rounding of `ε`, so chords have one of `εN`. With more chords this
/// exceeds `1/N`, the relative error of a first-order rule, and a finer grid does not improve the
/// result.
pub const LARGEST_N: usize = 1 << 26;

/// A sequence of `N + 1` points of `R^D`, at the times `tₙ = n/N`.
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`].
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
    dimension: usize,
    /// The coordinates, point by point.
    coordinates: Vec<f64>,
    n: NonZeroUsize,
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
    /// The coordinates are not those of whole points.
    #[error("{coordinates} coordinates are not those of whole points in dimension {dimension}")]
    NotWhole {
        /// The number of coordinates.
        coordinates: usize,
        /// The dimension.
        dimension: usize,
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
        Self::checked(D, points.len(), || bytemuck::cast_vec(points))
    }

    /// Makes a sequence from so many points, whose coordinates follow one another.
    fn checked(
        dimension: usize,
        points: usize,
        coordinates: impl FnOnce() -> Vec<f64>,
    ) -> Result<Self, SequenceError> {
        let n = points.checked_sub(1).and_then(NonZeroUsize::new);
        let n = n.ok_or(SequenceError::NoSubinterval { points })?;
        if n.get() > LARGEST_N {
            return Err(SequenceError::TooManySubintervals { n: n.get() });
        }
        let coordinates = coordinates();
        let extent = extent(&coordinates);
        if !extent.is_finite() {
            return Err(not_finite(dimension, &coordinates));
        }
        Ok(Self { dimension, coordinates, n, extent })
    }

    /// Makes a sequence of points of this dimension from their coordinates, one point after the other.
    pub(crate) fn of_coordinates(
        dimension: usize,
        coordinates: Vec<f64>,
    ) -> Result<Self, SequenceError> {
        Self::checked(dimension, coordinates.len() / dimension, || coordinates)
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
    #[inline]
    pub fn n(&self) -> NonZeroUsize {
        self.n
    }

    /// Returns the dimension of the space.
    #[must_use]
    #[inline]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the largest coordinate in absolute value, in `ℓ`. Coordinates are rounded by at most
    /// `ε` times this number.
    #[must_use]
    pub fn extent(&self) -> f64 {
        self.extent
    }

    /// Returns the coordinates of all points, one point after the other, in `ℓ`.
    #[must_use]
    #[inline]
    pub fn coordinates(&self) -> &[f64] {
        &self.coordinates
    }

    /// Returns the coordinates of all points, one point after the other, in `ℓ`.
    #[must_use]
    pub fn into_coordinates(self) -> Vec<f64> {
        self.coordinates
    }

    /// Returns the coordinates of point `k`, in `ℓ`.
    ///
    /// # Panics
    ///
    /// If there is no such point.
    #[must_use]
    #[inline]
    pub fn row(&self, k: usize) -> &[f64] {
        &self.coordinates[k * self.dimension..][..self.dimension]
    }

    /// Returns the `N + 1` points as vectors of `E` coordinates, in `ℓ`.
    ///
    /// # Panics
    ///
    /// If `E` is not the dimension.
    #[must_use]
    #[inline]
    pub fn points_in<const E: usize>(&self) -> &[SVector<f64, E>] {
        assert!(E == self.dimension, "{E} coordinates in dimension {}", self.dimension);
        bytemuck::cast_slice(&self.coordinates)
    }

    /// Returns the same sequence as one whose dimension is a value.
    #[must_use]
    pub fn into_any(self) -> PointSequence<ANY> {
        let Self { dimension, coordinates, n, extent } = self;
        PointSequence { dimension, coordinates, n, extent }
    }

    /// Returns the `N + 1` points, in `ℓ`.
    #[must_use]
    #[inline]
    pub fn points(&self) -> &[SVector<f64, D>] {
        bytemuck::cast_slice(&self.coordinates)
    }

    /// Returns the first point.
    #[must_use]
    pub fn first(&self) -> &SVector<f64, D> {
        &self.points()[0]
    }

    /// Returns the last point.
    #[must_use]
    pub fn last(&self) -> &SVector<f64, D> {
        &self.points()[self.n.get()]
    }

    /// Returns the `N` chords, each as its first point and the vector to the next point, in `ℓ`.
    pub fn chords(&self) -> impl ExactSizeIterator<Item = (&SVector<f64, D>, SVector<f64, D>)> {
        chords(self.points())
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
        chords(&self.points()[numbers.start..=numbers.end])
    }

    /// Returns chord `n < N` as its first point and the vector to the next point, in `ℓ`.
    #[must_use]
    #[inline]
    pub fn chord(&self, n: usize) -> (&SVector<f64, D>, SVector<f64, D>) {
        (&self.points()[n], self.points()[n + 1] - self.points()[n])
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
        // The list of coordinates may have room for a part of a vector, which no list of vectors has.
        bytemuck::try_cast_vec(self.coordinates)
            .unwrap_or_else(|(_, coordinates)| bytemuck::cast_slice(&coordinates).to_vec())
    }
}

impl PointSequence<ANY> {
    /// Makes a sequence in `R^dimension` from the coordinates of its points, one point after the other.
    ///
    /// # Errors
    ///
    /// As for [`PointSequence::new`]; also [`SequenceError::NotWhole`] if the coordinates end within a point.
    pub fn from_coordinates(
        dimension: usize,
        coordinates: Vec<f64>,
    ) -> Result<Self, SequenceError> {
        let count = coordinates.len();
        if dimension == 0 || !count.is_multiple_of(dimension) {
            return Err(SequenceError::NotWhole { coordinates: count, dimension });
        }
        Self::checked(dimension, count / dimension, || coordinates)
    }

    /// Returns the same sequence as one in `R^E`, or unchanged if `E` is [`ANY`]; `None` if it lies in
    /// another dimension.
    #[must_use]
    pub fn into_dimension<const E: usize>(self) -> Option<PointSequence<E>> {
        let Self { dimension, coordinates, n, extent } = self;
        (E == ANY || dimension == E).then_some(PointSequence { dimension, coordinates, n, extent })
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

/// Returns the coordinates of some points, one point after the other.
#[must_use]
pub fn coordinates<const D: usize>(points: &[SVector<f64, D>]) -> &[f64] {
    bytemuck::cast_slice(points)
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
fn extent(coordinates: &[f64]) -> f64 {
    // Eight coordinates are processed at a time, for independent chains of operations.
    let (many, rest) = coordinates.as_chunks::<8>();
    let mut largest = [0.0_f64; 8];
    let mut undefined = largest;
    for some in many {
        for k in 0..8 {
            let size = some[k].abs();
            largest[k] = if size > largest[k] { size } else { largest[k] };
            // This product is NaN for infinity and NaN.
            undefined[k] += size * 0.0;
        }
    }
    let all = largest.iter().chain(rest).fold(0.0, |a: f64, x| a.max(x.abs()));
    undefined.iter().chain(rest).fold(all, |sum, x| sum + x * 0.0)
}

/// Returns the error for the first coordinate that is NaN or infinite.
fn not_finite(dimension: usize, coordinates: &[f64]) -> SequenceError {
    let place = coordinates.iter().position(|x| !x.is_finite()).expect("one is not finite");
    let (index, coordinate) = (place / dimension, place % dimension);
    SequenceError::NotFinite { index, coordinate, value: coordinates[place] }
}

#[cfg(test)]
mod tests;
