//! Propositions 7.8, 7.9, 8.1 and 8.2, and Lemma S.2, which hold for any point sequence.

use tautline::{Bounded, Constants, MetricError, PointSequence, Rule};

use crate::{
    Evidence, GramRange, PaperRule, Statement, Subject, Unit,
    curvature::curvature_along,
    reconstruction::{mean_power, nodes},
};

/// Evaluates Proposition 7.8 for nonnegative numbers: `Σ xₙ³ ≤ (Σ xₙ²)^{3/2}`.
///
/// The numbers count as coordinates, in `ℓ`. Equality holds if at most one of them is nonzero.
#[doc(alias = "prop:ineq_cube_3/2")]
#[must_use]
pub fn prop_7_8(numbers: &[f64]) -> Evidence {
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let cubes: f64 = numbers.iter().map(|x| x.powi(3)).sum();
    let squares: f64 = numbers.iter().map(|x| x.powi(2)).sum();
    let bound = squares.powf(1.5);
    let unit = Unit { ell: 3, m: 0 };
    // The numbers are nonnegative. A term has two roundings, and an addition has one.
    let granted = (4.0 + 2.0 * numbers.len() as f64) * f64::EPSILON * bound;
    Evidence::of(Statement::Proposition7_8)
        .given("0 ≤ xₙ", Unit::COORDINATE, [-least, 0.0], 0.0)
        .stated("Σ xₙ³ ≤ (Σ xₙ²)^{3/2}", unit, [cubes, bound], granted)
}

/// The three energies of a point sequence, with the means of its differences.
struct Energies {
    trapezoidal: f64,
    left: f64,
    curve: f64,
    /// `mean |β|³`, in `ℓ³`.
    mean_cube: f64,
    /// `mean |β|⁴`, in `ℓ⁴`.
    mean_fourth: f64,
    gram: GramRange,
    granted: f64,
}

impl Energies {
    fn of<const D: usize>(
        subject: &Subject,
        metric: &impl Bounded<D>,
        sequence: &PointSequence<D>,
    ) -> Result<Self, MetricError> {
        let trapezoidal = subject.discrete_energy(Rule::TRAPEZOIDAL, metric, sequence);
        let left = subject.discrete_energy(Rule::LEFT_ENDPOINT, metric, sequence);
        let curve = subject.curve_energy(metric, sequence);
        Ok(Self {
            trapezoidal,
            left,
            curve: curve.value,
            mean_cube: mean_power(sequence, 3),
            mean_fourth: mean_power(sequence, 4),
            gram: GramRange::along(metric, nodes(sequence))?,
            // The energies are sums of the same size with a dozen roundings per term.
            granted: curve.error + 1e-14 * (trapezoidal + left + curve.value),
        })
    }

    /// Compares the gap between two energies with the bounds in terms of `K₃` and of the mean cube.
    fn gap(
        &self,
        statement: Statement,
        constants: Constants,
        [one, other]: [f64; 2],
        [stated, sharper]: [(&'static str, f64); 2],
    ) -> Evidence {
        let gap = (one - other).abs();
        Evidence::of(statement)
            .given_constants(constants, &self.gram)
            .stated(stated.0, Unit::ENERGY, [gap, stated.1], self.granted)
            .sharper(sharper.0, Unit::ENERGY, [gap, sharper.1], self.granted)
    }
}

/// Evaluates Proposition 7.9: `|E(γᵖˡ) − E_tra,N(γᵖ)| ≤ L_H K₃³ / (4√N)`.
///
/// Needs: `H` Lipschitz; `c₁ ≤ H ≤ c₂` is checked, but not needed.
///
/// Companion: the bound `(L_H/4N) mean |β|³`, before the proof passes to `K₃`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:approx_numerical_integral_pts")]
pub fn prop_7_9<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let (constants, n) = (subject.constants(metric), sequence.n());
    let bounds = [
        (
            "|E(γᵖˡ) − E_tra,N| ≤ L_H K₃³/4√N",
            subject.polyline_gap_trapezoidal(constants, subject.k3(sequence), n),
        ),
        (
            "|E(γᵖˡ) − E_tra,N| ≤ L_H mean|β|³/4N",
            subject.cubic_gap(constants, PaperRule::Trapezoidal, seen.mean_cube, n),
        ),
    ];
    Ok(seen.gap(Statement::Proposition7_9, constants, [seen.curve, seen.trapezoidal], bounds))
}

/// Evaluates Proposition 8.1: `|E_l,N(γᵖ) − E_tra,N(γᵖ)| ≤ L_H K₃³ / (2√N)`.
///
/// Needs: the hypotheses of [`prop_7_9`]. Companion: the bound `(L_H/2N) mean |β|³`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:left_trapezoidal_fomula")]
pub fn prop_8_1<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let (constants, n) = (subject.constants(metric), sequence.n());
    let bounds = [
        ("|E_l,N − E_tra,N| ≤ L_H K₃³/2√N", subject.rule_gap(constants, subject.k3(sequence), n)),
        (
            "|E_l,N − E_tra,N| ≤ L_H mean|β|³/2N",
            subject.cubic_rule_gap(constants, seen.mean_cube, n),
        ),
    ];
    Ok(seen.gap(Statement::Proposition8_1, constants, [seen.left, seen.trapezoidal], bounds))
}

