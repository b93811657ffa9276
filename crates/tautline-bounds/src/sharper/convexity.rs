//! Proposition S.7: a discrete energy that is strictly convex where its minimisers are, and has no
//! other minimum there.

use std::{f64::consts::FRAC_PI_2, num::NonZeroUsize};

use tautline_metrics::Constants;

use super::{ceiling, speeds::greatest_speed, spread::Spread};
use crate::{PaperRule, Setting, product::product};

/// Returns `σ`, in `m²/ℓ²`: where it is positive, the discrete energy between two *points* is
/// strictly convex on the sequences with `|βₙ| ≤ B` (Proposition S.7).
///
/// ```text
/// σ = c₁ − 2 L_H B r − ½ M_H B² r²,     r = 1/(2N tan(π/2N)) (trapezoidal), 1/(2N sin(π/2N)) (left)
/// ```
///
/// A variation `y` that vanishes at both ends moves the points where `H` is read by `r` times what
/// it moves the differences at most, in the mean square: the discrete inequality of Poincaré. The
/// second variation in its direction is at least `2σ` times the mean square of its differences.
///
/// - `greatest`: `B`, in `ℓ`.
///
/// Needs: `c₁`, `L_H` and `M_H` on the convex hull of such sequences; fixed ends. Overestimation:
/// none for the trapezoidal rule with `N = 2`, over a metric with the slopes `±L_H` at the two
/// midpoints.
///
/// Returns `None` if `M_H` is not known; `−∞` on overflow. At `N = 1` nothing can vary, and
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
    assert!(greatest >= 0.0, "a greatest norm, got {greatest}");
    let m_h = constants.m_h()?;
    let r = poincare(rule, n);
    Some(
        constants.c1()
            - product([2.0, constants.l_h(), greatest, r])
            - product([0.5, m_h, greatest, greatest, r, r]),
    )
}

/// The greatest ratio of the mean squares of what moves where `H` is read, and of the differences,
/// for variations that vanish at both ends; 0 at `N = 1`, where there are none.
fn poincare(rule: PaperRule, n: NonZeroUsize) -> f64 {
    let count = n.get() as f64;
    match rule {
        _ if n == NonZeroUsize::MIN => 0.0,
        PaperRule::Trapezoidal => 0.5 / (count * (FRAC_PI_2 / count).tan()),
        PaperRule::LeftEndpoint => 0.5 / (count * (FRAC_PI_2 / count).sin()),
    }
}

/// What was computed of a sequence between two points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BetweenPoints {
    /// The rule of the discrete energy.
    pub rule: PaperRule,
    /// The number of subintervals.
    pub n: NonZeroUsize,
    /// `E_N`, in `m²`.
    pub discrete_energy: f64,
    /// `L(γᵖˡ)`, in `m`, or another upper bound of the distance.
    pub length: f64,
    /// `max |βₙ|`, in `ℓ`.
    pub greatest_difference: f64,
    /// `((1/N) Σ |ρₙ|²)^{1/2}` over the inner points, in `m²/ℓ`, with `∂E_N/∂xₙ = −2hρₙ`.
    pub residual: f64,
}

/// Returns a lower bound of the minimum of `E_N` over *all* sequences between the two points, in
/// `m²`, if the energy is strictly convex where they can be (Proposition S.7).
///
/// ```text
/// min E_N  ≥  E_N(x) − R²/(4σ N² sin²(π/2N)),      R² = (1/N) Σ |ρₙ|²
/// ```
///
/// `B` covers the computed sequence and, by Lemmas S.3 and S.5, every global minimiser; both lie in
/// one convex set on which the energy is strictly convex. So the computed minimum is the global
/// one, up to what the residual leaves.
///
/// Needs: the setting of Theorem 1.1 with `M_H`, both ends points. Nothing is assumed of the
/// computed sequence.
///
/// Returns `None` if `M_H` is not known, if `σ ≤ 0`, or if a number of `computed` is negative,
/// infinite or NaN: then nothing is said.
#[must_use]
pub fn strict_convexity(
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
) -> Option<f64> {
    let &BetweenPoints { rule, n, discrete_energy, length, greatest_difference, residual } =
        computed;
    let numbers = [discrete_energy, length, greatest_difference, residual];
    if !numbers.iter().all(|number| *number >= 0.0 && number.is_finite()) {
        return None;
    }
    let setting = Setting::new(constants, length, dimension).ok()?;
    // Of a minimiser: stationary, with no more energy than the computed sequence, and d² e at most.
    let by_momentum = greatest_speed(constants, discrete_energy, 0.0, n);
    let by_spread = length * greatest_ratio(setting, rule, n);
    let minimisers = by_momentum.min(by_spread) / constants.c1().sqrt();
    let greatest = greatest_difference.max(minimisers);
    let modulus = convexity_modulus(constants, rule, greatest, n)?;
    if modulus > 0.0 {
        let count = n.get() as f64;
        let wave = count * (FRAC_PI_2 / count).sin();
        let left = residual / wave;
        Some(discrete_energy - left * left / (4.0 * modulus))
    } else {
        None
    }
}

