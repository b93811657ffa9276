//! The units, monotonicity and flags of the sharper bounds, checked from one table: with and
//! without `M_H`, isotropic or not, on a region or on all of space.

use std::num::NonZeroUsize;

use proptest::prelude::*;
use tautline_bounds::{self as bounds, Constants, PaperRule, Setting, Theorem};

use crate::{decades, n};

const TRA: PaperRule = PaperRule::Trapezoidal;
const LEFT: PaperRule = PaperRule::LeftEndpoint;

/// A function that returns a bound on an energy, in `m²`, or `None` without `M_H`.
type Energy = fn(Setting, NonZeroUsize) -> Option<f64>;

#[rustfmt::skip]
const ENERGIES: [(&str, Energy); 20] = [
    ("A minimum, trapezoidal", |s, n| Some(bounds::theorem_a_minimum_gap(s, TRA, n))),
    ("A minimum, left", |s, n| Some(bounds::theorem_a_minimum_gap(s, LEFT, n))),
    ("A gap, trapezoidal", |s, n| Some(bounds::theorem_a_polyline_gap(s, TRA, n))),
    ("A gap, left", |s, n| Some(bounds::theorem_a_polyline_gap(s, LEFT, n))),
    ("A excess, trapezoidal", |s, n| Some(bounds::theorem_a_excess(s, TRA, n))),
    ("A excess, left", |s, n| Some(bounds::theorem_a_excess(s, LEFT, n))),
    ("C deficit, trapezoidal", |s, n| Some(bounds::theorem_c_deficit(s, TRA, n))),
    ("C deficit, left", |s, n| Some(bounds::theorem_c_deficit(s, LEFT, n))),
    ("C excess, trapezoidal", |s, n| Some(bounds::theorem_c_excess(s, TRA, n))),
    ("C excess, left", |s, n| Some(bounds::theorem_c_excess(s, LEFT, n))),
    ("C length, trapezoidal", |s, n| Some(bounds::theorem_c_length_excess(s, TRA, n))),
    ("C length, left", |s, n| Some(bounds::theorem_c_length_excess(s, LEFT, n))),
    ("B minimum", bounds::theorem_b_minimum_gap),
    ("B gap", bounds::theorem_b_polyline_gap),
    ("B excess", bounds::theorem_b_excess),
    ("D minimum", bounds::theorem_d_minimum_gap),
    ("D deficit", bounds::theorem_d_deficit),
    ("D gap", bounds::theorem_d_polyline_gap),
    ("D excess", bounds::theorem_d_excess),
    ("D length", bounds::theorem_d_length_excess),
];

/// The number of entries that need `M_H`; they are the last ones.
const WITH_M_H: usize = 8;

/// The numbers that define a setting.
#[derive(Clone, Copy, Debug)]
struct Numbers {
    /// `c₁`, `c₂`, `L_H`, `d`.
    c: [f64; 4],
    m_h: Option<f64>,
    dimension: usize,
    isotropic: bool,
    local: bool,
}

impl Numbers {
    fn setting(self) -> Setting {
        let [c1, c2, l_h, d] = self.c;
        let constants = Constants::new(c1, c2, l_h).expect("in order");
        let constants = self.m_h.map_or(constants, |m| constants.with_m_h(m).expect("in order"));
        let constants = if self.isotropic { constants.isotropic() } else { constants };
        let constants = if self.local { constants.on_a_region() } else { constants };
        Setting::new(constants, d, self.dimension).expect("a distance")
    }

    /// Scales `c₁`, `c₂`, `L_H`, `d` by `factors`, and `M_H` by `m_h`.
    fn times(self, factors: [f64; 4], m_h: f64) -> Self {
        let c = std::array::from_fn(|k| self.c[k] * factors[k]);
        Self { c, m_h: self.m_h.map(|m| m * m_h), ..self }
    }
}

/// Draws `δ` and `μ` from 0.01 to 100, so that each entry of each minimum is the least in some
/// cases.
fn numbers() -> impl Strategy<Value = Numbers> {
    let numbers = (decades(-2.0, 2.0), decades(0.0, 3.0), decades(-2.0, 2.0), decades(-2.0, 2.0));
    let m_h = proptest::option::weighted(0.8, decades(-2.0, 2.0));
    (numbers, m_h, 1..4_usize, any::<bool>(), any::<bool>()).prop_map(
        |((c1, kappa, delta, d), mu, dimension, isotropic, local)| Numbers {
            c: [c1, kappa * c1, delta * c1.powf(1.5) / d, d],
            m_h: mu.map(|mu| mu * c1 * c1 / (d * d)),
            dimension,
            isotropic,
            local,
        },
    )
}

