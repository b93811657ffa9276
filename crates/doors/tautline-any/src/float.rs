//! `Float`: a number whose bits count, as a decimal and as an exact hexadecimal.

use schemars::JsonSchema;
use serde::Serialize;

/// A number as the nearest decimal, and exactly.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Float {
    /// The number. The decimal is the shortest that is read as this number.
    pub value: f64,
    /// The number in hexadecimal, such as `0x1.8p+1` for 3, as C and Python read it.
    pub hex: String,
}

impl From<f64> for Float {
    fn from(value: f64) -> Self {
        Self { value, hex: hexadecimal(value) }
    }
}

/// Returns the number in hexadecimal.
fn hexadecimal(value: f64) -> String {
    let bits = value.to_bits();
    let sign = if value.is_sign_negative() { "-" } else { "" };
    let (exponent, fraction) = ((bits >> 52) & 0x7ff, bits & ((1 << 52) - 1));
    if exponent == 0x7ff {
        return format!("{value}");
    }
    if exponent == 0 && fraction == 0 {
        return format!("{sign}0x0p+0");
    }
    // Numbers below the normal range have no leading 1.
    let (lead, exponent) = if exponent == 0 { (0, -1022) } else { (1, exponent as i64 - 1023) };
    let digits = format!("{fraction:013x}");
    let digits = digits.trim_end_matches('0');
    let point = if digits.is_empty() { "" } else { "." };
    format!("{sign}0x{lead}{point}{digits}p{exponent:+}")
}

#[cfg(test)]
mod tests {
    use super::hexadecimal;

    /// The numbers on the right are what Python's `float.hex` prints, without trailing zeros.
    #[test]
    fn numbers_are_printed_as_python_reads_them() {
        for (value, text) in [
            (3.0, "0x1.8p+1"),
            (-0.1, "-0x1.999999999999ap-4"),
            (1.0, "0x1p+0"),
            (0.0, "0x0p+0"),
            (-0.0, "-0x0p+0"),
            (5e-324, "0x0.0000000000001p-1022"),
            (f64::MAX, "0x1.fffffffffffffp+1023"),
            (f64::MIN_POSITIVE, "0x1p-1022"),
            (f64::INFINITY, "inf"),
        ] {
            assert_eq!(hexadecimal(value), text);
        }
    }
}
