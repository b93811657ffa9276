//! `LatticeGraph`: the edges between the nodes of a lattice, and shortest paths along them.

use std::{cmp::Reverse, collections::BinaryHeap};

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Batch, Batches, Kind};
use tautline_metrics::{Constants, check_matrix};
use tautline_sets::{ClosedSet, Ends};

use crate::{GraphPathError, Lattice, LatticePath};

/// The largest reach: in four dimensions it has some 80 000 offsets.
const LARGEST_REACH: usize = 8;

/// The most nodes of a batch: a call of a black box costs as much as some dozen points.
const BATCH: usize = 256;

/// By how much two sums of the same edges can differ, relative to them: an estimate is lowered by it
/// before a node is left unopened. A length is a sum of at most 2²³ edges, each rounded by 2⁻⁵³ of the
/// sum, so that it is off by less than 10⁻⁹ of itself.
pub(crate) const ROUNDING: f64 = 1e-9;

/// A lattice whose nodes are joined by edges under a metric.
///
/// The edges of a node lead to the nodes at all primitive offsets, those that are no multiples of
/// others, of at most `r` steps along each axis. The length of an edge is that of its chord, by the
/// trapezoidal rule for the norms along it: at both ends and, for a longer edge, at each plane of nodes
/// between them, the mean of the norms at the nodes next to it there; for the diagonal of a cell, at the middle,
/// the mean of those at the corners. So no edge leaps over a wall that is one node wide, also where two nodes
/// of it touch at a corner. Nodes without a metric have no edges, nor do edges pass next to them.
#[derive(Clone)]
pub struct LatticeGraph<'m, const D: usize> {
    metric: &'m dyn Batches<D>,
    lattice: Lattice<D>,
    gram: Vec<Option<SMatrix<f64, D, D>>>,
    steps: Vec<Step<D>>,
    /// How far apart a shortest path looks for the metric along its edges, in `ℓ`.
    looks: Option<f64>,
}

/// An edge from a node.
#[derive(Clone, Debug)]
struct Step<const D: usize> {
    offset: [isize; D],
    /// The chord, in `ℓ`.
    chord: SVector<f64, D>,
    /// The number of intervals of the trapezoidal rule.
    intervals: usize,
    /// The nodes next to the edge between its ends, by how much their numbers exceed the number of the first
    /// end, with the share of each in the mean at its plane.
    between: Vec<(isize, f64)>,
}

impl<const D: usize> Step<D> {
    fn new(offset: [isize; D], lattice: &Lattice<D>) -> Self {
        let chord = SVector::from_fn(|i, _| lattice.spacing()[i] * offset[i] as f64);
        // A diagonal has the middle of its cell, so that it does not pass between walls that touch there.
        let is_diagonal = offset.iter().filter(|&&along| along != 0).count() > 1;
        let steps = offset.iter().map(|along| along.unsigned_abs()).max().unwrap_or(1);
        let intervals = if steps == 1 && is_diagonal { 2 } else { steps };
        let strides = lattice.strides();
        let mut between = Vec::new();
        for k in 1..intervals as isize {
            // Along each axis the node below, and the part of a step beyond it.
            let places = offset.map(|along| {
                let (whole, m) = (along * k, intervals as isize);
                (whole.div_euclid(m), whole.rem_euclid(m) as f64 / intervals as f64)
            });
            for corner in 0..1_usize << D {
                let (mut node, mut share) = (0, 1.0);
                for (i, (below, part)) in places.iter().enumerate() {
                    let is_above = corner >> i & 1 == 1;
                    node += (below + isize::from(is_above)) * strides[i] as isize;
                    share *= if is_above { *part } else { 1.0 - part };
                }
                if share > 0.0 {
                    between.push((node, share));
                }
            }
        }
        Self { offset, chord, intervals, between }
    }
}

/// A node near a set, the point of the set that is nearest to it, and the length of the chord between.
type Gate<const D: usize> = (usize, SVector<f64, D>, f64);

impl<const D: usize> std::fmt::Debug for LatticeGraph<'_, D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("LatticeGraph")
            .field("lattice", &self.lattice)
            .field("offsets", &self.steps.len())
            .finish_non_exhaustive()
    }
}

