//! Decimals that are rounded in one direction, so that a printed bound is a bound.

/// The number of significant digits of a bound.
const DIGITS: usize = 10;

/// The significant decimal digits that every double has at most: all of them are printed before a
/// decimal is rounded, so that what is cut off is known exactly.
const ALL: usize = 767;

/// Returns the largest decimal of ten digits that is at most `x`.
#[must_use]
pub fn rounded_down(x: f64) -> String {
    directed(x, DIGITS, Towards::Below)
}

/// Returns the smallest decimal of ten digits that is at least `x`.
#[must_use]
pub fn rounded_up(x: f64) -> String {
    directed(x, DIGITS, Towards::Above)
}

/// Returns the largest decimal of so many digits that is at most `x`, without zeros at its end.
#[must_use]
pub fn shortly_down(x: f64, digits: usize) -> String {
    without_zeros(directed(x, digits, Towards::Below))
}

/// Returns the smallest decimal of so many digits that is at least `x`, without zeros at its end.
#[must_use]
pub fn shortly_up(x: f64, digits: usize) -> String {
    without_zeros(directed(x, digits, Towards::Above))
}

/// Returns a number to ten significant digits, rounded to nearest.
#[must_use]
pub fn nearest(x: f64) -> String {
    if !x.is_finite() {
        return x.to_string();
    }
    let text = format!("{x:.*e}", DIGITS - 1);
    let (digits, exponent) = parts(&text);
    plain(x < 0.0, &digits, exponent)
}

/// Returns a number to one significant digit, rounded up.
#[must_use]
pub fn one_digit_up(x: f64) -> String {
    up_to(x, 1)
}

/// Returns a number to so many significant digits, at least one, with an exponent, rounded up.
#[must_use]
pub fn up_to(x: f64, digits: usize) -> String {
    if !x.is_finite() {
        return x.to_string();
    }
    let (digits, exponent) = cut(x, digits, Towards::Above);
    scientific(x < 0.0, &digits, exponent)
}

/// Returns a nonnegative number with so many places after the point, rounded up.
#[must_use]
pub fn places_up(x: f64, places: usize) -> String {
    let exact = format!("{x:.ALL$e}");
    if !x.is_finite() || x <= 0.0 {
        return format!("{x:.places$}");
    }
    let (_, exponent) = parts(&exact);
    let digits = exponent + 1 + places as i32;
    if digits < 1 {
        // One unit of the last place is more.
        return format!("{:.places$}", 10.0_f64.powi(-(places as i32)));
    }
    let (digits, exponent) = cut(x, digits as usize, Towards::Above);
    point(&digits, exponent, places)
}

/// The direction in which a decimal is rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Towards {
    Below,
    Above,
}

fn directed(x: f64, digits: usize, towards: Towards) -> String {
    if !x.is_finite() {
        return x.to_string();
    }
    let (digits, exponent) = cut(x, digits, towards);
    plain(x < 0.0, &digits, exponent)
}

/// Returns the digits of `|x|`, without a point, and the exponent of the first one, so that the decimal
/// with the sign of `x` is on the wanted side of it.
///
/// A double has at most [`ALL`] significant digits, which Rust prints exactly. Where the rest is not 0,
/// the decimal with the first ones is nearer to 0; away from 0 lies the next one.
fn cut(x: f64, count: usize, towards: Towards) -> (Vec<u8>, i32) {
    let (mut digits, mut exponent) = parts(&format!("{x:.*e}", ALL - 1));
    let count = count.max(1);
    let has_rest = digits.iter().skip(count).any(|digit| *digit != 0);
    digits.truncate(count);
    let away = (x < 0.0) == (towards == Towards::Below);
    if has_rest && away {
        for digit in digits.iter_mut().rev() {
            *digit = (*digit + 1) % 10;
            if *digit != 0 {
                return (digits, exponent);
            }
        }
        // All digits were 9.
        digits[0] = 1;
        exponent += 1;
    }
    (digits, exponent)
}

