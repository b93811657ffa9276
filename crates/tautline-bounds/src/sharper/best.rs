//! The least of all bounds of `E(γᵖˡ) − d²` and of `L(γᵖˡ)² − d²`, and the number of subintervals
//! that a tolerance asks for.

use std::num::NonZeroUsize;

use super::{
    theorem_a_excess, theorem_b_excess, theorem_c_excess, theorem_c_length_excess,
    theorem_d_excess, theorem_d_length_excess,
};
use crate::{PaperRule, Setting, theorem_1_1_excess, theorem_1_3_excess};

/// By which theorem a bound holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Theorem {
    /// Theorem 1.1 (trapezoidal) or 1.3 (left endpoint) of the paper.
    Paper,
    /// Theorem A: order `1/N`, by stationarity.
    A,
    /// Theorem B: order `1/N²`, by stationarity.
    B,
    /// Theorem C: order `1/N`, by the energy.
    C,
    /// Theorem D: order `1/N²`, by the energy.
    D,
}

/// A bound, in `m²`, and the theorem by which it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The bound, in `m²`.
    pub value: f64,
    /// The theorem.
    pub by: Theorem,
}

impl Bound {
    fn or(self, other: Option<f64>, by: Theorem) -> Bound {
        match other {
            Some(value) if value < self.value => Bound { value, by },
            _ => self,
        }
    }
}

/// Bounds `E(γᵖˡ) − d²`, and `L(γᵖˡ)² − d²`, in `m²`, by the lesser of Theorems A and C: order
/// `1/N`.
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser.
#[must_use]
pub fn first_order_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    theorem_a_excess(setting, rule, n).min(theorem_c_excess(setting, rule, n))
}

/// Bounds `E(γᵖˡ) − d²`, and `L(γᵖˡ)² − d²`, for the trapezoidal rule, in `m²`, by the lesser of
/// Theorems B and D: order `1/N²`. `None` if `M_H` is not known.
///
/// Needs: the setting of Theorem 1.1, `DH` Lipschitz with `M_H`, and a *global* minimiser.
#[must_use]
pub fn second_order_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    Some(theorem_b_excess(setting, n)?.min(theorem_d_excess(setting, n)?))
}

/// Returns the least bound of `E(γᵖˡ) − d²`, and of `L(γᵖˡ)² − d²`, that the paper's theorem and
/// Theorems A to D have for a *global* minimiser.
///
/// Of equal bounds the one of the weaker theorem is returned, in the order of [`Theorem`].
#[must_use]
pub fn least_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> Bound {
    let paper = match rule {
        PaperRule::Trapezoidal => theorem_1_1_excess(setting, n),
        PaperRule::LeftEndpoint => theorem_1_3_excess(setting, n),
    };
    let first_order = Bound { value: paper, by: Theorem::Paper }
        .or(Some(theorem_a_excess(setting, rule, n)), Theorem::A);
    let second_order = match rule {
        PaperRule::Trapezoidal => first_order.or(theorem_b_excess(setting, n), Theorem::B),
        PaperRule::LeftEndpoint => first_order,
    };
    let from_energy = second_order.or(Some(theorem_c_excess(setting, rule, n)), Theorem::C);
    match rule {
        PaperRule::Trapezoidal => from_energy.or(theorem_d_excess(setting, n), Theorem::D),
        PaperRule::LeftEndpoint => from_energy,
    }
}

/// Returns the least bound of `L(γᵖˡ)² − d²` for a *global* minimiser: that of Theorem C or D for
/// the length, or the one of [`least_excess`].
#[must_use]
pub fn least_length_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> Bound {
    let first = least_excess(setting, rule, n)
        .or(Some(theorem_c_length_excess(setting, rule, n)), Theorem::C);
    match rule {
        PaperRule::Trapezoidal => first.or(theorem_d_length_excess(setting, n), Theorem::D),
        PaperRule::LeftEndpoint => first,
    }
}

