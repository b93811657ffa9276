//! `Enclosure`: bounds on `d²` from one computed sequence (Proposition S.6).

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use super::{Computed, DiscreteMinimum, ceiling};
use crate::{BoundError, PaperRule, Setting, product::product};

/// The statement that proves a lower bound on `d²`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FromBelow {
    /// The trivial bound `d² ≥ 0`.
    Nothing,
    /// Proposition 3.3: `c₁ |x − y|² ≤ d²`.
    Euclidean,
    /// Lemma S.4: `min E_N ≤ d² e`, solved for `d`.
    Minimum,
    /// Proposition S.9: a bound on `E(γᵖˡ) − d²` by convexity.
    Convexity,
    /// A certificate of the distance: a function that grows no faster than the length of any curve.
    Certificate,
}

/// The number that serves as the upper bound on `d²`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FromAbove {
    /// `L(γᵖˡ)²`, the squared length of a curve between the two sets.
    Length,
    /// `E(γᵖˡ)`, the energy of this curve, if rounding makes it smaller than the squared length.
    Energy,
}

/// Bounds on `d²`, with the statements that prove them and the assumptions they need.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// The lower bound, in `m²`.
    pub lower: f64,
    /// The upper bound, in `m²`.
    pub upper: f64,
    /// The statement that proves `lower`.
    pub from_below: FromBelow,
    /// The number that `upper` equals.
    pub from_above: FromAbove,
    /// Whether `lower` assumes that the computed energy is the global minimum.
    pub assumes_global_minimum: bool,
    /// Whether the numbers refute that assumption: some sequence has a smaller discrete energy. In
    /// that case `lower` does not use the assumption.
    pub is_not_global: bool,
    /// Whether the constants hold on a region only. In that case "global" means among the sequences
    /// in the region (Proposition S.8).
    pub is_local: bool,
}

impl Enclosure {
    /// Returns `upper − lower`, in `m²`, which bounds `L(γᵖˡ)² − d²` from the sequence alone.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.upper - self.lower
    }

    /// Returns the enclosure with the lower bound `lower`, in `m²`, of Proposition S.9 if that is
    /// larger. It assumes nothing about a minimum.
    ///
    /// # Errors
    ///
    /// [`BoundError::Contradiction`] if it is larger than the upper bound by more than rounding.
    pub fn with_convexity(self, lower: f64) -> Result<Enclosure, BoundError> {
        self.with(lower, FromBelow::Convexity)
    }

    /// Returns the enclosure with the lower bound `lower`, in `m²`, of a certificate of the distance
    /// if that is larger. It assumes nothing about a minimum.
    ///
    /// # Errors
    ///
    /// [`BoundError::Contradiction`] if it is larger than the upper bound by more than rounding.
    pub fn with_certificate(self, lower: f64) -> Result<Enclosure, BoundError> {
        self.with(lower, FromBelow::Certificate)
    }

    /// Returns the enclosure with a lower bound that assumes nothing, if that is larger.
    fn with(self, lower: f64, from_below: FromBelow) -> Result<Enclosure, BoundError> {
        let upper = self.upper;
        if lower > upper * (1.0 + 1e-12) {
            return Err(BoundError::Contradiction { lower, upper });
        }
        // A lower bound that is NaN carries no information.
        if !(lower > self.lower) {
            return Ok(self);
        }
        let lower = lower.min(upper);
        Ok(Enclosure { lower, from_below, assumes_global_minimum: false, ..self })
    }
}

