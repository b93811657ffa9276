//! `Units`: the same problem in other units.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline::{
    Bounded, ClosedSet, Constants, Ends, Interval, KnownDistance, Metric, PointSequence, Scalar,
};

use crate::{Known, VerifyError};

/// A change of units: a coordinate 1 becomes `ell`, and a length 1 becomes `m`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The factor that multiplies coordinates.
    pub ell: f64,
    /// The factor that multiplies Riemannian lengths.
    pub m: f64,
}

impl Units {
    /// No change.
    pub const ONE: Units = Units { ell: 1.0, m: 1.0 };

    /// Returns a metric in these units.
    pub fn metric<M>(self, metric: M) -> InUnits<M> {
        InUnits { metric, units: self }
    }

    /// Returns a vector of coordinates in these units.
    #[must_use]
    pub fn vector<const D: usize>(self, x: SVector<f64, D>) -> SVector<f64, D> {
        x * self.ell
    }

    /// Returns a point sequence in these units.
    ///
    /// # Errors
    ///
    /// If a coordinate overflows.
    pub fn sequence<const D: usize>(
        self,
        sequence: &PointSequence<D>,
    ) -> Result<PointSequence<D>, VerifyError> {
        let points = sequence.points().iter().map(|x| x * self.ell).collect();
        Ok(PointSequence::new(points)?)
    }

    /// Returns constants in these units.
    ///
    /// # Errors
    ///
    /// If a constant overflows or underflows.
    pub fn constants(self, constants: Constants) -> Result<Constants, VerifyError> {
        let gram = (self.m / self.ell).powi(2);
        Ok(constants.times([gram, gram, gram / self.ell, gram / self.ell / self.ell])?)
    }

    /// Returns a problem in these units.
    ///
    /// # Errors
    ///
    /// If a coordinate of a set overflows.
    pub fn known<M: Bounded<D>, const D: usize>(
        self,
        known: Known<M, D>,
    ) -> Result<Known<InUnits<M>, D>, VerifyError> {
        let set = |set: &Arc<dyn ClosedSet<D>>| SetInUnits::new(Arc::clone(set), self.ell);
        let [first, second] = [known.ends.first(), known.ends.second()].map(set);
        Ok(Known {
            metric: self.metric(known.metric),
            ends: Ends::new(first, second)?,
            distance: known.distance * self.m,
            distance_error: known.distance_error * self.m,
        })
    }
}

/// A metric in other units: `H′(x) = (m/ℓ)² H(x/ℓ)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InUnits<M> {
    metric: M,
    units: Units,
}

impl<M> InUnits<M> {
    /// Returns the metric in its own units.
    pub fn metric(&self) -> &M {
        &self.metric
    }

    /// Returns the units.
    pub fn units(&self) -> Units {
        self.units
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for InUnits<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let Units { ell, m } = self.units;
        self.metric.gram(&x.map(|xi| xi * ell.recip())).map(|entry| entry * (m / ell).powi(2))
    }
}

impl<M: Bounded<D>, const D: usize> Bounded<D> for InUnits<M> {
    /// The constants of the metric, in these units.
    fn constants(&self) -> Constants {
        self.units.constants(self.metric.constants()).expect("in the range of f64")
    }
}

impl<M: KnownDistance<D>, const D: usize> KnownDistance<D> for InUnits<M> {
    /// The distance of the metric, in these units.
    fn distance(&self, x: &SVector<f64, D>, y: &SVector<f64, D>) -> Option<f64> {
        let Units { ell, m } = self.units;
        Some(self.metric.distance(&(x / ell), &(y / ell))? * m)
    }
}

/// A set in another unit of coordinates.
#[derive(Clone, Debug)]
struct SetInUnits<const D: usize> {
    set: Arc<dyn ClosedSet<D>>,
    pieces: Vec<Arc<dyn ClosedSet<D>>>,
    ell: f64,
}

impl<const D: usize> SetInUnits<D> {
    fn new(set: Arc<dyn ClosedSet<D>>, ell: f64) -> Self {
        let piece = |piece: &Arc<dyn ClosedSet<D>>| -> Arc<dyn ClosedSet<D>> {
            Arc::new(Self::new(Arc::clone(piece), ell))
        };
        let pieces = set.pieces().iter().map(piece).collect();
        Self { set, pieces, ell }
    }
}

impl<const D: usize> ClosedSet<D> for SetInUnits<D> {
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        self.set.project(&(x / self.ell)) * self.ell
    }

    fn projection_derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        self.set.projection_derivative(&(x / self.ell))
    }

    fn radius(&self) -> Option<f64> {
        self.set.radius().map(|radius| radius * self.ell)
    }

    fn enclosing_ball(&self) -> Option<(SVector<f64, D>, f64)> {
        self.set.enclosing_ball().map(|(centre, radius)| (centre * self.ell, radius * self.ell))
    }

    fn is_convex(&self) -> bool {
        self.set.is_convex()
    }

    fn pieces(&self) -> Vec<Arc<dyn ClosedSet<D>>> {
        self.pieces.clone()
    }

    fn seeds(&self) -> Vec<SVector<f64, D>> {
        self.set.seeds().into_iter().map(|seed| seed * self.ell).collect()
    }

    fn member_near(&self, x: &SVector<f64, D>) -> Option<SVector<Interval, D>> {
        // The product is rounded outward unless ℓ is a power of two.
        let ell = Interval::point(self.ell);
        Some(self.set.member_near(&(x / self.ell))?.map(|side| side * ell))
    }
}
