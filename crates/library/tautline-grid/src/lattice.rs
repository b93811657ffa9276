//! `Lattice`: equally spaced nodes in a box.

use nalgebra::SVector;

use crate::graph_path::{GraphPathError, LARGEST_DIMENSION, MOST_NODES};

/// A lattice of equally spaced nodes in a box.
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice<const D: usize> {
    lower: SVector<f64, D>,
    spacing: SVector<f64, D>,
    /// The number of nodes along each axis. The last axis varies fastest.
    counts: [usize; D],
}

impl<const D: usize> Lattice<D> {
    /// Returns the lattice of the nodes `lower + spacing·k` up to `upper`, all in `ℓ`.
    ///
    /// # Errors
    ///
    /// Those of [`with_spacings`](Lattice::with_spacings).
    pub fn new(
        lower: impl Into<SVector<f64, D>>,
        upper: impl Into<SVector<f64, D>>,
        spacing: f64,
    ) -> Result<Self, GraphPathError> {
        Self::with_spacings(lower, upper, SVector::from_element(spacing))
    }

    /// Returns the lattice of the nodes up to `upper` that has a spacing of its own along each axis, all in
    /// `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Dimension`], [`GraphPathError::Box`] if an end or a spacing is not finite, if the
    /// ends are not in order, or if a spacing is not positive, and [`GraphPathError::TooManyNodes`].
    pub fn with_spacings(
        lower: impl Into<SVector<f64, D>>,
        upper: impl Into<SVector<f64, D>>,
        spacing: impl Into<SVector<f64, D>>,
    ) -> Result<Self, GraphPathError> {
        let (lower, upper, spacing) = (lower.into(), upper.into(), spacing.into());
        if D == 0 || D > LARGEST_DIMENSION {
            return Err(GraphPathError::Dimension { dimension: D });
        }
        let mut nodes = 1.0;
        let mut counts = [0; D];
        for i in 0..D {
            let (lower, upper, spacing) = (lower[i], upper[i], spacing[i]);
            // Both ends, their difference and the quotient are rounded. This must not lose the last node.
            let rounding = 4.0 * f64::EPSILON * (lower.abs() + upper.abs()) / spacing;
            let steps = ((upper - lower) / spacing + rounding).floor();
            let is_spacing = spacing > 0.0 && spacing.is_finite();
            if !(is_spacing && lower <= upper && steps.is_finite()) {
                return Err(GraphPathError::Box { axis: i + 1, lower, upper, spacing });
            }
            nodes *= steps + 1.0;
            // A conversion to an integer saturates.
            counts[i] = (steps as usize).saturating_add(1);
        }
        // The number of all nodes, not of those along the first axes.
        if !(nodes <= MOST_NODES as f64) {
            return Err(GraphPathError::TooManyNodes { nodes });
        }
        Ok(Self { lower, spacing, counts })
    }

    /// Returns the number of nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.counts.iter().product()
    }

    /// Returns the number of nodes along each axis. The last axis varies fastest.
    #[must_use]
    pub fn counts(&self) -> [usize; D] {
        self.counts
    }

    /// Returns the first node, in `ℓ`.
    #[must_use]
    pub fn lower(&self) -> &SVector<f64, D> {
        &self.lower
    }

    /// Returns the distance between neighbouring nodes along each axis, in `ℓ`.
    #[must_use]
    pub fn spacing(&self) -> &SVector<f64, D> {
        &self.spacing
    }

    /// Returns the place of a node along each axis.
    ///
    /// The number of the node must be less than that of [all](Lattice::nodes); a larger one has the place
    /// of the remainder.
    #[must_use]
    pub fn place(&self, mut node: usize) -> [usize; D] {
        let mut place = [0; D];
        for i in (0..D).rev() {
            place[i] = node % self.counts[i];
            node /= self.counts[i];
        }
        place
    }

    /// Returns the point of a node, in `ℓ`.
    #[must_use]
    pub fn point(&self, node: usize) -> SVector<f64, D> {
        let place = self.place(node);
        SVector::from_fn(|i, _| self.lower[i] + self.spacing[i] * place[i] as f64)
    }

    /// Returns by how much the number of a node grows with a step along each axis.
    pub(crate) fn strides(&self) -> [usize; D] {
        std::array::from_fn(|i| self.counts[i + 1..].iter().product())
    }

    /// Returns the node at an offset in steps from a place, if the lattice has it.
    #[must_use]
    pub fn neighbour(&self, place: &[usize; D], offset: &[isize; D]) -> Option<usize> {
        let mut node = 0;
        for i in 0..D {
            let along = place[i].checked_add_signed(offset[i]).filter(|&k| k < self.counts[i])?;
            node = node * self.counts[i] + along;
        }
        Some(node)
    }
}
