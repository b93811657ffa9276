//! The product of nonnegative factors, without spurious overflow.

/// Returns the product of `factors`, each in `[0, ∞]`. The product is `0` if one of them is `0`,
/// even if another is infinite, because `∞` here means a finite number too large for `f64`.
///
/// The product overflows or underflows only if the exact product does, whatever the order of the
/// factors. Each factor contributes one rounding.
pub(crate) fn product<const K: usize>(mut factors: [f64; K]) -> f64 {
    if factors.contains(&0.0) {
        return 0.0;
    }
    factors.sort_unstable_by(f64::total_cmp);
    let mut left = factors.as_slice();
    let mut value = 1.0;
    // While the product is above 1, multiply by the smallest remaining factor; if that factor is
    // above 1 too, all the others are, and the product only increases from there. While the product
    // is below 1, do the same with the largest factor.
    while let Some((smallest, others)) = left.split_first() {
        if value > 1.0 {
            value *= smallest;
            left = others;
        } else if let Some((largest, others)) = left.split_last() {
            value *= largest;
            left = others;
        }
    }
    value
}

#[cfg(test)]
mod tests {
    use super::product;

    #[test]
    fn zero_times_infinity_is_zero() {
        assert_eq!(product([0.0, f64::INFINITY]), 0.0);
        assert_eq!(product([f64::INFINITY, 1e-300, -0.0]).to_bits(), 0);
        assert_eq!(product([f64::INFINITY, 5e-324]), f64::INFINITY);
        assert_eq!(product([]), 1.0);
    }

    #[test]
    fn partial_products_of_a_finite_product_stay_finite() {
        // Multiplied from left to right, these factors would pass through ∞ or 0.
        let close = |product: f64, expected: f64| {
            // There are at most eight roundings of 2⁻⁵³ each, and the roundings of the eight
            // decimals.
            assert!((product / expected - 1.0).abs() < 2e-15, "{product:e} for {expected:e}");
        };
        close(product([1e300, 1e300, 1e-300, 1e-300]), 1.0);
        close(product([1e-300, 1e-300, 1e300, 1e300]), 1.0);
        close(product([1e200, 1e200, 1e-100]), 1e300);
        let small = 1e-100;
        close(product([1e150, small, 1e160, small, 1e170, small, small, small]), 1e-20);
        assert_eq!(product([1e200, 1e200, 1e-50]), f64::INFINITY);
        assert_eq!(product([1e-200, 1e-200, 1e50]), 0.0);
    }
}
