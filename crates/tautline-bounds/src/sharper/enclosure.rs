//! Proposition S.6: from one computed sequence, two numbers between which `d²` lies.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use super::ceiling;
use crate::{BoundError, PaperRule, Setting, product::product};

/// What is known of the minimum of a discrete energy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DiscreteMinimum {
    /// That the computed energy is the minimum over all admissible sequences: assumed, since a
    /// solver shows no more than a local minimum.
    Assumed,
    /// That it is at least this, in `m²`; see [`strict_convexity`](crate::strict_convexity).
    AtLeast(f64),
    /// Nothing.
    Unknown,
}

/// What was computed of one admissible sequence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Computed {
    /// The rule of the discrete energy.
    pub rule: PaperRule,
    /// The number of subintervals.
    pub n: NonZeroUsize,
    /// `E_N`, in `m²`.
    pub discrete_energy: f64,
    /// `E(γᵖˡ)`, in `m²`.
    pub energy: f64,
    /// `L(γᵖˡ)²`, in `m²`.
    pub length_squared: f64,
    /// What is known of the minimum of `E_N`.
    pub minimum: DiscreteMinimum,
    /// The Euclidean distance of the two sets, in `ℓ`; 0 if it is not known.
    pub gap: f64,
}

/// By which statement `d²` is at least a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FromBelow {
    /// It is a square.
    Nothing,
    /// Proposition 3.3: `c₁ |x − y|² ≤ d²`.
    Euclidean,
    /// Lemma S.4: `min E_N ≤ d² e`, solved for `d`.
    Minimum,
}

/// By which number `d²` is bounded from above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FromAbove {
    /// `L(γᵖˡ)²`, the squared length of a curve between the sets.
    Length,
    /// `E(γᵖˡ)`, its energy, if that came out less: equal but for rounding.
    Energy,
}

/// Two numbers between which `d²` lies, by which statements, and on which assumption.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Enclosure {
    /// `d²` is at least this, in `m²`.
    pub lower: f64,
    /// `d²` is at most this, in `m²`.
    pub upper: f64,
    /// What `lower` rests on.
    pub from_below: FromBelow,
    /// What `upper` rests on.
    pub from_above: FromAbove,
    /// Whether `lower` needs that the computed energy is the global minimum.
    pub assumes_global_minimum: bool,
    /// Whether the numbers show that it is not: then there is a sequence with less discrete energy,
    /// and nothing was concluded from the assumption.
    pub is_not_global: bool,
    /// Whether the constants hold on a region only. Then a global minimum is one among the sequences
    /// in the region (Proposition S.8).
    pub is_local: bool,
}

impl Enclosure {
    /// Returns `upper − lower`, in `m²`: a bound of `L(γᵖˡ)² − d²`, computed from the sequence alone.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.upper - self.lower
    }
}

/// Encloses `d²` by one computed sequence (Proposition S.6).
///
/// - *From above*, without any assumption: `d² ≤ L(γᵖˡ)² ≤ E(γᵖˡ)`.
/// - *From below*: `min E_N ≤ d² e` with the least `e` of Lemma S.4, which grows with `d`; solved for
///   `d`. No upper bound of `d` is needed. And `c₁ |x − y|² ≤ d²`.
///
/// Needs: the setting of Theorem 1.1 with `constants`, in `dimension` dimensions, on the region
/// that matters (Proposition S.8), and ends in their sets; from below what
/// [`DiscreteMinimum`] says.
///
/// The numbers are rounded to nearest, and `energy` and `length_squared` are taken as they are:
/// the enclosure is computed, not certified to its last digits.
///
/// # Errors
///
/// [`BoundError::NotAnEnergy`] if an energy is negative, infinite or NaN;
/// [`BoundError::NotADistance`] if `gap` is; [`BoundError::NoDimension`];
/// [`BoundError::Contradiction`] if the minimum is said to be at least what this sequence disproves.
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
            // A bound of a nonnegative number may be negative, and then says nothing.
            let least = if least < 0.0 { 0.0 } else { least };
            BoundError::check_energy(least)?;
            least
        }
        DiscreteMinimum::Unknown => 0.0,
    };
    let solved = distance_from_below(zero, rule, n, least).powi(2);
    // min E_N ≤ F(d) ≤ F(upper): a minimum above that is none, unless by rounding.
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

