//! Section 6: energy and length.

super::checks! {
    prop_6_1_holds_for_random_polygons
    prop_6_1_holds_for_geodesics_run_through_by_any_clock
    prop_6_1_is_homogeneous
    prop_6_1_is_attained_by_minimal_geodesics
    prop_6_1_is_attained_by_straight_lines_of_constant_metrics
    prop_6_2_holds_for_computed_pairs
    prop_6_2_is_homogeneous
    prop_6_2_is_attained_by_finite_sets
    prop_6_3_holds_for_random_polygons
    prop_6_3_is_homogeneous
    prop_6_3_is_attained_between_a_ball_and_a_half_space
}