/// Returns the digits and the exponent of a number in scientific form.
fn parts(text: &str) -> (Vec<u8>, i32) {
    let (digits, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let digits = digits.bytes().filter(u8::is_ascii_digit).map(|digit| digit - b'0');
    (digits.collect(), exponent.parse().unwrap_or_default())
}

/// Returns a decimal with all its digits, without an exponent if it is of ordinary size.
fn plain(is_negative: bool, digits: &[u8], exponent: i32) -> String {
    let places = digits.len() as i32 - 1 - exponent;
    if digits.iter().all(|digit| *digit == 0) {
        return "0".to_owned();
    }
    if !(0..=16).contains(&places) {
        return scientific(is_negative, digits, exponent);
    }
    let sign = if is_negative { "-" } else { "" };
    format!("{sign}{}", point(digits, exponent, places as usize))
}

/// Returns a decimal with so many places after the point.
fn point(digits: &[u8], exponent: i32, places: usize) -> String {
    let mut text = String::new();
    let digit = |power: i32| {
        let index = usize::try_from(exponent - power).ok();
        char::from(b'0' + index.and_then(|index| digits.get(index)).copied().unwrap_or(0))
    };
    for power in (0..=exponent.max(0)).rev() {
        text.push(digit(power));
    }
    if places > 0 {
        text.push('.');
        text.extend((1..=places as i32).map(|place| digit(-place)));
    }
    text
}

fn scientific(is_negative: bool, digits: &[u8], exponent: i32) -> String {
    let digit = |digit: &u8| char::from(b'0' + digit);
    let (first, rest) = digits.split_first().unwrap_or((&0, &[]));
    let sign = if is_negative { "-" } else { "" };
    let point = if rest.is_empty() { "" } else { "." };
    let rest: String = rest.iter().map(digit).collect();
    format!("{sign}{}{point}{rest}e{exponent}", digit(first))
}

fn without_zeros(text: String) -> String {
    if !text.contains('.') {
        return text;
    }
    let (digits, exponent) = match text.split_once('e') {
        Some((digits, exponent)) => (digits, format!("e{exponent}")),
        None => (text.as_str(), String::new()),
    };
    format!("{}{exponent}", digits.trim_end_matches('0').trim_end_matches('.'))
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use tautline_chance::{Random, seed};

    use super::{
        nearest, one_digit_up, places_up, rounded_down, rounded_up, shortly_down, shortly_up, up_to,
    };
    use crate::exact_decimal::{compare, exact};

    #[test]
    fn a_decimal_has_a_digit_at_least() {
        assert_eq!(up_to(0.5, 0), up_to(0.5, 1));
        assert_eq!((shortly_up(0.45, 0), shortly_down(-0.45, 0)), ("0.5".into(), "-0.5".into()));
    }

    #[test]
    fn decimals_are_compared_exactly() {
        assert_eq!(compare("0.1", &exact(0.1)), Ordering::Less);
        assert_eq!(compare("0.3", &exact(0.3)), Ordering::Greater);
        assert_eq!(compare("-0.1", &exact(-0.1)), Ordering::Greater);
        assert_eq!(compare("1.25e-3", &exact(1.25e-3)), Ordering::Less);
        assert_eq!(compare("0.5000", &exact(0.5)), Ordering::Equal);
        assert_eq!(compare("-3e2", "-299"), Ordering::Less);
        assert_eq!(compare("0", "-0.0"), Ordering::Equal);
    }

    /// Of each size, with few and with many bits, decimals as people type them, and halfway cases.
    fn numbers() -> Vec<f64> {
        let mut random = Random(seed(11));
        let mut numbers = vec![
            0.0,
            5e-324,
            f64::MIN_POSITIVE,
            f64::MIN_POSITIVE.next_down(),
            f64::MAX,
            0.1,
            0.2,
            0.3,
            1.0,
            1.0_f64.next_up(),
            1.0_f64.next_down(),
            1e15,
            1e16,
            1e17,
            1e22,
            1e23,
            9.999_999_999_5,
            0.999_999_999_95,
            99_999_999_999.5,
            1.000_000_000_5,
            2.5,
            1e-5,
            4503599627370497.5,
        ];
        for _ in 0..600 {
            let power = random.between(-308.0, 308.0);
            numbers.push(10.0_f64.powf(power) * random.between(0.1, 1.0));
            let digits = random.between(1.0, 2e4).round();
            numbers.push(digits * 10.0_f64.powi(random.between(-12.0, 12.0) as i32));
            numbers.push(f64::from_bits((random.between(0.0, 1.0) * 2.0_f64.powi(53)) as u64));
            // Just beside a decimal of ten digits.
            let beside = (random.between(1e9, 1e10).round() + 0.5) * 1e-9;
            numbers.extend([beside, beside.next_up(), beside.next_down()]);
        }
        numbers
    }

    #[test]
    fn a_printed_bound_is_a_bound() {
        for x in numbers().into_iter().flat_map(|x| [x, -x]) {
            let all = exact(x);
            for (low, high, digits) in [
                (rounded_down(x), rounded_up(x), 10),
                (shortly_down(x, 5), shortly_up(x, 5), 5),
                (shortly_down(x, 1), shortly_up(x, 1), 1),
            ] {
                assert_ne!(compare(&low, &all), Ordering::Greater, "{low} for {x:e}");
                assert_ne!(compare(&high, &all), Ordering::Less, "{high} for {x:e}");
                // The next decimal of as many digits is on the other side.
                if x != 0.0 && x.abs() < 1e300 && x.abs() > 1e-300 {
                    let [low, high]: [f64; 2] =
                        [low, high].map(|text| text.parse().expect("a number"));
                    let unit = 10.0_f64.powf(x.abs().log10().floor() + 1.0 - f64::from(digits));
                    assert!(high - low <= unit * (1.0 + 1e-5), "{low} {high} for {x:e}");
                }
            }
        }
    }

    /// The double 0.1 is above the decimal, and the double 0.3 is below it.
    #[test]
    fn decimals_that_are_no_doubles_are_rounded_as_decimals() {
        assert_eq!([rounded_down(0.1), rounded_up(0.1)], ["0.1000000000", "0.1000000001"]);
        assert_eq!([rounded_down(0.3), rounded_up(0.3)], ["0.2999999999", "0.3000000000"]);
        assert_eq!([shortly_down(0.1, 5), shortly_up(0.1, 5)], ["0.1", "0.10001"]);
        assert_eq!([shortly_down(0.3, 5), shortly_up(0.3, 5)], ["0.29999", "0.3"]);
        assert_eq!([shortly_down(-0.1, 5), shortly_up(-0.1, 5)], ["-0.10001", "-0.1"]);
        assert_eq!([shortly_down(12_345.6, 5), shortly_up(12_345.6, 5)], ["12345", "12346"]);
        assert_eq!([shortly_down(1e-30, 5), shortly_up(9.99999e20, 5)], ["1e-30", "1e21"]);
    }

    #[test]
    fn an_error_is_rounded_up() {
        let printed = [1.28e-9, 2e-10, 9.01e-3, 9.99, 0.0, 1.0001e5].map(one_digit_up);
        assert_eq!(printed, ["2e-9", "3e-10", "1e-2", "1e1", "0e0", "2e5"]);
        assert_eq!(
            [up_to(0.000_123_4, 2), up_to(1.0, 2), up_to(0.99, 1)],
            ["1.3e-4", "1.0e0", "1e0"]
        );
        for x in numbers() {
            for printed in [one_digit_up(x), up_to(x, 2), places_up(x, 2)] {
                assert_ne!(compare(&printed, &exact(x)), Ordering::Less, "{printed} for {x:e}");
            }
        }
        let places = [12.345, 12.34, 0.001, 0.0, 99.999, 12.5].map(|x| places_up(x, 2));
        assert_eq!(places, ["12.35", "12.34", "0.01", "0.00", "100.00", "12.50"]);
    }

    #[test]
    fn ten_digits_are_printed() {
        assert_eq!(rounded_down(5.337_962_737_325_072), "5.337962737");
        assert_eq!(rounded_up(5.338_305_530_544_8), "5.338305531");
        assert_eq!(nearest(std::f64::consts::PI), "3.141592654");
        assert_eq!([rounded_down(0.0), rounded_up(0.0), nearest(0.0)], ["0", "0", "0"]);
        assert_eq!([rounded_down(-0.0), rounded_down(-2.0)], ["0", "-2.000000000"]);
        assert_eq!(rounded_up(2.0), "2.000000000");
        assert_eq!(nearest(1.5e-20), "1.500000000e-20");
        assert_eq!(nearest(-1234.5), "-1234.500000");
        assert_eq!(nearest(f64::INFINITY), "inf");
        assert_eq!([rounded_up(1e9), rounded_up(1e10)], ["1000000000", "1.000000000e10"]);
    }
}
