//! Proposition S.7: a set on which the discrete energy between two points is strictly convex.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use tautline_scalar::Interval;

use super::{ceiling, speeds::greatest_speed_in, spread::Moments};
use crate::{PaperRule, Setting, number::Number};

/// Returns `σ`, in `m²/ℓ²`. If it is positive, the discrete energy between two *points* is strictly
/// convex on the sequences with `|βₙ| ≤ B` (Proposition S.7).
///
/// ```text
/// σ = c₁ − 2 L_H B r − ½ M_H B² r²,     r = 1/(2N tan(π/2N)) (trapezoidal), 1/(2N sin(π/2N)) (left)
/// ```
///
/// By a discrete Poincaré inequality, the root mean square of a variation that vanishes at both
/// ends, taken at the nodes, is at most `r` times the root mean square of its differences. The
/// second variation is at least `2σ` times the mean square of the differences.
///
/// - `greatest`: the bound `B`, in `ℓ`.
///
/// Needs: `c₁`, `L_H` and `M_H` on the convex hull of these sequences; fixed ends. Overestimation:
/// the modulus is attained by the trapezoidal rule with `N = 2`, for a metric with the slopes
/// `±L_H` at the two midpoints.
///
/// Returns `None` if `M_H` is unknown, and `−∞` on overflow. At `N = 1` nothing varies, and
/// `σ = c₁`.
///
/// # Panics
///
/// If `greatest` is negative or NaN.
#[must_use]
pub fn convexity_modulus(
    constants: Constants,
    rule: PaperRule,
    greatest: f64,
    n: NonZeroUsize,
) -> Option<f64> {
    assert!(greatest >= 0.0, "the greatest difference must be nonnegative, got {greatest}");
    convexity_modulus_in(constants, rule, greatest, n)
}

/// Returns what [`convexity_modulus`] documents, in doubles or in intervals.
pub(super) fn convexity_modulus_in<T: Number>(
    constants: Constants,
    rule: PaperRule,
    greatest: T,
    n: NonZeroUsize,
) -> Option<T> {
    let (m_h, r) = (T::constant(constants.m_h()?), poincare(rule, n));
    let [two, half, l_h] = [2.0, 0.5, constants.l_h()].map(T::constant);
    Some(
        T::constant(constants.c1())
            - T::product([two, l_h, greatest, r])
            - T::product([half, m_h, greatest, greatest, r, r]),
    )
}

/// Returns the greatest ratio of the root mean square at the nodes to the root mean square of the
/// differences, over the variations that vanish at both ends. At `N = 1` there are none, and the
/// result is 0.
pub(super) fn poincare<T: Number>(rule: PaperRule, n: NonZeroUsize) -> T {
    let count = n.get() as f64;
    let half = T::constant(0.5);
    match rule {
        _ if n == NonZeroUsize::MIN => T::constant(0.0),
        PaperRule::Trapezoidal => half / ((T::half_pi() / count).tan() * count),
        PaperRule::LeftEndpoint => half / ((T::half_pi() / count).sin() * count),
    }
}

/// Computed quantities of a sequence between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BetweenPoints {
    /// The rule of the discrete energy.
    pub rule: PaperRule,
    /// The number of subintervals.
    pub n: NonZeroUsize,
    /// `E_N`, in `m²`.
    pub discrete_energy: f64,
    /// `L(γᵖˡ)`, in `m`, or another upper bound on the distance.
    pub length: f64,
    /// `max |βₙ|`, in `ℓ`.
    pub greatest_difference: f64,
    /// `((1/N) Σ |ρₙ|²)^{1/2}` over the inner points, in `m²/ℓ`, with `∂E_N/∂xₙ = −2hρₙ`.
    pub residual: f64,
}

impl BetweenPoints {
    /// Returns whether every number is nonnegative and finite.
    pub(super) fn is_valid(&self) -> bool {
        let &Self { discrete_energy, length, greatest_difference, residual, .. } = self;
        let numbers = [discrete_energy, length, greatest_difference, residual];
        numbers.iter().all(|number| *number >= 0.0 && number.is_finite())
    }
}

/// Returns `N sin(π/2N)`. The root mean square of the differences of a variation that vanishes at
/// both ends is at least twice this number times that of its values.
pub(super) fn wave<T: Number>(n: NonZeroUsize) -> T {
    let count = n.get() as f64;
    (T::half_pi() / count).sin() * count
}

