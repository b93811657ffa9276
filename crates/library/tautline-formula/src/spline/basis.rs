//! The B-splines that are not zero on one cell, and their blossoms.
//!
//! On a cell, with `t` from 0 to 1, a spline of degree `p` is a polynomial. It is a combination of
//! the `p + 1` coefficients that meet the cell, with weights that are B-splines. The weights of
//! degree `p` follow from those of degree `p − 1` by the recursion of de Boor, Cox and Mansfield:
//!
//! ```text
//! N_p[j](t) = ((t + p − j) N_{p−1}[j − 1](t) + (j + 1 − t) N_{p−1}[j](t)) / p,    N_0 = [1]
//! ```
//!
//! If each step of the recursion has its own `t`, the result is the *blossom*: symmetric, and
//! affine in each `t`. The value of the blossom at `p − j` times `a` and `j` times `b` is the
//! Bernstein coefficient number `j` of the polynomial on `[a, b]`.
//!
//! # Rounding
//!
//! The division by `p` is left out, so weights are `p!` times too large. What remains are sums of
//! products of non-negative numbers, for `t` in `[0, 1]`: nothing cancels. A factor such as `1 − t`
//! has a relative error of at most `u = 2⁻⁵³`. So `N_1` has the error `u`, and each further step
//! adds `3u`, for the factor, the product and the sum: `4u` for `N_2`, and `7u` for `N_3`.
//!
//! A product may also underflow, for `t < 2⁻³⁵⁰`. The weight, which is at most `6`, then has an
//! absolute error below `2⁻¹⁰⁷⁰`.

/// `p!`, by which weights of degree `p` are too large.
pub(crate) const FACTORIAL: [f64; 4] = [1.0, 1.0, 2.0, 6.0];

/// Returns the weights of degree 1.
#[inline]
pub(crate) fn linear(t: f64) -> [f64; 2] {
    [1.0 - t, t]
}

/// Returns twice the weights of degree 2, from those of degree 1.
#[inline]
pub(crate) fn quadratic([a, b]: [f64; 2], t: f64) -> [f64; 3] {
    [(1.0 - t) * a, (t + 1.0) * a + (2.0 - t) * b, t * b]
}

/// Returns six times the weights of degree 3, from twice those of degree 2.
#[inline]
pub(crate) fn cubic([a, b, c]: [f64; 3], t: f64) -> [f64; 4] {
    [(1.0 - t) * a, (t + 2.0) * a + (2.0 - t) * b, (t + 1.0) * b + (3.0 - t) * c, t * c]
}

/// Returns `p!` times the weights of the blossom of degree `p ≤ 3` at the first `p` of these
/// points, followed by zeros.
#[inline]
pub(crate) fn blossom(degree: usize, [r, s, t]: [f64; 3]) -> [f64; 4] {
    let first = linear(r);
    match degree {
        0 => [1.0, 0.0, 0.0, 0.0],
        1 => [first[0], first[1], 0.0, 0.0],
        2 => {
            let [a, b, c] = quadratic(first, s);
            [a, b, c, 0.0]
        }
        _ => cubic(quadratic(first, s), t),
    }
}

/// Returns the first difference.
#[inline]
pub(crate) fn difference([a, b, c, d]: [f64; 4]) -> [f64; 3] {
    [b - a, c - b, d - c]
}

/// Returns the difference of first differences.
#[inline]
pub(crate) fn second_difference([a, b, c]: [f64; 3]) -> [f64; 2] {
    [b - a, c - b]
}

/// Returns the sum of the products.
#[inline]
pub(crate) fn dot<const N: usize>(weights: [f64; N], x: [f64; N]) -> f64 {
    let mut sum = weights[0] * x[0];
    for j in 1..N {
        sum += weights[j] * x[j];
    }
    sum
}
