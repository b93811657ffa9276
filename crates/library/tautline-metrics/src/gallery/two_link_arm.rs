//! A planar robot arm with two links, measured by its kinetic energy.

use std::f64::consts::SQRT_2;

use nalgebra::{SMatrix, SVector, matrix};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, nonnegative, positive},
};
use crate::{Bounded, Constants, Metric};

/// One link of a [`TwoLinkArm`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The mass of the link, nonnegative.
    pub mass: f64,
    /// The distance between its two joints, nonnegative. For the second link it does not matter.
    pub length: f64,
    /// The distance between its centre of mass and the joint before it, nonnegative.
    pub centre: f64,
    /// The moment of inertia about the centre of mass, nonnegative.
    pub inertia: f64,
}

/// The inertia of an arm without gravity, with joint angles `q₁`, `q₂` in radians, where `q₂` is
/// relative to the first link:
///
/// ```text
/// H(q) = [[A + 2B cos q₂, C + B cos q₂], [C + B cos q₂, C]],    kinetic energy ½ q̇ᵀ H(q) q̇
/// ```
///
/// Here `ℓ` is the radian, and `m²` is the unit of a moment of inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "robot")]
pub struct TwoLinkArm {
    a: f64,
    b: f64,
    c: f64,
    constants: Constants,
}

impl TwoLinkArm {
    /// Returns the arm with the moments of inertia `A`, `B`, `C`.
    ///
    /// # Errors
    ///
    /// [`GalleryError::SingularArm`] unless `C (A − C) − B² > 0`; a [`GalleryError`] that names the
    /// parameter if one of them is not finite, or if `C` is not positive.
    pub fn new(a: f64, b: f64, c: f64) -> Result<Self, GalleryError> {
        finite("A", a)?;
        finite("B", b)?;
        positive("C", c)?;
        // det H = C (A − C) − B² cos² q₂ and trace H = A + C + 2B cos q₂. Where B cos q₂ = |B|, the
        // determinant is least and the trace T is greatest. Hence both eigenvalues,
        // ½ (T + √(T² − 4 det)) and 2 det / (T + √(T² − 4 det)), are extreme there.
        let determinant = c * (a - c) - b * b;
        if !(determinant > 0.0) {
            return Err(GalleryError::SingularArm { determinant });
        }
        let trace = a + c + 2.0 * b.abs();
        let c2 = 0.5 * (trace + (trace * trace - 4.0 * determinant).sqrt());
        // DH[w] = −w₂ B sin q₂ [[2, 1], [1, 0]] and D²H[w, w] = −w₂² B cos q₂ [[2, 1], [1, 0]]; the
        // matrix has the eigenvalues 1 ± √2.
        let l_h = b.abs() * (1.0 + SQRT_2);
        let constants = Constants::new(determinant / c2, c2, l_h)?.with_m_h(l_h)?;
        Ok(Self { a, b, c, constants })
    }

    /// Returns the arm with the given links. If they have masses `mᵢ`, inertias `Iᵢ` and centres of
    /// mass `rᵢ`, and the first link has the length `l`, then
    ///
    /// ```text
    /// A = I₁ + I₂ + m₁ r₁² + m₂ (l² + r₂²),    B = m₂ l r₂,    C = I₂ + m₂ r₂²
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`TwoLinkArm::new`], and [`GalleryError::Negative`] with the parameter of a
    /// link.
    pub fn from_links(first: Link, second: Link) -> Result<Self, GalleryError> {
        for link in [first, second] {
            nonnegative("mass", link.mass)?;
            nonnegative("length", link.length)?;
            nonnegative("centre", link.centre)?;
            nonnegative("inertia", link.inertia)?;
        }
        let c = second.inertia + second.mass * second.centre.powi(2);
        let shoulder =
            first.inertia + first.mass * first.centre.powi(2) + second.mass * first.length.powi(2);
        Self::new(shoulder + c, second.mass * first.length * second.centre, c)
    }
}

impl Metric<2> for TwoLinkArm {
    #[inline]
    fn gram<S: Scalar>(&self, q: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let bend = q[1].cos() * self.b;
        let off = bend + self.c;
        matrix![bend * 2.0 + self.a, off; off, S::constant(self.c)]
    }
}

impl Bounded<2> for TwoLinkArm {
    /// All constants are attained: `c₁` and `c₂` are the eigenvalues for the stretched arm
    /// (`q₂ = 0`; folded if `B < 0`), and `L_H = M_H = |B| (1 + √2)`.
    fn constants(&self) -> Constants {
        self.constants
    }
}
