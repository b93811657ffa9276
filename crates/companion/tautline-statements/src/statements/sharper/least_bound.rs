//! The least of all bounds on the length, which the library reports to users.

use crate::statements::section_1::begin;
use crate::{Evidence, PaperRule, Reconstruction, Statement, Subject, Unit};

/// Evaluates the least bound on `L(γᵖˡ)² − d²` on a computed minimiser: the least of the bounds in
/// the theorem of the paper and in Theorems A to D.
///
/// The evidence counts for Theorem D if the rule is trapezoidal and `M_H` is known, and for Theorem
/// C otherwise. For large `N` the bound of this theorem is the least, so that both have the same
/// overestimation.
///
/// Needs: the hypotheses of the theorems, including stationary inner points, and the premise with
/// the least ceiling of Lemma S.4.
#[must_use]
pub fn least_length_bound<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let &Reconstruction { setting, rule, n, distance_squared: d2, granted, .. } = seen;
    let sharp = subject.theorem_d_minimum_gap(setting, n);
    let (statement, above) = match sharp.filter(|_| rule == PaperRule::Trapezoidal) {
        Some(above) => (Statement::TheoremD, above),
        None => (Statement::TheoremC, subject.theorem_a_minimum_gap(setting, rule, n)),
    };
    let mut evidence = begin(statement, seen, rule, d2 + above);
    if let Some(m_h) = setting.constants().m_h() {
        evidence = evidence.given_curvature(seen.curvature, m_h);
    }
    let least = subject.least_length_excess(setting, rule, n).value;
    let excess = seen.length_squared.value - d2;
    evidence.stated("L(γᵖˡ)² − d² ≤ the least bound", Unit::ENERGY, [excess, least], granted)
}