/// Evaluates Proposition 8.2: `|E(γᵖˡ) − E_l,N(γᵖ)| ≤ L_H K₃³ / (2√N)`.
///
/// Needs: the hypotheses of [`prop_7_9`]. Companion: the bound `(L_H/2N) mean |β|³`.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:approx_numerical_integral_pts_left")]
pub fn prop_8_2<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let (constants, n) = (subject.constants(metric), sequence.n());
    let bounds = [
        (
            "|E(γᵖˡ) − E_l,N| ≤ L_H K₃³/2√N",
            subject.polyline_gap_left(constants, subject.k3(sequence), n),
        ),
        (
            "|E(γᵖˡ) − E_l,N| ≤ L_H mean|β|³/2N",
            subject.cubic_gap(constants, PaperRule::LeftEndpoint, seen.mean_cube, n),
        ),
    ];
    Ok(seen.gap(Statement::Proposition8_2, constants, [seen.curve, seen.left], bounds))
}

/// Evaluates Lemma S.2 on any point sequence.
///
/// ```text
/// |E(γᵖˡ) − E_N|  ≤  (k L_H/N) mean |β|³,      |E_l,N − E_tra,N|  ≤  (L_H/2N) mean |β|³
/// |E(γᵖˡ) − E_tra,N|  ≤  (M_H/24N²) mean |β|⁴,                 if M_H is known
/// ```
///
/// Here `k = ¼` for the trapezoidal rule and `k = ½` for the left-endpoint rule.
///
/// Needs: `H` Lipschitz with `L_H`, and for the last bound `DH` Lipschitz with `M_H`; `c₁ ≤ H ≤ c₂`
/// is checked, but not needed.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
pub fn lemma_s_2<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let seen = Energies::of(subject, metric, sequence)?;
    let (constants, n, granted) = (subject.constants(metric), sequence.n(), seen.granted);
    let [tra, left] =
        PaperRule::BOTH.map(|rule| subject.cubic_gap(constants, rule, seen.mean_cube, n));
    let between = subject.cubic_rule_gap(constants, seen.mean_cube, n);
    let gaps =
        [seen.curve - seen.trapezoidal, seen.curve - seen.left, seen.left - seen.trapezoidal];
    let [of_tra, of_left, of_rules] = gaps.map(f64::abs);
    let mut evidence = Evidence::of(Statement::LemmaS2).given_constants(constants, &seen.gram);
    if let Some(m_h) = constants.m_h() {
        evidence = evidence.given_curvature(curvature_along(metric, sequence), m_h);
    }
    evidence = evidence
        .stated("|E(γᵖˡ) − E_tra,N| ≤ L_H mean|β|³/4N", Unit::ENERGY, [of_tra, tra], granted)
        .stated("|E(γᵖˡ) − E_l,N| ≤ L_H mean|β|³/2N", Unit::ENERGY, [of_left, left], granted)
        .stated("|E_l,N − E_tra,N| ≤ L_H mean|β|³/2N", Unit::ENERGY, [of_rules, between], granted);
    if let Some(bound) = subject.quartic_gap(constants, seen.mean_fourth, n) {
        let claim = "|E(γᵖˡ) − E_tra,N| ≤ M_H mean|β|⁴/24N²";
        evidence = evidence.stated(claim, Unit::ENERGY, [of_tra, bound], granted);
    }
    Ok(evidence)
}
