//! The statements about discrete minimisers.

use tautline::Bounded;
use tautline_statements::{
    Evidence, Known, PaperRule, Reconstruction, Statement, Subject, VerifyError, constant_k3_bar,
    constant_k4_bar, lemma_s_3, lemma_s_4, lemma_s_5, prop_s_6, remark_9_2, theorem_1_1,
    theorem_1_2, theorem_1_3, theorem_1_4, theorem_a, theorem_b, theorem_c, theorem_d,
};

/// Evaluates a statement on the minimiser of a problem; `None` if the statement does not apply.
type OfMinimiser<M, const D: usize> =
    fn(&Subject, &Known<M, D>, &Reconstruction<D>) -> Result<Option<Evidence>, VerifyError>;

/// A statement about the discrete minimisers of one rule.
pub(super) struct AboutProblem<M, const D: usize> {
    pub(super) statement: Statement,
    pub(super) rule: PaperRule,
    /// Whether the statement is about both rules, and this is the left-endpoint rule.
    pub(super) is_second: bool,
    pub(super) evidence: OfMinimiser<M, D>,
}

const TRA: PaperRule = PaperRule::Trapezoidal;
const LEFT: PaperRule = PaperRule::LeftEndpoint;

impl<M: Bounded<D>, const D: usize> AboutProblem<M, D> {
    fn one(statement: Statement, rule: PaperRule, evidence: OfMinimiser<M, D>) -> Self {
        Self { statement, rule, is_second: false, evidence }
    }

    fn both(statement: Statement, evidence: OfMinimiser<M, D>) -> [Self; 2] {
        PaperRule::BOTH.map(|rule| Self { statement, rule, is_second: rule == LEFT, evidence })
    }

    /// The paper's statements.
    pub(super) fn of_the_paper() -> Vec<Self> {
        vec![
            Self::one(Statement::Theorem1_1, TRA, |s, _, seen| Ok(Some(theorem_1_1(s, seen)))),
            Self::one(Statement::Theorem1_2, TRA, |s, _, seen| Ok(Some(theorem_1_2(s, seen)))),
            Self::one(Statement::Theorem1_3, LEFT, |s, _, seen| Ok(Some(theorem_1_3(s, seen)))),
            Self::one(Statement::Theorem1_4, LEFT, |s, _, seen| Ok(Some(theorem_1_4(s, seen)))),
            Self::one(Statement::ConstantK3Bar, TRA, |s, _, seen| {
                Ok(Some(constant_k3_bar(s, seen)))
            }),
            Self::one(Statement::ConstantK4Bar, LEFT, |s, _, seen| {
                Ok(Some(constant_k4_bar(s, seen)))
            }),
            // The remark is about both rules; this rule has the larger bound.
            Self::one(Statement::Remark9_2, LEFT, |s, _, seen| Ok(Some(remark_9_2(s, seen)))),
        ]
    }

    /// Lemmas S.3 and S.5. If the metric is nearly flat, speeds and their moments nearly attain
    /// their bounds, so the search looks for a violation.
    pub(super) fn speeds() -> Vec<Self> {
        let speeds = Self::both(Statement::LemmaS3, |s, known, seen| {
            Ok(Some(lemma_s_3(s, &known.metric, seen.rule, &seen.minimum.sequence)?))
        });
        let spread = Self::both(Statement::LemmaS5, |s, _, seen| Ok(Some(lemma_s_5(s, seen))));
        speeds.into_iter().chain(spread).collect()
    }

    /// Lemma S.4.
    pub(super) fn ceiling() -> Vec<Self> {
        Self::both(Statement::LemmaS4, |s, _, seen| Ok(Some(lemma_s_4(s, seen)))).into()
    }

    /// Theorems A and C, for both rules.
    pub(super) fn first_order() -> Vec<Self> {
        let a = Self::both(Statement::TheoremA, |s, _, seen| Ok(Some(theorem_a(s, seen))));
        let c = Self::both(Statement::TheoremC, |s, _, seen| Ok(Some(theorem_c(s, seen))));
        a.into_iter().chain(c).collect()
    }

    /// Theorems B and D, which need `M_H`.
    pub(super) fn second_order() -> Vec<Self> {
        vec![
            Self::one(Statement::TheoremB, TRA, |s, _, seen| Ok(theorem_b(s, seen))),
            Self::one(Statement::TheoremD, TRA, |s, _, seen| Ok(theorem_d(s, seen))),
        ]
    }

    /// Proposition S.6. Its enclosure of `d²` is arbitrarily tight for small `N` and small
    /// curvature, so the search looks for a violation.
    pub(super) fn enclosure() -> Vec<Self> {
        Self::both(Statement::PropositionS6, |s, _, seen| Ok(Some(prop_s_6(s, seen, 0.0)?))).into()
    }
}
