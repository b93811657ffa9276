//! Proposition 7.1.

super::checks! {
    prop_7_1_holds_and_minimisers_are_critical_points
    prop_7_1_is_homogeneous
    prop_7_1_is_attained_by_equal_steps_away_from_the_bounded_set
    prop_7_1_fails_where_both_sets_are_unbounded
    prop_7_1_fails_where_c1_is_zero
    prop_7_1_fails_for_another_number_of_subintervals_and_for_other_ends
}
