//! `Document`: an audit as one JSON document.

use schemars::{JsonSchema, Schema, schema_for};
use serde::Serialize;

use crate::{answer::Audit, text};

/// An audit, and its report as text.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "An audit of a metric")]
pub struct Document {
    /// What was found.
    #[serde(flatten)]
    pub audit: Audit,
    /// The report as text, for a person.
    pub text: String,
}

impl From<Audit> for Document {
    fn from(audit: Audit) -> Self {
        let text = text(&audit);
        Self { audit, text }
    }
}

/// Returns the JSON schema of a document.
#[must_use]
pub fn audit_schema() -> Schema {
    schema_for!(Document)
}
