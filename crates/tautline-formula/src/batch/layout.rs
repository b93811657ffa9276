//! `Layout`: which row holds what.

use crate::program::{Register, Registers};

/// What to compute of a metric.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `dᵀHd`.
    Square,
    /// `dᵀHd`, and whether `H` is finite, symmetric and positive definite.
    Checked,
    /// `dᵀHd`, `Hd` and `Gₖ = dᵀ ∂ₖH d`.
    Momentum,
    /// `H`, `Gₖ`, `Pᵢₖ = (∂ₖH d)ᵢ` and `Qₖₗ = dᵀ ∂ₖ∂ₗH d`.
    Contraction,
}

/// The registers that hold the rows of a batch; empty for what a [`Kind`] does not compute.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Layout {
    /// `dᵀHd`.
    pub square: Vec<Register>,
    /// `Hd`.
    pub momentum: Vec<Register>,
    /// `G`.
    pub slope: Vec<Register>,
    /// `H`, row by row.
    pub gram: Vec<Register>,
    /// `P`, row by row.
    pub turn: Vec<Register>,
    /// `Q`, row by row.
    pub bend: Vec<Register>,
    /// Positive and finite where `H` is finite and positive definite.
    pub positive: Vec<Register>,
    /// Entries `(i, j)` and `(j, i)`, with `(i, i)` and `(j, j)`.
    pub halves: Vec<[Register; 4]>,
}

impl Layout {
    /// Whether `H` is a Gram matrix in the first `count` lanes.
    pub(crate) fn is_metric(&self, registers: &Registers, count: usize) -> bool {
        let mut is_bad = false;
        for &register in &self.positive {
            for &pivot in &registers.row(register)[..count] {
                // NaN is bad; no branches.
                is_bad |= !(pivot > 0.0 && pivot <= f64::MAX);
            }
        }
        !is_bad
            && self.halves.iter().all(|halves| {
                let [above, below, one, other] = halves.map(|register| registers.row(register));
                (0..count)
                    .all(|lane| is_symmetric([above[lane], below[lane]], [one[lane], other[lane]]))
            })
    }
}

/// Whether two mirrored entries agree to the tolerance of [`is_gram`](tautline_metrics::is_gram).
fn is_symmetric([above, below]: [f64; 2], [one, other]: [f64; 2]) -> bool {
    let scale = one.abs().sqrt() * other.abs().sqrt();
    above == below || (above - below).abs() <= 1e-12 * scale.max(above.abs())
}
