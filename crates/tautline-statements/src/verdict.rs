//! `Verdict`: what we say of a statement, having tested it.

/// What we say of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It holds as printed.
    Holds,
    /// It holds if a word in it is read in one of two ways.
    HoldsReadAs(&'static str),
    /// It is false as printed, and holds in this form.
    RefutedRepairedAs(&'static str),
    /// A known theorem that the paper cites; what can be observed of it is tested.
    Cited,
    /// A statement of ours, proved in `paper/SHARPER.md`.
    ProvedHere,
    /// A question that the paper leaves open, and the answer.
    OpenAnsweredBy(&'static str),
}

impl Verdict {
    /// Returns the verdict in a word or two, as the tables have it.
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

    /// Returns the reading, the repair or the answer; empty if there is none.
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
