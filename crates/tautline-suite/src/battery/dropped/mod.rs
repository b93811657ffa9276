//! What fails where a hypothesis is dropped, and what is left of a statement without one.

mod apriori;
mod energy_and_length;
mod rates;
pub(super) mod theorems;
mod unneeded;

use super::Check;

pub(super) fn checks() -> Vec<Check> {
    let parts = [
        theorems::checks(),
        energy_and_length::checks(),
        unneeded::checks(),
        apriori::checks(),
        rates::checks(),
    ];
    parts.into_iter().flatten().collect()
}
