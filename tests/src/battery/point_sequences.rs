//! Propositions 7.9, 8.1 and 8.2.

super::checks! {
    props_7_9_8_1_and_8_2_hold_for_random_sequences
    props_7_9_8_1_and_8_2_are_homogeneous
    prop_7_9_is_attained_by_the_tent
    props_8_1_and_8_2_are_attained_by_the_incline
    the_left_rule_reads_the_point_where_a_chord_begins
    props_7_9_8_1_and_8_2_fail_where_the_metric_jumps
}
