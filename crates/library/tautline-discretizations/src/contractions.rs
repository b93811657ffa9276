//! `Contractions`: contracted derivatives of the metric, from which the models of chords are
//! assembled.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Lanes, Pair};

use crate::{ChordModel, Node};

/// A number for one chord, or a pair of numbers for two facing chords.
pub trait Entry: Lanes {
    /// The layout of an entry in a row.
    type Row: Copy;

    /// Loads an entry from a row.
    fn of(row: Self::Row) -> Self;

    /// Returns the position of a node as a fraction of each chord, reversed for the second of a
    /// pair. It is the weight of the far point.
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

/// The derivatives of the metric at the nodes of many chords, contracted with the chords and stored
/// in rows.
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
    /// Returns the contractions of the first `count` chords, or pairs of chords.
    ///
    /// # Panics
    ///
    /// If there are fewer than `count`.
    #[inline(always)]
    #[must_use]
    pub fn first(mut self, count: usize) -> Self {
        // The compiler then knows that all rows have the same length, and checks bounds only once.
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

    /// Returns whether the only node of the rule is the midpoint, as for the trapezoidal rule. In
    /// this case [`model_at_midpoint`](Self::model_at_midpoint) returns the same model and is
    /// faster.
    #[must_use]
    pub fn is_midpoint(&self) -> bool {
        matches!(self.nodes, [Node { fraction: 0.5, .. }])
    }

    /// Returns the model of chord (or pair of chords) `k` for a rule that has the midpoint as its
    /// only node. The model is the same from both ends.
    ///
    /// # Panics
    ///
    /// If there is no such chord. For any other rule the result is meaningless, and debug builds
    /// panic.
    #[inline(always)]
    #[must_use]
    pub fn model_at_midpoint(&self, k: usize) -> ChordModel<D, T> {
        debug_assert!(self.is_midpoint(), "a rule with the midpoint as its only node");
        // With a constant fraction the compiler evaluates products of it.
        self.at_node(k, self.nodes[0].weight, T::constant(0.5))
    }

    /// Returns the model of chord (or pair of chords) `k`.
    #[inline(always)]
    #[must_use]
    pub fn model(&self, k: usize) -> ChordModel<D, T> {
        self.sum(k, T::far)
    }

    /// Sums over the nodes. `far` maps the fraction of a node to the weight of the far point.
    #[inline(always)]
    fn sum(&self, k: usize, far: impl Fn(f64) -> T) -> ChordModel<D, T> {
        let [first, rest @ ..] = self.nodes else { return ChordModel::zero() };
        let lane = k * self.nodes.len();
        let mut model = self.at_node(lane, first.weight, far(first.fraction));
        for (place, node) in rest.iter().enumerate() {
            model.add(&self.at_node(lane + 1 + place, node.weight, far(node.fraction)));
        }
        model
    }

    /// Returns the contribution of a node with this weight, at the fraction `far` of the chord,
    /// from a lane or a pair of lanes.
    ///
    /// The code consists of plain loops over entries: temporary matrices would be copied, and not
    /// all closures for single entries would be inlined.
    #[inline(always)]
    fn at_node(&self, lane: usize, weight: f64, far: T) -> ChordModel<D, T> {
        let weight = weight * self.n;
        // The weight, and twice the weight for terms with a factor 2.
        let (once, twice) = (T::constant(weight), T::constant(2.0 * weight));
        let near = T::one() - far;
        let (near_near, near_far, far_far) = (near * near, near * far, far * far);
        let mut model = ChordModel::zero();
        let mut h = SMatrix::<T, D, D>::zeros();
        let [mut d, mut hd] = [SVector::<T, D>::zeros(); 2];
        for j in 0..D {
            for i in j..D {
                let h_ij = T::of(self.gram[i][j][lane]) * twice;
                let q = T::of(self.bend[i][j][lane]) * once;
                let [p, transposed] =
                    [self.turn[i][j], self.turn[j][i]].map(|row| T::of(row[lane]) * twice);
                let (symmetric, mixed) = (p + transposed, q * near_far - h_ij);
                let hessian =
                    [h_ij - symmetric * near + q * near_near, h_ij + symmetric * far + q * far_far];
                (h[(i, j)], h[(j, i)]) = (h_ij, h_ij);
                for end in 0..2 {
                    model.hessian[end][(i, j)] = hessian[end];
                    model.hessian[end][(j, i)] = hessian[end];
                }
                model.coupling[(j, i)] = mixed - transposed * far + p * near;
                model.coupling[(i, j)] = mixed - p * far + transposed * near;
            }
            d[j] = T::of(self.d[j][lane]);
        }
        for j in 0..D {
            for i in 0..D {
                hd[i] += h[(i, j)] * d[j];
            }
            model.trace += h[(j, j)];
        }
        for i in 0..D {
            let g = T::of(self.slope[i][lane]) * once;
            model.gradient[0][i] = g * near - hd[i];
            model.gradient[1][i] = g * far + hd[i];
        }
        model.energy = d.dot(&hd) * 0.5;
        model.trace *= T::constant(0.5);
        model
    }
}

impl<const D: usize> Contractions<'_, f64, D> {
    /// Returns the model of chord `k`, which was evaluated from its end 0 or 1, as `end` says.
    #[inline(always)]
    #[must_use]
    pub fn model_from(&self, end: usize, k: usize) -> ChordModel<D> {
        self.sum(k, |fraction| if end == 0 { fraction } else { 1.0 - fraction })
    }
}
