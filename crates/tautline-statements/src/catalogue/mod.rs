//! The catalogue behind [`Statement`]: one entry for each, in its order.

mod paper;
mod sharper;

use crate::{Statement, Verdict};
use paper::PAPER;
use sharper::SHARPER;

const _: () = assert!(PAPER.len() + SHARPER.len() == Statement::ALL.len(), "an entry for each");

/// What is known of a statement without evaluating it.
pub(crate) struct Entry {
    pub(crate) number: &'static str,
    pub(crate) label: &'static str,
    pub(crate) claim: &'static str,
    pub(crate) verdict: Verdict,
    pub(crate) function: &'static str,
}

/// Returns the entry of a statement.
pub(crate) fn entry(statement: Statement) -> &'static Entry {
    let index = statement as usize;
    index.checked_sub(PAPER.len()).map_or_else(|| &PAPER[index], |index| &SHARPER[index])
}

const fn statement(
    number: &'static str,
    label: &'static str,
    claim: &'static str,
    verdict: Verdict,
    function: &'static str,
) -> Entry {
    Entry { number, label, claim, verdict, function }
}
