//! Comparisons of computed numbers with expected ones.

use tautline_statements::slope;

use super::{Failure, Outcome, Tally};

/// Returns a failure unless `value` agrees with `expected` to within `tolerance`.
pub(crate) fn close(what: &str, value: f64, expected: f64, tolerance: f64) -> Outcome {
    if (value - expected).abs() <= tolerance {
        return Ok(Tally::default());
    }
    let message = format!("{what}: {value:.17e} is not {expected:.17e} up to {tolerance:.1e}");
    Err(Failure::new(message))
}

/// Returns a failure unless the slope of the points on logarithmic axes agrees with `expected` to
/// within `tilt`.
pub(crate) fn has_slope(what: &str, points: &[(f64, f64)], expected: f64, tilt: f64) -> Outcome {
    let slope = slope(points);
    if (slope - expected).abs() <= tilt {
        return Ok(Tally::default());
    }
    Err(Failure::new(format!("{what}: slope {slope} over {points:?}, not {expected}")))
}

#[cfg(test)]
mod tests {
    use super::{close, has_slope};

    #[test]
    fn a_distant_number_fails_and_so_does_nan() {
        assert!(close("one", 1.0 + 1e-9, 1.0, 1e-8).is_ok());
        assert!(close("one", 1.0 + 1e-7, 1.0, 1e-8).is_err());
        assert!(close("one", f64::NAN, 1.0, 1e-8).is_err());
    }

    #[test]
    fn a_wrong_slope_fails_and_so_does_nan() {
        let points = [1.0, 2.0, 8.0, 64.0].map(|n: f64| (n, 3.0 * n.powf(-1.5)));
        assert!(has_slope("a power", &points, -1.5, 0.1).is_ok());
        assert!(has_slope("a power", &points, -2.0, 0.1).is_err());
        assert!(has_slope("not a number", &[(1.0, f64::NAN)], -2.0, 0.1).is_err());
    }
}
