//! Section 9: the excess of length.

super::checks! {
    prop_9_1_repaired_holds_between_points
    prop_9_1_repaired_holds_from_set_to_set
    prop_9_1_is_homogeneous
    prop_9_1_is_attained_by_curves_of_constant_speed
    prop_9_1_refuted_by_a_late_minimiser
    remark_9_2_holds_between_points
    remark_9_2_holds_from_set_to_set
    remark_9_2_is_homogeneous
    remark_9_2_is_attained_by_two_routes
    remark_9_2_has_the_best_rate_for_every_number_of_subintervals
}
