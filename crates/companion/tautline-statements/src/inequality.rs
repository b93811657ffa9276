//! `Inequality`: one comparison of a statement, with its two numbers.

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

    /// Returns the factor by which a number in this unit grows if the unit of coordinates is
    /// divided by `ell` and the unit of length by `m`.
    #[must_use]
    pub fn factor(self, ell: f64, m: f64) -> f64 {
        ell.powi(self.ell) * m.powi(self.m)
    }
}

/// Where an inequality comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Source {
    /// It is from the statement, perhaps in its repaired form.
    Stated,
    /// It is a companion sharper than the statement, so that a wrong program is less likely to
    /// satisfy it.
    Sharper,
    /// It compares two ways to write one formula. Only a programming error violates it. It must
    /// hold, but it is no evidence for the statement or its sharpness.
    Identity,
}

/// `observed ≤ bound`, for one case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inequality {
    /// The formula.
    pub claim: &'static str,
    /// Where the inequality comes from.
    pub source: Source,
    /// The unit of the three numbers below.
    pub unit: Unit,
    /// The left side.
    pub observed: f64,
    /// The right side.
    pub bound: f64,
    /// The allowance for rounding and for errors of quadrature, added to the bound.
    pub granted: f64,
}

impl Inequality {
    /// Returns whether `observed ≤ bound + granted`; `false` for NaN.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.observed <= self.bound + self.granted
    }

    /// Returns whether the numbers could have contradicted the claim: the bound is finite, the
    /// observed number is distinguishable from 0, and the two sides are not the same formula.
    ///
    /// A gap that vanishes identically could not contradict its bound.
    #[must_use]
    pub fn could_fail(&self) -> bool {
        let visible = self.observed.abs() > self.granted;
        self.source != Source::Identity && self.bound < f64::INFINITY && visible
    }

    /// Returns the overestimation `bound / observed`, a pure number. It is 1 if the bound is
    /// attained, and less than 1 if the bound is violated.
    ///
    /// It is `∞` if the observed number is negative, zero, or so small that `granted` exceeds 1 %
    /// of it.
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
    fn overestimation_is_infinite_where_rounding_hides_the_number() {
        assert_eq!(inequality(2.0, 3.0).overestimation(), 1.5);
        assert_eq!(inequality(0.09, 3.0).overestimation(), f64::INFINITY);
        assert_eq!(inequality(-2.0, 3.0).overestimation(), f64::INFINITY);
    }

    #[test]
    fn a_number_near_zero_or_without_a_bound_could_not_fail() {
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
