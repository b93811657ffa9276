//! `Contractions`: what the models of chords are made of, row by row.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Lanes, Pair};

use crate::{ChordModel, Node, chord_model::Contraction};

/// A number of each of some lanes that stand side by side.
pub trait Entry: Lanes {
    /// How they stand in a row.
    type Row: Copy;

    /// Returns them as one number.
    fn of(row: Self::Row) -> Self;

    /// Returns the fraction of a chord as seen from where these lanes see it, and so its far point.
    fn far(fraction: f64) -> Self;
}

impl Entry for f64 {
    type Row = f64;

    #[inline(always)]
    fn of(row: f64) -> Self {
        row
    }

    #[inline(always)]
    fn far(fraction: f64) -> Self {
        fraction
    }
}

impl Entry for Pair {
    type Row = [f64; 2];

    #[inline(always)]
    fn of([one, other]: [f64; 2]) -> Self {
        Self::new(one, other)
    }

    #[inline(always)]
    fn far(fraction: f64) -> Self {
        Self::new(fraction, 1.0 - fraction)
    }
}

/// What makes the models of chords, row by row.
#[derive(Clone, Copy)]
pub struct Contractions<'b, T: Entry, const D: usize> {
    pub(crate) d: [&'b [T::Row]; D],
    pub(crate) slope: [&'b [T::Row]; D],
    pub(crate) gram: [[&'b [T::Row]; D]; D],
    pub(crate) turn: [[&'b [T::Row]; D]; D],
    pub(crate) bend: [[&'b [T::Row]; D]; D],
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
}

impl<T: Entry, const D: usize> Contractions<'_, T, D> {
    /// Returns those of the first `count` chords, or pairs of chords.
    ///
    /// # Panics
    ///
    /// If there are fewer.
    #[inline(always)]
    #[must_use]
    pub fn first(mut self, count: usize) -> Self {
        // A compiler then knows that all rows are of one length, and compares with it once.
        let lanes = count * self.nodes.len();
        for i in 0..D {
            self.d[i] = &self.d[i][..lanes];
            self.slope[i] = &self.slope[i][..lanes];
            for j in 0..D {
                self.gram[i][j] = &self.gram[i][j][..lanes];
                self.turn[i][j] = &self.turn[i][j][..lanes];
                self.bend[i][j] = &self.bend[i][j][..lanes];
            }
        }
        self
    }

    /// Returns whether the rule has one node, in the middle of a chord, as the trapezoidal rule has:
    /// [`model_by_middle`](Self::model_by_middle) is then the model, in less time.
    #[must_use]
    pub fn is_by_middle(&self) -> bool {
        matches!(self.nodes, [Node { fraction: 0.5, .. }])
    }

    /// Returns the model of the chord, or of the pair of chords, with this number, under a rule with one node
    /// in its middle. It is the same from both ends.
    ///
    /// # Panics
    ///
    /// If there is no such chord. Under another rule it is the model of none, which debug builds refuse.
    #[inline(always)]
    #[must_use]
    pub fn model_by_middle(&self, k: usize) -> ChordModel<D, T> {
        debug_assert!(self.is_by_middle(), "a rule with one node, in the middle");
        // A constant, of which products are known when this is compiled.
        self.at_node(k, self.nodes[0].weight, T::constant(0.5))
    }

    /// Returns the model of the chord, or of the pair of chords, with this number.
    #[inline(always)]
    #[must_use]
    pub fn model(&self, k: usize) -> ChordModel<D, T> {
        self.seen(k, T::far)
    }

    /// Returns the model of a chord that was seen from its end 0 or 1.
    #[inline(always)]
    fn seen(&self, k: usize, far: impl Fn(f64) -> T) -> ChordModel<D, T> {
        let first = k * self.nodes.len();
        ChordModel::over(self.nodes, |place, node| {
            self.at_node(first + place, node.weight, far(node.fraction))
        })
    }

    /// Returns the part of the node of this weight that was evaluated in this lane, or pair of lanes.
    #[inline(always)]
    fn at_node(&self, lane: usize, weight: f64, far: T) -> ChordModel<D, T> {
        // Plain loops: closures that are called for each entry are not all inlined.
        let matrix = |rows: &[[&[T::Row]; D]; D], is_symmetric: bool| {
            let mut matrix = SMatrix::<T, D, D>::zeros();
            for j in 0..D {
                for i in 0..D {
                    matrix[(i, j)] = if is_symmetric && i < j {
                        matrix[(j, i)]
                    } else {
                        T::of(rows[i][j][lane])
                    };
                }
            }
            matrix
        };
        let vector = |rows: &[&[T::Row]; D]| {
            let mut vector = SVector::<T, D>::zeros();
            for i in 0..D {
                vector[i] = T::of(rows[i][lane]);
            }
            vector
        };
        let contraction = Contraction {
            h: matrix(&self.gram, true),
            g: vector(&self.slope),
            p: matrix(&self.turn, false),
            q: matrix(&self.bend, true),
        };
        ChordModel::at_node(contraction, &vector(&self.d), far, weight * self.n)
    }
}

impl<const D: usize> Contractions<'_, f64, D> {
    /// Returns the model of the chord with this number, which was seen from its end 0 or 1.
    #[inline(always)]
    #[must_use]
    pub fn model_from(&self, end: usize, k: usize) -> ChordModel<D> {
        self.seen(k, |fraction| if end == 0 { fraction } else { 1.0 - fraction })
    }
}
