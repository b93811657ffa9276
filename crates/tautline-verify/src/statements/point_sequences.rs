//! Propositions 7.8, 7.9, 8.1 and 8.2: any point sequence, minimiser or not.

use tautline::{Bounded, LeftEndpoint, MetricError, PointSequence, Trapezoidal};

use crate::{
    Evidence, GramRange, Statement, Subject, Unit,
    reconstruction::{mean_cube, nodes},
};

/// Evaluates Proposition 7.8 for nonnegative numbers: `Σ xₙ³ ≤ (Σ xₙ²)^{3/2}`.
///
/// The numbers count as coordinates, in `ℓ`. Equality if at most one of them is not zero.
#[doc(alias = "prop:ineq_cube_3/2")]
#[must_use]
pub fn prop_7_8(numbers: &[f64]) -> Evidence {
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let cubes: f64 = numbers.iter().map(|x| x.powi(3)).sum();
    let squares: f64 = numbers.iter().map(|x| x.powi(2)).sum();
    let bound = squares.powf(1.5);
    let unit = Unit { ell: 3, m: 0 };
    // Two roundings a term, one an addition, of nonnegative numbers.
    let granted = (4.0 + 2.0 * numbers.len() as f64) * f64::EPSILON * bound;
    Evidence::of(Statement::Proposition7_8)
        .given("0 ≤ xₙ", Unit::COORDINATE, [-least, 0.0], 0.0)
        .paper("Σ xₙ³ ≤ (Σ xₙ²)^{3/2}", unit, [cubes, bound], granted)
}

/// The three energies of one point sequence, and what Propositions 7.9, 8.1 and 8.2 need.
struct Energies {
    trapezoidal: f64,
    left: f64,
    curve: f64,
    /// `(L_H/N) mean |β|³`, in `m²`.
    cube: f64,
    gram: GramRange,
    granted: f64,
}

impl Energies {
    fn of<const D: usize>(
        subject: &impl Subject,
        metric: &impl Bounded<D>,
        sequence: &PointSequence<D>,
    ) -> Result<Self, MetricError> {
        let trapezoidal = subject.discrete_energy(Trapezoidal, metric, sequence);
        let left = subject.discrete_energy(LeftEndpoint, metric, sequence);
        let curve = subject.curve_energy(metric, sequence);
        let l_h = subject.constants(metric).l_h();
        Ok(Self {
            trapezoidal,
            left,
            curve: curve.value,
            cube: l_h * mean_cube(sequence) / sequence.n().get() as f64,
            gram: GramRange::along(metric, nodes(sequence))?,
            // Sums of the same size, a dozen roundings a term.
            granted: curve.error + 1e-14 * (trapezoidal + left + curve.value),
        })
    }
}

/// Evaluates Proposition 7.9: `|E(γᵖˡ) − E_tra,N(γᵖ)| ≤ L_H K₃³ / (4√N)`.
///
/// Needs: `H` Lipschitz. That `c₁ ≤ H ≤ c₂` is checked as well, but not needed.
///
/// Companion: the same with `(L_H/4N) mean |β|³`, before the proof passes to `K₃`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:approx_numerical_integral_pts")]
pub fn prop_7_9<const D: usize>(
    subject: &impl Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let constants = subject.constants(metric);
    let bound = subject.polyline_gap_trapezoidal(constants, subject.k3(sequence), sequence.n());
    let gap = (seen.curve - seen.trapezoidal).abs();
    Ok(Evidence::of(Statement::Proposition7_9)
        .given_constants(constants, &seen.gram)
        .paper("|E(γᵖˡ) − E_tra,N| ≤ L_H K₃³/4√N", Unit::ENERGY, [gap, bound], seen.granted)
        .sharper(
            "|E(γᵖˡ) − E_tra,N| ≤ L_H mean|β|³/4N",
            Unit::ENERGY,
            [gap, 0.25 * seen.cube],
            seen.granted,
        ))
}

/// Evaluates Proposition 8.1: `|E_l,N(γᵖ) − E_tra,N(γᵖ)| ≤ L_H K₃³ / (2√N)`.
///
/// Needs: as [`prop_7_9`].
///
/// Companion: the same with `(L_H/2N) mean |β|³`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:left_trapezoidal_fomula")]
pub fn prop_8_1<const D: usize>(
    subject: &impl Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let constants = subject.constants(metric);
    let bound = subject.rule_gap(constants, subject.k3(sequence), sequence.n());
    let gap = (seen.left - seen.trapezoidal).abs();
    Ok(Evidence::of(Statement::Proposition8_1)
        .given_constants(constants, &seen.gram)
        .paper("|E_l,N − E_tra,N| ≤ L_H K₃³/2√N", Unit::ENERGY, [gap, bound], seen.granted)
        .sharper(
            "|E_l,N − E_tra,N| ≤ L_H mean|β|³/2N",
            Unit::ENERGY,
            [gap, 0.5 * seen.cube],
            seen.granted,
        ))
}

/// Evaluates Proposition 8.2: `|E(γᵖˡ) − E_l,N(γᵖ)| ≤ L_H K₃³ / (2√N)`.
///
/// Needs: as [`prop_7_9`].
///
/// Companion: the same with `(L_H/2N) mean |β|³`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:approx_numerical_integral_pts_left")]
pub fn prop_8_2<const D: usize>(
    subject: &impl Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let constants = subject.constants(metric);
    let bound = subject.polyline_gap_left(constants, subject.k3(sequence), sequence.n());
    let gap = (seen.curve - seen.left).abs();
    Ok(Evidence::of(Statement::Proposition8_2)
        .given_constants(constants, &seen.gram)
        .paper("|E(γᵖˡ) − E_l,N| ≤ L_H K₃³/2√N", Unit::ENERGY, [gap, bound], seen.granted)
        .sharper(
            "|E(γᵖˡ) − E_l,N| ≤ L_H mean|β|³/2N",
            Unit::ENERGY,
            [gap, 0.5 * seen.cube],
            seen.granted,
        ))
}
