//! `Statement`: the statements of the paper and our sharper ones, by number, label and claim.

mod needs;
mod row;
mod table;

use row::Refutation;
pub use table::Statement;

use crate::Verdict;

impl Statement {
    /// Returns the number as in prose: "Proposition 7.9", "Section 5, left-endpoint rule".
    #[must_use]
    pub fn number(self) -> &'static str {
        self.row().number
    }

    /// Returns the TeX label in the paper or the symbol of a displayed constant; for our own
    /// statements, `sharper:` followed by the subject.
    #[must_use]
    pub fn label(self) -> &'static str {
        self.row().label
    }

    /// Returns the claim, in one line.
    #[must_use]
    pub fn claim(self) -> &'static str {
        self.row().claim
    }

    /// Returns the hypotheses that are checked on every case.
    pub fn hypotheses(self) -> impl Iterator<Item = &'static str> {
        self.row().needs.iter().flat_map(|needs| needs.checked).copied()
    }

    /// Returns the hypotheses that are assumed, since no finite number of evaluations shows them.
    pub fn assumed(self) -> impl Iterator<Item = &'static str> {
        self.row().needs.iter().flat_map(|needs| needs.assumed).copied()
    }

    /// Returns our verdict.
    #[must_use]
    pub fn verdict(self) -> Verdict {
        self.row().verdict
    }

    /// Returns whether the statement is in the paper; the others are our own.
    #[must_use]
    pub fn is_of_the_paper(self) -> bool {
        self.verdict() != Verdict::ProvedHere
    }

    /// Returns whether the statement is in the paper and bounds an error, a speed or a derivative
    /// by the constants of the metric: Theorems 1.1 to 1.4, Propositions 7.4, 7.6, 7.7, 7.9 to
    /// 7.12, 8.1 and 8.2, and the displayed constants.
    ///
    /// The other statements claim existence, or equality, as a definition does.
    #[must_use]
    pub fn is_a_bound(self) -> bool {
        self.row().is_a_bound
    }

    /// Returns the name of the function of this crate that evaluates the statement.
    #[must_use]
    pub fn function(self) -> &'static str {
        self.row().function
    }

    /// Returns the counterexample if the statement is false as printed.
    pub(crate) fn refuted_by(self) -> Option<&'static Refutation> {
        self.row().refuted_by.as_ref()
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
    fn labels_and_numbers_are_distinct_and_the_paper_comes_first() {
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
        assert!(Statement::ALL[..40].iter().all(|statement| statement.is_of_the_paper()));
    }

    /// As [`Statement::is_a_bound`] lists them. `C_tra(N)` is displayed too, but a definition.
    #[test]
    fn the_bounds_of_the_paper_are_the_listed_ones() {
        let theorems = ["1.1", "1.2", "1.3", "1.4"].map(|number| format!("Theorem {number}"));
        let propositions = ["7.4", "7.6", "7.7", "7.9", "7.10", "7.11", "7.12", "8.1", "8.2"]
            .map(|number| format!("Proposition {number}"));
        let constants = [
            "C_tra♯",
            "K_{1,g}",
            "K_{2,g}",
            "K̄_{3,g}",
            "C of Theorem 1.1",
            "K̄_{4,g}",
            "C of Theorem 1.3",
        ];
        for statement in Statement::ALL {
            let number = statement.number();
            let listed = theorems.iter().chain(&propositions).any(|listed| listed == number);
            assert_eq!(statement.is_a_bound(), listed || constants.contains(&number), "{number}");
        }
    }
}
