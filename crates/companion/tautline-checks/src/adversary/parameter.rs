//! `Parameter`: one side of the box that is searched.

use super::edge::{Beyond, End};

/// A parameter with its range, and the scale on which the search moves it.
///
/// The search works with the *place* of a parameter in its range, a number in `[0, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The name used in tables.
    pub name: &'static str,
    low: f64,
    high: f64,
    scale: Scale,
    beyond: [Option<Beyond>; 2],
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    Linear,
    /// Linear; `high` is identified with `low`.
    Periodic,
    Logarithmic,
    /// The logarithm of `x/(1 − x)`.
    Fraction,
    /// Logarithmic, rounded to whole numbers.
    Whole,
}

/// A place within this distance of 0 or 1 counts as an edge, since the search may stop a few of its
/// last steps short of it.
const NEAR: f64 = 1e-3;

impl Parameter {
    /// Returns a parameter that moves linearly from `low` to `high`.
    #[must_use]
    pub fn linear(name: &'static str, low: f64, high: f64) -> Self {
        Self { name, low, high, scale: Scale::Linear, beyond: [None; 2] }
    }

    /// Returns a parameter that moves linearly over one period from 0 and has no edges.
    #[must_use]
    pub fn periodic(name: &'static str, period: f64) -> Self {
        Self { scale: Scale::Periodic, ..Self::linear(name, 0.0, period) }
    }

    /// Returns a parameter that moves logarithmically from `low > 0` to `high`. It is for a
    /// quantity that may have to become small.
    #[must_use]
    pub fn logarithmic(name: &'static str, low: f64, high: f64) -> Self {
        Self { scale: Scale::Logarithmic, ..Self::linear(name, low, high) }
    }

    /// Returns a parameter between `low > 0` and `high < 1` that moves linearly in
    /// `log(x/(1 − x))`. It is for a quantity that may have to approach 0 or 1.
    #[must_use]
    pub fn fraction(name: &'static str, low: f64, high: f64) -> Self {
        Self { scale: Scale::Fraction, ..Self::linear(name, low, high) }
    }

    /// Returns a whole-number parameter from `low ≥ 1` to `high`, such as `N`, on a logarithmic
    /// scale.
    #[must_use]
    pub fn whole(name: &'static str, low: u32, high: u32) -> Self {
        Self { scale: Scale::Whole, ..Self::linear(name, f64::from(low), f64::from(high)) }
    }

    /// Returns `N` as a parameter with a single value.
    #[must_use]
    pub fn subintervals(n: u32) -> Self {
        Self::whole("N", n, n)
    }

    /// Declares what lies below and above the range. A search that stops at an end where nothing is
    /// declared is [cut off](super::Edge::is_cut_off).
    #[must_use]
    pub fn with_ends(self, below: Beyond, above: Beyond) -> Self {
        Self { beyond: [Some(below), Some(above)], ..self }
    }

    /// Declares what lies below the range and leaves undeclared what lies above it.
    #[must_use]
    pub fn starting(self, below: Beyond) -> Self {
        Self { beyond: [Some(below), self.beyond[1]], ..self }
    }

    /// Returns whether the values of the parameter are whole numbers.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.scale == Scale::Whole
    }

    /// Returns the value at a place in `[0, 1]`.
    #[must_use]
    pub fn at(&self, place: f64) -> f64 {
        let logarithmic = |low: f64, high: f64| low * (high / low).powf(place);
        let odds = |x: f64| x / (1.0 - x);
        let value = match self.scale {
            Scale::Linear | Scale::Periodic => self.low + place * (self.high - self.low),
            Scale::Logarithmic => logarithmic(self.low, self.high),
            Scale::Fraction => {
                let odds = logarithmic(odds(self.low), odds(self.high));
                odds / (1.0 + odds)
            }
            Scale::Whole => logarithmic(self.low, self.high).round(),
        };
        value.clamp(self.low, self.high)
    }

    /// Returns the place in `[0, 1]` for any number: the nearest place, or the place at a whole
    /// number of periods from it.
    #[must_use]
    pub(super) fn brought_back(&self, place: f64) -> f64 {
        match self.scale {
            Scale::Periodic => place.rem_euclid(1.0),
            _ => place.clamp(0.0, 1.0),
        }
    }

    /// Returns the place that is `step` further, or the end of `[0, 1]` if that comes first. The
    /// value of a whole-number parameter changes by at least one.
    #[must_use]
    pub(super) fn moved(&self, place: f64, step: f64) -> f64 {
        if self.low == self.high {
            return place;
        }
        let further = self.brought_back(place + step);
        let value = self.at(place);
        if self.is_whole() && self.at(further) == value {
            let next = (value + step.signum()).clamp(self.low, self.high);
            return (next / self.low).ln() / (self.high / self.low).ln();
        }
        further
    }

    /// Returns the end of the range at which a value lies, if any.
    #[must_use]
    pub fn end(&self, value: f64) -> Option<End> {
        if self.low == self.high || self.scale == Scale::Periodic {
            return None;
        }
        let near = if self.is_whole() { 0.0 } else { NEAR };
        let (least, most) = (self.at(near), self.at(1.0 - near));
        if value <= least {
            Some(End::Least)
        } else if value >= most {
            Some(End::Most)
        } else {
            None
        }
    }

    /// Returns what lies beyond an end, if declared.
    #[must_use]
    pub fn beyond(&self, end: End) -> Option<Beyond> {
        self.beyond[end as usize]
    }

    /// Returns the place of the value that is twice as far from the limit at this end: twice as
    /// large near 0, half as large near `∞`, and twice as far from 1 near 1. The limits of a linear
    /// range are `±∞`.
    #[must_use]
    pub(super) fn half_way_out(&self, place: f64, end: End) -> f64 {
        let value = self.at(place);
        let log = |value: f64, low: f64, high: f64| (value / low).ln() / (high / low).ln();
        let odds = |x: f64| x / (1.0 - x);
        let doubled = match end {
            End::Least => 2.0 * value,
            End::Most => 0.5 * value,
        };
        let place = match (self.scale, end) {
            (Scale::Linear | Scale::Periodic, _) => {
                (0.5 * value - self.low) / (self.high - self.low)
            }
            (Scale::Logarithmic, _) => log(doubled, self.low, self.high),
            (Scale::Whole, _) => log(doubled.round(), self.low, self.high),
            (Scale::Fraction, End::Least) => log(odds(doubled), odds(self.low), odds(self.high)),
            (Scale::Fraction, End::Most) => {
                let value = 1.0 - 2.0 * (1.0 - value);
                log(odds(value), odds(self.low), odds(self.high))
            }
        };
        self.brought_back(place)
    }
}

