//! The peaks of a metric on a lattice: where curves pass on either side.

use nalgebra::SVector;
use tautline_formula::Batches;

use crate::{GraphPathError, Lattice, Punctures, lattice_graph::gram_at};

/// What counts as a prominent peak, and the most of them. Among more, the shortest paths of most classes
/// differ only in the sides on which they pass small ones.
const PROMINENCE: f64 = 1.05;
const MOST_PEAKS: usize = 64;

impl Punctures {
    /// Returns the [peaks](Punctures::peaks) of a metric with a prominence of 1.05 or more: the 64 most
    /// prominent ones, if there are more.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Puncture`] if a node overflows.
    pub fn prominent<const D: usize>(
        metric: &dyn Batches<D>,
        lattice: &Lattice<D>,
    ) -> Result<Self, GraphPathError> {
        Ok(Self::peaks(metric, lattice, PROMINENCE)?.first(MOST_PEAKS))
    }

    /// Returns the peaks of a metric: the middles of its holes, where there is no metric, and the nodes
    /// where its scale `(det H)^{1/2D}` is highest, if that is more than the scale at the highest pass to a
    /// higher peak or to the boundary of the lattice, and at least `prominence` times as much. The most
    /// prominent come first.
    ///
    /// This is the persistent homology of the scale (H. Edelsbrunner and J. Harer, *Computational
    /// Topology*, 2010): the level falls, islands rise and grow, and where two merge, the lower peak ends.
    /// All around the lattice is the highest land, since no curve goes around it. In more than two
    /// dimensions the scale is that in the middle of the further coordinates.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Prominence`] unless `prominence` is at least 1, and [`GraphPathError::Puncture`] if
    /// a node overflows.
    pub fn peaks<const D: usize>(
        metric: &dyn Batches<D>,
        lattice: &Lattice<D>,
        prominence: f64,
    ) -> Result<Self, GraphPathError> {
        if !(prominence >= 1.0) {
            return Err(GraphPathError::Prominence { prominence });
        }
        if D < 2 {
            return Self::new(Vec::new());
        }
        let counts = [lattice.counts()[0], lattice.counts()[1]];
        let point = |node: usize| {
            let place = [node / counts[1], node % counts[1]];
            SVector::<f64, D>::from_fn(|i, _| {
                let steps = place.get(i).copied().unwrap_or(lattice.counts()[i] / 2);
                lattice.lower()[i] + lattice.spacing()[i] * steps as f64
            })
        };
        let scale = |node: usize| {
            let factor = gram_at(metric, &point(node)).and_then(|h| h.cholesky());
            // (det H)^{1/2} is the product of the diagonal of a factor.
            let volume = factor.map(|factor| factor.l_dirty().diagonal().product());
            volume.map_or(f64::INFINITY, |volume: f64| volume.powf((D as f64).recip()))
        };
        let heights: Vec<f64> = (0..counts[0] * counts[1]).map(scale).collect();
        let mut order: Vec<usize> = (0..heights.len()).collect();
        order.sort_by(|&a, &b| heights[b].total_cmp(&heights[a]));
        let mut islands = Islands::new(heights.len());
        // The prominence of each peak, and its node.
        let mut peaks: Vec<(f64, usize)> = Vec::new();
        for node in order {
            islands.rise(node);
            for other in beside(node, counts) {
                let Some(peak) = islands.merge(node, other, &heights) else { continue };
                let quotient = heights[peak] / heights[node];
                // That of two nodes without a metric is NaN.
                if quotient > 1.0 && quotient >= prominence {
                    peaks.push((quotient, peak));
                }
            }
        }
        peaks.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let middle = |&(_, peak): &(f64, usize)| {
            let is_hole = heights[peak] == f64::INFINITY;
            let node = if is_hole { middle(&heights, peak, counts) } else { peak };
            [point(node)[0], point(node)[1]]
        };
        Self::new(peaks.iter().map(middle).collect())
    }
}

