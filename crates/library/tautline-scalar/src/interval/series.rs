//! The coefficients of series, and Horner's scheme with an error bound.

/// The unit roundoff `u = 2⁻⁵³`. Each operation satisfies `fl(a ∘ b) = (a ∘ b)(1 + δ)` with
/// `|δ| ≤ u`, unless it overflows or underflows.
pub(super) const U: f64 = f64::EPSILON / 2.0;

/// Returns the value of `Σ cⱼ wʲ`, computed by Horner's scheme.
///
/// Needs: each coefficient `cⱼ > 0` is correctly rounded; `|w cⱼ₊₁| ≤ q cⱼ` for all `j` and some
/// `q < 1`; and there is no underflow, which here means `w = 0` or `|w| > 2⁻²⁰⁰`. The caller
/// accounts for the rounding of `w` and for truncation.
///
/// **The error is at most `2.01 u c₀ / (1 − q)²`.** Let `sⱼ = Σ_{i≥j} cᵢ wⁱ⁻ʲ`, so that
/// `|sⱼ| ≤ cⱼ / (1 − q)`. The computed value is `fl(ĉⱼ + fl(w ŝⱼ₊₁))`, so to first order in `u` its
/// error `Eⱼ` satisfies
///
/// `Eⱼ ≤ |w| Eⱼ₊₁ + u |w sⱼ₊₁| + u |sⱼ| + u cⱼ ≤ |w| Eⱼ₊₁ + u cⱼ (q/(1−q) + 1/(1−q) + 1)`,
///
/// where the bracket equals `2/(1 − q)`. With `|w|ʲ cⱼ ≤ qʲ c₀`, summation over `j` gives
/// `E₀ ≤ 2 u c₀ / (1 − q)²`. The constant 2.01 covers the higher orders, which are less than
/// `(1 + u)⁴⁰` in total.
#[inline]
pub(super) fn horner<const N: usize>(w: f64, coefficients: &[f64; N]) -> f64 {
    let mut s = coefficients[N - 1];
    for j in (0..N - 1).rev() {
        s = coefficients[j] + w * s;
    }
    s
}

/// Returns `1/(first + step j)!` for `j < N`. The factorials up to 22! are doubles, so each
/// quotient is correctly rounded.
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

/// Returns `numerator/(2j + 3)` for `j < N`, correctly rounded.
pub(super) const fn over_odd_numbers<const N: usize>(numerator: f64) -> [f64; N] {
    let mut coefficients = [0.0; N];
    let mut j = 0;
    while j < N {
        coefficients[j] = numerator / (2 * j + 3) as f64;
        j += 1;
    }
    coefficients
}
