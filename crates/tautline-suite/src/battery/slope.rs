//! The order of a sequence of errors, compared with the one that theory predicts.

use tautline_statements::slope;

use super::Failure;

/// Returns a failure unless the slope is `expected` up to `tilt`.
pub(super) fn has_slope(
    what: &str,
    points: &[(f64, f64)],
    expected: f64,
    tilt: f64,
) -> Result<(), Failure> {
    let slope = slope(points);
    if (slope - expected).abs() <= tilt {
        Ok(())
    } else {
        Err(Failure::new(format!("{what}: slope {slope} over {points:?}, not {expected}")))
    }
}

#[cfg(test)]
mod tests {
    use super::has_slope;

    #[test]
    fn a_wrong_slope_fails_and_so_does_nan() {
        let points = [1.0, 2.0, 8.0, 64.0].map(|n: f64| (n, 3.0 * n.powf(-1.5)));
        assert!(has_slope("a power", &points, -1.5, 0.1).is_ok());
        assert!(has_slope("a power", &points, -2.0, 0.1).is_err());
        assert!(has_slope("not a number", &[(1.0, f64::NAN)], -2.0, 0.1).is_err());
    }
}
