//! The order of convergence of a sequence of errors, as a slope of logarithms.

/// Returns the slope of the least-squares line through `(log x, log error)`.
#[must_use]
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let logarithms: Vec<(f64, f64)> =
        points.iter().map(|&(x, error)| (x.ln(), error.ln())).collect();
    let count = logarithms.len() as f64;
    let mean_x = logarithms.iter().map(|p| p.0).sum::<f64>() / count;
    let mean_y = logarithms.iter().map(|p| p.1).sum::<f64>() / count;
    let covariance: f64 = logarithms.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum();
    covariance / logarithms.iter().map(|p| (p.0 - mean_x).powi(2)).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::slope;

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let points = [1.0, 2.0, 8.0, 64.0].map(|n: f64| (n, 3.0 * n.powf(-1.5)));
        assert!((slope(&points) + 1.5).abs() < 1e-14);
    }
}
