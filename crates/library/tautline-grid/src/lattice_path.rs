//! `LatticePath`: a path along the edges of a lattice between two sets.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;

use crate::{GraphPathError, equal_chords};

/// A shortest path along a lattice.
#[derive(Clone, Debug, PartialEq)]
pub struct LatticePath<const D: usize> {
    pub(crate) corners: Vec<(f64, SVector<f64, D>)>,
    pub(crate) opened: usize,
}

impl<const D: usize> LatticePath<D> {
    /// Returns the length of the path, in `m`: the sum of its edges and of the chords to the sets.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.corners.last().map_or(0.0, |last| last.0)
    }

    /// Returns the corners, in `ℓ`, each with the length up to it, in `m`. The first and the last one are
    /// points of the sets.
    #[must_use]
    pub fn corners(&self) -> &[(f64, SVector<f64, D>)] {
        &self.corners
    }

    /// Returns how often the edges of a node were looked at: a pure number, the work of the search.
    #[must_use]
    pub fn opened(&self) -> usize {
        self.opened
    }

    /// Returns `n` chords of equal length along the path.
    ///
    /// # Errors
    ///
    /// Those of [`equal_chords`].
    pub fn sequence(&self, n: usize) -> Result<PointSequence<D>, GraphPathError> {
        equal_chords(&self.corners, n)
    }
}
