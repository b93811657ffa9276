//! The constants and bounds of the paper.

mod apriori;
mod c_tra;
mod k_bar;
mod left_endpoint;
mod polyline_gap;
mod trapezoidal;

pub use apriori::{k1_g, k2_g};
pub use c_tra::{c_tra, c_tra_g, c_tra_sharp, c_tra_sharp_g};
pub use k_bar::{k3_bar_g, k4_bar_g};
pub use left_endpoint::{
    theorem_1_3_constant, theorem_1_3_excess, theorem_1_3_minimum_gap, theorem_1_3_polyline_gap,
    theorem_1_4_length_excess,
};
pub use polyline_gap::{polyline_gap_left, polyline_gap_trapezoidal, rule_gap};
pub use trapezoidal::{
    theorem_1_1_constant, theorem_1_1_excess, theorem_1_1_minimum_gap, theorem_1_1_polyline_gap,
    theorem_1_2_length_excess,
};