/// Bounds `max qₙ/d` of a minimiser: `√ε + R`, with the spread of its speeds.
fn greatest_ratio(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let spread = |surplus: f64, spread: Spread| (1.0 + surplus).sqrt() + spread.deviation;
    let surplus = ceiling::first_order(setting, rule, n);
    let first = spread(surplus, Spread::of_first_order(setting, rule, n, surplus));
    let second = match rule {
        PaperRule::Trapezoidal => ceiling::second_variation(setting, n).and_then(|surplus| {
            Some(spread(surplus, Spread::of_second_order(setting, n, surplus)?))
        }),
        PaperRule::LeftEndpoint => None,
    };
    second.map_or(first, |second| first.min(second))
}

#[cfg(test)]
mod tests {
    use super::{BetweenPoints, convexity_modulus, poincare, strict_convexity};
    use crate::{
        Constants, PaperRule, Setting, Spread, theorem_a_minimum_gap, theorem_d_minimum_gap,
    };
    use std::num::NonZeroUsize;

    fn n(n: usize) -> NonZeroUsize {
        NonZeroUsize::new(n).expect("positive")
    }

    fn constants(m_h: f64) -> Constants {
        Constants::new(4.0, 9.0, 1.0).and_then(|c| c.with_m_h(m_h)).expect("in order")
    }

    #[test]
    fn the_modulus_by_hand() {
        // N = 2: r = 1/(4 tan 45°) = 1/4, and 1/(4 sin 45°) = √2/4.
        let close = |value: Option<f64>, expected: f64| {
            let value = value.expect("M_H");
            assert!((value - expected).abs() < 4e-15, "{value} is not {expected}");
        };
        close(
            convexity_modulus(constants(2.0), PaperRule::Trapezoidal, 4.0, n(2)),
            4.0 - 2.0 - 1.0,
        );
        let left = 4.0 - 2.0 * 2_f64.sqrt() - 2.0;
        close(convexity_modulus(constants(2.0), PaperRule::LeftEndpoint, 4.0, n(2)), left);
        close(convexity_modulus(constants(2.0), PaperRule::LeftEndpoint, 4.0, n(1)), 4.0);
        let unknown = Constants::new(4.0, 9.0, 1.0).expect("in order");
        assert_eq!(convexity_modulus(unknown, PaperRule::LeftEndpoint, 4.0, n(2)), None);
    }