/// Returns an `N` for which [`least_length_excess`] is at most `tolerance`, and `N − 1` is not
/// enough; with the theorem by which it is. `None` if no power of 2 up to `2⁴⁰` is enough, or the
/// tolerance is NaN.
///
/// - `tolerance`: of `L(γᵖˡ)² − d²`, in `m²`.
///
/// Found by doubling and bisection. The bounds fall with `N` wherever we looked; if one did not,
/// the `N` returned would still do, and might not be the least.
///
/// Overestimation: that of the bound, in powers: where it is `r` times the excess and falls like
/// `1/N²`, a solve with `N/√r` subintervals is as good.
#[must_use]
pub fn suggest_n(
    setting: Setting,
    rule: PaperRule,
    tolerance: f64,
) -> Option<(NonZeroUsize, Theorem)> {
    let enough = |n: usize| {
        let bound = least_length_excess(setting, rule, NonZeroUsize::new(n)?);
        (bound.value <= tolerance).then_some(bound.by)
    };
    let (mut enough_n, mut by) = (0..=40.min(usize::BITS - 1))
        .map(|power| 1_usize << power)
        .find_map(|n| enough(n).map(|by| (n, by)))?;
    let mut too_few = enough_n / 2;
    while enough_n - too_few > 1 {
        let middle = too_few + (enough_n - too_few) / 2;
        match enough(middle) {
            Some(theorem) => (enough_n, by) = (middle, theorem),
            None => too_few = middle,
        }
    }
    NonZeroUsize::new(enough_n).map(|n| (n, by))
}

#[cfg(test)]
mod tests {
    use super::{
        Theorem, first_order_excess, least_excess, least_length_excess, second_order_excess,
        suggest_n,
    };
    use crate::{Constants, PaperRule, Setting};
    use crate::{theorem_c_length_excess, theorem_d_length_excess};
    use std::num::NonZeroUsize;

    fn n(n: usize) -> NonZeroUsize {
        NonZeroUsize::new(n).expect("positive")
    }

    fn setting(m_h: Option<f64>) -> Setting {
        let constants = Constants::new(1.0, 9.0, 4.0).expect("in order");
        let constants = m_h.map_or(constants, |m_h| constants.with_m_h(m_h).expect("valid"));
        Setting::new(constants, 5.0, 2).expect("valid")
    }

    #[test]
    fn the_least_is_that_of_its_theorem() {
        let smooth = setting(Some(6.0));
        let bound = least_excess(smooth, PaperRule::Trapezoidal, n(4096));
        assert_eq!(bound.by, Theorem::D);
        assert_eq!(Some(bound.value), second_order_excess(smooth, n(4096)));
        let bound = least_excess(setting(None), PaperRule::Trapezoidal, n(4096));
        assert_eq!(bound.by, Theorem::C);
        let expected = first_order_excess(setting(None), PaperRule::Trapezoidal, n(4096));
        assert_eq!(bound.value, expected);
        // M_H does not help the left-endpoint rule.
        let bound = least_excess(smooth, PaperRule::LeftEndpoint, n(4096));
        assert_eq!(bound.by, Theorem::C);
        // Of the length.
        let bound = least_length_excess(smooth, PaperRule::LeftEndpoint, n(4096));
        let expected = theorem_c_length_excess(smooth, PaperRule::LeftEndpoint, n(4096));
        assert_eq!((bound.value, bound.by), (expected, Theorem::C));
        let bound = least_length_excess(smooth, PaperRule::Trapezoidal, n(4096));
        let expected = theorem_d_length_excess(smooth, n(4096)).expect("M_H");
        assert_eq!((bound.value, bound.by), (expected, Theorem::D));
        // A constant metric has no error, and the paper says so.
        let flat = Setting::new(Constants::new(1.0, 2.0, 0.0).expect("in order"), 5.0, 2);
        let bound = least_excess(flat.expect("valid"), PaperRule::LeftEndpoint, n(1));
        assert_eq!((bound.value, bound.by), (0.0, Theorem::Paper));
    }

    #[test]
    fn the_number_of_subintervals_is_enough_and_one_less_is_not() {
        for rule in PaperRule::BOTH {
            for tolerance in [100.0, 1.0, 1e-2, 1e-4] {
                let (found, by) = suggest_n(setting(Some(6.0)), rule, tolerance).expect("some N");
                let bound = least_length_excess(setting(Some(6.0)), rule, found);
                assert!(bound.value <= tolerance && bound.by == by);
                if found.get() > 1 {
                    let before = least_length_excess(setting(Some(6.0)), rule, n(found.get() - 1));
                    assert!(before.value > tolerance, "{before:?} at {found} − 1");
                }
            }
        }
    }

    #[test]
    fn out_of_reach_is_none() {
        for rule in PaperRule::BOTH {
            assert_eq!(suggest_n(setting(Some(6.0)), rule, 0.0), None);
            assert_eq!(suggest_n(setting(Some(6.0)), rule, f64::NAN), None);
            assert_eq!(suggest_n(setting(Some(6.0)), rule, -1.0), None);
        }
        let (first, _) = suggest_n(setting(None), PaperRule::Trapezoidal, 1e30).expect("any N");
        assert_eq!(first.get(), 1);
    }
}
