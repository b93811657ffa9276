//! The global minimum of a discrete energy on the line, over all sequences of grid points, by
//! dynamic programming: also over sequences that jump across valleys.
//!
//! With the cost `c(x, y) = H(x + θ(y − x)) (y − x)²` of one chord, `E_N = N Σ c(xₙ, xₙ₊₁)`, and
//! the least cost `Vₙ(y)` of `n` chords from the start to `y` obeys
//! `Vₙ₊₁(y) = minₓ Vₙ(x) + c(x, y)`. `V` does not depend on `N`: one pass gives the minima for all
//! `N` up to the last.
//!
//! # How far the grid has to reach
//!
//! A sequence that leaves `[a, b]` by `r` has `Σ |xₙ₊₁ − xₙ| ≥ b − a + 2r`, hence by Cauchy and
//! Schwarz `E_N ≥ c₁ (b − a + 2r)²`. If an admissible sequence has energy `U`, any better one stays
//! within `r ≤ (√(U/c₁) − (b − a))/2`.
//!
//! # How far the grid is off
//!
//! Let `x` be a minimiser and `δ` move its inner points to the grid, `|δₙ| ≤ h/2`. To first order
//! nothing changes. The second derivative of one chord's share `N c` in the direction of `δ` is
//!
//! ```text
//! N (2H v² + 4 H′ Δ u v + H″ Δ² u²),    v = δₙ₊₁ − δₙ, |v| ≤ h;    u: δ at the node, |u| ≤ h/2
//! ```
//!
//! at most `N h² (2c₂ + 2 L_H |Δ| + M_H Δ²/4)`, where along the way `|Δ|` grows by at most `h`.
//! Half of the sum over the chords bounds the change.

use tautline::{Bounded, Constants, gallery::Valleys};

/// A problem on the line: from `a` to `b`, `a < b`, with the Gram matrix read at the fraction
/// `theta` of each chord.
pub struct GridLine<'a> {
    /// `a` and `b`, in `ℓ`.
    pub ends: [f64; 2],
    /// `H`, in `m²/ℓ²`.
    pub gram: &'a dyn Fn(f64) -> f64,
    /// The constants of `H`, with `M_H`.
    pub constants: Constants,
    /// Where the rule reads: 0 for the left-endpoint rule, ½ for the trapezoidal rule.
    pub theta: f64,
    /// The number of grid intervals between the ends.
    pub intervals: usize,
}

/// The least energy on the grid.
#[derive(Clone, Debug, PartialEq)]
pub struct GridMinimum {
    /// The energy, in `m²`.
    pub energy: f64,
    /// The sequence that attains it, in `ℓ`.
    pub sequence: Vec<f64>,
    /// A bound on what the grid adds to the minimum over all sequences, in `m²`.
    pub grid_error: f64,
}

impl GridLine<'static> {
    /// Returns the valleys of Section 5 along the axis, from 0 to `4π`, with 800 intervals; the
    /// rule reads at the fraction `theta`.
    ///
    /// In the plane the minima are the same: setting `x₂ = 0` everywhere keeps `H = f(x₁)² I` at
    /// the nodes and shortens the chords.
    #[must_use]
    pub fn over_the_valleys(theta: f64) -> Self {
        Self {
            ends: [0.0, 4.0 * std::f64::consts::PI],
            gram: &|x| (2.0 - x.cos()).powi(2),
            constants: Bounded::<2>::constants(&Valleys),
            theta,
            intervals: 800,
        }
    }
}

impl GridLine<'_> {
    fn step(&self) -> f64 {
        (self.ends[1] - self.ends[0]) / self.intervals as f64
    }

    /// Returns how far a sequence with energy at most `upper` may leave `[a, b]`.
    fn reach(&self, upper: f64) -> f64 {
        0.5 * ((upper / self.constants.c1()).sqrt() - (self.ends[1] - self.ends[0])).max(0.0)
    }

    /// Returns the minima for `N = 1, …, last`. For each of these `N`, some admissible sequence
    /// must have an energy of at most `upper`.
    ///
    /// # Panics
    ///
    /// If the constants have no `M_H`.
    #[must_use]
    pub fn minima(&self, last: usize, upper: f64) -> Vec<GridMinimum> {
        let h = self.step();
        let margin = (self.reach(upper) / h).ceil() as usize;
        let count = self.intervals + 2 * margin + 1;
        let (start, end) = (margin, margin + self.intervals);
        let x = |k: usize| self.ends[0] + (k as f64 - margin as f64) * h;
        // Both rules read H on the grid halved: at x + (y − x)/2 or at x.
        let gram: Vec<f64> =
            (0..2 * count - 1).map(|k| (self.gram)(x(0) + 0.5 * h * k as f64)).collect();
        let node = |from: usize, to: usize| {
            if self.theta == 0.0 { 2 * from } else { from + to }
        };
        let mut value = vec![f64::INFINITY; count];
        value[start] = 0.0;
        let mut came_from: Vec<Vec<u32>> = Vec::new();
        let mut minima = Vec::new();
        for n in 1..=last {
            let mut next = vec![f64::INFINITY; count];
            let mut from = vec![0_u32; count];
            for to in 0..count {
                for k in 0..count {
                    let steps = to as f64 - k as f64;
                    let cost = value[k] + gram[node(k, to)] * steps * steps;
                    if cost < next[to] {
                        (next[to], from[to]) = (cost, k as u32);
                    }
                }
            }
            value = next;
            came_from.push(from);
            let mut sequence = vec![end];
            for from in came_from.iter().rev() {
                sequence.push(from[sequence[sequence.len() - 1]] as usize);
            }
            sequence.reverse();
            let sequence: Vec<f64> = sequence.into_iter().map(x).collect();
            let energy = n as f64 * h * h * value[end];
            minima.push(GridMinimum { energy, grid_error: self.grid_error(n, upper), sequence });
        }
        minima
    }

    /// The bound of the module's doc. For a minimiser, `Σ Δ² ≤ U/(N c₁)` and
    /// `Σ |Δ| ≤ (U/c₁)^{1/2}`.
    fn grid_error(&self, n: usize, upper: f64) -> f64 {
        let (h, constants, n) = (self.step(), self.constants, n as f64);
        let squares = upper / (n * constants.c1());
        let lengths = (upper / constants.c1()).sqrt();
        let m_h = constants.m_h().expect("the constants have M_H");
        // Σ (|Δ| + h) and Σ (|Δ| + h)².
        let (first, second) = (lengths + n * h, squares + 2.0 * h * lengths + n * h * h);
        0.5 * n
            * h
            * h
            * (2.0 * constants.c2() * n + 2.0 * constants.l_h() * first + 0.25 * m_h * second)
    }
}
