//! The sharper statements: Lemmas S.1 to S.5, Theorems A to D, Propositions S.6 to S.8.

mod convexity;
mod dropped;
mod golden;
mod leading;
mod lemmas;
mod locality;
mod speeds;
mod theorems;
mod witnesses;

use super::Check;

pub(super) fn checks() -> Vec<Check> {
    let parts = [
        lemmas::checks(),
        theorems::checks(),
        locality::checks(),
        witnesses::checks(),
        speeds::checks(),
        convexity::checks(),
        leading::checks(),
        golden::checks(),
        dropped::checks(),
    ];
    parts.into_iter().flatten().collect()
}
