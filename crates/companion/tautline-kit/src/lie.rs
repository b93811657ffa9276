//! `Claim` and `Lie`: a constant that a metric claims, and a false claim.

/// One of the constants that a metric claims and the theorems use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Claim {
    /// The claim `c₁ ≤ λ_min(H)`, in `m²/ℓ²`.
    C1,
    /// The claim `λ_max(H) ≤ c₂`, in `m²/ℓ²`.
    C2,
    /// The claim `‖DH(x)[w]‖ ≤ L_H |w|`, in `m²/ℓ³`.
    LH,
    /// The claim `|uᵀ D²H(x)[w, w] u| ≤ M_H |w|² |u|²`, in `m²/ℓ⁴`.
    MH,
}

impl Claim {
    /// All four constants.
    pub const ALL: [Claim; 4] = [Claim::C1, Claim::C2, Claim::LH, Claim::MH];

    /// Returns the name in ASCII, as it is written in code.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Claim::C1 => "c1",
            Claim::C2 => "c2",
            Claim::LH => "L_H",
            Claim::MH => "M_H",
        }
    }

    /// Returns, in words, on which side of the best constant a valid one lies.
    pub(crate) fn side(self) -> &'static str {
        match self {
            Claim::C1 => "at most",
            _ => "at least",
        }
    }

    /// Returns the formula of the quantity that the constant bounds, at a point `x` in a unit
    /// direction `w`.
    #[must_use]
    pub fn formula(self) -> &'static str {
        match self {
            Claim::C1 | Claim::C2 => "wᵀ H(x) w",
            Claim::LH => "‖DH(x)[w]‖",
            Claim::MH => "‖D²H(x)[w, w]‖",
        }
    }
}

impl std::fmt::Display for Claim {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// A false claim about a constant, with a point and a direction that refute it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the metric claims {constant} = {claimed}, but {} = {found} at x = {point:?}{}",
    self.formula(), self.besides()
)]
pub struct Lie {
    /// The constant.
    pub constant: Claim,
    /// The value that the metric claims.
    pub claimed: f64,
    /// The value that was found, in the unit of the constant.
    pub found: f64,
    /// The point `x`.
    pub point: Vec<f64>,
    /// The direction `w`, of length 1.
    pub direction: Vec<f64>,
    /// The second point `y`, in this direction from `x`, if the value is a difference quotient.
    pub other: Option<Box<[f64]>>,
}

impl Lie {
    /// Returns the formula of the value that was found.
    #[must_use]
    pub fn formula(&self) -> &'static str {
        if self.other.is_some() { "‖H(x) − H(y)‖/|x − y|" } else { self.constant.formula() }
    }

    /// Returns the second variable of the formula, with its value.
    fn besides(&self) -> String {
        match &self.other {
            Some(other) => format!(" and y = {other:?}"),
            None => format!(" in the direction w = {:?}", self.direction),
        }
    }
}
