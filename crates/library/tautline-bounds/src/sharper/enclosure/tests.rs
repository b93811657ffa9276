//! Enclosures whose bounds are explicit.

use tautline_scalar::Interval;

use super::{Computed, DiscreteMinimum, FromAbove, FromBelow, enclose, enclose_outward};
use crate::{
    BoundError, Constants, PaperRule, Setting,
    by_hand::{self, n, with_m_h},
    product::product,
    theorem_a_minimum_gap, theorem_d_minimum_gap,
};

fn constants() -> Constants {
    with_m_h(4.0, 4e6, 8.0, 32.0)
}

fn computed(rule: PaperRule, minimum: DiscreteMinimum) -> Computed {
    Computed {
        rule,
        n: n(50),
        discrete_energy: 9.0,
        energy: 10.0,
        length_squared: 9.5,
        minimum,
        gap: 0.25,
    }
}

#[test]
fn the_larger_lower_bound_counts_and_convexity_assumes_nothing() {
    let computed = computed(PaperRule::Trapezoidal, DiscreteMinimum::Assumed);
    let assumed = enclose(constants(), 2, &computed).expect("valid");
    assert!(assumed.assumes_global_minimum && assumed.lower > 1.0);
    for less in [assumed.lower, 1.0, -3.0, f64::NEG_INFINITY, f64::NAN] {
        assert_eq!(assumed.with_convexity(less), Ok(assumed));
        assert_eq!(assumed.with_certificate(less), Ok(assumed));
    }
    let convex = assumed.with_convexity(9.4).expect("below 9.5");
    assert_eq!((convex.lower, convex.from_below), (9.4, FromBelow::Convexity));
    let certified = convex.with_certificate(9.45).expect("below 9.5");
    assert_eq!((certified.lower, certified.from_below), (9.45, FromBelow::Certificate));
    assert!(!convex.assumes_global_minimum && !certified.assumes_global_minimum);
    // Rounding may lift the bound above the upper one, but not far.
    let touching = assumed.with_convexity(9.5 * (1.0 + 1e-13)).expect("rounding");
    assert_eq!(touching.width(), 0.0);
    assert!(matches!(
        assumed.with_convexity(9.6),
        Err(BoundError::Contradiction { lower: 9.6, upper: 9.5 })
    ));
}

#[test]
fn the_lower_bound_solves_the_equation_of_the_ceiling() {
    for rule in PaperRule::BOTH {
        let computed = computed(rule, DiscreteMinimum::Assumed);
        let found = enclose(constants(), 2, &computed).expect("valid");
        assert_eq!((found.upper, found.from_above), (9.5, FromAbove::Length));
        assert_eq!(found.from_below, FromBelow::Minimum);
        assert!(found.assumes_global_minimum);
        let setting = Setting::new(constants(), found.lower.sqrt(), 2).expect("valid");
        let ceiling = match rule {
            PaperRule::Trapezoidal => theorem_d_minimum_gap(setting, computed.n).expect("M_H"),
            PaperRule::LeftEndpoint => theorem_a_minimum_gap(setting, rule, computed.n),
        };
        // This allows for about twenty roundings and the error of the bisection.
        assert!((found.lower + ceiling - 9.0).abs() < 1e-13, "{found:?}");
        assert!(found.lower < 9.0 && found.width() > 0.5);
    }
}

#[test]
fn without_the_assumption_the_minimum_must_be_known() {
    let known = computed(PaperRule::Trapezoidal, DiscreteMinimum::AtLeast(9.0));
    let known = enclose(constants(), 2, &known).expect("valid");
    assert!(known.from_below == FromBelow::Minimum && !known.assumes_global_minimum);
    assert!(known.has_known_minimum);
    let convex = known.with_convexity(known.lower.next_up()).expect("below the upper bound");
    assert!(convex.from_below == FromBelow::Convexity && convex.has_known_minimum);
    for minimum in [DiscreteMinimum::Unknown, DiscreteMinimum::AtLeast(-3.0)] {
        let found = enclose(constants(), 2, &computed(PaperRule::Trapezoidal, minimum));
        let found = found.expect("valid");
        // The Euclidean bound is 4·(1/4)².
        assert_eq!((found.lower, found.from_below), (0.25, FromBelow::Euclidean));
        assert!(!found.assumes_global_minimum && !found.has_known_minimum);
    }
    let nothing =
        Computed { gap: 0.0, ..computed(PaperRule::Trapezoidal, DiscreteMinimum::Unknown) };
    let nothing = enclose(constants(), 2, &nothing).expect("valid");
    assert_eq!((nothing.lower, nothing.from_below), (0.0, FromBelow::Nothing));
}

