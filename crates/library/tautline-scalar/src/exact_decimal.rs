//! Exact comparisons of decimals with doubles, for tests.

use std::cmp::Ordering;

/// Compares two decimals exactly, whatever their form, with all digits of a double where one is
/// given: as a sign, an exponent and digits.
pub(crate) fn compare(a: &str, b: &str) -> Ordering {
    /// The sign, and for numbers other than 0 the power of the first digit and the digits.
    fn read(text: &str) -> (i32, i32, String) {
        let is_negative = text.starts_with('-');
        let text = text.trim_start_matches('-');
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let exponent: i32 = exponent.parse().expect("an exponent");
        let (whole, rest) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let all = format!("{whole}{rest}");
        let digits = all.trim_start_matches('0');
        if digits.is_empty() {
            return (0, 0, String::new());
        }
        let power = exponent + whole.len() as i32 - 1 - (all.len() - digits.len()) as i32;
        let sign = if is_negative { -1 } else { 1 };
        (sign, power, digits.trim_end_matches('0').to_owned())
    }
    let ((s, p, d), (t, q, e)) = (read(a), read(b));
    let size = (p, d).cmp(&(q, e));
    s.cmp(&t).then(if s < 0 { size.reverse() } else { size })
}

/// All digits of a double.
pub(crate) fn exact(x: f64) -> String {
    format!("{x:.1074}")
}
