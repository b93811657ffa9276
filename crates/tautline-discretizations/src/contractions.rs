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
            let lane = first + place;
            let matrix = |rows: &[[&[T::Row]; D]; D]| {
                SMatrix::<T, D, D>::from_fn(|i, j| T::of(rows[i][j][lane]))
            };
            let contraction = Contraction {
                h: matrix(&self.gram),
                g: SVector::from_fn(|i, _| T::of(self.slope[i][lane])),
                p: matrix(&self.turn),
                q: matrix(&self.bend),
            };
            let d = SVector::from_fn(|i, _| T::of(self.d[i][lane]));
            ChordModel::at_node(contraction, &d, far(node.fraction), node.weight * self.n)
        })
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
