//! Proposition S.9: the excess of one computed sequence between two points, by convexity.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;
use tautline_scalar::Interval;

use super::{
    ceiling,
    convexity::{BetweenPoints, convexity_modulus_in, poincare, wave},
};
use crate::{PaperRule, Setting, number::Number};

/// Bounds `E(γᵖˡ) − d²`, in `m²`, for *any* sequence between two points, by `O(1/N²)` for either
/// rule, if the discrete energy is strictly convex there (Proposition S.9).
///
/// ```text
/// E(γᵖˡ) − d²  ≤  (d²/N²) G² [min(κ, (1 + δ/2N)²)/12 + δ/(√360 N) + μ/240N²]  +  (K + S)²/4σ
/// K  =  (M_H B³/N) (r/4 + 1/6N)           (trapezoidal),      S = R/(N sin(π/2N))
/// K  =  (3 L_H B² + M_H B³ r)/2N          (left endpoint)
/// ```
///
/// with the `σ` and `r` of Proposition S.7 at `B = max(max |βₙ|, d/√c₁)`, and with the residual
/// `R² = (1/N) Σ |ρₙ|²`.
///
/// The sequence and the points of a minimal geodesic lie in one convex set of sequences. There
/// `E_N` rises at least quadratically from the one to the other, whereas `E(γᵖˡ) − E_N` changes at
/// most by `K` per unit of distance.
///
/// The first part is the energy of the sampled geodesic, without the `μ/12` of Theorem D: as
/// `N → ∞`, the bound for a minimiser is `(d²/N²) (G²/12 + μ²c₁/64π²σ)` for the trapezoidal rule.
/// For the left-endpoint rule no other bound is better than `O(1/N)`.
///
/// - `computed.length`: any upper bound on the distance; the energy is not used.
///
/// Needs: the setting of Theorem 1.1 with `M_H`, and two points as ends. Nothing is assumed about
/// the sequence: `d² ≥ E(γᵖˡ)` minus this bound, whether or not a minimum is global.
///
/// Overestimation: the bound is attained as `N → ∞` by minimisers of the trapezoidal rule up an
/// incline, in the limit `L_H → 0`.
///
/// Returns `None` if `M_H` is unknown, if `σ ≤ 0`, or if a number in `computed` is negative,
/// infinite or NaN.
#[must_use]
pub fn convex_excess(
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
) -> Option<f64> {
    excess_in::<f64>(constants, dimension, computed)
}

/// Returns a bound like that of [`convex_excess`], rounded up to the last digit.
///
/// - `computed`: upper bounds, all of them.
///
/// Returns `None` as there.
#[must_use]
pub fn convex_excess_outward(
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
) -> Option<f64> {
    let excess = excess_in::<Interval>(constants, dimension, computed)?.above();
    excess.is_finite().then_some(excess)
}

/// Returns what [`convex_excess`] documents, in doubles or in intervals.
fn excess_in<T: Number>(
    constants: Constants,
    dimension: usize,
    computed: &BetweenPoints,
) -> Option<T> {
    if !computed.is_valid() {
        return None;
    }
    let &BetweenPoints { rule, n, length, greatest_difference, residual, .. } = computed;
    let setting = Setting::new(constants, length, dimension).ok()?;
    let [length, greatest_difference, residual] =
        [length, greatest_difference, residual].map(T::constant);
    let greatest = greatest_difference.greatest(length / T::constant(constants.c1()).sqrt());
    let modulus: T = convexity_modulus_in(constants, rule, greatest, n)?;
    if !modulus.is_positive() {
        return None;
    }
    let sampled: T = sampled_excess_in(setting, n)?;
    let slope = slope_of_the_gap(constants, rule, greatest, n)? + residual / wave::<T>(n);
    Some(sampled + slope * slope / (modulus * 4.0))
}

/// Bounds `E(γᵖˡ) − d²`, in `m²`, for the points `γ(n/N)` of a minimal geodesic `γ` (proof of Lemma
/// S.4).
///
/// ```text
/// P  =  (d²G²/N²) [min(κ, (1 + δ/2N)²)/12 + δ/(√360 N) + μ/240N²]
/// ```
///
/// Needs: the setting of Theorem 1.1 with `M_H`. Overestimation: the bound is attained up an
/// incline, as `N → ∞` and `L_H → 0`.
///
/// Returns `None` if `M_H` is unknown.
#[must_use]
pub fn sampled_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    sampled_excess_in(setting, n)
}