/// `c₁ |x − y|² = 16` is better than the bound that follows from a minimum of 9, and it needs
/// no assumption.
#[test]
fn where_the_euclidean_bound_is_better_nothing_is_assumed() {
    for minimum in
        [DiscreteMinimum::Assumed, DiscreteMinimum::AtLeast(9.0), DiscreteMinimum::Unknown]
    {
        let far = Computed {
            gap: 2.0,
            energy: 20.0,
            length_squared: 18.0,
            ..computed(PaperRule::LeftEndpoint, minimum)
        };
        for (constants, local) in [(constants(), false), (constants().on_a_region(), true)] {
            let found = enclose(constants, 2, &far).expect("valid");
            assert_eq!((found.lower, found.from_below), (16.0, FromBelow::Euclidean));
            assert!(!found.assumes_global_minimum && !found.is_not_global, "{found:?}");
            assert_eq!(found.is_local, local);
        }
    }
}

/// The inequality holds for the result; for the next double it holds only because of rounding.
#[test]
fn the_equation_of_the_ceiling_is_solved_from_below() {
    let with_m_h = constants();
    let without = by_hand::constants(4.0, 40.0, 8.0);
    let mut solved = 0;
    for constants in [with_m_h, without, with_m_h.isotropic(), with_m_h.on_a_region()] {
        for (rule, count) in PaperRule::BOTH.into_iter().zip([7, 50]) {
            let n = n(count);
            for k in 1..40 {
                let least = 0.37 * f64::from(k * k);
                let setting = |d| Setting::new(constants, d, 2).expect("valid");
                let d = super::distance_from_below::<f64>(setting(0.0), rule, n, least);
                let energy = |d: f64| {
                    let surplus: f64 = super::ceiling::least(setting(d), rule, n);
                    product([d, d, 1.0 + surplus])
                };
                assert!(energy(d) <= least, "{d} for {least}");
                solved += usize::from(energy(d.next_up()) > least);
                // In intervals the result is no larger, and smaller by a few roundings.
                let proved = super::distance_from_below::<Interval>(setting(0.0), rule, n, least);
                assert!(proved <= d && d <= proved * (1.0 + 1e-14), "{proved} {d}");
            }
        }
    }
    // Two neighbouring doubles may have equal rounded products.
    assert!(solved > 200, "{solved}");
}

#[test]
fn for_a_constant_metric_the_bounds_agree() {
    let flat = with_m_h(4.0, 5.0, 0.0, 0.0);
    let exact = Computed {
        energy: 9.0,
        length_squared: 9.0,
        ..computed(PaperRule::Trapezoidal, DiscreteMinimum::Assumed)
    };
    let found = enclose(flat, 2, &exact).expect("valid");
    assert_eq!((found.lower, found.upper, found.from_above), (9.0, 9.0, FromAbove::Length));
    let local = enclose(flat.on_a_region(), 2, &exact).expect("valid");
    assert!(local.is_local && !found.is_local && local.lower == found.lower);
    // The upper bound is the smaller of squared length and energy.
    let energy = Computed { energy: 8.999, ..exact };
    let found = enclose(flat, 2, &energy).expect("valid");
    assert_eq!((found.upper, found.from_above), (8.999, FromAbove::Energy));
}

