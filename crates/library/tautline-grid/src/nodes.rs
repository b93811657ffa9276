//! `Nodes`: a lattice, and how many ways along it are wanted, in a dimension that is a value.

use nalgebra::SVector;
use tautline_discretizations::{ANY, PointSequence};
use tautline_formula::{AnyBatches, BatchesIn};
use tautline_sets::AnyEnds;

use crate::{GraphPathError, Lattice, LatticeGraph, Punctures, class_paths, graph_path};

/// How many times as long as the shortest path the way around a peak may be.
const SLACK: f64 = 2.0;

/// The nodes of a [lattice](Lattice) in a box, and how many ways along them are wanted.
///
/// Use them for a metric with many hills, such as a measured one, with the spacing of its details and with
/// chords that are shorter than they are. Local searches from bent lines end in the valleys next to them
/// there.
#[derive(Clone, Debug, PartialEq)]
pub struct Nodes {
    /// The first node, in `ℓ`.
    pub lower: Vec<f64>,
    /// The corner at which the nodes end, in `ℓ`.
    pub upper: Vec<f64>,
    /// The distance of neighbouring nodes, in `ℓ`: one number, or one for each axis.
    pub spacing: Vec<f64>,
    /// The most homotopy classes whose shortest paths are starts: ways around the peaks and holes of the
    /// metric, shortest first. With 1, or 0, it is the shortest path of all.
    ///
    /// The peaks are the [prominent](Punctures::prominent) ones, and the [paths](class_paths) at most twice as
    /// long as the shortest. In space the sides are those in the first two coordinates, of peaks in the middle
    /// of the others. The search for paths stores up to four million pairs of a node and a class, of about 100
    /// bytes.
    pub classes: usize,
}

impl Nodes {
    /// Returns the nodes with one spacing, in `ℓ`, for the shortest path of all.
    #[must_use]
    pub fn new(lower: impl Into<Vec<f64>>, upper: impl Into<Vec<f64>>, spacing: f64) -> Self {
        let (lower, upper) = (lower.into(), upper.into());
        Self { lower, upper, spacing: vec![spacing], classes: 1 }
    }

    /// Returns the lattice in `R^D`.
    fn lattice<const D: usize>(&self) -> Result<Lattice<D>, GraphPathError> {
        let vector = |what, x: &[f64]| -> Result<SVector<f64, D>, GraphPathError> {
            let other = GraphPathError::Coordinates { what, found: x.len(), dimension: D };
            if x.len() == D { Ok(SVector::from_column_slice(x)) } else { Err(other) }
        };
        let corner = "a corner of a lattice";
        let (lower, upper) = (vector(corner, &self.lower)?, vector(corner, &self.upper)?);
        let spacing = match self.spacing[..] {
            [spacing] => SVector::from_element(spacing),
            ref each => vector("the spacing of a lattice", each)?,
        };
        Lattice::with_spacings(lower, upper, spacing)
    }

    /// Returns the starts of a search: the shortest path as `n` chords of equal length, or the shortest paths
    /// of the homotopy classes. `is_room` is told how many paths there are, before they have `n` chords;
    /// `None` if it returns false.
    ///
    /// # Errors
    ///
    /// [`GraphPathError`].
    pub fn starts(
        &self,
        metric: &dyn AnyBatches,
        ends: &AnyEnds,
        n: usize,
        is_room: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Option<Vec<PointSequence<ANY>>>, GraphPathError> {
        match metric.dimension() {
            1 => self.starts_in::<1>(metric, ends, n, is_room),
            2 => self.starts_in::<2>(metric, ends, n, is_room),
            3 => self.starts_in::<3>(metric, ends, n, is_room),
            4 => self.starts_in::<4>(metric, ends, n, is_room),
            dimension => Err(GraphPathError::Dimension { dimension }),
        }
    }

    fn starts_in<const D: usize>(
        &self,
        metric: &dyn AnyBatches,
        ends: &AnyEnds,
        n: usize,
        is_room: &mut dyn FnMut(usize) -> bool,
    ) -> Result<Option<Vec<PointSequence<ANY>>>, GraphPathError> {
        let lattice = self.lattice::<D>()?;
        let (what, found) = ("an end", ends.dimension());
        let other = || GraphPathError::Coordinates { what, found, dimension: D };
        let metric = BatchesIn::<D>::new(metric).expect("the dimension of the metric");
        let ends = ends.in_dimension().ok_or_else(other)?;
        if self.classes <= 1 {
            let path = graph_path(&metric, &ends, &lattice, n)?;
            return Ok(Some(vec![path.into_any()]));
        }
        let peaks = Punctures::prominent(&metric, &lattice)?;
        let graph = LatticeGraph::usual(&metric, lattice);
        let paths = class_paths(&graph, &ends, &peaks, self.classes, SLACK)?;
        if !is_room(paths.len()) {
            return Ok(None);
        }
        let start = |path: &crate::ClassPath<D>| Ok(path.path().sequence(n)?.into_any());
        paths.iter().map(start).collect::<Result<_, _>>().map(Some)
    }
}
