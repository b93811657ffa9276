//! Simpson's rule.

use crate::{Node, Rule};

impl Rule {
    /// Simpson's rule: `H` at both ends and in the middle of the chord, with the weights `1/6`, `4/6`
    /// and `1/6`.
    ///
    /// On smooth data its discrete energy differs from that of the reconstructed curve by `O(N⁻⁴)`. Its
    /// minimum still has the error `O(N⁻²)`, since the chords are straight.
    pub const SIMPSON: Rule = Rule::new(
        "simpson",
        &[
            Node { fraction: 0.0, weight: 1.0 / 6.0 },
            Node { fraction: 0.5, weight: 4.0 / 6.0 },
            Node { fraction: 1.0, weight: 1.0 / 6.0 },
        ],
        2,
    );
}
