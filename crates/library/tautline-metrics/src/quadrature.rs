//! Gauss–Kronrod quadrature: integrals of smooth functions over an interval, with an error estimate.

use std::ops::AddAssign;

/// A computed integral and an estimate of its error, in the same unit.
///
/// The error is the difference between two rules of different order. It is an estimate, not a
/// bound.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Integral {
    /// The value.
    pub value: f64,
    /// The estimated absolute error.
    pub error: f64,
}

impl AddAssign for Integral {
    fn add_assign(&mut self, other: Integral) {
        self.value += other.value;
        self.error += other.error;
    }
}

/// The nodes of the 7-point Kronrod rule on `[−1, 1]`.
///
/// A. S. Kronrod, *Nodes and Weights of Quadrature Formulas*, 1965. The rule is exact for
/// polynomials of degree 11.
const PLACES: [f64; 7] = [0.0, -INNER, INNER, -MIDDLE, MIDDLE, -OUTER, OUTER];
const INNER: f64 = 0.434_243_749_346_802_56;
const MIDDLE: f64 = 0.774_596_669_241_483_4;
const OUTER: f64 = 0.960_491_268_708_020_3;

/// The weights of the nodes, for this rule and for the 3-point Gauss rule on a subset of the nodes,
/// which is exact for polynomials of degree 5.
const WEIGHTS: [(f64, f64); 7] = {
    let (centre, inner) = ((0.450_916_538_658_474_14, 8.0 / 9.0), (0.401_397_414_775_962_2, 0.0));
    let (middle, outer) = ((0.268_488_089_868_333_44, 5.0 / 9.0), (0.104_656_226_026_467_27, 0.0));
    [centre, inner, inner, middle, middle, outer, outer]
};

/// The nodes on `[0, 1]` at which [`integrate`] evaluates an integrand first.
pub const FIRST_NODES: [f64; 7] = {
    let mut nodes = PLACES;
    let mut k = 0;
    while k < nodes.len() {
        nodes[k] = 0.5 + 0.5 * PLACES[k];
        k += 1;
    }
    nodes
};

/// Returns `∫₀¹ f` from the values of `f` at the [`FIRST_NODES`], or `None` if [`integrate`] would
/// halve the interval. A NaN value ends the subdivision.
#[must_use]
pub fn integral_by_values(values: &[f64; 7], tolerance: f64) -> Option<Integral> {
    let (integral, magnitude) = by_values(values, 0.5);
    let is_last = is_enough(integral, magnitude, tolerance) || integral.value.is_nan();
    is_last.then_some(integral)
}

/// Returns whether the error is small enough. Below `4 ε |f|` the two rules differ only by
/// rounding.
fn is_enough(integral: Integral, magnitude: f64, tolerance: f64) -> bool {
    integral.error <= tolerance.max(4.0 * f64::EPSILON) * magnitude
}

/// The relative tolerance for smooth integrands: a few roundings, so that the quadrature adds none of its own
/// to an integral.
pub const FEW_ROUNDINGS: f64 = 4.0 * f64::EPSILON;

/// The number of intervals allowed. Here only a singular integrand needs more.
const MAX_INTERVALS: usize = 4096;

/// Returns `∫ₐᵇ f`. It halves intervals until the estimated error on each is at most `tolerance`
/// times the integral of `|f|` over it (or until rounding is reached).
///
/// The subdivision always ends. A singular integrand ends it after at most 4096 intervals with a
/// large error estimate, and an integrand that is NaN somewhere gives the value NaN.
pub fn integrate(f: impl Fn(f64) -> f64, a: f64, b: f64, tolerance: f64) -> Integral {
    integrate_by_sevens(&mut |nodes| nodes.map(&f), a, b, tolerance, 0.0)
}

/// Returns `∫ₐᵇ f` like [`integrate`], for an integrand that is evaluated at seven nodes at a time. An
/// interval is not halved either if its estimated error is at most `least`, in the unit of the integral.
// This is compiled once for all integrands; an indirect call costs little compared with a metric.
pub fn integrate_by_sevens(
    f: &mut dyn FnMut([f64; 7]) -> [f64; 7],
    a: f64,
    b: f64,
    tolerance: f64,
    least: f64,
) -> Integral {
    let mut total = Integral::default();
    // The intervals still to be done, all of which lie to the right of [a, b].
    let mut pending = Vec::new();
    let mut next = Some((a, b));
    let mut intervals = 0;
    while let Some((a, b)) = next {
        let (integral, magnitude) = kronrod(f, a, b);
        intervals += 1;
        let enough = is_enough(integral, magnitude, tolerance) || integral.error <= least;
        let middle = 0.5 * (a + b);
        let exhausted = intervals + pending.len() >= MAX_INTERVALS || middle == a || middle == b;
        if enough || exhausted || integral.value.is_nan() {
            total += integral;
            next = pending.pop();
        } else {
            pending.push((middle, b));
            next = Some((a, middle));
        }
    }
    total
}

