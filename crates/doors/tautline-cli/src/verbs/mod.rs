//! The verbs, one a file.

pub(crate) mod audit;
pub(crate) mod certify;
pub(crate) mod check;
pub(crate) mod completions;
pub(crate) mod constants;
pub(crate) mod examples;
pub(crate) mod merge;
pub(crate) mod plan;
pub(crate) mod plot;
pub(crate) mod run;
pub(crate) mod schema;
pub(crate) mod solve;
