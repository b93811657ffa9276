//! The sharper statements: Lemmas S.1 to S.5, Theorems A to D, Propositions S.6 to S.10.

pub(super) mod convex_excess;
pub(super) mod convexity;
pub(super) mod dropped;
pub(super) mod golden;
pub(super) mod leading;
pub(super) mod lemmas;
pub(super) mod locality;
pub(super) mod monotone;
pub(super) mod speeds;
pub(super) mod theorems;
pub(super) mod witnesses;
