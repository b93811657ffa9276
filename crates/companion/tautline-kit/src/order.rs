//! The observed order of convergence, which is `q` for errors that fall like `N⁻ᑫ`.

use tautline_statements::slope;

/// Returns the order, which is minus the [`slope`] of the errors over `N`.
pub(crate) fn order(errors: &[(usize, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = errors.iter().map(|&(n, error)| (n as f64, error)).collect();
    -slope(&points)
}

/// Returns the median; for an even number of values, it is the lower of the two middle ones.
pub(crate) fn median(mut numbers: Vec<f64>) -> Option<f64> {
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len().saturating_sub(1) / 2).copied()
}

#[cfg(test)]
mod tests {
    use super::{median, order};

    #[test]
    fn the_order_of_a_power_is_its_exponent() {
        let errors = [1, 2, 8, 64].map(|n| (n, 3.0 * (n as f64).powf(-1.5)));
        assert!((order(&errors) - 1.5).abs() < 1e-14);
    }

    #[test]
    fn the_median_is_in_the_middle() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 2.0, 3.0]), Some(2.0));
        assert_eq!(median(vec![]), None);
    }
}
