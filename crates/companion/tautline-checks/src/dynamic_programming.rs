//! Finds the global minimum of a discrete energy on the line by dynamic programming, over all
//! sequences of grid points. This includes sequences that jump across valleys.
//!
//! One chord has the cost `c(x, y) = H(x + θ(y − x)) (y − x)²`, so that `E_N = N Σ c(xₙ, xₙ₊₁)`.
//! The least cost `Vₙ(y)` of `n` chords from the start to `y` satisfies
//! `Vₙ₊₁(y) = minₓ Vₙ(x) + c(x, y)`. Since `V` does not depend on `N`, one pass gives the minima
//! for all `N` up to the last.
//!
//! # How far the grid has to reach
//!
//! A sequence that leaves `[a, b]` by `r` satisfies `Σ |xₙ₊₁ − xₙ| ≥ b − a + 2r`, hence by the
//! Cauchy–Schwarz inequality `E_N ≥ c₁ (b − a + 2r)²`. If an admissible sequence has energy `U`,
//! any better sequence leaves `[a, b]` by at most `r ≤ (√(U/c₁) − (b − a))/2`.
//!
//! # How large the error of the grid is
//!
//! Let `x` be a minimiser, and let `δ` move its inner points to the grid, so that `|δₙ| ≤ h/2`. To
//! first order this does not change the energy. The second derivative of `N c`, the contribution of
//! one chord, in the direction of `δ` is
//!
//! ```text
//! N (2H v² + 4 H′ Δ u v + H″ Δ² u²),    v = δₙ₊₁ − δₙ, |v| ≤ h;    u: δ at the node, |u| ≤ h/2
//! ```
//!
//! It is at most `N h² (2c₂ + 2 L_H |Δ| + M_H Δ²/4)`, where `|Δ|` grows by at most `h` as the
//! points move. Half of the sum over the chords bounds the change of the energy.

use tautline::{Bounded, Constants, gallery::Valleys};

/// A problem on the line from `a` to `b`, `a < b`, where the rule evaluates the Gram matrix at the
/// fraction `theta` of each chord.
pub struct GridLine<'a> {
    /// `a` and `b`, in `ℓ`.
    pub ends: [f64; 2],
    /// `H`, in `m²/ℓ²`.
    pub gram: &'a dyn Fn(f64) -> f64,
    /// The constants of `H`, with `M_H`.
    pub constants: Constants,
    /// Where the rule evaluates `H`: 0 for the left-endpoint rule, ½ for the trapezoidal rule.
    pub theta: f64,
    /// The number of grid intervals between the ends.
    pub intervals: usize,
}

/// The least energy on the grid.
#[derive(Clone, Debug, PartialEq)]
pub struct GridMinimum {
    /// The energy, in `m²`.
    pub energy: f64,
    /// A sequence that attains it, in `ℓ`.
    pub sequence: Vec<f64>,
    /// A bound on the amount by which the grid raises the minimum over all sequences, in `m²`.
    pub grid_error: f64,
}

impl GridLine<'static> {
    /// Returns the valleys of Section 5 along the axis, from 0 to `4π`, with 800 intervals. The
    /// rule evaluates `H` at the fraction `theta`.
    ///
    /// The minima in the plane are the same, since setting `x₂ = 0` everywhere keeps `H = f(x₁)² I`
    /// at the nodes and shortens the chords.
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

    /// Returns the largest distance by which a sequence with energy at most `upper` can leave
    /// `[a, b]`.
    fn reach(&self, upper: f64) -> f64 {
        0.5 * ((upper / self.constants.c1()).sqrt() - (self.ends[1] - self.ends[0])).max(0.0)
    }

    /// Returns the minima for `N = 1, …, last`. For each of these `N` there must be an admissible
    /// sequence with energy at most `upper`.
    ///
    /// # Panics
    ///
    /// Panics if the constants have no `M_H`.
    #[must_use]
    pub fn minima(&self, last: usize, upper: f64) -> Vec<GridMinimum> {
        let h = self.step();
        let margin = (self.reach(upper) / h).ceil() as usize;
        let count = self.intervals + 2 * margin + 1;
        let (start, end) = (margin, margin + self.intervals);
        let x = |k: usize| self.ends[0] + (k as f64 - margin as f64) * h;
        // Both rules evaluate H on the grid with half the step: at x + (y − x)/2 or at x.
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

    /// Evaluates the bound of the module's documentation. A minimiser satisfies `Σ Δ² ≤ U/(N c₁)`
    /// and `Σ |Δ| ≤ (U/c₁)^{1/2}`.
    fn grid_error(&self, n: usize, upper: f64) -> f64 {
        let (h, constants, n) = (self.step(), self.constants, n as f64);
        let squares = upper / (n * constants.c1());
        let lengths = (upper / constants.c1()).sqrt();
        let m_h = constants.m_h().expect("the constants have M_H");
        // These are bounds on Σ (|Δ| + h) and Σ (|Δ| + h)².
        let (first, second) = (lengths + n * h, squares + 2.0 * h * lengths + n * h * h);
        0.5 * n
            * h
            * h
            * (2.0 * constants.c2() * n + 2.0 * constants.l_h() * first + 0.25 * m_h * second)
    }
}
