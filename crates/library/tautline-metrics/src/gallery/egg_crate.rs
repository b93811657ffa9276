//! An egg crate in space: the graph of `f(x) = a (sin kx₁ + sin kx₂)`.

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use nalgebra::{SMatrix, SVector, matrix};
use tautline_scalar::Scalar;

use super::{
    GalleryError,
    error::{finite, positive},
};
use crate::{Bounded, Constants, KnownDistance, Metric, quadrature::integrate};

/// `H(x) = I + ∇f ∇fᵀ` with `f = a (sin kx₁ + sin kx₂)`, in the plane. This is the metric of the
/// graph of `f` in `R³`, which has peaks and pits in a square pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EggCrate {
    amplitude: f64,
    wave_number: f64,
    constants: Constants,
}

impl EggCrate {
    /// Returns the egg crate with amplitude `a` in `ℓ`, of either sign, and wave number `k > 0` in
    /// `1/ℓ` (here `m` is the same as `ℓ`, the unit of the coordinates).
    ///
    /// # Errors
    ///
    /// [`GalleryError`] with the parameter that is out of range.
    pub fn new(amplitude: f64, wave_number: f64) -> Result<Self, GalleryError> {
        let k = positive("wave number", wave_number)?;
        let slope2 = (finite("amplitude", amplitude)? * k).powi(2);
        // Write p, q for the cosines of kx₁ and kx₂, and s and t for their sines. Let z = (b, c)
        // and w be unit vectors, B = bp, C = cq and P = B² + C².
        //
        // zᵀ DH[w] z = 2 (z·g) (z·Dg w) = −2a²k³ (B + C) (b s w₁ + c t w₂). The last factor is at
        // most √(b²s² + c²t²) = √(1 − P), and (B + C)² ≤ 2P. So the form is at most
        // 2a²k³ √(2P (1 − P)), hence √2 a²k³, which is attained where B = C and P = ½.
        let l_h = SQRT_2 * slope2 * k;
        // zᵀ D²H[w, w] z = 2a²k⁴ ((b s w₁ + c t w₂)² − (B w₁² + C w₂²) (B + C)). As w₁² + w₂² = 1,
        // the product is a mean of B (B + C) and C (B + C), where B² + BC ≤ b² + |bc| ≤ (1 + √2)/2.
        // This is attained by w = (1, 0), p = q = 1 and b = cos π/8. In the other direction
        // (b s w₁ + c t w₂)² ≤ b²s² + c²t² = 1 − P, so the whole bracket is at most 1 − P − min(B
        // (B + C), C (B + C)) = 1 − P − BC − min(B², C²) ≤ 1.
        let m_h = (1.0 + SQRT_2) * slope2 * k * k;
        let constants = Constants::new(1.0, 1.0 + 2.0 * slope2, l_h)?.with_m_h(m_h)?;
        Ok(Self { amplitude, wave_number, constants })
    }

    /// Returns the length of the crest between two phases `Y = kx₂` on a line `kx₁ = (n + ½) π`, if
    /// the crest is provably minimal.
    fn along_crest(&self, n: f64, from: f64, to: f64) -> Option<f64> {
        let (low, high) = (from.min(to), from.max(to));
        let m = (low / PI).floor();
        let (up, down) = ((m + 1.0) * PI - high, low - m * PI);
        // In the square, the signs (−1)ⁿ of sin X and (−1)ᵐ of sin Y differ.
        if !(up >= 0.0 && (n + m).rem_euclid(2.0) == 1.0) {
            return None;
        }
        let span = high - low;
        let slope = self.amplitude * self.wave_number;
        let length = integrate(|y| (slope * y.cos()).hypot(1.0), low, high, 1e-15).value;
        let detour = PI.hypot(span).min(span + 2.0 * up).min(span + 2.0 * down);
        (length <= detour).then_some(length / self.wave_number)
    }
}

impl Metric<2> for EggCrate {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let slope = self.amplitude * self.wave_number;
        let p = (x[0] * self.wave_number).cos() * slope;
        let q = (x[1] * self.wave_number).cos() * slope;
        matrix![p.sqr() + 1.0, p * q; p * q, q.sqr() + 1.0]
    }
}

impl Bounded<2> for EggCrate {
    /// All constants are attained: `c₁ = 1`, `c₂ = 1 + 2a²k²` at `x = 0`, `L_H = √2 a²k³`, and
    /// `M_H = (1 + √2) a²k⁴` at `x = 0`.
    fn constants(&self) -> Constants {
        self.constants
    }
}

impl KnownDistance<2> for EggCrate {
    /// The distance is known in two cases; for other pairs the result is `None`. Let `X = kx₁` and
    /// `Y = kx₂`.
    ///
    /// On the straight lines `X + Y ∈ 2πZ` and `X − Y ∈ π + 2πZ` the height `f` vanishes. The
    /// distance is `|x − y|`, which is minimal since `H ≥ I`.
    ///
    /// On a symmetry line `X ∈ π/2 + πZ` (or `Y`), take two points of one of the open squares of
    /// side `π` where `sin X sin Y < 0`. The distance is the length `∫ √(1 + a²k² cos² Y) dx₂`, if
    /// it is at most the Euclidean length of the shortest way between the points that meets the
    /// boundary of the square. Then no curve that leaves the square is shorter. A shortest curve
    /// that stays in the square is a geodesic, and so is the symmetry line. The square is a disc of
    /// negative curvature (`a²k⁴ sin X sin Y / (1 + |∇f|²)²`), in which no two geodesics enclose a
    /// region, by the Gauss–Bonnet theorem. Hence the shortest curve is the symmetry line.
    fn distance(&self, x: &SVector<f64, 2>, y: &SVector<f64, 2>) -> Option<f64> {
        if x == y {
            return Some(0.0);
        }
        let k = self.wave_number;
        let [from, to] = [x * k, y * k];
        // Returns the n of the line `phase = offset + n period` on which both points lie, up to the
        // rounding of the phases. So close to the line its distance is right to rounding, since d
        // is √c₂-Lipschitz.
        let line = |u: f64, v: f64, period: f64, offset: f64| {
            let n = ((u - offset) / period).round();
            let on = |phase: f64, size: f64| {
                (phase - (offset + n * period)).abs() <= 4.0 * f64::EPSILON * size
            };
            let size = from.amax().max(to.amax());
            (on(u, size) && on(v, size)).then_some(n)
        };
        let flat = line(from[0] + from[1], to[0] + to[1], 2.0 * PI, 0.0)
            .or_else(|| line(from[0] - from[1], to[0] - to[1], 2.0 * PI, PI));
        if flat.is_some() {
            return Some((x - y).norm());
        }
        let crest = |i: usize, j: usize| {
            self.along_crest(line(from[i], to[i], PI, FRAC_PI_2)?, from[j], to[j])
        };
        crest(0, 1).or_else(|| crest(1, 0))
    }
}
