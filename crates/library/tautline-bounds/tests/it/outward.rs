//! Bounds that are rounded outward, against those that are rounded to nearest.

use proptest::prelude::*;
use tautline_bounds::{
    BetweenPoints, Computed, Constants, DiscreteMinimum, PaperRule, Setting, convex_excess,
    convex_excess_outward, enclose, enclose_outward, reach, reach_outward, strict_convexity,
    strict_convexity_outward,
};

/// What 64 steps of the iteration of Lemma S.5 lose at most, relative to the result: a few hundred
/// roundings.
const LOST: f64 = 1e-12;

fn constants() -> impl Strategy<Value = Constants> {
    (0.01..100.0_f64, 0.0..3.0_f64, 0.0..0.3_f64, 0.0..0.3_f64, any::<[bool; 2]>()).prop_map(
        |(c1, above, l_h, m_h, [isotropic, local])| {
            let constants = Constants::new(c1, c1 * (1.0 + above), l_h * c1.powf(1.5));
            let constants = constants.and_then(|known| known.with_m_h(m_h * c1 * c1));
            let constants = constants.expect("valid");
            let constants = if isotropic { constants.isotropic() } else { constants };
            if local { constants.on_a_region() } else { constants }
        },
    )
}

fn rule() -> impl Strategy<Value = PaperRule> {
    prop::sample::select(PaperRule::BOTH.to_vec())
}

proptest! {
    #![proptest_config(tautline_chance::config(41, 1000))]

    /// In intervals each bound is on the safe side of the one in doubles, by no more than rounding.
    #[test]
    fn outward_bounds_are_on_the_safe_side(
        constants in constants(),
        rule in rule(),
        n in 1..2000_usize,
        dimension in 1..4_usize,
        [length, part, gap, difference] in [0.01..4.0_f64, 0.5..1.0_f64, 0.0..0.2_f64, 0.0..4.0_f64],
        residual in 0.0..1e-3_f64,
    ) {
        let n = n.try_into().expect("positive");
        let setting = Setting::new(constants, length, dimension).expect("valid");
        let (nearest, proved) = (reach(setting, rule, n), reach_outward(setting, rule, n));
        // Doubles may be off by a few roundings in either direction.
        prop_assert!(nearest * (1.0 - 1e-14) <= proved && proved <= nearest * (1.0 + LOST));
        let energy = length * length;
        let discrete_energy = part * energy;
        let between = BetweenPoints {
            rule, n, discrete_energy, length, greatest_difference: difference, residual,
        };
        let at_least = discrete_energy * (1.0 - 1e-15);
        let loss = strict_convexity(constants, dimension, &between);
        let proved = strict_convexity_outward(constants, dimension, &between, at_least);
        if let (Some(nearest), Some(proved)) = (loss, proved) {
            prop_assert!(proved <= nearest && nearest - proved <= LOST * energy);
        }
        let excess = convex_excess(constants, dimension, &between);
        let proved = convex_excess_outward(constants, dimension, &between);
        if let (Some(nearest), Some(proved)) = (excess, proved) {
            prop_assert!(nearest * (1.0 - 1e-13) <= proved, "{nearest} {proved}");
            prop_assert!(proved - nearest <= LOST * (energy + nearest));
        }
        for minimum in [
            DiscreteMinimum::Assumed,
            DiscreteMinimum::AtLeast(at_least),
            DiscreteMinimum::Unknown,
        ] {
            let computed = Computed {
                rule, n, discrete_energy, energy, length_squared: energy, minimum, gap,
            };
            let nearest = enclose(constants, dimension, &computed);
            let proved = enclose_outward(constants, dimension, &computed);
            if let (Ok(nearest), Ok(proved)) = (nearest, proved) {
                prop_assert!(proved.lower <= nearest.lower, "{proved:?} {nearest:?}");
                prop_assert!(nearest.lower - proved.lower <= LOST * energy);
                prop_assert_eq!(proved.upper, nearest.upper);
            }
        }
    }
}

/// What is proved of the energy from below counts, not the bound on it from above, which only says
/// where minimisers can be.
#[test]
fn the_minimum_is_bounded_by_what_is_proved_of_the_energy_from_below() {
    let constants = Constants::new(1.0, 1.5, 0.1).and_then(|known| known.with_m_h(0.01));
    let between = BetweenPoints {
        rule: PaperRule::Trapezoidal,
        n: 10.try_into().expect("positive"),
        discrete_energy: 1.0,
        length: 1.0,
        greatest_difference: 1.0,
        residual: 1e-3,
    };
    let of = |at_least| strict_convexity_outward(constants.expect("valid"), 2, &between, at_least);
    let whole = of(1.0).expect("convex");
    assert!((0.999..1.0).contains(&whole), "{whole}");
    for lower in [0.9, 0.5, 0.0, -1.0] {
        let least = of(lower).expect("convex");
        assert!(least < lower && (least - lower - (whole - 1.0)).abs() < 1e-15, "{least}");
    }
    assert_eq!([f64::NAN, f64::NEG_INFINITY].map(of), [None, None]);
}

/// Numbers at both ends of the range overflow and underflow. A reach is a bound all the same.
#[test]
fn a_reach_is_never_no_number() {
    let numbers = [0.0, 5e-324, 1e-300, 1e-100, 1.0, 1e100, 1e300, f64::MAX];
    let mut infinite = 0;
    for c1 in numbers.into_iter().skip(1) {
        for (l_h, m_h) in numbers.iter().flat_map(|&a| numbers.map(|b| (a, b))) {
            let constants = Constants::new(c1, f64::MAX, l_h).and_then(|known| known.with_m_h(m_h));
            let Ok(constants) = constants else { continue };
            for constants in [constants, constants.isotropic()] {
                for distance in numbers {
                    let setting = Setting::new(constants, distance, 2).expect("valid");
                    for rule in PaperRule::BOTH {
                        let reach = reach_outward(setting, rule, 3.try_into().expect("positive"));
                        // It is at least d/√c₁, up to rounding.
                        let least = distance / c1.sqrt() * (1.0 - 1e-15);
                        assert!(reach >= least, "{setting:?} {rule:?}: {reach}");
                        infinite += usize::from(reach == f64::INFINITY);
                    }
                }
            }
        }
    }
    assert!(infinite > 100, "{infinite}");
}