    /// `y_n = sin(nπ/N)` attains it; `1/π` in the limit.
    #[test]
    fn the_inequality_of_poincare_is_attained_by_a_sine() {
        for count in [2, 3, 8, 50] {
            let y = |k: usize| (std::f64::consts::PI * k as f64 / count as f64).sin();
            let sum = |f: &dyn Fn(usize) -> f64| (0..count).map(|k| f(k).powi(2)).sum::<f64>();
            let differences = sum(&|k| count as f64 * (y(k + 1) - y(k)));
            for (rule, moved) in [
                (PaperRule::Trapezoidal, sum(&|k| 0.5 * (y(k) + y(k + 1)))),
                (PaperRule::LeftEndpoint, sum(&y)),
            ] {
                let ratio = (moved / differences).sqrt();
                let r = poincare(rule, n(count));
                // Sums of at most 50 terms.
                assert!((ratio / r - 1.0).abs() < 1e-13, "{rule:?}, N = {count}: {ratio} and {r}");
            }
        }
        let limit = poincare(PaperRule::Trapezoidal, n(1 << 20));
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
    fn where_the_ends_are_near_the_computed_minimum_is_global() {
        let exact = strict_convexity(constants(2.0), 2, &computed(0.5, 0.0));
        assert_eq!(exact, Some(0.25));
        let left = strict_convexity(constants(2.0), 2, &computed(0.5, 0.1)).expect("convex");
        let lost = 0.25 - left;
        // σ = 4 − 0.6 r − 0.09 r² with r = 1/π, and 0.01/(4σ (π/2)²).
        assert!((lost / 2.6665e-4 - 1.0).abs() < 1e-3, "{lost}");
        assert_eq!(strict_convexity(constants(2.0), 2, &computed(50.0, 0.0)), None);
        let unknown = Constants::new(4.0, 9.0, 1.0).expect("in order");
        assert_eq!(strict_convexity(unknown, 2, &computed(0.5, 0.0)), None);
    }

    /// A computed sequence of nine times the least energy and without a speed: it is the spread of
    /// the speeds that bounds those of a minimiser, by the lesser of both ways.
    #[test]
    fn the_spread_of_the_speeds_bounds_those_of_a_minimiser() {
        let setting = Setting::new(constants(2.0), 0.5, 2).expect("valid");
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
            let modulus = convexity_modulus(constants(2.0), rule, greatest, n(64)).expect("M_H");
            let slow = BetweenPoints { rule, discrete_energy: 2.25, ..computed(0.5, 1.0) };
            let slow = BetweenPoints { greatest_difference: 0.0, ..slow };
            let found = strict_convexity(constants(2.0), 2, &slow).expect("convex");
            let wave = 64.0 * (std::f64::consts::FRAC_PI_2 / 64.0).sin();
            let lost = 1.0 / (4.0 * modulus * wave * wave);
            // Some twenty roundings of numbers up to 4, of a difference of 0.03.
            assert!(((2.25 - found) / lost - 1.0).abs() < 1e-12, "{rule:?}: {found}, {lost}");
        }
    }

    /// The other way round: for near ends and the left-endpoint rule `√E + (L_H/c₁^{3/2}) E` is
    /// less than the spread allows. It grows with the energy that the sequence has, not with its
    /// length.
    #[test]
    fn the_momentum_bounds_the_speeds_of_a_minimiser() {
        for (energy, speed) in [(0.25_f64, 0.5 + 0.25 / 8.0), (0.2601, 0.51 + 0.2601 / 8.0)] {
            let still = BetweenPoints {
                rule: PaperRule::LeftEndpoint,
                greatest_difference: 0.0,
                discrete_energy: energy,
                ..computed(0.5, 1.0)
            };
            let found = strict_convexity(constants(2.0), 2, &still).expect("convex");
            let (b, angle) = (0.5 * speed, std::f64::consts::FRAC_PI_2 / 64.0);
            let r = 1.0 / (128.0 * angle.sin());
            let modulus = 4.0 - 2.0 * b * r - (b * r).powi(2);
            let lost = 1.0 / (4.0 * modulus * (64.0 * angle.sin()).powi(2));
            // Some twenty roundings of numbers up to 4, of a difference of 0.03.
            assert!(((energy - found) / lost - 1.0).abs() < 1e-12, "{energy}: {found}, {lost}");
        }
    }

    /// With a speed of the computed sequence that is too large for the set it says nothing.
    #[test]
    fn both_sequences_have_to_lie_in_the_convex_set() {
        let wild = BetweenPoints { greatest_difference: 100.0, ..computed(0.5, 0.0) };
        assert_eq!(strict_convexity(constants(2.0), 2, &wild), None);
        // A minimiser of that energy may be fast, even where the computed sequence is not.
        let far = BetweenPoints { greatest_difference: 0.1, ..computed(50.0, 0.0) };
        assert_eq!(strict_convexity(constants(2.0), 2, &far), None);
    }

    #[test]
    fn numbers_that_are_none_say_nothing() {
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            let good = computed(0.5, 0.0);
            for computed in [
                BetweenPoints { discrete_energy: bad, ..good },
                BetweenPoints { length: bad, ..good },
                BetweenPoints { greatest_difference: bad, ..good },
                BetweenPoints { residual: bad, ..good },
            ] {
                assert_eq!(strict_convexity(constants(2.0), 2, &computed), None);
            }
        }
    }

    #[test]
    #[should_panic(expected = "a greatest norm, got NaN")]
    fn a_norm_that_is_no_number_is_a_mistake() {
        let _ = convexity_modulus(constants(2.0), PaperRule::Trapezoidal, f64::NAN, n(2));
    }
}
