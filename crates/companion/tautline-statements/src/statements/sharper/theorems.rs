//! Lemma S.4 and Theorems A to D: the excess of a discrete minimiser, of order `1/N` and `1/N²`.
//!
//! As in Section 1, a solver finds a local minimiser, but the theorems are about a global one. The
//! *premise* says that the energy of the sequence is at most the bound of Lemma S.4 on the minimum.
//! It is a hypothesis of Theorems A to D. Where it holds, they hold for the computed sequence.

use crate::statements::section_1::{GLOBAL, admitted, begin};
use crate::{Evidence, PaperRule, Reconstruction, Statement, Subject, Unit};

/// Evaluates Lemma S.4 on a computed minimiser.
///
/// ```text
/// E_tra,N − d²  ≤  d² min(κ − 1, δ/4N + Gδ/12N²),      E_l,N − d²  ≤  d² min(κ − 1, δ/2N)
/// E_tra,N − d²  ≤  d² (Gδ/3 + μ/24)/N²,  and  d² (ê − 1),            if M_H is known
/// ```
///
/// Needs: the setting of Theorem 1.1, `DH` Lipschitz where `M_H` enters, and a *global* minimiser.
/// No evaluation shows that a minimiser is global: a sequence with more energy is a worse local
/// minimiser.
///
/// The bounds are attained as `δ → 0`, at `N = 1`: over a ridge for the trapezoidal rule, and down
/// an incline for the left-endpoint rule.
#[must_use]
pub fn lemma_s_4<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let &Reconstruction { setting, rule, n, granted, .. } = seen;
    let surplus = seen.discrete_energy - seen.distance_squared;
    let first = subject.theorem_a_minimum_gap(setting, rule, n);
    let mut evidence = admitted(Evidence::of(Statement::LemmaS4), seen).assumed(GLOBAL);
    evidence = evidence.stated("E_N − d² ≤ d² (e − 1)", Unit::ENERGY, [surplus, first], granted);
    if rule == PaperRule::Trapezoidal {
        if let Some(m_h) = setting.constants().m_h() {
            evidence = evidence.given_curvature(seen.curvature, m_h);
        }
        let second = subject.theorem_b_minimum_gap(setting, n);
        let third = subject.theorem_d_minimum_gap(setting, n);
        for (claim, bound) in
            [("E_tra,N − d² ≤ d² (e₂ − 1)", second), ("E_tra,N − d² ≤ d² (ê − 1)", third)]
        {
            if let Some(bound) = bound {
                evidence = evidence.stated(claim, Unit::ENERGY, [surplus, bound], granted);
            }
        }
    }
    evidence
}

/// Bounds on `min E_N − d²`, `d² − E_N`, `|E(γᵖˡ) − E_N|` and `L(γᵖˡ)² − d²`, in `m²`.
struct Gaps {
    above: f64,
    below: f64,
    polyline: f64,
    length: f64,
}

impl Gaps {
    /// Compares all four gaps, and compares the excess of the energy with the sum of two bounds.
    fn conclude<const D: usize>(&self, statement: Statement, seen: &Reconstruction<D>) -> Evidence {
        let &Reconstruction { distance_squared: d2, discrete_energy, granted, .. } = seen;
        let (energy, length2) = (seen.energy.value, seen.length_squared.value);
        let (gap, deficit) = ((energy - discrete_energy).abs(), d2 - discrete_energy);
        let excess = self.above + self.polyline;
        begin(statement, seen, seen.rule, d2 + self.above)
            .stated("|E(γᵖˡ) − E_N| ≤ its bound", Unit::ENERGY, [gap, self.polyline], granted)
            .stated("d² − E_N ≤ its bound", Unit::ENERGY, [deficit, self.below], granted)
            .stated("E(γᵖˡ) − d² ≤ its bound", Unit::ENERGY, [energy - d2, excess], granted)
            .stated("L(γᵖˡ)² − d² ≤ its bound", Unit::ENERGY, [length2 - d2, self.length], granted)
    }
}

/// Evaluates Theorem A on a computed minimiser of either rule.
///
/// ```text
/// |E(γᵖˡ) − E_N|, d² − E_N  ≤  d² (kδ/N) e Q
/// L(γᵖˡ)² − d²  ≤  E(γᵖˡ) − d²  ≤  d² [e − 1 + (kδ/N) e Q]
/// ```
///
/// Needs: the setting of Theorem 1.1, and the premise `E_N ≤ d² e`. The proof uses that the inner
/// points are stationary. This is not needed, since Theorem C is no weaker.
///
/// The bounds are attained as `δ → 0`, at `N = 1` on two routes.
#[must_use]
pub fn theorem_a<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let polyline = subject.theorem_a_polyline_gap(seen.setting, seen.rule, seen.n);
    let above = subject.theorem_a_minimum_gap(seen.setting, seen.rule, seen.n);
    let length = above + polyline;
    let gaps = Gaps { above, below: polyline, polyline, length };
    given_bend(gaps.conclude(Statement::TheoremA, seen), seen)
}

