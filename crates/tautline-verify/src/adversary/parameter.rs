//! `Parameter`: one side of the box in which a search runs.

/// A parameter with its range and the scale on which the search moves it.
///
/// The search knows a parameter by its place, a number of `[0, 1]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// The name, as in tables.
    pub name: &'static str,
    low: f64,
    high: f64,
    scale: Scale,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    Linear,
    Logarithmic,
    /// Logarithmic, rounded to whole numbers.
    Whole,
}

impl Parameter {
    /// Returns a parameter that moves linearly from `low` to `high`.
    #[must_use]
    pub fn linear(name: &'static str, low: f64, high: f64) -> Self {
        Self { name, low, high, scale: Scale::Linear }
    }

    /// Returns a parameter whose logarithm moves from that of `low > 0` to that of `high`: for what
    /// may have to become small.
    #[must_use]
    pub fn logarithmic(name: &'static str, low: f64, high: f64) -> Self {
        Self { name, low, high, scale: Scale::Logarithmic }
    }

    /// Returns a whole parameter from `low ≥ 1` to `high`, such as `N`; small numbers are as
    /// likely as large ones.
    #[must_use]
    pub fn whole(name: &'static str, low: u32, high: u32) -> Self {
        Self { name, low: f64::from(low), high: f64::from(high), scale: Scale::Whole }
    }

    /// Returns `N`, where a family has no other than this one.
    #[must_use]
    pub fn subintervals(n: u32) -> Self {
        Self::whole("N", n, n)
    }

    /// Returns whether its values are whole numbers.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.scale == Scale::Whole
    }

    /// Returns the value at a place of `[0, 1]`.
    #[must_use]
    pub fn at(&self, place: f64) -> f64 {
        let logarithmic = || self.low * (self.high / self.low).powf(place);
        let value = match self.scale {
            Scale::Linear => self.low + place * (self.high - self.low),
            Scale::Logarithmic => logarithmic(),
            Scale::Whole => logarithmic().round(),
        };
        value.clamp(self.low, self.high)
    }

    /// Returns the place `step` further on, or the end of `[0, 1]`; a whole parameter moves by one
    /// at least.
    #[must_use]
    pub(super) fn moved(&self, place: f64, step: f64) -> f64 {
        if self.low == self.high {
            return place;
        }
        let further = (place + step).clamp(0.0, 1.0);
        let value = self.at(place);
        if self.is_whole() && self.at(further) == value {
            let next = (value + step.signum()).clamp(self.low, self.high);
            return (next / self.low).ln() / (self.high / self.low).ln();
        }
        further
    }
}

#[cfg(test)]
mod tests {
    use super::Parameter;

    #[test]
    fn places_run_from_end_to_end() {
        let ends = |p: Parameter| [p.at(0.0), p.at(0.5), p.at(1.0)];
        assert_eq!(ends(Parameter::linear("x", -1.0, 3.0)), [-1.0, 1.0, 3.0]);
        let [low, middle, high] = ends(Parameter::logarithmic("x", 1e-2, 1e2));
        assert_eq!([low, high], [1e-2, 1e2]);
        assert!((middle - 1.0).abs() <= 1e-15);
        assert_eq!(ends(Parameter::whole("N", 1, 16)), [1.0, 4.0, 16.0]);
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
}
