//! The order of a sequence of errors, as a slope on a log–log scale.

/// Returns the slope of the least-squares line through `(log N, −log error)`: `q` for errors
/// `N⁻ᑫ`.
pub(crate) fn order(errors: &[(usize, f64)]) -> f64 {
    let logarithms: Vec<[f64; 2]> =
        errors.iter().map(|&(n, error)| [(n as f64).ln(), -error.ln()]).collect();
    let count = logarithms.len() as f64;
    let mean = |k: usize| logarithms.iter().map(|p| p[k]).sum::<f64>() / count;
    let means = [mean(0), mean(1)];
    let moment =
        |k: usize| logarithms.iter().map(|p| (p[0] - means[0]) * (p[k] - means[k])).sum::<f64>();
    moment(1) / moment(0)
}

/// Returns the median; the lower one of an even number.
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
