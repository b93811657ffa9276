//! Our own statements, proved in `paper/SHARPER.md`. Lemmas S.1 and S.2 stand with the statements of
//! the paper that they sharpen, in `apriori` and `point_sequences`.

mod enclosures;
mod least_bound;
mod locality;
mod speeds;
mod theorems;

pub use enclosures::{prop_s_6, prop_s_7};
pub use least_bound::least_length_bound;
pub use locality::prop_s_8;
pub use speeds::{lemma_s_3, lemma_s_5};
pub use theorems::{lemma_s_4, theorem_a, theorem_b, theorem_c, theorem_d};
