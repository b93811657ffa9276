//! Numbers, intervals and jets, against arbitrary precision and an independent implementation.

mod derivatives;
mod formulas;
mod hard_arguments;
mod interval_edges;
mod interval_jets;
mod interval_laws;
mod interval_traps;
mod precise;
mod random_formulas;
mod reference;
