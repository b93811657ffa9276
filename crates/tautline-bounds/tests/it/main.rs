//! The bounds against reference values, by their properties and in special cases.

mod bend;
mod golden;
mod panics;
mod properties;
mod properties_sharper;
mod special_cases;
mod spread;
