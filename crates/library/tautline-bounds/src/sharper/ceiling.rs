//! Lemma S.4: upper bounds `min E_N ≤ d² e`, obtained by sampling a minimal geodesic.
//!
//! The functions return the surplus `e − 1`, computed without cancellation.

use std::num::NonZeroUsize;

use crate::{PaperRule, Setting, number::Number};

/// Returns `e − 1` with `e = min(κ, 1 + δ/4N + Gδ/12N²)` (trapezoidal) or `min(κ, 1 + δ/2N)` (left
/// endpoint). The chord between the ends gives `κ`, and points of the geodesic give the other
/// bound.
pub(crate) fn first_order<T: Number>(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> T {
    let (delta, n): (T, _) = (setting.delta_in(), n.get() as f64);
    let sampled = match rule {
        PaperRule::Trapezoidal => {
            let bent = T::product([setting.bend_in::<T>() / 12.0, delta]) / n;
            (delta * 0.25 + bent) / n
        }
        PaperRule::LeftEndpoint => delta * 0.5 / n,
    };
    sampled.least(setting.kappa_above_one())
}

/// Returns `e₂ − 1` for the trapezoidal rule: the smaller of [`first_order`] and
/// `(Gδ/3 + μ/24)/N²`. Returns `None` if `M_H` is unknown.
pub(crate) fn second_order<T: Number>(setting: Setting, n: NonZeroUsize) -> Option<T> {
    let (delta, mu): (T, T) = (setting.delta_in(), setting.mu_in()?);
    let leading = T::product([setting.bend_in::<T>() / 3.0, delta]) + mu / 24.0;
    let count = n.get() as f64;
    Some((leading / count / count).least(first_order(setting, PaperRule::Trapezoidal, n)))
}

/// Returns the smaller of [`second_order`] and `ê − 1`, where
///
/// ```text
/// ê − 1 = (1/N²) [G² (min(κ, (1 + δ/2N)²)/12 + δ/(√360 N) + μ/240N²) + μ/24]
/// ```
///
/// follows from the second variation of the energy at the geodesic.
pub(crate) fn second_variation<T: Number>(setting: Setting, n: NonZeroUsize) -> Option<T> {
    let (mu, count): (T, _) = (setting.mu_in()?, n.get() as f64);
    let surplus = (bent::<T>(setting, n)? + mu / 24.0) / count / count;
    Some(surplus.least(second_order(setting, n)?))
}

/// Returns `s − 1`, where `E(γᵖˡ) ≤ d² s` for the sequence of the points `γ(n/N)` of a minimal
/// geodesic. It is `ê − 1` without `μ/24`, by which `E_tra,N` may exceed `E(γᵖˡ)`. Returns `None`
/// if `M_H` is unknown.
pub(crate) fn sampled<T: Number>(setting: Setting, n: NonZeroUsize) -> Option<T> {
    let count = n.get() as f64;
    Some(bent::<T>(setting, n)? / count / count)
}

/// Returns the part of `N² (ê − 1)` that is proportional to `G²`.
fn bent<T: Number>(setting: Setting, n: NonZeroUsize) -> Option<T> {
    let (delta, mu, bend): (T, T, T) = (setting.delta_in(), setting.mu_in()?, setting.bend_in());
    let count = n.get() as f64;
    let step = delta / count;
    let moved = (step * 0.5 + 1.0).sqr().least(setting.kappa_above_one::<T>() + 1.0);
    let fourth = mu / (T::constant(240.0) * count * count);
    let factor = moved / 12.0 + step / T::constant(360.0).sqrt() + fourth;
    Some(T::product([bend, bend, factor]))
}

/// Returns the least of these surpluses for a rule.
pub(crate) fn least<T: Number>(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> T {
    match rule {
        PaperRule::Trapezoidal => {
            second_variation(setting, n).unwrap_or_else(|| first_order(setting, rule, n))
        }
        PaperRule::LeftEndpoint => first_order(setting, rule, n),
    }
}

#[cfg(test)]
mod tests {
    use super::{first_order, sampled, second_order, second_variation};
    use crate::{
        PaperRule, Setting,
        by_hand::{close, constants, n, with_m_h},
    };

    /// Allows for about ten roundings.
    const TOLERANCE: f64 = 4e-15;

    /// `c₁ = 4`, `L_H = 8`, `M_H = 32`, `d = 3`: `δ = 3` and `μ = 18`, on a region.
    fn setting(c2: f64, dimension: usize) -> Setting {
        Setting::new(with_m_h(4.0, c2, 8.0, 32.0).on_a_region(), 3.0, dimension).expect("valid")
    }

    #[test]
    fn by_hand() {
        let (plane, line) = (setting(4e6, 2), setting(4e6, 1));
        // The surpluses are 3/4N + 9/8N² and 3/4N + 9/24N² (trapezoidal), and 3/2N (left endpoint).
        let first: f64 = first_order(plane, PaperRule::Trapezoidal, n(6));
        close(first, 0.125 + 0.03125, TOLERANCE);
        let first: f64 = first_order(line, PaperRule::Trapezoidal, n(6));
        close(first, 0.125 + 0.375 / 36.0, TOLERANCE);
        close(first_order::<f64>(plane, PaperRule::LeftEndpoint, n(6)), 0.25, TOLERANCE);
        // The surpluses are (9/2 + 3/4)/N² and (3/2 + 3/4)/N².
        close(second_order(plane, n(6)), 5.25 / 36.0, TOLERANCE);
        close(second_order(line, n(6)), 2.25 / 36.0, TOLERANCE);
        // At N = 3 with ω = 1/2 the surplus is (9/4)((3/2)²/12 + 1/√360 + 18/2160) + 3/4, divided
        // by 9.
        let factor = 2.25 / 12.0 + 1.0 / 360_f64.sqrt() + 1.0 / 120.0;
        close(second_variation(line, n(3)), (2.25 * factor + 0.75) / 9.0, TOLERANCE);
        close(sampled(line, n(3)), 0.25 * factor, TOLERANCE);
    }

    #[test]
    fn the_least_is_taken() {
        // In the second variation κ = 1.2 is less than (1 + 3/2N)².
        let factor = 0.1 + 1.0 / 3.0 / 360_f64.sqrt() + 18.0 / 19440.0;
        let capped: Option<f64> = second_variation(setting(4.8, 2), n(9));
        close(capped, (20.25 * factor + 0.75) / 81.0, TOLERANCE);
        // Here κ − 1 = 1/8.
        let tame = setting(4.5, 2);
        assert_eq!(first_order::<f64>(tame, PaperRule::Trapezoidal, n(2)), 0.125);
        assert_eq!(first_order::<f64>(tame, PaperRule::LeftEndpoint, n(2)), 0.125);
        assert_eq!(second_order::<f64>(tame, n(2)), Some(0.125));
        assert_eq!(second_variation::<f64>(tame, n(2)), Some(0.125));
        // N = 1 and ω = 3/2: 3/4 + 9/8 is less than 9/2 + 3/4, which is less than
        // (81/4)(25/48 + …).
        let plane = setting(4e6, 2);
        assert_eq!(second_variation::<f64>(plane, n(1)), Some(1.875));
        // At N = 1000 the leading terms dominate, and the last surplus is the least.
        let at = |bound: Option<f64>| bound.expect("M_H") * 1e6;
        assert!(at(second_order(plane, n(1000))) > 5.2);
        let sharp = at(second_variation(plane, n(1000)));
        assert!((2.4375..2.45).contains(&sharp), "81/48 + 3/4, not {sharp}");
    }

    #[test]
    fn there_is_no_second_order_without_m_h() {
        let setting = Setting::new(constants(1.0, 2.0, 1.0), 1.0, 2).expect("valid");
        assert_eq!(second_order::<f64>(setting, n(8)), None);
        assert_eq!(second_variation::<f64>(setting, n(8)), None);
        assert_eq!(sampled::<f64>(setting, n(8)), None);
    }
}
