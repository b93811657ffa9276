//! `Spread`: bounds on how much the speeds of a sequence differ, from its energy alone (Lemma S.5).

use std::num::NonZeroUsize;

use crate::{PaperRule, Setting, number::Number};

/// Bounds on the moments of the relative speeds `uₙ = qₙ/d` of an admissible sequence with
/// `E_N ≤ d² ε` (Lemma S.5). All of them are pure numbers.
///
/// The length of `γᵖˡ` is at least `d` and nearly equals the mean speed; the energy is the mean
/// square speed. If mean and root mean square almost agree, the speeds are almost equal:
///
/// ```text
/// mean u ≥ 1 − x,    v = mean u² − (mean u)² ≤ ε − max(0, 1 − x)²,    |uₙ − mean u| ≤ R = √((N − 1) v)
/// x = kδε/2N,  and for the trapezoidal rule  x = μ m₃/48N²
/// ```
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and ends in their sets. The sequence need be neither
/// a minimiser nor stationary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// The shortfall `x` in `mean u ≥ 1 − x`.
    pub shortfall: f64,
    /// The variance `v`.
    pub variance: f64,
    /// The bound `R` on the deviation from the mean.
    pub deviation: f64,
    /// The mean of the cubes, `m₃`.
    pub cube: f64,
    /// The mean of the fourth powers, `m₄`.
    pub fourth: f64,
}

impl Spread {
    /// Returns the spread for `x = kδε/2N`, for either rule; `surplus` is `ε − 1 ≥ 0`.
    ///
    /// # Panics
    ///
    /// If `surplus` is negative or NaN.
    #[must_use]
    pub fn of_first_order(
        setting: Setting,
        rule: PaperRule,
        n: NonZeroUsize,
        surplus: f64,
    ) -> Self {
        assert!(surplus >= 0.0, "the surplus must be nonnegative, got {surplus}");
        Moments::of_first_order(setting, rule, n, surplus).into()
    }

    /// Returns the spread for the smaller of the two `x`, for the trapezoidal rule; `surplus` is
    /// `ε − 1 ≥ 0`. Returns `None` if `M_H` is unknown.
    ///
    /// `x` bounds `v`, `v` bounds `m₃`, and `m₃` bounds `x`. This gives a fixed-point iteration of
    /// 64 steps, each of which yields valid bounds.
    ///
    /// # Panics
    ///
    /// If `surplus` is negative or NaN.
    #[must_use]
    pub fn of_second_order(setting: Setting, n: NonZeroUsize, surplus: f64) -> Option<Self> {
        assert!(surplus >= 0.0, "the surplus must be nonnegative, got {surplus}");
        Moments::of_second_order(setting, n, surplus).map(Self::from)
    }
}

impl From<Moments<f64>> for Spread {
    fn from(moments: Moments<f64>) -> Self {
        let Moments { shortfall, variance, deviation, cube, fourth } = moments;
        Self { shortfall, variance, deviation, cube, fourth }
    }
}

/// The numbers of a [`Spread`], in doubles or in intervals.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moments<T> {
    shortfall: T,
    variance: T,
    pub(super) deviation: T,
    cube: T,
    fourth: T,
}

impl<T: Number> Moments<T> {
    /// Returns what [`Spread::of_first_order`] documents.
    pub(super) fn of_first_order(
        setting: Setting,
        rule: PaperRule,
        n: NonZeroUsize,
        surplus: T,
    ) -> Self {
        let halved = T::constant(0.5 * rule.mean_distance()) / n.get() as f64;
        Self::of_shortfall(T::product([halved, setting.delta_in(), surplus + 1.0]), surplus, n)
    }

    /// Returns what [`Spread::of_second_order`] documents.
    pub(super) fn of_second_order(setting: Setting, n: NonZeroUsize, surplus: T) -> Option<Self> {
        let mu = setting.mu_in()?;
        let mut spread = Self::of_first_order(setting, PaperRule::Trapezoidal, n, surplus);
        let count = n.get() as f64;
        for _ in 0..64 {
            let shortfall = T::product([mu, spread.cube]) / (T::constant(48.0) * count * count);
            spread = Self::of_shortfall(shortfall.least(spread.shortfall), surplus, n);
        }
        Some(spread)
    }

    /// Returns the bounds that follow from `mean u ≥ 1 − x` and `mean u² ≤ 1 + surplus`.
    fn of_shortfall(shortfall: T, surplus: T, n: NonZeroUsize) -> Self {
        let (e, count) = (surplus + 1.0, n.get() as f64);
        // ε − (1 − x)², computed without cancellation. It is at most ε for any x.
        let variance =
            if shortfall.is_below(1.0) { surplus + shortfall * (2.0 - shortfall) } else { e };
        let others = T::constant(count) - 1.0;
        let square = T::product([others, variance]);
        let deviation = square.sqrt();
        let root = e.sqrt();
        // Among all N nonnegative numbers with mean square ε, those with a single nonzero number
        // have the greatest moments.
        let cube =
            (e * root + T::product([root, variance]) * 1.5 + T::product([deviation, variance]))
                .least(T::constant(count).sqrt() * e * root);
        let fourth = (e * e
            + T::product([e, variance]) * 4.0
            + T::product([root, deviation, variance]) * 4.0
            + T::product([square, variance]))
        .least(e * count * e);
        Self { shortfall, variance, deviation, cube, fourth }
    }
}

