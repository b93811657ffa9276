//! Propositions 7.6 and 7.7, `C_tra(N)` and `C_tra♯`.

super::checks! {
    props_7_6_and_7_7_hold_for_smooth_curves
    prop_7_6_holds_for_minimal_geodesics
    props_7_6_and_7_7_are_homogeneous
    prop_7_6_has_a_quarter_over_valleys_at_the_midpoints
    the_sharp_form_of_prop_7_6_is_attained_by_half_a_cosine
    prop_7_6_refuted_by_a_kink
    prop_7_7_refuted_by_a_fast_start
    props_7_6_and_7_7_fail_with_false_constants
    the_discrete_minimum_is_not_above_sampled_curves
    c_tra_is_its_formula_and_c_tra_sharp_bounds_it
    c_tra_is_homogeneous
    c_tra_sharp_is_approached_as_k2_tends_to_0
}