/// Encloses `d²`, given one computed sequence (Proposition S.6).
///
/// - *From above*, without assumptions: `d² ≤ L(γᵖˡ)² ≤ E(γᵖˡ)`.
/// - *From below*: `min E_N ≤ d² e` with the least `e` of Lemma S.4. Since `e` increases with `d`,
///   the inequality can be solved for `d`, and no upper bound on `d` is needed. In addition,
///   `c₁ |x − y|² ≤ d²`.
///
/// Needs: the setting of Theorem 1.1, with `constants` on the region of the competitors
/// (Proposition S.8); ends in their sets; for the lower bound, the knowledge stated in
/// [`DiscreteMinimum`].
///
/// The computation rounds to nearest and treats `energy` and `length_squared` as exact, so the last
/// digits are not certified.
///
/// # Errors
///
/// [`BoundError::NotAnEnergy`] if an energy is negative, infinite or NaN;
/// [`BoundError::NotADistance`] if `gap` is negative, infinite or NaN;
/// [`BoundError::NoDimension`] if the dimension is 0; [`BoundError::Contradiction`] if the sequence
/// refutes the lower bound on the minimum.
pub fn enclose(
    constants: Constants,
    dimension: usize,
    computed: &Computed,
) -> Result<Enclosure, BoundError> {
    let &Computed { rule, n, discrete_energy, energy, length_squared, minimum, gap } = computed;
    for energy in [discrete_energy, energy, length_squared] {
        BoundError::check_energy(energy)?;
    }
    let zero = Setting::new(constants, 0.0, dimension)?;
    zero.with_distance(gap)?;
    let (upper, from_above) = if energy < length_squared {
        (energy, FromAbove::Energy)
    } else {
        (length_squared, FromAbove::Length)
    };
    let (mut lower, mut from_below) = (0.0, FromBelow::Nothing);
    let euclidean = product([constants.c1(), gap, gap]);
    if euclidean > lower {
        (lower, from_below) = (euclidean, FromBelow::Euclidean);
    }
    let least = match minimum {
        DiscreteMinimum::Assumed => discrete_energy,
        DiscreteMinimum::AtLeast(least) => {
            // A negative lower bound carries no information.
            let least = if least < 0.0 { 0.0 } else { least };
            BoundError::check_energy(least)?;
            least
        }
        DiscreteMinimum::Unknown => 0.0,
    };
    let solved = distance_from_below(zero, rule, n, least).powi(2);
    // The solution is at most d² ≤ upper, up to rounding, unless the claimed minimum is wrong.
    let contradicts = solved > upper * (1.0 + 1e-12);
    if contradicts && matches!(minimum, DiscreteMinimum::AtLeast(_)) {
        return Err(BoundError::Contradiction { lower: solved, upper });
    }
    let is_not_global = minimum == DiscreteMinimum::Assumed && contradicts;
    let mut assumes_global_minimum = false;
    if solved > lower && !is_not_global {
        (lower, from_below) = (solved.min(upper), FromBelow::Minimum);
        assumes_global_minimum = minimum == DiscreteMinimum::Assumed;
    }
    Ok(Enclosure {
        lower,
        upper,
        from_below,
        from_above,
        assumes_global_minimum,
        is_not_global,
        is_local: constants.is_local(),
    })
}

/// Returns the largest `d` with `d² e(d) ≤ least` that bisection finds, in `m`. It is a lower bound
/// on the distance between the ends if `min E_N ≥ least`.
fn distance_from_below(setting: Setting, rule: PaperRule, n: NonZeroUsize, least: f64) -> f64 {
    let at_most = |d: f64| {
        setting.with_distance(d).is_ok_and(|setting| {
            let surplus = ceiling::least(setting, rule, n);
            product([d, d, 1.0 + surplus]) <= least
        })
    };
    // e ≥ 1, so d ≤ √least.
    let (mut low, mut high) = (0.0, least.sqrt());
    if at_most(high) {
        return high;
    }
    loop {
        let middle = low + 0.5 * (high - low);
        if middle <= low || middle >= high {
            return low;
        }
        if at_most(middle) { low = middle } else { high = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::{Computed, DiscreteMinimum, FromAbove, FromBelow, enclose};
    use crate::{
        BoundError, Constants, PaperRule, Setting,
        by_hand::{self, n, with_m_h},
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
        for minimum in [DiscreteMinimum::Unknown, DiscreteMinimum::AtLeast(-3.0)] {
            let found = enclose(constants(), 2, &computed(PaperRule::Trapezoidal, minimum));
            let found = found.expect("valid");
            // The Euclidean bound is 4·(1/4)².
            assert_eq!((found.lower, found.from_below), (0.25, FromBelow::Euclidean));
            assert!(!found.assumes_global_minimum);
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
                    let d = super::distance_from_below(setting(0.0), rule, n, least);
                    let energy = |d: f64| {
                        super::product([d, d, 1.0 + super::ceiling::least(setting(d), rule, n)])
                    };
                    assert!(energy(d) <= least, "{d} for {least}");
                    solved += usize::from(energy(d.next_up()) > least);
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
}
