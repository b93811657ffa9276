//! Proofs by interval arithmetic about points and boxes: comparisons of distances, and points of a
//! sphere.

use nalgebra::SVector;
use tautline_scalar::{Interval, Scalar};

use crate::norm::on_axis;

/// Returns the box that consists of one point.
pub(crate) fn point<const D: usize>(x: &SVector<f64, D>) -> SVector<Interval, D> {
    x.map(Interval::point)
}

/// Returns the box if it is bounded, and `None` if a number overflowed.
pub(crate) fn finite<const D: usize>(member: SVector<Interval, D>) -> Option<SVector<Interval, D>> {
    member.iter().all(|side| side.is_finite()).then_some(member)
}

/// Returns `u·v`.
pub(crate) fn dot<const D: usize>(u: &SVector<Interval, D>, v: &SVector<Interval, D>) -> Interval {
    (0..D).fold(Interval::constant(0.0), |sum, i| sum + u[i] * v[i])
}

/// Returns `|u|²`.
pub(crate) fn square<const D: usize>(u: &SVector<Interval, D>) -> Interval {
    u.iter().fold(Interval::constant(0.0), |sum, u| sum + u.sqr())
}

/// Returns the largest power of two that is at most `size`, but at least the smallest normal
/// number. Division of intervals by it is exact except for the largest and smallest numbers.
pub(crate) fn power_of_two(size: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    f64::from_bits(size.to_bits() & EXPONENT).max(f64::MIN_POSITIVE)
}

/// The squared distance between two points. In its unit the largest coordinate of the difference of
/// the points is between 1 and 2, so that no square overflows or underflows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance<const D: usize> {
    offset: SVector<Interval, D>,
    square: Interval,
    unit: f64,
}

/// Returns the distance between `c` and `x`.
pub(crate) fn distance<const D: usize>(x: &SVector<f64, D>, c: &SVector<f64, D>) -> Distance<D> {
    let unit = power_of_two((x - c).amax());
    let offset = (point(x) - point(c)).map(|u| u / unit);
    Distance { offset, square: square(&offset), unit }
}

impl<const D: usize> Distance<D> {
    /// Returns whether the distance is proved to be at most `r ≥ 0`.
    pub(crate) fn at_most(&self, r: f64) -> bool {
        self.square.hi() <= self.square_of(r).lo()
    }

    /// Returns whether the distance is proved to be `r ≥ 0`, which requires that nothing rounds.
    pub(crate) fn is(&self, r: f64) -> bool {
        self.at_most(r) && self.square_of(r).hi() <= self.square.lo()
    }

    fn square_of(&self, r: f64) -> Interval {
        (Interval::point(r) / self.unit).sqr()
    }
}

