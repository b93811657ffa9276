//! Section 3: geodesics and distances.

super::checks! {
    prop_3_1_holds_for_geodesics
    prop_3_1_is_homogeneous
    prop_3_1_is_attained_by_every_geodesic_minimal_or_not
    prop_3_1_fails_for_curves_that_are_not_geodesics
    prop_3_2_holds_in_complete_spaces
    prop_3_2_is_homogeneous
    prop_3_2_is_attained_by_the_known_geodesics
    prop_3_2_fails_on_the_sphere_without_a_point
    prop_3_3_holds_between_points
    prop_3_3_is_homogeneous
    prop_3_3_is_attained_by_constant_metrics
    prop_3_3_fails_without_its_constants
}
