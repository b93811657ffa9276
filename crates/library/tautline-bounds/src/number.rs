//! `Number`: the two number types in which the bounds of Propositions S.6 to S.9 are evaluated.

use tautline_scalar::{Interval, Scalar};

use crate::product;

/// A double, rounded to nearest, or an interval, rounded outward.
///
/// A formula is written once for both. In intervals its ends are proved; in doubles its last digits are
/// not.
pub(crate) trait Number: Scalar {
    /// Returns `π/2`.
    fn half_pi() -> Self;

    /// Returns the product of nonnegative factors.
    fn product<const K: usize>(factors: [Self; K]) -> Self;

    /// Returns the smaller of two upper bounds.
    fn least(self, other: Self) -> Self;

    /// Returns the larger of two upper bounds.
    fn greatest(self, other: Self) -> Self;

    /// Returns whether the number is at most `bound`; for an interval, whether all of it is.
    fn is_at_most(self, bound: f64) -> bool;

    /// Returns whether the number is less than `bound`; for an interval, whether all of it is.
    fn is_below(self, bound: f64) -> bool;

    /// Returns whether the number is positive; for an interval, whether all of it is.
    fn is_positive(self) -> bool;

    /// Returns a double that is at most the number, for an interval at most all of it; NaN if it is
    /// undefined.
    fn below(self) -> f64;

    /// Returns a double that is at least the number, for an interval at least all of it; NaN if it is
    /// undefined.
    fn above(self) -> f64;

    /// Returns `x^{−3/2}`.
    fn to_minus_three_halves(self) -> Self;
}

impl Number for f64 {
    fn half_pi() -> f64 {
        std::f64::consts::FRAC_PI_2
    }

    fn product<const K: usize>(factors: [f64; K]) -> f64 {
        product::product(factors)
    }

    fn least(self, other: f64) -> f64 {
        self.min(other)
    }

    fn greatest(self, other: f64) -> f64 {
        self.max(other)
    }

    fn is_at_most(self, bound: f64) -> bool {
        self <= bound
    }

    fn is_below(self, bound: f64) -> bool {
        self < bound
    }

    fn is_positive(self) -> bool {
        self > 0.0
    }

    fn below(self) -> f64 {
        self
    }

    fn above(self) -> f64 {
        self
    }

    fn to_minus_three_halves(self) -> f64 {
        self.powf(-1.5)
    }
}

impl Number for Interval {
    fn half_pi() -> Interval {
        // The double next to π/2 is below it: π/2 − FRAC_PI_2 is 6.1e-17, less than its ulp 2.2e-16.
        let below = std::f64::consts::FRAC_PI_2;
        hull(below, below.next_up())
    }

    fn product<const K: usize>(mut factors: [Interval; K]) -> Interval {
        if factors.contains(&Interval::constant(0.0)) {
            return Interval::constant(0.0);
        }
        // The order is that of doubles, so that partial products overflow only if the product does.
        factors.sort_unstable_by(|a, b| a.hi().total_cmp(&b.hi()));
        let mut left = factors.as_slice();
        let mut value = Interval::constant(1.0);
        while let Some((smallest, others)) = left.split_first() {
            if value.hi() > 1.0 {
                value *= *smallest;
                left = others;
            } else if let Some((largest, others)) = left.split_last() {
                value *= *largest;
                left = others;
            }
        }
        value
    }

    fn least(self, other: Interval) -> Interval {
        if self.is_undefined() || other.is_undefined() {
            return Interval::UNDEFINED;
        }
        hull(self.lo().min(other.lo()), self.hi().min(other.hi()))
    }

    fn greatest(self, other: Interval) -> Interval {
        if self.is_undefined() || other.is_undefined() {
            return Interval::UNDEFINED;
        }
        hull(self.lo().max(other.lo()), self.hi().max(other.hi()))
    }

    fn is_at_most(self, bound: f64) -> bool {
        self.hi() <= bound
    }

    fn is_below(self, bound: f64) -> bool {
        self.hi() < bound
    }

    fn is_positive(self) -> bool {
        self.lo() > 0.0
    }

    fn below(self) -> f64 {
        self.lo()
    }

    fn above(self) -> f64 {
        self.hi()
    }

    fn to_minus_three_halves(self) -> Interval {
        (self * self.sqrt()).recip()
    }
}

fn hull(lo: f64, hi: f64) -> Interval {
    Interval::new(lo, hi).unwrap_or(Interval::UNDEFINED)
}

#[cfg(test)]
mod tests {
    use tautline_scalar::{Interval, Scalar};

    use super::{Number, hull};

    /// `sin` and `cos` of the enclosure contain 1 and 0.
    #[test]
    fn half_pi_is_enclosed() {
        let (sin, cos) = Interval::half_pi().sin_cos();
        assert!(sin.contains(1.0) && cos.contains(0.0), "{sin:?} {cos:?}");
        assert!(Interval::half_pi().width() < 3e-16);
    }

    #[test]
    fn the_least_of_two_enclosures_encloses_the_least() {
        let (low, wide) = (hull(1.0, 2.0), hull(0.0, 3.0));
        assert_eq!(low.least(wide), hull(0.0, 2.0));
        assert_eq!(low.greatest(wide), hull(1.0, 3.0));
        assert!(low.least(Interval::UNDEFINED).is_undefined());
        assert!(Interval::UNDEFINED.greatest(low).is_undefined());
    }

    #[test]
    fn products_of_intervals_are_as_safe_as_those_of_doubles() {
        let point = Interval::point;
        let close = Interval::product([1e300, 1e300, 1e-300, 1e-300].map(point));
        assert!(close.lo() < 1.0 + 1e-14 && 1.0 - 1e-14 < close.hi() && close.width() < 1e-14);
        assert_eq!(Interval::product([Interval::REALS, point(0.0)]), point(0.0));
        let over = Interval::product([1e200, 1e200].map(point));
        assert!(over.lo().is_finite() && over.hi() == f64::INFINITY);
        let tenth = Interval::product([0.1, 0.1].map(point));
        // 0.1² in doubles is above the exact square of the double 0.1.
        assert!(tenth.lo() < 0.1 * 0.1 && 0.1 * 0.1 <= tenth.hi());
        let known = point(2.0).to_minus_three_halves();
        assert!(known.contains(2.0_f64.powf(-1.5)) && known.width() < 1e-15);
    }

    #[test]
    fn comparisons_hold_for_all_of_an_interval() {
        let unit = hull(0.0, 1.0);
        assert!(unit.is_at_most(1.0) && !unit.is_below(1.0) && !unit.is_positive());
        assert!(hull(5e-324, 1.0).is_positive() && unit.is_below(1.0_f64.next_up()));
        assert!(!Interval::UNDEFINED.is_at_most(1.0) && !Interval::UNDEFINED.is_positive());
    }
}