/// A discrete energy of 9 cannot be the minimum if the length is 1.
#[test]
fn a_refuted_assumption_is_not_used() {
    let good = computed(PaperRule::Trapezoidal, DiscreteMinimum::Assumed);
    let bad = Computed { length_squared: 1.0, ..good };
    let found = enclose(constants(), 2, &bad).expect("valid");
    assert!(found.is_not_global && !found.assumes_global_minimum, "{found:?}");
    assert_eq!((found.lower, found.upper), (0.25, 1.0));
    let sure = Computed { minimum: DiscreteMinimum::AtLeast(9.0), ..bad };
    let error = enclose(constants(), 2, &sure).expect_err("9 is no minimum");
    assert!(
        matches!(error, BoundError::Contradiction { lower, upper: 1.0 } if lower > 1.0),
        "{error}"
    );
    let flat = by_hand::constants(4.0, 5.0, 0.0);
    let worse = Computed { length_squared: 8.5, ..bad };
    assert!(enclose(flat, 2, &worse).expect("valid").is_not_global);
    // A rounding error refutes nothing.
    let rounded = Computed { length_squared: 9.0 * (1.0 - 1e-15), ..bad };
    let found = enclose(flat, 2, &rounded).expect("valid");
    assert!(!found.is_not_global && found.width() == 0.0, "{found:?}");
}

#[test]
fn invalid_numbers_are_errors() {
    let good = computed(PaperRule::Trapezoidal, DiscreteMinimum::Assumed);
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        for computed in [
            Computed { discrete_energy: bad, ..good },
            Computed { energy: bad, ..good },
            Computed { length_squared: bad, ..good },
        ] {
            let error = enclose(constants(), 2, &computed).expect_err("no energy");
            assert!(matches!(error, BoundError::NotAnEnergy { .. }), "{error}");
        }
        let error = enclose(constants(), 2, &Computed { gap: bad, ..good });
        assert!(matches!(error, Err(BoundError::NotADistance { .. })), "{error:?}");
    }
    assert_eq!(enclose(constants(), 0, &good), Err(BoundError::NoDimension));
    for bad in [f64::INFINITY, f64::NAN] {
        let computed = Computed { minimum: DiscreteMinimum::AtLeast(bad), ..good };
        let error = enclose(constants(), 2, &computed);
        assert!(matches!(error, Err(BoundError::NotAnEnergy { .. })), "{error:?}");
    }
}

/// `d² = c E₁`, where `E₁` is the energy of one chord of length `x` under `H = c`: nothing is lost but
/// the last digits, and the bound is below the exact product.
#[test]
fn outward_bounds_are_below_exact_ones_to_the_last_digit() {
    let mut equal = 0;
    for k in 1..2000_u32 {
        let c = 0.1 + f64::from(k) * 0.37;
        let flat = Constants::new(c, c, 0.0).expect("positive");
        let gap = f64::from(k).sqrt();
        let computed = Computed {
            rule: PaperRule::Trapezoidal,
            n: n(3),
            discrete_energy: 0.0,
            energy: 1e9,
            length_squared: 1e9,
            minimum: DiscreteMinimum::Unknown,
            gap,
        };
        let found = enclose_outward(flat, 2, &computed).expect("valid");
        // Subtracted exactly: c gap² as a sum of doubles.
        let square = gap * gap;
        let rest = gap.mul_add(gap, -square);
        let product = c * square;
        let error = c.mul_add(square, -product) + c * rest;
        assert!(found.lower - product <= error, "{c} {gap}");
        assert!(found.lower >= product * (1.0 - 1e-15));
        equal += u32::from(enclose(flat, 2, &computed).expect("valid").lower > found.lower);
        // By a minimum of the discrete energy: d ≥ √least, whose square is at most it.
        let least = square;
        let by_minimum =
            Computed { minimum: DiscreteMinimum::AtLeast(least), gap: 0.0, ..computed };
        let found = enclose_outward(flat, 2, &by_minimum).expect("valid");
        assert!(found.lower <= least && found.lower >= least * (1.0 - 2e-15), "{found:?}");
    }
    // To nearest, a good part is on the wrong side.
    assert!(equal > 500, "{equal}");
}