#[cfg(test)]
mod tests {
    use super::{End, Parameter};

    #[test]
    fn places_run_from_end_to_end() {
        let ends = |p: Parameter| [p.at(0.0), p.at(0.5), p.at(1.0)];
        assert_eq!(ends(Parameter::linear("x", -1.0, 3.0)), [-1.0, 1.0, 3.0]);
        let [low, middle, high] = ends(Parameter::logarithmic("x", 1e-2, 1e2));
        assert_eq!([low, high], [1e-2, 1e2]);
        assert!((middle - 1.0).abs() <= 1e-15);
        assert_eq!(ends(Parameter::whole("N", 1, 16)), [1.0, 4.0, 16.0]);
        let [low, middle, high] = ends(Parameter::fraction("a", 1e-3, 0.999));
        assert_eq!([low, high], [1e-3, 0.999]);
        assert!((middle - 0.5).abs() <= 1e-15);
    }

    #[test]
    fn whole_numbers_move_by_one_at_least_and_stay_in_range() {
        let n = Parameter::whole("N", 1, 16);
        let mut place = 0.0;
        for expected in 2..=16 {
            place = n.moved(place, 1e-6);
            assert_eq!(n.at(place), f64::from(expected));
        }
        assert_eq!(n.at(n.moved(place, 1e-6)), 16.0);
        assert_eq!(n.at(n.moved(0.0, -1e-6)), 1.0);
        assert_eq!(Parameter::subintervals(2).moved(0.3, 0.1), 0.3);
    }

    #[test]
    fn a_periodic_parameter_wraps_and_has_no_edge() {
        let phase = Parameter::periodic("x", 2.0);
        assert_eq!(phase.moved(0.75, 0.5), 0.25);
        assert_eq!(phase.moved(0.25, -0.5), 0.75);
        assert_eq!([0.0, 1.0, 2.0].map(|value| phase.end(value)), [None; 3]);
        assert_eq!(Parameter::linear("x", 0.0, 2.0).moved(0.75, 0.5), 1.0);
    }

    #[test]
    fn an_end_is_where_the_range_ends() {
        let x = Parameter::logarithmic("x", 1e-2, 1e2);
        let ends = [1e-2, 1.008e-2, 1.02e-2, 99.0, 99.2, 100.0].map(|value| x.end(value));
        let (least, most) = (Some(End::Least), Some(End::Most));
        assert_eq!(ends, [least, least, None, None, most, most]);
        let n = Parameter::whole("N", 1, 8);
        assert_eq!([1.0, 2.0, 7.0, 8.0].map(|n_| n.end(n_)), [least, None, None, most]);
        assert_eq!(Parameter::subintervals(1).end(1.0), None);
    }

    #[test]
    fn half_way_out_is_twice_as_far_from_the_limit() {
        let out = |p: Parameter, place, end| p.at(p.half_way_out(place, end));
        let near = |found: f64, expected: f64| {
            assert!((found - expected).abs() <= 1e-12 * expected.abs(), "{found}, not {expected}");
        };
        let x = Parameter::logarithmic("x", 1e-2, 1e2);
        near(out(x, 0.0, End::Least), 2e-2);
        near(out(x, 1.0, End::Most), 50.0);
        let a = Parameter::fraction("a", 1e-3, 0.999);
        near(out(a, 0.0, End::Least), 2e-3);
        near(out(a, 1.0, End::Most), 0.998);
        near(out(Parameter::whole("N", 1, 8), 1.0, End::Most), 4.0);
        near(out(Parameter::linear("x", -10.0, 10.0), 0.0, End::Least), -5.0);
    }
}