/// Returns the eight nodes beside a node, in which all beyond the boundary are one: that after the last.
fn beside(node: usize, counts: [usize; 2]) -> impl Iterator<Item = usize> {
    let (row, column) = (node / counts[1], node % counts[1]);
    let offsets = (0..9).filter(|&k| k != 4).map(|k| (k / 3, k % 3));
    offsets.map(move |(i, j)| {
        // Steps of −1 wrap around, so that they are beyond the boundary as well.
        let (row, column) = ((row + i).wrapping_sub(1), (column + j).wrapping_sub(1));
        let is_inside = row < counts[0] && column < counts[1];
        if is_inside { row * counts[1] + column } else { counts[0] * counts[1] }
    })
}

/// Returns the node of a hole that is nearest to the mean of its nodes.
fn middle(heights: &[f64], start: usize, counts: [usize; 2]) -> usize {
    let (mut hole, mut seen) = (vec![start], vec![false; heights.len()]);
    seen[start] = true;
    let mut next = 0;
    while let Some(&node) = hole.get(next) {
        next += 1;
        for other in beside(node, counts) {
            if other < heights.len() && heights[other] == f64::INFINITY && !seen[other] {
                seen[other] = true;
                hole.push(other);
            }
        }
    }
    let place = |node: usize| [(node / counts[1]) as f64, (node % counts[1]) as f64];
    let mean = [0, 1].map(|i| hole.iter().map(|&n| place(n)[i]).sum::<f64>() / hole.len() as f64);
    let away = |&node: &usize| {
        let [row, column] = place(node);
        (row - mean[0]).powi(2) + (column - mean[1]).powi(2)
    };
    hole.sort_unstable();
    hole.into_iter().min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(start)
}

/// The islands above a falling level, as a forest of their nodes, with the peak of each at its root. The
/// node after the last is the land around the lattice.
struct Islands {
    parent: Vec<usize>,
    peak: Vec<usize>,
}

/// The parent of a node below the level.
const UNDER: usize = usize::MAX;

impl Islands {
    fn new(nodes: usize) -> Self {
        let mut parent = vec![UNDER; nodes + 1];
        parent[nodes] = nodes;
        Self { parent, peak: (0..=nodes).collect() }
    }

    /// The level falls to a node.
    fn rise(&mut self, node: usize) {
        self.parent[node] = node;
    }

    /// Returns the root of the island of a node, and shortens the way to it.
    fn root(&mut self, mut node: usize) -> usize {
        while self.parent[node] != node {
            self.parent[node] = self.parent[self.parent[node]];
            node = self.parent[node];
        }
        node
    }

