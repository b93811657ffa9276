//! Proposition S.8: a ball that contains all competitors.

use nalgebra::SVector;
use tautline::{Bounded, LocalError, PointSequence};

use crate::statements::section_1::{GLOBAL, begin};
use crate::{
    Evidence, GramRange, Known, PaperRule, Reconstruction, Statement, Subject, Unit, VerifyError,
    reconstruction::nodes,
};

/// The number of chords on a way out of the ball.
const WAY: usize = 4;

/// Evaluates Proposition S.8 on a computed minimiser, with the radius `R` that the library finds
/// for the constants of the problem.
///
/// ```text
/// |xₙ − x|  ≤  R        for every point of the sequence, where x is its bounded end
/// |xₙ − m|  ≤  ½ d̄ √e/√c₁,        where m is the middle of its two ends
/// d  ≤  √c₁ R           so that no minimal geodesic leaves
/// E_N  ≤  c₁ R²         so that no minimal sequence leaves
/// √c₁ R  ≤  L(γ)        for segments γ of Euclidean length R from x along axes
/// ```
///
/// Needs: the setting of Theorem 1.1 within the distance `R` of the end, and a *global* minimiser
/// in this ball.
///
/// The radius is 1 % larger than necessary, which costs 1 % in the first and third inequality and 2 %
/// in the fourth. The last is attained for the metric `c₁ I`, and so is the second.
///
/// # Errors
///
/// [`VerifyError::Locality`] if there is no radius. [`VerifyError::Metric`] if `H` is not positive
/// definite.
pub fn prop_s_8<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Reconstruction<D>,
) -> Result<Evidence, VerifyError> {
    let &Reconstruction { setting, rule, n, distance_squared: d2, granted, .. } = seen;
    let (constants, distance) = (setting.constants(), setting.distance());
    let everywhere = |_| Ok::<_, LocalError>(constants);
    let region = subject.competitors(D, rule, n, distance, everywhere)?;
    let (radius, root) = (region.radius, constants.c1().sqrt());
    let sequence = &seen.minimum.sequence;
    let is_bounded = known.ends.first().radius().is_some_and(f64::is_finite);
    let end = if is_bounded { sequence.first() } else { sequence.last() };
    let farthest_from = |place: SVector<f64, D>| {
        sequence.points().iter().map(|x| (x - place).norm()).fold(0.0, f64::max)
    };
    let farthest = farthest_from(*end);
    let from_the_middle = farthest_from((sequence.first() + sequence.last()) * 0.5);
    let half = 0.5 * subject.reach(setting, rule, n);
    // Points are rounded. Lengths are roots of energies and are at least d.
    let rounding = 1e-14 * (end.norm() + radius);
    let of_lengths = if d2 > 0.0 { granted / distance } else { granted.sqrt() };
    // This is the bound of Lemma S.4 on the minimum, from which the library determines the radius.
    let mut ceiling = subject.theorem_a_minimum_gap(setting, rule, n);
    if rule == PaperRule::Trapezoidal {
        let second =
            [subject.theorem_b_minimum_gap(setting, n), subject.theorem_d_minimum_gap(setting, n)];
        ceiling = second.into_iter().flatten().fold(ceiling, f64::min);
    }
    let premise = d2 + ceiling;
    let energies = [seen.discrete_energy, (root * radius).powi(2)];
    let mut evidence = begin(Statement::PropositionS8, seen, rule, premise)
        .assumed(GLOBAL)
        .stated("|xₙ − x| ≤ R", Unit::COORDINATE, [farthest, radius], rounding)
        .stated("|xₙ − m| ≤ ½ρ", Unit::COORDINATE, [from_the_middle, half], rounding)
        .stated("d ≤ √c₁ R", Unit::LENGTH, [distance, root * radius], of_lengths)
        .stated("E_N ≤ c₁ R²", Unit::ENERGY, energies, granted);
    if let (Some(m_h), PaperRule::Trapezoidal) = (constants.m_h(), rule) {
        evidence = evidence.given_curvature(seen.curvature, m_h);
    }
    for (axis, sign) in [(0, 1.0), (0, -1.0), (D - 1, 1.0)] {
        let way = SVector::from_fn(|i, _| if i == axis { sign * radius } else { 0.0 });
        let at = |k: usize| end + way * (k as f64 / WAY as f64);
        let out = PointSequence::new((0..=WAY).map(at).collect())?;
        let length = subject.curve_length(&known.metric, &out);
        let pair = [root * radius, length.value];
        let off = length.error + 1e-14 * length.value + root * rounding;
        evidence = evidence
            .given_constants(constants, &GramRange::along(&known.metric, nodes(&out))?)
            .stated("√c₁ R ≤ L(γ) on the way out", Unit::LENGTH, pair, off);
    }
    Ok(evidence)
}
