//! `EikonalError`: why there is no distance or no path.

use crate::GraphPathError;

/// Why there is no distance or no path on a lattice.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EikonalError {
    /// Selling's decomposition is for one to three dimensions.
    #[error("an eikonal equation in dimension {dimension}; at most 3 are possible")]
    Dimension {
        /// The dimension.
        dimension: usize,
    },
    /// There are too many nodes.
    #[error("a lattice of {nodes} nodes; at most {most} are possible")]
    TooManyNodes {
        /// The number of nodes.
        nodes: usize,
        /// The largest one.
        most: usize,
    },
    /// The metric is so anisotropic that its stencils are longer than any lattice.
    #[error(
        "H({point:?}) has the condition number {condition:e} in steps of the lattice; at most {most:e} \
         is possible"
    )]
    Anisotropy {
        /// The node, in `ℓ`.
        point: Vec<f64>,
        /// The condition number, a pure number.
        condition: f64,
        /// The largest one.
        most: f64,
    },
    /// A band of chords around a set has at least one step.
    #[error("a band of {steps} steps; expected 1 to {most}")]
    Band {
        /// The number of steps.
        steps: f64,
        /// The largest one.
        most: f64,
    },
    /// Values were given that are not one for each node.
    #[error("{found} values for {nodes} nodes")]
    Count {
        /// The number of values.
        found: usize,
        /// The number of nodes.
        nodes: usize,
    },
    /// A value was given that is no distance: `−∞`.
    #[error("the value {value} at node {node}; expected a number, infinity or NaN")]
    Value {
        /// The node, from 0.
        node: usize,
        /// The value, in `m`.
        value: f64,
    },
    /// No node is near one of the sets.
    #[error("no node of the lattice with a metric is near the {end} set")]
    FarFromEnd {
        /// "first" or "second".
        end: &'static str,
    },
    /// The front does not reach the second set: nodes without a metric separate it from the first.
    #[error("the front reached {reached} of {nodes} nodes and not the second set")]
    NotConnected {
        /// How many nodes were reached.
        reached: usize,
        /// The number of nodes.
        nodes: usize,
    },
    /// The descent from the second set found no smaller value, or took too many steps.
    #[error("the path is lost at {point:?}, at the distance {distance} from the first set")]
    PathLost {
        /// The point, in `ℓ`.
        point: Vec<f64>,
        /// The distance, in `m`.
        distance: f64,
    },
    /// The lattice, or the number of chords along the path, is not valid.
    #[error(transparent)]
    Lattice(#[from] GraphPathError),
}
