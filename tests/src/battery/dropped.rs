//! What fails where a hypothesis is dropped.

super::checks! {
    theorems_1_1_to_1_4_fail_where_l_h_is_understated
    theorems_1_1_to_1_4_fail_where_c1_is_overstated
    theorems_1_1_to_1_4_do_not_need_c2
    theorems_1_1_to_1_4_fail_for_a_minimiser_that_is_not_global
    theorems_1_1_to_1_4_fail_for_other_ends
    theorems_1_1_to_1_4_hold_for_the_other_rule
    theorems_1_1_and_1_3_fail_for_a_minimiser_of_the_discrete_length
    prop_6_1_fails_for_a_curve_that_stops_short
    prop_6_1_says_nothing_of_a_clock_that_runs_late
    prop_6_1_fails_for_a_segment_in_place_of_a_point
    props_6_1_and_6_3_fail_on_the_sphere_without_a_point
    prop_6_2_fails_for_two_unbounded_sets
    prop_6_2_fails_on_the_sphere_without_a_point
    prop_6_2_fails_for_an_open_set_and_for_other_points
    prop_6_3_fails_for_a_curve_outside_the_sets
    prop_9_1_fails_for_a_minimiser_of_the_length_alone
    prop_9_1_fails_for_other_curves_in_place_of_the_minimiser
    prop_9_1_holds_for_curves_that_join_nothing
    prop_7_6_does_not_need_c1_nor_prop_7_7_c2
    props_7_9_8_1_and_8_2_need_neither_c1_nor_c2
    props_7_10_and_7_11_fail_with_false_constants
    k1_fails_without_its_hypotheses
    k2_fails_without_its_hypotheses
    prop_7_12_fails_without_its_hypotheses
    remark_9_2_fails_for_a_slope_that_is_not_admitted
    remark_9_2_fails_with_false_bounds_of_h
    remark_9_2_fails_for_other_ends
    remark_9_2_fails_for_a_minimiser_that_is_not_global
    remark_9_2_holds_for_points_that_are_not_stationary
}