/// Returns a box that contains the point `c + r (x − c)/|x − c|` of a sphere, or `c + r e₁` if
/// `x = c`.
pub(crate) fn on_sphere<const D: usize>(
    x: &SVector<f64, D>,
    c: &SVector<f64, D>,
    r: f64,
) -> Option<SVector<Interval, D>> {
    let away = distance(x, c);
    let direction = if r == 0.0 {
        point(&SVector::zeros())
    } else if x == c {
        point(&on_axis(0, 1.0))
    } else {
        let length = away.square.sqrt();
        let unit = Interval::new(-1.0, 1.0).expect("ordered");
        // No coordinate of a unit vector exceeds 1.
        away.offset.map(|u| (u / length).intersection(unit).unwrap_or(Interval::UNDEFINED))
    };
    finite(SVector::from_fn(|i, _| direction[i] * r + c[i]))
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_scalar::Interval;

    use super::{distance, finite, on_sphere, point, power_of_two};

    #[test]
    fn powers_of_two_are_below_their_numbers() {
        let table = [(1.0, 1.0), (1.9, 1.0), (2.0, 2.0), (0.3, 0.25), (7e-310, f64::MIN_POSITIVE)];
        for (size, power) in table {
            assert_eq!(power_of_two(size), power);
        }
    }

    /// `3² + 4² = 5²` holds in every unit, and a difference of one ulp is noticed.
    #[test]
    fn distances_are_compared_exactly() {
        for unit in [1.0, 2.0_f64.powi(-900), 2.0_f64.powi(900)] {
            let away = distance(&(vector![4.0, 6.0] * unit), &(vector![1.0, 2.0] * unit));
            let r = 5.0 * unit;
            assert!(away.at_most(r) && away.is(r));
            assert!(away.at_most(r.next_up()) && !away.is(r.next_up()));
            assert!(!away.at_most(r.next_down()) && !away.is(r.next_down()));
        }
    }

    /// The squares lie between the same two neighbouring doubles, so the ends of intervals cannot
    /// compare them. Neither order is proved.
    #[test]
    fn distances_that_differ_by_less_than_a_rounding_prove_nothing() {
        let little = |n: i32| 2.0_f64.powi(-n);
        let origin = vector![0.0, 0.0, 0.0];
        // 1 + 2⁻⁸⁰ > 1 exceeds r², which is a double.
        assert!(!distance(&vector![1.0, little(40), 0.0], &origin).at_most(1.0));
        // Compares r² = 1 + 2⁻³⁹ + 2⁻⁸⁰ with 1 + 2⁻³⁹ + 2⁻⁸⁰ + 2⁻⁷⁰.
        let r = 1.0 + little(40);
        assert!(!distance(&vector![r, little(35), 0.0], &origin).at_most(r));
        // Conversely, 1 + 2⁻³⁹ is exact and less than r², so r is not the distance.
        let away = distance(&vector![1.0, little(20), little(20)], &origin);
        assert!(away.at_most(r) && !away.is(r));
        // 1 − 0.48 · 2⁻⁵² is not 1, although its upper bound is 1.
        let (u, v) = (1.0 - 431.0 * little(26), 61_571_941.0 * little(34));
        assert!(!distance(&vector![u, v, 0.0], &origin).is(1.0));
        // The distance r of (r, 0, 0) from the origin is not proved, since r² rounds.
        assert!(!distance(&vector![r, 0.0, 0.0], &origin).is(r));
    }

    /// In one dimension the sphere is `c ± r`. On the outer side the box ends where the interval of
    /// that sum does, although the offset from the centre rounds.
    #[test]
    fn no_box_reaches_farther_from_the_centre_than_the_sphere() {
        for case in 1..2000 {
            let x = 1e3 * f64::from(case).sin();
            let (c, r) = (0.1, 0.7);
            let [near]: [Interval; 1] =
                on_sphere(&vector![x], &vector![c], r).expect("finite").into();
            let [lower, upper] = [-r, r].map(|r| Interval::point(r) + c);
            let pole = if x < c { lower } else { upper };
            assert!(lower.lo() <= near.lo() && near.hi() <= upper.hi(), "{near:?} for {x}");
            assert!(near.intersection(pole).is_some(), "{near:?} for {x}");
        }
    }

    #[test]
    fn nothing_is_proved_beyond_f64() {
        let (x, c) = (vector![f64::MAX], vector![-f64::MAX]);
        let away = distance(&x, &c);
        assert!(!away.at_most(f64::MAX) && !away.is(f64::MAX));
        assert!(on_sphere(&x, &c, 1.0).is_none());
        // A sphere of radius 0 is its centre, however far away the other point is.
        let near = vector![-4e307];
        assert_eq!(on_sphere(&x, &near, 0.0), Some(point(&near)));
        assert!(on_sphere(&vector![f64::INFINITY], &c, 1.0).is_none());
        assert!(finite(vector![Interval::REALS]).is_none());
        let one = Interval::point(1.0);
        for (i, side) in (0..3).zip([Interval::REALS, Interval::UNDEFINED, Interval::REALS]) {
            let mut member = vector![one, one, one];
            member[i] = side;
            assert!(finite(member).is_none(), "{member:?}");
        }
        assert_eq!(finite(point(&c)), Some(point(&c)));
    }
}
