//! `PlanError`: why there is no plan, or why a table is not its own.

use crate::Diagnostic;

/// Why there is no plan, or why a table is not that of its plan.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum PlanError {
    /// The sweep file is wrong.
    #[error("{diagnostic}")]
    File {
        /// What is wrong, and where.
        diagnostic: Diagnostic,
        /// The text of the sweep file.
        file: String,
    },
    /// There are too many problems.
    #[error("{count} problems: only {most} are possible", most = super::plan::MOST)]
    TooMany {
        /// The number of problems.
        count: u128,
    },
    /// A parameter has the name of a column of the results.
    #[error("a parameter that varies is called {name}, as a column of the results; rename it")]
    Name {
        /// The name.
        name: String,
    },
    /// A text is no table of problems.
    #[error("this is no plan: its line {line} does not begin with {expected:?}")]
    NoPlan {
        /// The number of the line, from 1.
        line: usize,
        /// What was expected.
        expected: String,
    },
    /// The hash in the head of a table is not that of the sweep file there.
    #[error(
        "the plan or a file with its tables was changed: its hash is {written}, but its sweep has \
         {computed}"
    )]
    Hash {
        /// The hash that is written.
        written: String,
        /// The hash that was computed.
        computed: String,
    },
    /// A line of a table is not what follows from its head.
    #[error("the plan was changed: {what} is {found:?}, but its sweep gives {expected:?}")]
    Line {
        /// Which line.
        what: String,
        /// The line; empty if there is none.
        found: String,
        /// What was expected; empty if there is no such line.
        expected: String,
    },
    /// The threads did not start.
    #[error("the threads did not start: {reason}")]
    Threads {
        /// What the system says.
        reason: String,
    },
    /// A block reaches beyond the last problem.
    #[error("there are no problems {start}..{end}: the ids end before {count}")]
    Ids {
        /// The first id.
        start: u64,
        /// The end of the ids.
        end: u64,
        /// The number of problems.
        count: u64,
    },
}
