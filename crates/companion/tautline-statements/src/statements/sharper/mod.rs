//! Our own statements, proved in `paper/SHARPER.md`. Lemmas S.1 and S.2 are with the statements of
//! the paper that they sharpen, in `apriori` and `point_sequences`.

mod enclosures;
mod least_bound;
mod locality;
mod monotone;
mod speeds;
mod theorems;

pub use enclosures::*;
pub use least_bound::*;
pub use locality::*;
pub use monotone::*;
pub use speeds::*;
pub use theorems::*;
