//! The least of all bounds on `E(γᵖˡ) − d²` and on `L(γᵖˡ)² − d²`, and the number of subintervals
//! that meets a tolerance.

use std::num::NonZeroUsize;

use super::{
    theorem_a_excess, theorem_b_excess, theorem_c_excess, theorem_c_length_excess,
    theorem_d_excess, theorem_d_length_excess,
};
use crate::{PaperRule, Setting, theorem_1_1_excess, theorem_1_3_excess};

/// The theorem that proves a bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Theorem {
    /// Theorem 1.1 (trapezoidal) or 1.3 (left endpoint) of the paper.
    Paper,
    /// Theorem A: order `1/N`, for stationary sequences.
    A,
    /// Theorem B: order `1/N²`, for stationary sequences.
    B,
    /// Theorem C: order `1/N`, from the energy alone.
    C,
    /// Theorem D: order `1/N²`, from the energy alone.
    D,
}

/// A bound and the theorem that proves it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Bound {
    /// The bound, in `m²`.
    pub value: f64,
    /// The theorem that proves it.
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

/// Bounds both `E(γᵖˡ) − d²` and `L(γᵖˡ)² − d²`, in `m²`, by the smaller of the bounds in Theorems
/// A and C. It is of order `1/N`.
///
/// Needs: the setting of Theorem 1.1, and a *global* minimiser.
#[must_use]
pub fn first_order_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    theorem_a_excess(setting, rule, n).min(theorem_c_excess(setting, rule, n))
}

/// Bounds both `E(γᵖˡ) − d²` and `L(γᵖˡ)² − d²` for the trapezoidal rule, in `m²`, by the smaller
/// of the bounds in Theorems B and D. It is of order `1/N²`. Returns `None` if `M_H` is not known.
///
/// Needs: the setting of Theorem 1.1, `DH` Lipschitz with `M_H`, and a *global* minimiser.
#[must_use]
pub fn second_order_excess(setting: Setting, n: NonZeroUsize) -> Option<f64> {
    Some(theorem_b_excess(setting, n)?.min(theorem_d_excess(setting, n)?))
}

/// Returns the least of the bounds in the paper's theorem and in Theorems A to D on both
/// `E(γᵖˡ) − d²` and `L(γᵖˡ)² − d²`, for a *global* minimiser.
///
/// If several bounds are equal, the result names the theorem that comes first in [`Theorem`].
#[must_use]
pub fn least_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> Bound {
    let (paper, b, d) = match rule {
        PaperRule::Trapezoidal => (
            theorem_1_1_excess(setting, n),
            theorem_b_excess(setting, n),
            theorem_d_excess(setting, n),
        ),
        PaperRule::LeftEndpoint => (theorem_1_3_excess(setting, n), None, None),
    };
    Bound { value: paper, by: Theorem::Paper }
        .or(Some(theorem_a_excess(setting, rule, n)), Theorem::A)
        .or(b, Theorem::B)
        .or(Some(theorem_c_excess(setting, rule, n)), Theorem::C)
        .or(d, Theorem::D)
}

/// Returns the least bound on `L(γᵖˡ)² − d²` for a *global* minimiser: the least of
/// [`least_excess`] and the length bounds of Theorems C and D.
#[must_use]
pub fn least_length_excess(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> Bound {
    let first = least_excess(setting, rule, n)
        .or(Some(theorem_c_length_excess(setting, rule, n)), Theorem::C);
    match rule {
        PaperRule::Trapezoidal => first.or(theorem_d_length_excess(setting, n), Theorem::D),
        PaperRule::LeftEndpoint => first,
    }
}

/// Returns the least `N` for which [`least_length_excess`] is at most `tolerance`, together with the
/// theorem that proves the bound. Returns `None` if no power of 2 up to `2⁴⁰` is enough or if the
/// tolerance is NaN.
///
/// - `tolerance`: the tolerance for `L(γᵖˡ)² − d²`, in `m²`.
///
/// The search is by doubling and bisection, since no bound increases with `N` (S.10).
/// Where a bound hardly changes from one `N` to the next, rounding may decide which is the least.
///
/// Overestimation: if the bound is `r` times the excess and falls like `1/N²`, then already `N/√r`
/// subintervals are enough.
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
    use crate::{
        PaperRule, Setting,
        by_hand::{constants, n},
        theorem_c_length_excess, theorem_d_length_excess,
    };

    fn setting(m_h: Option<f64>) -> Setting {
        let constants = constants(1.0, 9.0, 4.0);
        let constants = m_h.map_or(constants, |m_h| constants.with_m_h(m_h).expect("valid"));
        Setting::new(constants, 5.0, 2).expect("valid")
    }

    #[test]
    fn the_least_bound_names_its_theorem() {
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
        let bound = least_length_excess(smooth, PaperRule::LeftEndpoint, n(4096));
        let expected = theorem_c_length_excess(smooth, PaperRule::LeftEndpoint, n(4096));
        assert_eq!((bound.value, bound.by), (expected, Theorem::C));
        let bound = least_length_excess(smooth, PaperRule::Trapezoidal, n(4096));
        let expected = theorem_d_length_excess(smooth, n(4096)).expect("M_H");
        assert_eq!((bound.value, bound.by), (expected, Theorem::D));
        // For a constant metric the paper's bound is 0.
        let flat = Setting::new(constants(1.0, 2.0, 0.0), 5.0, 2).expect("valid");
        let bound = least_excess(flat, PaperRule::LeftEndpoint, n(1));
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

    /// Few chords are enough by Theorem C, many by Theorem D. The theorem is that of the `N` returned,
    /// also where the next power of 2, at which the search begins, has another one.
    #[test]
    fn the_theorem_is_that_of_the_number_of_subintervals() {
        let mut differ = 0;
        for m_h in [6.0, 1e3, 1e5] {
            let setting = setting(Some(m_h));
            for tolerance in (0..=400).map(|k| 1e3 * 10_f64.powf(-0.02 * f64::from(k))) {
                let rule = PaperRule::Trapezoidal;
                let (found, by) = suggest_n(setting, rule, tolerance).expect("some N");
                let at = |n| least_length_excess(setting, rule, n).by;
                assert_eq!(by, at(found), "M_H = {m_h}, {tolerance} at {found}");
                differ += usize::from(at(n(found.get().next_power_of_two())) != by);
            }
        }
        assert!(differ > 0);
    }

    #[test]
    fn an_unreachable_tolerance_gives_none() {
        for rule in PaperRule::BOTH {
            for tolerance in [0.0, -1.0, f64::NAN] {
                assert_eq!(suggest_n(setting(Some(6.0)), rule, tolerance), None, "{tolerance}");
            }
        }
        let (first, _) = suggest_n(setting(None), PaperRule::Trapezoidal, 1e30).expect("any N");
        assert_eq!(first.get(), 1);
    }
}
