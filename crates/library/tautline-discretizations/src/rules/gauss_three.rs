//! Gauss's rule with three nodes.

use crate::{Node, Rule};

impl Rule {
    /// Gauss's rule with three nodes, in the middle of the chord with the weight `4/9` and at the
    /// fractions `1/2 ± (3/20)^{1/2}` with `5/18`.
    ///
    /// On smooth data its discrete energy differs from that of the reconstructed curve by `O(N⁻⁶)`.
    pub const GAUSS_THREE: Rule = Rule::new(
        "gauss_three",
        &[
            Node { fraction: 0.112_701_665_379_258_31, weight: 5.0 / 18.0 },
            Node { fraction: 0.5, weight: 8.0 / 18.0 },
            Node { fraction: 0.887_298_334_620_741_7, weight: 5.0 / 18.0 },
        ],
        2,
    );
}
