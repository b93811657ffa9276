//! `Workspace`: memory that one search leaves to the next.

use std::fmt;

use nalgebra::SVector;

use crate::factorization::Factorization;

/// Memory for searches, which grows with the largest of them and is kept for the next.
///
/// What a search on a fine grid writes down, `2D² + D` numbers a point, is written once and read
/// once or twice: on fresh memory, which the system has to find and to clear first, that takes
/// longer than to compute it.
#[derive(Clone)]
pub struct Workspace<const D: usize> {
    pub(crate) factorization: Factorization<D>,
    /// Where the points go from which a search starts.
    pub(crate) points: Vec<SVector<f64, D>>,
}

impl<const D: usize> Default for Workspace<D> {
    /// Returns a workspace without any memory yet.
    fn default() -> Self {
        Self { factorization: Factorization::with_capacity(0), points: Vec::new() }
    }
}

impl<const D: usize> fmt::Debug for Workspace<D> {
    /// For how many points there is room; what is in it means nothing.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Workspace").field("points", &self.points.capacity()).finish_non_exhaustive()
    }
}
