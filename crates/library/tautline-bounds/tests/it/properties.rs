//! The units, monotonicity and range of every function of a setting, checked from one table.

use std::num::NonZeroUsize;

use approx::{assert_relative_eq, relative_eq};
use proptest::prelude::*;
use tautline_bounds::{self as bounds, Setting};

use crate::{decades, n, setting};

/// A function of the setting and of `N`, with the exponents of its formula.
struct Entry {
    name: &'static str,
    value: fn(Setting, NonZeroUsize) -> f64,
    /// The unit is `ℓ^ell m^m`.
    ell: i32,
    m: i32,
    /// The least exponents of `d` and of `L_H`.
    d: i32,
    l_h: i32,
    /// The least and the greatest exponent of `1/N`.
    fall: [f64; 2],
}

#[rustfmt::skip]
const ENTRIES: [Entry; 16] = [
    Entry { name: "k1_g", value: |s, _| bounds::k1_g(s), ell: 1, m: 0, d: 1, l_h: 0, fall: [0.0, 0.0] },
    Entry { name: "k2_g", value: |s, _| bounds::k2_g(s), ell: 1, m: 0, d: 2, l_h: 1, fall: [0.0, 0.0] },
    Entry { name: "k3_bar_g", value: |s, _| bounds::k3_bar_g(s), ell: 1, m: 0, d: 1, l_h: 0, fall: [0.0, 0.0] },
    Entry { name: "k4_bar_g", value: |s, _| bounds::k4_bar_g(s), ell: 1, m: 0, d: 1, l_h: 0, fall: [0.0, 0.0] },
    Entry { name: "c_tra_sharp_g", value: |s, _| bounds::c_tra_sharp_g(s), ell: 0, m: 2, d: 3, l_h: 1, fall: [0.0, 0.0] },
    Entry { name: "theorem_1_1_constant", value: |s, _| bounds::theorem_1_1_constant(s), ell: 0, m: 2, d: 3, l_h: 1, fall: [0.0, 0.0] },
    Entry { name: "theorem_1_3_constant", value: |s, _| bounds::theorem_1_3_constant(s), ell: 0, m: 2, d: 3, l_h: 1, fall: [0.0, 0.0] },
    Entry { name: "c_tra_g", value: bounds::c_tra_g, ell: 0, m: 2, d: 3, l_h: 1, fall: [1.0, 2.0] },
    Entry { name: "theorem_1_1_minimum_gap", value: bounds::theorem_1_1_minimum_gap, ell: 0, m: 2, d: 3, l_h: 1, fall: [1.0, 1.0] },
    Entry { name: "theorem_1_1_polyline_gap", value: bounds::theorem_1_1_polyline_gap, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 0.5] },
    Entry { name: "theorem_1_1_excess", value: bounds::theorem_1_1_excess, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 1.0] },
    Entry { name: "theorem_1_2_length_excess", value: bounds::theorem_1_2_length_excess, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 0.5] },
    Entry { name: "theorem_1_3_minimum_gap", value: bounds::theorem_1_3_minimum_gap, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 0.5] },
    Entry { name: "theorem_1_3_polyline_gap", value: bounds::theorem_1_3_polyline_gap, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 0.5] },
    Entry { name: "theorem_1_3_excess", value: bounds::theorem_1_3_excess, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 1.0] },
    Entry { name: "theorem_1_4_length_excess", value: bounds::theorem_1_4_length_excess, ell: 0, m: 2, d: 3, l_h: 1, fall: [0.5, 0.5] },
];

/// Draws `c₁`, `κ = c₂ / c₁ ≥ 1`, `δ = L_H d / c₁^{3/2}`, `d` and `D`. With `δ` within one and a
/// half decades of 1, every term of every formula contributes.
fn settings() -> impl Strategy<Value = Setting> {
    let numbers = (decades(-2.0, 2.0), decades(0.0, 1.5), decades(-1.5, 1.5), decades(-2.0, 2.0));
    (numbers, 1..5_usize).prop_map(|((c1, kappa, delta, d), dimension)| {
        setting(c1, kappa * c1, delta * c1.powf(1.5) / d, d, dimension)
    })
}

fn subintervals() -> impl Strategy<Value = NonZeroUsize> {
    (1..5000_usize).prop_map(n)
}

/// Returns the setting with `c₁`, `c₂`, `L_H` and `d` multiplied by these factors.
fn scaled(s: Setting, c1: f64, c2: f64, l_h: f64, d: f64) -> Setting {
    let c = s.constants();
    setting(c.c1() * c1, c.c2() * c2, c.l_h() * l_h, s.distance() * d, s.dimension())
}

// Inputs and their factors are rounded up to five times each, and the worst result varies like d⁹,
// L_H⁷ and c₁^−13. The total error of 5 (9 + 7 + 13) + 2 · 40 roundings is below
// 250 · 2⁻⁵³ < 3e-14.
const TOLERANCE: f64 = 1e-13;

