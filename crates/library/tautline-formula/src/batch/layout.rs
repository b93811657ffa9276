//! `Layout`: which row of a batch holds what.

use crate::program::{Register, Registers};

/// Which quantities of a metric to compute.
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

/// The registers that hold the rows of a batch. A list is empty if the [`Kind`] does not compute
/// it.
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
    /// Numbers that are all positive and finite where `H` is finite and positive definite.
    pub positive: Vec<Register>,
    /// The entries `(i, j)` and `(j, i)`, together with `(i, i)` and `(j, j)`.
    pub halves: Vec<[Register; 4]>,
}

impl Layout {
    /// Returns whether `H` is a Gram matrix in the first `count` lanes.
    pub(crate) fn is_metric(&self, registers: &Registers, count: usize) -> bool {
        let mut is_bad = false;
        for &register in &self.positive {
            for &pivot in &registers.row(register)[..count] {
                // NaN counts as bad. There are no branches.
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

/// Returns whether two mirrored entries agree to within the tolerance of
/// [`is_gram`](tautline_metrics::is_gram).
fn is_symmetric([above, below]: [f64; 2], [one, other]: [f64; 2]) -> bool {
    let scale = one.abs().sqrt() * other.abs().sqrt();
    above == below || (above - below).abs() <= 1e-12 * scale.max(above.abs())
}