fn sampled_excess_in<T: Number>(setting: Setting, n: NonZeroUsize) -> Option<T> {
    let d = T::constant(setting.distance());
    Some(T::product([d, d, ceiling::sampled(setting, n)?]))
}

/// Returns `K`, in `m²/ℓ`: between two sequences with `|βₙ| ≤ B` and the same ends,
/// `E(γᵖˡ) − E_N` changes by at most `K` times the root mean square difference of their `βₙ`.
/// Returns `None` if `M_H` is unknown.
fn slope_of_the_gap<T: Number>(
    constants: Constants,
    rule: PaperRule,
    greatest: T,
    n: NonZeroUsize,
) -> Option<T> {
    let [l_h, m_h] = [constants.l_h(), constants.m_h()?].map(T::constant);
    // A single chord between two points cannot change.
    if n == NonZeroUsize::MIN {
        return Some(T::constant(0.0));
    }
    let (count, b) = (n.get() as f64, greatest);
    let r: T = poincare(rule, n);
    Some(match rule {
        PaperRule::Trapezoidal => {
            let moved = r * 0.25 + (T::constant(6.0) * count).recip();
            T::product([m_h, b, b, b, moved]) / count
        }
        PaperRule::LeftEndpoint => {
            let [more, half] = [1.5, 0.5].map(T::constant);
            (T::product([more, l_h, b, b]) + T::product([half, m_h, b, b, b, r])) / count
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{convex_excess, convex_excess_outward};
    use crate::{
        BetweenPoints, Constants, PaperRule, Setting,
        by_hand::{close, n, with_m_h},
        theorem_d_excess,
    };

    const BOTH: [PaperRule; 2] = PaperRule::BOTH;

    /// `c₁ = 4`, `c₂ = 9`, `L_H = 1`, `M_H = 2`.
    fn constants() -> Constants {
        with_m_h(4.0, 9.0, 1.0, 2.0)
    }

    fn computed(rule: PaperRule, count: usize) -> BetweenPoints {
        BetweenPoints {
            rule,
            n: n(count),
            discrete_energy: 1.0,
            length: 1.0,
            greatest_difference: 0.75,
            residual: 0.0,
        }
    }

    /// Two chords: `r = ¼` and `1/√8`, `S = R/√2`. With `d̄ = 1`, `δ = 1/8` and `μ = 1/8`, and
    /// `G = 3/16` on the plane.
    #[test]
    fn by_hand() {
        let sampled = {
            let factor = (1.0 + 1.0 / 32.0_f64).powi(2) / 12.0
                + 1.0 / 16.0 / 360_f64.sqrt()
                + 1.0 / 8.0 / 960.0;
            0.25 * (3.0 / 16.0_f64).powi(2) * factor
        };
        let b = 0.75_f64;
        let tra_k = 0.5 * 2.0 * b.powi(3) * (1.0 / 16.0 + 1.0 / 12.0);
        let tra_modulus = 4.0 - 0.5 * b - b * b / 16.0;
        let left_r = 1.0 / 8.0_f64.sqrt();
        let left_k = 0.25 * (3.0 * b * b + 2.0 * b.powi(3) * left_r);
        let left_modulus = 4.0 - 2.0 * b * left_r - b * b / 8.0;
        for residual in [0.0, 0.3] {
            let s = residual / 2_f64.sqrt();
            let of = |rule| {
                convex_excess(constants(), 2, &BetweenPoints { residual, ..computed(rule, 2) })
            };
            let bound = |k: f64, modulus: f64| sampled + (k + s).powi(2) / (4.0 * modulus);
            // This allows for about twenty roundings.
            close(of(BOTH[0]), bound(tra_k, tra_modulus), 8e-15);
            close(of(BOTH[1]), bound(left_k, left_modulus), 8e-15);
        }
    }

    /// The distance over `√c₁` is the least speed that counts, since the sampled geodesic has it.
    #[test]
    fn the_convex_set_contains_the_sampled_geodesic() {
        for rule in BOTH {
            let of = |greatest_difference| {
                convex_excess(
                    constants(),
                    2,
                    &BetweenPoints { greatest_difference, ..computed(rule, 32) },
                )
            };
            assert_eq!(of(0.0), of(0.5));
            assert!(of(0.5) < of(0.51));
        }
    }

    /// A single chord between two points cannot change; only the geodesic's bend remains.
    #[test]
    fn one_chord_varies_nothing() {
        let [tra, left] = BOTH.map(|rule| convex_excess(constants(), 2, &computed(rule, 1)));
        assert_eq!(tra, left);
        let fast = BetweenPoints { greatest_difference: 100.0, ..computed(BOTH[0], 1) };
        assert_eq!(convex_excess(constants(), 2, &fast), tra);
    }

    /// As `N → ∞` a minimiser has `G²/12 + μ²c₁/64π²σ` (trapezoidal) and
    /// `G²/12 + c₁ (3δ + μ/π)²/16σ` (left endpoint), with `σ/c₁ = 1 − 2δ/π − μ/2π²`.
    #[test]
    fn the_leading_constants() {
        use std::f64::consts::PI;
        let count = 1_usize << 26;
        let setting = Setting::new(constants(), 1.0, 2).expect("valid");
        let (delta, mu, bend) = (0.125, 0.125, 0.1875);
        let modulus = 1.0 - 2.0 * delta / PI - mu / (2.0 * PI * PI);
        let minimiser = |rule| {
            let at = BetweenPoints { greatest_difference: 0.5, ..computed(rule, count) };
            convex_excess(constants(), 2, &at).expect("convex") * (count as f64).powi(2)
        };
        let bent = bend * bend / 12.0;
        let expected = [
            bent + (mu / PI).powi(2) / (64.0 * modulus),
            bent + (3.0 * delta + mu / PI).powi(2) / (16.0 * modulus),
        ];
        for (rule, expected) in BOTH.into_iter().zip(expected) {
            // The next terms are of relative order 1/N, with factors below 10.
            let value = minimiser(rule);
            assert!((value / expected - 1.0).abs() < 10.0 / count as f64, "{value} {expected}");
        }
        let older = theorem_d_excess(setting, n(count)).expect("M_H") * (count as f64).powi(2);
        assert!(older > 4.0 * minimiser(BOTH[0]), "{older}");
    }

    #[test]
    fn without_convexity_or_m_h_nothing_is_claimed() {
        for rule in BOTH {
            let good = computed(rule, 32);
            let unknown = Constants::new(4.0, 9.0, 1.0).expect("valid");
            assert_eq!(convex_excess(unknown, 2, &good), None);
            let far = BetweenPoints { length: 50.0, ..good };
            assert_eq!(convex_excess(constants(), 2, &far), None);
            let fast = BetweenPoints { greatest_difference: 100.0, ..good };
            assert_eq!(convex_excess(constants(), 2, &fast), None);
            assert_eq!(convex_excess(constants(), 0, &good), None);
            for bad in [-1.0, f64::NAN, f64::INFINITY] {
                for bad in [
                    BetweenPoints { length: bad, ..good },
                    BetweenPoints { greatest_difference: bad, ..good },
                    BetweenPoints { residual: bad, ..good },
                ] {
                    assert_eq!(convex_excess(constants(), 2, &bad), None);
                }
            }
        }
    }

    #[test]
    fn a_constant_metric_has_no_excess() {
        let flat = with_m_h(4.0, 9.0, 0.0, 0.0);
        for rule in BOTH {
            assert_eq!(convex_excess(flat, 2, &computed(rule, 7)), Some(0.0));
        }
    }

    /// On a constant metric only the residual counts: one chord has the excess `R²/4c₁`. A fused
    /// product has the right sign.
    #[test]
    fn the_excess_is_rounded_up() {
        let mut nearest_fails = 0;
        for (c1, residual) in (2..100_u8).flat_map(|c1| (1..6_u8).map(move |r| (c1, r))) {
            let (c1, residual) = (f64::from(c1), f64::from(residual));
            let flat = with_m_h(c1, 400.0, 0.0, 0.0);
            for rule in BOTH {
                let one = BetweenPoints { residual, ..computed(rule, 1) };
                let is_below = |excess: f64| excess.mul_add(4.0 * c1, -(residual * residual)) < 0.0;
                let found = convex_excess_outward(flat, 2, &one).expect("convex");
                // A few roundings, and those of the sine of π/2.
                let most = residual * residual / (4.0 * c1) * (1.0 + 1e-13);
                assert!(!is_below(found) && found <= most, "{one:?}: {found}");
                let nearest = convex_excess(flat, 2, &one).expect("convex");
                nearest_fails += usize::from(is_below(nearest));
            }
        }
        assert!(nearest_fails > 100, "{nearest_fails}");
    }
}
