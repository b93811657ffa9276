//! One coordinate on its axis: the numbers that are drawn, and their label.

use super::PortraitError;
use crate::{Axis, DrawingError, Scale};

/// A range of a coordinate. The number `u` at a tick stands for `x = offset + 10^exponent u`, so
/// that ticks have few digits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    pub(crate) from: f64,
    pub(crate) to: f64,
    offset: f64,
    exponent: i32,
}

/// A range that is this many times closer than its distance from zero is counted from an offset.
const FAR: f64 = 2000.0;

impl Span {
    /// Returns the range `[from, to]` of the coordinate counted from 0.
    pub(crate) fn new(coordinate: usize, [from, to]: [f64; 2]) -> Result<Span, PortraitError> {
        let bad = |want| Err(PortraitError::Window { coordinate, from, to, want });
        if !(from.is_finite() && to.is_finite()) {
            return bad("both ends must be finite");
        }
        let (length, centre) = (to - from, from / 2.0 + to / 2.0);
        if !(length > 0.0) {
            return bad("the first end must be the smaller one");
        }
        if !(1e-290..1e290).contains(&length) {
            return bad("its length must be between 1e-290 and 1e290");
        }
        if !(length > 1e-11 * centre.abs()) {
            return bad("it must be longer than 1e-11 of its distance from 0");
        }
        let unit = 10.0_f64.powi(length.log10().ceil() as i32);
        let offset = if centre.abs() > FAR * length { (centre / unit).round() * unit } else { 0.0 };
        let most = (from - offset).abs().max((to - offset).abs());
        let exponent = if (1e-2..1e4).contains(&most) { 0 } else { most.log10().floor() as i32 };
        Ok(Span { from, to, offset, exponent })
    }

    /// Gives two coordinates the same unit.
    pub(crate) fn with_equal_units([x, y]: [Span; 2]) -> [Span; 2] {
        let exponent = x.exponent.max(y.exponent);
        [Span { exponent, ..x }, Span { exponent, ..y }]
    }

    /// Returns the number that stands for a value.
    pub(crate) fn drawn(&self, value: f64) -> f64 {
        (value - self.offset) / 10.0_f64.powi(self.exponent)
    }

    /// Returns the value for which a number stands.
    pub(crate) fn data(&self, drawn: f64) -> f64 {
        self.offset + drawn * 10.0_f64.powi(self.exponent)
    }

    /// Returns the ends, as numbers that are drawn.
    pub(crate) fn ends(&self) -> (f64, f64) {
        (self.drawn(self.from), self.drawn(self.to))
    }

    /// Returns the length.
    pub(crate) fn length(&self) -> f64 {
        self.to - self.from
    }

    /// Returns the range made longer by `share` of its length at both ends.
    pub(crate) fn wider(&self, share: f64) -> (f64, f64) {
        (self.from - share * self.length(), self.to + share * self.length())
    }

    /// Returns the axis of a coordinate with this name.
    pub(crate) fn axis(&self, name: &str) -> Result<Axis, DrawingError> {
        let (from, to) = self.ends();
        Ok(Axis::new(Scale::Linear, from, to)?.labelled(self.label(name)))
    }

    /// Returns the formula for the numbers on the axis.
    fn label(&self, name: &str) -> String {
        let sign = if self.offset > 0.0 { '-' } else { '+' };
        let offset = number(self.offset.abs());
        match (self.offset != 0.0, self.exponent) {
            (false, 0) => format!("${name}$"),
            (false, e) => format!("${name}/10^{{{e}}}$"),
            (true, 0) => format!("${name}{sign}{offset}$"),
            (true, e) => format!("$({name}{sign}{offset})/10^{{{e}}}$"),
        }
    }
}

/// Returns a number for a formula, with at most six digits or so that it is exact if it has few.
pub(crate) fn number(value: f64) -> String {
    if value == 0.0 || (1e-3..1e6).contains(&value.abs()) {
        let text = format!("{value:.6}");
        return text.trim_end_matches('0').trim_end_matches('.').to_owned();
    }
    let text = format!("{value:.5e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    match mantissa.trim_end_matches('0').trim_end_matches('.') {
        "1" => format!("10^{{{exponent}}}"),
        "-1" => format!("-10^{{{exponent}}}"),
        mantissa => format!("{mantissa}·10^{{{exponent}}}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{Span, number};

    #[test]
    fn labels_say_what_the_numbers_stand_for() {
        let label = |range| Span::new(0, range).expect("a range").label("x_1");
        assert_eq!(label([-2.0, 3.0]), "$x_1$");
        assert_eq!(label([0.0, 3e9]), "$x_1/10^{9}$");
        assert_eq!(label([0.0, 3e-9]), "$x_1/10^{-9}$");
        assert_eq!(label([1e9, 1e9 + 8.0]), "$x_1-10^{9}$");
        assert_eq!(label([-7000.0, -7000.0 + 3e-5]), "$(x_1+7000)/10^{-5}$");
    }

    #[test]
    fn numbers_return_to_their_values() {
        for range in [[-2.0, 3.0], [0.0, 3e9], [1e9, 1e9 + 8.0], [-1e-9, 1e-9], [3e-7, 4e-7]] {
            let span = Span::new(0, range).expect("a range");
            let (from, to) = span.ends();
            assert!(from.abs().max(to.abs()) <= 1e4 && to - from >= 1e-3, "{from} {to}");
            for value in range {
                // Two roundings of the offset and of the value.
                let slack = 1e-15 * (value.abs() + span.length());
                assert!((span.data(span.drawn(value)) - value).abs() <= slack, "{value}");
            }
        }
    }

    #[test]
    fn ranges_that_cannot_be_resolved_are_refused() {
        for range in [[1.0, 1.0], [2.0, 1.0], [f64::NAN, 1.0], [1e9, 1e9 + 1e-4], [0.0, 1e-300]] {
            assert!(Span::new(0, range).is_err(), "{range:?}");
        }
        assert!(Span::new(0, [-f64::MAX, f64::MAX]).is_err());
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(
            [0.25, 7000.0, 1e9, 2.5e-7].map(number),
            ["0.25", "7000", "10^{9}", "2.5·10^{-7}"]
        );
    }
}