/// Evaluates Theorem B on a computed minimiser of the trapezoidal rule, if `M_H` is known.
///
/// ```text
/// |E(γᵖˡ) − E_tra,N|, d² − E_tra,N  ≤  d² (μ/24N²) e₂ Q²
/// E(γᵖˡ) − d²  ≤  d² [e₂ − 1 + (μ/24N²) e₂ Q²]
/// ```
///
/// Needs: the setting of Theorem 1.1, the premise `E_tra,N ≤ d² e₂`, `DH` Lipschitz with `M_H`, and
/// stationary inner points, as a converged minimiser has.
///
/// The bounds are attained as `μ → 0`, at `N = 1` on two routes along parabolas.
#[must_use]
pub fn theorem_b<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Option<Evidence> {
    let polyline = subject.theorem_b_polyline_gap(seen.setting, seen.n)?;
    let above = subject.theorem_b_minimum_gap(seen.setting, seen.n)?;
    let length = above + polyline;
    of_second_order(Gaps { above, below: polyline, polyline, length }, Statement::TheoremB, seen)
}

/// Evaluates Theorem C on any sequence from set to set with `E_N ≤ d² e`, for either rule.
///
/// ```text
/// |E(γᵖˡ) − E_N|  ≤  d² (kδ/N) m₃,    d² − E_N  ≤  d² (1 − s²),  s² + (kδ/N) s³ = 1
/// E(γᵖˡ) − d²  ≤  d² [e − 1 + (kδ/N) m₃],    L(γᵖˡ)² − d²  ≤  d² [e − 1 + (kδ/N) e^{3/2}]
/// ```
///
/// Needs: the setting of Theorem 1.1, and the premise. The points need not be stationary.
///
/// The bounds are attained as `δ → 0`, on two routes, for every `N`.
#[must_use]
pub fn theorem_c<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let &Reconstruction { setting, rule, n, .. } = seen;
    let gaps = Gaps {
        above: subject.theorem_a_minimum_gap(setting, rule, n),
        below: subject.theorem_c_deficit(setting, rule, n),
        polyline: subject.theorem_c_polyline_gap(setting, rule, n),
        length: subject.theorem_c_length_excess(setting, rule, n),
    };
    given_bend(gaps.conclude(Statement::TheoremC, seen), seen)
}

/// Evaluates Theorem D on any sequence from set to set with `E_tra,N ≤ d² ε`, if `M_H` is known.
///
/// ```text
/// |E(γᵖˡ) − E_tra,N|  ≤  d² (μ/24N²) m₄,    d² − E_tra,N  ≤  d² (1 − 2/(1 + √(1 + μ/6N²)))
/// E(γᵖˡ) − d²  ≤  d² [ε − 1 + (μ/24N²) m₄],    L(γᵖˡ)² − d²  ≤  d² [ε − 1 + (μ/24N²) ε²]
/// ```
///
/// Needs: the hypotheses of [`theorem_c`], and `DH` Lipschitz with `M_H`.
///
/// The bounds are attained as `μ → 0`, at `N = 1` on two routes along parabolas.
#[must_use]
pub fn theorem_d<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Option<Evidence> {
    let gaps = Gaps {
        above: subject.theorem_d_minimum_gap(seen.setting, seen.n)?,
        below: subject.theorem_d_deficit(seen.setting, seen.n)?,
        polyline: subject.theorem_d_polyline_gap(seen.setting, seen.n)?,
        length: subject.theorem_d_length_excess(seen.setting, seen.n)?,
    };
    of_second_order(gaps, Statement::TheoremD, seen)
}

/// Adds the hypothesis on `M_H` where the bound on the acceleration needs it.
fn given_bend<const D: usize>(evidence: Evidence, seen: &Reconstruction<D>) -> Evidence {
    match seen.setting.constants().m_h() {
        Some(m_h) if seen.setting.bend_needs_m_h() => evidence.given_curvature(seen.curvature, m_h),
        _ => evidence,
    }
}

/// Concludes Theorem B or D. Returns `None` for the left-endpoint rule, to which they do not apply.
fn of_second_order<const D: usize>(
    gaps: Gaps,
    statement: Statement,
    seen: &Reconstruction<D>,
) -> Option<Evidence> {
    let m_h = seen.setting.constants().m_h()?;
    let of_the_rule = seen.rule == PaperRule::Trapezoidal;
    of_the_rule.then(|| gaps.conclude(statement, seen).given_curvature(seen.curvature, m_h))
}
