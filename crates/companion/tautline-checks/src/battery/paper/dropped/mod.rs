//! Statements without one of their hypotheses: either they fail, or the hypothesis is not needed.

pub(crate) mod apriori;
pub(crate) mod energy_and_length;
pub(crate) mod rates;
pub(crate) mod theorems;
pub(crate) mod unneeded;
