//! `ChordBatch`: the metric at the nodes of many chords at once.

use tautline_formula::{AnyBatches, Batch, Kind, Layout, Register};
use tautline_metrics::Pair;

use crate::{
    Node,
    contractions::{Contractions, Entry},
    momenta::{Energies, Momenta},
};

/// The Gram matrix at the nodes of many chords at once, contracted with the chords.
pub struct ChordBatch<'f> {
    batch: Batch<'f>,
    pub(crate) dimension: usize,
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node so far.
    pub is_metric: bool,
}

impl<'f> ChordBatch<'f> {
    /// Returns a batch of up to `chords` chords for evaluations of this `kind`, by the rule with
    /// these `nodes` on `n` subintervals.
    #[must_use]
    pub fn new(
        metric: &'f dyn AnyBatches,
        kind: Kind,
        nodes: &'static [Node],
        n: f64,
        chords: usize,
    ) -> Self {
        // A chord takes at least one lane, and two facing chords stay together.
        let unit = 2 * nodes.len().max(1);
        let batch = Batch::new(metric, kind, unit, chords.div_ceil(2));
        Self { batch, dimension: metric.dimension(), nodes, n, is_metric: true }
    }

    /// Returns the number of chords that fit, which is at least two.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.batch.lanes() / self.nodes.len().max(1)
    }

    /// Evaluates the chords between consecutive points, from the first to the last. The coordinates
    /// of the points follow one another.
    pub fn evaluate(&mut self, points: &[f64]) {
        let count = self.chords(points);
        // The usual dimensions are constants that the compiler can use.
        match self.dimension {
            1 => self.fill_chain(1, count, points),
            2 => self.fill_chain(2, count, points),
            3 => self.fill_chain(3, count, points),
            4 => self.fill_chain(4, count, points),
            5 => self.fill_chain(5, count, points),
            6 => self.fill_chain(6, count, points),
            d => self.fill_chain(d, count, points),
        }
        self.run(count);
    }

    /// Evaluates the chords between consecutive points from the last to the first, and each from its
    /// end `x + d` back to `x`.
    pub fn evaluate_reversed(&mut self, points: &[f64]) {
        let count = self.chords(points);
        self.fill(-1.0, count, points, |k| [count - 1 - k, count - k]);
        self.run(count);
    }

    /// Evaluates pairs of chords: those between consecutive points of `first`, from the first to the
    /// last, beside those of `last`, which has as many points, [reversed](Self::evaluate_reversed).
    pub fn evaluate_facing(&mut self, first: &[f64], last: &[f64]) {
        let count = self.chords(first);
        match self.dimension {
            1 => self.fill_facing(1, count, first, last),
            2 => self.fill_facing(2, count, first, last),
            3 => self.fill_facing(3, count, first, last),
            d => self.fill_facing(d, count, first, last),
        }
        self.run(2 * count);
    }

    /// Evaluates chords between any of some points, each given by the numbers of its first and its
    /// last point.
    pub fn evaluate_between(&mut self, points: &[f64], chords: &[[usize; 2]]) {
        self.fill(1.0, chords.len(), points, |k| chords[k]);
        self.run(chords.len());
    }

    /// Returns the number of chords between consecutive points.
    fn chords(&self, points: &[f64]) -> usize {
        (points.len() / self.dimension).saturating_sub(1)
    }

    /// Sets the nodes of the `count` chords between consecutive points, coordinate by coordinate. Node `j`
    /// of chord `k` of a rule with `m` nodes takes the lane `k m + j`.
    #[inline(always)]
    fn fill_chain(&mut self, d: usize, count: usize, points: &[f64]) {
        let (nodes, m) = (self.nodes, self.nodes.len().max(1));
        let (first, later) = points[..(count + 1) * d].split_at(d);
        for i in 0..d {
            let [places, vectors] = self.batch.input(i);
            let (places, vectors) = (&mut places[..count * m], &mut vectors[..count * m]);
            let mut x = first[i];
            let mut step_to = |point: &[f64]| {
                let (near, far) = (x, point[i]);
                x = far;
                (near, far - near)
            };
            if let [node] = nodes {
                let lanes = places.iter_mut().zip(vectors);
                for ((place, vector), point) in lanes.zip(later.chunks_exact(d)) {
                    let (near, step) = step_to(point);
                    *place = near + step * node.fraction;
                    *vector = step;
                }
                continue;
            }
            let lanes = places.chunks_exact_mut(m).zip(vectors.chunks_exact_mut(m));
            for ((places, vectors), point) in lanes.zip(later.chunks_exact(d)) {
                let (near, step) = step_to(point);
                for ((place, vector), node) in places.iter_mut().zip(vectors).zip(nodes) {
                    *place = near + step * node.fraction;
                    *vector = step;
                }
            }
        }
    }

    /// Sets the nodes of `count` chords, coordinate by coordinate. `chord` returns the numbers of the
    /// two points of a chord. Node `j` of chord `k` of a rule with `m` nodes takes the lane `k m + j`.
    #[inline(always)]
    fn fill(
        &mut self,
        direction: f64,
        count: usize,
        points: &[f64],
        chord: impl Fn(usize) -> [usize; 2],
    ) {
        // The usual dimensions are constants that the compiler can use.
        match self.dimension {
            1 => self.fill_in(1, direction, count, points, chord),
            2 => self.fill_in(2, direction, count, points, chord),
            3 => self.fill_in(3, direction, count, points, chord),
            d => self.fill_in(d, direction, count, points, chord),
        }
    }

    #[inline(always)]
    fn fill_in(
        &mut self,
        d: usize,
        direction: f64,
        count: usize,
        points: &[f64],
        chord: impl Fn(usize) -> [usize; 2],
    ) {
        let nodes = self.nodes;
        let lanes = count * nodes.len();
        for i in 0..d {
            let [places, vectors] = self.batch.input(i);
            let (places, vectors) = (&mut places[..lanes], &mut vectors[..lanes]);
            let ends = |k: usize| {
                let [near, far] = chord(k);
                let x = points[near * d + i];
                (x, points[far * d + i] - x)
            };
            if let [node] = nodes {
                for (k, (place, vector)) in places.iter_mut().zip(vectors).enumerate() {
                    let (x, step) = ends(k);
                    *place = x + step * node.fraction;
                    *vector = step * direction;
                }
                continue;
            }
            for k in 0..count {
                let (x, step) = ends(k);
                for (j, node) in nodes.iter().enumerate() {
                    let lane = k * nodes.len() + j;
                    places[lane] = x + step * node.fraction;
                    vectors[lane] = step * direction;
                }
            }
        }
    }

    /// Sets the nodes of facing chords, coordinate by coordinate. Node `j` of pair `k` of a rule with `m`
    /// nodes takes the pair of lanes `k m + j`.
    #[inline(always)]
    fn fill_facing(&mut self, d: usize, count: usize, first: &[f64], last: &[f64]) {
        let (nodes, m) = (self.nodes, self.nodes.len().max(1));
        let (first, later) = first[..(count + 1) * d].split_at(d);
        let (earlier, last) = last[..(count + 1) * d].split_at(count * d);
        for i in 0..d {
            let [places, vectors] = self.batch.input(i);
            let places = &mut places.as_chunks_mut::<2>().0[..count * m];
            let vectors = &mut vectors.as_chunks_mut::<2>().0[..count * m];
            let (mut x, mut z) = (first[i], last[i]);
            // From x on to the next point, and from z back to the point before it.
            let mut step_to = |next: &[f64], before: &[f64]| {
                let (near, y) = ([x, before[i]], before[i]);
                let steps = [next[i] - x, z - y];
                (x, z) = (next[i], y);
                (near, steps)
            };
            let points = later.chunks_exact(d).zip(earlier.rchunks_exact(d));
            if let [node] = nodes {
                let pairs = places.iter_mut().zip(vectors);
                for ((place, vector), (next, before)) in pairs.zip(points) {
                    let ([x, y], steps) = step_to(next, before);
                    *place = [x + steps[0] * node.fraction, y + steps[1] * node.fraction];
                    *vector = [steps[0], -steps[1]];
                }
                continue;
            }
            let pairs = places.chunks_exact_mut(m).zip(vectors.chunks_exact_mut(m));
            for ((places, vectors), (next, before)) in pairs.zip(points) {
                let ([x, y], steps) = step_to(next, before);
                for ((node, place), vector) in nodes.iter().zip(places).zip(vectors) {
                    *place = [x + steps[0] * node.fraction, y + steps[1] * node.fraction];
                    *vector = [steps[0], -steps[1]];
                }
            }
        }
    }

    fn run(&mut self, chords: usize) {
        let count = chords * self.nodes.len();
        if count > 0 {
            self.is_metric &= self.batch.evaluate(count);
        }
    }

    /// Returns the models of pairs of facing chords in `R^D`.
    #[must_use]
    #[inline]
    pub fn pairs<const D: usize>(&self) -> Contractions<'_, Pair, D> {
        self.contractions(|row| row.as_chunks::<2>().0)
    }

    /// Returns the models of single chords in `R^D`.
    #[must_use]
    #[inline]
    pub fn singles<const D: usize>(&self) -> Contractions<'_, f64, D> {
        self.contractions(|row| row)
    }

    #[inline]
    fn contractions<'b, T: Entry, const D: usize>(
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

    /// Returns which row holds what.
    #[inline]
    pub(crate) fn layout(&self) -> &Layout {
        self.batch.layout()
    }

    /// Returns a row, lane by lane.
    #[inline]
    pub(crate) fn row(&self, register: Register) -> &[f64] {
        self.batch.row(register)
    }

    /// Returns the energies of the chords.
    #[must_use]
    #[inline]
    pub fn energies(&self) -> Energies<'_> {
        let square = self.batch.row(self.batch.layout().square[0]);
        Energies { square, nodes: self.nodes, n: self.n }
    }

    /// Returns coordinate `i` of the momenta of the chords, from which their gradients follow.
    #[must_use]
    #[inline]
    pub fn momenta(&self, i: usize) -> Momenta<'_> {
        let Layout { momentum, slope, .. } = self.batch.layout();
        let [momentum, slope] = [momentum, slope].map(|rows| self.batch.row(rows[i]));
        Momenta { momentum, slope, nodes: self.nodes, n: self.n }
    }
}

#[cfg(test)]
mod tests;
