//! `AnyEnds`: the two sets between which a curve runs, in a dimension that is a value.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::set_error::non_finite;
use crate::{AnySet, ClosedSet, Ends, Point, SetError, Shape};

/// The two closed sets between which a curve runs, in a space whose dimension is a value.
///
/// Invariant: that of [`Ends`]; and both sets lie in the same dimension.
#[derive(Clone, Debug)]
pub struct AnyEnds {
    pub(crate) first: Arc<dyn AnySet>,
    pub(crate) second: Arc<dyn AnySet>,
    points: bool,
}

impl AnyEnds {
    /// Returns the pair for curves that start in `first` and stop in `second`.
    ///
    /// # Errors
    ///
    /// As for [`Ends::new`]; also [`SetError::Coordinates`] if the second set lies in another dimension
    /// than the first.
    pub fn new(first: Arc<dyn AnySet>, second: Arc<dyn AnySet>) -> Result<Self, SetError> {
        let (dimension, found) = (first.dimension(), second.dimension());
        if found != dimension {
            return Err(SetError::Coordinates { what: "the second set", found, dimension });
        }
        probe("first", &first)?;
        probe("second", &second)?;
        // A radius of NaN or ∞ bounds nothing.
        let bounded = |set: &Arc<dyn AnySet>| set.radius().is_some_and(f64::is_finite);
        if !(bounded(&first) || bounded(&second)) {
            return Err(SetError::BothUnbounded);
        }
        Ok(Self { first, second, points: false })
    }

    /// Makes the pair of ends from two points with coordinates in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite, [`SetError::NoCoordinates`], and
    /// [`SetError::Coordinates`] if the points lie in different dimensions.
    pub fn points(first: &[f64], second: &[f64]) -> Result<Self, SetError> {
        let [first, second] = [Point::<ANY>::from_slice(first)?, Point::from_slice(second)?];
        Ok(Self { points: true, ..Self::new(Arc::new(first), Arc::new(second))? })
    }

    pub(crate) fn of_sets(first: Arc<dyn AnySet>, second: Arc<dyn AnySet>, points: bool) -> Self {
        Self { first, second, points }
    }

    /// Returns the dimension of the space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.first.dimension()
    }

    /// Returns the set in which curves start.
    #[must_use]
    pub fn first(&self) -> &Arc<dyn AnySet> {
        &self.first
    }

    /// Returns the set in which curves stop.
    #[must_use]
    pub fn second(&self) -> &Arc<dyn AnySet> {
        &self.second
    }

    /// Returns whether the pair was made of two points, as [`Ends::are_points`] says.
    #[must_use]
    pub fn are_points(&self) -> bool {
        self.points
    }

    /// Returns all pairs of a piece of the first set and a piece of the second, in the order of
    /// [`Ends::pairs`].
    #[must_use]
    pub fn pairs(&self) -> Vec<[Arc<dyn AnySet>; 2]> {
        let (mut firsts, mut seconds) = (Vec::new(), Vec::new());
        append_pieces(&self.first, &mut firsts);
        append_pieces(&self.second, &mut seconds);
        let beside = |first: Arc<dyn AnySet>| {
            seconds.iter().map(move |second| [Arc::clone(&first), Arc::clone(second)])
        };
        firsts.into_iter().flat_map(beside).collect()
    }

    /// Returns the same pair in `R^D`; `None` if it lies in another dimension.
    #[must_use]
    pub fn in_dimension<const D: usize>(&self) -> Option<Ends<D>> {
        (self.dimension() == D).then(|| {
            let [first, second] =
                [&self.first, &self.second].map(|set| InDimension::<D>(Arc::clone(set)));
            Ends::of_sets(Arc::new(first), Arc::new(second), self.points)
        })
    }
}

/// Appends the pieces of `set`, recursively and in order, or `set` itself if it has no pieces.
fn append_pieces(set: &Arc<dyn AnySet>, pieces: &mut Vec<Arc<dyn AnySet>>) {
    let own = set.pieces();
    if own.is_empty() {
        pieces.push(Arc::clone(set));
    }
    for piece in &own {
        append_pieces(piece, pieces);
    }
}

/// Projects a few points to `set` and to its pieces, and refuses results that are not finite.
fn probe(end: &'static str, set: &Arc<dyn AnySet>) -> Result<(), SetError> {
    let mut pieces = vec![Arc::clone(set)];
    append_pieces(set, &mut pieces);
    let dimension = set.dimension();
    let unit = |i: usize, sign: f64| {
        let mut x = vec![0.0; dimension];
        x[i] = sign;
        x
    };
    let units = (0..dimension).flat_map(|i| [1.0, -1.0].map(|sign| unit(i, sign)));
    for x in std::iter::once(vec![0.0; dimension]).chain(units) {
        for piece in &pieces {
            let mut nearest = x.clone();
            piece.project(&mut nearest);
            if let Some((index, value)) = non_finite(&nearest) {
                return Err(SetError::NoNearestPoint { end, index, value });
            }
        }
    }
    Ok(())
}

/// A set of a space whose dimension is a value, as one of `R^D`.
#[derive(Clone, Debug)]
struct InDimension<const D: usize>(Arc<dyn AnySet>);

impl<const D: usize> ClosedSet<D> for InDimension<D> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        let mut nearest = *x;
        self.0.project(nearest.as_mut_slice());
        nearest
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        let mut derivative = SMatrix::<f64, D, D>::zeros();
        self.0.projection_derivative(x.as_slice(), derivative.as_mut_slice());
        derivative
    }

    fn radius(&self) -> Option<f64> {
        self.0.radius()
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        let (centre, radius) = self.0.enclosing_ball()?;
        Some((SVector::from_column_slice(&centre), radius))
    }

    fn is_convex(&self) -> bool {
        self.0.is_convex()
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        self.0.member_near(x.as_slice()).map(|member| SVector::from_column_slice(&member))
    }

    fn shape(&self) -> Option<Shape<D>> {
        self.0.shape()?.into_dimension().ok()
    }

    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        let pieces = self.0.pieces().into_iter();
        pieces.map(|piece| Arc::new(Self(piece)) as Arc<dyn ClosedSet<D>>).collect()
    }

    fn seeds(&self) -> Vec<SVector<f64, D>> {
        self.0.seeds().iter().map(|x| SVector::from_column_slice(x)).collect()
    }
}