/// Applies the rule once and returns the integral with its error, and the integral of `|f|`.
fn kronrod(f: &mut dyn FnMut([f64; 7]) -> [f64; 7], a: f64, b: f64) -> (Integral, f64) {
    let (centre, half) = (0.5 * (a + b), 0.5 * (b - a));
    by_values(&f(PLACES.map(|place| centre + half * place)), half)
}

/// Does the same, given the values at the [`PLACES`].
fn by_values(values: &[f64; 7], half: f64) -> (Integral, f64) {
    let (mut kronrod, mut gauss, mut magnitude) = (0.0, 0.0, 0.0);
    for (y, (weight, gauss_weight)) in values.iter().zip(WEIGHTS) {
        kronrod += weight * y;
        gauss += gauss_weight * y;
        magnitude += weight * y.abs();
    }
    // This is the sharpening used in QUADPACK: the difference is the error of the Gauss rule, and
    // the Kronrod rule is better by the factor (200 × relative difference)^{1/2} where this factor
    // is small.
    let mean = 0.5 * kronrod;
    let terms = values.iter().zip(WEIGHTS);
    let spread: f64 = terms.map(|(y, (weight, _))| weight * (y - mean).abs()).sum();
    let difference = (kronrod - gauss).abs();
    let error = if spread > 0.0 {
        let relative = 200.0 * difference / spread;
        spread * (relative * relative.sqrt()).min(1.0)
    } else {
        difference
    };
    // The last term is the rounding of a sum of seven terms.
    let error = error.max(2.0 * f64::EPSILON * magnitude);
    let integral = Integral { value: kronrod * half, error: error * half.abs() };
    (integral, magnitude * half.abs())
}

#[cfg(test)]
mod tests {
    use super::{FIRST_NODES, Integral, integral_by_values, integrate};

    fn kronrod(f: impl Fn(f64) -> f64, a: f64, b: f64) -> (Integral, f64) {
        super::kronrod(&mut |nodes| nodes.map(&f), a, b)
    }

    /// The rule is exact up to degree 11, so a mistyped node or weight fails here.
    #[test]
    fn polynomials_of_degree_11_are_exact() {
        for degree in 0..=11 {
            let integral = kronrod(|x| x.powi(degree), -1.0, 2.0).0.value;
            let k = f64::from(degree + 1);
            let exact = (2.0_f64.powi(degree + 1) - (-1.0_f64).powi(degree + 1)) / k;
            approx::assert_relative_eq!(integral, exact, max_relative = 1e-14);
        }
        let wrong = kronrod(|x| x.powi(14), -1.0, 2.0).0.value;
        assert!((wrong - 2_f64.powi(15) / 15.0).abs() > 1e-6, "but degree 14 is not");
    }

    #[test]
    fn smooth_integrals_are_exact_to_rounding() {
        let integral = integrate(f64::exp, 0.0, 10.0, 1e-15);
        approx::assert_relative_eq!(integral.value, 10_f64.exp() - 1.0, max_relative = 1e-14);
        assert!(integral.error < 1e-10 * integral.value);
        let backwards = integrate(f64::cos, 1.0, 0.0, 1e-15);
        approx::assert_relative_eq!(backwards.value, -1_f64.sin(), max_relative = 1e-14);
    }

    /// The Gauss rule misses 16 % of `x⁶`, so the error is `Σ w |y − mean|` with the mean 1/7.
    #[test]
    fn the_error_is_the_spread_where_the_rules_differ_widely() {
        let (integral, magnitude) = kronrod(|x| x.powi(6), -1.0, 1.0);
        approx::assert_relative_eq!(integral.error, 0.34743770314862704, max_relative = 1e-14);
        approx::assert_relative_eq!(magnitude, 2.0 / 7.0, max_relative = 1e-14);
    }

    #[test]
    fn integrals_and_their_errors_add_up() {
        let mut sum = Integral { value: 1.0, error: 0.5 };
        sum += Integral { value: 2.0, error: 0.25 };
        assert_eq!(sum, Integral { value: 3.0, error: 0.75 });
    }

    /// The integrand is a scramble of the bits of `x`, which no number of intervals resolves. The
    /// subdivision ends when 4096 intervals of seven nodes, plus one, are done or pending, or when
    /// it reaches neighbouring numbers.
    #[test]
    fn noise_exhausts_the_intervals_or_the_numbers() {
        let noise = |x: f64| (x.to_bits().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 40) as f64;
        let (integral, count) = evaluations(noise, 1.0, 2.0, 1e-12);
        assert!(integral.error > 0.0);
        assert_eq!(count, 7 * 4097);
        // The interval has eight spacings, so there are at most 15 intervals.
        let (integral, count) = evaluations(noise, 1.0, 1.0 + 8.0 * f64::EPSILON, 1e-12);
        assert!(integral.error > 0.0 && count <= 7 * 15);
    }

