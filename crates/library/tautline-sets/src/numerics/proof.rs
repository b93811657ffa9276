//! Proofs about points and boxes: exact comparisons of distances, and points of a sphere by interval
//! arithmetic.

mod sum_of_products;

use std::cmp::Ordering;

use tautline_scalar::{Interval, Scalar};

use crate::numerics::place::{largest, minus};

/// Returns the box that consists of one point.
pub(crate) fn point(x: &[f64]) -> Vec<Interval> {
    x.iter().map(|&x| Interval::point(x)).collect()
}

/// Returns the box if it is bounded, and `None` if a number overflowed.
pub(crate) fn finite(member: Vec<Interval>) -> Option<Vec<Interval>> {
    member.iter().all(|side| side.is_finite()).then_some(member)
}

/// Returns `u·v`.
pub(crate) fn dot(u: &[Interval], v: &[Interval]) -> Interval {
    u.iter().zip(v).fold(Interval::constant(0.0), |sum, (&u, &v)| sum + u * v)
}

/// Returns `|u|²`.
pub(crate) fn square(u: &[Interval]) -> Interval {
    u.iter().fold(Interval::constant(0.0), |sum, u| sum + u.sqr())
}

/// Returns the largest power of two that is at most `size`, but at least the smallest normal
/// number. Division of intervals by it is exact except for the largest and smallest numbers.
pub(crate) fn power_of_two(size: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    f64::from_bits(size.to_bits() & EXPONENT).max(f64::MIN_POSITIVE)
}

/// Returns how `|x − c|` compares with `r ≥ 0`, exactly; `None` if a number is not finite.
///
/// `|x − c|² − r²` is a sum of products of doubles: `Σ (xᵢ² − 2 xᵢ cᵢ + cᵢ²) − r²`.
pub(crate) fn compare_distance(x: &[f64], c: &[f64], r: f64) -> Option<Ordering> {
    let squares = x.iter().zip(c).flat_map(|(&x, &c)| [(x, x), (-x, c), (-x, c), (c, c)]);
    sum_of_products::sign(squares.chain([(-r, r)]))
}

/// Returns how `n·x` compares with `b`, exactly; `None` if a number is not finite.
pub(crate) fn compare_height(n: &[f64], x: &[f64], b: f64) -> Option<Ordering> {
    let products = n.iter().zip(x).map(|(&n, &x)| (n, x));
    sum_of_products::sign(products.chain([(-1.0, b)]))
}

/// Returns a box that contains the point `c + r (x − c)/|x − c|` of a sphere, or `c + r e₁` if
/// `x = c`.
pub(crate) fn on_sphere(x: &[f64], c: &[f64], r: f64) -> Option<Vec<Interval>> {
    // In this unit the largest coordinate of the offset is between 1 and 2, so that no square
    // overflows or underflows.
    let unit = power_of_two(largest(&minus(x, c)));
    let away: Vec<Interval> =
        x.iter().zip(c).map(|(&x, &c)| (Interval::point(x) - Interval::point(c)) / unit).collect();
    let length = square(&away).sqrt();
    let most = Interval::new(-1.0, 1.0).expect("ordered");
    let direction = |i: usize| {
        if r == 0.0 {
            Interval::point(0.0)
        } else if x == c {
            Interval::point(if i == 0 { 1.0 } else { 0.0 })
        } else {
            // No coordinate of a unit vector exceeds 1.
            (away[i] / length).intersection(most).unwrap_or(Interval::UNDEFINED)
        }
    };
    finite(c.iter().enumerate().map(|(i, c)| direction(i) * r + *c).collect())
}

#[cfg(test)]
mod tests {
    use tautline_scalar::Interval;

    use std::cmp::Ordering::{Equal, Greater, Less};

