//! `Enclosure`: bounds on `d²` from one computed sequence (Proposition S.6).

use std::num::NonZeroUsize;

use tautline_metrics::Constants;
use tautline_scalar::Interval;

use super::{Computed, DiscreteMinimum, ceiling};
use crate::{BoundError, PaperRule, Setting, number::Number};

/// The statement that proves a lower bound on `d²`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FromAbove {
    /// `L(γᵖˡ)²`, the squared length of a curve between the two sets.
    Length,
    /// `E(γᵖˡ)`, the energy of this curve, if rounding makes it smaller than the squared length.
    Energy,
}

/// Bounds on `d²`, with the statements that prove them and the assumptions they need.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// Whether a positive lower bound on the least discrete energy is known
    /// ([`DiscreteMinimum::AtLeast`]). In the enclosures of a line, the discrete energy then is
    /// strictly convex where all competitors are (Proposition S.7), so that there is only one local
    /// minimum among them.
    pub has_known_minimum: bool,
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
/// The computation rounds to nearest, so the last digits are not certified; those of
/// [`enclose_outward`] are.
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
    enclose_in::<f64>(constants, dimension, computed)
}

/// Encloses `d²` like [`enclose`], with a lower bound that is rounded down to the last digit.
///
/// - `computed`: upper bounds on `energy` and `length_squared`; lower bounds on `discrete_energy`, on
///   the least one that `minimum` says, and on `gap`.
///
/// # Errors
///
/// As for [`enclose`].
pub fn enclose_outward(
    constants: Constants,
    dimension: usize,
    computed: &Computed,
) -> Result<Enclosure, BoundError> {
    enclose_in::<Interval>(constants, dimension, computed)
}

fn enclose_in<T: Number>(
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
    let euclidean = T::product([constants.c1(), gap, gap].map(T::constant)).below();
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
    let solved = T::constant(distance_from_below::<T>(zero, rule, n, least)).sqr().below();
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
        has_known_minimum: matches!(minimum, DiscreteMinimum::AtLeast(least) if least > 0.0),
        is_local: constants.is_local(),
    })
}

/// Returns the largest `d` with `d² e(d) ≤ least` that bisection finds, in `m`. It is a lower bound
/// on the distance between the ends if `min E_N ≥ least`.
fn distance_from_below<T: Number>(
    setting: Setting,
    rule: PaperRule,
    n: NonZeroUsize,
    least: f64,
) -> f64 {
    let at_most = |d: f64| {
        setting.with_distance(d).is_ok_and(|setting| {
            let surplus: T = ceiling::least(setting, rule, n);
            let d = T::constant(d);
            T::product([d, d, surplus + 1.0]).is_at_most(least)
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
mod tests;
