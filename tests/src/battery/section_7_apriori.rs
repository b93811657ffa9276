//! Propositions 7.10 to 7.12, `K_{1,g}` and `K_{2,g}`.

super::checks! {
    props_7_10_and_7_11_hold_for_random_metrics
    props_7_10_and_7_11_are_homogeneous
    prop_7_10_is_attained_by_a_ripple
    prop_7_11_has_the_factor_root_d_over_a_twist
    prop_7_11_has_the_factor_three_on_the_line
    prop_7_12_holds_for_minimal_geodesics
    prop_7_12_is_homogeneous
    k1_is_attained_under_the_least_metric
    k2_has_the_factor_d_squared_over_a_twist
    k2_has_the_factor_three_on_the_line
}
