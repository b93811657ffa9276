//! Theorems 1.1 to 1.4: witnesses.

super::checks! {
    theorems_1_1_and_1_2_on_tents_have_the_least_overestimation_known
    theorems_1_3_and_1_4_on_inclines_have_the_least_overestimation_known
    k3_bar_and_k4_bar_are_attained_where_the_metric_is_constant
}
