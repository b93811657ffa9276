//! Decimals that are rounded in one direction, so that a printed bound is a bound.

/// The number of significant digits of a bound.
const DIGITS: usize = 10;

/// Returns the largest decimal of ten digits that is at most `x`.
pub(crate) fn rounded_down(x: f64) -> String {
    directed(x, |decimal| decimal <= x, -1)
}

/// Returns the smallest decimal of ten digits that is at least `x`.
pub(crate) fn rounded_up(x: f64) -> String {
    directed(x, |decimal| decimal >= x, 1)
}

/// Returns a number to ten significant digits, rounded to nearest.
pub(crate) fn nearest(x: f64) -> String {
    if !x.is_finite() { x.to_string() } else { plain(x, places(x)) }
}

/// Returns a number to one significant digit, rounded up.
pub(crate) fn one_digit_up(x: f64) -> String {
    let nearest = format!("{x:.0e}");
    let is_enough = nearest.parse().is_ok_and(|nearest: f64| nearest >= x);
    if is_enough || !x.is_finite() {
        return nearest;
    }
    // Half a unit of the digit more rounds to the next one.
    format!("{:.0e}", x + 0.5 * 10.0_f64.powf(x.log10().floor()))
}

fn directed(x: f64, holds: impl Fn(f64) -> bool, step: i32) -> String {
    if !x.is_finite() {
        return x.to_string();
    }
    let places = places(x);
    let decimal = plain(x, places);
    if decimal.parse().is_ok_and(holds) {
        return decimal;
    }
    // One more in the last place. A double of this size is far finer than the last place.
    let ulp = 10.0_f64.powi(-places);
    plain(x + f64::from(step) * ulp * 0.5, places)
}

/// Returns the number of places after the point at which ten digits end; negative for large
/// numbers.
fn places(x: f64) -> i32 {
    if x == 0.0 {
        return 0;
    }
    DIGITS as i32 - 1 - x.abs().log10().floor() as i32
}

fn plain(x: f64, places: i32) -> String {
    if (0..=16).contains(&places) {
        let text = format!("{x:.*}", places as usize);
        return text;
    }
    format!("{x:.*e}", DIGITS - 1)
}

#[cfg(test)]
mod tests {
    use super::{nearest, one_digit_up, rounded_down, rounded_up};

    #[test]
    fn a_printed_bound_is_a_bound() {
        let mut x = 1.234_567_890_123_4e-30;
        while x < 1e30 {
            let [low, high] = [rounded_down(x), rounded_up(x)].map(|text| {
                let value: f64 = text.parse().expect("a number");
                // Ten digits.
                assert!((value - x).abs() < 1.1e-9 * x, "{text} for {x}");
                value
            });
            assert!(low <= x && x <= high, "{low} {x} {high}");
            x *= 3.713_377;
        }
    }

    #[test]
    fn an_error_is_rounded_up() {
        let printed = [1.28e-9, 2e-10, 9.01e-3, 9.99, 0.0, 1.0001e5].map(one_digit_up);
        assert_eq!(printed, ["2e-9", "2e-10", "1e-2", "1e1", "0e0", "2e5"]);
        let mut x = 1.3e-300;
        while x < 1e300 {
            let up: f64 = one_digit_up(x).parse().expect("a number");
            assert!(x <= up && up <= 2.0 * x * (1.0 + 1e-12), "{x:e} {up:e}");
            x *= 3.713_377;
        }
    }

    #[test]
    fn ten_digits_are_printed() {
        assert_eq!(rounded_down(5.337_962_737_325_072), "5.337962737");
        assert_eq!(rounded_up(5.338_305_530_544_8), "5.338305531");
        assert_eq!(nearest(std::f64::consts::PI), "3.141592654");
        assert_eq!([rounded_down(0.0), rounded_up(0.0)], ["0", "0"]);
        assert_eq!(rounded_up(2.0), "2.000000000");
        assert_eq!(nearest(1.5e-20), "1.500000000e-20");
        assert_eq!(nearest(f64::INFINITY), "inf");
    }
}
