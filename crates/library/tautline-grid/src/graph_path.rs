//! Shortest paths along the nodes of a lattice, from which a search starts.
//!
//! A graph finds the way through a landscape with many hills, such as a measured one, where local
//! searches from bent lines end in the valleys next to them. Its paths run in a few directions only,
//! so that they are too long by some per cent; the search that follows straightens them.

use nalgebra::SVector;
use tautline_discretizations::{LARGEST_N, PointSequence, SequenceError};
use tautline_formula::Batches;
use tautline_sets::Ends;

use crate::{lattice::Lattice, lattice_graph::LatticeGraph};

/// The largest dimension with lattices: the number of nodes is a power of it.
pub(crate) const LARGEST_DIMENSION: usize = 4;

/// The largest number of nodes: the metrics of all take 0.3 GB in the plane and 1.2 GB in four
/// dimensions, and the heap of the search about as much.
pub(crate) const MOST_NODES: usize = 1 << 23;

/// Why there is no path along a lattice.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GraphPathError {
    /// The lattice is no box with a positive spacing.
    #[error(
        "coordinate {axis} of a lattice from {lower} to {upper} with the spacing {spacing}; expected \
         numbers in order, and a positive spacing"
    )]
    Box {
        /// The coordinate, from 1.
        axis: usize,
        /// Its lower end, in `ℓ`.
        lower: f64,
        /// Its upper end, in `ℓ`.
        upper: f64,
        /// The spacing, in `ℓ`.
        spacing: f64,
    },
    /// A path is divided into 1 to [`LARGEST_N`] chords.
    #[error("a path of {n} chords; expected 1 to {LARGEST_N}")]
    Chords {
        /// The number of chords.
        n: usize,
    },
    /// There are too many nodes.
    #[error("a lattice of {} nodes; at most {MOST_NODES} are possible", whole(*nodes))]
    TooManyNodes {
        /// How many there would be.
        nodes: f64,
    },
    /// A corner, a spacing or an end lies in another dimension than the metric.
    #[error("{what} has {found} coordinates in {dimension} dimensions")]
    Coordinates {
        /// What has them.
        what: &'static str,
        /// The number of coordinates.
        found: usize,
        /// The dimension.
        dimension: usize,
    },
    /// Lattices have one to four dimensions.
    #[error("a lattice in dimension {dimension}; at most {LARGEST_DIMENSION} are possible")]
    Dimension {
        /// The dimension.
        dimension: usize,
    },
    /// No node is near one of the sets.
    #[error("no node of the lattice with a metric is near the {end} set")]
    FarFromEnd {
        /// "first" or "second".
        end: &'static str,
    },
    /// Edges reach at least one step, and not too many.
    #[error("edges that reach {reach} steps along each axis; expected 1 to {largest}")]
    Reach {
        /// The number of steps.
        reach: usize,
        /// The largest one.
        largest: usize,
    },
    /// The constant of a lower bound on the lengths is too large.
    #[error("H({point:?}) has an eigenvalue below c1 = {c1}, which bounds no length from below")]
    Bound {
        /// The constant `c₁`, in `m²/ℓ²`.
        c1: f64,
        /// The point, in `ℓ`.
        point: Vec<f64>,
    },
    /// The nodes near the sets are not connected by nodes with a metric.
    #[error("no path along nodes with a metric joins the sets")]
    NotConnected,
    /// A puncture is not finite, or stands twice.
    #[error("puncture {number} at {point:?} is not finite, or stands twice")]
    Puncture {
        /// The number of the puncture, from 1.
        number: usize,
        /// The point, in `ℓ`.
        point: [f64; 2],
    },
    /// A peak is at least as high as its pass.
    #[error("a prominence of {prominence}; expected a number from 1 on")]
    Prominence {
        /// The quotient of the heights.
        prominence: f64,
    },
    /// Paths are at least as long as the shortest.
    #[error("paths of up to {slack} times the shortest; expected a number from 1 on")]
    Slack {
        /// The quotient of the lengths.
        slack: f64,
    },
    /// The path is no sequence of finite points.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
}

/// Returns a number of nodes with all of its digits, as those of the largest number of nodes are printed.
fn whole(nodes: f64) -> String {
    // A number beyond is no longer exact.
    if nodes < 2.0_f64.powi(53) { nodes.to_string() } else { format!("{nodes:e}") }
}

/// Returns a shortest path along a lattice between two sets, as a sequence of `n` chords of equal
/// length under the metric.
///
/// It is the [shortest path](LatticeGraph::shortest) of the [usual](LatticeGraph::usual) graph. Nodes
/// without a metric are left out.
///
/// # Errors
///
/// [`GraphPathError`].
pub fn graph_path<const D: usize>(
    metric: &dyn Batches<D>,
    ends: &Ends<D>,
    lattice: &Lattice<D>,
    n: usize,
) -> Result<PointSequence<D>, GraphPathError> {
    // Before the search, which may take long.
    check_chords(n)?;
    LatticeGraph::usual(metric, lattice.clone()).shortest(ends, None)?.sequence(n)
}

fn check_chords(n: usize) -> Result<(), GraphPathError> {
    if n == 0 || n > LARGEST_N { Err(GraphPathError::Chords { n }) } else { Ok(()) }
}

/// Returns `n` chords along a polygon, given as its corners, in `ℓ`, with the lengths up to them, in `m`,
/// which do not decrease. Equally much of the length is between neighbouring points, and the ends are
/// exact.
///
/// # Errors
///
/// [`GraphPathError::Chords`], and [`GraphPathError::Sequence`] if there is no corner or one is not
/// finite.
pub fn equal_chords<const D: usize>(
    corners: &[(f64, SVector<f64, D>)],
    n: usize,
) -> Result<PointSequence<D>, GraphPathError> {
    check_chords(n)?;
    let Some(&(total, last)) = corners.last() else {
        return Ok(PointSequence::new(Vec::new())?);
    };
    let mut corner = 0;
    let mut at = |k: usize| {
        if k == n || corners.len() == 1 {
            return last;
        }
        let length = total * (k as f64 / n as f64);
        while corner + 2 < corners.len() && corners[corner + 1].0 <= length {
            corner += 1;
        }
        let ((from, a), (to, b)) = (corners[corner], corners[corner + 1]);
        let t = if to > from { ((length - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        a + (b - a) * t
    };
    Ok(PointSequence::new((0..=n).map(&mut at).collect())?)
}
