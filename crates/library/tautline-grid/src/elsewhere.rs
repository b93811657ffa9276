//! `path_elsewhere`: a shortest path through a coarse lattice, unless it runs along a known line.

use tautline_discretizations::{ANY, PointSequence};
use tautline_formula::{AnyBatches, BatchesIn};
use tautline_sets::AnyEnds;

use crate::{Lattice, LatticeGraph};

/// The most chords of a path, and of the lines beside which it is held: no more than steps of the lattice
/// resolve.
const CHORDS: usize = 64;

/// How far the lattice reaches beyond the lines, relative to their extent.
const MARGIN: f64 = 0.3;

/// How many steps of the lattice the extent of the lines has, in the plane and in space, where more would
/// cost more than a solve.
const STEPS: [f64; 2] = [24.0, 8.0];

/// The most nodes: along each axis `(1 + 2 · 0.3) · 24 + 2` in the plane and `(1 + 2 · 0.3) · 8 + 2` in
/// space, without fractions. A lattice of lines that are a few roundings long would have millions.
const NODES: [usize; 2] = [40 * 40, 14 * 14 * 14];

/// Returns a shortest path with at most 64 chords through a coarse lattice around some lines. Returns `None`
/// if it runs along one of them, within a step of the lattice; if the sets or the lines leave no such path, or
/// the lines are only a few roundings long; and in other dimensions than two and three.
///
/// The lattice reaches beyond the lines on all sides by three tenths of their extent, and has 24 steps along it,
/// 8 in space. Whether a curve along the path is shorter than the lines is not known: a path runs in a few
/// directions only.
///
/// ```
/// use tautline_discretizations::PointSequence;
/// use tautline_formula::Prepared;
/// use tautline_grid::path_elsewhere;
/// use tautline_metrics::gallery::Bump;
/// use tautline_sets::AnyEnds;
///
/// // A steep hill between two points, and a line below it.
/// let hill = Prepared::<_, 2>::new(Bump::new(9.0, 0.5)?);
/// let ends = AnyEnds::points(&[-2.0, 0.1], &[2.0, 0.1])?;
/// let below = PointSequence::from_coordinates(2, vec![-2.0, 0.1, 0.0, -1.0, 2.0, 0.1])?;
/// let above = path_elsewhere(&hill, &ends, &[&below], 64).expect("a path above the hill");
/// assert!(above.row(32)[1] > 0.3);
/// // Where both are known, there is nothing new.
/// assert_eq!(path_elsewhere(&hill, &ends, &[&below, &above], 64), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn path_elsewhere<const D: usize>(
    metric: &dyn AnyBatches,
    ends: &AnyEnds,
    known: &[&PointSequence<D>],
    n: usize,
) -> Option<PointSequence<ANY>> {
    let known: Vec<Polygon> = known.iter().map(|line| Polygon::of(line)).collect();
    path(metric, ends, &known, n.min(CHORDS))
}

/// A line, with at most [`CHORDS`] chords, as the coordinates of its points.
struct Polygon(Vec<Vec<f64>>);

impl Polygon {
    fn of<const D: usize>(sequence: &PointSequence<D>) -> Self {
        let n = sequence.n().get();
        let chords = n.min(CHORDS);
        let place = |k: usize| (k as u128 * n as u128 / chords as u128) as usize;
        Self((0..=chords).map(|k| sequence.row(place(k)).to_vec()).collect())
    }

    /// Returns the distance of a point from it, in `ℓ`.
    fn distance(&self, x: &[f64]) -> f64 {
        let from_chord = |chord: &[Vec<f64>]| {
            let (mut along, mut square) = (0.0, 0.0);
            for ((a, b), x) in chord[0].iter().zip(&chord[1]).zip(x) {
                along += (b - a) * (x - a);
                square += (b - a) * (b - a);
            }
            let t = if square > 0.0 { (along / square).clamp(0.0, 1.0) } else { 0.0 };
            let foot = chord[0].iter().zip(&chord[1]).map(|(a, b)| a + t * (b - a));
            foot.zip(x).map(|(y, x)| (x - y) * (x - y)).sum::<f64>()
        };
        self.0.windows(2).map(from_chord).fold(f64::INFINITY, f64::min).sqrt()
    }
}

fn path(
    metric: &dyn AnyBatches,
    ends: &AnyEnds,
    known: &[Polygon],
    n: usize,
) -> Option<PointSequence<ANY>> {
    match metric.dimension() {
        2 => path_in::<2>(metric, ends, known, n),
        3 => path_in::<3>(metric, ends, known, n),
        _ => None,
    }
}

fn path_in<const D: usize>(
    metric: &dyn AnyBatches,
    ends: &AnyEnds,
    known: &[Polygon],
    n: usize,
) -> Option<PointSequence<ANY>> {
    let points = || known.iter().flat_map(|polygon| &polygon.0);
    let bound = |axis: usize, of: fn(f64, f64) -> f64| points().map(|x| x[axis]).reduce(of);
    let mut corners = [[0.0; D]; 2];
    for axis in 0..D {
        corners[0][axis] = bound(axis, f64::min)?;
        corners[1][axis] = bound(axis, f64::max)?;
    }
    let extent = (0..D).map(|axis| corners[1][axis] - corners[0][axis]).fold(0.0, f64::max);
    let margin = MARGIN * extent;
    let [lower, upper] = [corners[0].map(|x| x - margin), corners[1].map(|x| x + margin)];
    let spacing = extent / STEPS[D - 2];
    let lattice = Lattice::new(lower, upper, spacing).ok()?;
    if lattice.nodes() > NODES[D - 2] {
        return None;
    }
    let (metric, ends) = BatchesIn::<D>::new(metric).zip(ends.in_dimension::<D>())?;
    let graph = LatticeGraph::in_batches(&metric, lattice);
    let path = graph.shortest(&ends, None).ok()?.sequence(n).ok()?.into_any();
    let is_along = |polygon: &Polygon| {
        let mut points = path.coordinates().chunks_exact(D);
        points.all(|x| polygon.distance(x) <= spacing)
    };
    (!known.iter().any(is_along)).then_some(path)
}
