//! `ChordBatch`: the models of many chords at once.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Batch, Batches, Kind};
use tautline_metrics::{Lanes, Pair};

use crate::{ChordModel, Node, contraction::Contraction};

/// What many chords add to a discrete energy, to second order: the [`ChordModel`]s of as many as there are
/// lanes for.
pub struct ChordBatch<'f, const D: usize> {
    batch: Batch<'f, D>,
    nodes: &'static [Node],
    n: f64,
    /// Whether the Gram matrix is one at every node so far.
    pub is_metric: bool,
}

/// A chord `(x, d)`.
type Chord<'p, const D: usize> = (&'p SVector<f64, D>, SVector<f64, D>);

impl<'f, const D: usize> ChordBatch<'f, D> {
    /// For a rule with these nodes on `n` subintervals.
    pub fn new(metric: &'f dyn Batches<D>, nodes: &'static [Node], n: f64) -> Self {
        Self { batch: metric.batch(Kind::Contraction), nodes, n, is_metric: true }
    }

    /// How many chords there is room for.
    #[must_use]
    pub fn room(&self) -> usize {
        self.batch.lanes() / self.nodes.len().max(1)
    }

    /// Evaluates pairs of chords, the second of each seen from its end 1.
    #[inline]
    pub fn face<'p>(&mut self, pairs: impl ExactSizeIterator<Item = [Chord<'p, D>; 2]>) {
        let count = 2 * pairs.len() * self.nodes.len();
        if count == 0 {
            return;
        }
        let mut inputs = self.batch.inputs();
        let mut lane = 0;
        for [(x, d), (other_x, other_d)] in pairs {
            for node in self.nodes {
                inputs.set(lane, &(x + d * node.fraction), &d);
                inputs.set(lane + 1, &(other_x + other_d * node.fraction), &-other_d);
                lane += 2;
            }
        }
        self.is_metric &= self.batch.evaluate(count);
    }

    /// Evaluates chords as seen from one of their ends.
    #[inline]
    pub fn see<'p>(&mut self, end: usize, chords: impl ExactSizeIterator<Item = Chord<'p, D>>) {
        let count = chords.len() * self.nodes.len();
        if count == 0 {
            return;
        }
        let mut inputs = self.batch.inputs();
        let mut lane = 0;
        for (x, d) in chords {
            let seen = if end == 0 { d } else { -d };
            for node in self.nodes {
                inputs.set(lane, &(x + d * node.fraction), &seen);
                lane += 1;
            }
        }
        self.is_metric &= self.batch.evaluate(count);
    }

    /// Returns the rows in which the contractions of what was evaluated last are.
    #[inline]
    pub fn pairs(&self) -> Rows<'_, Pair, D> {
        Rows::new(&self.batch, self.nodes, self.n, |row| row.as_chunks::<2>().0)
    }

    /// The same, for chords that were seen one by one.
    #[inline]
    pub fn singles(&self) -> Rows<'_, f64, D> {
        Rows::new(&self.batch, self.nodes, self.n, |row| row)
    }
}

/// A number of each of some lanes that stand side by side.
pub trait Row: Lanes {
    type Entry: Copy;
    fn of(entry: Self::Entry) -> Self;
}

impl Row for f64 {
    type Entry = f64;
    #[inline(always)]
    fn of(entry: f64) -> Self {
        entry
    }
}

impl Row for Pair {
    type Entry = [f64; 2];
    #[inline(always)]
    fn of([one, other]: [f64; 2]) -> Self {
        Self::new(one, other)
    }
}

/// Contractions of chords, row by row.
pub struct Rows<'b, T: Row, const D: usize> {
    d: [&'b [T::Entry]; D],
    slope: [&'b [T::Entry]; D],
    gram: [[&'b [T::Entry]; D]; D],
    turn: [[&'b [T::Entry]; D]; D],
    bend: [[&'b [T::Entry]; D]; D],
    nodes: &'static [Node],
    n: f64,
}

impl<'b, T: Row, const D: usize> Rows<'b, T, D> {
    #[inline]
    fn new(
        batch: &'b Batch<'_, D>,
        nodes: &'static [Node],
        n: f64,
        split: impl Fn(&'b [f64]) -> &'b [T::Entry],
    ) -> Self {
        let layout = batch.layout();
        let row = |register: u16| split(batch.row(register));
        let square = |registers: &[u16]| {
            std::array::from_fn(|i| std::array::from_fn(|j| row(registers[i * D + j])))
        };
        Self {
            d: std::array::from_fn(|i| row((D + i) as u16)),
            slope: std::array::from_fn(|i| row(layout.slope[i])),
            gram: square(&layout.gram),
            turn: square(&layout.turn),
            bend: square(&layout.bend),
            nodes,
            n,
        }
    }

    /// The model of the chord, or pair of chords, with this number.
    #[inline(always)]
    pub fn model(&self, k: usize, far: impl Fn(f64) -> T) -> ChordModel<D, T> {
        let count = self.nodes.len();
        let first = k * count;
        ChordModel::over(self.nodes, |place, node| {
            let lane = first + place;
            let d = SVector::from_fn(|i, _| T::of(self.d[i][lane]));
            let contraction = Contraction {
                h: SMatrix::from_fn(|i, j| T::of(self.gram[i][j][lane])),
                g: SVector::from_fn(|i, _| T::of(self.slope[i][lane])),
                p: SMatrix::from_fn(|i, j| T::of(self.turn[i][j][lane])),
                q: SMatrix::from_fn(|i, j| T::of(self.bend[i][j][lane])),
                is_metric: true,
            };
            ChordModel::at_node(contraction, &d, far(node.fraction), node.weight * self.n)
        })
    }
}