impl<'m, const D: usize> LatticeGraph<'m, D> {
    /// Returns the graph of a lattice whose edges reach `reach` steps along each axis, from 1 to 8.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Reach`].
    pub fn new(
        metric: &'m dyn Batches<D>,
        lattice: Lattice<D>,
        reach: usize,
    ) -> Result<Self, GraphPathError> {
        if !(1..=LARGEST_REACH).contains(&reach) {
            return Err(GraphPathError::Reach { reach, largest: LARGEST_REACH });
        }
        Ok(Self::with_reach(metric, lattice, reach))
    }

    fn with_reach(metric: &'m dyn Batches<D>, lattice: Lattice<D>, reach: usize) -> Self {
        let of_node = |node| gram_at(metric, &lattice.point(node));
        let gram = (0..lattice.nodes()).map(of_node).collect();
        Self::with_gram(metric, lattice, reach, gram)
    }

    /// Returns the [usual](Self::usual) graph, in which `H` at the nodes is computed from norms in batches,
    /// by `2 Hᵢⱼ = |eᵢ + eⱼ|² − |eᵢ|² − |eⱼ|²`. It is the same up to rounding.
    pub(crate) fn in_batches(metric: &'m dyn Batches<D>, lattice: Lattice<D>) -> Self {
        let unit = |i: usize| SVector::<f64, D>::from_fn(|k, _| if k == i { 1.0 } else { 0.0 });
        let pairs: Vec<[usize; 2]> = (0..D).flat_map(|j| (0..=j).map(move |i| [i, j])).collect();
        let vectors: Vec<SVector<f64, D>> =
            pairs.iter().map(|&[i, j]| if i == j { unit(i) } else { unit(i) + unit(j) }).collect();
        let mut batch = Batch::new(metric, Kind::Square, pairs.len(), BATCH);
        let square = batch.layout().square[0];
        let nodes: Vec<usize> = (0..lattice.nodes()).collect();
        let mut gram = Vec::with_capacity(nodes.len());
        for nodes in nodes.chunks(batch.lanes() / pairs.len()) {
            let count = nodes.len() * pairs.len();
            let mut inputs = batch.inputs::<D>(count);
            for (place, &node) in nodes.iter().enumerate() {
                for (pair, vector) in vectors.iter().enumerate() {
                    inputs.set(place * pairs.len() + pair, &lattice.point(node), vector);
                }
            }
            batch.evaluate(count);
            let squares = batch.row(square)[..count].chunks_exact(pairs.len());
            gram.extend(nodes.iter().zip(squares).map(|(&node, squares)| {
                let mut h = SMatrix::<f64, D, D>::zeros();
                for (&[i, j], square) in pairs.iter().zip(squares) {
                    h[(i, j)] = *square;
                }
                let of = |i: usize, j: usize| h[(i.min(j), i.max(j))];
                let entry = |i: usize, j: usize| match i == j {
                    true => of(i, i),
                    false => 0.5 * (of(i, j) - of(i, i) - of(j, j)),
                };
                check_matrix(SMatrix::from_fn(entry), &lattice.point(node)).ok()
            }));
        }
        Self::with_gram(metric, lattice, usual_reach(D), gram)
    }

    fn with_gram(
        metric: &'m dyn Batches<D>,
        lattice: Lattice<D>,
        reach: usize,
        gram: Vec<Option<SMatrix<f64, D, D>>>,
    ) -> Self {
        let steps = offsets(reach as isize);
        let steps = steps.into_iter().map(|offset| Step::new(offset, &lattice)).collect();
        Self { metric, lattice, gram, steps, looks: None }
    }

    /// Returns the graph whose [shortest](Self::shortest) path is one along which there is a metric at points
    /// of this distance, in `ℓ`: it leaps over no wall that is thicker, however far apart the nodes are.
    #[must_use]
    pub fn looking(self, distance: f64) -> Self {
        Self { looks: Some(distance), ..self }
    }

