//! `ChordBatch`: the metric at the nodes of many chords at once.

use nalgebra::SVector;
use tautline_formula::{Batch, Batches, Kind, Layout, Register};
use tautline_metrics::Pair;

use crate::{
    Node,
    contractions::{Contractions, Entry},
    momenta::{Energies, Momenta},
};

/// The Gram matrix at the nodes of many chords at once, contracted with the chords.
pub struct ChordBatch<'f, const D: usize> {
    batch: Batch<'f, D>,
    nodes: &'static [Node],
    n: f64,
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node so far.
    pub is_metric: bool,
}

/// A chord `(x, d)`, which runs from `x` to `x + d`.
type Chord<'p, const D: usize> = (&'p SVector<f64, D>, SVector<f64, D>);

impl<'f, const D: usize> ChordBatch<'f, D> {
    /// Returns a batch of up to `chords` chords for evaluations of this `kind`, by the rule with
    /// these `nodes` on `n` subintervals.
    #[must_use]
    pub fn new(
        metric: &'f dyn Batches<D>,
        kind: Kind,
        nodes: &'static [Node],
        n: f64,
        chords: usize,
    ) -> Self {
        // A chord takes at least one lane, and two facing chords stay together.
        let unit = 2 * nodes.len().max(1);
        let batch = Batch::new(metric, kind, unit, chords.div_ceil(2));
        Self { batch, nodes, n, is_metric: true }
    }

    /// Returns the number of chords that fit, which is at least two.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.batch.lanes() / self.nodes.len().max(1)
    }

    /// Evaluates pairs of chords. The second chord of each pair is reversed: it runs from its end
    /// `x + d` back to `x`.
    #[inline]
    pub fn evaluate_facing<'p>(&mut self, pairs: impl ExactSizeIterator<Item = [Chord<'p, D>; 2]>) {
        let count = 2 * pairs.len() * self.nodes.len();
        let mut inputs = self.batch.inputs(count);
        let place = |[(x, d), (other_x, other_d)]: &[Chord<'p, D>; 2], node: &Node| {
            [*x + d * node.fraction, *other_x + other_d * node.fraction]
        };
        if let [node] = self.nodes {
            for (lane, pair) in pairs.enumerate() {
                inputs.set_pair(lane, &place(&pair, node), &[pair[0].1, -pair[1].1]);
            }
        } else {
            let nodes = pairs.flat_map(|pair| self.nodes.iter().map(move |node| (pair, node)));
            for (lane, (pair, node)) in nodes.enumerate() {
                inputs.set_pair(lane, &place(&pair, node), &[pair[0].1, -pair[1].1]);
            }
        }
        self.evaluate(count);
    }

    /// Evaluates chords from end 0, which is `x`, or reversed from end 1, which is `x + d`.
    #[inline]
    pub fn evaluate_from<'p>(
        &mut self,
        end: usize,
        chords: impl ExactSizeIterator<Item = Chord<'p, D>>,
    ) {
        let count = chords.len() * self.nodes.len();
        let mut inputs = self.batch.inputs(count);
        let directed = |d: SVector<f64, D>| if end == 0 { d } else { -d };
        if let [node] = self.nodes {
            for (lane, (x, d)) in chords.enumerate() {
                inputs.set(lane, &(x + d * node.fraction), &directed(d));
            }
        } else {
            let nodes = chords.flat_map(|chord| self.nodes.iter().map(move |node| (chord, node)));
            for (lane, ((x, d), node)) in nodes.enumerate() {
                inputs.set(lane, &(x + d * node.fraction), &directed(d));
            }
        }
        self.evaluate(count);
    }

    fn evaluate(&mut self, count: usize) {
        if count > 0 {
            self.is_metric &= self.batch.evaluate(count);
        }
    }

    /// Returns the models of pairs of facing chords.
    #[must_use]
    #[inline]
    pub fn pairs(&self) -> Contractions<'_, Pair, D> {
        self.contractions(|row| row.as_chunks::<2>().0)
    }

    /// Returns the models of single chords.
    #[must_use]
    #[inline]
    pub fn singles(&self) -> Contractions<'_, f64, D> {
        self.contractions(|row| row)
    }

    #[inline]
    fn contractions<'b, T: Entry>(
        &'b self,
        split: impl Fn(&'b [f64]) -> &'b [T::Row],
    ) -> Contractions<'b, T, D> {
        let Layout { slope, gram, turn, bend, .. } = self.batch.layout();
        let row = |register: Register| split(self.batch.row(register));
        let matrix = |registers: &[Register]| {
            std::array::from_fn(|i| std::array::from_fn(|j| row(registers[i * D + j])))
        };
        Contractions {
            d: std::array::from_fn(|i| row((D + i) as Register)),
            slope: std::array::from_fn(|i| row(slope[i])),
            gram: matrix(gram),
            turn: matrix(turn),
            bend: matrix(bend),
            nodes: self.nodes,
            n: self.n,
        }
    }

    /// Returns the energies of the chords.
    #[must_use]
    #[inline]
    pub fn energies(&self) -> Energies<'_> {
        let square = self.batch.row(self.batch.layout().square[0]);
        Energies { square, nodes: self.nodes, n: self.n }
    }

    /// Returns the momenta of the chords, from which their gradients follow.
    #[must_use]
    #[inline]
    pub fn momenta(&self) -> Momenta<'_, D> {
        let Layout { momentum, slope, .. } = self.batch.layout();
        let rows = |registers: &[Register]| std::array::from_fn(|i| self.batch.row(registers[i]));
        let (momentum, slope) = (rows(momentum), rows(slope));
        Momenta { momentum, slope, nodes: self.nodes, n: self.n }
    }
}

#[cfg(test)]
mod tests;
