//! `Statement`: the statements of the paper, and the sharper ones, by number, label and claim.

use crate::{Verdict, catalogue::entry};

/// A numbered statement of the paper, a claim of its Section 5, or a displayed constant, in the
/// order of the paper; and after them our own, in the order of `paper/SHARPER.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs, reason = "the names are the numbers; `claim` says what they say")]
pub enum Statement {
    Theorem1_1,
    Theorem1_2,
    Theorem1_3,
    Theorem1_4,
    Proposition3_1,
    Proposition3_2,
    Proposition3_3,
    Proposition4_1,
    Proposition4_2,
    Proposition4_3,
    Lemma4_4,
    Section5Left,
    Section5Trapezoidal,
    Proposition6_1,
    Proposition6_2,
    Proposition6_3,
    Proposition7_1,
    Proposition7_2,
    Proposition7_3,
    Proposition7_4,
    Proposition7_5,
    Proposition7_6,
    ConstantCTra,
    ConstantCTraSharp,
    Proposition7_7,
    Proposition7_8,
    Proposition7_9,
    Proposition7_10,
    Proposition7_11,
    ConstantK1,
    ConstantK2,
    Proposition7_12,
    ConstantK3Bar,
    ConstantC1_1,
    Proposition8_1,
    Proposition8_2,
    ConstantK4Bar,
    ConstantC1_3,
    Proposition9_1,
    Remark9_2,
    LemmaS1,
    LemmaS2,
    LemmaS3,
    LemmaS4,
    LemmaS5,
    TheoremA,
    TheoremB,
    TheoremC,
    TheoremD,
    PropositionS6,
    PropositionS7,
    PropositionS8,
}

impl Statement {
    /// All statements: of the paper, in its order, the 30 numbered ones, the two claims of Section
    /// 5, and eight displayed constants; then the sharper ones.
    pub const ALL: [Statement; 52] = [
        Statement::Theorem1_1,
        Statement::Theorem1_2,
        Statement::Theorem1_3,
        Statement::Theorem1_4,
        Statement::Proposition3_1,
        Statement::Proposition3_2,
        Statement::Proposition3_3,
        Statement::Proposition4_1,
        Statement::Proposition4_2,
        Statement::Proposition4_3,
        Statement::Lemma4_4,
        Statement::Section5Left,
        Statement::Section5Trapezoidal,
        Statement::Proposition6_1,
        Statement::Proposition6_2,
        Statement::Proposition6_3,
        Statement::Proposition7_1,
        Statement::Proposition7_2,
        Statement::Proposition7_3,
        Statement::Proposition7_4,
        Statement::Proposition7_5,
        Statement::Proposition7_6,
        Statement::ConstantCTra,
        Statement::ConstantCTraSharp,
        Statement::Proposition7_7,
        Statement::Proposition7_8,
        Statement::Proposition7_9,
        Statement::Proposition7_10,
        Statement::Proposition7_11,
        Statement::ConstantK1,
        Statement::ConstantK2,
        Statement::Proposition7_12,
        Statement::ConstantK3Bar,
        Statement::ConstantC1_1,
        Statement::Proposition8_1,
        Statement::Proposition8_2,
        Statement::ConstantK4Bar,
        Statement::ConstantC1_3,
        Statement::Proposition9_1,
        Statement::Remark9_2,
        Statement::LemmaS1,
        Statement::LemmaS2,
        Statement::LemmaS3,
        Statement::LemmaS4,
        Statement::LemmaS5,
        Statement::TheoremA,
        Statement::TheoremB,
        Statement::TheoremC,
        Statement::TheoremD,
        Statement::PropositionS6,
        Statement::PropositionS7,
        Statement::PropositionS8,
    ];

    /// Returns the number, as in prose: "Proposition 7.9", "Section 5, left-endpoint rule".
    #[must_use]
    pub fn number(self) -> &'static str {
        entry(self).number
    }

    /// Returns the TeX label in the paper; of a displayed constant, its symbol; of a statement of
    /// ours, `sharper:` and its subject.
    #[must_use]
    pub fn label(self) -> &'static str {
        entry(self).label
    }

    /// Returns what it claims, in a line.
    #[must_use]
    pub fn claim(self) -> &'static str {
        entry(self).claim
    }

    /// Returns what we say of it.
    #[must_use]
    pub fn verdict(self) -> Verdict {
        entry(self).verdict
    }

    /// Returns whether it is one of the paper's, and not of ours.
    #[must_use]
    pub fn is_of_the_paper(self) -> bool {
        self.verdict() != Verdict::ProvedHere
    }

    /// Returns whether it is one of the paper's and bounds an error, a speed or a derivative by the
    /// constants of the metric: Theorems 1.1 to 1.4, Propositions 7.4, 7.6, 7.7, 7.9 to 7.12, 8.1 and 8.2, and what the
    /// displayed constants bound.
    ///
    /// The others say that something exists, or that two numbers are equal, as a definition does.
    #[must_use]
    pub fn is_a_bound(self) -> bool {
        use Statement::{
            ConstantC1_1, ConstantC1_3, ConstantCTraSharp, ConstantK1, ConstantK2, ConstantK3Bar,
            ConstantK4Bar, Proposition7_4, Proposition7_6, Proposition7_7, Proposition7_9,
            Proposition7_10, Proposition7_11, Proposition7_12, Proposition8_1, Proposition8_2,
            Theorem1_1, Theorem1_2, Theorem1_3, Theorem1_4,
        };
        matches!(
            self,
            Theorem1_1
                | Theorem1_2
                | Theorem1_3
                | Theorem1_4
                | Proposition7_4
                | Proposition7_6
                | Proposition7_7
                | Proposition7_9
                | Proposition7_10
                | Proposition7_11
                | Proposition7_12
                | Proposition8_1
                | Proposition8_2
                | ConstantK1
                | ConstantK2
                | ConstantK3Bar
                | ConstantK4Bar
                | ConstantCTraSharp
                | ConstantC1_1
                | ConstantC1_3
        )
    }

    /// Returns the name of the function of this crate that evaluates it.
    #[must_use]
    pub fn function(self) -> &'static str {
        entry(self).function
    }
}

impl std::fmt::Display for Statement {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.number())
    }
}

#[cfg(test)]
mod tests {
    use super::Statement;

    #[test]
    fn labels_and_numbers_are_different_and_in_order() {
        for (k, statement) in Statement::ALL.into_iter().enumerate() {
            assert_eq!(statement as usize, k);
            for other in &Statement::ALL[..k] {
                assert_ne!(statement.label(), other.label());
                assert_ne!(statement.number(), other.number());
            }
        }
        let numbered = |statement: &&Statement| {
            ["Theorem", "Proposition", "Lemma", "Remark"]
                .iter()
                .any(|kind| statement.number().starts_with(kind))
        };
        let of_the_paper = || Statement::ALL.iter().filter(|statement| statement.is_of_the_paper());
        assert_eq!(of_the_paper().filter(numbered).count(), 30);
        assert_eq!(of_the_paper().count(), 40);
        // The paper's come first.
        assert!(Statement::ALL[..40].iter().all(|statement| statement.is_of_the_paper()));
    }

    /// What the suite of the paper's bounds alone asserts is the paper's.
    #[test]
    fn the_sharper_statements_are_not_among_the_bounds_of_the_paper() {
        for statement in Statement::ALL.into_iter().filter(|statement| !statement.is_of_the_paper())
        {
            assert!(!statement.is_a_bound(), "{statement}");
        }
    }
}
