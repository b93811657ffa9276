//! Propositions 7.2 to 7.4.

super::checks! {
    props_7_2_to_7_4_hold_for_smooth_curves
    prop_7_2_holds_for_kinked_curves
    props_7_2_to_7_4_are_homogeneous
    prop_7_2_is_attained_by_constant_velocity
    the_constants_of_prop_7_2_are_the_best
    the_second_inequality_of_prop_7_2_refuted_by_a_constant_curve
    prop_7_3_is_attained_by_constant_velocity
    the_constant_of_prop_7_3_is_the_best
    prop_7_3_refuted_by_constant_velocity
    prop_7_3_fails_for_a_kink
    the_sharp_form_of_prop_7_4_is_attained_by_a_cube
    the_mean_square_form_of_prop_7_4_is_attained_by_half_a_cosine
    prop_7_4_refuted_by_a_kink
}
