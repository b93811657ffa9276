//! `Verdict`: our judgement of a statement, after testing it.

/// Our judgement of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as printed.
    Holds,
    /// It holds under one of two readings of a word.
    HoldsReadAs(&'static str),
    /// It is false as printed, and holds in this form.
    RefutedRepairedAs(&'static str),
    /// It is a known theorem that the paper cites; its observable part is tested.
    Cited,
    /// It is our own statement, proved in `paper/SHARPER.md`.
    ProvedHere,
    /// It is a question that the paper leaves open, with this answer.
    OpenAnsweredBy(&'static str),
}

impl Verdict {
    /// Returns the verdict in a few words, as in the tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Holds => "holds",
            Verdict::HoldsReadAs(_) => "holds when read as",
            Verdict::RefutedRepairedAs(_) => "refuted, repaired as",
            Verdict::Cited => "cited",
            Verdict::ProvedHere => "proved here",
            Verdict::OpenAnsweredBy(_) => "open, answered by",
        }
    }

    /// Returns the reading, the repair or the answer; an empty string if there is none.
    #[must_use]
    pub fn remark(self) -> &'static str {
        match self {
            Verdict::Holds | Verdict::Cited | Verdict::ProvedHere => "",
            Verdict::HoldsReadAs(remark)
            | Verdict::RefutedRepairedAs(remark)
            | Verdict::OpenAnsweredBy(remark) => remark,
        }
    }
}
