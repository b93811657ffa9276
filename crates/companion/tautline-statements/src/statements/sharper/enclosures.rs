//! Propositions S.6, S.7 and S.9: an enclosure of the distance, global discrete minima, and the
//! excess of one sequence by convexity.

use tautline::{
    Bounded, PointSequence,
    bounds::{BetweenPoints, Computed, DiscreteMinimum},
};

use crate::statements::section_1::{GLOBAL, admitted};
use crate::{
    Evidence, GramRange, Known, PaperRule, Reconstruction, Statement, Subject, Unit, VerifyError,
    discrete_energy, reconstruction::nodes,
};

/// Evaluates Proposition S.6 on a computed minimiser, which is assumed to be global. `gap` is a
/// lower bound on the Euclidean distance between the sets, in `ℓ`.
///
/// ```text
/// lower  ≤  d²  ≤  L(γᵖˡ)²,      lower = max{ d² : d² e(d) ≤ E_N },  or  c₁ gap²
/// ```
///
/// Needs: the setting of Theorem 1.1; the lower bound also needs a *global* minimiser. The bounds
/// are attained by constant metrics.
///
/// # Errors
///
/// [`VerifyError::Bound`] if an energy is negative or not finite.
pub fn prop_s_6<const D: usize>(
    subject: &Subject,
    seen: &Reconstruction<D>,
    gap: f64,
) -> Result<Evidence, VerifyError> {
    let constants = seen.setting.constants();
    let computed = |minimum| Computed {
        rule: seen.rule,
        n: seen.n,
        discrete_energy: seen.discrete_energy,
        energy: seen.energy.value,
        length_squared: seen.length_squared.value,
        minimum,
        gap,
    };
    let assumed = subject.enclose(constants, D, &computed(DiscreteMinimum::Assumed))?;
    let unknown = subject.enclose(constants, D, &computed(DiscreteMinimum::Unknown))?;
    let (d2, granted) = (seen.distance_squared, seen.granted);
    let mut evidence = admitted(Evidence::of(Statement::PropositionS6), seen).assumed(GLOBAL);
    if let (Some(m_h), PaperRule::Trapezoidal) = (constants.m_h(), seen.rule) {
        evidence = evidence.given_curvature(seen.curvature, m_h);
    }
    Ok(evidence
        .stated("d² ≤ L(γᵖˡ)²", Unit::ENERGY, [d2, assumed.upper], granted)
        .stated("lower ≤ d²", Unit::ENERGY, [assumed.lower, d2], granted)
        .stated("c₁ gap² ≤ d²", Unit::ENERGY, [unknown.lower, d2], granted)
        .sharper("lower ≤ E_N", Unit::ENERGY, [assumed.lower, seen.discrete_energy], granted))
}

/// Evaluates Proposition S.7 on two sequences between the same two points.
///
/// ```text
/// σ  ≤  4 [½ (E_N(x) + E_N(y)) − E_N(½(x + y))] / mean|β(x) − β(y)|²,      |βₙ| ≤ B for both
/// E_N(x) − R²/(4σ N² sin²(π/2N))  ≤  E_N(y),                              where σ > 0
/// ```
///
/// The first inequality says that `E_N` is convex with modulus `σ` along a segment; its right side
/// is half the mean second derivative. The second says that `x` has the least energy of all
/// sequences, up to a term in its residual `R`. `length` is the length of the reconstruction of
/// `x`, in `m`.
///
/// Needs: `c₁ ≤ H`, `H` Lipschitz with `L_H`, and `DH` Lipschitz with `M_H`; both sequences have
/// the same ends and the same `N`.
///
/// The first inequality is attained at `N = 2` for the trapezoidal rule if `H` has the slopes
/// `±L_H` at the midpoints.
///
/// # Errors
///
/// [`VerifyError`] where `H` is not positive definite, or the midpoints overflow.
pub fn prop_s_7<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    rule: PaperRule,
    [x, y]: [&PointSequence<D>; 2],
    length: f64,
) -> Result<Evidence, VerifyError> {
    let (n, constants) = (x.n(), subject.constants(metric));
    let other_ends = (x.first() - y.first()).norm().max((x.last() - y.last()).norm());
    let points = x.points().iter().zip(y.points()).map(|(x, y)| (x + y) * 0.5);
    let middle = PointSequence::new(points.collect())?;
    let [of_x, of_y, of_middle] =
        [x, y, &middle].map(|sequence| discrete_energy(subject, rule, metric, sequence));
    let greatest = |sequence: &PointSequence<D>| {
        sequence.differences().map(|beta| beta.norm()).fold(0.0, f64::max)
    };
    let apart: f64 =
        x.differences().zip(y.differences()).map(|(b, c)| (b - c).norm_squared()).sum();
    let apart = apart / n.get() as f64;
    let both = greatest(x).max(greatest(y));
    let mut evidence = Evidence::of(Statement::PropositionS7)
        .given("the ends are the same", Unit::COORDINATE, [other_ends, 0.0], 0.0)
        .given_that("N is the same", y.n() == n);
    for sequence in [x, y, &middle] {
        evidence = evidence.given_constants(constants, &GramRange::along(metric, nodes(sequence))?);
        if let Some(m_h) = constants.m_h() {
            evidence = evidence.given_curvature(crate::curvature_along(metric, sequence), m_h);
        }
    }
    // As for a reconstruction, the sums are compensated, and the points are rounded.
    let size = x.points().iter().chain(y.points()).map(|x| x.norm()).fold(0.0, f64::max);
    let sum = of_x + of_y + of_middle;
    let momentum = 2.0 * (constants.c2() * sum).sqrt();
    let granted = 1e-14 * sum + 8.0 * f64::EPSILON * size * momentum;
    evidence = evidence.given_that("x ≠ y", apart > 0.0);
    if let Some(modulus) = subject.convexity_modulus(constants, rule, both, n) {
        let convexity = 4.0 * (0.5 * (of_x + of_y) - of_middle) / apart;
        let claim = "σ ≤ the convexity of E from x to y";
        evidence = evidence.stated(claim, Unit::GRAM, [modulus, convexity], 4.0 * granted / apart);
    }
    let computed = BetweenPoints {
        rule,
        n,
        discrete_energy: of_x,
        length,
        greatest_difference: greatest(x),
        residual: residual(subject, metric, rule, x),
    };
    if let Some(least) = subject.strict_convexity(constants, D, &computed) {
        let numbers = [least, of_y.min(of_middle)];
        evidence = evidence.stated("E(x) − R²/4σN²sin² ≤ E(y)", Unit::ENERGY, numbers, granted);
    }
    Ok(evidence)
}

