//! Propositions 7.5 and 7.8.

super::checks! {
    prop_7_5_holds_for_random_metrics
    prop_7_5_holds_for_random_matrices
    prop_7_5_is_homogeneous
    prop_7_5_is_attained_by_all_three_terms
    prop_7_5_fails_without_its_hypotheses
    prop_7_5_refuted_by_a_negative_form
    prop_7_8_holds_for_random_numbers
    prop_7_8_is_homogeneous
    prop_7_8_is_attained_by_one_number
    prop_7_8_holds_for_negative_numbers_too
}