/// Returns a `d` for which `d² e(d) ≤ least`, in `m`, as large as bisection finds it: the distance
/// of the ends is at least that, if `min E_N ≥ least`.
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
        BoundError, Constants, PaperRule, Setting, theorem_a_minimum_gap, theorem_d_minimum_gap,
    };
    use std::num::NonZeroUsize;

    fn constants() -> Constants {
        Constants::new(4.0, 4e6, 8.0).and_then(|c| c.with_m_h(32.0)).expect("in order")
    }

    fn computed(rule: PaperRule, minimum: DiscreteMinimum) -> Computed {
        Computed {
            rule,
            n: NonZeroUsize::new(50).expect("positive"),
            discrete_energy: 9.0,
            energy: 10.0,
            length_squared: 9.5,
            minimum,
            gap: 0.25,
        }
    }

    #[test]
    fn the_lower_end_solves_the_ceiling() {
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
            // Some twenty roundings, and that of the bisection.
            assert!((found.lower + ceiling - 9.0).abs() < 1e-13, "{found:?}");
            assert!(found.lower < 9.0 && found.width() > 0.5);
        }
    }

    #[test]
    fn without_the_assumption_the_minimum_has_to_be_known() {
        let known = computed(PaperRule::Trapezoidal, DiscreteMinimum::AtLeast(9.0));
        let known = enclose(constants(), 2, &known).expect("valid");
        assert!(known.from_below == FromBelow::Minimum && !known.assumes_global_minimum);
        for minimum in [DiscreteMinimum::Unknown, DiscreteMinimum::AtLeast(-3.0)] {
            let found = enclose(constants(), 2, &computed(PaperRule::Trapezoidal, minimum));
            let found = found.expect("valid");
            // 4·(1/4)².
            assert_eq!((found.lower, found.from_below), (0.25, FromBelow::Euclidean));
            assert!(!found.assumes_global_minimum);
        }
        let nothing =
            Computed { gap: 0.0, ..computed(PaperRule::Trapezoidal, DiscreteMinimum::Unknown) };
        let nothing = enclose(constants(), 2, &nothing).expect("valid");
        assert_eq!((nothing.lower, nothing.from_below), (0.0, FromBelow::Nothing));
    }

    /// `c₁ |x − y|² = 16` is above what the minimum of 9 tells, and rests on nothing else: no
    /// assumption is made where it is not needed. Whether the constants are those of a region is
    /// said by whatever statement the lower end holds.
    #[test]
    fn where_the_euclidean_distance_is_the_better_bound_nothing_is_assumed() {
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

    /// The last double for which `d² e(d)` is at most the minimum, and not the one behind it.
    #[test]
    fn the_equation_of_the_ceiling_is_solved_from_below() {
        let with_m_h = constants();
        let without = Constants::new(4.0, 40.0, 8.0).expect("in order");
        let mut solved = 0;
        for constants in [with_m_h, without, with_m_h.isotropic(), with_m_h.on_a_region()] {
            for (rule, count) in PaperRule::BOTH.into_iter().zip([7, 50]) {
                let n = NonZeroUsize::new(count).expect("positive");
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
        // Of two neighbours both may do, where the products round alike.
        assert!(solved > 200, "{solved}");
    }

    #[test]
    fn a_constant_metric_is_enclosed_by_one_number() {
        let flat = Constants::new(4.0, 5.0, 0.0).and_then(|c| c.with_m_h(0.0)).expect("valid");
        let exact = Computed {
            energy: 9.0,
            length_squared: 9.0,
            ..computed(PaperRule::Trapezoidal, DiscreteMinimum::Assumed)
        };
        let found = enclose(flat, 2, &exact).expect("valid");
        assert_eq!((found.lower, found.upper, found.from_above), (9.0, 9.0, FromAbove::Length));
        let local = enclose(flat.on_a_region(), 2, &exact).expect("valid");
        assert!(local.is_local && !found.is_local && local.lower == found.lower);
        // What came out less is taken, by whatever rounding.
        let energy = Computed { energy: 8.999, ..exact };
        let found = enclose(flat, 2, &energy).expect("valid");
        assert_eq!((found.upper, found.from_above), (8.999, FromAbove::Energy));
    }

    /// A discrete energy of 9 where the length is 1: some sequence has less.
    #[test]
    fn an_assumption_that_the_numbers_disprove_is_not_used() {
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
        let flat = Constants::new(4.0, 5.0, 0.0).expect("in order");
        let worse = Computed { length_squared: 8.5, ..bad };
        assert!(enclose(flat, 2, &worse).expect("valid").is_not_global);
        // A rounding is no disproof.
        let rounded = Computed { length_squared: 9.0 * (1.0 - 1e-15), ..bad };
        let found = enclose(flat, 2, &rounded).expect("valid");
        assert!(!found.is_not_global && found.width() == 0.0, "{found:?}");
    }

    #[test]
    fn what_is_no_energy_is_refused() {
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