/// Evaluates Proposition S.9 on any sequence between two points at a known distance. Returns `None`
/// if `M_H` is unknown, if convexity is not proved, or if an end is not a point.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  P + (K + S)²/4σ
/// ```
///
/// Needs: the setting of Theorem 1.1, and `DH` Lipschitz with `M_H`. The sequence need be neither a
/// minimiser nor stationary.
///
/// The bound is attained by minimisers of the trapezoidal rule up an incline, and by a wave under a
/// constant metric.
///
/// # Errors
///
/// [`VerifyError`] where `H` is not positive definite.
pub fn prop_s_9<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    rule: PaperRule,
    sequence: &PointSequence<D>,
) -> Result<Option<Evidence>, VerifyError> {
    let (metric, distance) = (&known.metric, known.distance);
    let constants = subject.constants(metric);
    let energy = subject.curve_energy(metric, sequence);
    let computed = BetweenPoints {
        rule,
        n: sequence.n(),
        discrete_energy: discrete_energy(subject, rule, metric, sequence),
        length: distance,
        greatest_difference: sequence.differences().map(|beta| beta.norm()).fold(0.0, f64::max),
        residual: residual(subject, metric, rule, sequence),
    };
    let fixed = known.ends.are_points();
    let (Some(m_h), Some(bound), true) =
        (constants.m_h(), subject.convex_excess(constants, D, &computed), fixed)
    else {
        return Ok(None);
    };
    // As for a reconstruction, the sums are compensated, and the points are rounded.
    let size = sequence.points().iter().map(|x| x.norm()).fold(0.0, f64::max);
    let momentum = 2.0 * (constants.c2() * energy.value).sqrt();
    let granted = 1e-14 * (distance * distance + energy.value)
        + 8.0 * f64::EPSILON * size * momentum
        + known.squared_error()
        + energy.error;
    let ends = [(known.ends.first(), sequence.first()), (known.ends.second(), sequence.last())];
    let off = ends.map(|(end, x)| (end.project(x) - x).norm()).into_iter().fold(0.0, f64::max);
    let excess = energy.value - distance * distance;
    let evidence = Evidence::of(Statement::PropositionS9)
        .given_constants(constants, &GramRange::along(metric, nodes(sequence))?)
        .given_curvature(crate::curvature_along(metric, sequence), m_h)
        .given("the ends lie in X⁽⁰⁾ and X⁽¹⁾", Unit::COORDINATE, [off, 0.0], 1e-13 * size)
        .stated("E(γᵖˡ) − d² ≤ P + (K + S)²/4σ", Unit::ENERGY, [excess, bound], granted);
    Ok(Some(evidence))
}

/// Returns `((1/N) Σ |ρₙ|²)^{1/2}` over the inner points, in `m²/ℓ`.
fn residual<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    rule: PaperRule,
    sequence: &PointSequence<D>,
) -> f64 {
    let gradient = subject.energy_gradient(rule.into(), metric, sequence);
    let n = sequence.n().get();
    let squares: f64 = gradient[1..n].iter().map(|g| g.norm_squared()).sum();
    0.5 * (n as f64 * squares).sqrt()
}
