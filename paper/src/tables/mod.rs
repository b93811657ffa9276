//! The tables, one in each file.

mod asymptotics;
mod certified_constants;
mod certified_curves;
mod certified_distances;
mod certified_times;
mod constants;
mod convergence;
mod corpus;
mod counterexample;
mod errata;
mod estimates;
mod failure_rates;
mod methods;
mod mutants;
mod rates;
mod statements;
mod tightness;

use crate::artefact::Artefact;

/// All tables.
pub const TABLES: &[Artefact] = &[
    asymptotics::TABLE,
    certified_constants::TABLE,
    certified_curves::TABLE,
    certified_distances::TABLE,
    certified_times::TABLE,
    constants::TABLE,
    convergence::TABLE,
    corpus::TABLE,
    counterexample::TABLE,
    errata::TABLE,
    estimates::TABLE,
    failure_rates::TABLE,
    methods::TABLE,
    mutants::TABLE,
    rates::TABLE,
    statements::TABLE,
    tightness::TABLE,
];