proptest! {
    #![proptest_config(tautline_chance::config(2, 512))]

    /// Changing the units of `ℓ` and `m` scales a bound by its unit.
    #[test]
    fn functions_of_a_setting_are_homogeneous(
        s in settings(), n in subintervals(), ell in decades(-3.0, 3.0), m in decades(-3.0, 3.0)
    ) {
        let h = (m / ell).powi(2);
        let there = scaled(s, h, h, h / ell, m);
        for entry in &ENTRIES {
            let expected = (entry.value)(s, n) * ell.powi(entry.ell) * m.powi(entry.m);
            let value = (entry.value)(there, n);
            let equal = relative_eq!(value, expected, max_relative = TOLERANCE);
            prop_assert!(equal, "{}: {value:e}, expected {expected:e}", entry.name);
        }
    }

    /// The same holds for the functions that take `K₁`, `K₂`, `K₃` as arguments.
    #[test]
    fn functions_of_speeds_are_homogeneous(
        s in settings(), n in subintervals(), ell in decades(-3.0, 3.0), m in decades(-3.0, 3.0),
        k in decades(-1.0, 1.0), k2 in decades(-1.0, 1.0)
    ) {
        let h = (m / ell).powi(2);
        let (here, there) = (s.constants(), scaled(s, h, h, h / ell, m).constants());
        let all = |constants, k, k2| [
            ("c_tra", bounds::c_tra(constants, k, k2, n)),
            ("c_tra_sharp", bounds::c_tra_sharp(constants, k, k2)),
            ("polyline_gap_trapezoidal", bounds::polyline_gap_trapezoidal(constants, k, n)),
            ("polyline_gap_left", bounds::polyline_gap_left(constants, k, n)),
            ("rule_gap", bounds::rule_gap(constants, k, n)),
        ];
        let values = all(there, k * ell, k2 * ell).into_iter().zip(all(here, k, k2));
        for ((name, value), (_, here)) in values {
            let expected = m * m * here;
            let equal = relative_eq!(value, expected, max_relative = TOLERANCE);
            prop_assert!(equal, "{name}: {value:e}, expected {expected:e}");
        }
    }

    /// All bounds are sums of powers of `d`, `L_H`, `c₂`, `1/c₁` and `1/N`, or roots of sums of
    /// this form. So they increase with `c₂` and `1/c₁`, and with `d` and `L_H` at least like the
    /// smallest power.
    #[test]
    fn bounds_are_monotone(s in settings(), n in subintervals(), t in 1.01..10.0_f64) {
        for entry in &ENTRIES {
            let value = |s: Setting| (entry.value)(s, n);
            let here = value(s) * (1.0 - TOLERANCE);
            let name = entry.name;
            prop_assert!(value(scaled(s, 1.0, 1.0, 1.0, t)) >= here * t.powi(entry.d), "{name}, d");
            prop_assert!(
                value(scaled(s, 1.0, 1.0, t, 1.0)) >= here * t.powi(entry.l_h), "{name}, L_H"
            );
            prop_assert!(value(scaled(s, 1.0, t, 1.0, 1.0)) >= here, "{name}, c2");
            prop_assert!(value(scaled(s, 1.0 / t, 1.0, 1.0, 1.0)) >= here, "{name}, c1");
            let c = s.constants();
            let higher = setting(c.c1(), c.c2(), c.l_h(), s.distance(), s.dimension() + 1);
            prop_assert!(value(higher) >= here, "{name}, D");
        }
    }

    /// When `N` becomes `4 N`, a bound falls by a factor between the two powers of 4 in its
    /// formula.
    #[test]
    fn bounds_fall_with_n(s in settings(), n in subintervals()) {
        let four_n = NonZeroUsize::new(4 * n.get()).expect("positive");
        for entry in &ENTRIES {
            let ratio = (entry.value)(s, four_n) / (entry.value)(s, n);
            let [least, most] = entry.fall.map(|power| 4_f64.powf(-power));
            prop_assert!(
                ratio <= least * (1.0 + TOLERANCE) && ratio >= most * (1.0 - TOLERANCE),
                "{}: {ratio}", entry.name
            );
        }
    }

    /// `C_tra(N) ≤ C_tra♯ / N`, with equality at `N = 1`. The excesses in the proofs are at most
    /// `C / √N`, again with equality at `N = 1`. Both hold exactly, since rounding is monotone.
    #[test]
    fn merged_bounds_are_larger(s in settings(), n in subintervals()) {
        prop_assert!(bounds::c_tra_g(s, n) <= bounds::c_tra_sharp_g(s) / n.get() as f64);
        prop_assert!(bounds::theorem_1_1_excess(s, n) <= bounds::theorem_1_2_length_excess(s, n));
        prop_assert!(bounds::theorem_1_3_excess(s, n) <= bounds::theorem_1_4_length_excess(s, n));
        let one = NonZeroUsize::MIN;
        prop_assert_eq!(bounds::c_tra_g(s, one), bounds::c_tra_sharp_g(s));
        prop_assert_eq!(bounds::theorem_1_1_excess(s, one), bounds::theorem_1_1_constant(s));
        prop_assert_eq!(bounds::theorem_1_3_excess(s, one), bounds::theorem_1_3_constant(s));
    }

    /// The proofs yield bounds smaller than `C / N` and `C / √N`: the constants contain these
    /// bounds as parts, at the speeds for which they were derived.
    #[test]
    fn constants_contain_the_parts_of_their_proofs(s in settings(), n in subintervals()) {
        let (constants, grant) = (s.constants(), 1.0 + TOLERANCE);
        let (k3, k4) = (bounds::k3_bar_g(s), bounds::k4_bar_g(s));
        prop_assert!(bounds::k1_g(s) <= k3 && k3 <= k4);
        prop_assert!(bounds::c_tra_g(s, n) <= bounds::theorem_1_1_minimum_gap(s, n) * grant);
        let by_speed = bounds::polyline_gap_trapezoidal(constants, k3, n);
        prop_assert!(by_speed <= bounds::theorem_1_1_polyline_gap(s, n) * grant);
        let by_speed = bounds::polyline_gap_left(constants, k4, n);
        prop_assert!(by_speed <= bounds::theorem_1_3_polyline_gap(s, n) * grant);
        let through_tra = bounds::c_tra_g(s, n) + bounds::rule_gap(constants, k3, n);
        prop_assert!(through_tra <= bounds::theorem_1_3_minimum_gap(s, n) * grant);
    }

    /// Computes `C_tra♯ / d² = δ + 3 D² δ² + 6 κ D² δ + 9 κ D⁴ δ²` without `K_{1,g}` and `K_{2,g}`,
    /// and from it the `C` of Theorem 1.1, in units with `c₁ = d = 1`, where `L_H = δ`.
    #[test]
    fn constants_expand_in_delta_and_kappa(s in settings()) {
        let (c, d) = (s.constants(), s.distance());
        let delta = c.l_h() * d / c.c1().powf(1.5);
        let (kappa, dim) = (c.c2() / c.c1(), s.dimension() as f64);
        let sharp = delta
            + 3.0 * dim.powi(2) * delta.powi(2)
            + 6.0 * kappa * dim.powi(2) * delta
            + 9.0 * kappa * dim.powi(4) * delta.powi(2);
        assert_relative_eq!(bounds::c_tra_sharp_g(s) / d.powi(2), sharp, max_relative = TOLERANCE);
        let third = (1.0 + sharp).powf(1.5);
        let constant = sharp + delta * third / 4.0;
        assert_relative_eq!(
            bounds::theorem_1_1_constant(s) / d.powi(2), constant, max_relative = TOLERANCE
        );
        let fourth = (1.0 + sharp + delta * third / 2.0).powf(1.5);
        let constant = sharp + delta * (third + fourth) / 2.0;
        assert_relative_eq!(
            bounds::theorem_1_3_constant(s) / d.powi(2), constant, max_relative = TOLERANCE
        );
    }

    /// Over the whole range of `f64` a bound is never NaN, never negative, and 0 only by underflow.
    #[test]
    fn no_setting_gives_a_nan(
        c1 in decades(-307.0, 307.0), kappa in decades(0.0, 300.0), l_h in decades(-307.0, 307.0),
        d in decades(-307.0, 307.0), zero in 0..8_usize, dimension in 1..usize::MAX,
        n in 1..usize::MAX, k2 in decades(-307.0, 307.0)
    ) {
        let c2 = (c1 * kappa).min(f64::MAX);
        // One case in eight has L_H = 0, and one in eight has d = 0.
        let l_h = if zero == 0 { 0.0 } else { l_h };
        let d = if zero == 1 { 0.0 } else { d };
        let (s, n) = (setting(c1, c2, l_h, d, dimension), NonZeroUsize::new(n).expect("positive"));
        for entry in &ENTRIES {
            let value = (entry.value)(s, n);
            prop_assert!(value >= 0.0, "{}: {value}", entry.name);
            if d == 0.0 || (l_h == 0.0 && entry.l_h > 0) {
                prop_assert_eq!(value, 0.0);
            }
        }
        for k in [d, k2, f64::INFINITY] {
            prop_assert!(bounds::c_tra(s.constants(), k, k2, n) >= 0.0);
            prop_assert!(bounds::c_tra(s.constants(), k2, k, n) >= 0.0);
            prop_assert!(bounds::rule_gap(s.constants(), k, n) >= 0.0);
        }
    }
}
