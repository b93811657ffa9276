//! Gauss's rule with two nodes.

use crate::{Node, Rule};

impl Rule {
    /// Gauss's rule with two nodes, at the fractions `1/2 ± 1/√12` of the chord.
    ///
    /// On smooth data its discrete energy differs from that of the reconstructed curve by `O(N⁻⁴)`, so
    /// that its minimum is above `d²` up to that order: `N² (E_N − d²)` tends to `1/12 ∫ γ''ᵀHγ''`.
    pub const GAUSS_TWO: Rule = Rule::new(
        "gauss_two",
        &[
            Node { fraction: 0.211_324_865_405_187_12, weight: 0.5 },
            Node { fraction: 0.788_675_134_594_812_9, weight: 0.5 },
        ],
        2,
    );
}