    /// Returns whether a chord has a length at points of this distance.
    fn is_free(
        looks: &mut Option<(f64, Batch<'_>)>,
        from: &SVector<f64, D>,
        to: &SVector<f64, D>,
    ) -> bool {
        let Some((distance, batch)) = looks else { return true };
        let chord = to - from;
        let pieces = (chord.norm() / *distance).ceil() as usize;
        let places: Vec<f64> = (1..pieces).map(|k| k as f64 / pieces as f64).collect();
        let square = batch.layout().square[0];
        places.chunks(batch.lanes()).all(|places| {
            let mut inputs = batch.inputs::<D>(places.len());
            for (lane, place) in places.iter().enumerate() {
                inputs.set(lane, &(from + chord * *place), &chord);
            }
            batch.evaluate(places.len());
            // NaN and infinity are no norms.
            let squares = &batch.row(square)[..places.len()];
            squares.iter().all(|square| *square > 0.0 && square.is_finite())
        })
    }

    /// Returns the graph whose edges reach two steps along each axis in the plane, and one step in space.
    #[must_use]
    pub fn usual(metric: &'m dyn Batches<D>, lattice: Lattice<D>) -> Self {
        Self::with_reach(metric, lattice, usual_reach(D))
    }

    /// Returns the lattice.
    #[must_use]
    pub fn lattice(&self) -> &Lattice<D> {
        &self.lattice
    }

    /// Returns the edges of a node: the other node, and the length in `m`, which may be infinite.
    pub fn edges(&self, node: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let neighbours = self.neighbours(node);
        neighbours.filter_map(move |(there, step)| Some((there, self.edge(node, there, step)?)))
    }

    /// Returns the nodes at the offsets of a node, with the steps to them.
    fn neighbours(&self, node: usize) -> impl Iterator<Item = (usize, &Step<D>)> {
        let place = self.lattice.place(node);
        let steps = self.steps.iter();
        steps.filter_map(move |step| Some((self.lattice.neighbour(&place, &step.offset)?, step)))
    }

    /// Returns the length of the edge between two nodes, in `m`; `None` if one of them, or a node next to the
    /// edge, has no metric.
    fn edge(&self, node: usize, there: usize, step: &Step<D>) -> Option<f64> {
        let norm_at = |node: usize| Some(norm(self.gram.get(node)?.as_ref()?, &step.chord));
        let ends = 0.5 * (norm_at(node)? + norm_at(there)?);
        if step.intervals == 1 {
            return Some(ends);
        }
        let mut sum = ends;
        for &(beyond, share) in &step.between {
            sum += share * norm_at(node.checked_add_signed(beyond)?)?;
        }
        Some(sum / step.intervals as f64)
    }

    /// Returns the nodes with a metric within one spacing of a set along each axis, with the nearest points
    /// of the set, in `ℓ`, and the lengths of the chords to them, in `m`.
    pub fn gates(&self, set: &dyn ClosedSet<D>) -> Vec<Gate<D>> {
        let gate = |(node, h): (usize, &Option<SMatrix<f64, D, D>>)| {
            let x = self.lattice.point(node);
            let nearest = set.project(&x);
            let chord = x - nearest;
            let is_near = (0..D).all(|i| chord[i].abs() <= self.lattice.spacing()[i]);
            let (h, other) = (h.as_ref().filter(|_| is_near)?, gram_at(self.metric, &nearest)?);
            Some((node, nearest, 0.5 * (norm(h, &chord) + norm(&other, &chord))))
        };
        self.gram.iter().enumerate().filter_map(gate).collect()
    }

    /// Returns a shortest path between two sets. It begins and ends at the points of the sets that are
    /// nearest to nodes within one spacing of them.
    ///
    /// Without `constants` the nodes are opened in the order of their lengths (E. W. Dijkstra, *A note on
    /// two problems in connexion with graphs*, Numer. Math. 1, 1959). With them it is the order of their
    /// lengths plus `√c₁` times their Euclidean distance from the second set, a lower bound on the rest
    /// (P. E. Hart, N. J. Nilsson and B. Raphael, *A formal basis for the heuristic determination of
    /// minimum cost paths*, IEEE Trans. Syst. Sci. Cybern. 4, 1968). The length is the same bit by bit,
    /// and fewer nodes are opened.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::FarFromEnd`], [`GraphPathError::NotConnected`], and [`GraphPathError::Bound`] if
    /// `c₁` is no bound at a node or at a nearest point.
    pub fn shortest(
        &self,
        ends: &Ends<D>,
        constants: Option<&Constants>,
    ) -> Result<LatticePath<D>, GraphPathError> {
        let near = |set: &dyn ClosedSet<D>, end| {
            let gates = self.gates(set);
            if gates.is_empty() { Err(GraphPathError::FarFromEnd { end }) } else { Ok(gates) }
        };
        let [mut first, mut second] =
            [near(&**ends.first(), "first")?, near(&**ends.second(), "second")?];
        let batch = || Batch::new(self.metric, Kind::Square, 1, BATCH);
        let mut looks = self.looks.map(|distance| (distance, batch()));
        for gates in [&mut first, &mut second] {
            let node = |gate: &Gate<D>| self.lattice.point(gate.0);
            gates.retain(|gate| Self::is_free(&mut looks, &gate.1, &node(gate)));
        }
        let points = first.iter().chain(&second).map(|gate| gate.1);
        let c1 = constants.map_or(Ok(0.0), |bound| self.checked_bound(bound.c1(), points))?;
        let count = self.lattice.nodes();
        let (mut lengths, mut before) = (vec![f64::INFINITY; count], vec![u32::MAX; count]);
        // A lower bound on the rest of the way from a node, when it is first asked for.
        let mut rests = vec![f64::NAN; if c1 > 0.0 { count } else { 0 }];
        let mut key = |node: usize, length: f64| {
            let Some(rest) = rests.get_mut(node) else { return length };
            if rest.is_nan() {
                let x = self.lattice.point(node);
                *rest = c1.sqrt() * (x - ends.second().project(&x)).norm();
            }
            length + *rest
        };
        // Lengths are not negative, so that their bits have the same order.
        let entry = |key: f64, node: usize| Reverse((key.to_bits(), node as u32));
        let mut heap = BinaryHeap::new();
        for &(node, _, length) in &first {
            lengths[node] = length;
            heap.push(entry(key(node, length), node));
        }
        let mut ends_of: Vec<(usize, f64)> = second.iter().map(|gate| (gate.0, gate.2)).collect();
        ends_of.sort_unstable_by_key(|end| end.0);
        let (mut least, mut opened) = (f64::INFINITY, 0);
        while let Some(Reverse((estimate, node))) = heap.pop() {
            let (estimate, here) = (f64::from_bits(estimate), node as usize);
            if estimate * (1.0 - ROUNDING) > least {
                break;
            }
            let length = lengths[here];
            if estimate > key(here, length) {
                continue;
            }
            opened += 1;
            if let Ok(at) = ends_of.binary_search_by_key(&here, |end| end.0) {
                least = least.min(length + ends_of[at].1);
            }
            for (there, step) in self.neighbours(here) {
                // No edge has a negative length.
                if lengths[there] <= length {
                    continue;
                }
                let Some(edge) = self.edge(here, there, step) else { continue };
                let longer = length + edge;
                let mut is_free = || {
                    let [here, there] = [here, there].map(|node| self.lattice.point(node));
                    Self::is_free(&mut looks, &here, &there)
                };
                if longer < lengths[there] && is_free() {
                    (lengths[there], before[there]) = (longer, node);
                    heap.push(entry(key(there, longer), there));
                }
            }
        }

        let last =
            second.iter().min_by(|a, b| (lengths[a.0] + a.2).total_cmp(&(lengths[b.0] + b.2)));
        let Some((last, end, tail)) = last.filter(|last| (lengths[last.0] + last.2).is_finite())
        else {
            return Err(GraphPathError::NotConnected);
        };
        let mut corners =
            vec![(lengths[*last] + tail, *end), (lengths[*last], self.lattice.point(*last))];
        let mut node = *last;
        while before[node] != u32::MAX {
            node = before[node] as usize;
            corners.push((lengths[node], self.lattice.point(node)));
        }
        let begin = first.iter().find(|begin| begin.0 == node);
        corners.extend(begin.map(|(_, nearest, _)| (0.0, *nearest)));
        corners.reverse();
        Ok(LatticePath { corners, opened })
    }

    /// Checks that `c₁ I ≤ H`, up to rounding, at the nodes and at the points. Returns `c₁`, lowered by the
    /// rounding.
    fn checked_bound(
        &self,
        c1: f64,
        points: impl Iterator<Item = SVector<f64, D>>,
    ) -> Result<f64, GraphPathError> {
        let nodes = self.gram.iter().enumerate();
        let nodes = nodes.filter_map(|(n, h)| Some((self.lattice.point(n), (*h)?)));
        let points = points.filter_map(|x| Some((x, gram_at(self.metric, &x)?)));
        let mut lowered = c1;
        for (x, h) in nodes.chain(points) {
            // Eigenvalues, and the squares of norms, are off by some roundings of the norm of H.
            let lower = c1 - 32.0 * f64::EPSILON * h.norm();
            if (h - SMatrix::identity() * lower).cholesky().is_none() {
                return Err(GraphPathError::Bound { c1, point: x.as_slice().to_vec() });
            }
            lowered = lowered.min(lower);
        }
        Ok(lowered.max(0.0))
    }
}

fn usual_reach(dimension: usize) -> usize {
    if dimension <= 2 { 2 } else { 1 }
}

/// Returns `H(x)` if there is a metric.
pub(crate) fn gram_at<const D: usize>(
    metric: &dyn Batches<D>,
    x: &SVector<f64, D>,
) -> Option<SMatrix<f64, D, D>> {
    check_matrix(metric.gram(x), x).ok()
}

fn norm<const D: usize>(h: &SMatrix<f64, D, D>, d: &SVector<f64, D>) -> f64 {
    // Column by column, as a product of matrices.
    let mut momentum = h.column(0) * d[0];
    for j in 1..D {
        for i in 0..D {
            momentum[i] += h[(i, j)] * d[j];
        }
    }
    let square = d.dot(&momentum);
    // A chord whose length overflows is infinitely long.
    if square >= 0.0 { square.sqrt() } else { f64::INFINITY }
}

/// Returns the offsets of at most `reach` steps along each axis whose greatest common divisor is 1.
fn offsets<const D: usize>(reach: isize) -> Vec<[isize; D]> {
    let side = (2 * reach + 1) as usize;
    let of_number = |mut number: usize| {
        let mut offset = [0; D];
        for along in &mut offset {
            *along = (number % side) as isize - reach;
            number /= side;
        }
        offset
    };
    let divisor = |mut a: isize, mut b: isize| {
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.abs()
    };
    let is_primitive =
        |offset: &[isize; D]| offset.iter().fold(0, |a, &along| divisor(a, along)) == 1;
    (0..side.pow(D as u32)).map(of_number).filter(is_primitive).collect()
}

#[cfg(test)]
mod tests {
    use tautline_formula::{Formula, Plain, Prepared};
    use tautline_metrics::{
        Metric,
        gallery::{Constant, CoupledCosines, Shear},
    };

