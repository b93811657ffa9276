//! Shortest paths along the nodes of a lattice, from which a search starts.
//!
//! A graph finds the way through a landscape with many hills, such as a measured one, where local
//! searches from bent lines end in the valleys next to them. Its paths run in a few directions only,
//! so that they are too long by some per cent; the search that follows straightens them.

use std::{cmp::Reverse, collections::BinaryHeap};

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{LARGEST_N, PointSequence, SequenceError};
use tautline_formula::Batches;
use tautline_metrics::check_matrix;
use tautline_sets::{ClosedSet, Ends};

/// The largest dimension with lattices: the number of nodes is a power of it.
const LARGEST_DIMENSION: usize = 4;

/// The largest number of nodes: the metrics of all take 0.3 GB in the plane and 1.2 GB in four
/// dimensions, and the heap of the search about as much.
const MOST_NODES: usize = 1 << 23;

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
    #[error("a lattice of {nodes:e} nodes; at most {MOST_NODES} are possible")]
    TooManyNodes {
        /// How many there would be.
        nodes: f64,
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
    /// The nodes near the sets are not connected by nodes with a metric.
    #[error("no path along nodes with a metric joins the sets")]
    NotConnected,
    /// The path is no sequence of finite points.
    #[error(transparent)]
    Sequence(#[from] SequenceError),
}

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
            if !(spacing > 0.0 && lower <= upper && steps.is_finite()) {
                return Err(GraphPathError::Box { axis: i + 1, lower, upper, spacing });
            }
            nodes *= steps + 1.0;
            if !(nodes <= MOST_NODES as f64) {
                return Err(GraphPathError::TooManyNodes { nodes });
            }
            counts[i] = steps as usize + 1;
        }
        Ok(Self { lower, spacing, counts })
    }

    /// Returns the number of nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        self.counts.iter().product()
    }

    /// Returns the place of a node along each axis.
    fn place(&self, mut node: usize) -> [usize; D] {
        let mut place = [0; D];
        for i in (0..D).rev() {
            place[i] = node % self.counts[i];
            node /= self.counts[i];
        }
        place
    }

    fn point(&self, node: usize) -> SVector<f64, D> {
        let place = self.place(node);
        SVector::from_fn(|i, _| self.lower[i] + self.spacing[i] * place[i] as f64)
    }

    /// Returns the neighbour of a node at this offset, if the lattice has it.
    fn neighbour(&self, place: &[usize; D], offset: &[isize; D]) -> Option<usize> {
        let mut node = 0;
        for i in 0..D {
            let along = place[i].checked_add_signed(offset[i]).filter(|&k| k < self.counts[i])?;
            node = node * self.counts[i] + along;
        }
        Some(node)
    }
}

/// Returns the offsets of neighbours: all of at most two steps along each axis in the plane, of one
/// step in space, without those that are multiples of others.
fn offsets<const D: usize>() -> Vec<[isize; D]> {
    let reach: isize = if D <= 2 { 2 } else { 1 };
    let side = (2 * reach + 1) as usize;
    let of_number = |mut number: usize| {
        let mut offset = [0; D];
        for along in &mut offset {
            *along = (number % side) as isize - reach;
            number /= side;
        }
        offset
    };
    let is_primitive = |offset: &[isize; D]| {
        let largest = offset.iter().map(|along| along.abs()).max().unwrap_or(0);
        largest == 1 || (largest == 2 && offset.iter().any(|along| along.abs() == 1))
    };
    (0..side.pow(D as u32)).map(of_number).filter(is_primitive).collect()
}