/// Returns a lower bound on the minimum of `E_N` over *all* sequences between the two points, in
/// `m²`, if the energy is strictly convex where minimisers can be (Proposition S.7).
///
/// ```text
/// min E_N  ≥  E_N(x) − R²/(4σ N² sin²(π/2N)),      R² = (1/N) Σ |ρₙ|²
/// ```
///
/// `B` is chosen large enough for the computed sequence and, by Lemmas S.3 and S.5, for every
/// global minimiser. All of them then lie in one convex set on which the energy is strictly convex.
/// Hence the computed minimum is global, up to the error due to the residual.
///
/// Needs: the setting of Theorem 1.1 with `M_H`, and two points as ends. Nothing is assumed about
/// the computed sequence.
///
/// Returns `None` if `M_H` is unknown, if `σ ≤ 0`, or if a number in `computed` is negative,
/// infinite or NaN.
#[must_use]
pub fn strict_convexity(
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
) -> Option<f64> {
    Some(computed.discrete_energy - loss::<f64>(constants, dimension, computed)?)
}

/// Returns a lower bound like that of [`strict_convexity`], rounded down to the last digit.
///
/// - `computed`: upper bounds, all of them.
/// - `discrete_energy_at_least`: a lower bound on `E_N` of the same sequence, in `m²`.
///
/// Returns `None` as there.
#[must_use]
pub fn strict_convexity_outward(
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
    discrete_energy_at_least: f64,
) -> Option<f64> {
    let loss = loss::<Interval>(constants, dimension, computed)?;
    let least = (Interval::point(discrete_energy_at_least) - loss).lo();
    least.is_finite().then_some(least)
}

/// Returns `R²/(4σ N² sin²(π/2N))`, by which the minimum may be below the computed energy.
fn loss<T: Number>(constants: Constants, dimension: usize, computed: &BetweenPoints) -> Option<T> {
    let &BetweenPoints { rule, n, discrete_energy, length, greatest_difference, residual } =
        computed;
    if !computed.is_valid() {
        return None;
    }
    let setting = Setting::new(constants, length, dimension).ok()?;
    let [discrete_energy, length, greatest_difference, residual] =
        [discrete_energy, length, greatest_difference, residual].map(T::constant);
    // A minimiser is stationary, and its energy is at most that of the computed sequence and at
    // most d² e.
    let by_momentum = greatest_speed_in(constants, discrete_energy, T::constant(0.0), n);
    let by_spread = length * greatest_ratio::<T>(setting, rule, n);
    let minimisers = by_momentum.least(by_spread) / T::constant(constants.c1()).sqrt();
    let greatest = greatest_difference.greatest(minimisers);
    let modulus = convexity_modulus_in(constants, rule, greatest, n)?;
    modulus.is_positive().then(|| {
        let left = residual / wave::<T>(n);
        left * left / (modulus * 4.0)
    })
}

