//! Euclidean norms and directions, without overflow or underflow of squares.

#[cfg(test)]
use nalgebra::SVector;
use tautline_scalar::{Interval, Scalar};

use crate::numerics::place::{Place, largest};
use crate::numerics::proof::power_of_two;

/// Returns an upper bound on `|v|`, in the unit of `v`, that is tight up to some roundings; NaN if a
/// coordinate is undefined.
pub(crate) fn norm_above(v: &[Interval]) -> f64 {
    if v.iter().any(|x| x.is_undefined()) {
        return f64::NAN;
    }
    let sizes = || v.iter().map(|x| x.magnitude());
    let largest = sizes().fold(0.0, f64::max);
    if !largest.is_finite() || sizes().filter(|&size| size > 0.0).count() < 2 {
        return largest;
    }
    // Scaling is exact unless a size gets subnormal.
    let scale = power_of_two(largest);
    let scaled = sizes().map(|size| {
        let by_scale = size * (1.0 / scale);
        if by_scale >= f64::MIN_POSITIVE { by_scale } else { by_scale.next_up() }
    });
    let squares = scaled.map(|size| Interval::point(size).sqr());
    let sum = squares.fold(Interval::point(0.0), |sum, square| sum + square);
    let root = sum.sqrt().hi();
    // From 1 on, the product is exact or infinite. Below, all sizes are subnormal.
    if root >= 1.0 { root * scale } else { (Interval::point(root) * scale).hi() }
}

/// Returns `x − y`, enclosed.
pub(crate) fn between(x: &[f64], y: &[f64]) -> Vec<Interval> {
    x.iter().zip(y).map(|(&x, &y)| Interval::point(x) - y).collect()
}

/// Returns `a + b` rounded up, or as it is if a term is not finite.
pub(crate) fn sum_above(a: f64, b: f64) -> f64 {
    let sum = a + b;
    if a.is_finite() && b.is_finite() { (Interval::point(a) + b).hi() } else { sum }
}

/// The squares of coordinates in this range, and sums of up to 1e28 such squares, are far from
/// overflow (1e308). If a square underflows, its coordinate is less than 1e-14 times the largest, and
/// the square is less than the rounding of the sum: (1e-154/1e-140)² = 1e-28.
const ORDINARY: std::ops::RangeInclusive<f64> = 1e-140..=1e140;

