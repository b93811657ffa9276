//! `Energies` and `Momenta`: contractions of the metric, from which energies and gradients are
//! assembled.

use nalgebra::SVector;

use crate::Node;

/// The energies of many chords, stored in a row.
#[derive(Clone, Copy)]
pub struct Energies<'b> {
    pub(crate) square: &'b [f64],
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
}

impl Energies<'_> {
    /// Calls `take` with `N w dᵀHd`, node by node, for each of the first `chords` chords.
    #[inline]
    pub fn for_first(self, chords: usize, mut take: impl FnMut(f64)) {
        let squares = &self.square[..chords * self.nodes.len()];
        // Without the inner loop, a rule with one node takes only two thirds of the time.
        if let [node] = self.nodes {
            for square in squares {
                take(self.n * node.weight * square);
            }
        } else {
            for squares in squares.chunks_exact(self.nodes.len().max(1)) {
                for (node, square) in self.nodes.iter().zip(squares) {
                    take(self.n * node.weight * square);
                }
            }
        }
    }
}

/// The momenta of many chords and the derivatives of the metric along them, stored in rows.
#[derive(Clone, Copy)]
pub struct Momenta<'b, const D: usize> {
    pub(crate) momentum: [&'b [f64]; D],
    pub(crate) slope: [&'b [f64]; D],
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
}

impl<const D: usize> Momenta<'_, D> {
    /// Returns the momenta of the first `chords` chords.
    ///
    /// # Panics
    ///
    /// If there are fewer than `chords`.
    #[inline(always)]
    #[must_use]
    pub fn first(mut self, chords: usize) -> Self {
        // The compiler then knows that all rows have the same length.
        let lanes = chords * self.nodes.len();
        for i in 0..D {
            self.momentum[i] = &self.momentum[i][..lanes];
            self.slope[i] = &self.slope[i][..lanes];
        }
        self
    }

    /// Adds the gradients of the energy of chord `k` with respect to its points `x` and `x + d`.
    #[inline(always)]
    pub fn add(&self, k: usize, gradients: &mut [SVector<f64, D>; 2]) {
        for (place, node) in self.nodes.iter().enumerate() {
            let lane = k * self.nodes.len() + place;
            let w = self.n * node.weight;
            for i in 0..D {
                let twice = 2.0 * self.momentum[i][lane];
                let g = self.slope[i][lane];
                gradients[0][i] += w * (g * (1.0 - node.fraction) - twice);
                gradients[1][i] += w * (g * node.fraction + twice);
            }
        }
    }
}