/// Bounds `max qₙ/d` for a minimiser by `√ε + R`, using the spread of its speeds.
fn greatest_ratio<T: Number>(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> T {
    let spread = |surplus: T, spread: Moments<T>| (surplus + 1.0).sqrt() + spread.deviation;
    let surplus = ceiling::first_order(setting, rule, n);
    let first = spread(surplus, Moments::of_first_order(setting, rule, n, surplus));
    let second = match rule {
        PaperRule::Trapezoidal => ceiling::second_variation(setting, n).and_then(|surplus| {
            Some(spread(surplus, Moments::of_second_order(setting, n, surplus)?))
        }),
        PaperRule::LeftEndpoint => None,
    };
    second.map_or(first, |second| first.least(second))
}

#[cfg(test)]
mod tests {
    use super::{
        BetweenPoints, convexity_modulus, poincare, strict_convexity, strict_convexity_outward,
    };
    use crate::{
        Constants, PaperRule, Setting, Spread,
        by_hand::{self, n, with_m_h},
        theorem_a_minimum_gap, theorem_d_minimum_gap,
    };

    fn constants() -> Constants {
        with_m_h(4.0, 9.0, 1.0, 2.0)
    }

    fn without_m_h() -> Constants {
        by_hand::constants(4.0, 9.0, 1.0)
    }

    #[test]
    fn the_modulus_by_hand() {
        // N = 2: r = 1/(4 tan 45°) = 1/4, and 1/(4 sin 45°) = √2/4.
        for (rule, count, expected) in [
            (PaperRule::Trapezoidal, 2, 4.0 - 2.0 - 1.0),
            (PaperRule::LeftEndpoint, 2, 4.0 - 2.0 * 2_f64.sqrt() - 2.0),
            (PaperRule::LeftEndpoint, 1, 4.0),
        ] {
            let value = convexity_modulus(constants(), rule, 4.0, n(count)).expect("M_H");
            assert!((value - expected).abs() < 4e-15, "{rule:?}: {value} is not {expected}");
        }
        assert_eq!(convexity_modulus(without_m_h(), PaperRule::LeftEndpoint, 4.0, n(2)), None);
    }

    /// The variation is `yₙ = sin(nπ/N)`; the constant tends to `1/π`.
    #[test]
    fn the_poincare_inequality_is_attained_by_a_sine() {
        for count in [2, 3, 8, 50] {
            let y = |k: usize| (std::f64::consts::PI * k as f64 / count as f64).sin();
            let sum = |f: &dyn Fn(usize) -> f64| (0..count).map(|k| f(k).powi(2)).sum::<f64>();
            let differences = sum(&|k| count as f64 * (y(k + 1) - y(k)));
            for (rule, moved) in [
                (PaperRule::Trapezoidal, sum(&|k| 0.5 * (y(k) + y(k + 1)))),
                (PaperRule::LeftEndpoint, sum(&y)),
            ] {
                let ratio = (moved / differences).sqrt();
                let r: f64 = poincare(rule, n(count));
                // The sums have at most 50 terms.
                assert!((ratio / r - 1.0).abs() < 1e-13, "{rule:?}, N = {count}: {ratio} and {r}");
            }
        }
        let limit: f64 = poincare(PaperRule::Trapezoidal, n(1 << 20));
        assert!((limit * std::f64::consts::PI - 1.0).abs() < 1e-11);
    }

    fn computed(length: f64, residual: f64) -> BetweenPoints {
        BetweenPoints {
            rule: PaperRule::Trapezoidal,
            n: n(64),
            discrete_energy: length * length,
            length,
            greatest_difference: 0.6 * length,
            residual,
        }
    }

    #[test]
    fn for_near_ends_the_computed_minimum_is_global() {
        let exact = strict_convexity(constants(), 2, &computed(0.5, 0.0));
        assert_eq!(exact, Some(0.25));
        let left = strict_convexity(constants(), 2, &computed(0.5, 0.1)).expect("convex");
        let lost = 0.25 - left;
        // σ = 4 − 0.6 r − 0.09 r² with r = 1/π, and the loss is 0.01/(4σ (π/2)²).
        assert!((lost / 2.6665e-4 - 1.0).abs() < 1e-3, "{lost}");
        assert_eq!(strict_convexity(constants(), 2, &computed(50.0, 0.0)), None);
        assert_eq!(strict_convexity(without_m_h(), 2, &computed(0.5, 0.0)), None);
    }

    /// For a computed sequence with nine times the least energy and zero speed, the spread of the
    /// speeds (the smaller of two bounds) gives a better bound than the momentum.
    #[test]
    fn the_spread_bounds_the_speeds_of_a_minimiser() {
        let setting = Setting::new(constants(), 0.5, 2).expect("valid");
        let ratio = |gap: f64, spread: &dyn Fn(f64) -> Spread| {
            let surplus = gap / 0.25;
            (1.0 + surplus).sqrt() + spread(surplus).deviation
        };
        for rule in PaperRule::BOTH {
            let first = theorem_a_minimum_gap(setting, rule, n(64));
            let first = ratio(first, &|e| Spread::of_first_order(setting, rule, n(64), e));
            let second = theorem_d_minimum_gap(setting, n(64)).expect("M_H");
            let second =
                ratio(second, &|e| Spread::of_second_order(setting, n(64), e).expect("M_H"));
            let least = match rule {
                PaperRule::Trapezoidal => first.min(second),
                PaperRule::LeftEndpoint => first,
            };
            let greatest = 0.5 * least / 2.0;
            let modulus = convexity_modulus(constants(), rule, greatest, n(64)).expect("M_H");
            let slow = BetweenPoints { rule, discrete_energy: 2.25, ..computed(0.5, 1.0) };
            let slow = BetweenPoints { greatest_difference: 0.0, ..slow };
            let found = strict_convexity(constants(), 2, &slow).expect("convex");
            let wave = 64.0 * (std::f64::consts::FRAC_PI_2 / 64.0).sin();
            let lost = 1.0 / (4.0 * modulus * wave * wave);
            // This allows for about twenty roundings of numbers up to 4, relative to a difference
            // of 0.03.
            assert!(((2.25 - found) / lost - 1.0).abs() < 1e-12, "{rule:?}: {found}, {lost}");
        }
    }

    /// For ends close together and the left-endpoint rule, `√E + (L_H/c₁^{3/2}) E` is better than
    /// the bound from the spread. It depends on the energy of the sequence, not on its length.
    #[test]
    fn the_momentum_bounds_the_speeds_of_a_minimiser() {
        for (energy, speed) in [(0.25_f64, 0.5 + 0.25 / 8.0), (0.2601, 0.51 + 0.2601 / 8.0)] {
            let still = BetweenPoints {
                rule: PaperRule::LeftEndpoint,
                greatest_difference: 0.0,
                discrete_energy: energy,
                ..computed(0.5, 1.0)
            };
            let found = strict_convexity(constants(), 2, &still).expect("convex");
            let (b, angle) = (0.5 * speed, std::f64::consts::FRAC_PI_2 / 64.0);
            let r = 1.0 / (128.0 * angle.sin());
            let modulus = 4.0 - 2.0 * b * r - (b * r).powi(2);
            let lost = 1.0 / (4.0 * modulus * (64.0 * angle.sin()).powi(2));
            // This allows for about twenty roundings of numbers up to 4, relative to a difference
            // of 0.03.
            assert!(((energy - found) / lost - 1.0).abs() < 1e-12, "{energy}: {found}, {lost}");
        }
    }

    /// With one chord the energy exceeds the minimum by at most `R²/4c₁`. The difference of two
    /// doubles within a factor of 2 is exact, and a fused product has the right sign.
    #[test]
    fn the_least_energy_is_rounded_down() {
        let mut nearest_fails = 0;
        for (c1, residual) in (2..100_u8).flat_map(|c1| (1..6_u8).map(move |r| (c1, r))) {
            let (c1, residual) = (f64::from(c1), f64::from(residual));
            let constants = with_m_h(c1, 400.0, 1.0, 2.0);
            for rule in PaperRule::BOTH {
                let energy = 8.0;
                let one = BetweenPoints {
                    rule,
                    n: n(1),
                    discrete_energy: energy,
                    length: 1.0,
                    greatest_difference: 1.0,
                    residual,
                };
                let is_too_much =
                    |least: f64| (energy - least).mul_add(4.0 * c1, -(residual * residual)) < 0.0;
                let least = strict_convexity_outward(constants, 2, &one, energy).expect("convex");
                let lost = residual * residual / (4.0 * c1);
                // A few roundings of numbers up to 8, and those of the sine of π/2.
                assert!(!is_too_much(least) && energy - least <= lost + 1e-13, "{one:?}: {least}");
                let nearest = strict_convexity(constants, 2, &one).expect("convex");
                nearest_fails += usize::from(is_too_much(nearest));
            }
        }
        assert!(nearest_fails > 100, "{nearest_fails}");
    }

    #[test]
    fn both_sequences_must_lie_in_the_convex_set() {
        let wild = BetweenPoints { greatest_difference: 100.0, ..computed(0.5, 0.0) };
        assert_eq!(strict_convexity(constants(), 2, &wild), None);
        // The computed sequence is slow, but a minimiser may be fast.
        let far = BetweenPoints { greatest_difference: 0.1, ..computed(50.0, 0.0) };
        assert_eq!(strict_convexity(constants(), 2, &far), None);
    }

    #[test]
    fn invalid_numbers_give_none() {
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            let good = computed(0.5, 0.0);
            for computed in [
                BetweenPoints { discrete_energy: bad, ..good },
                BetweenPoints { length: bad, ..good },
                BetweenPoints { greatest_difference: bad, ..good },
                BetweenPoints { residual: bad, ..good },
            ] {
                assert_eq!(strict_convexity(constants(), 2, &computed), None);
            }
        }
    }
}
