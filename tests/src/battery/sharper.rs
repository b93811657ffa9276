//! The sharper statements.

super::checks! {
    lemma_s_1_holds_for_minimal_geodesics
    lemma_s_1_is_homogeneous
    lemmas_s_2_and_s_3_hold_for_random_sequences
    lemmas_s_2_and_s_3_are_homogeneous
    prop_s_7_holds_beside_minimisers
    prop_s_7_is_homogeneous
    theorems_a_to_d_hold_between_points
    theorems_a_to_d_hold_from_set_to_set
    theorems_a_and_c_hold_between_points
    theorems_a_and_c_hold_from_set_to_set
    theorems_a_to_d_are_homogeneous
    theorems_a_and_c_are_homogeneous
    lemma_s_1_is_attained_by_a_twist_and_an_incline
    lemma_s_2_is_attained_by_one_step
    lemma_s_2_is_attained_along_a_parabola
    lemma_s_3_and_prop_s_6_are_attained_where_the_metric_is_constant
    lemmas_s_4_and_s_5_are_attained_on_ridges_valleys_and_inclines
    lemma_s_4_has_the_second_variation_up_an_incline
    lemma_s_5_is_attained_by_one_long_chord
    theorems_a_and_c_are_attained_on_two_routes
    theorem_c_is_attained_by_the_left_rule_for_every_n
    theorems_b_and_d_are_attained_on_two_arcs
    prop_s_7_finds_the_minimum_under_a_constant_metric_from_a_wave
    prop_s_7_is_attained_with_two_chords_on_opposite_slopes
    golden_bounds_of_theorems_a_and_b
    lemmas_s_1_to_s_3_fail_where_l_h_is_understated
    the_sharper_theorems_fail_where_l_h_is_understated
    lemma_s_2_and_theorems_b_and_d_fail_where_m_h_is_understated
    lemma_s_4_fails_where_c2_is_understated
    prop_s_7_fails_where_c1_is_overstated
    theorems_a_and_c_fail_for_a_minimiser_that_is_not_global
}
