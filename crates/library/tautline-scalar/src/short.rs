//! `Short`: a number in a message.

use std::fmt;

/// A number in a message, to four significant digits.
///
/// ```
/// use tautline_scalar::Short;
///
/// let shown = [7.053933958593928, 33872650588.601097, 0.9, -1.25e-9, 0.0, 1234.56];
/// let shown = shown.map(|x| Short(x).to_string());
/// assert_eq!(shown, ["7.054", "3.387e10", "0.9", "-1.25e-9", "0", "1235"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Short(pub f64);

/// The largest power of ten that is written without an exponent.
const PLAIN: i32 = 4;

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(x) = *self;
        if !x.is_finite() || x == 0.0 {
            return write!(f, "{x}");
        }
        // Rounded first, since 9999.7 has five digits before the point.
        let rounded = format!("{x:.3e}");
        let (digits, exponent) = rounded.split_once('e').ok_or(fmt::Error)?;
        let exponent: i32 = exponent.parse().map_err(|_| fmt::Error)?;
        if (-PLAIN..=PLAIN).contains(&exponent) {
            let plain: f64 = rounded.parse().map_err(|_| fmt::Error)?;
            write!(f, "{plain}")
        } else {
            let digits = digits.trim_end_matches('0').trim_end_matches('.');
            write!(f, "{digits}e{exponent}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Short;

    #[test]
    fn a_message_shows_four_digits() {
        for (x, shown) in [
            (9999.7, "10000"),
            (12345.6, "12350"),
            (123456.0, "1.235e5"),
            (0.00012345678, "0.0001235"),
            (0.000012345678, "1.235e-5"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
            (f64::MAX, "1.798e308"),
            (f64::MIN_POSITIVE, "2.225e-308"),
            (5e-324, "4.941e-324"),
        ] {
            assert_eq!(Short(x).to_string(), shown);
        }
    }
}
