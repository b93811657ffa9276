//! Series: their coefficients, and Horner's scheme with an error bound.

/// The unit roundoff `u = 2⁻⁵³`: `fl(a ∘ b) = (a ∘ b)(1 + δ)` with `|δ| ≤ u` for each of the
/// operations, unless it under- or overflows.
pub(super) const U: f64 = f64::EPSILON / 2.0;

/// The value of `Σ cⱼ wʲ` by Horner's scheme.
///
/// Needs: `cⱼ > 0`, each coefficient correctly rounded, `|w cⱼ₊₁| ≤ q cⱼ` for all `j` with a
/// `q < 1`, and no underflow, that is `w = 0` or `|w| > 2⁻²⁰⁰` here. The caller accounts for the
/// rounding of `w` and for truncation.
///
/// **The error is at most `2.01 u c₀ / (1 − q)²`.** Let `sⱼ = Σ_{i≥j} cᵢ wⁱ⁻ʲ`, so
/// `|sⱼ| ≤ cⱼ / (1 − q)`. The computed one is `fl(ĉⱼ + fl(w ŝⱼ₊₁))`, so to first order in `u` its
/// error `Eⱼ` obeys
///
/// `Eⱼ ≤ |w| Eⱼ₊₁ + u |w sⱼ₊₁| + u |sⱼ| + u cⱼ ≤ |w| Eⱼ₊₁ + u cⱼ (q/(1−q) + 1/(1−q) + 1)`,
///
/// where the bracket is `2/(1 − q)`. With `|w|ʲ cⱼ ≤ qʲ c₀` the sum over `j` gives
/// `E₀ ≤ 2 u c₀ / (1 − q)²`; the 2.01 covers the higher orders, less than `(1 + u)⁴⁰` in total.
#[inline]
pub(super) fn horner<const N: usize>(w: f64, coefficients: &[f64; N]) -> f64 {
    let mut s = coefficients[N - 1];
    for j in (0..N - 1).rev() {
        s = coefficients[j] + w * s;
    }
    s
}

/// `1/(first + step j)!` for `j < N`. The factorials up to 22! are doubles, so each quotient is
/// correctly rounded.
pub(super) const fn reciprocals_of_factorials<const N: usize>(first: u8, step: u8) -> [f64; N] {
    let mut coefficients = [0.0; N];
    let (mut n, mut factorial, mut j) = (1, 1.0, 0);
    while j < N {
        while n < first + step * j as u8 {
            n += 1;
            factorial *= n as f64;
        }
        assert!(n <= 22, "a factorial that is no double");
        coefficients[j] = 1.0 / factorial;
        j += 1;
    }
    coefficients
}

/// `numerator/(2j + 3)` for `j < N`, correctly rounded.
pub(super) const fn over_odd_numbers<const N: usize>(numerator: f64) -> [f64; N] {
    let mut coefficients = [0.0; N];
    let mut j = 0;
    while j < N {
        coefficients[j] = numerator / (2 * j + 3) as f64;
        j += 1;
    }
    coefficients
}
