//! `Energies` and `Momenta`: what energies and gradients of chords are made of, row by row.

use nalgebra::SVector;

use crate::Node;

/// What chords add to the energy.
#[derive(Clone, Copy)]
pub struct Energies<'b> {
    pub(crate) square: &'b [f64],
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
}

impl Energies<'_> {
    /// Hands over what the first chords add, node by node and chord by chord: `N w dᵀHd`.
    #[inline]
    pub fn for_first(self, chords: usize, mut take: impl FnMut(f64)) {
        let squares = &self.square[..chords * self.nodes.len()];
        // A rule with one node takes two thirds of the time without the inner loop.
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

/// What makes the gradients of chords.
#[derive(Clone, Copy)]
pub struct Momenta<'b, const D: usize> {
    pub(crate) momentum: [&'b [f64]; D],
    pub(crate) slope: [&'b [f64]; D],
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
}

impl<const D: usize> Momenta<'_, D> {
    /// Returns those of the first chords.
    ///
    /// # Panics
    ///
    /// If there are fewer.
    #[inline(always)]
    #[must_use]
    pub fn first(mut self, chords: usize) -> Self {
        // A compiler then knows that all rows are of one length.
        let lanes = chords * self.nodes.len();
        for i in 0..D {
            self.momentum[i] = &self.momentum[i][..lanes];
            self.slope[i] = &self.slope[i][..lanes];
        }
        self
    }

    /// Adds the gradients of what chord `k` adds to the energy, by its points `x` and `x + d`, to these.
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
