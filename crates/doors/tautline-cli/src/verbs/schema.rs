//! `tautline schema`.

use std::process::ExitCode;

use tautline_problem::{answer_schema, certified_schema, constants_schema, problem_schema};

use crate::{
    arguments::{Described, Schema},
    error::CommandError,
    write::{json, print},
};

/// Prints a JSON schema.
pub(crate) fn schema(arguments: &Schema) -> Result<ExitCode, CommandError> {
    let schema = match arguments.of {
        Described::Problem => problem_schema(),
        Described::Answer => answer_schema(),
        Described::Constants => constants_schema(),
        Described::Certified => certified_schema(),
    };
    print(&json(&schema)?)?;
    Ok(ExitCode::SUCCESS)
}