fn subintervals() -> impl Strategy<Value = NonZeroUsize> {
    prop_oneof![1..5_usize, 5..5000_usize].prop_map(n)
}

// Inputs are rounded a few times each and enter with powers up to 9; differences lose at most two
// digits.
const TOLERANCE: f64 = 1e-11;

proptest! {
    #![proptest_config(tautline_chance::config(4, 512))]

    /// Changing the units of `ℓ` and `m` scales a bound by its unit.
    #[test]
    fn the_sharper_bounds_are_homogeneous(
        s in numbers(), n in subintervals(), ell in decades(-3.0, 3.0), m in decades(-3.0, 3.0)
    ) {
        let h = (m / ell).powi(2);
        let there = s.times([h, h, h / ell, m], h / ell / ell).setting();
        let here = s.setting();
        for (name, bound) in ENERGIES {
            let (value, expected) = (bound(there, n), bound(here, n).map(|x| x * m * m));
            prop_assert_eq!(value.is_some(), expected.is_some());
            let (value, expected) = (value.unwrap_or(0.0), expected.unwrap_or(0.0));
            prop_assert!((value - expected).abs() <= TOLERANCE * expected, "{name}: {value:e}");
        }
        prop_assert!((there.bend() / here.bend() - 1.0).abs() < TOLERANCE);
        for (rule, k2) in [(TRA, bounds::k2_sharp(here)), (LEFT, bounds::k2_sharp(here))] {
            prop_assert!((bounds::k2_sharp(there) / ell / k2 - 1.0).abs() < TOLERANCE);
            let reach = bounds::reach(here, rule, n) * ell;
            prop_assert!((bounds::reach(there, rule, n) / reach - 1.0).abs() < TOLERANCE);
        }
    }

    /// Each bound increases with `d`, `c₂`, `L_H` and `M_H` and decreases with `c₁`. It does not
    /// improve from all of space to a region, from an isotropic metric to a general one, or from
    /// one dimension to a higher one.
    #[test]
    fn worse_constants_give_larger_bounds(
        s in numbers(), n in subintervals(), t in 1.0..10.0_f64
    ) {
        let worse = [
            ("d", s.times([1.0, 1.0, 1.0, t], 1.0)),
            ("c2", s.times([1.0, t, 1.0, 1.0], 1.0)),
            ("L_H", s.times([1.0, 1.0, t, 1.0], 1.0)),
            ("M_H", s.times([1.0; 4], t)),
            ("c1", s.times([1.0 / t, 1.0, 1.0, 1.0], 1.0)),
            ("region", Numbers { local: true, ..s }),
            ("any metric", Numbers { isotropic: false, ..s }),
            ("plane", Numbers { dimension: s.dimension + 1, ..s }),
        ];
        for (name, bound) in ENERGIES {
            let here = bound(s.setting(), n).unwrap_or(0.0) * (1.0 - TOLERANCE);
            for (what, worse) in worse {
                let there = bound(worse.setting(), n).unwrap_or(0.0);
                prop_assert!(there >= here, "{name}, {what}: {there:e} below {here:e}");
            }
        }
    }

    /// No bound increases with `N` (S.10). From one chord to two the caps of the moments
    /// decide.
    #[test]
    fn more_chords_never_give_a_larger_bound(
        s in numbers(), n in subintervals(), more in prop_oneof![Just(1), 1..50_usize]
    ) {
        let (s, finer) = (s.setting(), crate::n(n.get() + more));
        for (name, bound) in ENERGIES {
            let (coarse, fine) = (bound(s, n).unwrap_or(0.0), bound(s, finer).unwrap_or(0.0));
            prop_assert!(fine <= coarse * (1.0 + TOLERANCE), "{name}: {coarse:e} {fine:e}");
        }
        for rule in PaperRule::BOTH {
            for bound in [bounds::least_excess, bounds::least_length_excess] {
                let (coarse, fine) = (bound(s, rule, n).value, bound(s, rule, finer).value);
                prop_assert!(fine <= coarse * (1.0 + TOLERANCE), "{coarse:e} {fine:e}");
            }
            let reach = |n| bounds::reach(s, rule, n);
            prop_assert!(reach(finer) <= reach(n) * (1.0 + TOLERANCE));
        }
        let sampled = |n| bounds::sampled_excess(s, n).unwrap_or(0.0);
        prop_assert!(sampled(finer) <= sampled(n) * (1.0 + TOLERANCE));
    }

    /// Without `M_H`, the bounds that need it are `None`. The others have the same values as with
    /// `M_H` on a region, where `M_H` does not improve the bend.
    #[test]
    fn only_bounds_of_second_order_need_m_h(s in numbers(), n in subintervals()) {
        let unknown = Numbers { m_h: None, ..s }.setting();
        let known = Numbers { m_h: Some(s.m_h.unwrap_or(1.0)), local: true, ..s }.setting();
        for (k, (name, bound)) in ENERGIES.into_iter().enumerate() {
            if k < ENERGIES.len() - WITH_M_H {
                prop_assert_eq!(bound(unknown, n), bound(known, n), "{}", name);
            } else {
                prop_assert!(bound(unknown, n).is_none() && bound(known, n).is_some(), "{name}");
            }
        }
        prop_assert_eq!(bounds::second_order_excess(unknown, n), None);
    }

    /// The least bound is at most every bound and equals the bound of the theorem it names. The
    /// constants for all `N` give bounds at least as large as those for a single `N`.
    #[test]
    fn the_least_bound_is_the_least(s in numbers(), n in subintervals()) {
        let s = s.setting();
        let tra = bounds::least_excess(s, TRA, n);
        let all = [
            (Theorem::Paper, Some(bounds::theorem_1_1_excess(s, n))),
            (Theorem::A, Some(bounds::theorem_a_excess(s, TRA, n))),
            (Theorem::B, bounds::theorem_b_excess(s, n)),
            (Theorem::C, Some(bounds::theorem_c_excess(s, TRA, n))),
            (Theorem::D, bounds::theorem_d_excess(s, n)),
        ];
        for (theorem, value) in all {
            prop_assert!(value.is_none_or(|value| tra.value <= value), "{theorem:?}");
            prop_assert!(tra.by != theorem || value == Some(tra.value), "{theorem:?}");
        }
        let left = bounds::least_excess(s, LEFT, n);
        let all = [
            (Theorem::Paper, bounds::theorem_1_3_excess(s, n)),
            (Theorem::A, bounds::theorem_a_excess(s, LEFT, n)),
            (Theorem::C, bounds::theorem_c_excess(s, LEFT, n)),
        ];
        for (theorem, value) in all {
            prop_assert!(left.value <= value && (left.by != theorem || left.value == value));
        }
        let first = bounds::theorem_a_excess(s, TRA, n).min(bounds::theorem_c_excess(s, TRA, n));
        prop_assert_eq!(bounds::first_order_excess(s, TRA, n), first);
        let second = bounds::theorem_b_excess(s, n).zip(bounds::theorem_d_excess(s, n));
        prop_assert_eq!(bounds::second_order_excess(s, n), second.map(|(b, d)| b.min(d)));
        for rule in PaperRule::BOTH {
            let length = bounds::least_length_excess(s, rule, n).value;
            prop_assert!(length <= bounds::least_excess(s, rule, n).value);
            prop_assert!(length <= bounds::theorem_c_length_excess(s, rule, n));
            let (excess, constant) =
                (bounds::theorem_a_excess(s, rule, n), bounds::theorem_a_constant(s, rule));
            prop_assert!(excess <= constant / n.get() as f64 * (1.0 + TOLERANCE));
        }
        let squared = (n.get() as f64).powi(2);
        let constant = bounds::theorem_b_constant(s).map(|c| c / squared * (1.0 + TOLERANCE));
        prop_assert!(bounds::theorem_b_excess(s, n) <= constant);
    }

    #[test]
    fn the_reach_follows_from_the_least_ceiling(s in numbers(), n in subintervals()) {
        let s = s.setting();
        let d2 = s.distance().powi(2);
        for rule in PaperRule::BOTH {
            let mut surplus = bounds::theorem_a_minimum_gap(s, rule, n);
            if rule == TRA {
                let second = bounds::theorem_b_minimum_gap(s, n).unwrap_or(f64::INFINITY);
                let fourth = bounds::theorem_d_minimum_gap(s, n).unwrap_or(f64::INFINITY);
                surplus = surplus.min(second).min(fourth);
            }
            let expected = ((d2 + surplus) / s.constants().c1()).sqrt();
            prop_assert!((bounds::reach(s, rule, n) / expected - 1.0).abs() < TOLERANCE);
        }
    }

    /// The bounds are exactly zero.
    #[test]
    fn bounds_are_zero_for_touching_ends_and_for_constant_metrics(s in numbers(), n in subintervals()) {
        let touching = s.times([1.0, 1.0, 1.0, 0.0], 1.0).setting();
        let constant = s.times([1.0, 1.0, 0.0, 1.0], 0.0).setting();
        for (name, bound) in ENERGIES {
            prop_assert_eq!(bound(touching, n).unwrap_or(0.0), 0.0, "{}", name);
            prop_assert_eq!(bound(constant, n).unwrap_or(0.0), 0.0, "{}", name);
        }
    }
}
