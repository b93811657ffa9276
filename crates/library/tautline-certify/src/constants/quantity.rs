//! `Quantity`: which constant of a metric.

use std::fmt;

/// One of the constants of a metric that the theorems use.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Quantity {
    /// `c₁`, the least eigenvalue of `H`, in `m²/ℓ²`.
    C1,
    /// `c₂`, the greatest eigenvalue of `H`, in `m²/ℓ²`.
    C2,
    /// `L_H`, the largest `‖DH[v]‖` over unit vectors `v`, in `m²/ℓ³`.
    LH,
    /// `M_H`, the largest `‖D²H[v, w]‖` over unit vectors `v` and `w`, in `m²/ℓ⁴`.
    MH,
}

impl Quantity {
    /// All four constants.
    pub const ALL: [Quantity; 4] = [Quantity::C1, Quantity::C2, Quantity::LH, Quantity::MH];
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Quantity::C1 => "c1",
            Quantity::C2 => "c2",
            Quantity::LH => "L_H",
            Quantity::MH => "M_H",
        })
    }
}
