//! The bounds against reference values, by their properties and in special cases.

mod golden;
mod golden_energy;
mod golden_sharper;
mod properties;
mod properties_sharper;
mod special_cases;