    use super::{compare_distance, compare_height, finite, on_sphere, point, power_of_two};

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
            let (x, c, r) = ([4.0 * unit, 6.0 * unit], [1.0 * unit, 2.0 * unit], 5.0 * unit);
            assert_eq!(compare_distance(&x, &c, r), Some(Equal));
            assert_eq!(compare_distance(&x, &c, r.next_up()), Some(Less));
            assert_eq!(compare_distance(&x, &c, r.next_down()), Some(Greater));
        }
    }

    /// The squares lie between the same two neighbouring doubles, so that neither doubles nor the ends
    /// of intervals could compare them.
    #[test]
    fn distances_that_differ_by_less_than_a_rounding_are_compared() {
        let little = |n: i32| 2.0_f64.powi(-n);
        let origin = [0.0, 0.0, 0.0];
        // 1 + 2⁻⁸⁰ > 1.
        assert_eq!(compare_distance(&[1.0, little(40), 0.0], &origin, 1.0), Some(Greater));
        // r² = 1 + 2⁻³⁹ + 2⁻⁸⁰ is less than 1 + 2⁻³⁹ + 2⁻⁸⁰ + 2⁻⁷⁰ and more than 1 + 2⁻³⁹.
        let r = 1.0 + little(40);
        assert_eq!(compare_distance(&[r, little(35), 0.0], &origin, r), Some(Greater));
        let below = [1.0, little(20), little(20)];
        assert_eq!(compare_distance(&below, &origin, r), Some(Less));
        assert_eq!(compare_distance(&[r, 0.0, 0.0], &origin, r), Some(Equal));
        // 1 − 0.48 · 2⁻⁵² is not 1.
        let (u, v) = (1.0 - 431.0 * little(26), 61_571_941.0 * little(34));
        assert_eq!(compare_distance(&[u, v, 0.0], &origin, 1.0), Some(Less));
        // (1 + 2⁻⁴⁰)² − 2⁻³⁹ = 1 + 2⁻⁸⁰.
        let (n, x) = ([r, -1.0], [r, little(39)]);
        assert_eq!(compare_height(&n, &x, 1.0), Some(Greater));
        assert_eq!(compare_height(&n, &x, 1.0_f64.next_up()), Some(Less));
        assert_eq!(compare_height(&[0.5, 0.25], &[4.0, -2.0], 1.5), Some(Equal));
    }

    /// In one dimension the sphere is `c ± r`. On the outer side the box ends where the interval of
    /// that sum does, although the offset from the centre rounds.
    #[test]
    fn no_box_reaches_farther_from_the_centre_than_the_sphere() {
        for case in 1..2000 {
            let x = 1e3 * f64::from(case).sin();
            let (c, r) = (0.1, 0.7);
            let near = on_sphere(&[x], &[c], r).expect("finite")[0];
            let [lower, upper] = [-r, r].map(|r| Interval::point(r) + c);
            let pole = if x < c { lower } else { upper };
            assert!(lower.lo() <= near.lo() && near.hi() <= upper.hi(), "{near:?} for {x}");
            assert!(near.intersection(pole).is_some(), "{near:?} for {x}");
        }
    }

    #[test]
    fn nothing_is_proved_beyond_f64() {
        let (x, c) = ([f64::MAX], [-f64::MAX]);
        assert_eq!(compare_distance(&x, &c, f64::MAX), Some(Greater));
        assert_eq!(compare_distance(&[f64::NAN], &c, 1.0), None);
        assert!(on_sphere(&x, &c, 1.0).is_none());
        // A sphere of radius 0 is its centre, however far away the other point is.
        let near = [-4e307];
        assert_eq!(on_sphere(&x, &near, 0.0), Some(point(&near)));
        assert!(on_sphere(&[f64::INFINITY], &c, 1.0).is_none());
        assert!(finite(vec![Interval::REALS]).is_none());
        let one = Interval::point(1.0);
        for (i, side) in (0..3).zip([Interval::REALS, Interval::UNDEFINED, Interval::REALS]) {
            let mut member = vec![one, one, one];
            member[i] = side;
            assert!(finite(member.clone()).is_none(), "{member:?}");
        }
        assert_eq!(finite(point(&c)), Some(point(&c)));
    }
}
