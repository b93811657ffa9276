//! The JSON schemas of problems and answers, generated from their types.

use schemars::{Schema, schema_for};

use crate::{Answer, CertifiedAnswer, ConstantsAnswer, file::ProblemFile};

/// Returns the schema of a problem file, as if its TOML were JSON.
#[must_use]
pub fn problem_schema() -> Schema {
    schema_for!(ProblemFile)
}

/// Returns the schema of an answer.
#[must_use]
pub fn answer_schema() -> Schema {
    schema_for!(Answer)
}

/// Returns the schema of a certified distance.
#[must_use]
pub fn certified_schema() -> Schema {
    schema_for!(CertifiedAnswer)
}

/// Returns the schema of the constants of a metric.
#[must_use]
pub fn constants_schema() -> Schema {
    schema_for!(ConstantsAnswer)
}
