//! Theorems 1.1 to 1.4: witnesses, and what fails without a hypothesis.

super::checks! {
    theorems_1_1_and_1_2_on_tents_have_the_best_slack_known
    theorems_1_3_and_1_4_on_inclines_have_the_best_slack_known
    k3_bar_and_k4_bar_are_attained_where_the_metric_is_constant
    theorems_1_1_to_1_4_fail_where_l_h_is_understated
    theorems_1_1_to_1_4_fail_where_c1_is_overstated
    theorems_1_1_to_1_4_fail_for_a_minimiser_that_is_not_global
    theorems_1_1_and_1_3_fail_for_a_minimiser_of_the_discrete_length
}
