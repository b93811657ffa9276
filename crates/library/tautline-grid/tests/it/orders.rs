//! Orders of convergence.

/// Returns the slope of the line through `(log h, log error)` with the least squares.
pub(crate) fn slope(errors: &[(f64, f64)]) -> f64 {
    let logs: Vec<(f64, f64)> = errors.iter().map(|(h, e)| (h.ln(), e.ln())).collect();
    let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / logs.len() as f64;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let (above, below) = logs.iter().fold((0.0, 0.0), |(above, below), p| {
        (above + (p.0 - x) * (p.1 - y), below + (p.0 - x).powi(2))
    });
    above / below
}

/// `e = 3 h²` on four spacings has the slope 2, up to some roundings of logarithms below 4.
#[test]
fn the_slope_of_a_power_is_its_exponent() {
    let errors: Vec<(f64, f64)> =
        [0.5, 0.25, 0.1, 0.05].iter().map(|h| (*h, 3.0 * h * h)).collect();
    assert!((slope(&errors) - 2.0).abs() < 1e-13, "{}", slope(&errors));
}
