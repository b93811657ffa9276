//! `Level`: cubes, and two numbers at each of their nodes.

use crate::{CheckError, Cubes, Place};

/// The data of one level: cubes and, at each node, values of two functions.
///
/// The values are proposals. They define continuous, piecewise quadratic functions `φ` and `ψ`,
/// which should be close to the distances from the first and from the second set. Nothing that is
/// proved depends on how close they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Level<const D: usize> {
    cubes: Cubes<D>,
    nodes: Vec<Place<D>>,
    values: [Vec<f64>; 2],
}

impl<const D: usize> Level<D> {
    /// Returns the level with these values at the [nodes](Cubes::nodes), in `m`. `level` is its
    /// number, for errors.
    ///
    /// # Errors
    ///
    /// [`CheckError::Values`] or [`CheckError::NotFinite`].
    pub fn new(level: usize, cubes: Cubes<D>, values: [Vec<f64>; 2]) -> Result<Self, CheckError> {
        let nodes = cubes.nodes();
        for values in &values {
            if values.len() != nodes.len() {
                let (nodes, found) = (nodes.len(), values.len());
                return Err(CheckError::Values { level, nodes, found });
            }
            if let Some((node, &value)) = values.iter().enumerate().find(|(_, v)| !v.is_finite()) {
                return Err(CheckError::NotFinite { level, node, value });
            }
        }
        Ok(Self { cubes, nodes, values })
    }

    /// Returns the cubes.
    #[must_use]
    pub fn cubes(&self) -> &Cubes<D> {
        &self.cubes
    }

    /// Returns the nodes of the cubes, on the lattice of half their side.
    #[must_use]
    pub fn nodes(&self) -> &[Place<D>] {
        &self.nodes
    }

    /// Returns the values of `φ` and of `ψ` at the nodes, in `m`.
    #[must_use]
    pub fn values(&self) -> &[Vec<f64>; 2] {
        &self.values
    }
}
