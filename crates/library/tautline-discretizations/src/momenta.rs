//! `Energies` and `Momenta`: contractions of the metric, from which energies and gradients are
//! assembled.

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

/// One coordinate of the momenta of many chords and of the derivatives of the metric along them, in
/// rows.
#[derive(Clone, Copy)]
pub struct Momenta<'b> {
    pub(crate) momentum: &'b [f64],
    pub(crate) slope: &'b [f64],
    pub(crate) nodes: &'static [Node],
    pub(crate) n: f64,
}

impl Momenta<'_> {
    /// Calls `take` with this coordinate of the gradients of the energy with respect to the points of
    /// the first `chords` chords, which follow one another. Before the first of them it is `carried`;
    /// what the last chord contributes to its last point is returned.
    ///
    /// # Panics
    ///
    /// If there are fewer than `chords`.
    #[inline]
    pub fn for_first(self, chords: usize, mut carried: f64, mut take: impl FnMut(f64)) -> f64 {
        let lanes = chords * self.nodes.len();
        let (momentum, slope) = (&self.momentum[..lanes], &self.slope[..lanes]);
        for k in 0..chords {
            let mut gradients = [carried, 0.0];
            for (place, node) in self.nodes.iter().enumerate() {
                let lane = k * self.nodes.len() + place;
                let w = self.n * node.weight;
                let (twice, g) = (2.0 * momentum[lane], slope[lane]);
                gradients[0] += w * (g * (1.0 - node.fraction) - twice);
                gradients[1] += w * (g * node.fraction + twice);
            }
            take(gradients[0]);
            carried = gradients[1];
        }
        carried
    }
}
