//! The statements, each as one function that returns [`Evidence`](crate::Evidence).

mod apriori;
mod discrete_constants;
mod distances;
mod energy_and_length;
mod existence;
mod functional_lipschitz;
mod geodesics;
mod gram_derivatives;
mod length_excess;
mod minimal_curves;
mod morrey;
mod nearest_pair;
mod point_sequences;
mod sampled_curves;
mod section_1;
mod section_5;
mod sharper;
mod way_out;

pub use apriori::{constant_k1, constant_k2, lemma_s_1, prop_7_12};
pub use discrete_constants::{constant_c_1_1, constant_c_1_3, constant_k3_bar, constant_k4_bar};
pub use distances::prop_3_3;
pub use energy_and_length::{
    prop_6_1, prop_6_1_attained, prop_6_1_minimiser, prop_6_3, prop_6_3_attained,
};
pub use existence::{critical_point, prop_7_1};
pub use functional_lipschitz::{TwoForms, prop_7_5, prop_7_5_as_printed};
pub use geodesics::{prop_3_1, prop_3_2};
pub use gram_derivatives::{prop_7_10, prop_7_11};
pub use length_excess::{prop_9_1, prop_9_1_as_printed, remark_9_2, remark_9_2_for_any_sequence};
pub use minimal_curves::{
    lemma_4_4, prop_4_1, prop_4_2, prop_4_2_converse, prop_4_2_read_strictly, prop_4_3,
};
pub use morrey::{prop_7_2, prop_7_2_as_printed, prop_7_3, prop_7_3_as_printed, prop_7_4};
pub use nearest_pair::{NearestPair, prop_6_2};
pub use point_sequences::{lemma_s_2, prop_7_8, prop_7_9, prop_8_1, prop_8_2};
pub use sampled_curves::{
    constant_c_tra, constant_c_tra_sharp, prop_7_6, prop_7_6_as_printed, prop_7_7,
};
pub use section_1::{theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4};
pub use section_5::{section_5_left, section_5_trapezoidal};
pub use sharper::{
    least_length_bound, lemma_s_3, lemma_s_4, lemma_s_5, prop_s_6, prop_s_7, prop_s_8, theorem_a,
    theorem_b, theorem_c, theorem_d,
};
pub use way_out::WayOut;