#[cfg(test)]
mod tests {
    use super::Spread;
    use crate::{
        PaperRule, Setting,
        by_hand::{self, constants, n, with_m_h},
    };

    /// `c₁ = 4`, `L_H = 8`, `d = 3`: `δ = 3`, and `μ = 9 m_h/16`.
    fn setting(m_h: f64) -> Setting {
        Setting::new(with_m_h(4.0, 4e6, 8.0, m_h), 3.0, 2).expect("valid")
    }

    fn close(value: f64, expected: f64) {
        // This allows for about ten roundings.
        by_hand::close(value, expected, 4e-15);
    }

    #[test]
    fn first_order_by_hand() {
        // N = 5, ε = 1 + 1/9: x = 3·(10/9)/40 = 1/12, v = 10/9 − (11/12)² = 39/144.
        let spread = Spread::of_first_order(setting(32.0), PaperRule::Trapezoidal, n(5), 1.0 / 9.0);
        close(spread.shortfall, 1.0 / 12.0);
        close(spread.variance, 39.0 / 144.0);
        close(spread.deviation, (39.0_f64 / 36.0).sqrt());
        let (e, v, r) = (10.0_f64 / 9.0, 39.0_f64 / 144.0, (39.0_f64 / 36.0).sqrt());
        close(spread.cube, e.powf(1.5) + 1.5 * e.sqrt() * v + r * v);
        close(spread.fourth, e * e + 4.0 * e * v + 4.0 * e.sqrt() * r * v + r * r * v);
        // For the left-endpoint rule x is twice as large.
        let left = Spread::of_first_order(setting(32.0), PaperRule::LeftEndpoint, n(5), 1.0 / 9.0);
        close(left.shortfall, 1.0 / 6.0);
    }

    /// At `ε = 1` and `x = 1` all of the energy may be variance. Then `m₃/N` is 1 for one chord, and
    /// without its cap `√2` it would be `(1 + 3/2 + 1)/2` for two; `m₄/N²` would be `10/4`.
    #[test]
    fn the_caps_keep_the_gaps_from_growing_from_one_chord_to_two() {
        let steep = Setting::new(constants(4.0, 4e6, 8.0), 48.0, 2).expect("valid");
        let [one, two] = [1, 2]
            .map(|count| Spread::of_first_order(steep, PaperRule::LeftEndpoint, n(count), 0.0));
        assert_eq!((one.variance, two.variance), (1.0, 1.0));
        assert_eq!((one.cube, one.fourth), (1.0, 1.0));
        close(two.cube, 2_f64.sqrt());
        close(two.fourth, 2.0);
        let Spread { variance: v, deviation: r, .. } = two;
        let (cube, fourth) = (1.0 + 1.5 * v + r * v, 1.0 + 4.0 * v + 4.0 * r * v + r * r * v);
        assert_eq!((0.5 * cube, 0.25 * fourth), (1.75, 2.5));
    }

    #[test]
    fn one_chord_has_one_speed() {
        let spread = Spread::of_first_order(setting(32.0), PaperRule::LeftEndpoint, n(1), 0.44);
        assert_eq!(spread.deviation, 0.0);
        close(spread.cube, 1.2_f64.powi(3));
        close(spread.fourth, 1.2_f64.powi(4));
    }

    /// At N = 1 and ε = 1, `m₃ = 1`, so that `x = μ/48`, which is 1/144 for μ = 1/3.
    #[test]
    fn second_order_by_hand() {
        let spread = Spread::of_second_order(setting(16.0 / 27.0), n(1), 0.0).expect("M_H");
        close(spread.shortfall, 1.0 / 144.0);
        close(spread.variance, 1.0 / 72.0 - 1.0 / 144.0_f64.powi(2));
        // For large μ the result falls back to the first order.
        let first = Spread::of_first_order(setting(1e9), PaperRule::Trapezoidal, n(9), 0.1);
        assert_eq!(Spread::of_second_order(setting(1e9), n(9), 0.1), Some(first));
        let unknown = Setting::new(constants(1.0, 2.0, 1.0), 1.0, 2).expect("valid");
        assert_eq!(Spread::of_second_order(unknown, n(9), 0.1), None);
    }

    /// At the end of the iteration, `x = μ m₃/48N²`.
    #[test]
    fn the_iteration_has_converged() {
        let (setting, n) = (setting(32.0), n(40));
        let spread = Spread::of_second_order(setting, n, 0.01).expect("M_H");
        close(spread.shortfall, 18.0 * spread.cube / (48.0 * 1600.0));
        assert!(spread.cube < 1.1 && spread.variance < 0.011, "{spread:?}");
    }

    #[test]
    fn overflow_gives_no_nan() {
        let wild = with_m_h(1e-200, 1e200, 1e300, 1e300);
        let wild = Setting::new(wild, 1e200, 2).expect("valid");
        for count in [1, 2, 1000] {
            let spread = Spread::of_second_order(wild, n(count), f64::INFINITY).expect("M_H");
            for number in [spread.shortfall, spread.variance, spread.deviation, spread.cube] {
                assert!(number >= 0.0, "{spread:?}");
            }
            assert!(spread.fourth > 1.0, "{spread:?}");
        }
    }
}
