//! `path_round`: a shortest path through a coarse lattice round regions without a metric.

use tautline_discretizations::{ANY, PointSequence};
use tautline_formula::{AnyBatches, BatchesIn};
use tautline_sets::AnyEnds;

use crate::{Lattice, LatticeGraph};

/// How far the lattice reaches beyond the ends, relative to their extent: first, and if no way is there.
const MARGINS: [f64; 2] = [1.0, 4.0];

/// How many steps of the lattice the extent of the ends has, in the plane and in space, where the lattice of
/// the larger margin would otherwise cost seconds.
const STEPS: [f64; 2] = [24.0, 6.0];

/// How many times the path looks for the metric along the extent of the ends.
const LOOKS: f64 = 2048.0;

/// The number of alternating projections that search for near points of the sets.
const PROJECTIONS: usize = 50;

/// Returns the shortest path of `n` chords through a coarse lattice around two sets along which there is a
/// metric, as far as points show that are 1/2048 of the distance of the sets apart. So it leaps over no wall
/// that is thicker. Returns `None` if there is no such path, if the sets touch, and in other dimensions than two
/// and three.
///
/// The lattice reaches beyond near points of the sets on all sides by their distance, or by four times as
/// much if there is no path. It has 24 steps along the distance, 6 in space.
///
/// ```
/// use tautline_formula::{Formula, Prepared};
/// use tautline_grid::path_round;
/// use tautline_sets::AnyEnds;
///
/// // A wall that is much thinner than the steps of the lattice ends at a height of 2.
/// let wall = "(1 + exp(-2*ln(1e4*((x1/0.002)^2 + exp(20*(x2 - 2)) - 1)))) I";
/// let wall = Prepared::new(Formula::<2>::parse(wall, &[]).unwrap());
/// let ends = AnyEnds::points(&[-2.0, 0.0], &[2.0, 0.0])?;
/// let path = path_round(&wall, &ends, 64).ok_or("no path")?;
/// let heights = path.coordinates().chunks(2).map(|x| x[1]);
/// assert!(heights.fold(0.0, f64::max) > 1.9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn path_round(metric: &dyn AnyBatches, ends: &AnyEnds, n: usize) -> Option<PointSequence<ANY>> {
    match metric.dimension() {
        2 => path_in::<2>(metric, ends, n),
        3 => path_in::<3>(metric, ends, n),
        _ => None,
    }
}

fn path_in<const D: usize>(
    metric: &dyn AnyBatches,
    ends: &AnyEnds,
    n: usize,
) -> Option<PointSequence<ANY>> {
    let (metric, typed) = BatchesIn::<D>::new(metric).zip(ends.in_dimension::<D>())?;
    let [a, b] = near_points::<D>(ends);
    let extent = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    MARGINS.iter().find_map(|margin| {
        let reach = margin * extent;
        let corner = |i: usize, sign: f64| match sign < 0.0 {
            true => a[i].min(b[i]) - reach,
            false => a[i].max(b[i]) + reach,
        };
        let [lower, upper] =
            [-1.0, 1.0].map(|sign| std::array::from_fn::<_, D, _>(|i| corner(i, sign)));
        let lattice = Lattice::new(lower, upper, extent / STEPS[D - 2]).ok()?;
        let graph = LatticeGraph::in_batches(&metric, lattice).looking(extent / LOOKS);
        Some(graph.shortest(&typed, None).ok()?.sequence(n).ok()?.into_any())
    })
}

/// Returns points of the two sets that are near to each other.
fn near_points<const D: usize>(ends: &AnyEnds) -> [[f64; D]; 2] {
    let [mut a, mut b] = [[0.0; D]; 2];
    for _ in 0..PROJECTIONS {
        ends.first().project(&mut a);
        b = a;
        ends.second().project(&mut b);
        a = b;
    }
    ends.first().project(&mut a);
    [a, b]
}
