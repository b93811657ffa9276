//! The least of all bounds of the length: what a user of the theorems is told.

use crate::statements::section_1::begin;
use crate::{Evidence, PaperRule, Reconstruction, Statement, Subject, Unit};

/// Evaluates the least bound of the length on a computed minimiser: of the paper's theorem, and of
/// Theorems A to D, the smallest number for `L(γᵖˡ)² − d²`.
///
/// Counted as Theorem D where the rule is the trapezoidal one and `M_H` is known, and as Theorem C
/// otherwise, which are the least for large `N`.
///
/// Needs: what the theorems need, of which stationary inner points; the premise with the least
/// ceiling of Lemma S.4.
///
/// Overestimation: that of Theorems C and D.
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