/// Returns the root of the sum of squares, summed from left to right.
fn root(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Returns `v/scale`.
fn over(v: &[f64], scale: f64) -> Place {
    v.iter().map(|x| x / scale).collect()
}

/// Returns `|v|`, in the unit of `v`. The result is infinite only if `|v|` itself overflows.
pub(crate) fn norm(v: &[f64]) -> f64 {
    let largest = largest(v);
    if !ORDINARY.contains(&largest) && largest > 0.0 && largest.is_finite() {
        // This costs one more rounding per coordinate, so it is not used for ordinary numbers.
        root(&over(v, largest)) * largest
    } else {
        // The vector may be zero, infinite or NaN, and so is its plain norm.
        root(v)
    }
}

/// Returns `|v|` and the unit vector `v/|v|`, or `None` for `v = 0`.
pub(crate) fn polar(v: &[f64]) -> Option<(f64, Place)> {
    let largest = largest(v);
    if largest == 0.0 {
        return None;
    }
    if ORDINARY.contains(&largest) || !largest.is_finite() {
        let length = root(v);
        return Some((length, over(v, length)));
    }
    // The vector is scaled first, so that the direction is right even if |v| overflows.
    let scaled = over(v, largest);
    let length = root(&scaled);
    Some((length * largest, over(&scaled, length)))
}

/// Returns `length · eᵢ`. (`SVector::ith` does not exist while `D` is generic.)
#[cfg(test)]
pub(crate) fn on_axis<const D: usize>(i: usize, length: f64) -> SVector<f64, D> {
    SVector::from_fn(|j, _| if j == i { length } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::{norm, norm_above, polar, sum_above};
    use crate::numerics::place::{dot, largest, minus};
    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, cases, seed};
    use tautline_scalar::Interval;

    /// In up to three dimensions, sums of slices are those of vectors to the last bit.
    #[test]
    fn sums_are_those_of_vectors_in_space() {
        fn check<const D: usize>(random: &mut Random) {
            let mut vector = || SVector::<f64, D>::from_fn(|_, _| random.between(-2.0, 2.0));
            let (x, y) = (vector(), vector());
            assert_eq!(dot(x.as_slice(), y.as_slice()).to_bits(), x.dot(&y).to_bits());
            assert_eq!(norm(x.as_slice()).to_bits(), x.norm().to_bits());
            assert_eq!(largest(x.as_slice()), x.amax());
        }
        let mut random = Random(seed(34));
        for _ in 0..cases(500) {
            check::<1>(&mut random);
            check::<2>(&mut random);
            check::<3>(&mut random);
        }
    }

    #[test]
    fn norm_is_homogeneous_from_the_smallest_to_the_largest_number() {
        for exponent in -1074..=1020 {
            // The scale is computed in two steps, since 2^-1074 is not a normal number.
            let scale = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
            let v = vector![3.0, 4.0] * scale;
            // The allowance is four roundings.
            let error = (norm(v.as_slice()) / scale - 5.0).abs();
            assert!(error <= 5.0 * 4.0 * f64::EPSILON, "2^{exponent}: {error:e}");
            let (length, unit) = polar(v.as_slice()).expect("not zero");
            assert_eq!(length, norm(v.as_slice()));
            assert!(largest(&minus(&unit, &[0.6, 0.8])) <= 4.0 * f64::EPSILON);
        }
    }

    /// Where the norm is a double, its bound is this double; else it is at most two roundings above.
    #[test]
    fn the_bound_on_a_norm_is_tight_from_the_smallest_to_the_largest_number() {
        let bound = |v: SVector<f64, 2>| norm_above(v.map(Interval::point).as_slice());
        for exponent in -1020..=1020 {
            let scale = 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
            assert_eq!(bound(vector![3.0, -4.0] * scale), 5.0 * scale);
            // √2 lies between these neighbours.
            let root = 2.0_f64.sqrt();
            assert!(root * root > 2.0 && root.next_down().powi(2) < 2.0);
            let found = bound(vector![1.0, 1.0] * scale) / scale;
            assert!(found >= root && found <= root.next_up().next_up(), "{found:e}");
        }
        assert_eq!(bound(vector![0.0, -5e-324]), 5e-324);
        assert!(bound(vector![5e-324, 5e-324]) >= 1e-323);
        assert_eq!(bound(vector![f64::MAX, f64::MAX]), f64::INFINITY);
        assert_eq!(bound(SVector::zeros()), 0.0);
        assert!(bound(vector![f64::NAN, 1.0]).is_nan());
    }

    /// A coordinate far below the last place of the largest one makes the vector longer all the same,
    /// also if its square underflows, or it itself in the unit of the largest one.
    #[test]
    fn the_bound_on_a_norm_exceeds_each_of_two_coordinates() {
        let power = |exponent: i32| 2.0_f64.powi(exponent);
        for (large, small) in [
            (1.0, power(-30)),
            (1.0, power(-600)),
            (1.0, 5e-324),
            (power(1000), power(-1000)),
            (power(1023), 5e-324),
            (-power(600), -power(-500)),
            (power(-1022), 5e-324),
        ] {
            let tight = large.abs().next_up()..=large.abs().next_up().next_up();
            for v in [vector![large, small, 0.0], vector![small, 0.0, large]] {
                let found = norm_above(v.map(Interval::point).as_slice());
                assert!(tight.contains(&found), "{v}: {found:e}");
            }
        }
        for small in [power(-60), power(-600), 5e-324] {
            let found = sum_above(1.0, small);
            assert!(1.0 < found && found <= 1.0_f64.next_up().next_up(), "{small:e}: {found:e}");
        }
        assert_eq!((sum_above(1.0, 2.0), sum_above(1.0, f64::INFINITY)), (3.0, f64::INFINITY));
        assert!(sum_above(f64::NAN, 1.0).is_nan());
    }

    #[test]
    fn a_direction_is_right_if_the_length_overflows() {
        let (length, unit) = polar(&[f64::MAX, -f64::MAX]).expect("not zero");
        let half = 0.5_f64.sqrt();
        assert_eq!(length, f64::INFINITY);
        assert!(largest(&minus(&unit, &[half, -half])) <= 4.0 * f64::EPSILON);
    }

    #[test]
    fn zero_has_no_direction_and_nan_stays_nan() {
        assert_eq!(norm(&[0.0; 3]), 0.0);
        assert!(polar(&[0.0; 3]).is_none());
        assert!(norm(&[f64::NAN, 1.0]).is_nan());
        assert!(norm(&[1.0, f64::NAN]).is_nan());
        assert_eq!(norm(&[1.0, f64::NEG_INFINITY]), f64::INFINITY);
    }
}