    use super::*;

    /// Of an inner node: 8 neighbours and 8 knight's moves in the plane, and 26 neighbours in space.
    #[test]
    fn usual_edges_reach_two_steps_in_the_plane_and_one_in_space() {
        fn edges<const D: usize>() -> usize {
            let flat = Constant::new(SMatrix::<f64, D, D>::identity()).expect("definite");
            let flat = Plain::new(&flat);
            let lattice = Lattice::new([0.0; D], [4.0; D], 1.0).expect("a box");
            let graph = LatticeGraph::usual(&flat, lattice);
            graph.edges(graph.lattice().nodes() / 2).count()
        }
        assert_eq!([edges::<2>(), edges::<3>()], [16, 26]);
    }

    /// `H` from norms is that of the metric at every node, up to a few roundings of its largest entry, and is
    /// missing where there is none.
    #[test]
    fn a_graph_in_batches_has_the_metric_of_its_nodes() {
        fn compare<M: Metric<D>, const D: usize>(metric: M, holes: usize) {
            let metric = Prepared::new(metric);
            let lattice = || Lattice::new([-1.0; D], [1.0; D], 0.25).expect("a box");
            let graph = LatticeGraph::in_batches(&metric, lattice());
            let usual = LatticeGraph::usual(&metric, lattice());
            assert_eq!(graph.gram.iter().filter(|h| h.is_none()).count(), holes);
            for (found, expected) in graph.gram.iter().zip(&usual.gram) {
                let (Some(h), Some(expected)) = (found, expected) else {
                    assert_eq!(found.is_none(), expected.is_none());
                    continue;
                };
                assert!((h - expected).amax() <= 16.0 * f64::EPSILON * expected.amax(), "{h}");
            }
        }
        compare(CoupledCosines, 0);
        compare(Shear::new(0.5, 1.0).expect("a wave number"), 0);
        // Of 81 nodes, 9 have x₁ = 0 and 36 less.
        compare(Formula::<2>::parse("cost(exp(-ln(x1)))", &[]).expect("a formula"), 45);
    }
}
