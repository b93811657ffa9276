//! Two numbers that have to agree.

use super::Failure;

/// Returns a failure unless `value` is `expected` up to `tolerance`.
pub(super) fn close(what: &str, value: f64, expected: f64, tolerance: f64) -> Result<(), Failure> {
    if (value - expected).abs() <= tolerance {
        return Ok(());
    }
    let message = format!("{what}: {value:.17e} is not {expected:.17e} up to {tolerance:.1e}");
    Err(Failure::new(message))
}

#[cfg(test)]
mod tests {
    use super::close;

    #[test]
    fn what_is_far_or_not_a_number_fails() {
        assert!(close("one", 1.0 + 1e-9, 1.0, 1e-8).is_ok());
        assert!(close("one", 1.0 + 1e-7, 1.0, 1e-8).is_err());
        assert!(close("one", f64::NAN, 1.0, 1e-8).is_err());
    }
}
