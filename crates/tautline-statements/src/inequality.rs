//! `Inequality`: one comparison that a statement makes, with its two numbers.

/// The unit of a number: `ℓ^ell m^m`, with coordinates in `ℓ` and Riemannian lengths in `m`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Unit {
    /// The exponent of the unit of coordinates.
    pub ell: i32,
    /// The exponent of the unit of length.
    pub m: i32,
}

impl Unit {
    /// A pure number.
    pub const NONE: Unit = Unit { ell: 0, m: 0 };
    /// Coordinates and their derivatives in time, `ℓ`.
    pub const COORDINATE: Unit = Unit { ell: 1, m: 0 };
    /// Riemannian lengths and speeds, `m`.
    pub const LENGTH: Unit = Unit { ell: 0, m: 1 };
    /// Energies and squared lengths, `m²`.
    pub const ENERGY: Unit = Unit { ell: 0, m: 2 };
    /// `c₁`, `c₂` and the eigenvalues of `H`, `m²/ℓ²`.
    pub const GRAM: Unit = Unit { ell: -2, m: 2 };
    /// `L_H` and the first derivatives of `H`, `m²/ℓ³`.
    pub const GRAM_SLOPE: Unit = Unit { ell: -3, m: 2 };
    /// `M_H` and the second derivatives of `H`, `m²/ℓ⁴`.
    pub const GRAM_CURVATURE: Unit = Unit { ell: -4, m: 2 };
    /// Christoffel symbols, `1/ℓ`.
    pub const CHRISTOFFEL: Unit = Unit { ell: -1, m: 0 };

    /// Returns the number that 1 of this unit becomes where the unit of coordinates is divided
    /// by `ell` and that of length by `m`.
    #[must_use]
    pub fn factor(self, ell: f64, m: f64) -> f64 {
        ell.powi(self.ell) * m.powi(self.m)
    }
}

/// Whether a statement says it, or we do besides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// The statement says it; one of the paper, perhaps, only if it is repaired.
    Stated,
    /// A sharper form that the statement does not have: a companion, which a wrong program has
    /// more trouble to satisfy.
    Sharper,
    /// Two ways to write one formula. No case can contradict it, only a slip of the program: it is
    /// judged as the others are, but is no evidence of the statement, nor of its sharpness.
    Identity,
}

/// `observed ≤ bound`, for one case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inequality {
    /// What is compared, as a formula.
    pub claim: &'static str,
    /// Whether it is stated, or a companion.
    pub source: Source,
    /// The unit of the three numbers below.
    pub unit: Unit,
    /// The left side.
    pub observed: f64,
    /// The right side.
    pub bound: f64,
    /// What is granted to rounding and to the errors of quadratures, besides the bound.
    pub granted: f64,
}

impl Inequality {
    /// Returns whether `observed ≤ bound` up to what is granted; `false` for NaN.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.observed <= self.bound + self.granted
    }

    /// Returns whether the numbers could have contradicted the claim: the bound is finite, what is
    /// observed can be told from 0, and the two sides are not the same formula.
    ///
    /// A gap that vanishes identically, as that of a length does where every curve has the same,
    /// is at most any bound.
    #[must_use]
    pub fn could_fail(&self) -> bool {
        let told = self.observed.abs() > self.granted;
        self.source != Source::Identity && self.bound < f64::INFINITY && told
    }

    /// Returns the overestimation `bound / observed`, a pure number: 1 where the bound is attained,
    /// less where it is violated.
    ///
    /// `∞` where nothing can be told: the observed number is negative, zero, or so small that
    /// what is granted is a percent of it.
    #[must_use]
    pub fn overestimation(&self) -> f64 {
        if self.observed > 0.0 && self.granted <= 0.01 * self.observed {
            self.bound / self.observed
        } else {
            f64::INFINITY
        }
    }
}

impl std::fmt::Display for Inequality {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "{}: {:.15e} against {:.15e}, with {:e} granted",
            self.claim, self.observed, self.bound, self.granted
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Inequality, Source, Unit};

    fn inequality(observed: f64, bound: f64) -> Inequality {
        Inequality {
            claim: "a ≤ b",
            source: Source::Stated,
            unit: Unit::NONE,
            observed,
            bound,
            granted: 1e-3,
        }
    }

    #[test]
    fn nan_on_either_side_does_not_hold() {
        assert!(inequality(1.0, 1.0).holds() && inequality(1.0005, 1.0).holds());
        assert!(!inequality(1.002, 1.0).holds());
        assert!(!inequality(f64::NAN, 1.0).holds() && !inequality(1.0, f64::NAN).holds());
    }

    #[test]
    fn overestimation_is_told_only_of_what_is_seen() {
        assert_eq!(inequality(2.0, 3.0).overestimation(), 1.5);
        assert_eq!(inequality(0.09, 3.0).overestimation(), f64::INFINITY);
        assert_eq!(inequality(-2.0, 3.0).overestimation(), f64::INFINITY);
    }

    /// Of NaN nothing is told, but it does not hold either.
    #[test]
    fn what_cannot_be_told_from_zero_or_has_no_bound_could_not_fail() {
        assert!(inequality(0.5, 1.0).could_fail() && inequality(-0.5, 0.0).could_fail());
        assert!(!inequality(1e-3, 1.0).could_fail() && !inequality(-1e-4, 0.0).could_fail());
        assert!(!inequality(0.5, f64::INFINITY).could_fail());
        assert!(!Inequality { source: Source::Identity, ..inequality(0.5, 0.5) }.could_fail());
    }

    #[test]
    fn units_scale_by_their_powers() {
        assert_eq!(Unit::GRAM_SLOPE.factor(2.0, 4.0), 2.0);
        assert_eq!(Unit::NONE.factor(2.0, 4.0), 1.0);
    }
}
