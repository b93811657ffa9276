//! Section 4: minimal curves.

super::checks! {
    props_4_1_and_4_2_hold_for_every_clock
    prop_4_2_holds_for_segments_that_are_minimal
    props_4_1_and_4_2_hold_for_a_point
    props_4_1_and_4_2_are_homogeneous
    props_4_1_and_4_2_are_attained_by_a_curve_that_pauses
    props_4_1_and_4_2_read_strictly_are_refuted_by_a_pause
    props_4_1_and_4_2_fail_for_a_clock_that_turns_back
    props_4_1_and_4_2_fail_for_the_long_way_round
    prop_4_2_says_nothing_of_a_detour
    props_4_1_and_4_2_fail_for_a_curve_that_stops_short
    props_4_1_and_4_2_fail_for_an_uneven_curve
    prop_4_1_holds_for_points_that_are_not_near
    prop_4_3_holds_on_balls
    prop_4_3_is_homogeneous
    prop_4_3_is_attained_by_every_ray
    prop_4_3_fails_beyond_half_a_great_circle
    prop_4_3_fails_on_the_whole_plane_and_outside_a_ball
    lemma_4_4_holds_for_minimal_curves
    lemma_4_4_is_homogeneous
    lemma_4_4_is_attained_on_a_ramp
    lemma_4_4_holds_for_a_point
    lemma_4_4_fails_for_a_minimal_curve_that_accelerates
    lemma_4_4_fails_for_a_circle_of_constant_speed
    lemma_4_4_fails_for_an_arc_that_stops_half_way
}