/// Returns a shortest path along a lattice between two sets, as a sequence of `n` chords of equal
/// length under the metric.
///
/// The length of an edge is that of its chord under the mean of the norms at both ends. The path begins
/// and ends at the points of the sets that are nearest to nodes within one spacing of them. Nodes
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
    if n == 0 || n > LARGEST_N {
        return Err(GraphPathError::Chords { n });
    }
    let count = lattice.nodes();
    let gram_at = |x: &SVector<f64, D>| check_matrix(metric.gram(x), x).ok();
    let gram: Vec<Option<SMatrix<f64, D, D>>> =
        (0..count).map(|node| gram_at(&lattice.point(node))).collect();
    let norm = |h: &SMatrix<f64, D, D>, d: &SVector<f64, D>| {
        let square = d.dot(&(h * d));
        // A chord whose length overflows is infinitely long.
        if square >= 0.0 { square.sqrt() } else { f64::INFINITY }
    };
    // The nodes near a set, with the nearest point and the length of the chord to it.
    let near = |set: &dyn ClosedSet<D>, end| {
        let nodes = gram.iter().enumerate().filter_map(|(node, h)| {
            let x = lattice.point(node);
            let nearest = set.project(&x);
            let chord = x - nearest;
            let is_near = (0..D).all(|i| chord[i].abs() <= lattice.spacing[i]);
            let (h, other) = (h.as_ref().filter(|_| is_near)?, gram_at(&nearest)?);
            Some((node, nearest, 0.5 * (norm(h, &chord) + norm(&other, &chord))))
        });
        let nodes: Vec<_> = nodes.collect();
        if nodes.is_empty() { Err(GraphPathError::FarFromEnd { end }) } else { Ok(nodes) }
    };
    let [first, second] = [near(&**ends.first(), "first")?, near(&**ends.second(), "second")?];

    let steps: Vec<([isize; D], SVector<f64, D>)> = offsets::<D>()
        .into_iter()
        .map(|offset| (offset, SVector::from_fn(|i, _| lattice.spacing[i] * offset[i] as f64)))
        .collect();
    let (mut lengths, mut before) = (vec![f64::INFINITY; count], vec![u32::MAX; count]);
    // Lengths are not negative, so that their bits have the same order.
    let mut heap = BinaryHeap::new();
    for &(node, _, length) in &first {
        lengths[node] = length;
        heap.push(Reverse((length.to_bits(), node as u32)));
    }
    while let Some(Reverse((length, node))) = heap.pop() {
        let (length, here) = (f64::from_bits(length), node as usize);
        if length > lengths[here] {
            continue;
        }
        let Some(h) = &gram[here] else { continue };
        let place = lattice.place(here);
        for (offset, chord) in &steps {
            let Some(there) = lattice.neighbour(&place, offset) else { continue };
            let Some(other) = &gram[there] else { continue };
            let longer = length + 0.5 * (norm(h, chord) + norm(other, chord));
            if longer < lengths[there] {
                (lengths[there], before[there]) = (longer, node);
                heap.push(Reverse((longer.to_bits(), there as u32)));
            }
        }
    }

    let last = second.iter().min_by(|a, b| (lengths[a.0] + a.2).total_cmp(&(lengths[b.0] + b.2)));
    let Some((last, end, tail)) = last.filter(|last| lengths[last.0].is_finite()) else {
        return Err(GraphPathError::NotConnected);
    };
    let mut path = vec![(lengths[*last] + tail, *end), (lengths[*last], lattice.point(*last))];
    let mut node = *last;
    while before[node] != u32::MAX {
        node = before[node] as usize;
        path.push((lengths[node], lattice.point(node)));
    }
    let begin = first.iter().find(|begin| begin.0 == node);
    path.extend(begin.map(|(_, nearest, _)| (0.0, *nearest)));
    path.reverse();
    Ok(PointSequence::new(of_equal_chords(&path, n))?)
}

/// Returns `n + 1` points on a polygon, given with the length up to each corner, so that equally much of
/// the length is between neighbours. The ends are exact.
fn of_equal_chords<const D: usize>(
    path: &[(f64, SVector<f64, D>)],
    n: usize,
) -> Vec<SVector<f64, D>> {
    let total = path[path.len() - 1].0;
    let mut corner = 0;
    let mut at = |k: usize| {
        if k == n {
            return path[path.len() - 1].1;
        }
        let length = total * (k as f64 / n as f64);
        while corner + 2 < path.len() && path[corner + 1].0 <= length {
            corner += 1;
        }
        let ((from, a), (to, b)) = (path[corner], path[corner + 1]);
        let t = if to > from { ((length - from) / (to - from)).clamp(0.0, 1.0) } else { 0.0 };
        a + (b - a) * t
    };
    (0..=n).map(&mut at).collect()
}