    /// Merges the islands of two nodes. Returns the lower one of their peaks, if there were two.
    fn merge(&mut self, a: usize, b: usize, heights: &[f64]) -> Option<usize> {
        if self.parent[b] == UNDER {
            return None;
        }
        let [a, b] = [a, b].map(|node| self.root(node));
        if a == b {
            return None;
        }
        let [first, second] = [self.peak[a], self.peak[b]];
        // The land around has no height, and is above all.
        let height = |peak: usize| heights.get(peak).copied().unwrap_or(f64::INFINITY);
        let is_around = |peak: usize| peak == heights.len();
        let first_is_lower =
            !is_around(first) && (is_around(second) || height(first) < height(second));
        let [higher, lower] = if first_is_lower { [second, first] } else { [first, second] };
        self.parent[a] = b;
        self.peak[b] = higher;
        Some(lower)
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_formula::Plain;
    use tautline_metrics::{
        Metric, Scalar,
        gallery::{Obstacle, SoftObstacles},
    };

    use crate::{GraphPathError, Lattice, Punctures};

    fn lattice() -> Lattice<2> {
        Lattice::new([-2.0, -1.5], [2.0, 1.5], 0.1).expect("a box")
    }

    fn hills<const D: usize>(hills: &[([f64; 2], f64)]) -> SoftObstacles<D> {
        let centre = |x: [f64; 2]| SVector::from_fn(|i, _| x.get(i).copied().unwrap_or(0.0));
        let hill =
            |&(x, height): &([f64; 2], f64)| Obstacle { centre: centre(x), height, width: 0.3 };
        SoftObstacles::new(hills.iter().map(hill).collect()).expect("hills")
    }

    /// The most prominent first; a hill beyond the boundary is none.
    #[test]
    fn hills_are_peaks() {
        let metric = hills::<2>(&[([-1.0, 0.5], 3.0), ([0.5, -0.4], 8.0), ([1.2, 2.0], 5.0)]);
        let peaks = Punctures::peaks(&Plain::new(&metric), &lattice(), 1.1).expect("a prominence");
        let [first, second] = peaks.points() else { panic!("{peaks:?}") };
        for (found, exact) in [(first, [0.5, -0.4]), (second, [-1.0, 0.5])] {
            // The other hill moves a peak by less than a step.
            assert!((0..2).all(|i| (found[i] - exact[i]).abs() < 0.1), "{found:?}");
        }
    }

    /// A hill of height 15 three widths from a higher one ends at a pass of the height 11, so that its
    /// scale is 1.14 times that of the pass. The scale of a lone hill of height 6 is `√7` times that of the
    /// boundary.
    #[test]
    fn a_lone_hill_comes_before_the_shoulder_of_a_higher_one() {
        let metric = hills::<2>(&[([-1.0, 0.0], 20.0), ([-0.1, 0.0], 15.0), ([1.0, 0.0], 6.0)]);
        let peaks = Punctures::peaks(&Plain::new(&metric), &lattice(), 1.1).expect("a prominence");
        let across = peaks.points().iter().map(|peak| peak[0]);
        let off = across.zip([-1.0, 1.0, -0.1]).map(|(found, exact)| (found - exact).abs());
        assert!(peaks.points().len() == 3 && off.fold(0.0, f64::max) < 0.15, "{peaks:?}");
    }

    /// The middle of two hills of height `a` that are three widths apart has the height
    /// `1 + 2a e^{−9/8}`, and each hill `1 + a (1 + e^{−9/2})`. With `a = 1` the scales, the roots of
    /// these, have the quotient 1.10. In space it is that half way up, where the hills are.
    #[test]
    fn a_hill_ends_at_its_pass() {
        let two = [([-0.45, 0.0], 1.0), ([0.45, 0.0], 1.0)];
        let (plane, space) = (hills::<2>(&two), hills::<3>(&two));
        let box_of_hills = Lattice::new([-2.0, -1.5, -1.0], [2.0, 1.5, 1.0], 0.1).expect("a box");
        let pass = 1.0 + 2.0 * (-1.125_f64).exp();
        let quotient = ((2.0 + (-4.5_f64).exp()) / pass).sqrt();
        // No node is the very peak; one is within 0.07 of it, where the hill falls by 3 % or less.
        for (prominence, expected) in [(quotient - 0.03, 2), (quotient + 0.01, 1)] {
            let in_the_plane = Punctures::peaks(&Plain::new(&plane), &lattice(), prominence);
            let in_space = Punctures::peaks(&Plain::new(&space), &box_of_hills, prominence);
            for peaks in [in_the_plane, in_space] {
                let peaks = peaks.expect("a prominence");
                assert_eq!(peaks.points().len(), expected, "{prominence}");
            }
        }
    }

    /// The plane without a disc, and without a half-plane.
    struct Holes;

    impl Metric<2> for Holes {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let outside = ((x[0] - 0.3).sqr() + (x[1] - 0.2).sqr() - 0.25).sqrt();
            let below = (x[1] * -1.0 + 1.2).sqrt();
            SMatrix::from_diagonal_element((outside + below) * 0.0 + 1.0)
        }
    }

    #[test]
    fn a_hole_is_a_peak_in_its_middle_unless_it_reaches_the_boundary() {
        let peaks = Punctures::peaks(&Plain::new(&Holes), &lattice(), 1.1).expect("a prominence");
        let [middle] = peaks.points() else { panic!("{peaks:?}") };
        // The mean of the nodes in the disc is its centre, which is a node.
        assert!((vector![middle[0], middle[1]] - vector![0.3, 0.2]).norm() < 1e-9, "{middle:?}");
    }

    /// Each node is as high as its pass to the boundary, and no higher.
    #[test]
    fn flat_land_has_no_peaks() {
        let peaks = Punctures::peaks(&Plain::new(&hills::<2>(&[])), &lattice(), 1.0);
        assert!(peaks.expect("a prominence").points().is_empty());
    }

    #[test]
    fn a_prominence_is_at_least_one() {
        for prominence in [0.9, f64::NAN] {
            let error = Punctures::peaks(&Plain::new(&Holes), &lattice(), prominence);
            assert!(matches!(error, Err(GraphPathError::Prominence { .. })));
        }
    }
}
