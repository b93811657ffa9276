//! The bounds on `E(γᵖˡ) − d²` for the trapezoidal rule that two figures compare.

use std::num::NonZeroUsize;

use tautline::bounds::{
    Setting, theorem_a_excess, theorem_b_excess, theorem_c_excess, theorem_d_excess,
};

use crate::{
    Failure,
    case::{PaperRule, paper_bound},
};

/// The columns of these bounds in the data files.
pub(super) const COLUMNS: &str = "paper theorem_a theorem_c theorem_b theorem_d";

/// Returns the bounds in the order of [`COLUMNS`], in `m²`.
pub(super) fn excess_bounds(setting: Setting, n: NonZeroUsize) -> Result<[f64; 5], Failure> {
    let unknown = || Failure::Data("M_H is not known".to_owned());
    let rule = PaperRule::Trapezoidal;
    Ok([
        paper_bound(setting, rule, n),
        theorem_a_excess(setting, rule, n),
        theorem_c_excess(setting, rule, n),
        theorem_b_excess(setting, n).ok_or_else(unknown)?,
        theorem_d_excess(setting, n).ok_or_else(unknown)?,
    ])
}