    /// Returns the integral and the number of times that `integrate` evaluates the integrand.
    fn evaluations(f: impl Fn(f64) -> f64, a: f64, b: f64, tolerance: f64) -> (Integral, usize) {
        let count = std::cell::Cell::new(0);
        let counted = |x: f64| {
            count.set(count.get() + 1);
            f(x)
        };
        (integrate(counted, a, b, tolerance), count.get())
    }

    #[test]
    fn reversed_limits_change_only_the_sign() {
        for f in [f64::exp, |x: f64| (20.0 * x).cos(), |x: f64| 1.0 / (1.0 + x * x)] {
            let (there, count) = evaluations(f, -1.0, 3.0, 1e-13);
            let (back, again) = evaluations(f, 3.0, -1.0, 1e-13);
            assert_eq!(count, again);
            approx::assert_relative_eq!(back.value, -there.value, max_relative = 1e-13);
            approx::assert_relative_eq!(back.error, there.error, max_relative = 1e-6);
            assert!(there.error > 0.0);
        }
    }

    #[test]
    fn the_first_values_decide_whether_an_interval_is_halved() {
        let steep: fn(f64) -> f64 = |x| (30.0 * x).sin();
        let functions: [fn(f64) -> f64; 6] =
            [f64::exp, |_| 0.0, |_| -3.0, |x| x.powi(11), |x| (x - 0.3).abs(), |_| f64::NAN];
        let mut done = [0, 0];
        for f in functions.into_iter().chain([steep]) {
            for tolerance in [0.0, 1e-12, 1e-3, 2.0] {
                let by_values = integral_by_values(&FIRST_NODES.map(f), tolerance);
                let (integral, count) = evaluations(f, 0.0, 1.0, tolerance);
                assert_eq!(by_values.is_some(), count == 7, "{tolerance} {count}");
                let bits = |integral: Integral| [integral.value, integral.error].map(f64::to_bits);
                assert!(by_values.is_none_or(|found| bits(found) == bits(integral)));
                done[usize::from(by_values.is_some())] += 1;
            }
        }
        assert!(done.iter().all(|&count| count >= 5), "{done:?}");
    }

    /// No interval is halved if the rules differ only by rounding or if a value is NaN.
    #[test]
    fn nothing_is_halved_in_vain() {
        assert_eq!(evaluations(|_| 3.0, 0.0, 1.0, 0.0).1, 7);
        assert!(evaluations(f64::exp, 0.0, 1.0, 0.0).1 <= 7 * 31);
        assert_eq!(evaluations(|_| f64::NAN, 0.0, 1.0, 1e-12).1, 7);
        let (half, count) = evaluations(|x| (x - 0.5).ln(), 0.0, 1.0, 1e-12);
        assert!(half.value.is_nan() && count == 7, "{count}");
    }

    /// Rounding counts as an error too, for values of either sign: it is 2 ε times the integral of
    /// `|f|`.
    #[test]
    fn the_error_is_no_less_than_rounding() {
        for f in [|_: f64| 3.0, |_: f64| -3.0] {
            let (integral, magnitude) = kronrod(f, 0.0, 2.0);
            approx::assert_relative_eq!(magnitude, 6.0, max_relative = 1e-14);
            assert!(integral.error >= 1.9 * f64::EPSILON * 6.0, "{integral:?}");
        }
        // The integral of an odd function is 0, although its values are large.
        let (integral, magnitude) = kronrod(|x| x, -2.0, 2.0);
        assert!(
            magnitude > 3.5 && integral.error >= 1.9 * f64::EPSILON * magnitude,
            "{integral:?}"
        );
        assert!(integral.value.abs() <= integral.error);
    }

    /// There is no number between two neighbours, whichever of the two their mean rounds to.
    #[test]
    fn neighbours_are_not_halved() {
        // The two rules disagree about these values.
        let jump = |x: f64| (x.to_bits() & 1) as f64;
        let mut x = 1.0_f64;
        for _ in 0..16 {
            for (a, b) in [(x, x.next_up()), (x.next_up(), x), (-x, -x.next_up())] {
                assert!(evaluations(jump, a, b, 1e-12).1 <= 7 * 2, "{a:e} {b:e}");
            }
            x = x.next_up();
        }
    }

    #[test]
    fn a_singular_integrand_ends_with_a_large_error() {
        let integral = integrate(|x| 1.0 / x, 0.0, 1.0, 1e-12);
        assert!(!(integral.error < 1e-3));
        assert!(integrate(|_| f64::NAN, 0.0, 1.0, 1e-12).value.is_nan());
    }
}
